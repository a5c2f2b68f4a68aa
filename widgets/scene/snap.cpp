#include "widgets/scene/snap.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>

#include "widgets/scene/grid.h"

namespace carom {
namespace {

constexpr double kLeastSpacing = 1.0;   // px between neighbouring values
constexpr double kLargestSpacing = 16;  // px
constexpr int kIterations = 8;          // of Newton's, to the touching place on an axis
constexpr double kLeastSlope = 0.1;     // of the gap along an axis: flatter ones meet too far away

// The distance of two outlines, negative in an overlap, and the direction that parts them.
struct Gap {
  double size;  // m
  Vec2 away;    // unit vector, in which the first body moves off
};

// From a point to a body's outline; the direction is the gradient of the distance.
Gap gap_to_point(const Body& body, const Vec2& point) {
  const Shape& shape = body.shape;
  const Eigen::Rotation2Dd back(-body.angle);
  const Vec2 at = back * (point - body.position);
  const double h = 1e-6 * std::max(at.norm(), 1e-12);
  const Vec2 slope(signed_distance(shape, at + Vec2(h, 0.0)) - signed_distance(shape, at - Vec2(h, 0.0)),
                   signed_distance(shape, at + Vec2(0.0, h)) - signed_distance(shape, at - Vec2(0.0, h)));
  return {signed_distance(shape, at), back.inverse() * slope.normalized()};
}

std::optional<Gap> gap_of(const Body& body, const Body& other) {
  if (is_half_plane(other.shape) && !is_half_plane(body.shape)) {
    const Vec2 out(-std::sin(other.angle), std::cos(other.angle));
    const Eigen::Rotation2Dd turned(body.angle);
    double lowest = std::numeric_limits<double>::infinity();
    for (const ConvexPart& part : convex_parts(body.shape)) {
      for (const Vec2& v : part.outline.vertices) {
        const Vec2 at = body.position + turned * (part.position + v) - other.position;
        lowest = std::min(lowest, out.dot(at) - part.outline.rounding);
      }
    }
    return Gap{lowest, out};
  }
  const auto* disc = std::get_if<Disc>(&body.shape);
  const auto* post = std::get_if<Disc>(&other.shape);
  if (disc != nullptr && post != nullptr) {
    const Vec2 between = body.position - other.position;
    return Gap{between.norm() - disc->radius - post->radius, between.normalized()};
  }
  if (disc != nullptr) {
    Gap gap = gap_to_point(other, body.position);
    gap.size -= disc->radius;
    return gap;
  }
  if (post != nullptr) {
    Gap gap = gap_to_point(body, other.position);
    return Gap{gap.size - post->radius, -gap.away};
  }
  return std::nullopt;
}

std::optional<Vec2> place_of_touch(Body body, const Body& other, double reach,
                                   const std::optional<Vec2>& axis) {
  const Vec2 from = body.position;
  for (int k = 0; k < kIterations; ++k) {
    const std::optional<Gap> gap = gap_of(body, other);
    if (!gap) return std::nullopt;
    const Vec2 along = axis.value_or(gap->away);
    const double slope = gap->away.dot(along);
    if (std::abs(slope) < kLeastSlope) return std::nullopt;
    body.position -= gap->size / slope * along;
    if (!((body.position - from).norm() <= reach)) return std::nullopt;
  }
  return body.position;
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
