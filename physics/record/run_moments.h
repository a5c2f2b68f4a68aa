#pragma once

#include <functional>
#include <span>
#include <vector>

#include "physics/record/frame.h"

namespace carom {

// The newest impacts of a run, for showing: a resting heap makes thousands a second, of which the newest
// kMostRecent are enough. Forgets those of `span` s or more before `now`, and any after it; then adds the fresh
// ones.
inline constexpr std::size_t kMostRecent = 1000;
void keep_recent(std::vector<ImpactRecord>& impacts, std::span<const ImpactRecord> fresh, double now,
                 double span);

// Goes through runs once more, side by side, and shows them at `times` (s, ascending), on beyond where they
// were left if these lie there. A time between two steps is reached by one shorter step of a copy, of which the
// run knows nothing. The frames, one a run, have no rows; their impacts are the recent ones of the last `span`
// s. Before each step `go_on` is told the time that is reached. Where one of the two answers false the runs are
// left, and the answer is false.
[[nodiscard]] bool visit_moments(std::span<const RunLog> runs, std::span<const double> times, double span,
                                 const std::function<bool(std::span<const Frame>)>& show,
                                 const std::function<bool(double time)>& go_on);

}  // namespace carom
