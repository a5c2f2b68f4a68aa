#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "physics/collision/broad_phase.h"
#include "physics/collision/geometry.h"
#include "physics/contact/impact_law.h"
#include "physics/motion/force_field.h"
#include "physics/motion/state.h"
#include "physics/scene/scene.h"
#include "physics/world/ledger.h"
#include "physics/world/totals.h"

namespace carom {

// One impact of a run, as the log keeps it. Bodies are indices into Simulation::bodies(), a < b; the normal
// points from a to b and the impulse acts on b. Times in s, points in m, impulses in N s, energies in J.
struct ImpactRecord {
  double time = 0.0;
  int a = 0;
  int b = 0;
  Vec2 point = Vec2::Zero();
  Vec2 normal = Vec2::UnitX();
  double normal_impulse = 0.0;
  double tangential_impulse = 0.0;
  double closing_speed = 0.0;  // m/s, > 0
  double lost_to_restitution = 0.0;
  double lost_to_friction = 0.0;
  // Of the whole scene, so that plots jump where the motion does. Only with Simulation::watch_impacts, and only
  // for the first kMostWatched impacts of a step.
  bool watched = false;
  Totals before;
  Totals after;
};

// What a run has to say about itself beside its numbers: each is an expected numerical outcome, never an error.
struct Notices {
  // Bounces came to follow one another faster than the method resolves (Zeno), first at this time; from there
  // the pair is held by inelastic impacts at the end of each step. Negative: never.
  double resting_since = -1.0;
  // The limit kMostImpactsPerStep was reached, first at this time; the rest of that step was resolved at its
  // end.
  double impacts_capped_since = -1.0;

  // One line for people; "ok" if there is nothing to tell.
  [[nodiscard]] std::string text() const;
};

// A scene in motion: one world under one method. It is a value: copies go separate ways and share nothing.
//
// Impacts at the step's end (the founding report's loop): all bodies fly for h, then each overlapping pair, in
// the order of index pairs, gets its impulse if it approaches, and a pseudo-spring moves it apart by
// kOverlapFraction of its overlap, shared by inverse mass.
//
// Impacts at their own time: within a step each body keeps a local time, the time of its last impact. The first
// time of contact of each pair is searched on the integrator's own map (physics/collision/time_of_impact.h);
// the earliest is resolved; only the two bodies of an impact are touched and searched again. The state at an
// impact is a true step of the method, so the integrator keeps its order through impacts. Impacts at one time
// go pair by pair, in the order of index pairs.
class Simulation {
 public:
  // Fraction of an overlap that the pseudo-spring takes away in a step, dimensionless: small enough that a deep
  // overlap parts without a burst of speed (positions move, velocities don't), large enough that it is gone in
  // some 20 steps.
  static constexpr double kOverlapFraction = 0.2;
  // m/s; a pressed contact that rebounds slower than this is at rest: it would hop by v²/2g = 5e-14 m.
  static constexpr double kRestSpeed = 1e-6;
  // After more than kCrowdedImpacts + kCrowdedImpactsPerBody * N located impacts in one step, the guard against
  // inelastic collapse acts: a pair with e < 1 that rebounds slower than its forces can press it together in a
  // step rests until the step's end. A settling pile would otherwise need millions of impacts a step.
  static constexpr int kCrowdedImpacts = 100;
  static constexpr int kCrowdedImpactsPerBody = 4;
  // Located impacts in one step before the rest of it is resolved at its end. A million takes about a second.
  static constexpr int kMostImpactsPerStep = 1'000'000;

  // The scene must be valid (see validate() in physics/scene/validate.h).
  explicit Simulation(const Scene& scene);

  void step() { step(method_.step); }
  void step(double h);
  // Steps until `time`, with a last shorter step if needed, and calls after_step() after each. Whole steps keep
  // time = start + k h without summing.
  template <class AfterStep>
  void advance_to(double time, const AfterStep& after_step) {
    const double h = method_.step;
    // A remainder below 1e-9 steps is rounding.
    for (double left = time - time_; left > 1e-9 * h; left = time - time_) {
      step(left > (1.0 - 1e-9) * h ? h : left);
      after_step();
    }
  }
  void advance_to(double time) {
    advance_to(time, [] {});
  }

  [[nodiscard]] double time() const { return time_; }
  [[nodiscard]] std::int64_t steps() const { return steps_; }
  [[nodiscard]] std::int64_t impact_count() const { return impact_count_; }
  // Of the right-hand side, a body each; and steps that the error control took back.
  [[nodiscard]] std::int64_t evaluations() const { return evaluations_; }
  [[nodiscard]] std::int64_t rejected_steps() const { return rejected_steps_; }
  [[nodiscard]] const State& state() const { return state_; }
  [[nodiscard]] const std::vector<Body>& bodies() const { return bodies_; }
  [[nodiscard]] const MassProperties& mass() const { return mass_; }
  [[nodiscard]] const Geometry& shapes() const { return shapes_; }
  [[nodiscard]] const ForceField& field() const { return field_; }
  [[nodiscard]] const Method& method() const { return method_; }
  [[nodiscard]] const Notices& notices() const { return notices_; }
  [[nodiscard]] Totals totals() const { return carom::totals(state_, mass_, field_); }
  // With the drag work of the moment.
  [[nodiscard]] Ledger ledger() const;
  // The impacts of the last call of step(), in the order of time.
  [[nodiscard]] const std::vector<ImpactRecord>& last_impacts() const { return impacts_; }

  // From the next step on.
  void set_method(const Method& method);
  // Fills `before` and `after` of the records, at the cost of two sums over all bodies an impact.
  static constexpr int kMostWatched = 32;
  void watch_impacts(bool on) { watch_impacts_ = on; }
  // Puts in one more body now; its energy is the user's. Its name must be new and its material known.
  void add_body(const Body& body);

 private:
  struct Event {
    double time;  // within the step, s
    int a;
    int b;
  };
  struct Deferred {
    int a;
    int b;
    bool resting;
  };

  void fly(double h);
  void resolve_at_end(const std::vector<Deferred>& pairs, double h);
  void step_with_located_impacts(double h);
  void predict(int body, double h);
  void search(int a, int b, double h);
  // Resolves the impact of two bodies at their present poses, `within` s after the step began, and logs it.
  void collide(int a, int b, const Contact& contact, const Material& material, double within);
  void defer(int a, int b, bool resting, double within);
  [[nodiscard]] bool pressed_together(int a, int b, const Vec2& normal) const;
  // m/s: closing speed that the forces alone can give a resting pair in a step.
  [[nodiscard]] double pressed_in(int a, int b, double h) const;
  [[nodiscard]] double touch_tolerance(int a, int b, double h) const;
  [[nodiscard]] Totals totals_at(double within) const;
  // One side of a contact; `towards` is +1 for its body a, -1 for b: the way that the normal points from there.
  [[nodiscard]] ImpactSide side(int body, const Contact& contact, double towards) const;
  [[nodiscard]] Motion motion_at(int body, double time) const;
  [[nodiscard]] const Material& material_between(int a, int b) const;
  void lay_out();  // arrays from bodies_

  Scene scene_;
  Method method_;
  std::vector<Body> bodies_;
  MassProperties mass_;
  Geometry shapes_;
  ForceField field_;
  std::vector<int> material_;
  std::vector<Material> mixed_;  // material pairs, row by row
  int materials_ = 0;

  State state_;
  double time_ = 0.0;
  double step_end_ = 0.0;  // of the step under way
  double origin_ = 0.0;    // time_ = origin_ + steps_since_origin_ * h
  double origin_step_ = 0.0;
  std::int64_t steps_since_origin_ = 0;
  std::int64_t steps_ = 0;
  std::int64_t impact_count_ = 0;
  std::int64_t evaluations_ = 0;
  std::int64_t rejected_steps_ = 0;
  Ledger ledger_;  // without the drag work, which the state carries
  Notices notices_;
  std::vector<ImpactRecord> impacts_;
  bool watch_impacts_ = false;

  // Work space of a step; its capacity is kept.
  BroadPhase broad_phase_;
  std::vector<Bounds> bounds_;
  std::vector<double> local_time_;
  State end_;
  Eigen::VectorXd acceleration_;  // m/s², bound on each body's path curvature within the step
  std::vector<Event> events_;
  std::vector<Deferred> deferred_;
};

}  // namespace carom
