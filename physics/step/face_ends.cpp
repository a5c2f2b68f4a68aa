#include "physics/step/face_ends.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "physics/dynamics/integrators/integrators.h"
#include "physics/math/roots.h"
#include "physics/math/vectors.h"
#include "physics/model/pair_size.h"
#include "physics/step/contact_sides.h"
#include "physics/step/pair_motion.h"

namespace carom {
namespace {

// Relative to the size: what is so near the end of a face has reached it.
constexpr double kAtEnd = 1e-12;
// Likewise for a corner: its contact ends so far before, where the manifold still has the face's normal, and
// nearer ones have reached the end. Beyond, faces that nearly touch beside the corner may be taken.
constexpr double kBeforeEnd = 2.5e-10;
constexpr double kCornerAtEnd = 3e-10;
// Likewise, beside half the gap: what touches at a corner so near may leave it.
constexpr double kLeaves = 4e-10;
// rad: corners that turn by less are no ends; the normal turns there as along a curve.
constexpr double kLeastCorner = 1e-6;
// m: of a place along the face, how far it is to the end that the touch comes to.
double left_to(const TouchNearEnd& touch, double place) {
  const double end = touch.towards_end != touch.comes_on ? touch.on.face.length : 0.0;
  return touch.towards_end ? end - place : place - end;
}

// A touch on its way to an end of a face.
struct Coming {
  TouchNearEnd touch;
  double left = 0.0;   // m, to that end
  double reach = 0.0;  // m, that it may go within the step
};
Coming coming_to_end(const World& world, const TouchOnFace& on, const FoundContacts& found, int i, double h,
                     bool comes_on = false) {
  const Motion toucher = world.trajectories.at_start(on.toucher);
  const Motion body = world.trajectories.at_start(on.body);
  const double speed = speed_along(world, on, toucher, body);
  const TouchNearEnd touch{on, speed > 0.0, false, comes_on};
  const double press = std::abs(found.press[static_cast<std::size_t>(i)]);
  // Forces may double the speed.
  return {touch, left_to(touch, place_along(world, on, toucher, body)),
          (2.0 * std::abs(speed) + press * h) * h};
}

// Where contact i is that of a disc with a corner: the faces that go on from this corner, its own and those of
// other parts, to which it may come within h s.
void add_faces_beside(const World& world, const FoundContacts& found, int i, const Neighbours& neighbours,
                      double h, std::vector<TouchNearEnd>& touches) {
  const Geometry& g = world.shapes();
  const ContactSides sides = sides_of(world, found, i);
  const bool disc_is_b = is_round(g.shapes, sides.b.part);
  const ContactSide& disc = disc_is_b ? sides.b : sides.a;
  const ContactSide& side = disc_is_b ? sides.a : sides.b;
  if (!is_round(g.shapes, disc.part)) return;
  // A method of order 1 leaves the corner by as much as a shorter step would mend.
  if (choice_of(kIntegrators, world.method.integrator).order == 1) return;
  const double size = pair_size(world.shapes(), disc.body, side.body);
  const Vec2 point = found.point[static_cast<std::size_t>(i)];
  const Corner* corner = corner_at(g.shapes, side.part, side.of_part(point), kAtCorner * size);
  if (corner == nullptr) return;
  const Corner& before = corner_before(g.shapes, side.part, *corner);
  const bool as_along_a_curve = corner->normal.dot(before.normal) > std::cos(kLeastCorner);
  const Vec2 vertex = side.pose.position + side.pose.turned(corner->vertex);
  const auto look = [&](BodyIndex body) {
    g.each_part(body, [&](ShapeIndex part) {
      if (!has_faces(g.shapes, part)) return;
      if (body == side.body && part == side.part && as_along_a_curve) return;
      const Pose pose = g.part_pose(body, part, pose_at_start(world, body));
      const Vec2 at = pose.turned_back(Vec2(vertex - pose.position));
      const double tolerance = kFlush * size + 1e-12 * vertex.lpNorm<1>();
      const Corner* corners = g.shapes.corners_of(part);
      for (int k = 0; k < g.shapes.corners[part]; ++k) {
        const Face face{part, corners[k].normal, corners[k].vertex, corners[k].length};
        const bool from_start = (face.at(0.0) - at).norm() <= tolerance;
        const bool from_end = (face.at(face.length) - at).norm() <= tolerance;
        if (!(face.length > 0.0) || from_start == from_end) continue;
        if (!(pose.turned(face.normal).dot(side.out) > 0.0)) continue;
        const Coming coming =
            coming_to_end(world, {.toucher = disc.body, .toucher_part = disc.part, .body = body, .face = face},
                          found, i, h, true);
        if (coming.touch.towards_end == from_start && coming.left > kFlush * size &&
            coming.left <= coming.reach)
          touches.push_back(coming.touch);
      }
    });
  };
  look(side.body);
  const auto [a, b] = std::minmax(disc.body, side.body);
  for (const BodyIndex other : neighbours.of_pair(world, a, b)) {
    if (other != a && other != b && world.can_collide(other, disc.body)) look(other);
  }
}

// Whether the face ends at its start or end: no other face or body goes on from there.
bool ends_there(World& world, const TouchNearEnd& touch, double time, const Neighbours& neighbours) {
  const Geometry& g = world.shapes();
  const TouchOnFace& on = touch.on;
  const Face& face = on.face;
  const double sign = touch.towards_end ? 1.0 : -1.0;
  const Vec2 turned = turned_by(sign * kLeastCorner, face.normal);
  const Corner* corner = g.shapes.corners_of(face.part);
  for (int k = 0; k < g.shapes.corners[face.part]; ++k) {
    const Vec2& n = corner[k].normal;
    if (corner[k].length > 0.0 && (n - face.normal).norm() > kOnFace &&
        n.dot(face.normal) > turned.dot(face.normal) && sign * cross(face.normal, n) > 0.0)
      return false;
  }
  const auto pose = [&](BodyIndex i) { return g.pose(i, world.trajectories.place(i, time)); };
  const auto [a, b] = std::minmax(on.body, on.toucher);
  // What moves against the body has another surface in the next moment.
  std::vector<BodyIndex> together;
  for (const BodyIndex other : neighbours.of_pair(world, a, b)) {
    if (world.stay_together(on.body, other) || world.move_as_one(on.body, other)) together.push_back(other);
  }
  return !goes_on_past(world, on.body, face, touch.towards_end, on.toucher, on.toucher_part, together, pose);
}

// Two corners that leave each other: each moves out of the other body.
struct LeavingCorners {
  Vec2 point;         // m
  ContactSides past;  // past the corner of each
};
// Those of contact i that are within `near` m of it, if they do so within h s by more than that.
std::optional<LeavingCorners> leaving_corners(const World& world, const FoundContacts& found, int i, double h,
                                              double near) {
  const ConvexShapes& shapes = world.shapes().shapes;
  const auto is_sharp = [&](ShapeIndex part) {
    return shapes.rounding[part] == 0.0 && shapes.core[part] != Core::kHalfPlane;
  };
  LeavingCorners leaving{found.point[static_cast<std::size_t>(i)], sides_of(world, found, i)};
  auto& [a, b] = leaving.past;
  if (!is_sharp(a.part) || !is_sharp(b.part)) return std::nullopt;
  const auto velocity = [&](BodyIndex body) {
    const Motion y = world.trajectories.at_start(body);
    return Vec2(y.segment<2>(3) + y[5] * crossed(Vec2(leaving.point - y.head<2>())));
  };
  const auto moves_out = [&](ContactSide& side, const Vec2& away) {
    // A point of no size is its own corner, without a face.
    if (is_round(shapes, side.part)) return true;
    const Corner* corner = corner_at(shapes, side.part, side.of_part(leaving.point), near);
    if (corner == nullptr) return false;
    const Corner& before = corner_before(shapes, side.part, *corner);
    // What leaves along the contact's normal may come back to the same face.
    const auto along = [&](const Vec2& normal_of_part) {
      const Vec2 normal = side.pose.turned(normal_of_part);
      return (normal - side.out).norm() <= kOnFace ? 0.0 : normal.dot(away);
    };
    const double out = std::max(along(corner->normal), along(before.normal));
    side.out = turned_by(cross(side.out, away) > 0.0 ? kBeyond : -kBeyond, side.out);
    return h * out > near;
  };
  const Vec2 u = velocity(b.body) - velocity(a.body);
  if (!moves_out(a, u) || !moves_out(b, -u)) return std::nullopt;
  return leaving;
}

// Whether no other contact of its bodies has pressed up to now.
bool carries_alone(const FoundContacts& found, int i) {
  const Contacts& c = found.contacts;
  for (int k = 0; k < c.size(); ++k) {
    const bool joins = c.a[k] == c.a[i] || c.b[k] == c.b[i] || c.a[k] == c.b[i] || c.b[k] == c.a[i];
    if (joins && (found.guess[static_cast<std::size_t>(k)][0] > 0.0) == (k != i)) return false;
  }
  return true;
}

}  // namespace

void find_touches_near_ends(const World& world, const FoundContacts& found, const Neighbours& neighbours,
                            double h, std::vector<TouchNearEnd>& touches) {
  touches.clear();
  for (int i = 0; i < found.contacts.size(); ++i) {
    const std::optional<TouchOnFace> on = touch_on_face(world, found, i);
    if (!on) {
      add_faces_beside(world, found, i, neighbours, h, touches);
      continue;
    }
    Coming coming = coming_to_end(world, *on, found, i, h);
    if (!(coming.left <= coming.reach && coming.left > -past_seam(world, *on))) continue;
    const Geometry& g = world.shapes();
    const double at_end = on->is_corner(world) ? kCornerAtEnd * pair_size(g, on->body, on->toucher)
                                               : kAtEnd * (g.size[on->body] + g.size[on->toucher]);
    if (coming.left <= at_end) add_faces_beside(world, found, i, neighbours, h, touches);
    TouchNearEnd& touch = coming.touch;
    touch.law_changes =
        world.model->surfaces.materials > 1 && law_changes(world, *on, touch.towards_end, neighbours);
    // Two faces part where the last corner of the one comes to the end of the other. The first one that comes
    // there stays behind, which matters where nothing else carries the load.
    const bool ends = !on->flat || on->to_end == touch.towards_end || carries_alone(found, i);
    if (touch.law_changes || (ends && coming.left > at_end)) touches.push_back(touch);
  }
}

double first_face_end(World& world, const std::vector<TouchNearEnd>& touches, const Neighbours& neighbours,
                      double h) {
  double first = h;
  for (const TouchNearEnd& touch : touches) {
    const TouchOnFace& on = touch.on;
    const double before =
        on.is_corner(world) ? kBeforeEnd * pair_size(world.shapes(), on.body, on.toucher) : 0.0;
    const double place = touch.law_changes ? past_seam(world, on) : -before;
    const auto left = [&](double t) {
      return place + left_to(touch, place_along(world, on, world.trajectories.at(on.toucher, t),
                                                world.trajectories.at(on.body, t)));
    };
    const double now = left(0.0);
    const double then = left(first);
    if (!(now > 0.0 && then < 0.0)) continue;
    const double time = bracketed_root(left, 0.0, now, first, then);
    if (touch.law_changes || touch.comes_on || ends_there(world, touch, time, neighbours)) first = time;
  }
  return first;
}

bool has_passed_on(const World& world, const FoundContacts& found, int i) {
  if (found.contacts.size() > kFewContactsOfScene) return false;
  const ConvexShapes& shapes = world.shapes().shapes;
  const ContactSides own = sides_of(world, found, i);
  if (is_round(shapes, own.a.part) == is_round(shapes, own.b.part)) return false;
  const ContactSide& disc = is_round(shapes, own.a.part) ? own.a : own.b;
  const auto point = [&](int k) { return found.point[static_cast<std::size_t>(k)]; };
  const double near = kFlush * pair_size(world.shapes(), own.a.body, own.b.body) + 1e-12 * point(i).lpNorm<1>();
  const auto is_at_it = [&](int k) {
    if (k == i || (point(k) - point(i)).norm() > near) return false;
    const ContactSides other = sides_of(world, found, k);
    const auto is_same = [&](const ContactSide& side) {
      return side.part == disc.part && (side.out - disc.out).norm() <= kOnFace;
    };
    return is_same(other.a) || is_same(other.b);
  };
  for (int k = 0; k < found.contacts.size(); ++k) {
    if (is_at_it(k) && !touch_on_face(world, found, i) && touch_on_face(world, found, k)) return true;
  }
  return false;
}

bool leaves_corner(const World& world, const FoundContacts& found, int i, const Neighbours& neighbours,
                   double h) {
  const Contacts& c = found.contacts;
  const double size = pair_size(world.shapes(), c.a[i], c.b[i]);
  const auto half_gap = [&](int k) { return 0.5 * std::abs(c.gap[k]); };
  // Another contact of theirs at this place, on the same face, goes on.
  const double flush = kFlush * size;
  const auto leaves = [&](int k) {
    return leaving_corners(world, found, k, h, flush + half_gap(k)).has_value();
  };
  const auto point = [&](int k) { return found.point[static_cast<std::size_t>(k)]; };
  const auto takes_over = [&](int k) {
    return k != i && c.a[k] == c.a[i] && c.b[k] == c.b[i] && (point(k) - point(i)).norm() <= flush &&
           (c.normal[k] - c.normal[i]).norm() <= kOnFace && !leaves(k);
  };
  if (leaves(i)) {
    for (int k = 0; k < c.size(); ++k) {
      if (takes_over(k)) return true;
    }
  }
  const auto leaving = leaving_corners(world, found, i, h, kLeaves * size + half_gap(i));
  if (!leaving) return false;
  const auto others = neighbours.of_pair(world, c.a[i], c.b[i]);
  const auto is_bare = [&](const ContactSide& past, const ContactSide& other) {
    return is_round(world.shapes().shapes, past.part) ||
           !goes_on(world, past, other, past.of_part(leaving->point), others,
                    [&](BodyIndex body) { return pose_at_start(world, body); });
  };
  const auto& [past_a, past_b] = leaving->past;
  return is_bare(past_a, past_b) && is_bare(past_b, past_a);
}

}  // namespace carom
