#pragma once

#include <optional>
#include <vector>

#include "physics/model/index.h"
#include "physics/model/needs.h"
#include "physics/scene/scene.h"

namespace carom {

// A spring with its ends as body indices.
struct SpringTerm {
  BodyIndex body;
  BodyIndex other;     // a movable body, or -1
  BodyIndex drive;     // a kinematic body at the other end, or -1
  Vec2 point;          // m, of the body, along its own axes
  Vec2 other_point;    // m, likewise of a body at the other end
  Vec2 anchor;         // m, a point of the plane; on a fixed or kinematic body where the scene has it
  double stiffness;    // N/m
  double damping;      // N s/m
  double rest_length;  // m
  SpringActs acts;
};

// An applied force and torque, likewise.
struct AppliedTerm {
  BodyIndex body;
  Vec2 point;                 // m, of the body, along its own axes
  Vec2 force;                 // N
  double torque;              // N m
  double start;               // s
  double rise;                // s
  std::optional<double> end;  // s
};

// A hand that pulls, likewise.
struct HandTerm {
  BodyIndex body = kNoBody;
  Vec2 grip = Vec2::Zero();   // m, in the body's own axes
  Vec2 place = Vec2::Zero();  // m, at the start
  double stiffness = 0.0;     // N/m
  double damping = 0.0;       // N s/m
};

// The smooth forces of a scene, arranged for evaluation. All lists of a part that the model leaves out are
// empty, including those by body.
struct ForceTerms : CommonForces {
  bool on_each = false;      // some of those act on each body, as drag does
  bool gravity_only = true;  // only uniform gravity acts: all quadratures but its own stay zero
  bool constant = true;      // only gravity and forces that never change: flight is a parabola
  bool one_sided = false;    // some springs push or pull only
  ArrayOf<SpringIndex, SpringTerm> springs;
  std::vector<std::vector<SpringIndex>> outside;  // springs to points and to fixed or kinematic bodies, by body
  std::vector<std::vector<SpringIndex>> between;  // springs between movable bodies, by both their bodies
  std::vector<std::vector<SpringIndex>> switching;  // one-sided springs, by both their bodies
  ArrayOf<AppliedForceIndex, AppliedTerm> applied;
  std::vector<std::vector<AppliedForceIndex>> applied_to;  // by body
  std::optional<HandTerm> hand;
};

// Of a valid scene.
[[nodiscard]] ForceTerms force_terms(const Forces& forces, const std::vector<Body>& bodies, const Needs& needs);

}  // namespace carom
