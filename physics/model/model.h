#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "physics/model/force_terms.h"
#include "physics/model/geometry.h"
#include "physics/model/joint_terms.h"
#include "physics/model/mass.h"
#include "physics/model/needs.h"
#include "physics/model/surfaces.h"
#include "physics/scene/scene.h"

namespace carom {

// What the step works on: a scene with indices in place of names, its masses, shapes and forces as arrays,
// and only the parts that it needs. Compiled once, then constant and shared by all runs and their copies, on
// any thread. A run whose scene is edited continues with a new model; welds that it makes are its own state.
struct Model {
  Scene scene;  // with all bodies listed, those of the generators too
  Needs needs;
  MassProperties mass;
  Geometry shapes;
  Surfaces surfaces;
  ForceTerms forces;
  JointTerms joint_terms;
  std::vector<std::uint8_t> kinematic;  // by body; empty without kinematic bodies
  bool smooth_discs = false;            // no rotation, friction, sticking, joints or switched forces
  double start_time = 0.0;              // s, of a run

  [[nodiscard]] const std::vector<Body>& bodies() const { return scene.bodies; }
  [[nodiscard]] bool is_kinematic(int body) const { return !kinematic.empty() && kinematic[body] != 0; }
  [[nodiscard]] const Drive& drive(int body) const { return *scene.bodies[body].drive; }
  [[nodiscard]] bool infinite_mass(int body) const { return shapes.fixed[body] != 0; }
};

// The scene must be valid (validate.h). A run of it starts at `start_time` (s), which sets the drives'
// positions.
[[nodiscard]] std::shared_ptr<const Model> compile(Scene scene, const Needs& needs, double start_time = 0.0);

}  // namespace carom
