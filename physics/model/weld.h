#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "physics/model/index.h"
#include "physics/scene/shape.h"

namespace carom {

// A weld that a run makes where two bodies stick together, with its ends as body indices.
struct Weld {
  BodyIndex body;              // movable
  BodyIndex other;             // of any mass
  Vec2 point = Vec2::Zero();   // m, where they touch, from the centre of `body` along its axes
  Vec2 anchor = Vec2::Zero();  // m, the same from the centre of `other`
  double angle = 0.0;          // rad, of `body` minus that of `other`
};

// Which bodies are welded into one.
class WeldedBodies {
 public:
  WeldedBodies() = default;
  explicit WeldedBodies(std::size_t bodies) : number_(bodies, -1) {}

  // Both bodies and all that are welded to them are one from then on.
  void join(BodyIndex a, BodyIndex b) {
    const int from_a = number_[a];
    const int from_b = number_[b];
    for (int& number : number_) {
      if (number >= 0 && (number == from_a || number == from_b)) number = a;
    }
    number_[a] = number_[b] = a;
  }
  [[nodiscard]] bool is_welded(BodyIndex body) const { return number_[body] >= 0; }
  [[nodiscard]] bool are_one(BodyIndex a, BodyIndex b) const {
    return number_[a] >= 0 && number_[a] == number_[b];
  }

 private:
  std::vector<int> number_;  // by body: shared by those that are one; -1: welded to none
};

}  // namespace carom
