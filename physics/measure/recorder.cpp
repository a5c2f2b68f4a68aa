#include "physics/measure/recorder.h"

#include <cstddef>

namespace carom {
namespace {

// Returns false if something had to go.
template <class T>
bool append_bounded(std::vector<T>& to, const std::vector<T>& from, std::size_t most) {
  to.insert(to.end(), from.begin(), from.end());
  if (to.size() <= most) return true;
  to.erase(to.begin(), to.end() - static_cast<std::ptrdiff_t>(3 * most / 4));
  return false;
}

}  // namespace

void Recorder::clear() {
  samples_.clear();
  impacts_.clear();
  complete_ = true;
}

void Recorder::add(const Frame& frame) {
  if (frame.run != run_) {
    clear();
    run_ = frame.run;
  }
  const bool all_samples = append_bounded(samples_, frame.samples, kMostSamples);
  const bool all_impacts = append_bounded(impacts_, frame.impacts, kMostImpacts);
  complete_ = complete_ && all_samples && all_impacts;
}

}  // namespace carom
