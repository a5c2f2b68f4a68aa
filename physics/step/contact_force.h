#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "physics/math/vectors.h"
#include "physics/model/index.h"

namespace carom {

// Tolerance of the contact forces, relative to the change of a speed by forces in a step.
inline constexpr double kContactTolerance = 1e-12;

// Force of one contact point on two bodies during a step, or a part of one.
struct ContactForce {
  BodyIndex a;
  BodyIndex b;                    // a < b
  std::uint32_t id = 0;           // of the manifold point; constant while the same features touch
  Vec2 point = Vec2::Zero();      // m, when the force ends
  Vec2 normal = Vec2::UnitX();    // from a to b; of halfway through the step where it turns
  double normal_force = 0.0;      // N, mean over the step: the force on b along the normal
  double tangential_force = 0.0;  // N, along the normal turned by +90°
  double rolling_moment = 0.0;    // N m
  bool sticks = false;            // did not slip
};

// Relative to the smaller body: contacts of a pair that are nearer to each other are at one place.
inline constexpr double kSamePlace = 0.02;

// Index of the first force of the pair a < b, or of where it would be, among forces in the order of (a, b).
[[nodiscard]] inline std::size_t first_force_of(const std::vector<ContactForce>& forces, BodyIndex a,
                                                BodyIndex b) {
  const auto before = [](const ContactForce& f, const BodyPair& pair) { return BodyPair(f.a, f.b) < pair; };
  return static_cast<std::size_t>(std::lower_bound(forces.begin(), forces.end(), BodyPair(a, b), before) -
                                  forces.begin());
}

// State of resting contacts between two steps.
struct ContactMemory {
  std::vector<ContactForce> forces;      // of the last step, in the order of (a, b)
  std::vector<Eigen::Vector3d> support;  // N, N and N m, parallel to forces: the solver's initial guess
  std::vector<BodyIndex> pushed;         // bodies that contact forces act on
};

}  // namespace carom
