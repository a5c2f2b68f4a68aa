#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "physics/record/recorder.h"

namespace carom {

// The recorded impacts by their times. Of a run with more than Recorder::kMostImpacts the earlier ones are
// known by some of their times only.

// s: the first impact after `time`, the last one not after it.
[[nodiscard]] std::optional<double> impact_after(const Recorder& recorder, double time);
[[nodiscard]] std::optional<double> impact_until(const Recorder& recorder, double time);

// The impacts after `from` and not after `to` (s), of those whose records are kept.
[[nodiscard]] std::vector<ImpactRecord> impacts_between(const Recorder& recorder, double from, double to);

// Their numbers, counted from 1, of `all` impacts of the run so far.
struct ImpactNumbers {
  std::int64_t first = 0;
  std::int64_t last = 0;  // less than `first`: there are none
};
[[nodiscard]] ImpactNumbers impact_numbers(const Recorder& recorder, double from, double to, std::int64_t all);

}  // namespace carom
