#include "physics/step/contact_pressing.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "physics/collision/pair_contact.h"
#include "physics/math/vectors.h"
#include "physics/scene/drive.h"
#include "physics/step/coming_to_rest.h"
#include "physics/step/contact_finder.h"
#include "physics/step/internal_edges.h"
#include "physics/step/pair_motion.h"

namespace carom {
namespace {

// Of the change of a speed by forces in a step, and of the largest speed: a slower motion is not one.
constexpr double kNoise = 1.6e-9;
constexpr double kRounding = 256.0 * std::numeric_limits<double>::epsilon();

// Bounces are followed until the rebounds are slower than this share of the speed by which forces press the
// pair together within a step. With e = 1/2 the bounces left out would last an eighth of a step at most.
constexpr double kLastShare = 0.03125;

// Relative to the size: a contact that is open by more has ended.
constexpr double kOpen = 0.02;

// Of a body by a contact force, m/s² and rad/s².
Eigen::Vector3d acceleration_by(const World& world, const ContactForce& f, const Eigen::Vector3d& support,
                                BodyIndex body) {
  const Vec2 force = support[0] * f.normal + support[1] * crossed(f.normal);
  const Vec2 arm = f.point - world.trajectories.at_start(body).head<2>();
  const Vec2 moved = world.mass().inverse_mass[body] * force;
  return {moved.x(), moved.y(), world.mass().inverse_inertia[body] * (cross(arm, force) + support[2])};
}

}  // namespace

void ContactPressing::find(World& world, double step_length, bool may_divide, const ContactMemory& memory) {
  step_length_ = step_length;
  follows_bounces_ = may_divide && world.method.impacts == ImpactsId::kLocated &&
                     world.method.integrator != IntegratorId::kExplicitEuler &&
                     memory.forces.size() <= static_cast<std::size_t>(kFewContactsOfScene);
  const int n = world.bodies();
  acceleration_.setZero(3, n);
  for (BodyIndex i{0}; i < n; ++i) {
    if (!world.infinite_mass(i)) {
      acceleration_.col(i) = world.trajectories.acceleration(i);
    } else if (world.model->is_kinematic(i)) {
      acceleration_.col(i).head<2>() = drive_acceleration(world.model->drive(i), world.trajectories.epoch());
    }
  }
  double most = 0.0;  // m/s², of any point of a body
  for (BodyIndex i{0}; i < n; ++i) {
    const double turning = std::abs(acceleration_.col(i)[2]);
    most = std::max(
        most, acceleration_.col(i).head<2>().norm() + (turning > 0.0 ? turning * world.shapes().size[i] : 0.0));
  }
  change_by_forces_ = step_length * most;
  noise_ = kNoise * change_by_forces_ + kRounding * world.state.v.topRows<2>().cwiseAbs().maxCoeff();
  update(world, memory);
}

void ContactPressing::update(const World& world, const ContactMemory& memory) {
  pressing_ = acceleration_;
  pushes_.resize(memory.support.size());
  for (std::size_t k = 0; k < memory.support.size(); ++k) {
    const ContactForce& f = memory.forces[k];
    pushes_[k] = {-acceleration_by(world, f, memory.support[k], f.a),
                  acceleration_by(world, f, memory.support[k], f.b)};
    pressing_.col(f.a) += pushes_[k].of_a;
    pressing_.col(f.b) += pushes_[k].of_b;
  }
}

double ContactPressing::between(const World& world, const ContactMemory& memory, BodyIndex a, BodyIndex b,
                                const Vec2& point, const Vec2& normal) const {
  Eigen::Vector3d of_a = pressing_.col(a);
  Eigen::Vector3d of_b = pressing_.col(b);
  const auto& forces = memory.forces;
  const auto take_off = [&](BodyIndex body, std::size_t k) {
    (body == a ? of_a : of_b) -= forces[k].a == body ? pushes_[k].of_a : pushes_[k].of_b;
  };
  // By other points of the pair.
  const double near = kSamePlace * smaller_size(world, a, b);
  Eigen::Vector3d tilt_a = Eigen::Vector3d::Zero();
  Eigen::Vector3d tilt_b = Eigen::Vector3d::Zero();
  std::size_t k = first_force_of(forces, a, b);
  for (; k < memory.support.size() && forces[k].a == a && forces[k].b == b; ++k) {
    take_off(a, k);
    take_off(b, k);
    if ((forces[k].point - point).norm() <= near) continue;
    tilt_a += pushes_[k].of_a;
    tilt_b += pushes_[k].of_b;
  }
  if (world.is_immovable(a) != world.is_immovable(b) &&
      forces.size() <= static_cast<std::size_t>(kFewContactsOfScene)) {
    const BodyIndex mover = world.is_immovable(a) ? b : a;
    for (k = 0; k < memory.support.size(); ++k) {
      const ContactForce& f = forces[k];
      const bool on_other = (f.a == mover || f.b == mover) && (f.a != a || f.b != b);
      if (on_other && world.same_sides(f.a, f.b, a, b) != 0.0 && std::abs(cross(f.normal, normal)) <= kTogether)
        take_off(mover, k);
    }
  }
  const Vec2 arm_a = point - world.trajectories.at_start(a).head<2>();
  const Vec2 arm_b = point - world.trajectories.at_start(b).head<2>();
  const auto closing = [&](const Eigen::Vector3d& by_a, const Eigen::Vector3d& by_b) {
    return -((by_b - by_a).head<2>().dot(normal) + by_b[2] * cross(arm_b, normal) -
             by_a[2] * cross(arm_a, normal));
  };
  return closing(of_a, of_b) + std::max(0.0, closing(tilt_a, tilt_b));
}

double ContactPressing::rest_speed(const World& world, double press, double restitution) const {
  const double least = calms_ && restitution < 1.0 ? std::max(noise_, change_by_forces_) : noise_;
  if (!(press > 0.0)) return least;
  double share = follows_bounces_ ? kLastShare : 1.0;
  if (world.method.integrator == IntegratorId::kExplicitEuler && restitution < 1.0)
    share = std::max(share, last_rebound_of_euler(restitution));
  return std::max(least, share * press * step_length_);
}

void carry_forces(World& world, double passed, const Neighbours& neighbours, ContactMemory& memory) {
  const Geometry& g = world.shapes();
  const auto pose = [&](BodyIndex i) { return g.pose(i, world.trajectories.place(i, passed)); };
  for (std::size_t k = 0; k < memory.support.size(); ++k) {
    ContactForce& f = memory.forces[k];
    const auto moved = [&](BodyIndex i) -> Eigen::Vector3d {
      return world.trajectories.place(i, passed) - world.state.q.col(i);
    };
    const Eigen::Vector3d by_a = moved(f.a);
    const Eigen::Vector3d by_b = moved(f.b);
    const Vec2 slid = (by_b - by_a).head<2>();
    const double size = smaller_size(world, f.a, f.b);
    const bool moves = slid.norm() > kTogether * size || std::abs(by_a[2]) + std::abs(by_b[2]) > kTogether;
    const double open = kOpen * size;
    if (moves) {
      const Manifold m = manifold_of(g, f.a, pose(f.a), f.b, pose(f.b), f.id, open);
      const int at = point_with(m, f.id);
      const auto is_bare = [&] {
        return !may_be_continued(world, f.a, f.b) ||
               !on_internal_edge(world, f.a, f.b, m.contact(at), neighbours.of_pair(world, f.a, f.b), pose);
      };
      if (at >= 0 && is_bare()) {
        f.point = m.points[static_cast<std::size_t>(at)].point;
        continue;
      }
    }
    if (std::abs(slid.dot(f.normal)) > open) memory.support[k].setZero();
    f.point += (world.infinite_mass(f.b) ? by_a : by_b).head<2>();
  }
}

}  // namespace carom
