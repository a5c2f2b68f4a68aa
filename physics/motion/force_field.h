#pragma once

#include <vector>

#include "physics/motion/state.h"
#include "physics/scene/scene.h"

namespace carom {

// Right-hand side of the equation of motion of one body: q' = v, v' = acceleration(q, v), and the power in W
// that velocity-dependent forces take from it.
struct Rate {
  Eigen::Vector3d acceleration = Eigen::Vector3d::Zero();  // m/s², m/s², rad/s²
  double dissipation = 0.0;                                // W
};

// The smooth forces of a scene, laid out for evaluation body by body. No force here couples two bodies, so each
// body can be advanced to a time of its own.
class ForceField {
 public:
  ForceField() = default;
  ForceField(const Forces& forces, const std::vector<Body>& bodies);

  // a = g - (c/m)|v| v + springs/m for a moving body, zero for a fixed one.
  [[nodiscard]] Rate rate(int body, const Motion& y) const {
    Rate r;
    if (!(inverse_mass_[body] > 0.0)) return r;
    const Eigen::Vector2d v = y.v.head<2>();
    Eigen::Vector2d a = gravity_;
    if (drag_ > 0.0) {
      const double speed = v.norm();
      a -= (drag_ * inverse_mass_[body] * speed) * v;
      r.dissipation = drag_ * speed * v.squaredNorm();
    }
    if (!springs_.empty()) a += inverse_mass_[body] * spring_force(body, y.q.head<2>());
    r.acceleration.head<2>() = a;
    return r;
  }

  // J: -m g·x of a moving body plus the energy of its springs, zero at the origin and at rest length.
  [[nodiscard]] double potential_energy(int body, const Vec2& position) const;

  // N: force of the anchor springs on a body whose centre is at `position`.
  [[nodiscard]] Vec2 spring_force(int body, const Vec2& position) const;

  // True if every acceleration is exactly zero: bodies move on straight lines.
  [[nodiscard]] bool is_free() const { return gravity_.isZero(0.0) && drag_ == 0.0 && springs_.empty(); }

 private:
  struct Anchored {
    int body;
    Vec2 anchor;
    double stiffness;
    double rest_length;
  };
  Vec2 gravity_ = Vec2::Zero();
  double drag_ = 0.0;
  std::vector<Anchored> springs_;  // sorted by body
  std::vector<int> first_;         // springs of body i are springs_[first_[i]] .. springs_[first_[i + 1] - 1]
  Eigen::VectorXd inverse_mass_;
};

}  // namespace carom
