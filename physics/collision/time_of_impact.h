#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "physics/math/roots.h"
#include "physics/math/vectors.h"

namespace carom {

// One sample of a pair that does not turn, or of discs: the gap in m, the unit normal from A to B, and the
// position of B relative to A in m. All three come from the integrator's own map, so the state at the root is
// a true step of the integrator. For bodies that turn see turning_pair.h.
struct GapSample {
  double gap;
  Vec2 normal;
  Vec2 relative;
};

// The time after which two points at the relative position `d` (m) and velocity `u` (m/s) are at the
// `distance` (m, > 0), while they approach: the smaller root of |d + u τ| = distance. The gap |d| - distance
// may be negative by its rounding; the time is then zero. The discriminant is formed from d × u, which tells
// a grazing pass from a miss where d·d - distance² would have cancelled.
[[nodiscard]] inline std::optional<double> first_disc_contact(const Vec2& d, const Vec2& u, double distance) {
  const double approach = -d.dot(u);
  const double speed = u.norm();
  const double aside = std::abs(cross(d, u));
  const double discriminant = (speed * distance - aside) * (speed * distance + aside);
  // One branch, as neither is predictable.
  if ((int(approach > 0.0) & int(discriminant > 0.0)) == 0) return std::nullopt;
  const double apart = d.norm();
  const double gap = (apart - distance) * (apart + distance);
  return std::max(0.0, gap / (approach + std::sqrt(discriminant)));
}

// The mean rate in m/s at which two bodies separate along the normal of one sample, over the `width` (s,
// signed) from it to another: (s(n, to) - gap) / width with the separation s(n, t), the least n·(x_b - x_a)
// over all points of both. Without rotation all points move alike. A sampler of bodies that turn provides
// separation(n, sample).
template <class Sampler, class Sample>
[[nodiscard]] double parting_rate(const Sampler& sample, const Sample& from, const Sample& to, double width) {
  if constexpr (requires { sample.separation(from.normal, to); }) {
    return (sample.separation(from.normal, to) - from.gap) / width;
  } else {
    return from.normal.dot((to.relative - from.relative) / width);
  }
}

// The least of f + slope t - curvature t (width - t)/2 over [0, end], end <= width.
[[nodiscard]] inline double least_over_chord(double f, double slope, double curvature, double width,
                                             double end) {
  double t = slope < 0.0 ? end : 0.0;
  if (curvature > 0.0) t = std::clamp(0.5 * width - slope / curvature, 0.0, end);
  return f + t * (slope - 0.5 * curvature * (width - t));
}

// The budget of a search; the search counts it down.
struct SearchLimit {
  int looks = std::numeric_limits<int>::max();  // samples, not counting those of a bracketed root
  int halvings = 64;                            // nested, of an interval; further ones reach rounding
  bool reached = false;                         // set when the search ran out of samples
};

// The first time in [a, b] at which the gap of two convex bodies closes, if there is one. The gap at `a` must
// be positive. `sample(t)` returns a GapSample, or whatever the sampler's own separation() takes. `curvature`
// K in m/s² is a curvature bound: of the second derivative of x_q - x_p for all vertices q and p of the cores
// of B and A. Without rotation that is the relative path; else see turning_pair.h.
//
// The signed gap of convex bodies is the greatest separation s(n, t) over all directions n, and equals s for
// the contact normal n. For a fixed n and one pair of vertices, the distance along n lies above its chord
// over [a, b] less K (t-a)(b-t)/2. s(n, t) is the least of these distances, and the least of several lines
// lies above the chord between its own ends. So with the normals n_a, n_b at the ends
//   gap(t) >= max(line from gap(a) to s(n_a, b), line from s(n_b, a) to gap(b)) - K (t-a)(b-t)/2.
// (Under straight translation these lines are the tangents of a convex function.) An interval whose bound
// stays positive has no root; any other is halved where the lines intersect. A root r found by bracketing is
// the first one if s(n_r, a)/(r-a) exceeds K (r-a)/2, by the same bound on [a, r]; else the interval before
// it is searched. So grazing passes are neither missed nor invented, except for `tolerance`: a pass that
// would penetrate by less (m, the rounding of a gap) is no impact.
//
// A sampler may also have clear(from, to, width): true if bounds of its own show that there is no contact
// between two samples; and curvature_along(n), a bound that holds for this direction alone: faces that slide
// along each other, flush, on curved paths are clear by it; and clear_turning(from, to, width, tolerance),
// where normals turn.
//
// If the limit ends the search, the result is a known contact, if there is one, though perhaps not the first.
template <class Sampler, class Sample>
[[nodiscard]] std::optional<double> first_contact(const Sampler& sample, double a, const Sample& ga, double b,
                                                  const Sample& gb, double curvature, double tolerance,
                                                  SearchLimit& limit) {
  const double width = b - a;
  if (!(width > 4.0 * std::numeric_limits<double>::epsilon() * std::max(std::abs(a), std::abs(b))) ||
      limit.halvings == 0) {
    return gb.gap <= 0.0 ? std::optional(a) : std::nullopt;
  }
  const auto search = [&](double from, const Sample& at_from, double to, const Sample& at_to) {
    --limit.halvings;
    const auto found = first_contact(sample, from, at_from, to, at_to, curvature, tolerance, limit);
    ++limit.halvings;
    return found;
  };
  const auto ends_here = [&limit] {
    if (limit.looks > 0) {
      --limit.looks;
      return false;
    }
    limit.reached = true;
    return true;
  };

  if (gb.gap > 0.0) {
    if (limit.reached) return std::nullopt;
    if constexpr (requires { sample.clear(ga, gb, width); }) {
      if (sample.clear(ga, gb, width)) return std::nullopt;
    }
    const double slope_a = parting_rate(sample, ga, gb, width);
    const double slope_b = -parting_rate(sample, gb, ga, width);
    double crossing = 0.5 * width;
    if (slope_a < slope_b) {
      crossing = std::clamp((gb.gap - ga.gap - slope_b * width) / (slope_a - slope_b), 0.0, width);
    }
    const auto least = [&](double of_a, double of_b) {
      return std::min(least_over_chord(ga.gap, slope_a, of_a, width, crossing),
                      least_over_chord(gb.gap, -slope_b, of_b, width, width - crossing));
    };
    if (least(curvature, curvature) > -tolerance) return std::nullopt;
    if constexpr (requires { sample.curvature_along(ga.normal); }) {
      if (least(sample.curvature_along(ga.normal), sample.curvature_along(gb.normal)) > -tolerance)
        return std::nullopt;
    }
    if constexpr (requires { sample.clear_turning(ga, gb, width, tolerance); }) {
      if (sample.clear_turning(ga, gb, width, tolerance)) return std::nullopt;
    }
    if (ends_here()) return std::nullopt;
    const double stray = curvature * width * width / 8.0;
    // Both curves touch their chord at the ends. Where the stray dominates, the middle is better.
    if (!(crossing > 0.05 * width && crossing < 0.95 * width) || stray > 0.5 * ga.gap) crossing = 0.5 * width;
    const double m = a + crossing;
    const Sample gm = sample(m);
    if (gm.gap <= 0.0) return search(a, ga, m, gm);
    if (const auto root = search(a, ga, m, gm)) return root;
    return search(m, gm, b, gb);
  }

  const double root = bracketed_root([&](double t) { return sample(t).gap; }, a, ga.gap, b, gb.gap);
  if (curvature == 0.0 || !(root > a)) return root;
  const Sample gr = sample(root);
  const double closing = parting_rate(sample, gr, ga, root - a);
  if (closing > 0.5 * curvature * (root - a)) return root;
  const double m = 0.5 * (a + root);
  if (!(m > a && m < root) || ends_here()) return root;
  const Sample gm = sample(m);
  if (gm.gap <= 0.0) return search(a, ga, m, gm);
  if (const auto earlier = search(a, ga, m, gm)) return earlier;
  // Between m and the root: search with the root as a positive end (the gap there may be zero to the last bit),
  // and fall back on the root itself.
  Sample end = gr;
  end.gap = std::max(gr.gap, std::numeric_limits<double>::min());
  if (const auto earlier = search(m, gm, root, end)) return earlier;
  return root;
}

template <class Sampler, class Sample>
[[nodiscard]] std::optional<double> first_contact(const Sampler& sample, double a, const Sample& ga, double b,
                                                  const Sample& gb, double curvature, double tolerance) {
  SearchLimit none;
  return first_contact(sample, a, ga, b, gb, curvature, tolerance, none);
}

}  // namespace carom
