#include "widgets/scene/drag.h"

#include <Eigen/Geometry>
#include <QStringList>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <variant>

#include "physics/math/vectors.h"
#include "widgets/scene/corner_drag.h"
#include "widgets/scene/edit_names.h"
#include "widgets/scene/level.h"
#include "widgets/scene/snap.h"

namespace carom {
namespace {

constexpr double kSpinStep = 0.5;  // rad/s
constexpr double kTurnStep = 5.0;  // degrees
constexpr double kLargeTurnStep = 45.0;
constexpr double kLengthStep = 0.01;  // m
constexpr double kFactorStep = 0.05;  // of the size of a compound
constexpr double kAtRest = 12.0;      // px from the centre: a velocity drawn from inside the body becomes 0

bool shift(const DragPoint& point) { return point.keys.testFlag(Qt::ShiftModifier); }

// Each by itself: to the centres and corners of others, else to the grid. The one across the axis stays.
void snap_coordinates(const DragStart& start, const std::optional<Vec2>& axis, double reach, Vec2& place,
                      Dragged& out) {
  const Vec2 from = place;
  std::vector<std::pair<Eigen::Index, Level>> levels;
  for (const Eigen::Index k : {0, 1}) {
    if (axis && (*axis)[k] == 0.0) continue;
    if (const auto level = level_with(from, k, start.others, start.seen, reach)) {
      place[k] = level->at[k];
      levels.emplace_back(k, *level);
    } else if (start.grid > 0.0) {
      place[k] = on_grid(place[k], start.grid, reach);
    }
  }
  QStringList texts;
  for (const auto& [k, level] : levels) {
    out.guides.emplace_back(place, level.at);
    texts.push_back(QString::fromStdString(level_text(place, k, level)));
  }
  const bool one = levels.size() == 2 && levels[0].second.at == levels[1].second.at;
  const QString of = one ? QString::fromStdString(levels[0].second.of) : QString();
  out.detail = one && levels[0].second.corner ? "on a corner of " + of
               : one                          ? "on the centre of " + of
                                              : texts.join(", ");
}

Dragged move(const DragStart& start, const DragPoint& point) {
  Body grabbed = start.bodies[0];
  Vec2 delta = point.at - start.press;
  std::optional<Vec2> axis;
  if (shift(point)) {
    axis = std::abs(delta.x()) >= std::abs(delta.y()) ? Vec2(Vec2::UnitX()) : Vec2(Vec2::UnitY());
    delta = axis->dot(delta) * *axis;
  }
  grabbed.position += delta;
  Dragged out;
  if (snaps(point)) {
    const double reach = kSnapReach / point.scale;
    if (const auto touch = touching_place(grabbed, start.others, reach, axis)) {
      grabbed.position = touch->position;
      out.detail = "touches " + QString::fromStdString(touch->with);
    } else {
      snap_coordinates(start, axis, reach, grabbed.position, out);
    }
  }
  const Vec2 moved = grabbed.position - start.bodies[0].position;
  out.bodies = start.bodies;
  for (Body& body : out.bodies) body.position += moved;
  out.bodies[0].position = grabbed.position;
  out.value = place_text(grabbed.position, point.scale);
  if (out.detail.isEmpty()) out.detail = with_former({}, place_text(start.bodies[0].position, point.scale));
  out.name = "Move " + name_of_bodies(start.bodies);
  return out;
}

// Whether the mouse went back into the body, which stops it. Long arrows can end inside a large body: then only
// its middle counts.
bool into_body(const DragStart& start, const DragPoint& point) {
  const Body& body = start.bodies[0];
  const auto inside = [&](const Vec2& at) {
    return signed_distance(body.shape, Eigen::Rotation2Dd(-body.angle) * (at - body.position)) <= 0.0;
  };
  if (inside(start.press)) return (point.at - body.position).norm() * point.scale <= kAtRest;
  return inside(point.at);
}

Dragged pull_velocity(const DragStart& start, const DragPoint& point) {
  const Vec2 before = start.bodies[0].velocity;
  const double step = step_for_mouse(kSpeedStep, start.arrow_seconds * point.scale);
  Vec2 v = before + (point.at - start.press) / start.arrow_seconds;
  if (into_body(start, point)) {
    v.setZero();
  } else if (shift(point)) {
    const Vec2 along = before.norm() > 0.0 ? Vec2(before.normalized()) : Vec2(Vec2::UnitX());
    const double speed = std::max(0.0, along.dot(v));
    v = (!snaps(point) ? speed : snapped(speed, step)) * along;
  } else if (snaps(point)) {
    v = snapped(v.norm(), step) * unit_vector(snapped(direction(v), kDirectionStep));
  }
  Dragged out;
  out.bodies = start.bodies;
  for (Body& body : out.bodies) body.velocity += v - before;
  out.bodies[0].velocity = v;
  const int decimals = decimals_of(step) + (!snaps(point) ? 1 : 0);
  out.value = velocity_text(v, decimals, !snaps(point) ? 1 : 0);
  const auto parts = [decimals](const Vec2& w) {
    return QStringLiteral("(%1, %2)").arg(fixed_text(w.x(), decimals + 1), fixed_text(w.y(), decimals + 1));
  };
  out.detail = with_former("v = " + parts(v) + " m/s", parts(before));
  out.name = name_of_velocity(start.bodies, out.bodies);
  return out;
}

Dragged turn(const DragStart& start, const DragPoint& point) {
  const Body& body = start.bodies[0];
  const Vec2 from = start.press - body.position;
  const Vec2 to = point.at - body.position;
  double angle = body.angle + radians(degrees(std::atan2(to.y(), to.x()) - std::atan2(from.y(), from.x())));
  if (snaps(point)) {
    angle = radians(snapped(angle * 180.0 / std::numbers::pi, shift(point) ? kLargeTurnStep : kTurnStep));
  }
  Dragged out;
  out.bodies = start.bodies;
  out.bodies[0].angle = angle;
  out.value = angle_text(angle, !snaps(point) ? 1 : 0);
  out.detail = with_former({}, angle_text(body.angle, !snaps(point) ? 1 : 0));
  out.name = "Turn " + name_of_bodies(start.bodies);
  return out;
}

Dragged spin(const DragStart& start, const DragPoint& point) {
  constexpr double kTurn = 2.0 * std::numbers::pi;
  const double before = start.bodies[0].spin;
  double after = before + point.swept / radians(kArcOfSpin);
  if (snaps(point)) after = shift(point) ? kTurn * std::round(after / kTurn) : snapped(after, kSpinStep);
  Dragged out;
  out.bodies = start.bodies;
  out.bodies[0].spin = after;
  out.value = spin_text(after);
  out.detail = with_former(turns_text(after), spin_text(before));
  out.name = name_of_spin(start.bodies[0], out.bodies[0]);
  return out;
}

// The handles of a disc are corners of a square, farther from its centre than its rim.
Dragged resize_disc(const DragStart& start, const DragPoint& point, const Disc& disc) {
  const Body& body = start.bodies[0];
  const double outwards =
      ((point.at - body.position).norm() - (start.press - body.position).norm()) / std::numbers::sqrt2;
  const double radius = drawn_length(disc.radius + outwards, point);
  Dragged out;
  out.bodies = {resized(body, Disc{radius}, start.keeps)};
  out.value = size_text(out.bodies[0].shape, point);
  return out;
}

// The far end stays.
Dragged resize_wall(const DragStart& start, const DragPoint& point, double before) {
  const Body& body = start.bodies[0];
  const Vec2 outwards = turned_by(body.angle, side_of(start.kind));
  const double length = drawn_length(before + outwards.dot(point.at - start.press), point);
  Dragged out;
  out.bodies = {resized(body, Wall{length}, start.keeps)};
  out.bodies[0].position += 0.5 * (length - before) * outwards;
  out.value = size_text(out.bodies[0].shape, point);
  return out;
}

// The far side stays, or the far corner. With Shift the larger change of a corner leads.
Dragged resize_box(const DragStart& start, const DragPoint& point, const Box& box) {
  const Body& body = start.bodies[0];
  const Vec2 side = side_of(start.kind);
  const Eigen::Rotation2Dd turned(body.angle);
  const Vec2 pulled = side.cwiseProduct(turned.inverse() * (point.at - start.press));
  const Vec2 before(box.width, box.height);
  Vec2 size = before;
  for (const Eigen::Index k : {0, 1}) {
    if (side[k] != 0.0) size[k] = drawn_length(before[k] + pulled[k], point);
  }
  if (shift(point)) {
    const Vec2 grown = size.cwiseQuotient(before);
    const Eigen::Index lead = std::abs(std::log(grown.x())) >= std::abs(std::log(grown.y())) ? 0 : 1;
    size[1 - lead] = before[1 - lead] * grown[lead];
  }
  Dragged out;
  out.bodies = {resized(body, Box{size.x(), size.y()}, start.keeps)};
  out.bodies[0].position += turned * (0.5 * side.cwiseProduct(size - before));
  out.value = size_text(out.bodies[0].shape, point);
  return out;
}

// All of it, about its centre of mass.
Dragged resize_compound(const DragStart& start, const DragPoint& point) {
  const Body& body = start.bodies[0];
  const double factor = (point.at - body.position).norm() / (start.press - body.position).norm();
  Dragged out;
  const double allowed = std::max(snaps(point) ? snapped(factor, kFactorStep) : factor, kFactorStep);
  out.bodies = {resized(body, scaled(body.shape, allowed), start.keeps)};
  out.value = size_text(out.bodies[0].shape, point);
  return out;
}

// m: to which the mouse can aim.
double drawn_step(const DragPoint& point) {
  return step_for_mouse(kLengthStep, point.scale) / (!snaps(point) ? 10.0 : 1.0);
}

QString former_size(const Shape& shape, const DragPoint& point) {
  const auto* disc = std::get_if<Disc>(&shape);
  return disc != nullptr ? drawn_text(disc->radius, point) : size_text(shape, point);
}

Dragged resize(const DragStart& start, const DragPoint& point) {
  Dragged out;
  const Body& body = start.bodies[0];
  if (const auto* disc = std::get_if<Disc>(&body.shape)) {
    out = resize_disc(start, point, *disc);
  } else if (const auto* box = std::get_if<Box>(&body.shape)) {
    out = resize_box(start, point, *box);
  } else if (std::holds_alternative<Compound>(body.shape)) {
    out = resize_compound(start, point);
  } else if (const auto* wall = std::get_if<Wall>(&body.shape)) {
    out = resize_wall(start, point, wall->length.value_or(0.0));
  } else {
    out.bodies = start.bodies;
  }
  if (!has_infinite_mass(body)) out.detail = QStringLiteral("m = %1 kg").arg(mass_of(out.bodies[0]), 0, 'g', 3);
  out.detail = with_former(out.detail, former_size(body.shape, point));
  out.name = "Resize " + name_of_bodies(start.bodies);
  return out;
}

}  // namespace

Dragged drag_to(const DragStart& start, const DragPoint& point) {
  switch (start.kind) {
    case HandleKind::kBody:
      return move(start, point);
    case HandleKind::kVelocity:
      return pull_velocity(start, point);
    case HandleKind::kTurn:
      return turn(start, point);
    case HandleKind::kSpin:
      return spin(start, point);
    case HandleKind::kCorner:
      return drag_corner(start, point);
    default:
      return resize(start, point);
  }
}

double drawn_length(double length, const DragPoint& point) {
  if (!snaps(point)) return std::max(length, 1.0 / point.scale);
  const double step = step_for_mouse(kLengthStep, point.scale);
  return std::max(snapped(length, step), step);
}

Vec2 drawn_place(const Vec2& at, const DragPoint& point, double grid) {
  if (!snaps(point)) return at;
  const double step = step_for_mouse(kLengthStep, point.scale);
  Vec2 place = at;
  for (double& c : place) {
    const double line = grid > 0.0 ? on_grid(c, grid, kSnapReach / point.scale) : c;
    c = line == c ? snapped(c, step) : line;
  }
  return place;
}

QString size_text(const Shape& shape, const DragPoint& point) {
  if (const auto* disc = std::get_if<Disc>(&shape)) return "r " + drawn_text(disc->radius, point);
  if (const auto* wall = std::get_if<Wall>(&shape)) return drawn_text(wall->length.value_or(0.0), point);
  const Vec2 size = 2.0 * half_extent(shape, 0.0);
  return drawn_text(size.x(), point) + " × " + drawn_text(size.y(), point);
}

QString drawn_text(double length, const DragPoint& point) {
  return fixed_text(length, decimals_of(drawn_step(point))) + " m";
}

QString small_length_text(double length, const DragPoint& point) {
  if (length >= 1.0) return drawn_text(length, point);
  return fixed_text(100.0 * length, decimals_of(100.0 * drawn_step(point))) + " cm";
}

}  // namespace carom
