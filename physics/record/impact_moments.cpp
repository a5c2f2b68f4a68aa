#include "physics/record/impact_moments.h"

namespace carom {
namespace {

// How many of the kept records are not after `time`.
std::size_t count_until(const Ring<ImpactRecord>& impacts, double time) {
  std::size_t count = 0;
  std::size_t most = impacts.size();
  while (count < most) {
    const std::size_t middle = (count + most) / 2;
    if (impacts[middle].time <= time) {
      count = middle + 1;
    } else {
      most = middle;
    }
  }
  return count;
}

}  // namespace

std::optional<double> impact_after(const Recorder& recorder, double time) {
  const Ring<ImpactRecord>& impacts = recorder.impacts();
  if (const std::size_t next = count_until(impacts, time); next > 0) {
    return next == impacts.size() ? std::nullopt : std::optional(impacts[next].time);
  }
  const SeriesPoint<1>* first = recorder.impulses().known_after(time);
  return first == nullptr ? std::nullopt : std::optional(first->at);
}

std::optional<double> impact_until(const Recorder& recorder, double time) {
  const Ring<ImpactRecord>& impacts = recorder.impacts();
  if (const std::size_t count = count_until(impacts, time); count > 0) return impacts[count - 1].time;
  const SeriesPoint<1>* earlier = recorder.impulses().at(time);
  return earlier == nullptr ? std::nullopt : std::optional(earlier->at);
}

std::vector<ImpactRecord> impacts_between(const Recorder& recorder, double from, double to) {
  const Ring<ImpactRecord>& impacts = recorder.impacts();
  std::vector<ImpactRecord> found;
  const std::size_t end = count_until(impacts, to);
  for (std::size_t i = count_until(impacts, from); i < end; ++i) found.push_back(impacts[i]);
  return found;
}

ImpactNumbers impact_numbers(const Recorder& recorder, double from, double to, std::int64_t all) {
  const Ring<ImpactRecord>& impacts = recorder.impacts();
  const std::int64_t not_kept = all - static_cast<std::int64_t>(impacts.size());
  return {not_kept + static_cast<std::int64_t>(count_until(impacts, from)) + 1,
          not_kept + static_cast<std::int64_t>(count_until(impacts, to))};
}

}  // namespace carom
