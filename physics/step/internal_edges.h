#pragma once

#include <algorithm>
#include <optional>
#include <span>

#include "physics/collision/contact.h"
#include "physics/collision/pair_contact.h"
#include "physics/collision/smooth_surface.h"
#include "physics/model/convex.h"
#include "physics/model/pair_size.h"
#include "physics/step/world.h"

// Edges at which another body, or another shape of the same one, continues a surface: nothing is hit there.
namespace carom {

// Relative to the pair's size: a resting body is off its place by what the solver of its contact forces leaves,
// up to 1e-10.
inline constexpr double kFlush = 1e-8;

// Whether a and b can touch at an edge that a third body continues: only corners can.
[[nodiscard]] inline bool may_be_continued(const World& world, BodyIndex a, BodyIndex b) {
  return !world.shapes().is_disc(a) || !world.shapes().is_disc(b);
}

// Whether this contact of a and b is none of the ends of the stretch along which they touch: a face lies over
// the place where two bodies at rest, or that one drive moves, make one face, or two shapes of one body.
template <class PoseOf>
[[nodiscard]] bool on_seam_of_face(const World& world, BodyIndex a, BodyIndex b, const Contact& contact,
                                   std::span<const BodyIndex> others, const PoseOf& pose) {
  const Geometry& g = world.shapes();
  if (g.is_disc(a) || g.is_disc(b)) return false;
  const ShapePair parts = g.parts_or_first(contact.parts, a, b);
  const Vec2 half = 0.5 * contact.gap * contact.normal;
  const auto on_seam_of = [&](BodyIndex owner, ShapeIndex part, const Vec2& at, BodyIndex toucher,
                              ShapeIndex touching, const Vec2& over, const Vec2& normal) {
    const double tolerance = kFlush * pair_size(g, owner, toucher) + 1e-12 * contact.point.lpNorm<1>();
    const auto continues = [&](BodyIndex other) {
      bool any = false;
      g.each_part(other, [&](ShapeIndex piece) {
        any = any || (piece != part && lies_over_seam(g.shapes, part, g.part_pose(owner, part, pose(owner)),
                                                      piece, g.part_pose(other, piece, pose(other)), touching,
                                                      g.part_pose(toucher, touching, pose(toucher)), at, over,
                                                      normal, tolerance));
      });
      return any;
    };
    if (g.has_parts(owner) && continues(owner)) return true;
    return world.infinite_mass(owner) && std::any_of(others.begin(), others.end(), [&](BodyIndex other) {
             return other != owner && world.stay_together(owner, other) && world.can_collide(other, toucher) &&
                    continues(other);
           });
  };
  return on_seam_of(a, parts.a, contact.point - half, b, parts.b, contact.point + half, contact.normal) ||
         on_seam_of(b, parts.b, contact.point + half, a, parts.a, contact.point - half, -contact.normal);
}

// Whether another part, of a body itself or of one of `others`, leaves no such contact of a and b, because it
// continues the surface of one of them there (neighbour_covers, on_seam_of_face). pose(i) is the pose of a
// body.
template <class PoseOf>
[[nodiscard]] bool on_internal_edge(const World& world, BodyIndex a, BodyIndex b, const Contact& contact,
                                    std::span<const BodyIndex> others, const PoseOf& pose) {
  const Geometry& g = world.shapes();
  const Vec2 half = 0.5 * contact.gap * contact.normal;
  const ShapePair parts = g.parts_or_first(contact.parts, a, b);
  struct Side {
    BodyIndex body;
    ShapeIndex part;
    Pose pose;
  };
  const Vec2 on_a = contact.point - half;
  const Vec2 on_b = contact.point + half;
  if (on_seam_of_face(world, a, b, contact, others, pose)) return true;
  if (!g.has_parts(a) && !g.has_parts(b) && others.empty()) return false;
  // A disc has no edge, and nobody asks where it is.
  const auto side = [&](BodyIndex body, ShapeIndex part) {
    const bool no_edge = g.more.empty() && g.shapes.core[part] == Core::kPoint;
    return Side{body, part, no_edge ? Pose() : pose(body)};
  };
  const Side of_a = side(a, parts.a);
  const Side of_b = side(b, parts.b);
  const auto may_cover = [&](BodyIndex other, const Side& owner, const Side& toucher) {
    return g.shapes.core[owner.part] != Core::kPoint && world.can_collide(other, toucher.body);
  };
  const auto covers = [&](BodyIndex other, const Pose& of_other, const Side& owner, const Side& toucher,
                          const Vec2& point, const Vec2& normal) {
    if (!may_cover(other, owner, toucher)) return false;
    // Two half-planes have no size of their own.
    const double size = std::max(g.size[owner.body] + g.size[other], g.size[toucher.body]);
    const double tolerance = kFlush * size + 1e-12 * point.lpNorm<1>();
    if (g.more.empty()) {
      return neighbour_covers(g.shapes, owner.part, owner.pose, g.first_part(other), of_other, point, normal,
                              tolerance, !world.can_collide(owner.body, other));
    }
    const bool one_body = owner.body == other;
    const bool by_face = one_body && has_face(g.shapes, toucher.part,
                                              g.part_pose(toucher.body, toucher.part, toucher.pose), -normal);
    const Pose of_owner = g.part_pose(owner.body, owner.part, owner.pose);
    bool covered = false;
    g.each_part(other, [&](ShapeIndex piece) {
      if (covered || piece == owner.part) return;
      covered =
          neighbour_covers(g.shapes, owner.part, of_owner, piece, g.part_pose(other, piece, of_other), point,
                           normal, tolerance, one_body || !world.can_collide(owner.body, other), by_face);
    });
    return covered;
  };
  if (g.has_parts(a) && covers(a, of_a.pose, of_a, of_b, on_a, contact.normal)) return true;
  if (g.has_parts(b) && covers(b, of_b.pose, of_b, of_a, on_b, -contact.normal)) return true;
  return std::any_of(others.begin(), others.end(), [&](BodyIndex other) {
    if (other == a || other == b || (!may_cover(other, of_a, of_b) && !may_cover(other, of_b, of_a)))
      return false;
    const Pose of_other = pose(other);
    return covers(other, of_other, of_a, of_b, on_a, contact.normal) ||
           covers(other, of_other, of_b, of_a, on_b, -contact.normal);
  });
}

// Whether a disc, or another rounding, that is at a corner turns about it to this contact, though another part
// goes on from there: halfway from its normal before, the corner is bare. Over a seam it is not.
template <class PoseOf>
[[nodiscard]] bool turns_about_corner(const World& world, BodyIndex a, BodyIndex b, const Vec2& normal_before,
                                      const Contact& contact, std::span<const BodyIndex> others,
                                      const PoseOf& pose) {
  const ShapePair parts = world.shapes().parts_or_first(contact.parts, a, b);
  const auto& rounding = world.shapes().shapes.rounding;
  if ((rounding[parts.a] > 0.0) == (rounding[parts.b] > 0.0)) return false;
  const double side = rounding[parts.a] > 0.0 ? 0.5 : -0.5;
  Contact halfway = contact;
  halfway.point += side * contact.gap * contact.normal;
  halfway.normal = (normal_before + contact.normal).normalized();
  halfway.gap = 0.0;
  return !on_internal_edge(world, a, b, halfway, others, pose);
}

// The points of a manifold that no other part continues; calls continued(contact) for each that one does. Where
// one of two goes so, the nearest features are a seam and the face over it, while what may land there is a
// corner of the one on the face of the other: its normal is that of this face.
template <class PoseOf, class Continued>
[[nodiscard]] Manifold exposed_points(const World& world, BodyIndex a, BodyIndex b, const Manifold& m,
                                      std::span<const BodyIndex> others, const PoseOf& pose,
                                      const Continued& continued) {
  if (!may_be_continued(world, a, b)) return m;
  Manifold left = m;
  left.count = 0;
  for (int k = 0; k < m.count; ++k) {
    const ManifoldPoint& at = m.points[static_cast<std::size_t>(k)];
    const Contact contact = m.contact(k);
    if (on_internal_edge(world, a, b, contact, others, pose)) {
      continued(contact);
    } else {
      left.points[static_cast<std::size_t>(left.count++)] = at;
    }
  }
  if (left.count == m.count || left.count == 0) return left;
  ManifoldPoint& at = left.points[0];
  const Geometry& g = world.shapes();
  const auto [part_a, part_b] = g.parts_or_first(m.parts, a, b);
  const Pose pose_a = g.part_pose(a, part_a, pose(a));
  const Pose pose_b = g.part_pose(b, part_b, pose(b));
  const Vec2 half = 0.5 * at.gap * m.normal;
  const double near = kFlush * pair_size(g, a, b);
  std::optional<Contact> on_face =
      corner_over_face(g.shapes, part_a, pose_a, part_b, pose_b, at.point + half, m.normal, near);
  if (!on_face) {
    on_face = corner_over_face(g.shapes, part_b, pose_b, part_a, pose_a, at.point - half, -m.normal, near);
    if (on_face) on_face->normal = -on_face->normal;
  }
  if (on_face) {
    left.normal = on_face->normal;
    at.point = on_face->point;
    at.gap = on_face->gap;
  }
  return left;
}

}  // namespace carom
