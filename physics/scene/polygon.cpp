#include "physics/scene/polygon.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "physics/math/vectors.h"

namespace carom {
namespace {

using Eigen::Vector2d;

constexpr double kSame = 1e-9;  // relative to the extent

Vector2d mean_of(std::span<const Vector2d> vertices) {
  Vector2d sum = Vector2d::Zero();
  for (const Vector2d& v : vertices) sum += v;
  return sum / static_cast<double>(vertices.size());
}

// Largest distance of a vertex from their mean, in m.
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
