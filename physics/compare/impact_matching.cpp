#include "physics/compare/impact_matching.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

namespace carom {
namespace {

using TimesOfPairs = std::map<std::pair<int, int>, std::vector<double>>;

TimesOfPairs by_pair(const std::vector<TimedImpact>& impacts) {
  TimesOfPairs times;
  for (const TimedImpact& i : impacts) times[{i.a, i.b}].push_back(i.time);
  return times;
}

}  // namespace

Comparison compare(const RecordedRun& run, const RecordedRun& reference, std::span<const int> moving,
                   double time) {
  Comparison c;
  if (run.blew_up_at >= 0.0 && run.blew_up_at < time) {
    c.unmatched = static_cast<int>(run.impact_count + reference.impact_count);
    c.left_out = static_cast<int>(moving.size());
    return c;
  }

  std::vector<char> in_window(static_cast<std::size_t>(run.state.size()), 0);
  const TimesOfPairs ours = by_pair(run.impacts);
  TimesOfPairs theirs = by_pair(reference.impacts);
  for (const auto& [pair, times] : ours) theirs.try_emplace(pair);
  for (const auto& [pair, there] : theirs) {
    const auto found = ours.find(pair);
    const std::vector<double> none;
    const std::vector<double>& here = found == ours.end() ? none : found->second;
    for (std::size_t k = 0; k < std::max(here.size(), there.size()); ++k) {
      const bool ran = k < here.size() && here[k] <= time;
      const bool expected = k < there.size() && there[k] <= time;
      if (!ran && !expected) break;
      if (k >= std::min(here.size(), there.size())) {
        ++c.unmatched;
        continue;
      }
      ++c.matched;
      c.impact_time_error = std::fmax(c.impact_time_error, std::abs(here[k] - there[k]));
      if (ran != expected) {
        in_window[static_cast<std::size_t>(pair.first)] = 1;
        in_window[static_cast<std::size_t>(pair.second)] = 1;
      }
    }
  }

  for (const int i : moving) {
    if (in_window[static_cast<std::size_t>(i)] != 0) {
      ++c.left_out;
      continue;
    }
    c.position_error =
        std::fmax(c.position_error, (run.state.position(i) - reference.state.position(i)).norm());
    c.velocity_error =
        std::fmax(c.velocity_error, (run.state.velocity(i) - reference.state.velocity(i)).norm());
  }
  if (c.left_out == 0) c.energy_error = std::abs(run.energy - reference.energy);
  return c;
}

}  // namespace carom
