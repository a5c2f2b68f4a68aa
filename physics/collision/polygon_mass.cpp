#include "physics/collision/polygon_mass.h"

#include <cassert>
#include <cmath>
#include <numbers>

namespace carom {
namespace {

double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

struct Moments {
  double area = 0.0;
  Vec2 first = Vec2::Zero();
  double second = 0.0;

  void add(double part, const Vec2& first_of_part, double second_of_part) {
    area += part;
    first += first_of_part;
    second += second_of_part;
  }
};

Moments moments_about(const Vec2& centre, const std::vector<Vec2>& core, double r) {
  Moments sum;
  const std::size_t n = core.size();
  for (std::size_t k = 0; k < n; ++k) {
    const Vec2 p = core[k] - centre;
    const Vec2 q = core[(k + 1) % n] - centre;
    const double triangle = 0.5 * cross(p, q);
    sum.add(triangle, triangle / 3.0 * (p + q),
            triangle / 6.0 * (p.squaredNorm() + p.dot(q) + q.squaredNorm()));

    if (r == 0.0) continue;
    if (n == 1) {
      const double disc = std::numbers::pi * r * r;
      sum.add(disc, disc * p, disc * (0.5 * r * r + p.squaredNorm()));
      continue;
    }
    const Vec2 after = (q - p).normalized();
    const Vec2 before = (core[k] - core[(k + n - 1) % n]).normalized();
    const double length = (q - p).norm();
    const Vec2 middle = 0.5 * (p + q) + 0.5 * r * Vec2(after.y(), -after.x());
    const double rectangle = length * r;
    sum.add(rectangle, rectangle * middle,
            rectangle * ((length * length + r * r) / 12.0 + middle.squaredNorm()));

    const double angle = n == 2 ? std::numbers::pi : std::atan2(cross(before, after), before.dot(after));
    const double sector = 0.5 * angle * r * r;
    const Vec2 about_vertex = r * r * r / 3.0 * (before - after);
    sum.add(sector, about_vertex + sector * p,
            0.25 * angle * r * r * r * r + 2.0 * p.dot(about_vertex) + sector * p.squaredNorm());
  }
  return sum;
}

}  // namespace

AreaMoments area_moments(const std::vector<Vec2>& core, double rounding) {
  assert(!core.empty());
  Vec2 middle = Vec2::Zero();
  for (const Vec2& v : core) middle += v / static_cast<double>(core.size());
  const Moments rough = moments_about(middle, core, rounding);
  if (!(rough.area > 0.0)) return {0.0, middle, 0.0};
  const Vec2 centroid = middle + rough.first / rough.area;
  return {rough.area, centroid, moments_about(centroid, core, rounding).second};
}

}  // namespace carom
