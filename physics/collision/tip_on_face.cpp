#include "physics/collision/tip_on_face.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "physics/collision/feature_id.h"
#include "physics/math/vectors.h"

namespace carom {
namespace {

// The corner that ends this edge.
int end_of(const ConvexShapes& shapes, ShapeIndex part, int edge) {
  return edge + 1 == shapes.corners[part] ? 0 : edge + 1;
}

Vec2 vertex_of(const ConvexShapes& shapes, ShapeIndex part, const Pose& pose, int corner) {
  return pose.position + pose.turned(shapes.corners_of(part)[corner].vertex);
}

bool is_sharp(const ConvexShapes& shapes, ShapeIndex part) {
  return shapes.rounding[part] == 0.0 && shapes.core[part] != Core::kPoint;
}

Face face_of(const ConvexShapes& shapes, ShapeIndex part, int edge) {
  const Corner& corner = shapes.corners_of(part)[edge];
  const bool ends = shapes.core[part] != Core::kHalfPlane;
  return {part, corner.normal, corner.vertex, ends ? corner.length : std::numeric_limits<double>::infinity()};
}

// The tip from the place of the face's part on, so that places far from the origin lose no digits.
struct Placed {
  Placed(const Geometry& g, BodyIndex a, const Pose& pose_a, BodyIndex b, const Pose& pose_b,
         const TipOnFace& touch)
      : face_at(touch.is_of_b ? g.part_pose(a, touch.parts.a, pose_a) : g.part_pose(b, touch.parts.b, pose_b)) {
    const Pose tip_at =
        touch.is_of_b ? g.part_pose(b, touch.parts.b, pose_b) : g.part_pose(a, touch.parts.a, pose_a);
    tip = tip_at.position - face_at.position + tip_at.turned(touch.tip);
  }
  Pose face_at;
  Vec2 tip;  // m, in the plane's directions
};

}  // namespace

std::optional<TipOnFace> tip_on_face(const Geometry& g, BodyIndex a, const Pose& pose_a, BodyIndex b,
                                     const Pose& pose_b, std::uint32_t id) {
  const ConvexShapes& shapes = g.shapes;
  const ShapePair parts = parts_at(g, a, b, id);
  const Features features = features_of(id);
  const bool is_end = features.ends == Ends::kLow || features.ends == Ends::kHigh;
  if (!is_end || !is_sharp(shapes, parts.a) || !is_sharp(shapes, parts.b)) return std::nullopt;
  // An edge runs from its corner on to the left of its outward normal: to the high end for a, to the low for b.
  const bool low = features.ends == Ends::kLow;
  for (const bool plane_is_b : {false, true}) {
    if (shapes.core[plane_is_b ? parts.b : parts.a] != Core::kHalfPlane) continue;
    const ShapeIndex body = plane_is_b ? parts.a : parts.b;
    const ShapeIndex plane = plane_is_b ? parts.b : parts.a;
    const int corner = low ? end_of(shapes, body, features.of_b) : features.of_b;
    return TipOnFace{parts, !plane_is_b, shapes.corners_of(body)[corner].vertex, face_of(shapes, plane, 0)};
  }
  const int of_a = low ? features.of_a : end_of(shapes, parts.a, features.of_a);
  const int of_b = low ? end_of(shapes, parts.b, features.of_b) : features.of_b;
  const Pose at_a = g.part_pose(a, parts.a, pose_a);
  const Pose at_b = g.part_pose(b, parts.b, pose_b);
  // The stretch that the faces share ends with that of the two corners which lies further in.
  const Vec2 along = crossed(at_a.turned(shapes.corners_of(parts.a)[features.of_a].normal));
  const double ahead =
      along.dot(vertex_of(shapes, parts.b, at_b, of_b) - vertex_of(shapes, parts.a, at_a, of_a));
  if (low ? ahead >= 0.0 : ahead <= 0.0)
    return TipOnFace{parts, true, shapes.corners_of(parts.b)[of_b].vertex,
                     face_of(shapes, parts.a, features.of_a)};
  return TipOnFace{parts, false, shapes.corners_of(parts.a)[of_a].vertex,
                   face_of(shapes, parts.b, features.of_b)};
}

double beyond_face(const Geometry& g, BodyIndex a, const Pose& pose_a, BodyIndex b, const Pose& pose_b,
                   const TipOnFace& touch) {
  if (!std::isfinite(touch.face.length)) return 0.0;
  const Placed at(g, a, pose_a, b, pose_b, touch);
  const double place = touch.face.place_of(at.face_at.turned_back(at.tip));
  return place - std::clamp(place, 0.0, touch.face.length);
}

Contact contact_on_line(const Geometry& g, BodyIndex a, const Pose& pose_a, BodyIndex b, const Pose& pose_b,
                        const TipOnFace& touch) {
  const Placed at(g, a, pose_a, b, pose_b, touch);
  const Vec2 out = at.face_at.turned(touch.face.normal);
  const ConvexShapes::Roundings rounding = g.shapes.roundings(touch.parts.a, touch.parts.b);
  const double gap = out.dot(at.tip) - touch.face.normal.dot(touch.face.vertex) - rounding.sum();
  const double below = (touch.is_of_b ? rounding.b : rounding.a) + 0.5 * gap;
  return {gap, touch.is_of_b ? out : Vec2(-out), at.face_at.position + at.tip - below * out, touch.parts};
}

}  // namespace carom
