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

// What the step works on: a scene with indices in place of names, its masses, shapes and forces as arrays, and
// only the parts that it needs. Compiled once, then shared by all runs and copies of a run; nobody changes it.
// A run that gets one more body, or in which two stick together, goes on with a model compiled anew.
struct Model {
  Scene scene;  // whose bodies are all of them, those of the generators too
  Needs needs;
  MassProperties mass;
  Geometry shapes;
  Surfaces surfaces;
  ForceTerms forces;
  JointTerms joint_terms;
  std::vector<std::uint8_t> kinematic;  // by body; empty without kinematic bodies
  bool smooth_discs = false;            // impacts are between centres: nothing turns, rubs, sticks or is joined
  double start_time = 0.0;              // s, of a run

  [[nodiscard]] const std::vector<Body>& bodies() const { return scene.bodies; }
  [[nodiscard]] bool is_kinematic(int body) const { return !kinematic.empty() && kinematic[body] != 0; }
  [[nodiscard]] const Drive& drive(int body) const { return *scene.bodies[body].drive; }
  [[nodiscard]] bool infinite_mass(int body) const { return shapes.fixed[body] != 0; }
};

// The scene must be valid. A run of it starts at `start_time` (s), where its drives are then.
[[nodiscard]] std::shared_ptr<const Model> compile(Scene scene, const Needs& needs, double start_time = 0.0);

}  // namespace carom
