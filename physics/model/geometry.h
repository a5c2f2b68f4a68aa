#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "physics/model/convex.h"
#include "physics/model/weld.h"
#include "physics/scene/scene.h"

namespace carom {

// What collision detection needs of N bodies, as arrays. A body is one convex part or, if its shape is concave
// or a compound, several. Part i < N is the first one of body i; further parts follow.
struct Geometry {
  ConvexShapes shapes;  // of the parts, each in a frame along the axes of its body
  // Of a body of several parts; all empty where there is none.
  struct MoreParts {
    int first = 0;  // numbers of those beyond its first one
    int last = 0;
  };
  std::vector<MoreParts> more;        // by body
  ArrayOf<ShapeIndex, Vec2> place;    // m: where a part is in the frame of its body
  ArrayOf<ShapeIndex, int> of_shape;  // which shape of a compound a part is of
  Eigen::VectorXd core_reach;  // m, by body: of the circle about the centre of mass that contains the cores
  Eigen::VectorXd reach;       // m, likewise of the whole body; infinite for a half-plane
  // m, 2×N: half width and height of the axis-aligned rectangle about the centre that contains the body at
  // every angle that it can take. Infinite for a half-plane.
  Eigen::Matrix2Xd extent;
  Eigen::VectorXd size;             // m, approximately; 0 for a half-plane
  std::vector<std::uint8_t> fixed;  // infinite mass: fixed or kinematic
  std::vector<int> group;           // bodies of one group >= 0 do not collide with each other
  std::vector<BodyPair> pinned;     // nor do pairs that a pin joins; a < b, sorted
  WeldedBodies welded;              // nor do bodies that are one

  [[nodiscard]] bool has_parts(BodyIndex i) const { return !more.empty() && more[i].last > more[i].first; }
  [[nodiscard]] ShapeIndex first_part(BodyIndex body) const { return ShapeIndex{int{body}}; }
  [[nodiscard]] ShapePair first_parts(BodyIndex a, BodyIndex b) const { return {first_part(a), first_part(b)}; }
  // Those that are given, or the first ones.
  [[nodiscard]] ShapePair parts_or_first(const ShapePair& parts, BodyIndex a, BodyIndex b) const {
    return parts.known() ? parts : first_parts(a, b);
  }
  [[nodiscard]] bool is_disc(BodyIndex i) const {
    return shapes.core[first_part(i)] == Core::kPoint && !has_parts(i);
  }
  template <class Visit>
  void each_part(BodyIndex body, const Visit& visit) const {
    visit(first_part(body));
    if (!has_parts(body)) return;
    for (int part = more[body].first; part < more[body].last; ++part) visit(ShapeIndex{part});
  }
  // visit(part of a, part of b)
  template <class Visit>
  void each_parts(BodyIndex a, BodyIndex b, const Visit& visit) const {
    each_part(a, [&](ShapeIndex part_a) { each_part(b, [&](ShapeIndex part_b) { visit(part_a, part_b); }); });
  }
  [[nodiscard]] std::size_t shape_of(ShapeIndex part) const {
    return more.empty() ? 0U : static_cast<std::size_t>(of_shape[part]);
  }
  // A part's number within its body, and back.
  [[nodiscard]] int number_of(BodyIndex body, ShapeIndex part) const {
    return part == first_part(body) ? 0 : 1 + static_cast<int>(part) - more[body].first;
  }
  [[nodiscard]] ShapeIndex part_of(BodyIndex body, int number) const {
    return number == 0 ? first_part(body) : ShapeIndex{more[body].first + number - 1};
  }

  // The pose of body i at q = (x, y, angle), and that of its parts.
  [[nodiscard]] Pose pose(BodyIndex i, const Eigen::Vector3d& q) const {
    if (!has_parts(i)) return pose_of(shapes, first_part(i), q);
    const Vec2 along = direction_at(q[2]);
    return {q.head<2>(), along.x(), along.y()};
  }
  [[nodiscard]] Pose part_pose(BodyIndex body, ShapeIndex part, const Pose& pose) const {
    if (!has_parts(body)) return pose;
    return {pose.position + pose.turned(place[part]), pose.cos, pose.sin};
  }
  // Whether the two can collide at all, at the start of a run; likewise later, with the welds of then.
  [[nodiscard]] bool can_collide(BodyIndex a, BodyIndex b) const { return can_collide(a, b, welded); }
  [[nodiscard]] bool can_collide(BodyIndex a, BodyIndex b, const WeldedBodies& now) const {
    if ((fixed[a] != 0 && fixed[b] != 0) || (group[a] >= 0 && group[a] == group[b]) || now.are_one(a, b))
      return false;
    return pinned.empty() || !std::binary_search(pinned.begin(), pinned.end(), BodyPair(std::minmax(a, b)));
  }
};

[[nodiscard]] Geometry geometry(const std::vector<Body>& bodies, const std::vector<Joint>& joints = {});

}  // namespace carom
