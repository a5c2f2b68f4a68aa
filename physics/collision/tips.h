#pragma once

#include <algorithm>
#include <optional>

#include "physics/collision/closest_features.h"
#include "physics/model/convex.h"

// Corners without rounding that meet tip to tip.
namespace carom {

// They do if they are no farther from each other than this share of the scale: rounding, which adds up on the
// way there.
inline constexpr double kTip = 1e-11;

// Two tips in the frame of a.
struct TipsThatMeet {
  Vec2 point;  // m, in their middle
  CornerCone of_a, of_b;
};
// Of two cores with faces, the corners that are within `near` m of each other.
[[nodiscard]] std::optional<TipsThatMeet> tips_that_meet(const ConvexShapes& shapes, ShapeIndex a, ShapeIndex b,
                                                         const PairFrame& frame, double near);

// In the middle of the directions that are outward normals of a and inward ones of b, as which of their corners
// is nearest is rounding; nothing if there are none. At a reentrant corner that of the one of its bare faces on
// whose side the other body is; `to_b` leads from a to b.
[[nodiscard]] std::optional<Vec2> tip_normal(const TipsThatMeet& tips, const Vec2& to_b);

// The first and the last of the normals that two tips have in common, counter-clockwise.
struct TipNormals {
  Vec2 low, high;  // unit, from a to b
};
// Nothing where two parts at these poses have no corners that are flush, or a reentrant one.
[[nodiscard]] std::optional<TipNormals> tip_normals(const ConvexShapes& shapes, ShapeIndex a,
                                                    const Pose& pose_a, ShapeIndex b, const Pose& pose_b);

// Tips meet if they close along both of these normals, along the one by no less than this share of the other.
inline constexpr double kTipsClose = 1e-3;

// What slides along a face past a corner that is flush with it does not meet that: the one of these normals
// along which it does not close, if there is one. parting(normal) is the speed along a normal in m/s.
template <class Parting>
[[nodiscard]] std::optional<Vec2> passes_along(const TipNormals& tips, const Parting& parting) {
  const double low = parting(tips.low);
  const double high = parting(tips.high);
  if (std::max(low, high) < kTipsClose * std::min(low, high)) return std::nullopt;
  return low > high ? tips.low : tips.high;
}

}  // namespace carom
