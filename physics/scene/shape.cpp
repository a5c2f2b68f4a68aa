#include "physics/scene/shape.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "physics/scene/polygon.h"

namespace carom {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

template <class... Ts>
struct Overloaded : Ts... {
  using Ts::operator()...;
};
template <class... Ts>
Overloaded(Ts...) -> Overloaded<Ts...>;

Vec2 turned(const Vec2& v) { return {-v.y(), v.x()}; }

}  // namespace

Outline outline_of(const Shape& shape) {
  return std::visit(
      Overloaded{
          [](const Disc& d) {
            return Outline{{Vec2::Zero()}, d.radius, false};
          },
          [](const Box& b) {
            const Vec2 half(0.5 * b.width, 0.5 * b.height);
            return Outline{{-half, Vec2(half.x(), -half.y()), half, Vec2(-half.x(), half.y())}, 0.0, false};
          },
          [](const Polygon& p) {
            std::vector<Vec2> vertices = tidied(p.vertices);
            const Vec2 centroid = moments_of(vertices, p.rounding).centroid;
            for (Vec2& v : vertices) v -= centroid;
            return Outline{std::move(vertices), p.rounding, false};
          },
          [](const Wall& w) {
            if (!w.length) return Outline{{}, 0.0, true};
            return Outline{{Vec2(-0.5 * *w.length, 0.0), Vec2(0.5 * *w.length, 0.0)}, 0.0, false};
          }},
      shape);
}

double area(const Shape& shape) {
  return std::visit(Overloaded{[](const Disc& d) { return std::numbers::pi * d.radius * d.radius; },
                               [](const Box& b) { return b.width * b.height; },
                               [](const Polygon& p) { return moments_of(tidied(p.vertices), p.rounding).area; },
                               [](const Wall& w) { return w.length ? 0.0 : kInfinity; }},
                    shape);
}

double bounding_radius(const Shape& shape) {
  if (const auto* disc = std::get_if<Disc>(&shape)) return disc->radius;
  const Outline outline = outline_of(shape);
  if (outline.half_plane) return kInfinity;
  double reach = 0.0;
  for (const Vec2& v : outline.vertices) reach = std::max(reach, v.norm());
  return reach + outline.rounding;
}

double inertia_per_mass(const Shape& shape) {
  return std::visit(Overloaded{[](const Disc& d) { return 0.5 * d.radius * d.radius; },
                               [](const Box& b) { return (b.width * b.width + b.height * b.height) / 12.0; },
                               [](const Polygon& p) {
                                 const PlateMoments m = moments_of(tidied(p.vertices), p.rounding);
                                 return m.second_moment / m.area;
                               },
                               [](const Wall& w) { return w.length ? *w.length * *w.length / 12.0 : 0.0; }},
                    shape);
}

Vec2 half_extent(const Shape& shape, double angle) {
  if (const auto* disc = std::get_if<Disc>(&shape)) return Vec2::Constant(disc->radius);
  const Outline outline = outline_of(shape);
  if (outline.half_plane) return Vec2::Constant(kInfinity);
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  Vec2 reach = Vec2::Zero();
  for (const Vec2& v : outline.vertices)
    reach = reach.cwiseMax(Vec2(c * v.x() - s * v.y(), s * v.x() + c * v.y()).cwiseAbs());
  return reach + Vec2::Constant(outline.rounding);
}

double signed_distance(const Outline& outline, const Vec2& point) {
  if (outline.half_plane) return point.y();
  double nearest = kInfinity;
  double outside = -kInfinity;  // largest distance beyond an edge, times its length; <= 0 inside
  const std::size_t count = outline.vertices.size();
  for (std::size_t k = 0; k < count; ++k) {
    const Vec2& a = outline.vertices[k];
    const Vec2 edge = outline.vertices[(k + 1) % count] - a;
    const double length2 = edge.squaredNorm();
    const double along = length2 > 0.0 ? std::clamp((point - a).dot(edge) / length2, 0.0, 1.0) : 0.0;
    nearest = std::min(nearest, (point - a - along * edge).norm());
    if (length2 > 0.0) outside = std::max(outside, -(point - a).dot(turned(edge)));
  }
  const bool inside = count > 2 && outside <= 0.0;
  return (inside ? -nearest : nearest) - outline.rounding;
}

std::optional<std::pair<double, double>> chord(const Outline& outline, const Vec2& from, const Vec2& along) {
  double low = kInfinity;
  double high = -kInfinity;
  const auto take = [&](double s) {
    low = std::min(low, s);
    high = std::max(high, s);
  };
  if (outline.half_plane) {
    if (along.y() == 0.0) {
      if (from.y() > 0.0) return std::nullopt;
      return std::pair(-kInfinity, kInfinity);
    }
    const double s = -from.y() / along.y();
    return along.y() > 0.0 ? std::pair(-kInfinity, s) : std::pair(s, kInfinity);
  }
  // The shape is the convex hull of the discs about its vertices and of its edges moved outwards. The first
  // and last intersections of the line with these are the ends of the chord.
  const std::size_t count = outline.vertices.size();
  const double r = outline.rounding;
  for (std::size_t k = 0; k < count; ++k) {
    const Vec2& a = outline.vertices[k];
    const Vec2 d = a - from;
    const double aside = std::abs(turned(along).dot(d));
    if (aside <= r) {
      const double half = std::sqrt((r - aside) * (r + aside));
      take(along.dot(d) - half);
      take(along.dot(d) + half);
    }
    const Vec2 edge = outline.vertices[(k + 1) % count] - a;
    const double length = edge.norm();
    if (!(length > 0.0)) continue;
    const Vec2 out = -turned(edge) / length;
    const double approach = along.dot(out);
    if (approach == 0.0) continue;
    const double s = (d + r * out).dot(out) / approach;
    const double t = (from + s * along - a).dot(edge) / (length * length);
    if (t >= 0.0 && t <= 1.0) take(s);
  }
  if (!(low <= high)) return std::nullopt;
  return std::pair(low, high);
}

}  // namespace carom
