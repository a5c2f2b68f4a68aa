#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "physics/model/index.h"

namespace carom {

// A pair of bodies that waits for the end of the step.
struct WaitingPair {
  BodyIndex a;
  BodyIndex b;  // a < b
  bool resting = false;
};

// Pairs in the order of insertion, without duplicates; lookup takes constant time. clear() keeps the memory.
class PairList {
 public:
  // A pair that is already listed rests if either entry does.
  void add(BodyIndex a, BodyIndex b, bool resting) {
    if (2 * (pairs_.size() + 1) > slots_.size()) grow();
    int& slot = slots_[slot_of(a, b)];
    if (slot == kEmpty) {
      slot = static_cast<int>(pairs_.size());
      pairs_.push_back({a, b, resting});
    } else if (resting) {
      pairs_[static_cast<std::size_t>(slot)].resting = true;
    }
  }
  [[nodiscard]] bool rests(BodyIndex a, BodyIndex b) const {
    if (pairs_.empty()) return false;
    const int slot = slots_[slot_of(a, b)];
    return slot != kEmpty && pairs_[static_cast<std::size_t>(slot)].resting;
  }
  void clear() {
    if (!pairs_.empty()) std::fill(slots_.begin(), slots_.end(), kEmpty);
    pairs_.clear();
  }
  // Into the order of (a, b).
  void sort() {
    std::sort(pairs_.begin(), pairs_.end(), [](const WaitingPair& x, const WaitingPair& y) {
      return std::pair(x.a, x.b) < std::pair(y.a, y.b);
    });
    std::fill(slots_.begin(), slots_.end(), kEmpty);
    number();
  }
  void swap(PairList& other) {
    pairs_.swap(other.pairs_);
    slots_.swap(other.slots_);
    std::swap(shift_, other.shift_);
  }
  [[nodiscard]] const std::vector<WaitingPair>& all() const { return pairs_; }

 private:
  static constexpr int kEmpty = -1;
  static constexpr std::uint64_t kOdd = 0x9E3779B97F4A7C15U;  // 2^64 over the golden ratio

  // The slot of the pair, or the one where it would go.
  [[nodiscard]] std::size_t slot_of(BodyIndex a, BodyIndex b) const {
    // Multiples of odd numbers, whose highest bits are mixed best. The key of a is folded before b is added,
    // because sums of two such sequences have gaps.
    std::uint64_t key = static_cast<std::uint32_t>(a) * kOdd;
    key = ((key ^ key >> 32U) + static_cast<std::uint32_t>(b)) * kOdd;
    std::size_t at = static_cast<std::size_t>(key >> shift_);
    while (slots_[at] != kEmpty) {
      const WaitingPair& p = pairs_[static_cast<std::size_t>(slots_[at])];
      if (p.a == a && p.b == b) break;
      at = (at + 1) & (slots_.size() - 1);
    }
    return at;
  }
  void grow() {
    slots_.assign(std::max<std::size_t>(16, 2 * slots_.size()), kEmpty);
    shift_ = 64U - static_cast<unsigned>(std::countr_zero(slots_.size()));
    number();
  }
  // Enters all pairs into empty slots.
  void number() {
    for (std::size_t i = 0; i < pairs_.size(); ++i)
      slots_[slot_of(pairs_[i].a, pairs_[i].b)] = static_cast<int>(i);
  }

  std::vector<WaitingPair> pairs_;
  std::vector<int> slots_;  // a power of two of them
  unsigned shift_ = 64;     // 64 less the exponent of that power
};

}  // namespace carom
