#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "physics/collision/approach.h"
#include "physics/dynamics/trajectories.h"
#include "physics/impact/impact_law.h"
#include "physics/ledger/impact_record.h"
#include "physics/ledger/run_sums.h"
#include "physics/ledger/totals.h"
#include "physics/model/model.h"
#include "physics/scene/method.h"
#include "physics/step/run_clock.h"
#include "physics/step/step_work.h"

namespace carom {

struct World;
// What an impact did.
enum class ImpactEffect {
  kNone,     // the two don't close
  kBounced,  // their velocities have changed
  kJoined    // they have stuck together: the islands are different, and all of them start now
};
// Resolves one impact (apply_impact.h).
using ApplyImpact = ImpactEffect (*)(World&, BodyIndex a, BodyIndex b, const Contact&, const SurfaceLaw&,
                                     double within);

// The data that every part of a step works on: the model, the motions of its bodies, and the sums of the run.
// A value: copies share only the model.
struct World {
  // At the start of a run of this model.
  World(std::shared_ptr<const Model> model, const Method& method);

  std::shared_ptr<const Model> model;
  Method method;
  ApplyImpact apply_impact;          // of the model
  std::vector<BodyIndex> immovable;  // bodies of infinite mass without a drive
  Trajectories trajectories;
  State state;  // at clock.time; the parts of a step publish it when they need it
  RunClock clock;
  RunSums sums;
  ImpactLog log;
  StepWork work;

  [[nodiscard]] int bodies() const { return static_cast<int>(model->bodies()); }
  [[nodiscard]] const MassProperties& mass() const { return model->mass; }
  [[nodiscard]] const Geometry& shapes() const { return model->shapes; }
  [[nodiscard]] const ForceField& field() const { return trajectories.field(); }
  [[nodiscard]] bool infinite_mass(BodyIndex body) const { return model->infinite_mass(body); }
  [[nodiscard]] bool is_immovable(BodyIndex body) const {
    return model->infinite_mass(body) && !model->is_kinematic(body);
  }
  // Whether nothing moves either of them, or the same drive both.
  [[nodiscard]] bool stay_together(BodyIndex a, BodyIndex b) const {
    if (!infinite_mass(a) || !infinite_mass(b) || model->is_kinematic(a) != model->is_kinematic(b))
      return false;
    return !model->is_kinematic(a) || model->drive(a) == model->drive(b);
  }
  // Whether they move as one body: by a weld, or as nothing moves them, such as the tiles of a floor.
  [[nodiscard]] bool move_as_one(BodyIndex a, BodyIndex b) const {
    return a == b || (is_immovable(a) && is_immovable(b)) || trajectories.welded().are_one(a, b);
  }
  // Whether an impulse on one of them moves the other one at once: they are one, or joints connect them. Not
  // where they move as one body: that is hit where the pressure on all of it acts (pressed_contact).
  [[nodiscard]] bool move_each_other(BodyIndex a, BodyIndex b) const {
    return a == b || (trajectories.is_jointed(a) && trajectories.island_of(a) == trajectories.island_of(b) &&
                      !move_as_one(a, b));
  }
  // 1 where a moves as one with c and b with d, -1 where a does with d and b with c, 0 otherwise.
  [[nodiscard]] double same_sides(BodyIndex a, BodyIndex b, BodyIndex c, BodyIndex d) const {
    if (move_as_one(a, c) && move_as_one(b, d)) return 1.0;
    return move_as_one(a, d) && move_as_one(b, c) ? -1.0 : 0.0;
  }
  // Of the parts of a and b that touch.
  [[nodiscard]] const SurfaceLaw& material(const Contact& contact, BodyIndex a, BodyIndex b) const {
    return model->surfaces.between(shapes().parts_or_first(contact.parts, a, b));
  }
  // Whether the two can collide at all; not if they have stuck together.
  [[nodiscard]] bool can_collide(BodyIndex a, BodyIndex b) const {
    return shapes().can_collide(a, b, trajectories.welded());
  }
  // Whether one of them moves and is not a disc.
  [[nodiscard]] bool has_moving_corners(BodyIndex a, BodyIndex b) const {
    return (!infinite_mass(a) && !shapes().is_disc(a)) || (!infinite_mass(b) && !shapes().is_disc(b));
  }

  // Sets `state` to the motions at this time, in s after the epoch.
  void publish(double within) { trajectories.read(within, state); }
  // All motions at this time; a body whose trajectory starts later is taken at its start.
  [[nodiscard]] State state_at(double within);
  // One side of a contact, at the start of the body's trajectory. `towards` is +1 for the contact's body a,
  // -1 for b: the direction of the normal as seen from there.
  [[nodiscard]] ImpactSide side(BodyIndex body, const Contact& contact, double towards) const;
  // m/s: separation speed along the contact's normal, at the start of the trajectories.
  [[nodiscard]] double parting_speed(BodyIndex a, BodyIndex b, const Contact& contact) const;
  // At the start of the trajectories; gaps up to `tolerance` (m) above the smallest count as touching.
  [[nodiscard]] Approach approach(BodyIndex a, BodyIndex b, double tolerance, const ShapePair& parts) const;
  // Likewise, at the place where they approach fastest.
  [[nodiscard]] Approach fastest_approach(BodyIndex a, BodyIndex b, double tolerance,
                                          const ShapePair& parts) const;
  // After a push has moved a body: projects positions and velocities of its island onto the joints. The
  // energy counts as the push's, the momentum as that of the joints' anchors.
  void restore_joints(IslandIndex island);

  // Enters what bodies don't take of the angular momentum (about the origin) that an impulse j (N s) at a point
  // (m) and a moment (kg m²/s) give to them: all of it for a body of infinite mass, the moment about its centre
  // for a point-like one. `arm` (m) leads there from its centre.
  void record_angular_momentum(BodyIndex body, const Vec2& point, const Vec2& arm, const Vec2& j,
                               double moment) {
    if (mass().inverse_inertia[body] > 0.0) return;
    sums.ledger.angular_momentum_to_walls += cross(infinite_mass(body) ? point : arm, j) + moment;
  }

  // Of `state`.
  [[nodiscard]] Totals totals() const { return carom::totals(state, mass(), field()); }
  [[nodiscard]] Ledger ledger() const;  // with the work of the smooth forces up to now
  // Throws LostMotion if the state is out of the computable range.
  void check_motions() const;
  // Notes it if the method itself makes the energy.
  void check_energy();
  // Keeps the time (s) and the bodies of the first occurrence.
  void note(double Notices::*notice, double time, const NoticeBodies& of = {}) {
    if (sums.notices.*notice < 0.0) sums.notices.note(notice, time, of);
  }
};

}  // namespace carom
