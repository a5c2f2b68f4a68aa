#include "physics/step/face_ends.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "physics/collision/pair_contact.h"
#include "physics/math/roots.h"
#include "physics/math/vectors.h"
#include "physics/step/internal_edges.h"
#include "physics/step/pair_motion.h"

namespace carom {
namespace {

// Relative to the size: what is so near the end of a face has reached it.
constexpr double kAtEnd = 1e-12;
// Likewise for a corner: its contact ends so far before, where the manifold still has the face's normal, and
// nearer ones have reached the end. Beyond, faces that nearly touch beside the corner may be taken.
constexpr double kBeforeEnd = 2.5e-5;
constexpr double kCornerAtEnd = 3e-5;
// Sine by which a normal and that of a face differ at most.
constexpr double kOnFace = 1e-7;
// Relative to the size of what slides or rolls over a seam.
constexpr double kPastSeam = 2e-7;
// Likewise: a corner so near a contact is the one that touches.
constexpr double kAtCorner = 4e-5;
// rad: corners that turn by less are no ends; the normal turns there as along a curve.
constexpr double kLeastCorner = 0.2;
// rad: beyond an end the normal turns to this side of the face's own; far enough to tell a corner from
// rounding.
constexpr double kBeyond = 0.05;

// The face that has this outward normal in its body's frame.
std::optional<TouchOnFace> face_with(const ConvexShapes& shapes, ShapeIndex part, const Vec2& normal) {
  const Corner* corner = shapes.corners_of(part);
  for (int k = 0; k < shapes.corners[part]; ++k) {
    if (corner[k].length > 0.0 && (corner[k].normal - normal).norm() <= kOnFace)
      return TouchOnFace{
          .part = part, .normal = corner[k].normal, .vertex = corner[k].vertex, .length = corner[k].length};
  }
  return std::nullopt;
}

double sizes(const World& world, BodyIndex a, BodyIndex b) {
  return world.shapes().size[a] + world.shapes().size[b];
}

bool is_round(const ConvexShapes& shapes, ShapeIndex part) { return shapes.core[part] == Core::kPoint; }

bool has_faces(const ConvexShapes& shapes, ShapeIndex part) {
  return shapes.edges(part) > 0 && shapes.core[part] != Core::kHalfPlane;
}

// The corner of a part without rounding that is within `near` m of this point of its frame.
const Corner* corner_at(const ConvexShapes& shapes, ShapeIndex part, const Vec2& point, double near) {
  if (!has_faces(shapes, part) || shapes.rounding[part] > 0.0) return nullptr;
  const Corner* corner = shapes.corners_of(part);
  const Corner* end = corner + shapes.corners[part];
  const Corner* found =
      std::find_if(corner, end, [&](const Corner& c) { return (c.vertex - point).norm() <= near; });
  return found == end ? nullptr : found;
}

// The two parts of a contact with their poses at the start, and the normals out of each.
struct Sides {
  struct Side {
    BodyIndex body;
    ShapeIndex part;
    Pose pose;
    Vec2 out;  // of the plane
    [[nodiscard]] std::optional<TouchOnFace> face(const ConvexShapes& shapes) const {
      return has_faces(shapes, part) ? face_with(shapes, part, pose.turned_back(out)) : std::nullopt;
    }
    [[nodiscard]] Vec2 of_part(const Vec2& point) const {
      return pose.turned_back(Vec2(point - pose.position));
    }
  };
  Side a, b;
};

Sides sides_of(const World& world, const FoundContacts& found, int i) {
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

// Contact i as that of a disc or a corner of the other side on this face.
std::optional<TouchOnFace> touch_by(const World& world, const FoundContacts& found, int i, TouchOnFace face,
                                    const Sides::Side& own, const Sides::Side& other) {
  const ConvexShapes& shapes = world.shapes().shapes;
  if (!is_round(shapes, other.part)) {
    const Corner* corner =
        corner_at(shapes, other.part, other.of_part(found.point[static_cast<std::size_t>(i)]),
                  kAtCorner * sizes(world, own.body, other.body));
    if (corner == nullptr) return std::nullopt;
    face.tip = corner->vertex;
  }
  face.toucher = other.body;
  face.toucher_part = other.part;
  face.body = own.body;
  return face;
}

// Where corners of both are near, it is the nearer one that touches.
std::optional<TouchOnFace> touch_on_face(const World& world, const FoundContacts& found, int i) {
  const ConvexShapes& shapes = world.shapes().shapes;
  const auto [a, b] = sides_of(world, found, i);
  const std::optional<TouchOnFace> of_a = a.face(shapes);
  const std::optional<TouchOnFace> of_b = b.face(shapes);
  std::optional<TouchOnFace> on_a, on_b;
  if (of_a) on_a = touch_by(world, found, i, *of_a, a, b);
  if (of_b) on_b = touch_by(world, found, i, *of_b, b, a);
  if (on_a && on_b) {
    const Vec2 point = found.point[static_cast<std::size_t>(i)];
    const double by_b = (on_a->tip - b.of_part(point)).norm();
    const double by_a = (on_b->tip - a.of_part(point)).norm();
    (by_b < by_a ? on_b : on_a).reset();
  }
  std::optional<TouchOnFace>& on = on_a ? on_a : on_b;
  if (on) on->flat = of_a && of_b;
  return on;
}

// m, in the plane.
Vec2 place_of_tip(const World& world, const TouchOnFace& on, const Motion& toucher) {
  const Geometry& g = world.shapes();
  const Pose pose = g.part_pose(on.toucher, on.toucher_part, g.pose(on.toucher, toucher.head<3>()));
  return pose.position + pose.turned(on.tip);
}

// m: where the disc or corner is along the face, from its start.
double place_along(const World& world, const TouchOnFace& on, const Motion& toucher, const Motion& body) {
  const Geometry& g = world.shapes();
  const Pose of_face = g.part_pose(on.body, on.part, g.pose(on.body, body.head<3>()));
  const Vec2 tip = place_of_tip(world, on, toucher);
  return cross(on.normal, Vec2(of_face.turned_back(Vec2(tip - of_face.position)) - on.vertex));
}

// m/s: how fast, about.
double speed_along(const World& world, const TouchOnFace& on, const Motion& toucher, const Motion& body) {
  const Vec2 tip = place_of_tip(world, on, toucher);
  const Vec2 u = toucher.segment<2>(3) + toucher[5] * crossed(Vec2(tip - toucher.head<2>())) -
                 body.segment<2>(3) - body[5] * crossed(Vec2(tip - body.head<2>()));
  return u.dot(crossed(turned_by(body[2], on.normal)));
}

// m: of a place along the face, how far beyond the end that it moves to.
double beyond(const TouchOnFace& on, double place) { return on.towards_end ? place - on.length : -place; }

bool is_corner(const World& world, const TouchOnFace& on) {
  return !is_round(world.shapes().shapes, on.toucher_part);
}

const SurfaceLaw& law_on(const World& world, const TouchOnFace& on, BodyIndex body, ShapeIndex part) {
  Contact contact;
  if (on.toucher < body) {
    contact.parts = {on.toucher_part, part};
    return world.material(contact, on.toucher, body);
  }
  contact.parts = {part, on.toucher_part};
  return world.material(contact, body, on.toucher);
}

// m: so far beyond the end of a face only the next one is touched.
double past_seam(const World& world, const TouchOnFace& on) {
  const double size = world.shapes().size[on.toucher];
  return std::max(kPastSeam * size, 4.0 * kFlush * sizes(world, on.body, on.toucher));
}

// Whether another part, of the body or of another one, goes on with the face beyond the end to which the
// contact moves, under another law.
bool changes_there(const World& world, const TouchOnFace& on, const Neighbours& neighbours) {
  const Geometry& g = world.shapes();
  const auto pose = [&](BodyIndex body, ShapeIndex part) {
    return g.part_pose(body, part, pose_at_start(world, body));
  };
  const Pose of_face = pose(on.body, on.part);
  const double past = past_seam(world, on);
  const Vec2 along = crossed(on.normal);
  const Vec2 beyond =
      on.towards_end ? Vec2(on.vertex + (on.length + past) * along) : Vec2(on.vertex - past * along);
  const Vec2 point = of_face.position + of_face.turned(beyond);
  const Vec2 normal = of_face.turned(on.normal);
  const SurfaceLaw& law = law_on(world, on, on.body, on.part);
  bool changes = false;
  const auto look = [&](BodyIndex body) {
    g.each_part(body, [&](ShapeIndex part) {
      if ((body == on.body && part == on.part) || !has_faces(g.shapes, part) || changes) return;
      const Pose there = pose(body, part);
      const std::optional<TouchOnFace> face = face_with(g.shapes, part, there.turned_back(normal));
      if (!face) return;
      const Vec2 d = there.turned_back(Vec2(point - there.position)) - face->vertex;
      const double place = cross(face->normal, d);
      const double tolerance = kFlush * sizes(world, on.body, on.toucher) + 1e-12 * point.lpNorm<1>();
      changes = std::abs(face->normal.dot(d)) <= tolerance && place >= 0.0 && place <= face->length &&
                law_on(world, on, body, part) != law;
    });
  };
  if (g.has_parts(on.body)) look(on.body);
  const auto [a, b] = std::minmax(on.toucher, on.body);
  for (const BodyIndex other : neighbours.of_pair(world, a, b)) {
    if (other != a && other != b && world.can_collide(other, on.toucher)) look(other);
  }
  return changes;
}

// Whether another part goes on with the surface of a side at this corner of it: the other side leaves no
// contact with the side's normal, which is that of what lies beyond.
template <class PoseOf>
bool goes_on(const World& world, const Sides::Side& side, const Sides::Side& other, const Vec2& corner,
             const Neighbours& neighbours, const PoseOf& pose) {
  const Geometry& g = world.shapes();
  const bool first = side.body < other.body;
  const auto [a, b] = std::minmax(side.body, other.body);
  Contact contact{0.0, first ? side.out : Vec2(-side.out), side.pose.position + side.pose.turned(corner)};
  if (g.has_parts(a) || g.has_parts(b))
    contact.parts = first ? ShapePair{side.part, other.part} : ShapePair{other.part, side.part};
  return on_internal_edge(world, a, b, contact, neighbours.of_pair(world, a, b), pose);
}

// Whether the face ends at its start or end: no other face or body goes on from there.
bool ends_there(World& world, const TouchOnFace& on, double time, const Neighbours& neighbours) {
  const Geometry& g = world.shapes();
  const Vec2 turned = turned_by(on.towards_end ? kLeastCorner : -kLeastCorner, on.normal);
  const Corner* corner = g.shapes.corners_of(on.part);
  for (int k = 0; k < g.shapes.corners[on.part]; ++k) {
    const Vec2& n = corner[k].normal;
    if (corner[k].length > 0.0 && (n - on.normal).norm() > kOnFace &&
        n.dot(on.normal) > turned.dot(on.normal) && cross(on.normal, n) * (on.towards_end ? 1.0 : -1.0) > 0.0)
      return false;
  }
  const auto pose = [&](BodyIndex i) { return g.pose(i, world.trajectories.at(i, time).head<3>()); };
  const Pose of_face = g.part_pose(on.body, on.part, pose(on.body));
  const Vec2 end = on.towards_end ? Vec2(on.vertex + on.length * crossed(on.normal)) : on.vertex;
  const Vec2 past = turned_by(on.towards_end ? kBeyond : -kBeyond, on.normal);
  return !goes_on(world, {on.body, on.part, of_face, of_face.turned(past)},
                  {on.toucher, on.toucher_part, {}, {}}, end, neighbours, pose);
}

}  // namespace

void find_touches_near_ends(const World& world, const FoundContacts& found, const Neighbours& neighbours,
                            double h, std::vector<TouchOnFace>& touches) {
  touches.clear();
  for (int i = 0; i < found.contacts.size(); ++i) {
    std::optional<TouchOnFace> on = touch_on_face(world, found, i);
    if (!on) continue;
    const Motion toucher = world.trajectories.at_start(on->toucher);
    const Motion body = world.trajectories.at_start(on->body);
    const double speed = speed_along(world, *on, toucher, body);
    on->towards_end = speed > 0.0;
    on->left = -beyond(*on, place_along(world, *on, toucher, body));
    const double at_end = (is_corner(world, *on) ? kCornerAtEnd : kAtEnd) * sizes(world, on->body, on->toucher);
    const double press = std::abs(found.press[static_cast<std::size_t>(i)]);
    // Forces may double the speed.
    const double reach = (2.0 * std::abs(speed) + press * h) * h;
    if (!(on->left <= reach && on->left > -past_seam(world, *on))) continue;
    on->changes = world.model->surfaces.materials > 1 && changes_there(world, *on, neighbours);
    if (on->changes || (!on->flat && on->left > at_end)) touches.push_back(*on);
  }
}

double first_face_end(World& world, const std::vector<TouchOnFace>& touches, const Neighbours& neighbours,
                      double h) {
  double first = h;
  for (const TouchOnFace& on : touches) {
    const double before = is_corner(world, on) ? kBeforeEnd * sizes(world, on.body, on.toucher) : 0.0;
    const double place = on.changes ? past_seam(world, on) : -before;
    const auto left = [&](double t) {
      return place - beyond(on, place_along(world, on, world.trajectories.at(on.toucher, t),
                                            world.trajectories.at(on.body, t)));
    };
    const double now = left(0.0);
    const double then = left(first);
    if (!(now > 0.0 && then < 0.0)) continue;
    const double time = bracketed_root(left, 0.0, now, first, then);
    if (on.changes || ends_there(world, on, time, neighbours)) first = time;
  }
  return first;
}

bool leaves_corner(const World& world, const FoundContacts& found, int i, const Neighbours& neighbours,
                   double h) {
  const ConvexShapes& shapes = world.shapes().shapes;
  const auto is_sharp = [&](ShapeIndex part) {
    return shapes.rounding[part] == 0.0 && shapes.core[part] != Core::kHalfPlane;
  };
  const auto parts =
      parts_at(world.shapes(), found.contacts.a[i], found.contacts.b[i], found.id[static_cast<std::size_t>(i)]);
  if (!is_sharp(parts.a) || !is_sharp(parts.b)) return false;
  const auto [a, b] = sides_of(world, found, i);
  const double near = kAtCorner * sizes(world, a.body, b.body);
  const Vec2 point = found.point[static_cast<std::size_t>(i)];
  const auto velocity = [&](BodyIndex body) {
    const Motion y = world.trajectories.at_start(body);
    return Vec2(y.segment<2>(3) + y[5] * crossed(Vec2(point - y.head<2>())));
  };
  const Vec2 u = velocity(b.body) - velocity(a.body);
  // A point of no size is its own corner, without a face.
  const auto moves_out = [&](const Sides::Side& side, const Sides::Side& other, const Vec2& away) {
    if (is_round(shapes, side.part)) return true;
    const Corner* corner = corner_at(shapes, side.part, side.of_part(point), near);
    if (corner == nullptr) return false;
    const Corner* first = shapes.corners_of(side.part);
    const Corner* before = corner == first ? first + shapes.corners[side.part] - 1 : corner - 1;
    if (h * std::max(side.pose.turned(corner->normal).dot(away), side.pose.turned(before->normal).dot(away)) <=
        near)
      return false;
    Sides::Side past = side;
    past.out = turned_by(cross(side.out, away) > 0.0 ? kBeyond : -kBeyond, side.out);
    return !goes_on(world, past, other, corner->vertex, neighbours,
                    [&](BodyIndex body) { return pose_at_start(world, body); });
  };
  return moves_out(a, b, u) && moves_out(b, a, -u);
}

}  // namespace carom
