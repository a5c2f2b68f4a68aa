#include "physics/model/joint_terms.h"

#include <string>
#include <unordered_map>

#include "physics/math/vectors.h"
#include "physics/scene/drive.h"

namespace carom {
namespace {

// A weld may be placed at the centre of either of its bodies. At the one with the smaller inertia (0 for a
// point-like body, which gets no row for its angle) the rows depend least on each other. The angles are those
// of the bodies at the start; `weld` is a pin so far.
void place_weld(JointTerm& weld, const Joint& joint, double angle, double other_angle,
                const MassProperties& mass) {
  weld.angle = joint.angle.value_or(angle - other_angle);
  weld.point = Vec2::Zero();
  if (weld.other >= 0 && mass.inertia[weld.body] > mass.inertia[weld.other]) {
    weld.anchor = joint.point - turned_by(-weld.angle, joint.anchor);
    weld.angle = -weld.angle;
    std::swap(weld.body, weld.other);
  } else {
    if (weld.other < 0) weld.angle += other_angle;
    weld.anchor -= turned_by(weld.angle, joint.point);
  }
  weld.rows = mass.inertia[weld.body] > 0.0 ? 3 : 2;
}

// m, the distance of the ends at `time`.
double distance_of(const JointTerm& joint, const std::vector<Body>& bodies, double time) {
  const Body a = moved_by_drive(bodies[joint.body], time);
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

// `other`: the body at the other end, or -1.
JointTerm joint_term(const Joint& l, int body, int other, const std::vector<Body>& bodies,
                     const MassProperties& mass) {
  JointTerm joint{l.kind, body, -1, -1, l.point, l.anchor, 0.0, 0.0, l.kind == JointKind::kPin ? 2 : 1};
  if (other >= 0) {
    if (!has_infinite_mass(bodies[other])) {
      joint.other = other;
    } else {
      joint.anchor = bodies[other].position + turned_by(bodies[other].angle, l.anchor);
      if (bodies[other].drive) joint.drive = other;
    }
  }
  if (l.kind == JointKind::kWeld)
    place_weld(joint, l, bodies[body].angle, other < 0 ? 0.0 : bodies[other].angle, mass);
  return joint;
}

}  // namespace

JointTerms joint_terms_of(const std::vector<Joint>& joints, const std::vector<Body>& bodies,
                          const MassProperties& mass, double time) {
  JointTerms joint_terms;
  std::unordered_map<std::string, int> index;
  for (std::size_t i = 0; i < bodies.size(); ++i) index.emplace(bodies[i].name, static_cast<int>(i));
  for (const Joint& l : joints) {
    JointTerm joint = joint_term(l, index.at(l.body), l.to.empty() ? -1 : index.at(l.to), bodies, mass);
    joint.length = l.length.value_or(distance_of(joint, bodies, time));
    joint_terms.all.push_back(joint);
  }
  return joint_terms;
}

JointTerm weld_term(const Weld& weld, const std::vector<Body>& bodies, const MassProperties& mass) {
  Joint joint;
  joint.kind = JointKind::kWeld;
  joint.point = weld.point;
  joint.anchor = weld.anchor;
  joint.angle = weld.angle;
  return joint_term(joint, weld.body, weld.other, bodies, mass);
}

std::vector<std::pair<int, int>> JointTerms::joined() const {
  std::vector<std::pair<int, int>> pairs;
  for (const JointTerm& l : all) pairs.emplace_back(l.body, l.other >= 0 ? l.other : l.body);
  return pairs;
}

}  // namespace carom
