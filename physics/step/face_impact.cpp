#include "physics/step/face_impact.h"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "physics/math/vectors.h"
#include "physics/step/contact_patch.h"

namespace carom {
namespace {

using Changes = Eigen::Matrix<double, 3, 2>;  // of the velocities of a and b

// Of the largest response: one that turns less than this turns nothing.
constexpr double kNoTurn = 1e-12;
// Of the energy of the impact: rounding.
constexpr double kNoGain = 1e-13;

// By an impulse at the contact's point and a couple.
Changes free_changes(const World& world, BodyIndex a, BodyIndex b, const Contact& contact, const Vec2& impulse,
                     double couple) {
  Changes by;
  int column = 0;
  for (const auto& [body, sign] : {std::pair(a, -1.0), std::pair(b, 1.0)}) {
    const Vec2 arm = contact.point - world.trajectories.at_start(body).head<2>();
    by.col(column++) << sign * world.mass().inverse_mass[body] * impulse,
        sign * world.mass().inverse_inertia[body] * (cross(arm, impulse) + couple);
  }
  return by;
}

// The motion of b against a at the contact's point: along the normal and the tangent, and how much faster along
// the normal it is `length` along the tangent; all in m/s.
Eigen::Vector3d relative(const World& world, BodyIndex a, BodyIndex b, const Contact& contact, double length,
                         const Changes& v) {
  const auto at_point = [&](BodyIndex body, int column) -> Vec2 {
    const Vec2 arm = contact.point - world.trajectories.at_start(body).head<2>();
    return v.col(column).head<2>() + v(2, column) * crossed(arm);
  };
  const Vec2 u = at_point(b, 1) - at_point(a, 0);
  return {u.dot(contact.normal), u.dot(crossed(contact.normal)), length * (v(2, 0) - v(2, 1))};
}

struct FaceMotion {
  Eigen::Vector3d before;    // as relative()
  Eigen::Matrix3d response;  // 1/kg: of that to j_n, j_t, and j_n this length along the tangent instead
};

FaceMotion motion_of(World& world, BodyIndex a, BodyIndex b, const Contact& contact, double length) {
  Trajectories& trajectories = world.trajectories;
  const bool jointed = trajectories.is_jointed(a) || trajectories.is_jointed(b);
  FaceMotion motion;
  Changes now;
  now << trajectories.at_start(a).segment<3>(3), trajectories.at_start(b).segment<3>(3);
  motion.before = relative(world, a, b, contact, length, now);
  const std::array<Vec2, 3> impulses = {contact.normal, crossed(contact.normal), Vec2::Zero()};
  for (int k = 0; k < 3; ++k) {
    Changes by =
        free_changes(world, a, b, contact, impulses[static_cast<std::size_t>(k)], k == 2 ? -length : 0.0);
    if (jointed) trajectories.project_changes(std::array{a, b}, by);
    motion.response.col(k) = relative(world, a, b, contact, length, by);
  }
  return motion;
}

// j_n, j_t, and the share of the length times j_n, for the motion along the normal and turning after it:
// without slip, or sliding.
std::optional<Eigen::Vector3d> impulses_for(const FaceMotion& motion, double normal_after, double turning_after,
                                            double friction) {
  const Eigen::Vector3d& u = motion.before;
  const Eigen::Matrix3d& k = motion.response;
  const Eigen::Vector3d held =
      k.partialPivLu().solve(Eigen::Vector3d(normal_after - u[0], -u[1], turning_after - u[2]));
  if (!held.allFinite() || !(held[0] > 0.0)) return std::nullopt;
  if (std::abs(held[1]) <= friction * held[0]) return held;
  const double slope = std::copysign(friction, held[1]);
  Eigen::Matrix2d sliding;
  sliding << k(0, 0) + slope * k(0, 1), k(0, 2), k(2, 0) + slope * k(2, 1), k(2, 2);
  const Eigen::Vector2d j =
      sliding.partialPivLu().solve(Eigen::Vector2d(normal_after - u[0], turning_after - u[2]));
  const Eigen::Vector3d slides(j[0], slope * j[0], j[1]);
  // Friction acts against the slip that is left.
  const bool against = slope * (u[1] + k.row(1).dot(slides)) <= 0.0;
  if (!slides.allFinite() || !(j[0] > 0.0) || !against) return std::nullopt;
  return slides;
}

}  // namespace

std::optional<FaceImpact> face_impact(World& world, BodyIndex a, BodyIndex b, const Contact& contact,
                                      const SurfaceLaw& material) {
  if (!(material.kinetic_friction > 0.0) || material.tangential_restitution != 0.0 || material.sticks)
    return std::nullopt;
  const std::optional<Stretch> stretch = stretch_of(world, a, b, contact);
  if (!stretch) return std::nullopt;
  const Vec2 along = crossed(contact.normal);
  const double length = stretch->high - stretch->low;
  const FaceMotion motion = motion_of(world, a, b, contact, length);
  const Eigen::Vector3d& u = motion.before;
  const Eigen::Matrix3d& k = motion.response;
  if (!(k(2, 2) > kNoTurn * (k(0, 0) + k(1, 1)))) return std::nullopt;
  // Of the two ends.
  const auto speed_at = [&](double x) { return u[0] + u[2] * x / length; };
  const auto rebound = [&](double x) { return material.restitution * std::max(0.0, -speed_at(x)); };
  if (!(std::min(speed_at(stretch->low), speed_at(stretch->high)) < 0.0)) return std::nullopt;
  const double turning_after = rebound(stretch->high) - rebound(stretch->low);
  const double normal_after = rebound(stretch->low) - turning_after * stretch->low / length;
  const std::optional<Eigen::Vector3d> j =
      impulses_for(motion, normal_after, turning_after, material.kinetic_friction);
  if (!j) return std::nullopt;
  FaceImpact found;
  const double x = (*j)[2] * length / (*j)[0];
  found.point = contact.point + std::clamp(x, stretch->low, stretch->high) * along;
  if (x < stretch->low || x > stretch->high) {
    const double end = x < stretch->low ? stretch->low : stretch->high;
    return speed_at(end) < 0.0 ? std::optional(found) : std::nullopt;
  }
  const Eigen::Vector3d mean = u + 0.5 * k * *j;
  const double lost = -j->dot(mean);
  if (lost < -kNoGain * std::abs((*j)[0] * u[0])) return std::nullopt;
  found.impact.emplace();
  found.impact->normal = (*j)[0];
  found.impact->tangential = (*j)[1];
  // An end that one impulse drives into the other body may take energy from the other one; only the sum is
  // lost.
  found.impact->lost_to_friction = std::clamp(-(*j)[1] * mean[1], 0.0, std::max(0.0, lost));
  found.impact->lost_to_restitution = std::max(0.0, lost) - found.impact->lost_to_friction;
  return found;
}

bool apply_face_impulse(World& world, BodyIndex a, BodyIndex b, const Contact& contact, const Impact& impact) {
  Trajectories& trajectories = world.trajectories;
  const Vec2 j = impact.normal * contact.normal + impact.tangential * crossed(contact.normal);
  const Changes by = free_changes(world, a, b, contact, j, 0.0);
  if (trajectories.is_jointed(a) || trajectories.is_jointed(b))
    return trajectories.apply_changes(std::array{a, b}, by);
  int column = 0;
  for (const BodyIndex body : {a, b}) {
    const auto change = by.col(column++);
    const auto y = trajectories.at_start(body);
    if (!world.infinite_mass(body))
      trajectories.set_velocity(body, y.segment<2>(3) + change.head<2>(), y[5] + change[2]);
  }
  return true;
}

}  // namespace carom
