#pragma once

#include <memory>

#include "physics/collision/approach.h"
#include "physics/dynamics/trajectories.h"
#include "physics/impact/impact_law.h"
#include "physics/model/model.h"
#include "physics/scene/method.h"
#include "physics/world/impact_record.h"
#include "physics/world/run_clock.h"
#include "physics/world/run_sums.h"
#include "physics/world/step_work.h"
#include "physics/world/totals.h"

namespace carom {

struct World;
// Resolves one impact (apply_impact.h).
using ApplyImpact = void (*)(World&, int a, int b, const Contact&, const Material&, double within);

// What every part of a step works on: the model, where its bodies are, and what the run has counted. A value:
// copies share the model alone.
struct World {
  // At the start of a run of this model.
  World(std::shared_ptr<const Model> model, const Method& method);

  std::shared_ptr<const Model> model;
  Method method;
  ApplyImpact apply_impact;  // of the model
  Trajectories trajectories;
  State state;  // at clock.time; the parts of a step publish it where they need it
  RunClock clock;
  RunSums sums;
  ImpactLog log;
  StepWork work;

  [[nodiscard]] int bodies() const { return static_cast<int>(model->bodies().size()); }
  [[nodiscard]] const MassProperties& mass() const { return model->mass; }
  [[nodiscard]] const Geometry& shapes() const { return model->shapes; }
  [[nodiscard]] const ForceField& field() const { return trajectories.field(); }
  [[nodiscard]] bool infinite_mass(int body) const { return model->infinite_mass(body); }
  [[nodiscard]] const Material& material(int a, int b) const { return model->surfaces.between(a, b); }
  // Whether one of them is no disc and moves.
  [[nodiscard]] bool has_moving_corners(int a, int b) const {
    return (!infinite_mass(a) && !shapes().is_disc(a)) || (!infinite_mass(b) && !shapes().is_disc(b));
  }

  // Puts another scene in place of the model's, with one body or one weld more. `within` is a time (s after the
  // epoch) at which all motions are known.
  void recompile(Scene scene, const Needs& needs, double within);
  // Empties the state for the bodies of the model.
  void resize_state();
  // Makes `state` the motions at this time, in s after the epoch.
  void publish(double within);
  // All motions then, of bodies whose trajectory starts later those at its start.
  [[nodiscard]] State state_at(double within);
  // One side of a contact of settled bodies; `towards` is +1 for its body a, -1 for b: the way that the normal
  // points from there.
  [[nodiscard]] ImpactSide side(int body, const Contact& contact, double towards) const;
  // m/s: how fast the settled bodies part along the contact's normal.
  [[nodiscard]] double parting_speed(int a, int b, const Contact& contact) const;
  // Of the settled bodies; gaps up to `tolerance` (m) beyond the least one count as touch.
  [[nodiscard]] Approach approach(int a, int b, double tolerance) const;
  // After a push moved one of its bodies: positions and velocities of an island go back onto its joints. The
  // energy is the push's, the momentum comes from what the joints are fastened to.
  void restore_joints(int island);

  // Of `state`.
  [[nodiscard]] Totals totals() const { return carom::totals(state, mass(), field()); }
  [[nodiscard]] Ledger ledger() const;  // with the work of the smooth forces up to now
  // Throws LostMotion where the state is beyond what can be computed with.
  void check_motions() const;
  // Tells by a notice that the method itself makes the energy.
  void check_energy();
  // Notes the time (s) at which something first happened.
  void note(double Notices::*notice, double time) {
    if (sums.notices.*notice < 0.0) sums.notices.*notice = time;
  }
};

}  // namespace carom
