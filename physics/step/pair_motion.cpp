#include "physics/step/pair_motion.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "physics/collision/pair_contact.h"
#include "physics/collision/tips.h"
#include "physics/contact/contact_velocity.h"
#include "physics/scene/drive.h"
#include "physics/step/coming_to_rest.h"

namespace carom {
namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
// Relative to the smaller body.
constexpr double kHeld = 1e-5;

}  // namespace

Pose pose_at_start(const World& world, BodyIndex body) {
  return world.shapes().pose(body, world.trajectories.at_start(body).head<3>());
}

double smaller_size(const World& world, BodyIndex a, BodyIndex b) {
  double size = std::numeric_limits<double>::infinity();
  for (const BodyIndex i : {a, b}) {
    if (!world.infinite_mass(i)) size = std::min(size, world.shapes().size[i]);
  }
  return size;
}

double touch_tolerance(const World& world, BodyIndex a, BodyIndex b, double duration) {
  const Geometry& shapes = world.shapes();
  const double time = std::max(duration, world.method.step);
  const auto ya = world.trajectories.at_start(a);
  const auto yb = world.trajectories.at_start(b);
  double reach = ya.head<2>().lpNorm<1>() + yb.head<2>().lpNorm<1>() + shapes.size[a] + shapes.size[b];
  double speeds = ya.segment<2>(3).norm() + yb.segment<2>(3).norm();
  for (const BodyIndex i : {a, b}) {
    if (shapes.is_disc(i)) continue;
    // The rounding of an angle moves a corner.
    reach += std::abs(world.trajectories.at_start(i)[2]) * shapes.size[i];
    speeds += std::abs(world.trajectories.at_start(i)[5]) * shapes.size[i];
  }
  return 16.0 * kEpsilon * (reach + speeds * time);
}

double held_gap(const World& world, BodyIndex a, BodyIndex b) { return kHeld * smaller_size(world, a, b); }

double gap_in_flight(World& world, BodyIndex a, BodyIndex b, const ShapePair& parts, double within) {
  const auto pose = [&](BodyIndex i) { return world.shapes().pose(i, world.trajectories.place(i, within)); };
  Contact contact;
  contact.parts = parts;
  return contact_again(world.shapes(), a, pose(a), b, pose(b), contact).gap;
}

bool passes_by(const World& world, BodyIndex a, BodyIndex b, const Approach& at) {
  if (!(at.speed < 0.0)) return false;
  const double time = std::max(at.contact.gap, 0.0) / -at.speed;
  const Geometry& g = world.shapes();
  const ShapePair parts = g.parts_or_first(at.contact.parts, a, b);
  const auto pose = [&](BodyIndex i, ShapeIndex part) {
    const auto& y = world.trajectories.at_start(i);
    return g.part_pose(i, part, g.pose(i, y.head<3>() + time * y.segment<3>(3)));
  };
  const auto tips = tip_normals(g.shapes, parts.a, pose(a, parts.a), parts.b, pose(b, parts.b));
  if (!tips) return false;
  const auto along = [&](const Vec2& normal) {
    return world.parting_speed(a, b, {at.contact.gap, normal, at.contact.point});
  };
  return passes_along(*tips, along).has_value();
}

double curvature(const World& world, BodyIndex a, BodyIndex b, double of_centres) {
  double sum = of_centres;
  for (const BodyIndex i : {a, b}) {
    if (world.trajectories.turn_bound(i) > 0.0)
      sum += world.trajectories.turn_bound(i) * world.shapes().core_reach[i];
  }
  return sum;
}

double turning_press(const World& world, const Contacts& c, int i) {
  const Eigen::Vector3d a = world.state.v.col(c.a[i]);
  const Eigen::Vector3d b = world.state.v.col(c.b[i]);
  const double slides = std::abs(contact_velocity(c, i, world.state.v).tangential);
  return (std::abs(a[2]) + std::abs(b[2])) * slides + a[2] * a[2] * c.arm_a[i].norm() +
         b[2] * b[2] * c.arm_b[i].norm();
}

double pressed_in(const World& world, BodyIndex a, BodyIndex b, double h) {
  return curvature(world, a, b, world.trajectories.curvature_bound(a) + world.trajectories.curvature_bound(b)) *
             h +
         kRestSpeed;
}

double pressing(World& world, BodyIndex a, BodyIndex b, const Contact& contact, double within) {
  Trajectories& trajectories = world.trajectories;
  const auto acceleration = [&](BodyIndex i) -> Eigen::Vector3d {
    if (!world.model->is_kinematic(i)) return trajectories.acceleration(i);
    const Vec2 kinematic = drive_acceleration(world.model->drive(i), trajectories.epoch() + within);
    return {kinematic.x(), kinematic.y(), 0.0};
  };
  const Eigen::Vector3d acceleration_a = acceleration(a);
  const Eigen::Vector3d acceleration_b = acceleration(b);
  if (!world.has_moving_corners(a, b)) return -contact.normal.dot((acceleration_b - acceleration_a).head<2>());

  // Where corners move, the contact point wanders over the surfaces. The second difference of the gap along
  // the flight from here on includes that. It is taken over as long as the gap's rounding allows.
  double bound = 0.0;
  for (const auto& [i, by] : {std::pair(a, acceleration_a), std::pair(b, acceleration_b)}) {
    bound += by.head<2>().norm();
    if (!world.infinite_mass(i))
      bound += turning_curvature(world.shapes().core_reach[i], trajectories.at_start(i)[5], by[2]);
  }
  if (bound == 0.0) return 0.0;
  const double wait = std::min(world.method.step, std::sqrt(2e4 * touch_tolerance(world, a, b) / bound));
  const auto flown = [&](BodyIndex i, const Eigen::Vector3d& by) -> Eigen::Vector3d {
    const auto& y = trajectories.at_start(i);
    return y.head<3>() + wait * (y.segment<3>(3) + 0.5 * wait * by);
  };
  const Geometry& shapes = world.shapes();
  const double gap = contact_again(shapes, a, shapes.pose(a, flown(a, acceleration_a)), b,
                                   shapes.pose(b, flown(b, acceleration_b)), contact)
                         .gap;
  const double speed = world.parting_speed(a, b, contact);
  return -2.0 * (gap - contact.gap - speed * wait) / (wait * wait);
}

}  // namespace carom
