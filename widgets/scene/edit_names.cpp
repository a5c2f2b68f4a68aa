#include "widgets/scene/edit_names.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "widgets/base/number_text.h"

namespace carom {
namespace {

constexpr QChar kDegree(0x00b0);
constexpr int kMostDecimals = 12;
constexpr double kShownStep = 4.0;  // px, that the figures of a place tell apart

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

QString angle_text(double radians, int decimals) { return fixed_text(degrees(radians), decimals) + kDegree; }

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
  return "Direction of " + who + " " + fixed_text(direction(before[0].velocity), 0) + kDegree + arrow +
         fixed_text(direction(after[0].velocity), 0) + kDegree;
}

}  // namespace carom
