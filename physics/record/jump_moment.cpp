#include "physics/record/jump_moment.h"

#include <algorithm>
#include <cstddef>

#include "physics/record/replay.h"

namespace carom {
namespace {

// The end of the impacts that have the time of the one at `begin`.
std::size_t end_of_moment(const std::vector<ImpactRecord>& records, std::size_t begin) {
  std::size_t end = begin;
  while (end < records.size() && records[end].time == records[begin].time) ++end;
  return end;
}

std::shared_ptr<const JumpMoment> moment_of(const Simulation& run, std::size_t begin, std::size_t end) {
  const auto from = static_cast<std::ptrdiff_t>(begin);
  const auto to = static_cast<std::ptrdiff_t>(end);
  const std::vector<ImpactRecord>& records = run.last_impacts();
  const std::vector<Jump>& jumps = run.last_jumps();
  return std::make_shared<const JumpMoment>(JumpMoment{run.compiled(),
                                                       run.joints(),
                                                       {records.begin() + from, records.begin() + to},
                                                       {jumps.begin() + from, jumps.begin() + to}});
}

}  // namespace

std::vector<BodyIndex> JumpMoment::bodies() const {
  std::vector<BodyIndex> found;
  for (const ImpactRecord& record : records) {
    found.push_back(record.a);
    found.push_back(record.b);
  }
  for (BodyIndex i{0}; i < before().size(); ++i) {
    if (before().v.col(i) != after().v.col(i)) found.push_back(i);
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

std::vector<std::shared_ptr<const JumpMoment>> jump_moments(const Simulation& run) {
  const std::vector<ImpactRecord>& records = run.last_impacts();
  std::vector<std::shared_ptr<const JumpMoment>> moments;
  for (std::size_t begin = 0; begin < records.size();) {
    const std::size_t end = end_of_moment(records, begin);
    if (end > run.last_jumps().size()) break;
    moments.push_back(moment_of(run, begin, end));
    begin = end;
  }
  return moments;
}

std::shared_ptr<const JumpMoment> last_jump_moment(const Simulation& run) {
  const std::vector<ImpactRecord>& records = run.last_impacts();
  if (records.empty() || run.last_jumps().size() < records.size()) return nullptr;
  std::size_t begin = records.size() - 1;
  while (begin > 0 && records[begin - 1].time == records.back().time) --begin;
  return moment_of(run, begin, records.size());
}

std::shared_ptr<const JumpMoment> first_jump_moment(const RunSetup& setup, double end,
                                                    const std::function<bool()>& go_on) {
  std::shared_ptr<const JumpMoment> first;
  bool met = false;
  Replay(setup).go_through(
      [](const RunEdit&) {},
      [&](const Simulation& run) { return !met && !run.lost() && run.time() < end && go_on(); },
      [&](const Simulation& run) {
        met = !run.last_impacts().empty();
        const auto moments = jump_moments(run);
        if (!moments.empty()) first = moments.front();
      });
  return first;
}

}  // namespace carom
