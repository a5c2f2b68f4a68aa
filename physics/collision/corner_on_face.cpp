#include "physics/collision/corner_on_face.h"

#include <algorithm>

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

// The corner from the place of the face's part on, so that places far from the origin lose no digits.
struct CornerAndFace {
  CornerAndFace(const Geometry& g, BodyIndex a, const Pose& pose_a, BodyIndex b, const Pose& pose_b,
                const CornerOnFace& touch)
      : face_at(touch.is_of_b ? g.part_pose(a, touch.parts.a, pose_a) : g.part_pose(b, touch.parts.b, pose_b)),
        face(g.shapes.corners_of(touch.is_of_b ? touch.parts.a : touch.parts.b)[touch.face]),
        of_half_plane(g.shapes.core[touch.is_of_b ? touch.parts.a : touch.parts.b] == Core::kHalfPlane) {
    const Pose corner_at =
        touch.is_of_b ? g.part_pose(b, touch.parts.b, pose_b) : g.part_pose(a, touch.parts.a, pose_a);
    const ShapeIndex of_corner = touch.is_of_b ? touch.parts.b : touch.parts.a;
    corner = corner_at.position - face_at.position +
             corner_at.turned(g.shapes.corners_of(of_corner)[touch.corner].vertex);
  }
  Pose face_at;
  const Corner& face;
  bool of_half_plane;
  Vec2 corner;  // m, in the plane's directions
};

}  // namespace

std::optional<CornerOnFace> corner_on_face(const Geometry& g, BodyIndex a, const Pose& pose_a, BodyIndex b,
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
    return CornerOnFace{parts, !plane_is_b, low ? end_of(shapes, body, features.of_b) : features.of_b, 0};
  }
  const int of_a = low ? features.of_a : end_of(shapes, parts.a, features.of_a);
  const int of_b = low ? end_of(shapes, parts.b, features.of_b) : features.of_b;
  const Pose at_a = g.part_pose(a, parts.a, pose_a);
  const Pose at_b = g.part_pose(b, parts.b, pose_b);
  // The stretch that the faces share ends with that of the two corners which lies further in.
  const Vec2 along = crossed(at_a.turned(shapes.corners_of(parts.a)[features.of_a].normal));
  const double ahead =
      along.dot(vertex_of(shapes, parts.b, at_b, of_b) - vertex_of(shapes, parts.a, at_a, of_a));
  if (low ? ahead >= 0.0 : ahead <= 0.0) return CornerOnFace{parts, true, of_b, features.of_a};
  return CornerOnFace{parts, false, of_a, features.of_b};
}

double beyond_face(const Geometry& g, BodyIndex a, const Pose& pose_a, BodyIndex b, const Pose& pose_b,
                   const CornerOnFace& touch) {
  const CornerAndFace at(g, a, pose_a, b, pose_b, touch);
  if (at.of_half_plane) return 0.0;
  const double place = cross(at.face.normal, at.face_at.turned_back(at.corner) - at.face.vertex);
  return place - std::clamp(place, 0.0, at.face.length);
}

Contact contact_on_line(const Geometry& g, BodyIndex a, const Pose& pose_a, BodyIndex b, const Pose& pose_b,
                        const CornerOnFace& touch) {
  const CornerAndFace at(g, a, pose_a, b, pose_b, touch);
  const Vec2 out = at.face_at.turned(at.face.normal);
  const double gap = out.dot(at.corner) - at.face.normal.dot(at.face.vertex);
  const Vec2 point = at.face_at.position + at.corner - 0.5 * gap * out;
  return {gap, touch.is_of_b ? out : Vec2(-out), point, touch.parts};
}

}  // namespace carom
