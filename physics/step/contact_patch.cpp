#include "physics/step/contact_patch.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "physics/collision/pair_contact.h"
#include "physics/math/vectors.h"
#include "physics/model/pair_size.h"
#include "physics/step/pair_motion.h"

namespace carom {
namespace {

// Below this share of the largest square, a determinant is rounding: the stretch cannot turn.
constexpr double kNoTurn = 1e-12;

// The bodies that are one with this one, itself among them: by a weld, or as nothing moves them.
template <class Visit>
void each_of_one(const World& world, BodyIndex body, const Visit& visit) {
  if (world.is_immovable(body)) {
    for (const BodyIndex i : world.immovable) visit(i);
    return;
  }
  const WeldedBodies& welded = world.trajectories.welded();
  if (!welded.is_welded(body) || world.infinite_mass(body)) return visit(body);
  for (const BodyIndex i : world.trajectories.members(world.trajectories.island_of(body))) {
    if (world.move_as_one(i, body)) visit(i);
  }
}

// Calls visit(i, j, at, parts) for each point where two parts touch in that stretch, i one with a and j with b:
// where, in m along the tangent from the contact's point. Points of the same parts follow each other.
template <class Visit>
void each_touch(const World& world, BodyIndex a, BodyIndex b, const Contact& contact, const Visit& visit) {
  const Geometry& g = world.shapes();
  const Vec2 along = crossed(contact.normal);
  const SurfaceLaw& law = world.material(contact, a, b);
  each_of_one(world, a, [&](BodyIndex i) {
    const Pose pose_i = pose_at_start(world, i);
    each_of_one(world, b, [&](BodyIndex j) {
      if (!world.can_collide(i, j)) return;
      const Pose pose_j = pose_at_start(world, j);
      const double tolerance = kTogether * pair_size(g, i, j);
      each_manifold(g, i, pose_i, j, pose_j, contact.gap + tolerance, [&](const Manifold& m) {
        if (std::abs(cross(m.normal, contact.normal)) > kTogether || m.normal.dot(contact.normal) < 0.0) return;
        // Beside an immovable body another surface has an impact of its own.
        const bool beside = (i != a && world.is_immovable(i)) || (j != b && world.is_immovable(j));
        if (beside && world.material(m.contact(0), i, j) != law) return;
        for (int k = 0; k < m.count; ++k) {
          if (m.points[k].gap <= contact.gap + tolerance)
            visit(i, j, along.dot(m.points[k].point - contact.point), m.parts);
        }
      });
    });
  });
}

// How the ends of a stretch move along the normal: their velocities, and the velocity of end i by a unit
// impulse at end j.
struct EndMotion {
  std::array<double, 2> velocity{};                 // m/s
  std::array<std::array<double, 2>, 2> response{};  // 1/kg
};

EndMotion motion_of_ends(World& world, BodyIndex a, BodyIndex b, const Vec2& normal,
                         const std::array<Vec2, 2>& ends) {
  Trajectories& trajectories = world.trajectories;
  const bool jointed = trajectories.is_jointed(a) || trajectories.is_jointed(b);
  const auto lever = [&](BodyIndex body, int end) {
    return cross(ends[static_cast<std::size_t>(end)] - trajectories.at_start(body).head<2>(), normal);
  };
  const auto along = [&](const Eigen::Vector3d& of_a, const Eigen::Vector3d& of_b, int end) {
    return (of_b - of_a).head<2>().dot(normal) + of_b[2] * lever(b, end) - of_a[2] * lever(a, end);
  };
  const auto change = [&](BodyIndex body, int end, double sign) -> Eigen::Vector3d {
    const Vec2 v = sign * world.mass().inverse_mass[body] * normal;
    return {v.x(), v.y(), sign * world.mass().inverse_inertia[body] * lever(body, end)};
  };
  EndMotion motion;
  for (int j = 0; j < 2; ++j) {
    Eigen::Matrix<double, 3, 2> by;
    by << change(a, j, -1.0), change(b, j, 1.0);
    if (jointed) trajectories.project_changes(std::array{a, b}, by);
    const auto to = static_cast<std::size_t>(j);
    for (std::size_t i = 0; i < 2; ++i)
      motion.response[i][to] = along(by.col(0), by.col(1), static_cast<int>(i));
    motion.velocity[to] =
        along(trajectories.at_start(a).segment<3>(3), trajectories.at_start(b).segment<3>(3), j);
  }
  return motion;
}

}  // namespace

std::optional<Stretch> stretch_of(const World& world, BodyIndex a, BodyIndex b, const Contact& contact) {
  const Geometry& g = world.shapes();
  const WeldedBodies& welded = world.trajectories.welded();
  const auto has_no_stretch = [&](BodyIndex i) { return g.is_disc(i) && !welded.is_welded(i); };
  if (has_no_stretch(a) || has_no_stretch(b)) {
    // A disc touches a body that is one piece at one point.
    if (!welded.is_welded(a) && !welded.is_welded(b)) return std::nullopt;
    if (has_no_stretch(a) && has_no_stretch(b)) return std::nullopt;
  }
  Stretch stretch;
  each_touch(world, a, b, contact, [&](BodyIndex, BodyIndex, double at, const ShapePair&) {
    stretch = {std::min(stretch.low, at), std::max(stretch.high, at)};
  });
  if (!(stretch.high - stretch.low > kTogether * pair_size(g, a, b))) return std::nullopt;
  return stretch;
}

Contact pressed_contact(World& world, BodyIndex a, BodyIndex b, const Contact& contact) {
  const std::optional<Stretch> stretch = stretch_of(world, a, b, contact);
  if (!stretch) return contact;
  const Vec2 along = crossed(contact.normal);
  const std::array<double, 2> at = {stretch->low, stretch->high};
  const auto [u, k] = motion_of_ends(world, a, b, contact.normal,
                                     {contact.point + at[0] * along, contact.point + at[1] * along});
  const double determinant = k[0][0] * k[1][1] - k[0][1] * k[1][0];
  const double scale = std::max(k[0][0], k[1][1]);
  double where = 0.5 * (at[0] + at[1]);
  if (determinant > kNoTurn * scale * scale) {
    const double low = (k[0][1] * u[1] - k[1][1] * u[0]) / determinant;
    const double high = (k[1][0] * u[0] - k[0][0] * u[1]) / determinant;
    if (!(std::min(u[0], u[1]) < 0.0)) return contact;
    // Where both would not push, the end that closes does alone.
    const bool both = low > 0.0 && high > 0.0;
    const bool at_low = low > 0.0 || (high <= 0.0 && u[0] < u[1]);
    where = both ? (low * at[0] + high * at[1]) / (low + high) : at_low ? at[0] : at[1];
  }
  Contact pressed = contact;
  pressed.point += where * along;
  return pressed;
}

PressedPair pressed_pair(World& world, BodyIndex a, BodyIndex b, const Contact& contact) {
  PressedPair pressed{a, b, pressed_contact(world, a, b, contact)};
  if (!world.is_immovable(a) && !world.is_immovable(b)) return pressed;
  const double at = crossed(contact.normal).dot(pressed.contact.point - contact.point);
  if (at == 0.0) return pressed;
  // Of those that touch on either side of the point, or at it, the first; the pair itself if it does.
  struct Span {
    BodyIndex a;
    BodyIndex b;
    ShapePair parts;
    Stretch stretch;
  };
  std::optional<Span> now, found;
  const auto take = [&] {
    if (!now || !(now->stretch.low <= at && at <= now->stretch.high)) return;
    if (!found || (now->a == a && now->b == b)) found = now;
  };
  each_touch(world, a, b, contact, [&](BodyIndex i, BodyIndex j, double point, const ShapePair& parts) {
    if (now && now->a == i && now->b == j && now->parts.a == parts.a && now->parts.b == parts.b) {
      now->stretch = {std::min(now->stretch.low, point), std::max(now->stretch.high, point)};
      return;
    }
    take();
    now = Span{i, j, parts, {point, point}};
  });
  take();
  if (!found) return pressed;
  pressed.a = found->a;
  pressed.b = found->b;
  pressed.contact.parts = found->parts;
  if (pressed.a > pressed.b) {
    std::swap(pressed.a, pressed.b);
    std::swap(pressed.contact.parts.a, pressed.contact.parts.b);
    pressed.contact.normal = -pressed.contact.normal;
  }
  return pressed;
}

}  // namespace carom
