#include "widgets/scene/direction_arc.h"

#include <QPainter>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "widgets/scene/edit_names.h"
#include "widgets/theme/theme.h"

namespace carom {
namespace {

constexpr double kShare = 0.75;         // of the arrow, at which the arc stands
constexpr double kLeastLength = 36.0;   // px: there is no room at a shorter arrow
constexpr double kMostRadius = 120.0;   // px
constexpr double kLeastBetween = 26.0;  // px, of the arc, for a number between the arrow and the horizontal
constexpr double kGap = 6.0;            // px, from the arc to the number
constexpr double kTextSize = 12.0;      // px
constexpr QSizeF kTextRoom(44.0, 18.0);
constexpr double kLeastAngle = 0.05;  // degrees, which a number can tell from 0

bool is_shown(const DirectionArc& arc) {
  return arc.length >= kLeastLength && std::abs(arc.degrees) >= kLeastAngle;
}

double radius_of(const DirectionArc& arc) { return std::min(kShare * arc.length, kMostRadius); }

}  // namespace

DirectionArc direction_arc(const Body& body, const Camera& camera, double seconds) {
  if (body.velocity.isZero(0.0)) return {};
  return {camera.to_screen(body.position), body.velocity.norm() * seconds * camera.scale,
          direction(body.velocity)};
}

QRectF text_place(const DirectionArc& arc) {
  if (!is_shown(arc)) return {};
  const double radius = radius_of(arc);
  const double angle = 0.5 * arc.degrees * std::numbers::pi / 180.0;
  QRectF rect(QPointF(), kTextRoom);
  if (2.0 * std::abs(angle) * radius < kLeastBetween) {
    // Beyond the horizontal.
    const double below = std::copysign(0.5 * kTextRoom.height() + 2.0, arc.degrees);
    rect.moveCenter(arc.foot + QPointF(radius, below));
    return rect;
  }
  const QPointF along(std::cos(angle), -std::sin(angle));
  const double out = radius + kGap + 0.5 * std::abs(along.x()) * kTextRoom.width() +
                     0.5 * std::abs(along.y()) * kTextRoom.height();
  rect.moveCenter(arc.foot + out * along);
  return rect;
}

void paint_direction(QPainter& painter, const DirectionArc& arc, const Theme& theme) {
  if (!is_shown(arc)) return;
  const double radius = radius_of(arc);
  constexpr double kUnits = 16.0;  // of Qt in a degree
  QPen horizontal(theme.muted, 1.2);
  horizontal.setDashPattern({4.0, 3.0});
  painter.setBrush(Qt::NoBrush);
  painter.setPen(horizontal);
  painter.drawLine(arc.foot, arc.foot + QPointF(arc.length, 0.0));
  painter.setPen(QPen(theme.accent, 1.5));
  painter.drawArc(QRectF(arc.foot - QPointF(radius, radius), QSizeF(2 * radius, 2 * radius)), 0,
                  qRound(kUnits * arc.degrees));
  QFont font = painter.font();
  font.setPixelSize(static_cast<int>(kTextSize));
  font.setWeight(QFont::DemiBold);
  painter.setFont(font);
  const bool whole = std::abs(arc.degrees - std::round(arc.degrees)) < kLeastAngle;
  painter.drawText(text_place(arc), Qt::AlignCenter, fixed_text(arc.degrees, whole ? 0 : 1) + QChar(0x00b0));
}

}  // namespace carom
