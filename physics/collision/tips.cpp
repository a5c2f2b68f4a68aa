#include "physics/collision/tips.h"

#include "physics/math/vectors.h"

namespace carom {
namespace {

// Relative to the size: what slides on a support is off its place by what the solver of its contact forces
// leaves, up to 1e-10.
constexpr double kFlush = 1e-8;
// Normals differ by rounding, or by less than this, squared or as a sine.
constexpr double kSameNormal = 1e-12;

// That two corners have in common.
std::optional<TipNormals> common_normals(const CornerCone& a, const CornerCone& b) {
  const Vec2 low = cross(a.last, -b.last) > 0.0 ? Vec2(-b.last) : a.last;
  const Vec2 high = cross(a.next, -b.next) < 0.0 ? Vec2(-b.next) : a.next;
  if (cross(low, high) < 0.0 || a.last.dot(-b.last) < 0.0) return std::nullopt;
  return TipNormals{low, high};
}

// The direction in their middle.
std::optional<Vec2> middle_normal(const CornerCone& a, const CornerCone& b) {
  const auto common = common_normals(a, b);
  if (!common) return std::nullopt;
  const Vec2 middle = common->low + common->high;
  return middle.squaredNorm() > 0.0 ? std::optional<Vec2>(middle.normalized()) : std::nullopt;
}

// Whether this direction is among the normals of a cone, within rounding.
bool has_normal(const CornerCone& cone, const Vec2& normal) {
  if (cone.reentrant)
    return (normal - cone.last).squaredNorm() <= kSameNormal ||
           (normal - cone.next).squaredNorm() <= kSameNormal;
  return cross(cone.last, normal) >= -kSameNormal && cross(normal, cone.next) >= -kSameNormal &&
         cone.last.dot(normal) + cone.next.dot(normal) > 0.0;
}

bool has_tips(const ConvexShapes& shapes, ShapeIndex part) {
  return (shapes.core[part] == Core::kBox || shapes.core[part] == Core::kPolygon) &&
         shapes.rounding[part] == 0.0;
}

}  // namespace

std::optional<TipsThatMeet> tips_that_meet(const ConvexShapes& shapes, ShapeIndex a, ShapeIndex b,
                                           const PairFrame& frame, double near) {
  if (frame.edges_a < 3 || frame.edges_b < 3) return std::nullopt;
  for (int i = 0; i < frame.edges_a; ++i) {
    for (int k = 0; k < frame.edges_b; ++k) {
      const Vec2& on_a = frame.a[i].vertex;
      const Vec2& on_b = frame.vertex[static_cast<std::size_t>(k)];
      if ((on_a - on_b).squaredNorm() > near * near) continue;
      CornerCone of_b = shapes.cone_at(b, k);
      of_b.last = frame.relative.turned(of_b.last);
      of_b.next = frame.relative.turned(of_b.next);
      return TipsThatMeet{0.5 * (on_a + on_b), shapes.cone_at(a, i), of_b};
    }
  }
  return std::nullopt;
}

std::optional<Vec2> tip_normal(const TipsThatMeet& tips, const Vec2& to_b) {
  const auto& [point, a, b] = tips;
  if (!a.reentrant && !b.reentrant) return middle_normal(a, b);
  const CornerCone inwards{-b.last, -b.next, b.reentrant};
  const CornerCone& one = a.reentrant ? a : inwards;
  const CornerCone& other = a.reentrant ? inwards : a;
  std::optional<Vec2> best;
  for (const Vec2& normal : {one.last, one.next}) {
    if (normal.isZero() || !has_normal(other, normal)) continue;
    if (!best || normal.dot(to_b) > best->dot(to_b)) best = normal;
  }
  return best;
}

std::optional<TipNormals> tip_normals(const ConvexShapes& shapes, ShapeIndex a, const Pose& pose_a,
                                      ShapeIndex b, const Pose& pose_b) {
  if (!has_tips(shapes, a) || !has_tips(shapes, b)) return std::nullopt;
  const PairFrame frame(shapes, a, pose_a, b, pose_b);
  const auto tips = tips_that_meet(shapes, a, b, frame, kFlush * frame.size);
  if (!tips || tips->of_a.reentrant || tips->of_b.reentrant) return std::nullopt;
  const auto common = common_normals(tips->of_a, tips->of_b);
  if (!common) return std::nullopt;
  return TipNormals{pose_a.turned(common->low), pose_a.turned(common->high)};
}

}  // namespace carom
