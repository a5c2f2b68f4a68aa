#include "physics/step/touch_on_face.h"

#include <algorithm>
#include <cmath>

#include "physics/math/vectors.h"
#include "physics/model/pair_size.h"
#include "physics/step/pair_motion.h"

namespace carom {
namespace {

// Relative to the size of what slides or rolls over a seam.
constexpr double kPastSeam = 2e-7;

// Contact i as that of a tip of the other side on this face.
std::optional<TouchOnFace> touch_by(const World& world, const FoundContacts& found, int i, const Face& face,
                                    const ContactSide& own, const ContactSide& other) {
  const ConvexShapes& shapes = world.shapes().shapes;
  TouchOnFace on{.toucher = other.body, .toucher_part = other.part, .body = own.body, .face = face};
  if (!is_round(shapes, other.part)) {
    const Vec2 point = found.point[static_cast<std::size_t>(i)] - shapes.rounding[other.part] * other.out;
    const Corner* corner = core_corner_at(shapes, other.part, other.of_part(point),
                                          kAtCorner * pair_size(world.shapes(), own.body, other.body));
    if (corner == nullptr) return std::nullopt;
    on.tip = corner->vertex;
  }
  return on;
}

// m, in the plane.
Vec2 place_of_tip(const World& world, const TouchOnFace& on, const Motion& toucher) {
  const Geometry& g = world.shapes();
  const Pose pose = g.part_pose(on.toucher, on.toucher_part, g.pose(on.toucher, toucher.head<3>()));
  return pose.position + pose.turned(on.tip);
}

// Whether it moves away from the middle of its face.
bool runs_off(const World& world, const TouchOnFace& on) {
  const Motion toucher = world.trajectories.at_start(on.toucher);
  const Motion body = world.trajectories.at_start(on.body);
  const double from_middle = place_along(world, on, toucher, body) - 0.5 * on.face.length;
  return from_middle * speed_along(world, on, toucher, body) > 0.0;
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

}  // namespace

std::optional<TouchOnFace> touch_on_face(const World& world, const FoundContacts& found, int i) {
  const ConvexShapes& shapes = world.shapes().shapes;
  const auto [a, b] = sides_of(world, found, i);
  const std::optional<Face> of_a = a.face(shapes);
  const std::optional<Face> of_b = b.face(shapes);
  std::optional<TouchOnFace> on_a, on_b;
  if (of_a) on_a = touch_by(world, found, i, *of_a, a, b);
  if (of_b) on_b = touch_by(world, found, i, *of_b, b, a);
  if (on_a && on_b) {
    const Vec2 point = found.point[static_cast<std::size_t>(i)];
    const double by_b = (on_a->tip - b.of_part(point)).norm();
    const double by_a = (on_b->tip - a.of_part(point)).norm();
    // Two corners at one place: the one that comes to the end of its face, where another may go on.
    const bool at_once = std::max(by_a, by_b) <= past_seam(world, *on_a);
    const bool on_a_stays = at_once ? runs_off(world, *on_a) : by_b < by_a;
    (on_a_stays ? on_b : on_a).reset();
  }
  std::optional<TouchOnFace>& on = on_a ? on_a : on_b;
  if (!on || !of_a || !of_b) return on;
  on->flat = true;
  // The two faces go around their bodies in opposite directions.
  const Face& own = on_a ? *of_b : *of_a;
  on->to_end = own.place_of(on->tip) > 0.5 * own.length;
  return on;
}

double place_along(const World& world, const TouchOnFace& on, const Motion& toucher, const Motion& body) {
  const Geometry& g = world.shapes();
  const Pose of_face = g.part_pose(on.body, on.face.part, g.pose(on.body, body.head<3>()));
  const Vec2 tip = place_of_tip(world, on, toucher);
  return on.face.place_of(of_face.turned_back(Vec2(tip - of_face.position)));
}

double speed_along(const World& world, const TouchOnFace& on, const Motion& toucher, const Motion& body) {
  const Vec2 tip = place_of_tip(world, on, toucher);
  const Vec2 u = toucher.segment<2>(3) + toucher[5] * crossed(Vec2(tip - toucher.head<2>())) -
                 body.segment<2>(3) - body[5] * crossed(Vec2(tip - body.head<2>()));
  return u.dot(crossed(turned_by(body[2], on.face.normal)));
}

double past_seam(const World& world, const TouchOnFace& on) {
  const double size = world.shapes().size[on.toucher];
  return std::max(kPastSeam * size, 4.0 * kFlush * pair_size(world.shapes(), on.body, on.toucher));
}

bool law_changes(const World& world, const TouchOnFace& on, bool at_end, const Neighbours& neighbours) {
  const Geometry& g = world.shapes();
  const auto pose = [&](BodyIndex body, ShapeIndex part) {
    return g.part_pose(body, part, pose_at_start(world, body));
  };
  const Pose of_face = pose(on.body, on.face.part);
  const double past = past_seam(world, on);
  const Vec2 point = of_face.position + of_face.turned(on.face.at(at_end ? on.face.length + past : -past));
  const Vec2 normal = of_face.turned(on.face.normal);
  const SurfaceLaw& law = law_on(world, on, on.body, on.face.part);
  bool changes = false;
  const auto look = [&](BodyIndex body) {
    g.each_part(body, [&](ShapeIndex part) {
      if ((body == on.body && part == on.face.part) || !has_faces(g.shapes, part) || changes) return;
      const Pose there = pose(body, part);
      const std::optional<Face> face = face_with(g.shapes, part, there.turned_back(normal));
      if (!face) return;
      const Vec2 at = there.turned_back(Vec2(point - there.position));
      const double place = face->place_of(at);
      const double tolerance =
          kFlush * pair_size(world.shapes(), on.body, on.toucher) + 1e-12 * point.lpNorm<1>();
      changes = std::abs(face->normal.dot(at - face->vertex)) <= tolerance && place >= 0.0 &&
                place <= face->length && law_on(world, on, body, part) != law;
    });
  };
  if (g.has_parts(on.body)) look(on.body);
  const auto [a, b] = std::minmax(on.toucher, on.body);
  for (const BodyIndex other : neighbours.of_pair(world, a, b)) {
    if (other != a && other != b && world.can_collide(other, on.toucher)) look(other);
  }
  return changes;
}

}  // namespace carom
