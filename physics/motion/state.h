#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "physics/scene/scene.h"

namespace carom {

// Generalised coordinates of one body: q = (x, y, angle), v = (x', y', spin), in m, rad, m/s, rad/s.
// `dissipated` is the work in J that velocity-dependent forces have taken from it: one more component of the
// differential equation, advanced by the same integrator, so that drag closes the energy ledger.
struct Motion {
  Eigen::Vector3d q = Eigen::Vector3d::Zero();
  Eigen::Vector3d v = Eigen::Vector3d::Zero();
  double dissipated = 0.0;
};

// The motions of N bodies as arrays, a column a body: q and v are 3×N, dissipated has N entries.
struct State {
  Eigen::Matrix3Xd q;
  Eigen::Matrix3Xd v;
  Eigen::VectorXd dissipated;

  [[nodiscard]] int size() const { return static_cast<int>(q.cols()); }
  [[nodiscard]] Motion motion(int i) const { return {q.col(i), v.col(i), dissipated[i]}; }
  void set_motion(int i, const Motion& m) {
    q.col(i) = m.q;
    v.col(i) = m.v;
    dissipated[i] = m.dissipated;
  }
  [[nodiscard]] Vec2 position(int i) const { return q.col(i).head<2>(); }
  [[nodiscard]] Vec2 velocity(int i) const { return v.col(i).head<2>(); }
};

[[nodiscard]] State initial_state(const std::vector<Body>& bodies);

// Inverse masses and inertias, zero for fixed bodies; masses of fixed bodies are infinite.
struct MassProperties {
  Eigen::VectorXd inverse_mass;     // 1/kg
  Eigen::VectorXd inverse_inertia;  // 1/(kg m²), about the centre
  Eigen::VectorXd mass;             // kg
  Eigen::VectorXd inertia;          // kg m²
};

[[nodiscard]] MassProperties mass_properties(const std::vector<Body>& bodies);

}  // namespace carom
