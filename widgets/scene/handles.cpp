#include "widgets/scene/handles.h"

#include <Eigen/Geometry>
#include <QLineF>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <variant>

#include "physics/math/vectors.h"
#include "physics/scene/polygon.h"
#include "widgets/edit/driven.h"
#include "widgets/edit/reshaping.h"

namespace carom {
namespace {

constexpr double kGap = 8.0;         // px from the outline to a handle of the size
constexpr double kStem = 24.0;       // px from there to the knob
constexpr double kStub = 30.0;       // px from the outline to the grip of a short velocity
constexpr double kTail = 240.0;      // degrees, where the arc of a spin begins
constexpr double kToSizes = 11.0;    // px, from the handles of the size to the grip of a spin
constexpr int kHalvings = 24;        // of a distance, to well below a px
constexpr double kArcPiece = 3.0;    // degrees, of the arc of a spin
constexpr double kSteepArrow = 0.8;  // sine of the direction from which on an arrow would cross the knob's stem

// px on the screen, y down.
QPointF on_screen(const Vec2& v) { return {v.x(), -v.y()}; }

void add_velocity(const Body& body, std::size_t index, const Camera& camera, double seconds,
                  std::vector<Handle>& handles) {
  const QPointF centre = camera.to_screen(body.position);
  const double length = body.velocity.norm() * seconds * camera.scale;
  const Vec2 along = body.velocity.norm() > 0.0 ? Vec2(body.velocity.normalized()) : Vec2(Vec2::UnitX());
  if (length >= kLeastHandleDistance) {
    handles.push_back({HandleKind::kVelocity, index, centre + length * on_screen(along), std::nullopt});
    return;
  }
  const auto inside = chord(outline_of(body.shape), Vec2::Zero(), Eigen::Rotation2Dd(-body.angle) * along);
  const double rim = inside ? inside->second * camera.scale : 0.0;
  handles.push_back({HandleKind::kVelocity, index, centre + (rim + kStub) * on_screen(along),
                     centre + std::max(rim, length) * on_screen(along)});
}

// What a spin's arc goes around: no dents.
Outline hull_of(const Shape& shape) {
  Outline outline = outline_of(shape);
  if (outline.vertices.size() > 2) outline.vertices = convex_hull(std::move(outline.vertices));
  return outline;
}

// px from the centre, where the grip of a spin stands at this angle: just outside the rim of a disc; of another
// body along its outline, and of a small one around it, outside the handles of the size.
double spin_distance(const Body& body, const Outline& hull, double angle, const Camera& camera) {
  if (const auto* disc = std::get_if<Disc>(&body.shape)) {
    const double near = disc->radius * camera.scale + kGap;
    const double corner = std::max(std::numbers::sqrt2 * near, kLeastHandleDistance);
    const bool clear = near >= kLeastHandleDistance && corner - near >= kHandleReach;
    return clear ? near : corner + kHandleReach;
  }
  const double out = (std::numbers::sqrt2 * kGap + kToSizes) / camera.scale;
  const Vec2 along = turned_by(angle - body.angle, Vec2::UnitX());
  double low = 0.0;
  double high = bounding_radius(body.shape) + out;
  for (int k = 0; k < kHalvings; ++k) {
    const double middle = 0.5 * (low + high);
    (signed_distance(hull, middle * along) < out ? low : high) = middle;
  }
  return std::max(high * camera.scale, kLeastHandleDistance + kToSizes);
}

void add_spin(const Body& body, const Camera& camera, std::vector<Handle>& handles) {
  if (!(inertia_of(body) > 0.0)) return;
  const QPointF centre = camera.to_screen(body.position);
  const Outline hull = hull_of(body.shape);
  Handle::Arc arc{.tail = kTail, .sweep = std::clamp(body.spin * kArcOfSpin, -kLongestArc, kLongestArc)};
  const int pieces = std::max(1, static_cast<int>(std::ceil(std::abs(arc.sweep) / kArcPiece)));
  for (int k = 0; k <= pieces; ++k) {
    const double angle = (arc.tail + arc.sweep * k / pieces) * std::numbers::pi / 180.0;
    arc.way.append(centre + spin_distance(body, hull, angle, camera) *
                                on_screen(Vec2(std::cos(angle), std::sin(angle))));
  }
  handles.push_back({HandleKind::kSpin, 0, arc.way.last(), std::nullopt, arc});
}

void add_knob(const Body& body, const Camera& camera, bool arrow, double turned, std::vector<Handle>& handles) {
  const QPointF centre = camera.to_screen(body.position);
  const Vec2 half = half_extent(body.shape, body.angle - turned) * camera.scale;
  const double reach = half.allFinite() ? half.y() : 0.0;
  // Below where an arrow points up, or the view ends.
  const bool arrow_up = arrow && body.velocity.y() > kSteepArrow * body.velocity.norm();
  const bool below = arrow_up || centre.y() - reach - kGap - kStem < kHandleReach;
  const QPointF side = (below ? 1.0 : -1.0) * QPointF(std::sin(turned), std::cos(turned));
  handles.push_back({HandleKind::kTurn, 0, centre + (reach + kGap + kStem) * side, centre + reach * side});
}

void add_sizes_of_box(const Body& body, const Box& box, const Camera& camera, std::vector<Handle>& handles) {
  const QPointF centre = camera.to_screen(body.position);
  const Vec2 half = 0.5 * camera.scale * Vec2(box.width, box.height);
  for (const HandleKind kind :
       {HandleKind::kRight, HandleKind::kTop, HandleKind::kLeft, HandleKind::kBottom, HandleKind::kTopRight,
        HandleKind::kTopLeft, HandleKind::kBottomLeft, HandleKind::kBottomRight}) {
    const Vec2 side = side_of(kind);
    const double least = kLeastHandleDistance / side.norm();
    const Vec2 reach = (half.array() + kGap).max(least);
    const Vec2 out = Eigen::Rotation2Dd(body.angle) * side.cwiseProduct(reach);
    handles.push_back({kind, 0, centre + on_screen(out), std::nullopt});
  }
}

void add_ends_of_wall(const Body& body, double length, const Camera& camera, std::vector<Handle>& handles) {
  const QPointF centre = camera.to_screen(body.position);
  const double reach = std::max(0.5 * length * camera.scale + kGap, kLeastHandleDistance);
  for (const HandleKind kind : {HandleKind::kRight, HandleKind::kLeft}) {
    const Vec2 out = Eigen::Rotation2Dd(body.angle) * (reach * side_of(kind));
    handles.push_back({kind, 0, centre + on_screen(out), std::nullopt});
  }
}

void add_corners(const Body& body, const Polygon& polygon, const Camera& camera, std::vector<Handle>& handles) {
  const QPointF centre = camera.to_screen(body.position);
  const Vec2 middle = centre_of(polygon);
  for (std::size_t k = 0; k < polygon.vertices.size(); ++k) {
    const Vec2 out = Eigen::Rotation2Dd(body.angle) * (polygon.vertices[k] - middle);
    const double length = out.norm();
    const Vec2 along = length > 0.0 ? Vec2(out / length) : Vec2(Vec2::UnitX());
    const double distance = std::max((length + polygon.rounding) * camera.scale + kGap, kLeastHandleDistance);
    Handle handle{HandleKind::kCorner, 0, centre + distance * on_screen(along), std::nullopt};
    handle.corner = k;
    handles.push_back(handle);
  }
}

// Of a disc, or of all shapes of a compound.
void add_corners_around(const Body& body, const Camera& camera, std::vector<Handle>& handles) {
  const QPointF centre = camera.to_screen(body.position);
  const double radius = bounding_radius(body.shape) * camera.scale;
  const bool compound = std::holds_alternative<Compound>(body.shape);
  const double half = std::max((compound ? radius / std::numbers::sqrt2 : radius) + kGap,
                               kLeastHandleDistance / std::numbers::sqrt2);
  for (const QPointF corner : {QPointF(1, -1), QPointF(-1, -1), QPointF(-1, 1), QPointF(1, 1)}) {
    handles.push_back({HandleKind::kRadius, 0, centre + half * corner, std::nullopt});
  }
}

void add_sizes(const Body& body, const Camera& camera, std::vector<Handle>& handles) {
  if (std::holds_alternative<Disc>(body.shape) || std::holds_alternative<Compound>(body.shape)) {
    add_corners_around(body, camera, handles);
  } else if (const auto* box = std::get_if<Box>(&body.shape)) {
    add_sizes_of_box(body, *box, camera, handles);
  } else if (const auto* wall = std::get_if<Wall>(&body.shape)) {
    if (wall->length) add_ends_of_wall(body, *wall->length, camera, handles);
  } else if (const auto* polygon = std::get_if<Polygon>(&body.shape)) {
    add_corners(body, *polygon, camera, handles);
  }
}

}  // namespace

Vec2 side_of(HandleKind kind) {
  switch (kind) {
    case HandleKind::kRight:
      return Vec2::UnitX();
    case HandleKind::kTop:
      return Vec2::UnitY();
    case HandleKind::kLeft:
      return -Vec2::UnitX();
    case HandleKind::kBottom:
      return -Vec2::UnitY();
    case HandleKind::kTopRight:
      return {1.0, 1.0};
    case HandleKind::kTopLeft:
      return {-1.0, 1.0};
    case HandleKind::kBottomLeft:
      return {-1.0, -1.0};
    case HandleKind::kBottomRight:
      return {1.0, -1.0};
    default:
      return Vec2::Zero();
  }
}

std::vector<Handle> handles_of(std::span<const Body> bodies, const Camera& camera,
                               std::optional<double> arrow_seconds, double turned) {
  std::vector<Handle> handles;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (arrow_seconds && has_own_velocity(bodies[i])) {
      add_velocity(bodies[i], i, camera, *arrow_seconds, handles);
    }
  }
  if (bodies.size() == 1) {
    const bool arrow = !handles.empty();
    if (arrow && !has_infinite_mass(bodies[0])) add_spin(bodies[0], camera, handles);
    add_knob(bodies[0], camera, arrow, turned, handles);
    add_sizes(bodies[0], camera, handles);
  }
  return handles;
}

std::optional<Handle> handle_at(std::span<const Handle> handles, const QPointF& at) {
  std::optional<Handle> nearest;
  double least = kHandleReach;
  for (const Handle& handle : handles) {
    // An arrow's tip is taken before a handle that lies over it.
    const double favour = handle.kind == HandleKind::kVelocity ? 0.5 * kHandleReach : 0.0;
    const double distance = QLineF(handle.at, at).length();
    if (distance > kHandleReach || distance - favour > least) continue;
    least = distance - favour;
    nearest = handle;
  }
  return nearest;
}

}  // namespace carom
