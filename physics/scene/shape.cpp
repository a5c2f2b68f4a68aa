#include "physics/scene/shape.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <numbers>

#include "physics/math/vectors.h"

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

using Eigen::Vector2d;

constexpr double kSame = 1e-9;  // of the extent

Vector2d mean_of(std::span<const Vector2d> vertices) {
  Vector2d sum = Vector2d::Zero();
  for (const Vector2d& v : vertices) sum += v;
  return sum / static_cast<double>(vertices.size());
}

// m: the largest distance from the mean.
double extent_of(std::span<const Vector2d> vertices) {
  const Vector2d mean = mean_of(vertices);
  double extent = 0.0;
  for (const Vector2d& v : vertices) extent = std::max(extent, (v - mean).norm());
  return extent;
}

double signed_area(std::span<const Vector2d> v) {
  double twice = 0.0;
  for (std::size_t k = 1; k + 1 < v.size(); ++k) twice += cross(v[k] - v[0], v[k + 1] - v[0]);
  return 0.5 * twice;
}

// Vertex k lies on the segment between its neighbours, or on one of them.
bool is_spare(std::span<const Vector2d> v, std::size_t k, double same) {
  const Vector2d& a = v[(k + v.size() - 1) % v.size()];
  const Vector2d& b = v[(k + 1) % v.size()];
  if ((v[k] - a).norm() <= same) return true;
  const Vector2d along = b - a;
  if (along.norm() <= same || v.size() < 3) return false;
  const double t = (v[k] - a).dot(along) / along.squaredNorm();
  return t > 0.0 && t < 1.0 && std::abs(cross(along, v[k] - a)) <= same * along.norm();
}

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
  Vec2 reach = Vec2::Zero();
  for (const Vec2& v : outline.vertices) reach = reach.cwiseMax(turned_by(angle, v).cwiseAbs());
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

std::vector<Vector2d> tidied(std::span<const Vector2d> vertices) {
  std::vector<Vector2d> v(vertices.begin(), vertices.end());
  if (v.empty()) return v;
  const double same = kSame * extent_of(v);
  for (bool again = true; again && v.size() > 1;) {
    again = false;
    for (std::size_t k = 0; k < v.size() && v.size() > 1; ++k) {
      if (!is_spare(v, k, same)) continue;
      v.erase(v.begin() + static_cast<std::ptrdiff_t>(k));
      again = true;
      break;
    }
  }
  if (signed_area(v) < 0.0) std::reverse(v.begin() + 1, v.end());
  return v;
}

std::optional<std::string> fault_of(std::span<const Vector2d> vertices, double rounding) {
  constexpr const char* kAllowed =
      "the corners of a convex polygon in order; or two points and a \"rounding\", a capsule";
  if (static_cast<int>(vertices.size()) > kMostPolygonPoints)
    return fmt::format("{} vertices are not allowed; allowed: at most {}", vertices.size(), kMostPolygonPoints);
  const std::vector<Vector2d> v = tidied(vertices);
  if (static_cast<int>(v.size()) > kMostVertices)
    return fmt::format("{} corners are not allowed; allowed: at most {}", v.size(), kMostVertices);
  if (v.size() < 2 || (v.size() == 2 && !(rounding > 0.0)))
    return fmt::format("{} point{} without an area between them {} not allowed; allowed: {}", v.size(),
                       v.size() == 1 ? "" : "s", v.size() == 1 ? "is" : "are", kAllowed);
  if (v.size() == 2) return std::nullopt;
  double turning = 0.0;
  for (std::size_t k = 0; k < v.size(); ++k) {
    const Vector2d in = v[k] - v[(k + v.size() - 1) % v.size()];
    const Vector2d out = v[(k + 1) % v.size()] - v[k];
    if (!(cross(in, out) > 0.0))
      return fmt::format("a reentrant corner at [{}, {}] is not allowed; allowed: {}", v[k].x(), v[k].y(),
                         kAllowed);
    turning += std::atan2(cross(in, out), in.dot(out));
  }
  // Once around is 2π; a star with five corners goes around twice.
  if (turning > 7.0) return fmt::format("edges that cross are not allowed; allowed: {}", kAllowed);
  return std::nullopt;
}

PlateMoments moments_of(std::span<const Vector2d> vertices, double rounding) {
  // About the mean of the vertices, where the terms are small.
  const Vector2d origin = mean_of(vertices);
  const double r = rounding;
  double area = 0.0;
  Vector2d first = Vector2d::Zero();
  double second = 0.0;
  const std::size_t count = vertices.size();
  const auto outward = [&](std::size_t k) -> Vector2d {  // of the edge from vertex k
    const Vector2d edge = vertices[(k + 1) % count] - vertices[k % count];
    return Vector2d(edge.y(), -edge.x()) / edge.norm();
  };
  for (std::size_t k = 0; k < count; ++k) {
    const Vector2d a = vertices[k] - origin;
    const Vector2d b = vertices[(k + 1) % count] - origin;
    // The triangle from the origin.
    const double twice = cross(a, b);
    area += 0.5 * twice;
    first += twice / 6.0 * (a + b);
    second += twice / 12.0 * (a.squaredNorm() + a.dot(b) + b.squaredNorm());
    // The rectangle on the edge.
    const Vector2d n = outward(k);
    const double length = (b - a).norm();
    const Vector2d middle = 0.5 * (a + b) + 0.5 * r * n;
    area += length * r;
    first += length * r * middle;
    second += length * r * (middle.squaredNorm() + (length * length + r * r) / 12.0);
    // The sector about b, from this edge's normal n to the next one's m.
    const Vector2d m = outward(k + 1);
    const double angle = std::atan2(std::abs(cross(n, m)), n.dot(m));
    const Vector2d bulge = r * r * r / 3.0 * Vector2d(m.y() - n.y(), n.x() - m.x());
    area += 0.5 * angle * r * r;
    first += 0.5 * angle * r * r * b + bulge;
    second += 0.5 * angle * r * r * b.squaredNorm() + 2.0 * b.dot(bulge) + 0.25 * angle * r * r * r * r;
  }
  const Vector2d centroid = first / area;
  return {area, origin + centroid, second - area * centroid.squaredNorm()};
}

}  // namespace carom
