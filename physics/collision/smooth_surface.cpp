#include "physics/collision/smooth_surface.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "physics/math/vectors.h"

namespace carom {
namespace {

// rad: two faces that press each other are parallel, and two flush ones smooth, within this.
constexpr double kParallel = 1e-7;
// Sine of the least angle by which a corner of several parts turns.
constexpr double kCorner = 1e-3;

// Where a point lies relative to a body. On its surface, the body fills the directions d with low·d <= 0 and
// high·d <= 0; `high` is `low` turned counter-clockwise by less than 180°, or equal to it on a face.
struct Wedge {
  enum Where { kOutside, kSurface, kInside };
  Where where = kOutside;
  Vec2 low = Vec2::Zero();
  Vec2 high = Vec2::Zero();
};

Wedge smooth_wedge(double distance, const Vec2& normal, double tolerance) {
  if (distance > tolerance) return {};
  if (distance < -tolerance) return {Wedge::kInside};
  return {Wedge::kSurface, normal, normal};
}

// A core without rounding. Of a segment, which is solid from both sides, the side that faces `towards`.
Wedge wedge_at_edges(const ConvexShapes& shapes, ShapeIndex i, const Pose& pose, const Vec2& p,
                     const Vec2& towards, double tolerance) {
  const Corner* corner = shapes.corners_of(i);
  const int count = shapes.corners[i];
  const auto active = [&](int k) {
    const bool far_side = shapes.core[i] == Core::kSegment && k % 2 == 0 && corner[k].normal.dot(towards) < 0.0;
    return !far_side && corner[k].normal.dot(p - corner[k].vertex) >= -tolerance;
  };
  int first = -1;
  bool any = false;
  for (int k = 0; k < count; ++k) {
    if (corner[k].normal.dot(p - corner[k].vertex) > tolerance) return {};
    any = any || active(k);
    if (active(k) && !active(k == 0 ? count - 1 : k - 1)) first = k;
  }
  if (!any) return {Wedge::kInside};
  if (first < 0) return {};  // smaller than the tolerance
  int last = first;
  while (active((last + 1) % count)) last = (last + 1) % count;
  return {Wedge::kSurface, pose.turned(corner[first].normal), pose.turned(corner[last].normal)};
}

Wedge wedge_at_rounded(const ConvexShapes& shapes, ShapeIndex i, const Pose& pose, const Vec2& p,
                       double tolerance) {
  const Corner* corner = shapes.corners_of(i);
  double nearest = std::numeric_limits<double>::infinity();
  bool outside = false;
  Vec2 normal = Vec2::Zero();
  for (int k = 0; k < shapes.corners[i]; ++k) {
    const Vec2 d = p - corner[k].vertex;
    const double height = corner[k].normal.dot(d);
    outside = outside || height > 0.0;
    const double along = cross(corner[k].normal, d);
    if (height > 0.0 && along >= 0.0 && along <= corner[k].length)
      return smooth_wedge(height - shapes.rounding[i], pose.turned(corner[k].normal), tolerance);
    if (d.norm() < nearest) nearest = d.norm(), normal = d;
  }
  if (!outside) return {Wedge::kInside};
  return smooth_wedge(nearest - shapes.rounding[i], pose.turned(normal / nearest), tolerance);
}

Wedge wedge_at(const ConvexShapes& shapes, ShapeIndex i, const Pose& pose, const Vec2& point,
               const Vec2& towards, double tolerance) {
  const Vec2 d = point - pose.position;
  if (shapes.core[i] == Core::kPoint) {
    const double distance = d.norm();
    if (!(distance > 0.0)) return {Wedge::kInside};
    return smooth_wedge(distance - shapes.rounding[i], d / distance, tolerance);
  }
  const Vec2 p = pose.turned_back(d);
  if (shapes.core[i] == Core::kHalfPlane) {
    const Corner& edge = *shapes.corners_of(i);
    return smooth_wedge(edge.normal.dot(p - edge.vertex), pose.turned(edge.normal), tolerance);
  }
  if (shapes.rounding[i] > 0.0) return wedge_at_rounded(shapes, i, pose, p, tolerance);
  return wedge_at_edges(shapes, i, pose, p, pose.turned_back(towards), tolerance);
}

bool opposite(const Vec2& m, const Vec2& n) { return (m + n).squaredNorm() <= kParallel * kParallel; }

bool parallel(const Vec2& m, const Vec2& n) { return (m - n).squaredNorm() <= kParallel * kParallel; }

// Of the tolerance: a point that has sunk so far between two neighbours has done so from their edge.
constexpr double kSunk = 1e3;
// Likewise of one that has sunk into a neighbour, from its surface; and of the neighbour's radius.
constexpr double kSunkInto = 1e5;
constexpr double kSunkShare = 1e-2;

enum class Cover { kNone, kRidge, kBetween, kInside };

// rad: from one direction to another, counter-clockwise, in (-π, π].
double turn(const Vec2& from, const Vec2& to) { return std::atan2(cross(from, to), from.dot(to)); }

// Where two wedges overlap, their surface has the normals that both have: where a corner lies on a face, that
// of the face alone. Where they have none in common it is reentrant, and both are met.
Cover cover_of_overlap(const Wedge& here, const Wedge& there, const Vec2& normal, bool by_face) {
  // Normals as angles from the first one here.
  const double here_end = turn(here.low, here.high);
  const double there_begin = turn(here.low, there.low);
  const double there_end = there_begin + turn(there.low, there.high);
  // Each fills the directions from a quarter turn after its last normal to three quarters after its first.
  const double begin_of_both = std::max(there_end, here_end) + 0.5 * std::numbers::pi;
  const double end_of_both = std::min(there_begin, 0.0) + 1.5 * std::numbers::pi;
  if (begin_of_both > end_of_both + kParallel) return Cover::kNone;
  const double first = std::max(there_begin, 0.0);
  const double last = std::min(there_end, here_end);
  if (last < first - kParallel || (by_face && last - first > kCorner)) return Cover::kNone;
  const double at = turn(here.low, normal);
  return at < first - kParallel || at > last + kParallel ? Cover::kRidge : Cover::kNone;
}

// How a neighbour covers a point of its owner: from inside, face to face, or by a ridge that both make.
Cover cover_of(const Wedge& here, const Wedge& there, const Vec2& normal, bool may_overlap, bool by_face) {
  if (there.where == Wedge::kOutside || here.where != Wedge::kSurface) return Cover::kNone;
  if (there.where == Wedge::kInside) return Cover::kInside;
  // Which of the two follows the other counter-clockwise: faces that press each other are opposite.
  const bool follows = opposite(there.high, here.low);
  const bool leads = opposite(there.low, here.high);
  if (follows && leads) return Cover::kBetween;
  if (!follows && !leads) return may_overlap ? cover_of_overlap(here, there, normal, by_face) : Cover::kNone;
  const Vec2& low = follows ? there.low : here.low;
  const Vec2& high = follows ? here.high : there.high;
  if (cross(low, high) < -kParallel || (by_face && cross(low, high) > kCorner)) return Cover::kNone;
  const bool outside = cross(low, normal) < -kParallel || cross(normal, high) < -kParallel;
  return outside ? Cover::kRidge : Cover::kNone;
}

// Whether this is a thin wall along which the normal runs, which does not tell from which side it is touched.
bool runs_along(const ConvexShapes& shapes, ShapeIndex i, const Pose& pose, const Vec2& normal) {
  return shapes.core[i] == Core::kSegment && shapes.rounding[i] == 0.0 &&
         std::abs(shapes.corners_of(i)->normal.dot(pose.turned_back(normal))) <= kParallel;
}

// The outward normal of the face on which a point is that is none of its ends.
std::optional<Vec2> face_at(const ConvexShapes& shapes, ShapeIndex i, const Pose& pose, const Vec2& point,
                            const Vec2& towards, double tolerance) {
  if (shapes.core[i] == Core::kPoint) return std::nullopt;
  if (shapes.rounding[i] == 0.0) {
    const Wedge face = wedge_at(shapes, i, pose, point, towards, tolerance);
    if (face.where != Wedge::kSurface || !parallel(face.low, face.high)) return std::nullopt;
    return face.low;
  }
  const Vec2 p = pose.turned_back(Vec2(point - pose.position));
  const Corner* corner = shapes.corners_of(i);
  for (int k = 0; k < shapes.corners[i]; ++k) {
    const Vec2 d = p - corner[k].vertex;
    const double along = cross(corner[k].normal, d);
    const bool is_on = std::abs(corner[k].normal.dot(d) - shapes.rounding[i]) <= tolerance;
    if (is_on && along > tolerance && along < corner[k].length - tolerance)
      return pose.turned(corner[k].normal);
  }
  return std::nullopt;
}

}  // namespace

bool neighbour_covers(const ConvexShapes& shapes, ShapeIndex owner, const Pose& pose_owner,
                      ShapeIndex neighbour, const Pose& pose_neighbour, const Vec2& point, const Vec2& normal,
                      double tolerance, bool may_overlap, bool by_face) {
  const double reach = shapes.radius[neighbour] + tolerance;
  if ((point - pose_neighbour.position).squaredNorm() > reach * reach) return false;
  const auto covers = [&](const Vec2& towards) {
    const auto cover = [&](double within) {
      const Wedge there = wedge_at(shapes, neighbour, pose_neighbour, point, towards, within);
      if (there.where == Wedge::kOutside) return Cover::kNone;
      return cover_of(wedge_at(shapes, owner, pose_owner, point, towards, within), there, normal, may_overlap,
                      by_face);
    };
    const Cover covered = cover(tolerance);
    if (covered == Cover::kNone || covered == Cover::kRidge) return covered != Cover::kNone;
    if (!may_overlap) return covered == Cover::kBetween && cover(kSunk * tolerance) == Cover::kRidge;
    // Where two faces meet in a corner of a room, what has sunk into the one is still on the other.
    const double from_surface = std::min(kSunkInto * tolerance, kSunkShare * shapes.radius[neighbour]);
    return cover(std::max(tolerance, from_surface)) != Cover::kNone;
  };
  if (!runs_along(shapes, owner, pose_owner, normal) && !runs_along(shapes, neighbour, pose_neighbour, normal))
    return covers(normal);
  const Vec2 aside = 2.0 * kParallel * crossed(normal);
  return covers(normal + aside) || covers(normal - aside);
}

bool lies_over_seam(const ConvexShapes& shapes, ShapeIndex owner, const Pose& pose_owner, ShapeIndex neighbour,
                    const Pose& pose_neighbour, ShapeIndex toucher, const Pose& pose_toucher, const Vec2& at,
                    const Vec2& over, const Vec2& normal, double tolerance) {
  const double reach = shapes.radius[neighbour] + tolerance;
  if ((at - pose_neighbour.position).squaredNorm() > reach * reach) return false;
  const Wedge there = wedge_at(shapes, neighbour, pose_neighbour, at, normal, tolerance);
  if (there.where != Wedge::kSurface) return false;
  const std::optional<Vec2> face = face_at(shapes, toucher, pose_toucher, over, -normal, tolerance);
  if (!face || face->dot(normal) >= 0.0) return false;
  const Wedge here = wedge_at(shapes, owner, pose_owner, at, normal, tolerance);
  if (here.where != Wedge::kSurface) return false;
  const auto side_by_side = [&](const Wedge& first, const Wedge& second) {
    return opposite(first.high, second.low) && parallel(first.low, normal) && parallel(second.high, normal);
  };
  return side_by_side(here, there) || side_by_side(there, here);
}

std::optional<Contact> corner_over_face(const ConvexShapes& shapes, ShapeIndex owner, const Pose& pose_owner,
                                        ShapeIndex toucher, const Pose& pose_toucher, const Vec2& over,
                                        const Vec2& normal, double tolerance) {
  if (shapes.rounding[owner] > 0.0 || shapes.rounding[toucher] > 0.0) return std::nullopt;
  if (shapes.core[toucher] == Core::kHalfPlane) return std::nullopt;
  const bool ends = shapes.core[owner] != Core::kHalfPlane;
  const Vec2 at = pose_toucher.turned_back(Vec2(over - pose_toucher.position));
  const Corner* corner = shapes.corners_of(toucher);
  const Corner* end = corner + shapes.corners[toucher];
  const Corner* tip =
      std::find_if(corner, end, [&](const Corner& c) { return (c.vertex - at).norm() <= tolerance; });
  if (tip == end) return std::nullopt;
  const Vec2 point = pose_toucher.position + pose_toucher.turned(tip->vertex);
  const Vec2 p = pose_owner.turned_back(Vec2(point - pose_owner.position));
  const Corner* face = shapes.corners_of(owner);
  for (int k = 0; k < shapes.edges(owner); ++k) {
    const Vec2 out = pose_owner.turned(face[k].normal);
    const double along = cross(face[k].normal, Vec2(p - face[k].vertex));
    if (!(out.dot(normal) > std::numbers::sqrt2 / 2.0) || (ends && (along < 0.0 || along > face[k].length)))
      continue;
    const double gap = face[k].normal.dot(p - face[k].vertex);
    return Contact{gap, out, point - 0.5 * gap * out};
  }
  return std::nullopt;
}

bool has_face(const ConvexShapes& shapes, ShapeIndex i, const Pose& pose, const Vec2& normal) {
  const Vec2 own = pose.turned_back(normal);
  const Corner* corner = shapes.corners_of(i);
  if (shapes.core[i] == Core::kHalfPlane) return (corner->normal - own).squaredNorm() <= kParallel * kParallel;
  for (int k = 0; k < shapes.edges(i); ++k) {
    if (corner[k].length > 0.0 && (corner[k].normal - own).squaredNorm() <= kParallel * kParallel) return true;
  }
  return false;
}

}  // namespace carom
