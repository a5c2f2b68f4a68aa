#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

#include "physics/dynamics/state.h"
#include "physics/ledger/impact_counts.h"
#include "physics/ledger/impact_record.h"
#include "physics/ledger/ledger.h"
#include "physics/ledger/notices.h"
#include "physics/ledger/totals.h"
#include "physics/math/vectors.h"
#include "physics/model/compiled_scene.h"
#include "physics/run/lost_run.h"
#include "physics/run/run_setup.h"
#include "physics/step/contact_force.h"
#include "physics/step/run_clock.h"

namespace carom {

struct Checkpoint;       // physics/run/checkpoint.h
struct RunState;         // physics/run/run_state.h
struct SimulationParts;  // physics/run/simulation_parts.h
struct LostMotion;       // physics/dynamics/lost_motion.h

// A scene in motion: one world under one method. A value: copies are independent and share only the compiled
// scene.
//
// The method chooses one of two strategies for impacts, at the step's end (step_end_impacts.h) or at their
// own time (event_driven_impacts.h). Resting contacts (resting_contacts.h) are added if the method asks for
// them and the scene needs them. Where surfaces stick, an impact adds a weld between its two bodies, in this
// run alone.
//
// Use: construct, then call step() or advance_to() as often as needed, and read state(), ledger(),
// last_impacts() between two steps. Not thread-safe, except that a stop of the token given to interrupt_on()
// may be requested from any thread.
class Simulation {
 public:
  // The scene must be valid (see validate() in physics/scene/validate.h). `needs` names the parts of the
  // model to compile. A saved run continues from its checkpoint.
  explicit Simulation(const RunSetup& setup) : Simulation(setup, needs_of(setup.scene)) {}
  Simulation(const RunSetup& setup, const Needs& needs);
  // At the start of a run of this scene.
  Simulation(std::shared_ptr<const CompiledScene> compiled, const Method& method);
  // At a later moment: `state` is from a run of the same scene, which continues here bit by bit.
  Simulation(std::shared_ptr<const CompiledScene> compiled, const RunState& state);
  Simulation(const Simulation& other);
  Simulation(Simulation&& other) noexcept;
  Simulation& operator=(const Simulation& other);
  Simulation& operator=(Simulation&& other) noexcept;
  ~Simulation();

  // One step of next_step() s.
  void step();
  // s: the method's length, or less where an edit of the scene is due before its end, so that each has its own
  // time; then what is left of the step that it divides. Edits that are due now are thought of as made.
  [[nodiscard]] double next_step() const;
  // s: of the step from now towards `time`; 0 at that time.
  [[nodiscard]] double next_step(double time) const { return step_towards(time, this->time(), next_step()); }
  // A step of h > 0 s. Throws StepInterrupted (physics/step/step_work.h) if a stop was requested
  // (interrupt_on()); the simulation is then unusable. A run whose motion is lost is no error but a status: it
  // stays where it is, and a step does nothing.
  void step(double h);
  // Steps end early once a stop is requested.
  void interrupt_on(std::stop_token stop);
  // Steps until `time`, with shorter steps to it and to edits where needed, and calls after_step() after each.
  // Whole steps keep time = start + k h without summing. Edits that are due at `time` are made too.
  template <class AfterStep>
  void advance_to(double time, const AfterStep& after_step) {
    while (!lost_) {
      apply_all_due();
      const double h = next_step(time);
      if (h == 0.0) return;
      step(h);
      if (!lost_) after_step();
    }
  }
  void advance_to(double time) {
    advance_to(time, [] {});
  }

  // The scene as it was at the start, or at the last edit of it, and its model.
  [[nodiscard]] const std::shared_ptr<const CompiledScene>& compiled() const { return compiled_; }
  [[nodiscard]] const std::shared_ptr<const Model>& model() const;
  [[nodiscard]] double time() const;
  [[nodiscard]] std::int64_t steps() const;
  [[nodiscard]] std::int64_t impact_count() const;
  // With the pairs named in the setup.
  [[nodiscard]] const ImpactCounts& impact_counts() const;
  // Evaluations of the right-hand side, each body counted, and steps rejected by the error control.
  [[nodiscard]] std::int64_t evaluations() const;
  [[nodiscard]] std::int64_t rejected_steps() const;
  [[nodiscard]] const State& state() const;
  [[nodiscard]] const std::vector<Body>& bodies() const { return compiled_->scene.bodies; }
  [[nodiscard]] const MassProperties& mass() const;
  [[nodiscard]] const Geometry& shapes() const;
  // Those of the scene, then a weld for each impact after which two bodies stuck together.
  [[nodiscard]] std::vector<Joint> joints() const;
  // The bodies that are one, by a weld of the scene or of the run.
  [[nodiscard]] const WeldedBodies& welded() const;
  [[nodiscard]] bool is_taut(JointIndex joint) const;   // of a string
  [[nodiscard]] double length(JointIndex joint) const;  // m, of a rod or a string
  [[nodiscard]] const ForceField& field() const;
  [[nodiscard]] const Method& method() const;
  [[nodiscard]] const Needs& needs() const { return compiled_->needs; }
  [[nodiscard]] Notices notices() const;
  // In one line, "ok" if there are none, and in a few words each; bodies have their names.
  [[nodiscard]] std::string notices_text() const { return notices().text(body_name()); }
  [[nodiscard]] std::string notices_brief() const { return notices().brief(body_name()); }
  // Why the run can't continue; nothing while it can.
  [[nodiscard]] const std::optional<LostRun>& lost() const { return lost_; }
  // notices_text(), and why the run can't continue.
  [[nodiscard]] std::string status() const;
  [[nodiscard]] Totals totals() const;
  // m/s², m/s², rad/s²: by body, if they were in this state at this moment (s), by the springs, strings and
  // contacts that act now. Zero for bodies that forces don't move; of one body it leaves out others, too.
  [[nodiscard]] Eigen::Matrix3Xd accelerations(const State& state, double time, BodyIndex of = kNoBody) const;
  [[nodiscard]] Totals totals_of(const State& state) const { return carom::totals(state, mass(), field()); }
  // With the work of the smooth forces up to now.
  [[nodiscard]] Ledger ledger() const;
  // The impacts of the last call of step(), in the order of time.
  [[nodiscard]] const std::vector<ImpactRecord>& last_impacts() const;
  // The jumps of the first of these, one each, if watch_impacts(true) was called.
  [[nodiscard]] const std::vector<Jump>& last_jumps() const;
  void watch_impacts(bool on);
  // The contact forces of the last step; empty without resting contacts.
  [[nodiscard]] const std::vector<ContactForce>& contact_forces() const;

  // From the next step on. A lost run stays as it is, here and in apply().
  void set_method(const Method& method);
  // Changes the scene now (see RunEdit); the energy and momenta that this brings count as the user's. The scene
  // must be valid afterwards (apply_edit.cpp).
  void apply(const SceneEdits& edits);
  [[nodiscard]] bool is_due(const RunEdit& edit) const { return carom::is_due(edit, time(), method().step); }
  // The next edit of the setup, if it is due at this moment; else nullptr. The next step begins with all of
  // them.
  [[nodiscard]] const RunEdit* due() const;
  void apply_due();
  // Other edits of the setup; those that were applied stay the same.
  void set_edits(std::vector<RunEdit> edits);
  // How many of them were applied.
  [[nodiscard]] std::size_t edits_applied() const { return edits_applied_; }
  // The complete state between two steps (run_state.cpp).
  [[nodiscard]] RunState run_state() const;
  // What a preset file keeps of it (checkpoint.cpp).
  [[nodiscard]] Checkpoint checkpoint() const;

 private:
  [[nodiscard]] Notices::BodyName body_name() const;
  void apply_all_due();
  void choose_strategies();
  void move_hand(const Vec2& place);  // m
  void count_pairs(const std::vector<std::pair<std::string, std::string>>& names);
  void make_step(double h);
  [[nodiscard]] double undivided_step() const;
  void give_up(const LostMotion& lost);
  void go_on_from(const SavedRun& saved);
  void go_on_from(const Checkpoint& from);
  void restore(const RunState& state);

  std::shared_ptr<const CompiledScene> compiled_;
  std::unique_ptr<SimulationParts> parts_;  // those that move
  std::optional<LostRun> lost_;
  std::shared_ptr<const std::vector<RunEdit>> edits_ = std::make_shared<const std::vector<RunEdit>>();
  std::size_t edits_applied_ = 0;
};

}  // namespace carom
