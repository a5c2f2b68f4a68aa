#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "physics/scene/scene.h"

namespace carom {

// What the search needs to know of a pair at one time: the gap in m, the unit normal from A to B, and the
// position of B relative to A in m. All three come from the integrator's own map, so the state at the root is a
// true step of it.
struct GapSample {
  double gap;
  Vec2 normal;
  Vec2 relative;
};

// A root of a function with f(a) > 0 >= f(b), to the last bit of the argument: the returned argument is on the
// side of a, where f is still positive (or exactly zero), so that bodies are never left overlapping. T. R.
// Chandrupatla, Advances in Engineering Software 28 (1997) 145: inverse quadratic interpolation where it is
// safe, bisection elsewhere.
template <class Function>
[[nodiscard]] double bracketed_root(const Function& f, double a, double fa, double b, double fb) {
  if (fb == 0.0) return b;
  double low = a;  // largest argument known with f > 0
  double x1 = b, f1 = fb, x2 = a, f2 = fa, x3 = b, f3 = fb;
  double t = 0.5;
  if (std::abs(fa - fb) > 0.0) t = fb / (fb - fa);
  for (int i = 0; i < 200; ++i) {
    double x = x1 + t * (x2 - x1);
    // Where the guess rounds to an end, its neighbour decides.
    if (x == x1) x = std::nextafter(x1, x2);
    if (x == x2) x = std::nextafter(x2, x1);
    if (x == x1) break;
    const double fx = f(x);
    if (fx >= 0.0) low = x;
    if (fx == 0.0) break;
    if ((fx > 0.0) == (f1 > 0.0)) {
      x3 = x1, f3 = f1;
    } else {
      x3 = x2, f3 = f2;
      x2 = x1, f2 = f1;
    }
    x1 = x, f1 = fx;
    // x1 is the newest point, x2 brackets with it, x3 is the one before.
    const double xi = (x1 - x2) / (x3 - x2);
    const double phi = (f1 - f2) / (f3 - f2);
    if (phi * phi < xi && (1.0 - phi) * (1.0 - phi) < 1.0 - xi) {
      t = f1 / (f2 - f1) * f3 / (f2 - f3) + (x3 - x1) / (x2 - x1) * f1 / (f3 - f1) * f2 / (f3 - f2);
    } else {
      t = 0.5;
    }
    const double width = std::abs(x2 - x1);
    const double least = 0.5 * std::numeric_limits<double>::epsilon() * std::max(std::abs(x1), std::abs(x2));
    if (width <= 2.0 * least) break;
    t = std::min(1.0 - least / width, std::max(least / width, t));
  }
  return low;
}

// The time after which two points that are `d` apart (m) and move at `u` relative to each other (m/s) come as
// near as `distance` (m, > 0), while they approach: the smaller root of |d + u τ| = distance. The gap |d| -
// distance may be negative by its rounding; the time is then zero. The discriminant is formed from d × u, which
// keeps a grazing pass apart from a miss where d·d - distance² would have cancelled.
[[nodiscard]] inline std::optional<double> first_disc_contact(const Vec2& d, const Vec2& u, double distance) {
  const double approach = -d.dot(u);
  if (!(approach > 0.0)) return std::nullopt;
  const double speed = u.norm();
  const double aside = std::abs(d.x() * u.y() - d.y() * u.x());
  const double discriminant = (speed * distance - aside) * (speed * distance + aside);
  if (!(discriminant > 0.0)) return std::nullopt;
  const double apart = d.norm();
  const double gap = (apart - distance) * (apart + distance);
  return std::max(0.0, gap / (approach + std::sqrt(discriminant)));
}

// The first time in [a, b] at which the gap of two convex bodies closes, if there is one. The gap at `a` must
// be positive. `sample(t)` gives a GapSample; `curvature` in m/s² bounds the second derivative of the relative
// path.
//
// Under straight relative translation the signed distance of convex shapes is a convex function of time, so the
// tangents at both ends bound it from below; the true path strays from its chord by at most curvature·(b-a)²/8.
// An interval whose bound stays positive holds no root, any other is halved at the point where the tangents
// meet. A root r found by bracketing is the first one if the closing speed at r exceeds curvature·(r-a)/2, else
// the interval before it is searched. So a grazing pass is neither missed nor invented, beyond `tolerance`: a
// pass that would overlap by less (m, the rounding of a gap) is no impact.
template <class Sample>
[[nodiscard]] std::optional<double> first_contact(const Sample& sample, double a, const GapSample& ga, double b,
                                                  const GapSample& gb, double curvature, double tolerance) {
  const double width = b - a;
  if (!(width > 4.0 * std::numeric_limits<double>::epsilon() * std::max(std::abs(a), std::abs(b)))) {
    return gb.gap <= 0.0 ? std::optional(a) : std::nullopt;
  }
  const Vec2 chord = (gb.relative - ga.relative) / width;
  const double slope_a = ga.normal.dot(chord);
  const double slope_b = gb.normal.dot(chord);

  if (gb.gap > 0.0) {
    double least = ga.gap;
    double meet = 0.5 * width;
    if (slope_b <= 0.0) {
      least = gb.gap;
    } else if (slope_a < 0.0) {
      meet = (gb.gap - ga.gap - slope_b * width) / (slope_a - slope_b);
      least = ga.gap + slope_a * meet;
    }
    const double stray = curvature * width * width / 8.0;
    if (least - stray > -tolerance) return std::nullopt;
    // Both curves touch their chord at the ends: where the stray dominates, the middle is the better place.
    if (!(meet > 0.05 * width && meet < 0.95 * width) || stray > 0.5 * ga.gap) meet = 0.5 * width;
    const double m = a + meet;
    const GapSample gm = sample(m);
    if (gm.gap <= 0.0) return first_contact(sample, a, ga, m, gm, curvature, tolerance);
    if (const auto root = first_contact(sample, a, ga, m, gm, curvature, tolerance)) return root;
    return first_contact(sample, m, gm, b, gb, curvature, tolerance);
  }

  const double root = bracketed_root([&](double t) { return sample(t).gap; }, a, ga.gap, b, gb.gap);
  if (curvature == 0.0 || !(root > a)) return root;
  const GapSample gr = sample(root);
  const double closing = -gr.normal.dot((gr.relative - ga.relative) / (root - a));
  if (closing > 0.5 * curvature * (root - a)) return root;
  const double m = 0.5 * (a + root);
  if (!(m > a && m < root)) return root;
  const GapSample gm = sample(m);
  if (gm.gap <= 0.0) return first_contact(sample, a, ga, m, gm, curvature, tolerance);
  if (const auto earlier = first_contact(sample, a, ga, m, gm, curvature, tolerance)) return earlier;
  // Between m and the root: search with the root as a positive end, and fall back on the root itself.
  if (gr.gap > 0.0) {
    if (const auto earlier = first_contact(sample, m, gm, root, gr, curvature, tolerance)) return earlier;
  }
  return root;
}

}  // namespace carom
