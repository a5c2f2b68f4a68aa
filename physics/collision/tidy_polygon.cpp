#include "physics/collision/tidy_polygon.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace carom {
namespace {

double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

// A vertex and its place in the given list.
struct Place {
  Vec2 x;
  int index;
};

std::string text(const Place& p) { return fmt::format("vertex {} at ({}, {})", p.index, p.x.x(), p.x.y()); }

TidyPolygon refuse(std::string problem, int vertex = -1) { return {{}, std::move(problem), vertex}; }

const Place& at(const std::vector<Place>& list, std::size_t k) { return list[k % list.size()]; }

// How far a vertex lies to the right of the line from the one before to the one after: positive for a corner of
// a convex counter-clockwise list.
double bulge(const std::vector<Place>& list, std::size_t k) {
  const Vec2& before = at(list, k + list.size() - 1).x;
  const Vec2 chord = at(list, k + 1).x - before;
  const double length = chord.norm();
  if (length == 0.0) return 0.0;
  return cross(at(list, k).x - before, chord) / length;
}

// Whether the path turns back at a vertex: then it is a spike, not a point of a straight edge.
bool turns_back(const std::vector<Place>& list, std::size_t k) {
  const Vec2& x = at(list, k).x;
  return (x - at(list, k + list.size() - 1).x).dot(at(list, k + 1).x - x) <= 0.0;
}

void drop_repeated(std::vector<Place>& list, double tolerance) {
  std::vector<Place> kept;
  for (const Place& p : list) {
    if (kept.empty() || (p.x - kept.back().x).norm() > tolerance) kept.push_back(p);
  }
  while (kept.size() > 1 && (kept.back().x - kept.front().x).norm() <= tolerance) kept.pop_back();
  list = std::move(kept);
}

// The straightest vertex first, so that those that are dropped never add up to a corner.
void drop_collinear(std::vector<Place>& list, double tolerance) {
  while (list.size() > 2) {
    std::size_t straightest = list.size();
    double least = tolerance;
    for (std::size_t k = 0; k < list.size(); ++k) {
      const double off = std::abs(bulge(list, k));
      if (off <= least && !turns_back(list, k)) least = off, straightest = k;
    }
    if (straightest == list.size()) return;
    list.erase(list.begin() + static_cast<std::ptrdiff_t>(straightest));
  }
}

// Whether two edges that don't share a vertex have a point in common.
bool cross_each_other(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  const auto side = [](double v) { return v > 0.0 ? 1 : v < 0.0 ? -1 : 0; };
  const int c_side = side(cross(b - a, c - a));
  const int d_side = side(cross(b - a, d - a));
  const int a_side = side(cross(d - c, a - c));
  const int b_side = side(cross(d - c, b - c));
  if (c_side == 0 && d_side == 0) {
    const Vec2 along = b - a;
    const double length = along.squaredNorm();
    const double first = (c - a).dot(along);
    const double second = (d - a).dot(along);
    return std::max(first, second) >= 0.0 && std::min(first, second) <= length;
  }
  return c_side * d_side <= 0 && a_side * b_side <= 0;
}

}  // namespace

TidyPolygon tidy_polygon(const std::vector<Vec2>& given) {
  std::vector<Place> list;
  Eigen::Array2d low = Eigen::Array2d::Constant(std::numeric_limits<double>::infinity());
  Eigen::Array2d high = -low;
  for (const Vec2& x : given) {
    const int index = static_cast<int>(list.size());
    if (!x.allFinite()) return refuse(fmt::format("vertex {} is not a finite point", index), index);
    list.push_back({x, index});
    low = low.min(x.array());
    high = high.max(x.array());
  }
  if (list.size() < 3) return refuse(fmt::format("a polygon has at least 3 vertices, not {}", list.size()));
  const double size = (high - low).maxCoeff();
  if (!std::isfinite(size)) return refuse("the polygon is too large for its coordinates");
  const double tolerance = kTidyTolerance * size;

  drop_repeated(list, tolerance);
  drop_collinear(list, tolerance);
  const std::size_t n = list.size();
  double area = 0.0;
  for (std::size_t k = 2; k < n; ++k) area += 0.5 * cross(list[k - 1].x - list[0].x, list[k].x - list[0].x);
  if (n < 3 || std::abs(area) <= tolerance * tolerance) {
    // Few points, or all on a line.
    double off = 0.0;
    for (std::size_t k = 0; k < n; ++k) off = std::max(off, std::abs(bulge(list, k)));
    if (n < 3 || off <= tolerance) {
      return refuse(
          "fewer than 3 vertices are left without repeated and collinear ones: the polygon has no area");
    }
  }
  if (n > static_cast<std::size_t>(kMostVertices)) {
    return refuse(fmt::format("{} vertices; at most {} are allowed", n, kMostVertices));
  }

  for (std::size_t k = 0; k < n; ++k) {
    for (std::size_t other = k + 2; other < n; ++other) {
      if (k == 0 && other == n - 1) continue;
      if (cross_each_other(list[k].x, at(list, k + 1).x, list[other].x, at(list, other + 1).x)) {
        return refuse(fmt::format("the polygon crosses itself: the edge from {} meets the one from {}",
                                  text(list[k]), text(list[other])),
                      list[other].index);
      }
    }
  }
  for (std::size_t k = 0; k < n; ++k) {
    const double outwards = area < 0.0 ? -bulge(list, k) : bulge(list, k);
    if (outwards < -tolerance || (outwards <= tolerance && turns_back(list, k))) {
      return refuse(fmt::format("the polygon is not convex: it bends inwards at {}", text(list[k])),
                    list[k].index);
    }
  }
  if (area < 0.0) std::reverse(list.begin() + 1, list.end());
  TidyPolygon tidy;
  for (const Place& p : list) tidy.vertices.push_back(p.x);
  return tidy;
}

}  // namespace carom
