#include "physics/scene/polygon.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <fmt/format.h>
#include <utility>

namespace carom {
namespace {

constexpr double kSame = 1e-9;  // of the extent

Vec2 mean_of(std::span<const Vec2> vertices) {
  Vec2 sum = Vec2::Zero();
  for (const Vec2& v : vertices) sum += v;
  return sum / static_cast<double>(vertices.size());
}

// m: the largest distance from the mean.
double extent_of(std::span<const Vec2> vertices) {
  const Vec2 mean = mean_of(vertices);
  double extent = 0.0;
  for (const Vec2& v : vertices) extent = std::max(extent, (v - mean).norm());
  return extent;
}

double signed_area(std::span<const Vec2> v) {
  double twice = 0.0;
  for (std::size_t k = 1; k + 1 < v.size(); ++k) twice += cross(v[k] - v[0], v[k + 1] - v[0]);
  return 0.5 * twice;
}

// Vertex k lies on the segment between its neighbours, or on one of them.
bool is_spare(std::span<const Vec2> v, std::size_t k, double same) {
  const Vec2& a = v[(k + v.size() - 1) % v.size()];
  const Vec2& b = v[(k + 1) % v.size()];
  if ((v[k] - a).norm() <= same) return true;
  const Vec2 along = b - a;
  if (along.norm() <= same || v.size() < 3) return false;
  const double t = (v[k] - a).dot(along) / along.squaredNorm();
  return t > 0.0 && t < 1.0 && std::abs(cross(along, v[k] - a)) <= same * along.norm();
}

std::size_t before(std::size_t k, std::size_t count) { return (k + count - 1) % count; }

// How far b turns left of the way from a on to c; as an area, positive at a convex corner.
double turn_at(const Vec2& a, const Vec2& b, const Vec2& c) { return cross(b - a, c - b); }

std::optional<Vec2> reentrant_corner(std::span<const Vec2> v) {
  for (std::size_t k = 0; k < v.size(); ++k) {
    if (!(turn_at(v[before(k, v.size())], v[k], v[(k + 1) % v.size()]) > 0.0)) return v[k];
  }
  return std::nullopt;
}

// Whether the edges from a to b and from c to d, which are no neighbours, have a point in common.
bool meet(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  const auto side = [](const Vec2& p, const Vec2& q, const Vec2& r) { return cross(q - p, r - p); };
  const auto is_on = [](const Vec2& p, const Vec2& q, const Vec2& r) { return (r - p).dot(r - q) <= 0.0; };
  const double of_c = side(a, b, c);
  const double of_d = side(a, b, d);
  const double of_a = side(c, d, a);
  const double of_b = side(c, d, b);
  if (of_c * of_d < 0.0 && of_a * of_b < 0.0) return true;
  return (of_c == 0.0 && is_on(a, b, c)) || (of_d == 0.0 && is_on(a, b, d)) ||
         (of_a == 0.0 && is_on(c, d, a)) || (of_b == 0.0 && is_on(c, d, b));
}

// Whether the way from a to b goes straight back to c.
bool goes_back(const Vec2& a, const Vec2& b, const Vec2& c) {
  return turn_at(a, b, c) == 0.0 && (b - a).dot(c - b) < 0.0;
}

// Whether two of its edges share more than the corner between them.
bool crosses_itself(std::span<const Vec2> v) {
  const std::size_t n = v.size();
  for (std::size_t i = 0; i < n; ++i) {
    if (goes_back(v[before(i, n)], v[i], v[(i + 1) % n])) return true;
    for (std::size_t k = i + 2; k < n; ++k) {
      const bool next = i == 0 && k == n - 1;
      if (!next && meet(v[i], v[i + 1], v[k], v[(k + 1) % n])) return true;
    }
  }
  return false;
}

// Corners of the polygon, by number.
using Piece = std::vector<std::size_t>;

// Relative to the edges beside it: a corner that turns by less is straight.
constexpr double kStraight = 1e-12;

bool is_convex_at(const std::vector<Vec2>& v, std::size_t a, std::size_t b, std::size_t c) {
  return turn_at(v[a], v[b], v[c]) >= -kStraight * (v[b] - v[a]).norm() * (v[c] - v[b]).norm();
}

// Whether the triangle at corner k of what is left is inside, and no other corner is inside it.
bool is_ear(const std::vector<Vec2>& v, const Piece& left, std::size_t k) {
  const std::size_t n = left.size();
  const Vec2& a = v[left[before(k, n)]];
  const Vec2& b = v[left[k]];
  const Vec2& c = v[left[(k + 1) % n]];
  if (!(turn_at(a, b, c) > 0.0)) return false;
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2& p = v[left[i]];
    if (i == k || i == before(k, n) || i == (k + 1) % n || p == a || p == b || p == c) continue;
    if (cross(b - a, p - a) >= 0.0 && cross(c - b, p - b) >= 0.0 && cross(a - c, p - c) >= 0.0) return false;
  }
  return true;
}

std::vector<Piece> triangles_of(const std::vector<Vec2>& v) {
  Piece left(v.size());
  for (std::size_t k = 0; k < left.size(); ++k) left[k] = k;
  std::vector<Piece> triangles;
  while (left.size() > 3) {
    // Rounding may leave no ear: then the corner that turns most.
    std::size_t ear = 0;
    double most = -1.0;
    bool found = false;
    for (std::size_t k = 0; k < left.size() && !found; ++k) {
      const std::size_t n = left.size();
      const double turn = turn_at(v[left[before(k, n)]], v[left[k]], v[left[(k + 1) % n]]);
      found = is_ear(v, left, k);
      if (found || turn > most) ear = k, most = turn;
    }
    const std::size_t n = left.size();
    triangles.push_back({left[before(ear, n)], left[ear], left[(ear + 1) % n]});
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(ear));
  }
  triangles.push_back(left);
  return triangles;
}

// Both as one, if they share an edge and are convex together.
std::optional<Piece> joined(const std::vector<Vec2>& v, const Piece& p, const Piece& q) {
  for (std::size_t i = 0; i < p.size(); ++i) {
    const std::size_t from = p[i];
    const std::size_t to = p[(i + 1) % p.size()];
    const auto at = std::find(q.begin(), q.end(), to);
    if (at == q.end()) continue;
    const auto j = static_cast<std::size_t>(at - q.begin());
    if (q[(j + 1) % q.size()] != from) continue;
    // From `to` all around p to `from`, then around q.
    Piece all;
    for (std::size_t k = 1; k <= p.size(); ++k) all.push_back(p[(i + k) % p.size()]);
    for (std::size_t k = 2; k < q.size(); ++k) all.push_back(q[(j + k) % q.size()]);
    if (static_cast<int>(all.size()) > kMostVertices) return std::nullopt;
    for (std::size_t k = 0; k < all.size(); ++k) {
      if (!is_convex_at(v, all[before(k, all.size())], all[k], all[(k + 1) % all.size()])) return std::nullopt;
    }
    return all;
  }
  return std::nullopt;
}

}  // namespace

std::vector<Vec2> tidied(std::span<const Vec2> vertices) {
  std::vector<Vec2> v(vertices.begin(), vertices.end());
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

std::optional<std::string> fault_of(std::span<const Vec2> vertices, double rounding) {
  constexpr const char* kAllowed =
      "the corners of a polygon in order, convex if it is rounded; or two points and a \"rounding\", a capsule";
  if (static_cast<int>(vertices.size()) > kMostPolygonPoints)
    return fmt::format("{} vertices are not allowed; allowed: at most {}", vertices.size(), kMostPolygonPoints);
  const std::vector<Vec2> v = tidied(vertices);
  if (v.size() < 2 || (v.size() == 2 && !(rounding > 0.0)))
    return fmt::format("{} point{} without an area between them {} not allowed; allowed: {}", v.size(),
                       v.size() == 1 ? "" : "s", v.size() == 1 ? "is" : "are", kAllowed);
  if (v.size() == 2) return std::nullopt;
  if (crosses_itself(v)) return fmt::format("edges that cross are not allowed; allowed: {}", kAllowed);
  if (const auto corner = reentrant_corner(v)) {
    if (rounding == 0.0) return std::nullopt;
    return fmt::format("a reentrant corner at [{}, {}] of a rounded polygon is not allowed; allowed: {}",
                       corner->x(), corner->y(), kAllowed);
  }
  if (static_cast<int>(v.size()) > kMostVertices)
    return fmt::format("{} corners of a convex polygon are not allowed; allowed: at most {}", v.size(),
                       kMostVertices);
  return std::nullopt;
}

bool crosses(std::span<const Vec2> chain, const Vec2& next) {
  const std::size_t n = chain.size();
  if (n > 1 && goes_back(chain[n - 2], chain[n - 1], next)) return true;
  for (std::size_t k = 0; k + 2 < n; ++k) {
    if (meet(chain[k], chain[k + 1], chain[n - 1], next)) return true;
  }
  return false;
}

PlateMoments moments_of(std::span<const Vec2> vertices, double rounding) {
  // About the mean of the vertices, where the terms are small.
  const Vec2 origin = mean_of(vertices);
  const double r = rounding;
  double area = 0.0;
  Vec2 first = Vec2::Zero();
  double second = 0.0;
  const std::size_t count = vertices.size();
  const auto outward = [&](std::size_t k) -> Vec2 {  // of the edge from vertex k
    const Vec2 edge = vertices[(k + 1) % count] - vertices[k % count];
    return Vec2(edge.y(), -edge.x()) / edge.norm();
  };
  for (std::size_t k = 0; k < count; ++k) {
    const Vec2 a = vertices[k] - origin;
    const Vec2 b = vertices[(k + 1) % count] - origin;
    // The triangle from the origin.
    const double twice = cross(a, b);
    area += 0.5 * twice;
    first += twice / 6.0 * (a + b);
    second += twice / 12.0 * (a.squaredNorm() + a.dot(b) + b.squaredNorm());
    // The rectangle on the edge.
    const Vec2 n = outward(k);
    const double length = (b - a).norm();
    const Vec2 middle = 0.5 * (a + b) + 0.5 * r * n;
    area += length * r;
    first += length * r * middle;
    second += length * r * (middle.squaredNorm() + (length * length + r * r) / 12.0);
    // The sector about b, from this edge's normal n to the next one's m.
    const Vec2 m = outward(k + 1);
    const double angle = std::atan2(std::abs(cross(n, m)), n.dot(m));
    const Vec2 bulge = r * r * r / 3.0 * Vec2(m.y() - n.y(), n.x() - m.x());
    area += 0.5 * angle * r * r;
    first += 0.5 * angle * r * r * b + bulge;
    second += 0.5 * angle * r * r * b.squaredNorm() + 2.0 * b.dot(bulge) + 0.25 * angle * r * r * r * r;
  }
  const Vec2 centroid = first / area;
  return {area, origin + centroid, second - area * centroid.squaredNorm()};
}

std::vector<Vec2> convex_hull(std::vector<Vec2> points) {
  std::sort(points.begin(), points.end(),
            [](const Vec2& a, const Vec2& b) { return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y(); });
  // Andrew's monotone chain.
  std::vector<Vec2> hull;
  for (int pass = 0; pass < 2; ++pass) {
    const std::size_t first = hull.size();
    for (const Vec2& point : points) {
      while (hull.size() >= first + 2 && cross(hull.back() - hull[hull.size() - 2], point - hull.back()) <= 0.0)
        hull.pop_back();
      hull.push_back(point);
    }
    hull.pop_back();  // begins the other chain
    std::reverse(points.begin(), points.end());
  }
  return hull;
}

std::vector<std::vector<Vec2>> convex_pieces(const std::vector<Vec2>& vertices) {
  if (vertices.size() < 3 || !reentrant_corner(vertices)) return {vertices};
  std::vector<Piece> pieces = triangles_of(vertices);
  for (bool again = true; std::exchange(again, false);) {
    for (std::size_t i = 0; i < pieces.size() && !again; ++i) {
      for (std::size_t k = i + 1; k < pieces.size() && !again; ++k) {
        auto both = joined(vertices, pieces[i], pieces[k]);
        if (!both) continue;
        pieces[i] = std::move(*both);
        pieces.erase(pieces.begin() + static_cast<std::ptrdiff_t>(k));
        again = true;
      }
    }
  }
  std::vector<std::vector<Vec2>> out;
  for (const Piece& piece : pieces) {
    std::vector<Vec2> corners;
    for (const std::size_t k : piece) corners.push_back(vertices[k]);
    corners = tidied(corners);
    if (corners.size() > 2) out.push_back(std::move(corners));
  }
  return out;
}

}  // namespace carom
