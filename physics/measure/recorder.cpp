#include "physics/measure/recorder.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace carom {
namespace {

// Replaces each whole block of `block` records before `end` by what keep(first) leaves at its front, which is
// half of it.
template <class T, class Keep>
void thin(std::vector<T>& records, std::ptrdiff_t end, std::ptrdiff_t block, const Keep& keep) {
  auto to = records.begin();
  auto from = records.begin();
  for (; from + block <= records.begin() + end; from += block) {
    keep(from);
    to = std::move(from, from + block / 2, to);
  }
  to = std::move(from, records.end(), to);
  records.erase(to, records.end());
}

template <class T>
std::ptrdiff_t older_part(const std::vector<T>& records) {
  return static_cast<std::ptrdiff_t>(records.size() / 10 * 9);
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
  samples_.insert(samples_.end(), frame.samples.begin(), frame.samples.end());
  while (samples_.size() > kMostSamples) {
    complete_ = false;
    thin(samples_, older_part(samples_), 4, [](auto first) {
      const auto [least, largest] = std::minmax_element(first, first + 4, [](const Sample& x, const Sample& y) {
        return x.totals.kinetic() < y.totals.kinetic();
      });
      const std::array kept = {*std::min(least, largest), *std::max(least, largest)};
      std::copy(kept.begin(), kept.end(), first);
    });
  }
  impacts_.insert(impacts_.end(), frame.impacts.begin(), frame.impacts.end());
  while (impacts_.size() > kMostImpacts) {
    complete_ = false;
    thin(impacts_, older_part(impacts_), 2, [](auto first) {
      if (first[1].normal_impulse > first[0].normal_impulse) first[0] = first[1];
    });
  }
}

}  // namespace carom
