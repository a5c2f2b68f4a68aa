#include "physics/model/joint_terms.h"

#include "physics/math/vectors.h"
#include "physics/model/bodies_by_name.h"
#include "physics/scene/drive.h"

namespace carom {
namespace {

// A weld may be placed at the centre of either of its bodies. At the one with the smaller inertia (0 for a
// point-like body, which gets no row for its angle) the rows depend least on each other. `weld` is a pin so
// far, between these two points; `other_angle` in rad is that of the other body at the start.
void place_weld(JointTerm& weld, const Vec2& point, const Vec2& anchor, double other_angle,
                const MassProperties& mass) {
  weld.point = Vec2::Zero();
  if (weld.other >= 0 && mass.inertia[weld.body] > mass.inertia[weld.other]) {
    weld.anchor = point - turned_by(-weld.angle, anchor);
    weld.angle = -weld.angle;
    std::swap(weld.body, weld.other);
  } else {
    if (weld.other < 0) weld.angle += other_angle;
    weld.anchor -= turned_by(weld.angle, point);
  }
  weld.rows = mass.inertia[weld.body] > 0.0 ? 3 : 2;
}

// `other`: the body at the other end, or -1. `angle` is that of a weld; none: as at the start.
JointTerm joint_term(JointKind kind, const Weld& ends, std::optional<double> angle,
                     const JointedBodies& bodies) {
  const auto& [starts, drives, mass] = bodies;
  const BodyIndex other = ends.other;
  JointTerm joint{
      kind, ends.body, kNoBody, kNoBody, ends.point, ends.anchor, 0.0, 0.0, kind == JointKind::kPin ? 2 : 1};
  const double other_angle = other < 0 ? 0.0 : starts.q.col(other)[2];
  if (other >= 0 && mass.inverse_mass[other] > 0.0) {
    joint.other = other;
  } else if (other >= 0) {
    const Vec2 home = drives.drives(other) ? drives.at(other).home : Vec2(starts.q.col(other).head<2>());
    joint.anchor = home + turned_by(other_angle, ends.anchor);
    if (drives.drives(other)) joint.drive = other;
  }
  if (kind != JointKind::kWeld) return joint;
  joint.angle = angle.value_or(starts.q.col(ends.body)[2] - other_angle);
  place_weld(joint, ends.point, ends.anchor, other_angle, mass);
  return joint;
}

// m, the distance of the ends at the start, at `time` (s).
double distance_of(const JointTerm& joint, const JointedBodies& bodies, double time) {
  const auto a = bodies.starts.q.col(joint.body);
  Vec2 d = a.head<2>() + turned_by(a[2], joint.point);
  if (joint.other >= 0) {
    const auto b = bodies.starts.q.col(joint.other);
    d -= b.head<2>() + turned_by(b[2], joint.anchor);
  } else if (joint.drive >= 0) {
    d -= drive_position(bodies.drives.at(joint.drive).law, joint.anchor, time);
  } else {
    d -= joint.anchor;
  }
  return d.norm();
}

}  // namespace

JointTerms joint_terms_of(const std::vector<Joint>& joints, const std::vector<Body>& names,
                          const JointedBodies& bodies, double time) {
  JointTerms joint_terms;
  const auto index = bodies_by_name(names);
  for (const Joint& l : joints) {
    const Weld ends{.body = index.at(l.body),
                    .other = l.to.empty() ? kNoBody : index.at(l.to),
                    .point = l.point,
                    .anchor = l.anchor,
                    .angle = 0.0};
    JointTerm joint = joint_term(l.kind, ends, l.angle, bodies);
    joint.length = l.length.value_or(distance_of(joint, bodies, time));
    joint_terms.all.push_back(joint);
  }
  return joint_terms;
}

JointTerm weld_term(const Weld& weld, const JointedBodies& bodies) {
  return joint_term(JointKind::kWeld, weld, weld.angle, bodies);
}

std::vector<BodyPair> JointTerms::joined() const {
  std::vector<BodyPair> pairs;
  for (const JointTerm& l : all) pairs.emplace_back(l.body, l.other >= 0 ? l.other : l.body);
  return pairs;
}

}  // namespace carom
