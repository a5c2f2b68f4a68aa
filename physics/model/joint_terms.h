#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "physics/model/mass.h"
#include "physics/scene/scene.h"

namespace carom {

// A joint, its ends as indices of bodies. A rod or a string is one row, a pin two, a weld two or three: it is
// laid at the centre of the body of the lesser inertia.
struct JointTerm {
  JointKind kind;
  int body;
  int other;  // a movable body, or -1
  int drive;  // a kinematic body at the other end, or -1
  Vec2 point;
  Vec2 anchor;    // on the other body, or of the plane; where a kinematic body's home is added
  double length;  // m
  double angle;   // rad, of a weld
  int rows;
};

// The joints of a scene, laid out for evaluation.
struct JointTerms {
  std::vector<JointTerm> all;

  // The movable bodies of each joint; twice the same where the other end is no movable body.
  [[nodiscard]] std::vector<std::pair<int, int>> joined() const;
};

// Lengths that the scene leaves open are those at `time` (s), the start of the run.
[[nodiscard]] JointTerms joint_terms_of(const std::vector<Joint>& joints, const std::vector<Body>& bodies,
                                        const MassProperties& mass, double time);

}  // namespace carom
