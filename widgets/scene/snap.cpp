#include "widgets/scene/snap.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>

#include "physics/collision/pair_contact.h"
#include "physics/math/vectors.h"
#include "physics/model/geometry.h"
#include "widgets/scene/grid.h"

namespace carom {
namespace {

constexpr double kLeastSpacing = 1.0;   // px between neighbouring values
constexpr double kLargestSpacing = 16;  // px
constexpr int kIterations = 8;          // of Newton's, to the touching place on an axis
constexpr double kLevel = 1e-9;         // of its length: an edge that falls no more is level
constexpr double kLeastSlope = 0.1;     // of the gap along an axis: flatter ones meet too far away

std::optional<Vec2> place_of_touch(const Body& body, const Body& other, double reach,
                                   const std::optional<Vec2>& axis) {
  if (is_half_plane(body.shape) && is_half_plane(other.shape)) return std::nullopt;
  const double sizes = bounding_radius(body.shape) + bounding_radius(other.shape);
  if ((body.position - other.position).norm() > sizes + reach) return std::nullopt;
  const Geometry shapes = geometry({body, other}, {});
  const auto pose_of = [&shapes](int i, const Body& at) {
    return shapes.pose(BodyIndex{i}, {at.position.x(), at.position.y(), at.angle});
  };
  Pose pose = pose_of(0, body);
  const Pose there = pose_of(1, other);
  Vec2 moved = Vec2::Zero();
  for (int k = 0; k < kIterations; ++k) {
    const Contact contact = contact_between(shapes, BodyIndex{0}, pose, BodyIndex{1}, there);
    const Vec2 along = axis.value_or(-contact.normal);
    const double slope = -contact.normal.dot(along);
    if (std::abs(slope) < kLeastSlope) return std::nullopt;
    const Vec2 step = -contact.gap / slope * along;
    moved += step;
    pose.position += step;
    if (!(moved.norm() <= reach)) return std::nullopt;
  }
  return body.position + moved;
}

// A compound has those of its shapes, also where another one covers them.
std::vector<ConvexPart> boundaries_of(const Shape& shape) {
  if (std::holds_alternative<Compound>(shape)) return convex_parts(shape);
  return {ConvexPart{outline_of(shape)}};
}

// The nearest point of a convex core that is grown by a rounding, or of a polygon's edges.
Vec2 nearest_on_rim(const Outline& outline, const Vec2& place) {
  const std::vector<Vec2>& v = outline.vertices;
  Vec2 nearest = v[0];
  bool inside = v.size() > 2;
  Vec2 out = Vec2::UnitX();
  for (std::size_t i = 0; i < v.size(); ++i) {
    const Vec2 along = v[(i + 1) % v.size()] - v[i];
    const double length = along.squaredNorm();
    const double share = length > 0.0 ? std::clamp(along.dot(place - v[i]) / length, 0.0, 1.0) : 0.0;
    const Vec2 at = v[i] + share * along;
    inside = inside && cross(along, place - v[i]) >= 0.0;
    if (i > 0 && (at - place).squaredNorm() >= (nearest - place).squaredNorm()) continue;
    nearest = at;
    if (length > 0.0) out = -crossed(along).normalized();
  }
  if (outline.rounding == 0.0) return nearest;
  if (!inside && place != nearest) out = (place - nearest).normalized();
  return nearest + outline.rounding * out;
}

}  // namespace

double snapped(double value, double step) {
  const double count = std::round(value / step);
  return step < 1.0 ? count / std::round(1.0 / step) : count * step;
}

double on_grid(double value, double spacing, double reach) {
  const double line = snapped(value, spacing);
  return std::abs(line - value) <= reach ? line : value;
}

double step_for_mouse(double wanted, double pixels) {
  if (wanted * pixels > kLargestSpacing) return step_not_above(kLargestSpacing / pixels);
  if (wanted * pixels < kLeastSpacing) return step_not_below(kLeastSpacing / pixels);
  return wanted;
}

std::optional<Vec2> on_rim(const Shape& shape, const Vec2& place, double reach) {
  if (is_half_plane(shape)) {
    if (std::abs(place.y()) > reach) return std::nullopt;
    return Vec2(place.x(), 0.0);
  }
  std::optional<Vec2> corner;
  std::optional<Vec2> rim;
  const auto take = [&](std::optional<Vec2>& best, const Vec2& at) {
    const double distance = (at - place).norm();
    if (distance <= reach && !(best && (*best - place).norm() <= distance)) best = at;
  };
  for (const ConvexPart& part : boundaries_of(shape)) {
    const std::vector<Vec2>& v = part.outline.vertices;
    if (v.size() > 1 && part.outline.rounding == 0.0) {
      for (const Vec2& vertex : v) take(corner, part.position + vertex);
    }
    take(rim, part.position + nearest_on_rim(part.outline, place - part.position));
  }
  return corner ? corner : rim;
}

Vec2 on_level_edges(const Vec2& place, const Vec2& otherwise, std::span<const Body> bodies, double reach) {
  Vec2 moved = otherwise;
  Vec2 nearest = Vec2::Constant(reach);
  const auto take = [&](const Vec2& from, const Vec2& to) {
    for (const int k : {0, 1}) {
      if (std::abs(to[k] - from[k]) > kLevel * (to - from).norm()) continue;
      const double away = std::abs(from[k] - place[k]);
      const auto [low, high] = std::minmax(from[1 - k], to[1 - k]);
      if (away > nearest[k] || place[1 - k] < low - reach || place[1 - k] > high + reach) continue;
      nearest[k] = away;
      moved[k] = from[k];
    }
  };
  for (const Body& body : bodies) {
    const Eigen::Rotation2Dd turned(body.angle);
    if (is_half_plane(body.shape)) {
      const Vec2 along = turned * Vec2::UnitX();
      const Vec2 beside = body.position + along.dot(place - body.position) * along;
      take(beside - reach * along, beside + reach * along);
      continue;
    }
    if ((body.position - place).norm() > bounding_radius(body.shape) + 2.0 * reach) continue;
    for (const ConvexPart& part : boundaries_of(body.shape)) {
      const std::vector<Vec2>& v = part.outline.vertices;
      for (std::size_t i = 0; v.size() > 1 && i < v.size(); ++i) {
        const Vec2& from = v[i];
        const Vec2& to = v[(i + 1) % v.size()];
        const Vec2 out = -part.outline.rounding * crossed(to - from).normalized();
        const auto placed = [&](const Vec2& at) -> Vec2 {
          return body.position + turned * (part.position + at + out);
        };
        take(placed(from), placed(to));
      }
    }
  }
  return moved;
}

std::optional<Touch> touching_place(const Body& body, std::span<const Body> others, double reach,
                                    const std::optional<Vec2>& axis) {
  std::optional<Touch> best;
  for (const Body& other : others) {
    const std::optional<Vec2> place = place_of_touch(body, other, reach, axis);
    if (!place) continue;
    if (best && (best->position - body.position).norm() <= (*place - body.position).norm()) continue;
    best = Touch{*place, other.name};
  }
  return best;
}

}  // namespace carom
