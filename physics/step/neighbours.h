#pragma once

#include <span>
#include <vector>

#include "physics/step/pair_list.h"
#include "physics/step/world.h"

namespace carom {

[[nodiscard]] inline BodyPair ends_of(const BodyPair& pair) { return pair; }
[[nodiscard]] inline BodyPair ends_of(const WaitingPair& pair) { return {pair.a, pair.b}; }

// The partners of each body in a list of pairs.
class Neighbours {
 public:
  template <class Pairs>
  void build(int bodies, const Pairs& pairs) {
    first_.assign(static_cast<std::size_t>(bodies) + 1, 0);
    for (const auto& pair : pairs) {
      const auto [a, b] = ends_of(pair);
      ++first_[a], ++first_[b];
    }
    int sum = 0;
    for (int& first : first_) sum += first, first = sum;
    partners_.resize(static_cast<std::size_t>(sum));
    for (const auto& pair : pairs) {
      const auto [a, b] = ends_of(pair);
      partners_[--first_[a]] = b, partners_[--first_[b]] = a;
    }
  }
  [[nodiscard]] std::span<const BodyIndex> of(BodyIndex body) const {
    const auto i = static_cast<std::size_t>(body);
    return {partners_.data() + first_[i], static_cast<std::size_t>(first_[i + 1] - first_[i])};
  }
  // Those of a or b that both of them may touch, and some that they don't.
  [[nodiscard]] std::span<const BodyIndex> of_pair(const World& world, BodyIndex a, BodyIndex b) const {
    if (world.infinite_mass(a)) return of(b);
    if (world.infinite_mass(b)) return of(a);
    return of(a).size() < of(b).size() ? of(a) : of(b);
  }

 private:
  std::vector<int> first_;
  std::vector<BodyIndex> partners_;
};

}  // namespace carom
