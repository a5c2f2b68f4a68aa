#pragma once

#include <Eigen/Core>
#include <type_traits>
#include <utility>
#include <vector>

#include "physics/model/body_starts.h"
#include "physics/scene/scene.h"

namespace carom {

// The unknowns of one body as a column: rows 0-2 are q = (x, y, angle) in m, m, rad; rows 3-5 are v = q' in
// m/s, m/s, rad/s; rows 6-13 are quadratures, extra state components that integrators advance with the rest
// so that the ledger closes: losses to drag and to dampers, work of drives and applied forces (all in J), the
// momentum x, y (N s) from external forces other than gravity, the work of a hand (J), and the angular momentum
// about the origin (kg m²/s) from those forces and from gravity.
inline constexpr int kRows = 14;
inline constexpr int kQuadratures = 8;
enum QuadratureRow {
  kDragLoss,
  kDamperLoss,
  kWorkIn,
  kImpulseX,
  kImpulseY,
  kHandWork,
  kAngularImpulse,
  kGravityAngularImpulse
};
// Rows of a motion without quadratures, and of one without that of gravity.
inline constexpr int kMotionRows = 6;
inline constexpr int kRowsWithoutGravity = kRows - 1;

template <int kBodies>
using Columns = Eigen::Matrix<double, kRows, kBodies>;
using Motion = Columns<1>;                                 // of one body
using Kinematics = Eigen::Matrix<double, kMotionRows, 1>;  // q and v of one body alone
using Motions = Columns<Eigen::Dynamic>;                   // of several that are advanced together

template <class Y>
[[nodiscard]] auto q_of(Y&& y) {
  return std::forward<Y>(y).template topRows<3>();
}
template <class Y>
[[nodiscard]] auto v_of(Y&& y) {
  return std::forward<Y>(y).template middleRows<3>(3);
}
template <class Y>
[[nodiscard]] auto quadratures_of(Y&& y) {
  return std::forward<Y>(y).template bottomRows<std::decay_t<Y>::RowsAtCompileTime - kMotionRows>();
}
template <class Y>
[[nodiscard]] auto angular_rows_of(Y&& y) {
  constexpr int kFirst = kMotionRows + kAngularImpulse;
  return std::forward<Y>(y).template bottomRows<std::decay_t<Y>::RowsAtCompileTime - kFirst>();
}

// The motions of N bodies at one time, as arrays with one column per body.
struct State {
  Eigen::Matrix3Xd q;
  Eigen::Matrix3Xd v;
  Eigen::Matrix<double, kQuadratures, Eigen::Dynamic> quadratures;

  [[nodiscard]] int size() const { return static_cast<int>(q.cols()); }
  void resize(int bodies) {
    q.resize(3, bodies);
    v.resize(3, bodies);
    quadratures.resize(kQuadratures, bodies);
  }
  void set_motion(int i, const Motion& m) {
    q.col(i) = q_of(m);
    v.col(i) = v_of(m);
    quadratures.col(i) = quadratures_of(m);
  }
  [[nodiscard]] Vec2 position(int i) const { return q.col(i).head<2>(); }
  [[nodiscard]] Vec2 velocity(int i) const { return v.col(i).head<2>(); }
};

// The motion of a body as the scene states it; a kinematic one has the position and velocity of its drive at
// `time` (s).
[[nodiscard]] Motion initial_motion(const Body& body, double time = 0.0);

[[nodiscard]] Motion motion_at_start(const BodyStarts& starts, BodyIndex body);

[[nodiscard]] State initial_state(const std::vector<Body>& bodies);

}  // namespace carom
