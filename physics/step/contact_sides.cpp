#include "physics/step/contact_sides.h"

#include <algorithm>

#include "physics/step/pair_motion.h"

namespace carom {

std::optional<Face> face_with(const ConvexShapes& shapes, ShapeIndex part, const Vec2& normal) {
  const Corner* corner = shapes.corners_of(part);
  for (int k = 0; k < shapes.corners[part]; ++k) {
    if (corner[k].length > 0.0 && (corner[k].normal - normal).norm() <= kOnFace)
      return Face{part, corner[k].normal, corner[k].vertex, corner[k].length};
  }
  return std::nullopt;
}

const Corner* core_corner_at(const ConvexShapes& shapes, ShapeIndex part, const Vec2& point, double near) {
  if (!has_faces(shapes, part)) return nullptr;
  const Corner* corner = shapes.corners_of(part);
  const auto distance = [&](const Corner& c) { return (c.vertex - point).norm(); };
  const Corner* nearest =
      std::min_element(corner, corner + shapes.corners[part],
                       [&](const Corner& one, const Corner& other) { return distance(one) < distance(other); });
  return distance(*nearest) <= near ? nearest : nullptr;
}

const Corner* corner_at(const ConvexShapes& shapes, ShapeIndex part, const Vec2& point, double near) {
  return shapes.rounding[part] > 0.0 ? nullptr : core_corner_at(shapes, part, point, near);
}

const Corner& corner_before(const ConvexShapes& shapes, ShapeIndex part, const Corner& corner) {
  const Corner* first = shapes.corners_of(part);
  return &corner == first ? first[shapes.corners[part] - 1] : *(&corner - 1);
}

ContactSides sides_of(const World& world, const FoundContacts& found, int i) {
  const Geometry& g = world.shapes();
  const BodyIndex a = found.contacts.a[i];
  const BodyIndex b = found.contacts.b[i];
  const auto parts = parts_at(g, a, b, found.id[static_cast<std::size_t>(i)]);
  const auto pose = [&](BodyIndex body, ShapeIndex part) {
    return g.part_pose(body, part, pose_at_start(world, body));
  };
  const Vec2 n = found.contacts.normal[i];
  return {{a, parts.a, pose(a, parts.a), n}, {b, parts.b, pose(b, parts.b), -n}};
}

}  // namespace carom
