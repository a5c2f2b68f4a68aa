#include "physics/step/contact_pressing.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include "physics/collision/pair_contact.h"
#include "physics/math/vectors.h"
#include "physics/scene/drive.h"
#include "physics/step/coming_to_rest.h"
#include "physics/step/contact_finder.h"
#include "physics/step/pair_motion.h"

namespace carom {
namespace {

// Of the change of a speed by forces in a step, and of the largest speed: a slower motion is not one.
constexpr double kNoise = 1.6e-9;
constexpr double kRounding = 256.0 * std::numeric_limits<double>::epsilon();

// Relative to the size: a contact whose bodies move on by more in a step has gone to another place, or is gone.
constexpr double kMovedOn = 0.02;

// Of a body by a contact force at this point, m/s² and rad/s².
Eigen::Vector3d acceleration_by(const World& world, const ContactForce& f, const Eigen::Vector3d& support,
                                const Vec2& point, BodyIndex body) {
  const Vec2 force = support[0] * f.normal + support[1] * crossed(f.normal);
  const Vec2 arm = point - world.trajectories.at_start(body).head<2>();
  const Vec2 moved = world.mass().inverse_mass[body] * force;
  return {moved.x(), moved.y(), world.mass().inverse_inertia[body] * (cross(arm, force) + support[2])};
}

// m: where the contact of a force of the last step is now; nothing if it is gone.
std::optional<Vec2> place_now(const World& world, const ContactForce& f, double step_length) {
  const Motion a = world.trajectories.at_start(f.a);
  const Motion b = world.trajectories.at_start(f.b);
  const double moves = step_length * (b.segment<2>(3) - a.segment<2>(3)).norm();
  if (!(moves > kMovedOn * smaller_size(world, f.a, f.b))) return f.point;
  const Geometry& g = world.shapes();
  if (!has_parts_at(g, f.a, f.b, f.id)) return std::nullopt;
  const Manifold m = manifold_of(g, f.a, g.pose(f.a, a.head<3>()), f.b, g.pose(f.b, b.head<3>()), f.id, moves);
  const int k = point_with(m, f.id);
  if (k < 0) return std::nullopt;
  return m.points[static_cast<std::size_t>(k)].point;
}

}  // namespace

void ContactPressing::find(World& world, double step_length, const ContactMemory& memory) {
  step_length_ = step_length;
  const int n = world.bodies();
  acceleration_.setZero(3, n);
  for (BodyIndex i{0}; i < n; ++i) {
    if (!world.infinite_mass(i)) {
      acceleration_.col(i) = world.trajectories.acceleration(i);
    } else if (world.model->is_kinematic(i)) {
      acceleration_.col(i).head<2>() = drive_acceleration(world.model->drive(i), world.trajectories.epoch());
    }
  }
  change_by_forces_ = step_length * acceleration_.topRows<2>().colwise().norm().maxCoeff();
  noise_ = kNoise * change_by_forces_ + kRounding * world.state.v.topRows<2>().cwiseAbs().maxCoeff();
  pressing_ = acceleration_;
  pushes_.assign(memory.support.size(), {Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()});
  for (std::size_t k = 0; k < memory.support.size(); ++k) {
    const std::optional<Vec2> place = place_now(world, memory.forces[k], step_length);
    if (place) push(world, memory, k, *place);
  }
}

void ContactPressing::update(const World& world, const ContactMemory& memory) {
  pressing_ = acceleration_;
  pushes_.resize(memory.support.size());
  for (std::size_t k = 0; k < memory.support.size(); ++k) push(world, memory, k, memory.forces[k].point);
}

// Force k of the memory, at this point.
void ContactPressing::push(const World& world, const ContactMemory& memory, std::size_t k, const Vec2& point) {
  const ContactForce& f = memory.forces[k];
  pushes_[k] = {-acceleration_by(world, f, memory.support[k], point, f.a),
                acceleration_by(world, f, memory.support[k], point, f.b)};
  pressing_.col(f.a) += pushes_[k].of_a;
  pressing_.col(f.b) += pushes_[k].of_b;
}

double ContactPressing::between(const World& world, const ContactMemory& memory, BodyIndex a, BodyIndex b,
                                const Vec2& point, const Vec2& normal) const {
  Eigen::Vector3d of_a = pressing_.col(a);
  Eigen::Vector3d of_b = pressing_.col(b);
  const auto& forces = memory.forces;
  const auto before = [](const ContactForce& f, const BodyPair& pair) { return std::pair(f.a, f.b) < pair; };
  auto k = static_cast<std::size_t>(std::lower_bound(forces.begin(), forces.end(), std::pair(a, b), before) -
                                    forces.begin());
  for (; k < memory.support.size() && forces[k].a == a && forces[k].b == b; ++k) {
    of_a -= pushes_[k].of_a;
    of_b -= pushes_[k].of_b;
  }
  const Vec2 arm_a = point - world.trajectories.at_start(a).head<2>();
  const Vec2 arm_b = point - world.trajectories.at_start(b).head<2>();
  return -((of_b - of_a).head<2>().dot(normal) + of_b[2] * cross(arm_b, normal) -
           of_a[2] * cross(arm_a, normal));
}

double ContactPressing::rest_speed(const World& world, double press, double restitution) const {
  if (!(press > 0.0)) return noise_;
  double share = 1.0;
  if (world.method.integrator == IntegratorId::kExplicitEuler && restitution < 1.0)
    share = std::max(share, last_rebound_of_euler(restitution));
  return std::max(noise_, share * press * step_length_);
}

}  // namespace carom
