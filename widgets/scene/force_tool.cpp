#include "widgets/scene/force_tool.h"

#include <algorithm>
#include <cmath>

#include "widgets/scene/edit_names.h"
#include "widgets/scene/grid.h"
#include "widgets/scene/snap.h"

namespace carom {
namespace {

constexpr double kUsualArrow = 100.0;  // px, for about the body's weight
constexpr double kLeastGravity = 1.0;  // m/s², of the weight
constexpr double kSteps = 20.0;        // in the usual arrow
constexpr double kRightAngle = 90.0;   // degrees, with Shift
constexpr int kFreeFigures = 3;

// N
double usual_force(const Frame& frame, const Body& body) {
  const double gravity = frame.forces ? frame.forces->gravity.norm() : 0.0;
  return step_not_below(mass_of(body) * std::max(gravity, kLeastGravity));
}

double metres_per_newton(const JointSight& sight, const Body& body) {
  if (sight.metres_per_newton > 0.0) return sight.metres_per_newton;
  return usual_metres_per_newton(*sight.frame, body, sight.camera.scale);
}

// N, between neighbouring values of the mouse.
double force_step(const JointSight& sight, double a_newton) {
  const double pixels = a_newton * sight.camera.scale;
  return step_for_mouse(step_not_above(kUsualArrow / pixels / kSteps), pixels);
}

QString force_text(const Vec2& force, double step, bool free) {
  const double size = force.norm();
  const QString newtons = free ? number_text(size, kFreeFigures) : fixed_text(size, decimals_of(step));
  return newtons + " N at " + fixed_text(direction(force), free ? 1 : 0) + QChar(0x00b0);
}

}  // namespace

double usual_metres_per_newton(const Frame& frame, const Body& body, double scale) {
  return kUsualArrow / scale / usual_force(frame, body);
}

Vec2 usual_tip(const JointSight& sight, const Body& body) {
  if (has_infinite_mass(body)) return body.position;
  return body.position + metres_per_newton(sight, body) * usual_force(*sight.frame, body) * Vec2::UnitX();
}

Joined push(const JointTool& /*tool*/, const JointSight& sight, const LinkEnds& ends) {
  Joined out;
  out.from = place_of(*sight.frame, ends[0]);
  out.to = place_of(*sight.frame, ends[1]);
  const std::optional<Body> body = body_at_end(*sight.frame, ends[0]);
  if (!body || has_infinite_mass(*body)) {
    out.fault = QStringLiteral("a force begins on a body that moves");
    return out;
  }
  const bool free = !snaps(sight.mouse);
  const bool axis = sight.mouse.keys.testFlag(Qt::ShiftModifier);
  const double a_newton = metres_per_newton(sight, *body);
  const double step = force_step(sight, a_newton);
  Vec2 force = (out.to - out.from) / a_newton;
  const double turned = snapped(direction(force), axis ? kRightAngle : kDirectionStep);
  if (axis) force = unit_vector(turned).dot(force) * unit_vector(turned);
  if (!free) force = snapped(force.norm(), step) * unit_vector(turned);
  if (force.isZero(0.0)) {
    out.fault = QStringLiteral("pull the arrow out of the body");
    return out;
  }
  out.to = out.from + a_newton * force;
  out.name = "Add force on " + QString::fromStdString(body->name);
  out.value = force_text(force, step, free);
  AppliedForce applied;
  applied.body = body->name;
  applied.point = ends[0].own;
  applied.force = force;
  out.edits = {Add<AppliedForce>{applied}};
  return out;
}

}  // namespace carom
