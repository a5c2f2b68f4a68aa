#pragma once

#include <cstddef>

#include "physics/model/body_starts.h"
#include "physics/model/force_terms.h"
#include "physics/model/geometry.h"
#include "physics/model/joint_terms.h"
#include "physics/model/mass.h"
#include "physics/model/surfaces.h"

namespace carom {

// What the step works on: masses, shapes, surfaces, forces and joints of a scene as arrays by index, without
// its names, and only the parts that it needs. Compiled once (compiled_scene.h), then constant and shared by
// all runs and their copies, on any thread. A run whose scene is edited continues with a new model; welds that
// it makes are its own state.
struct Model {
  BodyStarts starts;
  MassProperties mass;
  Geometry shapes;
  Surfaces surfaces;
  ForceTerms forces;
  JointTerms joint_terms;
  DriveTerms drives;
  ImpactLawId impact_law = ImpactLawId::kEnergetic;
  SeveralImpactsId several_impacts = SeveralImpactsId::kPairwise;
  bool smooth_discs = false;  // no rotation, friction, sticking, joints or switched forces
  bool untrimmed = false;     // without short cuts that change only rounding: all bodies are advanced together
  double start_time = 0.0;    // s, of a run

  [[nodiscard]] std::size_t bodies() const { return shapes.fixed.size(); }  // how many
  [[nodiscard]] bool is_kinematic(BodyIndex body) const { return drives.drives(body); }
  [[nodiscard]] const Drive& drive(BodyIndex body) const { return drives.at(body).law; }
  [[nodiscard]] bool infinite_mass(BodyIndex body) const { return shapes.fixed[body] != 0; }
};

}  // namespace carom
