#include "physics/world/thinning.h"

#include <algorithm>
#include <array>

namespace carom {
namespace {

// Replaces each whole block of `block` records in the older nine tenths by what keep(first) leaves at its
// front, which is half of it, until there are at most `most`. True if there were no more before.
template <class T, class Keep>
bool thin_to(std::vector<T>& records, std::size_t most, std::ptrdiff_t block, const Keep& keep) {
  if (records.size() <= most) return true;
  do {
    const auto end = static_cast<std::ptrdiff_t>(records.size() / 10 * 9);
    auto to = records.begin();
    auto from = records.begin();
    for (; from + block <= records.begin() + end; from += block) {
      keep(from);
      to = std::move(from, from + block / 2, to);
    }
    to = std::move(from, records.end(), to);
    records.erase(to, records.end());
  } while (records.size() > most);
  return false;
}

}  // namespace

bool thin(std::vector<Sample>& samples) {
  return thin_to(samples, kMostSamples, 4, [](auto first) {
    const auto [least, largest] = std::minmax_element(first, first + 4, [](const Sample& x, const Sample& y) {
      return x.totals.kinetic() < y.totals.kinetic();
    });
    const std::array kept = {*std::min(least, largest), *std::max(least, largest)};
    std::copy(kept.begin(), kept.end(), first);
  });
}

bool thin(std::vector<ImpactRecord>& impacts) {
  return thin_to(impacts, kMostImpacts, 2, [](auto first) {
    if (first[1].normal_impulse > first[0].normal_impulse) first[0] = first[1];
  });
}

}  // namespace carom
