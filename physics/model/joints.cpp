#include "physics/model/joints.h"

#include <string>
#include <unordered_map>

#include "physics/math/vectors.h"
#include "physics/scene/drive.h"

namespace carom {
namespace {

// Wherever the file puts it, a weld is the same if it is laid at the centre of one of its bodies. At that of
// the lesser inertia (0 of a point-like body, which gets no row for its angle) the rows depend least on each
// other. The angles are those of the bodies at the start, and `laid` is that of a pin so far.
void lay_weld(Joint& laid, const Link& link, double angle, double other_angle, const MassProperties& mass) {
  laid.angle = link.angle.value_or(angle - other_angle);
  laid.point = Vec2::Zero();
  if (laid.other >= 0 && mass.inertia[laid.body] > mass.inertia[laid.other]) {
    laid.anchor = link.point - turned_by(-laid.angle, link.anchor);
    laid.angle = -laid.angle;
    std::swap(laid.body, laid.other);
  } else {
    if (laid.other < 0) laid.angle += other_angle;
    laid.anchor -= turned_by(laid.angle, link.point);
  }
  laid.rows = mass.inertia[laid.body] > 0.0 ? 3 : 2;
}

// m: how far the ends are apart at the start.
double distance_of(const Joint& joint, const std::vector<Body>& bodies, double time) {
  const Body a = driven_to(bodies[joint.body], time);
  Vec2 d = a.position + turned_by(a.angle, joint.point);
  if (joint.other >= 0) {
    const Body& b = bodies[joint.other];
    d -= b.position + turned_by(b.angle, joint.anchor);
  } else if (joint.drive >= 0) {
    d -= drive_position(*bodies[joint.drive].drive, joint.anchor, time);
  } else {
    d -= joint.anchor;
  }
  return d.norm();
}

}  // namespace

Joints joints_of(const std::vector<Link>& links, const std::vector<Body>& bodies, const MassProperties& mass,
                 double time) {
  Joints joints;
  std::unordered_map<std::string, int> index;
  for (std::size_t i = 0; i < bodies.size(); ++i) index.emplace(bodies[i].name, static_cast<int>(i));
  for (const Link& l : links) {
    Joint joint{l.kind, index.at(l.body), -1, -1, l.point, l.anchor, 0.0, 0.0, 1};
    if (l.kind == LinkKind::kPin) joint.rows = 2;
    if (!l.to.empty()) {
      const int other = index.at(l.to);
      if (!is_immovable(bodies[other])) {
        joint.other = other;
      } else {
        joint.anchor = bodies[other].position + turned_by(bodies[other].angle, l.anchor);
        if (bodies[other].drive) joint.drive = other;
      }
    }
    if (l.kind == LinkKind::kWeld) {
      lay_weld(joint, l, bodies[joint.body].angle, l.to.empty() ? 0.0 : bodies[index.at(l.to)].angle, mass);
    }
    joint.length = l.length.value_or(distance_of(joint, bodies, time));
    joints.all.push_back(joint);
  }
  return joints;
}

std::vector<std::pair<int, int>> Joints::joined() const {
  std::vector<std::pair<int, int>> pairs;
  for (const Joint& l : all) pairs.emplace_back(l.body, l.other >= 0 ? l.other : l.body);
  return pairs;
}

}  // namespace carom
