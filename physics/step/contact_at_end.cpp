#include "physics/step/contact_at_end.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "physics/contact/contact_velocity.h"
#include "physics/model/convex.h"
#include "physics/step/contact_sides.h"
#include "physics/step/internal_edges.h"
#include "physics/step/pair_motion.h"
#include "physics/step/touch_on_face.h"

namespace carom {

bool may_turn_far(const Geometry& g, const ShapePair& parts) {
  const bool discs = g.shapes.core[parts.a] == Core::kPoint && g.shapes.core[parts.b] == Core::kPoint;
  return !discs && g.shapes.rounding[parts.a] + g.shapes.rounding[parts.b] > 0.0;
}

void ContactsAtEnd::look(int i) {
  const Geometry& g = world_.shapes();
  const bool same_parts = contact_ >= 0 && parts_of(found_.id[static_cast<std::size_t>(i)]) == parts_of(id());
  contact_ = i;
  if (same_parts) return;
  parts_ = parts_at(g, a_.body, b_.body, id());
  all_ = manifold_of(g, a_.body, a_.end, b_.body, b_.end, id(), std::numeric_limits<double>::infinity());
  // Where a neighbour continues the surface, the contact does not turn about the edge.
  const auto pose_of = [this](BodyIndex body) { return pose(body); };
  bare_ = exposed_points(world_, a_.body, b_.body, all_, others_, pose_of, [](const Contact&) {});
  if (bare_.count == 0 && all_.count == 1 &&
      turns_about_corner(world_, a_.body, b_.body, found_.contacts.normal[i], all_.contact(0), others_,
                         pose_of))
    bare_ = all_;
}

// Whether the contact has come over a seam: another part continues the surface there.
bool ContactsAtEnd::slides_on() const {
  return point_with(bare_, id()) < 0 && (bare_.count == 0 || point_with(all_, id()) >= 0);
}

std::optional<GuessedEnd> ContactsAtEnd::same() const {
  const auto guess = [this](int point) {
    const ManifoldPoint& at = bare_.points[static_cast<std::size_t>(point)];
    return GuessedEnd{at.point, bare_.normal, at.gap};
  };
  if (const int point = point_with(bare_, id()); point >= 0) return guess(point);
  if (const std::optional<Contact> line = on_line()) return GuessedEnd{line->point, line->normal, line->gap};
  if (slides_on()) return std::nullopt;
  for (int point = 0; point < bare_.count; ++point) {
    if (is_same_corner(bare_.points[static_cast<std::size_t>(point)])) return guess(point);
  }
  if (bare_.count == 1 && has_rolled_on()) return guess(0);
  return std::nullopt;
}

// The contact of a tip on the line of a face, as long as it is on the face, or on one that continues it.
std::optional<Contact> ContactsAtEnd::on_line() const {
  const Geometry& g = world_.shapes();
  const auto beyond = [&](const TipOnFace& tip) {
    return beyond_face(g, a_.body, a_.end, b_.body, b_.end, tip);
  };
  const auto on_its_line = [&](const TipOnFace& tip) {
    return contact_on_line(g, a_.body, a_.end, b_.body, b_.end, tip);
  };
  if (const auto on = touch_on_face(world_, found_, contact_)) {
    const TipOnFace tip = on->on_line();
    if (const double past = beyond(tip); past != 0.0 && face_goes_on(tip, past > 0.0)) return on_its_line(tip);
  }
  const auto halfway = [&](const Flown& flown) {
    return g.pose(flown.body, world_.trajectories.at_start(flown.body).head<3>() + 0.5 * flown.moved);
  };
  const auto touch = tip_on_face(g, a_.body, halfway(a_), b_.body, halfway(b_), id());
  if (!touch) return std::nullopt;
  if (std::abs(beyond(*touch)) > kFlush * size() && !slides_on()) return std::nullopt;
  return on_its_line(*touch);
}

// Whether another part goes on with the face of this touch beyond its end, or its start.
bool ContactsAtEnd::face_goes_on(const TipOnFace& touch, bool at_end) const {
  const auto& [own, other] = touch.is_of_b ? std::tie(a_, b_) : std::tie(b_, a_);
  return goes_on_past(world_, own.body, touch.face, at_end, other.body, touch.is_of_b ? parts_.b : parts_.a,
                      others_, [this](BodyIndex body) { return pose(body); });
}

// Whether this point at the end is where the contact was on one of its bodies: a corner that another edge faces
// by then.
bool ContactsAtEnd::is_same_corner(const ManifoldPoint& end) const {
  const double near = kFlush * size() + std::abs(found_.contacts.gap[contact_]) + std::abs(end.gap);
  const auto stays = [&](const Flown& flown) {
    const Pose from = pose_at_start(world_, flown.body);
    return (flown.end.turned_back(end.point - flown.end.position) - from.turned_back(start() - from.position))
               .norm() <= near;
  };
  return stays(a_) || stays(b_);
}

// Whether what touches is round there, and may have come to the one point at the end.
bool ContactsAtEnd::has_rolled_on() const {
  const Geometry& g = world_.shapes();
  if (!may_turn_far(g, parts_)) return false;
  const double turned = std::abs(a_.moved[2]) * g.size[a_.body] + std::abs(b_.moved[2]) * g.size[b_.body];
  const double way = (a_.moved - b_.moved).head<2>().norm() + turned;
  return (bare_.points[0].point - start() - 0.5 * (a_.moved + b_.moved).head<2>()).norm() <= way;
}

GuessedEnd ContactsAtEnd::carried() const {
  const Contacts& c = found_.contacts;
  const int i = contact_;
  GuessedEnd end{start(), c.normal[i], c.gap[i]};
  const Vec2 by_a = a_.moved.head<2>() + a_.moved[2] * crossed(c.arm_a[i]);
  const Vec2 by_b = b_.moved.head<2>() + b_.moved[2] * crossed(c.arm_b[i]);
  end.gap += (by_b - by_a).dot(c.normal[i]);
  const ConvexShapes& shapes = world_.shapes().shapes;
  if (is_round(shapes, parts_.a) != is_round(shapes, parts_.b)) {
    end.point += is_round(shapes, parts_.a) ? moved_centre(a_, parts_.a) : moved_centre(b_, parts_.b);
  } else if (!slides_on()) {
    end.point += 0.5 * (by_a + by_b);
  } else {
    end.point += from_corner(a_.body, parts_.a) < from_corner(b_.body, parts_.b) ? by_a : by_b;
  }
  return end;
}

// m: how far the centre of a part goes.
Vec2 ContactsAtEnd::moved_centre(const Flown& flown, ShapeIndex part) const {
  const Geometry& g = world_.shapes();
  return g.part_pose(flown.body, part, flown.end).position -
         g.part_pose(flown.body, part, pose_at_start(world_, flown.body)).position;
}

// m: from the contact at the start to the nearest corner of this part of a body.
double ContactsAtEnd::from_corner(BodyIndex body, ShapeIndex part) const {
  const Geometry& g = world_.shapes();
  double nearest = std::numeric_limits<double>::infinity();
  if (g.shapes.core[part] == Core::kHalfPlane) return nearest;
  const Pose from = g.part_pose(body, part, pose_at_start(world_, body));
  const Vec2 at = from.turned_back(Vec2(start() - from.position));
  const Corner* corner = g.shapes.corners_of(part);
  for (int k = 0; k < g.shapes.corners[part]; ++k) nearest = std::min(nearest, (corner[k].vertex - at).norm());
  return nearest;
}

}  // namespace carom
