#include "physics/step/face_ends.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "physics/collision/pair_contact.h"
#include "physics/math/roots.h"
#include "physics/math/vectors.h"

namespace carom {
namespace {

// Relative to the size: a disc so near the end of a face has reached it.
constexpr double kAtEnd = 1e-12;
// Sine by which a normal and that of a face differ at most.
constexpr double kDiscOnFace = 1e-7;
// rad: corners that turn by less are no ends; the normal turns there as along a curve.
constexpr double kLeastCorner = 0.2;
// rad: beyond an end the normal turns to this side of the face's own; far enough to tell a corner from
// rounding.
constexpr double kBeyond = 0.05;

// The face that has this outward normal in its body's frame.
std::optional<DiscOnFace> face_with(const ConvexShapes& shapes, ShapeIndex part, const Vec2& normal) {
  const Corner* corner = shapes.corners_of(part);
  for (int k = 0; k < shapes.corners[part]; ++k) {
    if (corner[k].length > 0.0 && (corner[k].normal - normal).norm() <= kDiscOnFace)
      return DiscOnFace{
          .part = part, .normal = corner[k].normal, .vertex = corner[k].vertex, .length = corner[k].length};
  }
  return std::nullopt;
}

bool is_disc(const ConvexShapes& shapes, ShapeIndex part) {
  return shapes.core[part] == Core::kPoint && shapes.rounding[part] > 0.0;
}

std::optional<DiscOnFace> disc_on_face(const World& world, const FoundContacts& found, int i) {
  const Geometry& g = world.shapes();
  const BodyIndex a = found.contacts.a[i];
  const BodyIndex b = found.contacts.b[i];
  const auto [part_a, part_b] = parts_at(g, a, b, found.id[static_cast<std::size_t>(i)]);
  const bool a_is_disc = is_disc(g.shapes, part_a);
  if (a_is_disc == is_disc(g.shapes, part_b)) return std::nullopt;
  const ShapeIndex part = a_is_disc ? part_b : part_a;
  const BodyIndex body = a_is_disc ? b : a;
  if (g.shapes.edges(part) == 0 || g.shapes.core[part] == Core::kHalfPlane) return std::nullopt;
  const Pose pose = g.pose(body, world.trajectories.at_start(body).head<3>());
  const Vec2 out = a_is_disc ? Vec2(-found.contacts.normal[i]) : Vec2(found.contacts.normal[i]);
  std::optional<DiscOnFace> face = face_with(g.shapes, part, pose.turned_back(out));
  if (!face) return std::nullopt;
  face->disc = a_is_disc ? a : b;
  face->disc_part = a_is_disc ? part_a : part_b;
  face->body = body;
  return face;
}

// m: where the disc is along the face, from its start.
double place_along(const World& world, const DiscOnFace& on, const Motion& disc, const Motion& body) {
  const Geometry& g = world.shapes();
  const Pose of_face = g.part_pose(on.body, on.part, g.pose(on.body, body.head<3>()));
  const Pose of_disc = g.part_pose(on.disc, on.disc_part, g.pose(on.disc, disc.head<3>()));
  return cross(on.normal, Vec2(of_face.turned_back(of_disc.position - of_face.position) - on.vertex));
}

// m/s: how fast, about.
double speed_along(const DiscOnFace& on, const Motion& disc, const Motion& body) {
  const Vec2 arm = disc.head<2>() - body.head<2>();
  const Vec2 u = disc.segment<2>(3) - body.segment<2>(3) - body[5] * crossed(arm);
  return u.dot(crossed(turned_by(body[2], on.normal)));
}

// m: of a place along the face, how far beyond the end that the disc moves to.
double beyond(const DiscOnFace& on, double place) { return on.towards_end ? place - on.length : -place; }

// Whether the face ends at its start or end for the disc: no other face or body goes on from there.
bool ends_there(World& world, const DiscOnFace& on, double time, const Neighbours& neighbours) {
  const Geometry& g = world.shapes();
  const Vec2 turned = turned_by(on.towards_end ? kLeastCorner : -kLeastCorner, on.normal);
  const Corner* corner = g.shapes.corners_of(on.part);
  for (int k = 0; k < g.shapes.corners[on.part]; ++k) {
    const Vec2& n = corner[k].normal;
    if (corner[k].length > 0.0 && (n - on.normal).norm() > kDiscOnFace &&
        n.dot(on.normal) > turned.dot(on.normal) && cross(on.normal, n) * (on.towards_end ? 1.0 : -1.0) > 0.0)
      return false;
  }
  const auto pose = [&](BodyIndex i) { return g.pose(i, world.trajectories.at(i, time).head<3>()); };
  const Pose of_face = g.part_pose(on.body, on.part, pose(on.body));
  const Vec2 end = on.towards_end ? Vec2(on.vertex + on.length * crossed(on.normal)) : on.vertex;
  const Vec2 out = of_face.turned(turned_by(on.towards_end ? kBeyond : -kBeyond, on.normal));
  const auto [a, b] = std::minmax(on.disc, on.body);
  Contact contact{0.0, a == on.body ? out : Vec2(-out), of_face.position + of_face.turned(end)};
  if (g.has_parts(a) || g.has_parts(b))
    contact.parts = a == on.body ? ShapePair{on.part, on.disc_part} : ShapePair{on.disc_part, on.part};
  return !on_internal_edge(world, a, b, contact, neighbours.of_pair(world, a, b), pose);
}

}  // namespace

void find_discs_near_ends(const World& world, const FoundContacts& found, double h,
                          std::vector<DiscOnFace>& discs) {
  discs.clear();
  for (int i = 0; i < found.contacts.size(); ++i) {
    std::optional<DiscOnFace> on = disc_on_face(world, found, i);
    if (!on) continue;
    const Motion disc = world.trajectories.at_start(on->disc);
    const Motion body = world.trajectories.at_start(on->body);
    const double speed = speed_along(*on, disc, body);
    on->towards_end = speed > 0.0;
    on->left = -beyond(*on, place_along(world, *on, disc, body));
    const double size = world.shapes().size[on->body] + world.shapes().size[on->disc];
    const double press = std::abs(found.press[static_cast<std::size_t>(i)]);
    // Forces may double the speed.
    if (on->left > kAtEnd * size && on->left <= (2.0 * std::abs(speed) + press * h) * h) discs.push_back(*on);
  }
}

double first_face_end(World& world, const std::vector<DiscOnFace>& discs, const Neighbours& neighbours,
                      double h) {
  double first = h;
  for (const DiscOnFace& on : discs) {
    const auto past = [&](double t) {
      return beyond(
          on, place_along(world, on, world.trajectories.at(on.disc, t), world.trajectories.at(on.body, t)));
    };
    const double then = past(first);
    if (!(then > 0.0)) continue;
    const double time = bracketed_root(past, 0.0, -on.left, first, then);
    if (ends_there(world, on, time, neighbours)) first = time;
  }
  return first;
}

}  // namespace carom
