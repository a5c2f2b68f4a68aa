#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "physics/model/body_starts.h"
#include "physics/model/index.h"
#include "physics/model/mass.h"
#include "physics/model/weld.h"
#include "physics/scene/scene.h"

namespace carom {

// A joint with its ends as body indices. A rod or a string has one constraint row, a pin two, a weld two or
// three. A weld is placed at the centre of the body with the smaller inertia.
struct JointTerm {
  JointKind kind;
  BodyIndex body;
  BodyIndex other;  // a movable body, or -1
  BodyIndex drive;  // a kinematic body at the other end, or -1
  Vec2 point;       // m, on the body, along its own axes
  Vec2 anchor;      // m, on the other body or in the plane; absolute if that body is kinematic
  double length;    // m
  double angle;     // rad, of a weld
  int rows;
};

// The joints of a scene, arranged for evaluation.
struct JointTerms {
  ArrayOf<JointIndex, JointTerm> all;

  // The movable bodies of each joint; the same one twice if only one end is movable.
  [[nodiscard]] std::vector<BodyPair> joined() const;
};

// What joints need to know of the bodies.
struct JointedBodies {
  const BodyStarts& starts;
  const DriveTerms& drives;
  const MassProperties& mass;
};

// Lengths that the scene leaves out are those at `time` (s), the start of the run.
[[nodiscard]] JointTerms joint_terms_of(const std::vector<Joint>& joints, const std::vector<Body>& names,
                                        const JointedBodies& bodies, double time);
// Of a weld that a run makes.
[[nodiscard]] JointTerm weld_term(const Weld& weld, const JointedBodies& bodies);

}  // namespace carom
