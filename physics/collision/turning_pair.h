#pragma once

#include <algorithm>
#include <cmath>

#include "physics/collision/pair_contact.h"
#include "physics/collision/time_of_impact.h"

namespace carom {

// A pair of convex bodies that may turn, at one time.
struct TurningSample {
  double gap;   // m
  Vec2 normal;  // unit, from a to b
  Pose a;
  Pose b;
};

// The sampler of first_contact for bodies that may turn. `path_a(t)` and `path_b(t)` return q = (x, y,
// angle), or a Pose, which saves sine and cosine for a body that does not turn.
//
// `path_curvature` in m/s² bounds the second derivative of the relative path of the centres. The curvature
// bound for first_contact is larger by the turning_curvature of both bodies, for their largest spin and
// angular acceleration within the interval: (ω² + |α|) r bounds the path of a vertex about its centre. It is
// zero for discs, however fast they spin. `turn_a` and `turn_b` in rad/s² bound ω² + |α|.
template <class PathA, class PathB>
class TurningPair {
 public:
  TurningPair(const ConvexShapes& shapes, ShapeIndex a, PathA path_a, ShapeIndex b, PathB path_b,
              double path_curvature, double turn_a, double turn_b)
      : shapes_(shapes),
        a_(a),
        b_(b),
        path_a_(path_a),
        path_b_(path_b),
        path_curvature_(path_curvature),
        turn_a_(turn_a),
        turn_b_(turn_b) {}

  [[nodiscard]] TurningSample operator()(double t) const {
    const Pose a = pose(a_, path_a_(t));
    const Pose b = pose(b_, path_b_(t));
    const Gap gap = gap_between(shapes_, a_, a, b_, b);
    return {gap.gap, gap.normal, a, b};
  }

  [[nodiscard]] double separation(const Vec2& n, const TurningSample& at) const {
    return carom::separation(shapes_, a_, at.a, b_, at.b, n);
  }

  // Whether the circles around the bodies stay apart: the centres' relative path deviates from its chord by
  // up to path_curvature·width²/8. Saves the search for bodies that turn fast but are far from each other.
  [[nodiscard]] bool clear(const TurningSample& from, const TurningSample& to, double width) const {
    const Vec2 d = from.b.position - from.a.position;
    const Vec2 way = to.b.position - to.a.position - d;
    const double length = way.squaredNorm();
    const double along = length > 0.0 ? std::clamp(-d.dot(way) / length, 0.0, 1.0) : 0.0;
    const double reach = shapes_.radius[a_] + shapes_.radius[b_] + path_curvature_ * width * width / 8.0;
    return (d + along * way).squaredNorm() > reach * reach;
  }

  // Whether the separation along a normal that turns with one of the bodies shows that they touch by no more
  // than `tolerance` (m). Along a fixed normal the far end of a face that turns comes near: where a corner
  // leaves a face slowly, that shows nothing but within very short times.
  [[nodiscard]] bool clear_turning(const TurningSample& from, const TurningSample& to, double width,
                                   double tolerance) const {
    const auto clear_in = [&](const Pose& own_from, const Pose& own_to, double turn, ShapeIndex other,
                              double turn_other) {
      if (!(turn > 0.0)) return false;
      const double curvature = curvature_seen(from, to, width, turn, other, turn_other);
      const auto clear_along = [&](double at_from, double at_to) {
        return least_over_chord(at_from, (at_to - at_from) / width, curvature, width, width) > -tolerance;
      };
      return clear_along(from.gap, separation(own_to.turned(own_from.turned_back(from.normal)), to)) ||
             clear_along(separation(own_from.turned(own_to.turned_back(to.normal)), from), to.gap);
    };
    return clear_in(from.a, to.a, turn_a_, b_, turn_b_) || clear_in(from.b, to.b, turn_b_, a_, turn_a_);
  }

 private:
  // m/s²: bounds the second derivative of n·(x - c) for the vertices x of the other body, seen from a body with
  // the centre c and `turn` in rad/s² with which n turns: that of n·d is n''·d + 2 n'·d' + n·d''.
  [[nodiscard]] double curvature_seen(const TurningSample& from, const TurningSample& to, double width,
                                      double turn, ShapeIndex other, double turn_other) const {
    const double reach = shapes_.core_radius[other];
    const Vec2 d_from = from.b.position - from.a.position;
    const Vec2 d_to = to.b.position - to.a.position;
    const double farthest =
        std::max(d_from.norm(), d_to.norm()) + path_curvature_ * width * width / 8.0 + reach;
    const double fastest =
        (d_to - d_from).norm() / width + 0.5 * path_curvature_ * width + std::sqrt(turn_other) * reach;
    return turn * farthest + 2.0 * std::sqrt(turn) * fastest + path_curvature_ + turn_other * reach;
  }

  [[nodiscard]] Pose pose(ShapeIndex, const Pose& pose) const { return pose; }
  [[nodiscard]] Pose pose(ShapeIndex i, const Eigen::Vector3d& q) const { return pose_of(shapes_, i, q); }

  const ConvexShapes& shapes_;
  ShapeIndex a_;
  ShapeIndex b_;
  PathA path_a_;
  PathB path_b_;
  double path_curvature_;
  double turn_a_;
  double turn_b_;
};

}  // namespace carom
