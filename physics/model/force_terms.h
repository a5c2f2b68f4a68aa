#pragma once

#include <optional>
#include <vector>

#include "physics/model/needs.h"
#include "physics/scene/scene.h"

namespace carom {

// A spring, its ends as indices of bodies.
struct SpringTerm {
  int body;
  int other;    // a movable body, or -1
  int drive;    // a kinematic body at the other end, or -1
  Vec2 anchor;  // m, of a point or an immovable body's home
  double stiffness;
  double damping;
  double rest_length;
  SpringActs acts;
};

struct AppliedTerm {
  int body;
  AppliedForce law;
};

// The smooth forces of a scene, laid out for evaluation. Of a part that is left out the lists are empty, those
// by body too.
struct ForceTerms {
  bool drag = false;  // Part::kDrag is in
  Vec2 gravity = Vec2::Zero();
  double linear_drag = 0.0;
  double quadratic_drag = 0.0;
  std::optional<Attraction> attraction;
  bool gravity_only = true;  // nothing but uniform gravity acts: no work, no impulse to sum up
  bool constant = true;      // nothing but gravity and constant forces, for good: flight is a parabola
  bool one_sided = false;    // some springs push or pull only
  std::vector<SpringTerm> springs;
  std::vector<std::vector<int>> outside;    // springs to points and immovable bodies, by body
  std::vector<std::vector<int>> between;    // springs to free bodies, by both their bodies
  std::vector<std::vector<int>> switching;  // one-sided springs, by both their bodies
  std::vector<AppliedTerm> applied;
  std::vector<std::vector<int>> applied_to;  // by body
};

[[nodiscard]] ForceTerms force_terms(const Forces& forces, const std::vector<Body>& bodies, const Needs& needs);

}  // namespace carom
