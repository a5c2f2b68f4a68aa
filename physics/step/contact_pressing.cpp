#include "physics/step/contact_pressing.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "physics/math/vectors.h"
#include "physics/scene/drive.h"
#include "physics/step/coming_to_rest.h"
#include "physics/step/pair_motion.h"

namespace carom {
namespace {

// Of the change of a speed by forces in a step, and of the largest speed: a slower motion is not one.
constexpr double kNoise = 1.6e-9;
constexpr double kRounding = 256.0 * std::numeric_limits<double>::epsilon();

// Adds `sign` times a contact force to the accelerations of one of its bodies.
void add_force(const World& world, const ContactForce& f, const Eigen::Vector3d& support, BodyIndex body,
               double sign, Eigen::Ref<Eigen::Vector3d> acceleration) {
  const Vec2 force = support[0] * f.normal + support[1] * crossed(f.normal);
  const Vec2 arm = f.point - world.trajectories.at_start(body).head<2>();
  acceleration.head<2>() += sign * world.mass().inverse_mass[body] * force;
  acceleration[2] += sign * world.mass().inverse_inertia[body] * (cross(arm, force) + support[2]);
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
  update(world, memory);
}

void ContactPressing::update(const World& world, const ContactMemory& memory) {
  pressing_ = acceleration_;
  for (std::size_t k = 0; k < memory.support.size(); ++k) {
    const ContactForce& f = memory.forces[k];
    add_force(world, f, memory.support[k], f.a, -1.0, pressing_.col(f.a));
    add_force(world, f, memory.support[k], f.b, 1.0, pressing_.col(f.b));
  }
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
    add_force(world, forces[k], memory.support[k], a, 1.0, of_a);
    add_force(world, forces[k], memory.support[k], b, -1.0, of_b);
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
