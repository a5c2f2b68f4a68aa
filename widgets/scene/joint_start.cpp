#include "widgets/scene/joint_start.h"

#include <Eigen/Dense>
#include <cmath>
#include <cstddef>

#include "physics/math/vectors.h"

namespace carom {
namespace {

constexpr double kSlack = 1e-6;  // of the speeds, at which ends still move together

using Rows = Eigen::Matrix<double, Eigen::Dynamic, 6>;  // over the velocity and spin of each body
using Motion = Eigen::Matrix<double, 6, 1>;

double inverse(double mass) { return mass > 0.0 && std::isfinite(mass) ? 1.0 / mass : 0.0; }

// What a joint forbids: the speed along a rod, that of a pin's ends apart, and the turning of a weld.
Rows rows_of(JointKind kind, const JointEnds& ends) {
  Rows apart(2, 6);
  for (std::size_t i = 0; i < 2; ++i) {
    const double sign = i == 0 ? 1.0 : -1.0;
    const Vec2 arm = ends.bodies[i] ? Vec2(ends.places[i] - ends.bodies[i]->position) : Vec2(Vec2::Zero());
    apart.block<2, 2>(0, static_cast<Eigen::Index>(3 * i)) = sign * Eigen::Matrix2d::Identity();
    apart.col(static_cast<Eigen::Index>(3 * i + 2)) = sign * crossed(arm);
  }
  if (kind == JointKind::kRod) return (ends.places[0] - ends.places[1]).normalized().transpose() * apart;
  if (kind == JointKind::kPin) return apart;
  Rows all = Rows::Zero(3, 6);
  all.topRows<2>() = apart;
  all(2, 2) = 1.0;
  all(2, 5) = -1.0;
  return all;
}

}  // namespace

std::vector<Body> as_joined(JointKind kind, const JointEnds& ends) {
  if (kind == JointKind::kString) return {};
  Motion before = Motion::Zero();
  Motion inverse_mass = Motion::Zero();
  double speeds = 0.0;
  for (std::size_t i = 0; i < 2; ++i) {
    const std::optional<Body>& body = ends.bodies[i];
    if (!body) continue;
    const auto k = static_cast<Eigen::Index>(3 * i);
    before.segment<3>(k) << body->velocity, body->spin;
    const double mass = inverse(mass_of(*body));
    inverse_mass.segment<3>(k) << mass, mass, inverse(inertia_of(*body));
    speeds += body->velocity.norm() + std::abs(body->spin) * (ends.places[i] - body->position).norm() +
              (kind == JointKind::kWeld ? std::abs(body->spin) : 0.0);
  }
  const Rows rows = rows_of(kind, ends);
  const Eigen::VectorXd gap = rows * before;
  if (!(gap.cwiseAbs().maxCoeff() > kSlack * speeds)) return {};
  const Eigen::MatrixXd held = rows * inverse_mass.asDiagonal() * rows.transpose();
  const Eigen::VectorXd impulse = held.completeOrthogonalDecomposition().solve(-gap);
  Motion after = before + inverse_mass.asDiagonal() * rows.transpose() * impulse;
  // Without the rounding of what is one number: the spin of both.
  if (kind == JointKind::kWeld) inverse_mass[2] > 0.0 ? after[2] = after[5] : after[5] = after[2];
  std::vector<Body> changed;
  for (std::size_t i = 0; i < 2; ++i) {
    const auto k = static_cast<Eigen::Index>(3 * i);
    if (!ends.bodies[i] || after.segment<3>(k) == before.segment<3>(k)) continue;
    changed.push_back(*ends.bodies[i]);
    changed.back().velocity = after.segment<2>(k);
    changed.back().spin = after[k + 2];
  }
  return changed;
}

}  // namespace carom
