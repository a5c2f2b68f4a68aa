#include "widgets/scene/edit_names.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "physics/scene/scene.h"
#include "widgets/base/method_names.h"
#include "widgets/base/number_text.h"
#include "widgets/edit/units.h"

namespace carom {
namespace {

constexpr QChar kDegree(0x00b0);
constexpr int kMostDecimals = 12;
constexpr double kSameForce = 1e-9;  // of its size, that only turns
constexpr double kShownStep = 4.0;   // px, that the figures of a place tell apart

// "0° → 15°"
QString turned_text(const Vec2& before, const Vec2& after) {
  return fixed_text(direction(before), 0) + kDegree + QStringLiteral(" → ") + fixed_text(direction(after), 0) +
         kDegree;
}

}  // namespace

QString fixed_text(double value, int decimals) {
  QString text = QString::number(std::abs(value), 'f', decimals);
  if (value < 0.0 && text.toDouble() != 0.0) text.prepend(kMinus);
  return text;
}

int decimals_of(double step) {
  return std::clamp(static_cast<int>(std::ceil(-std::log10(step) - 1e-9)), 0, kMostDecimals);
}

double degrees(double radians) {
  const double turned = std::remainder(radians * 180.0 / std::numbers::pi, 360.0);
  return turned <= -180.0 ? turned + 360.0 : turned;
}

double radians(double degrees) { return degrees * std::numbers::pi / 180.0; }

double direction(const Vec2& v) { return degrees(std::atan2(v.y(), v.x())); }

Vec2 unit_vector(double degrees) {
  const double angle = degrees * std::numbers::pi / 180.0;
  const auto tidy = [](double c) { return std::abs(c) < 1e-15 ? 0.0 : c; };
  return {tidy(std::cos(angle)), tidy(std::sin(angle))};
}

QString place_text(const Vec2& position, double scale) {
  const int decimals = decimals_of(kShownStep / scale);
  return "x " + fixed_text(position.x(), decimals) + " m, y " + fixed_text(position.y(), decimals) + " m";
}

QString velocity_text(const Vec2& velocity, int decimals, int decimals_of_direction) {
  QString speed = fixed_text(velocity.norm(), decimals) + " m/s";
  if (velocity.isZero(0.0)) return speed;
  return speed + " at " + fixed_text(direction(velocity), decimals_of_direction) + kDegree;
}

QString with_former(const QString& detail, const QString& value) {
  return (detail.isEmpty() ? QString() : detail + " · ") + "was " + value;
}

QString angle_text(double radians, int decimals) { return fixed_text(degrees(radians), decimals) + kDegree; }

QString spin_text(double spin) { return fixed_text(spin, 2) + " rad/s"; }

QString turns_text(double spin) { return fixed_text(spin / (2.0 * std::numbers::pi), 2) + " turns a second"; }

QString name_of_part(const Joint& joint) {
  if (!joint.name.empty()) return QString::fromStdString(joint.name);
  const std::string_view kind = name_of(kJointNames, joint.kind);
  return "a " + text_of(kind);
}
QString name_of_part(const Spring& spring) {
  return spring.name.empty() ? QStringLiteral("a spring") : QString::fromStdString(spring.name);
}
QString name_of_part(const AppliedForce& force) { return "a force on " + QString::fromStdString(force.body); }

QString name_of_bodies(std::span<const Body> bodies) {
  if (bodies.size() == 1) return QString::fromStdString(bodies[0].name);
  return QStringLiteral("%1 bodies").arg(bodies.size());
}

QString name_of_velocity(std::span<const Body> before, std::span<const Body> after) {
  const QString who = name_of_bodies(before);
  if (before.size() != 1) return QStringLiteral("Speed of %1").arg(who);
  const QString old_speed = fixed_text(before[0].velocity.norm(), 2);
  const QString speed = fixed_text(after[0].velocity.norm(), 2);
  const QString arrow = QStringLiteral(" → ");
  if (old_speed != speed) return "Speed of " + who + " " + old_speed + arrow + speed + " m/s";
  return "Direction of " + who + " " + turned_text(before[0].velocity, after[0].velocity);
}

QString name_of_spin(const Body& before, const Body& after) {
  return "Spin of " + QString::fromStdString(after.name) + " " + fixed_text(before.spin, 2) + " → " +
         spin_text(after.spin);
}

QString name_of_force(const AppliedForce& before, const AppliedForce& after) {
  const QString who = QString::fromStdString(before.body);
  const double old_size = before.force.norm();
  const double size = after.force.norm();
  if (std::abs(size - old_size) > kSameForce * old_size) {
    return "Force on " + who + " " + change_text(old_size, size, "N");
  }
  return "Direction of the force on " + who + " " + turned_text(before.force, after.force);
}

}  // namespace carom
