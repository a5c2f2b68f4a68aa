#include "widgets/scene/overlay.h"

#include <QFontMetricsF>
#include <QGuiApplication>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>

#include "physics/math/vectors.h"
#include "widgets/scene/body_path.h"

namespace carom {
namespace {

constexpr double kHalo = 6.0;     // px, width of the soft line around a selected body
constexpr double kOutline = 2.0;  // px
constexpr double kSquare = 4.0;   // px, half a handle of the size
constexpr double kKnob = 5.5;     // px, radius
constexpr double kGrip = 7.0;     // px, radius of the ring at the tip of a velocity
constexpr double kChosen = 4.0;   // px, width of the line of a chosen joint
constexpr double kHeadLength = 12.0;
constexpr double kHeadHalfWidth = 5.0;
constexpr double kGuide = 2.4;     // px, width of a guide
constexpr double kCross = 3.5;     // px, half the cross at the end of a guide
constexpr double kBlocked = 3.0;   // px, width of a joint or edge that can't be
constexpr double kThinWall = 5.0;  // px, of a thin wall in an overlap
constexpr double kSign = 9.0;      // px, from the middle of a sign to its corners
constexpr int kDetailSize = 12;

QColor faint(QColor color, float alpha) {
  color.setAlphaF(alpha);
  return color;
}

QPen dashed(const QColor& color) {
  QPen pen(color, 1.5);
  pen.setDashPattern({4.0, 3.0});
  return pen;
}

void paint_ghost(QPainter& painter, const Overlay& overlay, const Overlay::Ghost& ghost, const Camera& camera,
                 const Theme& theme) {
  painter.setPen(dashed(theme.muted));
  painter.setBrush(Qt::NoBrush);
  if (!ghost.arrow) {
    painter.drawPath(body_path(ghost.body, camera));
    return;
  }
  const QPointF from = camera.to_screen(ghost.body.position);
  const QPointF tip = camera.to_screen(ghost.body.position + overlay.arrow_seconds * ghost.body.velocity);
  painter.drawLine(from, tip);
  painter.drawEllipse(tip, 3.0, 3.0);
}

QPen dotted(const QColor& color) {
  QPen pen(color, 1.6, Qt::CustomDashLine, Qt::RoundCap);
  pen.setDashPattern({0.1, 3.0});
  return pen;
}

QFont aim_font() {
  QFont font = QGuiApplication::font();
  font.setPixelSize(kDetailSize);
  return font;
}

QString aim_text(const Aim& aim) { return QString("first impact at %1 s").arg(aim.time, 0, 'f', 3); }

// The paths dotted, the bodies dashed where they meet, and the time beside them.
void paint_aim(QPainter& painter, const Aim& aim, const Camera& camera, const Theme& theme) {
  painter.setBrush(Qt::NoBrush);
  painter.setPen(dotted(faint(theme.accent, 0.8F)));
  for (const std::vector<Vec2>& path : aim.paths) {
    QPolygonF line;
    for (const Vec2& at : path) line.append(camera.to_screen(at));
    painter.drawPolyline(line);
  }
  painter.setPen(dashed(theme.accent));
  for (const Body& body : aim.meeting) {
    if (!body.fixed) painter.drawPath(body_path(body, camera));
  }
  painter.setFont(aim_font());
  painter.setPen(theme.accent);
  painter.drawText(text_place(aim, camera), Qt::AlignCenter, aim_text(aim));
}

// From a centre to what it is level with, where a small cross stands.
void paint_guide(QPainter& painter, const Vec2& from, const Vec2& to, const Camera& camera,
                 const Theme& theme) {
  const QPointF at = camera.to_screen(to);
  QPen line = dotted(theme.accent);
  line.setWidthF(kGuide);
  painter.setPen(line);
  painter.drawLine(camera.to_screen(from), at);
  painter.setPen(QPen(theme.accent, 1.5));
  painter.drawLine(at - QPointF(kCross, kCross), at + QPointF(kCross, kCross));
  painter.drawLine(at - QPointF(kCross, -kCross), at + QPointF(kCross, -kCross));
}

void paint_corners(QPainter& painter, const Overlay::Corners& corners, const Camera& camera,
                   const Theme& theme) {
  QPolygonF line;
  for (const Vec2& corner : corners.set) line.append(camera.to_screen(corner));
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(theme.accent, kOutline, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.drawPolyline(line);
  const auto edge_to = [&](const Vec2& corner, const QColor& color) {
    const QPointF at = camera.to_screen(corner);
    painter.setPen(dashed(color));
    if (!line.isEmpty()) painter.drawLine(line.last(), at);
    painter.setPen(QPen(color, kOutline));
    painter.drawEllipse(at, kSquare, kSquare);
  };
  if (corners.next) edge_to(*corners.next, corners.fault ? theme.danger : theme.accent);
  if (corners.refused) edge_to(*corners.refused, theme.danger);
  painter.setPen(QPen(theme.accent, kOutline));
  painter.setBrush(theme.panel);
  for (const QPointF& at : line) painter.drawEllipse(at, kSquare, kSquare);
}

void paint_head(QPainter& painter, const QLineF& arrow, const QColor& color) {
  const QPointF along = (arrow.p2() - arrow.p1()) / arrow.length();
  const QPointF across(-along.y(), along.x());
  const QPointF base = arrow.p2() - kHeadLength * along;
  const QPointF head[] = {arrow.p2(), base + kHeadHalfWidth * across, base - kHeadHalfWidth * across};
  painter.setPen(Qt::NoPen);
  painter.setBrush(color);
  painter.drawConvexPolygon(head, 3);
}

// A line with its ends, an arrow, or a ring where both ends are at one place.
void paint_link(QPainter& painter, const Overlay::Link& link, const Camera& camera, const Theme& theme) {
  const QColor color = link.fault ? theme.danger : theme.accent;
  const QLineF line(camera.to_screen(link.from), camera.to_screen(link.to));
  painter.setBrush(Qt::NoBrush);
  if (link.was) {
    painter.setPen(dashed(theme.muted));
    return painter.drawLine(line);
  }
  painter.setPen(link.chosen ? QPen(color, kChosen, Qt::SolidLine, Qt::RoundCap) : dashed(color));
  if (line.length() > 0.0) painter.drawLine(line);
  if (link.arrow) {
    if (line.length() > 0.0) paint_head(painter, line, color);
    painter.setPen(QPen(color, kOutline));
    painter.setBrush(Qt::NoBrush);
    if (link.chosen) painter.drawEllipse(line.p2(), kGrip, kGrip);
    return;
  }
  painter.setPen(QPen(color, kOutline));
  painter.setBrush(theme.panel);
  for (const QPointF& end : {line.p1(), line.p2()}) painter.drawEllipse(end, kKnob, kKnob);
}

void paint_outline(QPainter& painter, const Body& body, const Camera& camera, const Theme& theme) {
  const QPainterPath path = body_path(body, camera);
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(faint(theme.accent, 0.3F), kHalo, Qt::SolidLine, Qt::FlatCap, Qt::RoundJoin));
  painter.drawPath(path);
  painter.setPen(QPen(theme.accent, kOutline, Qt::SolidLine, Qt::FlatCap, Qt::RoundJoin));
  painter.drawPath(path);
}

// On the rim, below at the right; a half-plane's at its point.
void paint_padlock(QPainter& painter, const Body& body, const Camera& camera, const Theme& theme) {
  constexpr double kOnRim = 0.7071;
  const Vec2 half = half_extent(body.shape, body.angle);
  const Vec2 corner = half.allFinite() ? Vec2(kOnRim * half.x(), -kOnRim * half.y()) : Vec2(Vec2::Zero());
  painter.save();
  painter.translate(camera.to_screen(body.position + corner));
  painter.setPen(QPen(theme.text, 1.6));
  painter.setBrush(theme.panel);
  painter.drawArc(QRectF(-3.0, -7.0, 6.0, 8.0), 0, 16 * 180);
  painter.drawRoundedRect(QRectF(-5.0, -3.0, 10.0, 8.0), 1.5, 1.5);
  painter.drawLine(QPointF(0.0, 0.0), QPointF(0.0, 2.0));
  painter.restore();
}

// Along the rim from its tail to its grip.
void paint_arc(QPainter& painter, const Handle::Arc& arc, const Theme& theme) {
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(theme.accent, 2.5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.drawPolyline(arc.way);
}

void paint_handle(QPainter& painter, const Handle& handle, const Theme& theme) {
  if (handle.arc) paint_arc(painter, *handle.arc, theme);
  if (handle.foot) {
    QPen stem(theme.accent, 1.5, handle.kind == HandleKind::kVelocity ? Qt::DotLine : Qt::SolidLine);
    painter.setPen(stem);
    painter.drawLine(*handle.foot, handle.at);
  }
  painter.setPen(QPen(theme.accent, 2.0));
  painter.setBrush(theme.panel);
  switch (handle.kind) {
    case HandleKind::kVelocity:
      // A ring leaves the arrow's head visible; a grip without an arrow is filled.
      if (!handle.foot) painter.setBrush(Qt::NoBrush);
      painter.drawEllipse(handle.at, kGrip, kGrip);
      break;
    case HandleKind::kSpin:
      painter.drawEllipse(handle.at, kSquare, kSquare);
      break;
    case HandleKind::kTurn:
      painter.drawEllipse(handle.at, kKnob, kKnob);
      painter.setPen(QPen(theme.accent, 1.2));
      painter.drawArc(QRectF(handle.at - QPointF(2.5, 2.5), QSizeF(5.0, 5.0)), 16 * 60, 16 * 270);
      break;
    default:
      painter.drawRoundedRect(QRectF(handle.at - QPointF(kSquare, kSquare), QSizeF(2 * kSquare, 2 * kSquare)),
                              1.5, 1.5);
  }
}

// What a body covers of the view.
QPainterPath area_path(const Body& body, const Camera& camera) {
  const Outline outline = outline_of(body.shape);
  if (outline.half_plane) {
    const double reach = (camera.visible().upper - camera.visible().lower).norm();
    const Vec2 along = turned_by(body.angle, Vec2::UnitX());
    const Vec2 top = body.position + along.dot(camera.center - body.position) * along;
    QPolygonF ground;
    for (const Vec2& corner :
         {Vec2(-reach, 0.0), Vec2(reach, 0.0), Vec2(reach, -2 * reach), Vec2(-reach, -2 * reach)}) {
      ground.append(camera.to_screen(top + turned_by(body.angle, corner)));
    }
    QPainterPath path;
    path.addPolygon(ground);
    path.closeSubpath();
    return path;
  }
  const QPainterPath path = body_path(body, camera);
  if (area(body.shape) > 0.0) return path;
  QPainterPathStroker stroker;
  stroker.setWidth(kThinWall);
  return stroker.createStroke(path);
}

void paint_overlap(QPainter& painter, const Overlap& overlap, const Camera& camera, const Theme& theme) {
  const QPainterPath shared = area_path(overlap.body, camera).intersected(area_path(overlap.other, camera));
  painter.setPen(QPen(theme.danger, 1.5));
  painter.setBrush(faint(theme.danger, 0.2F));
  painter.drawPath(shared);
  painter.setBrush(QBrush(theme.danger, Qt::BDiagPattern));
  painter.drawPath(shared);
}

// A triangle with a mark of exclamation.
void paint_sign(QPainter& painter, const QPointF& middle, const Theme& theme) {
  const QPointF corners[] = {middle + QPointF(0.0, -kSign), middle + QPointF(kSign, 0.8 * kSign),
                             middle + QPointF(-kSign, 0.8 * kSign)};
  painter.setPen(QPen(theme.danger, 1.8, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.setBrush(theme.panel);
  painter.drawConvexPolygon(corners, 3);
  painter.drawLine(middle + QPointF(0.0, -3.0), middle + QPointF(0.0, 1.5));
  painter.drawPoint(middle + QPointF(0.0, 4.6));
}

}  // namespace

bool on_sign(const QPointF& middle, const QPointF& mouse) { return QLineF(middle, mouse).length() <= kSign; }

QRectF text_place(const Aim& aim, const Camera& camera) {
  constexpr double kAbove = 6.0;  // px, the outlines
  QRectF all;
  for (const Body& body : aim.meeting) {
    if (!body.fixed) all |= body_path(body, camera).boundingRect();
  }
  const QFontMetricsF metrics(aim_font());
  const QSizeF size(metrics.horizontalAdvance(aim_text(aim)) + 1.0, metrics.height());
  return {QPointF(all.center().x() - 0.5 * size.width(), all.top() - kAbove - size.height()), size};
}

void paint_tools(QPainter& painter, const Overlay& overlay, const Camera& camera, const Theme& theme) {
  if (overlay.aim) paint_aim(painter, *overlay.aim, camera, theme);
  painter.setRenderHints(QPainter::Antialiasing | QPainter::TextAntialiasing);
  for (const Overlay::Ghost& ghost : overlay.ghosts) paint_ghost(painter, overlay, ghost, camera, theme);
  if (overlay.direction) paint_direction(painter, *overlay.direction, theme);
  for (const auto& [from, to] : overlay.guides) paint_guide(painter, from, to, camera, theme);
  for (const Body& body : overlay.selected) paint_outline(painter, body, camera, theme);
  for (const Body& body : overlay.lit) paint_outline(painter, body, camera, theme);
  for (const Overlay::Link& link : overlay.links) paint_link(painter, link, camera, theme);
  if (overlay.drawn) {
    painter.setPen(QPen(theme.accent, kOutline));
    painter.setBrush(faint(theme.accent, 0.15F));
    painter.drawPath(body_path(*overlay.drawn, camera));
  }
  paint_corners(painter, overlay.corners, camera, theme);
  for (const Overlap& overlap : overlay.overlaps) paint_overlap(painter, overlap, camera, theme);
  painter.setPen(QPen(theme.danger, kBlocked, Qt::SolidLine, Qt::RoundCap));
  if (overlay.blocked)
    painter.drawLine(camera.to_screen(overlay.blocked->first), camera.to_screen(overlay.blocked->second));
  for (const auto& [from, to] : overlay.refused) painter.drawLine(camera.to_screen(from), camera.to_screen(to));
  for (const Vec2& at : overlay.signs) paint_sign(painter, camera.to_screen(at), theme);
  for (const Body& body : overlay.locked) paint_padlock(painter, body, camera, theme);
  for (const Handle& handle : overlay.handles) paint_handle(painter, handle, theme);
  if (overlay.band) {
    painter.setPen(QPen(theme.accent, 1.0, Qt::DashLine));
    painter.setBrush(faint(theme.accent, 0.1F));
    painter.drawRect(*overlay.band);
  }
  if (!overlay.bubble.value.isEmpty()) paint_bubble(painter, overlay.bubble, camera.viewport, theme);
}

}  // namespace carom
