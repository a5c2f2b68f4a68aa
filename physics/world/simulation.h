#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include "physics/collision/approach.h"
#include "physics/collision/broad_phase.h"
#include "physics/collision/cell_grid.h"
#include "physics/dynamics/tracks.h"
#include "physics/impact/impact_law.h"
#include "physics/impact/simultaneous_impact.h"
#include "physics/model/model.h"
#include "physics/scene/method.h"
#include "physics/scene/scene.h"
#include "physics/world/event_queue.h"
#include "physics/world/impact_counts.h"
#include "physics/world/impact_record.h"
#include "physics/world/lasting_contacts.h"
#include "physics/world/ledger.h"
#include "physics/world/lost_run.h"
#include "physics/world/notices.h"
#include "physics/world/pair_list.h"
#include "physics/world/run_setup.h"
#include "physics/world/step_limits.h"
#include "physics/world/step_work.h"
#include "physics/world/totals.h"

namespace carom {

// A scene in motion: one world under one method. It is a value: copies go separate ways and share nothing.
//
// Impacts at the step's end (the founding report's loop): all bodies fly for h, then each overlapping pair, in
// the order of index pairs, gets its impulse if it approaches, and a pseudo-spring moves it apart by
// kOverlapFraction of its overlap, shared by inverse mass.
//
// Impacts at their own time: each body, or each group that forces couple, keeps a time of its own, that of its
// last impact, and a track from there on (physics/dynamics/tracks.h). The first contact of two tracks is
// searched on the integrator's own map (physics/collision/time_of_impact.h); the earliest of all is resolved;
// only the bodies of an impact are touched, and only their neighbours searched again. The state at an impact is
// a true step of the method, so the integrator keeps its order through impacts. Impacts at one time go pair by
// pair, in the order of index pairs. Integrators with a step lay all tracks anew at each step's end. The
// adaptive one and exact flight need no common step: their tracks run on across it, and `step` is only the
// interval at which the state is looked at.
//
// Where surfaces stick an impact puts a weld between its two bodies, into this run alone. From that moment on,
// which stays exact, all bodies have tracks anew.
//
// Contacts that last, where the method asks for them and the scene needs them: forces hold what touches, found
// anew in each step (physics/world/lasting_contacts.h); all tracks then start anew with it.
class Simulation {
 public:
  // Fraction of an overlap that the pseudo-spring takes away in a step, dimensionless: small enough that a deep
  // overlap parts without a burst of speed (positions move, velocities don't), large enough that it is gone in
  // some 20 steps.
  static constexpr double kOverlapFraction = 0.2;
  // m/s; a pressed contact that rebounds slower than this is at rest: it would hop by v²/2g = 5e-14 m.
  static constexpr double kRestSpeed = 1e-6;
  // Under explicit Euler a pressed contact rests below kRestRebound e/(1 - e) |a| h, |a| being the
  // acceleration that presses it: its rebounds tend to e |a| h/(1 - e) and would never die out. At
  // most kMostRestRebound |a| h, so that nearly elastic bodies still bounce (and show that drift).
  static constexpr double kRestRebound = 1.5;
  static constexpr double kMostRestRebound = 5.0;
  // Inelastic collapse: a pair with e < 1 parts slower than this share of its own speed, in less time after the
  // impact before than doubles can tell apart.
  static constexpr double kCollapseShare = 1e-12;
  // Impacts at one time, to the last bit, after which closing speeds below that share are rounding: a light
  // body between two whose speeds it is too light to change would bounce to and fro for ever.
  static constexpr int kMostAtOnce = 10'000;
  // After more than kCrowdedImpacts + kCrowdedImpactsPerBody * N located impacts in one step, the guard against
  // inelastic collapse acts: a pair with e < 1 that rebounds slower than its forces can press it together in a
  // step rests until the step's end. A settling pile would otherwise need millions of impacts a step.
  static constexpr int kCrowdedImpacts = 100;
  static constexpr int kCrowdedImpactsPerBody = 4;
  // Parts of a step that touch-downs divide it into; what touches down in the last one is held from the next
  // step on.
  static constexpr int kMostHolds = 8;

  // The scene must be valid (see validate() in physics/scene/validate.h). `needs` says which parts of the model
  // are put in. Of a saved run, the run goes on from there: with its state, under the setup's method as if it
  // had been chosen at that moment.
  explicit Simulation(const RunSetup& setup) : Simulation(setup, needs_of(setup.scene)) {}
  Simulation(const RunSetup& setup, const Needs& needs);
  // At the start of a run of this model.
  Simulation(std::shared_ptr<const Model> model, const Method& method);
  // At a later moment: `state` is that of a run of the same model, which goes on here for the same bytes.
  Simulation(std::shared_ptr<const Model> model, const RunState& state);

  void step() { step(method_.step); }
  // Throws StepInterrupted if interrupt_on() asked for it; the simulation can only be thrown away then. A run
  // that is lost stands still: a step of it does nothing.
  void step(double h);
  // Steps end early once a stop is requested.
  void interrupt_on(std::stop_token stop) { work_.stop_on(std::move(stop)); }
  // Steps until `time`, with a last shorter step if needed, and calls after_step() after each. Whole steps keep
  // time = start + k h without summing.
  template <class AfterStep>
  void advance_to(double time, const AfterStep& after_step) {
    const double h = method_.step;
    // A remainder below 1e-9 steps is rounding.
    for (double left = time - time_; left > 1e-9 * h && !lost_; left = time - time_) {
      step(left > (1.0 - 1e-9) * h ? h : left);
      if (!lost_) after_step();
    }
  }
  void advance_to(double time) {
    advance_to(time, [] {});
  }

  [[nodiscard]] const std::shared_ptr<const Model>& model() const { return model_; }
  [[nodiscard]] double time() const { return time_; }
  [[nodiscard]] std::int64_t steps() const { return steps_; }
  [[nodiscard]] std::int64_t impact_count() const { return impact_count_; }
  // With the pairs that the setup names.
  [[nodiscard]] const ImpactCounts& impact_counts() const { return impact_counts_; }
  // Of the right-hand side, a body each; and steps that the error control took back.
  [[nodiscard]] std::int64_t evaluations() const { return tracks_.evaluations(); }
  [[nodiscard]] std::int64_t rejected_steps() const { return tracks_.rejected_steps(); }
  [[nodiscard]] const State& state() const { return state_; }
  [[nodiscard]] const std::vector<Body>& bodies() const { return model_->bodies(); }
  [[nodiscard]] const MassProperties& mass() const { return model_->mass; }
  [[nodiscard]] const Geometry& shapes() const { return model_->shapes; }
  // The scene's, and after them a weld for each impact after which two bodies have stuck together.
  [[nodiscard]] const std::vector<Link>& links() const { return model_->scene.links; }
  [[nodiscard]] bool is_taut(int link) const { return tracks_.is_taut(link); }  // of a string
  [[nodiscard]] const ForceField& field() const { return tracks_.field(); }
  [[nodiscard]] const Method& method() const { return method_; }
  [[nodiscard]] const Needs& needs() const { return model_->needs; }
  [[nodiscard]] Notices notices() const;
  // Why the run can't go on; nothing while it can.
  [[nodiscard]] const std::optional<LostRun>& lost() const { return lost_; }
  // What the run has to say about itself, in one line: "ok" if nothing.
  [[nodiscard]] std::string status() const;
  [[nodiscard]] Totals totals() const { return totals_of(state_); }
  [[nodiscard]] Totals totals_of(const State& state) const { return carom::totals(state, mass(), field()); }
  // With the work of the smooth forces up to now.
  [[nodiscard]] Ledger ledger() const;
  // The impacts of the last call of step(), in the order of time.
  [[nodiscard]] const std::vector<ImpactRecord>& last_impacts() const { return impacts_; }
  // Those of the first of these, one each.
  [[nodiscard]] const std::vector<Jump>& last_jumps() const { return jumps_; }

  // What held bodies together in the last step; empty without contacts that last.
  [[nodiscard]] const std::vector<ContactForce>& contact_forces() const { return lasting_.forces; }

  // From the next step on. A run that is lost stays as it is, here and with a body more.
  void set_method(const Method& method);
  // Fills last_jumps() for the first impacts of a step, at the cost of all bodies' motions twice each: up to
  // kMostWatched of a few bodies, of a crowd fewer, but kLeastWatched.
  static constexpr std::size_t kMostWatched = 64;
  static constexpr std::size_t kLeastWatched = 4;
  static constexpr std::size_t kMostWatchedMotions = 8192;
  void watch_impacts(bool on) { watch_impacts_ = on; }
  // Puts in one more body now; its energy is the user's. Its name must be new and its material known.
  void add_body(const Body& body);

  [[nodiscard]] double length(int link) const { return tracks_.length(link); }  // m, of a rod or a string
  // All that the next step starts from (run_state.cpp).
  [[nodiscard]] RunState run_state() const;

 private:
  // The state and the sums at the end of the last good step.
  struct LastGood {
    State state;
    Ledger ledger;
    Notices notices;
    std::int64_t impact_count = 0;
    ImpactCounts impact_counts;
  };

  template <class Self, class Kept, class Each>
  static void each_kept(Self& simulation, Kept& kept, const Each& each);
  void go_on_from(const SavedRun& saved);
  void put_back(const RunState& state);
  [[nodiscard]] bool runs_on() const;  // tracks run on across the ends of steps

  void lay_out();  // arrays for the bodies of the model
  // Goes on with this scene: one body or one weld more.
  void recompile(Scene scene, const Needs& needs, double within);
  void count_pairs(const std::vector<std::pair<std::string, std::string>>& names);
  void publish(double within);
  void check_motions() const;  // throws LostMotion
  void check_energy();
  void make_step(double h);
  void give_up(const LostMotion& lost);
  void resolve_at_end(const std::vector<WaitingPair>& pairs, double h);
  void restore_links(int island);
  void step_with_impacts_at_end(double h);
  // Resolves the impact of two bodies at their settled poses, `within` s after the epoch, and logs it.
  void collide(int a, int b, const Contact& contact, const Material& material, double within);
  // Joins two settled bodies for good (sticking.cpp): from then on they can't meet, and islands are others.
  [[nodiscard]] Impact join(int a, int b, const Contact& contact);
  // Counts and logs an impact that has been resolved, and keeps the ledger.
  void book(int a, int b, const Contact& contact, const Impact& impact, double closing, double within);
  [[nodiscard]] State state_at(double within);
  [[nodiscard]] bool watches_more() const {
    const std::size_t all = std::max<std::size_t>(bodies().size(), 1);
    return watch_impacts_ && jumps_.size() < std::clamp(kMostWatchedMotions / all, kLeastWatched, kMostWatched);
  }
  // One side of a contact; `towards` is +1 for its body a, -1 for b: the way that the normal points from there.
  [[nodiscard]] ImpactSide side(int body, const Contact& contact, double towards) const;
  // Of the settled bodies; gaps up to `tolerance` (m) beyond the least one count as touch.
  [[nodiscard]] Approach approach(int a, int b, double tolerance) const;
  [[nodiscard]] const Material& material_between(int a, int b) const { return model_->surfaces.between(a, b); }
  [[nodiscard]] bool immovable(int body) const { return model_->immovable(body); }

  // Contacts that last (lasting_contacts.cpp).
  void hold_contacts(double h);
  void find_contacts(double h);
  void project_contacts();
  void touch_down(double h);
  void find_contact_forces(double h);
  void book_contact_forces(double passed, double share);
  void book_contacts(double share);
  double process_holding(double h);
  double first_landing(double end, Landing& first);
  void land(const Landing& l, double within);
  void tell_residual(const ContactSolverReport& report);
  void rebound_at_end(const std::vector<std::pair<int, int>>& pairs);
  [[nodiscard]] ContactSolverOptions contact_options() const;
  // m/s: a contact that rebounds slower than this lasts, as what presses it would close it again within a step.
  [[nodiscard]] double rest_speed(int a, int b, const Vec2& normal, double restitution) const;
  [[nodiscard]] double rolling_radius(int a, int b) const;
  [[nodiscard]] bool holds(int a, int b) const;
  [[nodiscard]] bool stays_held(int a, int b) const;

  // Impacts at their own time (located_impacts.cpp, contact_search.cpp). Times are within the epoch of the
  // tracks.
  void step_with_located_impacts(double h);
  void lay_all(double horizon);
  void lay(int island, double horizon);
  void search_island(int island);
  void search(int a, int b);
  void search_discs(int a, int b, double start, double end);
  // A pair that is awaited lands at `target`.
  void process_until(double target, double horizon, double h, const Landing* awaited = nullptr);
  void meet(int a, int b, double time, double horizon, bool crowd, double h);
  // After an impact with e < 1: whether the pair rests from now on, or has collapsed.
  void judge(int a, int b, const Contact& contact, const Material& material, double time, bool crowd, double h);
  void find_due_islands(const std::vector<WaitingPair>& due);
  // Lays the tracks of these islands anew and searches them.
  void go_on(std::span<const int> islands, double horizon);
  // Simultaneous impacts (simultaneous_impacts.cpp): all that touches a or b, or what they touch, and so on.
  // False if there is nothing but the pair, or no solution.
  bool meet_all(int a, int b, double time, double horizon, bool crowd, double h);
  void touching(int a, int b, double time);
  void foresee(double time, int a, int b);
  void note_resting(double time) {
    if (!lasts_ && notices_.resting_since < 0.0) notices_.resting_since = time;
  }
  [[nodiscard]] bool is_stale(const Event& event) const;
  // Whether one of them is no disc and moves.
  [[nodiscard]] bool has_moving_corners(int a, int b) const {
    return (!immovable(a) && !shapes().is_disc(a)) || (!immovable(b) && !shapes().is_disc(b));
  }
  // m/s²: how the settled pair's forces, and a drive, press it together along the normal; negative if they part
  // it.
  [[nodiscard]] double pressing(int a, int b, const Contact& contact, double within);
  // m/s²: bounds how the paths of two bodies' points bend against each other.
  [[nodiscard]] double curvature(int a, int b, double of_centres) const;
  // m/s: closing speed that the forces alone can give a resting pair in a step.
  [[nodiscard]] double pressed_in(int a, int b, double h) const;
  [[nodiscard]] double touch_tolerance(int a, int b, double end) const;
  [[nodiscard]] bool rests(int a, int b) const;
  // Of the bodies' speeds: below this they don't close.
  [[nodiscard]] double closing_share() const {
    return at_once_ >= kMostAtOnce ? kCollapseShare : 16.0 * std::numeric_limits<double>::epsilon();
  }
  void choose_cells(double horizon);
  [[nodiscard]] const std::vector<std::pair<int, int>>& near_pairs();
  void note(double Notices::*notice, double time) {
    if (notices_.*notice < 0.0) notices_.*notice = time;
  }

  std::shared_ptr<const Model> model_;
  Method method_;
  Tracks tracks_;

  State state_;  // at time_
  double time_ = 0.0;
  double step_end_ = 0.0;  // of the step under way
  double origin_ = 0.0;    // time_ = origin_ + steps_since_origin_ * h
  double origin_step_ = 0.0;
  std::int64_t steps_since_origin_ = 0;
  std::int64_t steps_ = 0;
  std::int64_t impact_count_ = 0;
  ImpactCounts impact_counts_;
  std::int64_t impacts_before_step_ = 0;
  Ledger ledger_;               // without the work of the smooth forces, which the state carries
  double gravity_since_ = 0.0;  // s: ledger_.momentum_from_gravity holds what came before
  double peak_kinetic_ = 0.0;   // J: the most up to now
  int energy_doubts_ = 0;       // see check_energy()
  Notices notices_;
  std::optional<LostRun> lost_;
  LastGood last_good_;
  StepWork work_;
  std::vector<ImpactRecord> impacts_;
  std::vector<Jump> jumps_;
  bool watch_impacts_ = false;

  // Impacts at their own time.
  bool running_ = false;       // tracks, grid and queue hold since the last step
  double reach_ = 1.0;         // m: length of a track that no step ends
  double epoch_length_ = 1.0;  // s, a power of two
  double last_impact_ = -1.0;  // s within the epoch
  int at_once_ = 0;            // impacts before it at the same time
  CellGrid grid_;
  EventQueue queue_;
  std::vector<std::uint32_t> stamp_;  // by body, of its island; fixed bodies keep theirs
  PairList deferred_;
  PairList due_;
  std::vector<int> due_islands_;  // of due_, where tracks run on
  std::vector<bool> is_due_;      // by island
  std::vector<WaitingPair> near_pairs_;
  int track_ends_ = 0;    // in this step
  double stretch_ = 1.0;  // of tracks that no step ends, where too many ended
  struct Touch {
    int a;
    int b;
    Contact contact;
  };
  std::vector<Touch> touches_;  // of a cluster
  std::vector<int> cluster_;    // its bodies
  ClusterScratch cluster_scratch_;

  // Contacts that last.
  bool lasts_ = false;        // the method asks for them, and the scene needs them
  double step_length_ = 0.0;  // s, of the step under way; of a whole one where it is shorter
  bool may_divide_ = false;
  double touched_down_ = -1.0;  // s within the epoch: where the step is to be divided
  LastingContacts lasting_;

  // Impacts at the step's end.
  BroadPhase broad_phase_;
  std::vector<Bounds> bounds_;
};

}  // namespace carom
