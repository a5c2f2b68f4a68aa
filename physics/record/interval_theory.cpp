#include "physics/record/interval_theory.h"

#include <algorithm>
#include <cstddef>
#include <string>

#include "physics/math/vectors.h"
#include "physics/model/bodies_by_name.h"
#include "physics/scene/forces.h"

namespace carom {
namespace {

// What acts beside gravity: on each body, and from outside on all of them.
struct Actions {
  std::vector<NoIntervalLaw> on;  // by body
  NoIntervalLaw from_outside = NoIntervalLaw::kNone;
  NoIntervalLaw turning = NoIntervalLaw::kNone;  // from outside too, about the origin alone
  bool within = false;                           // joints or forces between the bodies, which may do work

  explicit Actions(const RunInterval& interval) : on(interval.compiled->model.bodies(), NoIntervalLaw::kNone) {
    const Model& model = interval.compiled->model;
    for (BodyIndex i{0}; i < static_cast<int>(on.size()); ++i) {
      if (interval.touched[i]) add(i, NoIntervalLaw::kTouches);
    }
    const ForceTerms& forces = model.forces;
    if (!forces.applied.empty() || forces.hand) from_outside = NoIntervalLaw::kForces;
    within = !forces.springs.empty() || !interval.joints.empty();
    each_common_force(forces, [this](const CommonForce& force, const auto& value, const auto&...) {
      if (!carom::acts(value)) return;
      std::fill(on.begin(), on.end(), NoIntervalLaw::kForces);
      if (force.on == ActsOn::kEachBody) from_outside = NoIntervalLaw::kForces;
      if (force.on == ActsOn::kEachPair) within = true;
    });
    for (const AppliedTerm& term : forces.applied) add(term.body, NoIntervalLaw::kForces);
    if (forces.hand) add(forces.hand->body, NoIntervalLaw::kForces);
    for (const SpringTerm& term : forces.springs) {
      add_pair(term.body, term.other, NoIntervalLaw::kForces);
      const bool idle = is_beside_point(model, term.body, term.point) ||
                        (term.other >= 0 && is_beside_point(model, term.other, term.other_point));
      if (idle) turning = NoIntervalLaw::kForces;
    }
    add_joints(interval);
  }

 private:
  // Whose torque turns nothing.
  static bool is_beside_point(const Model& model, BodyIndex body, const Vec2& point) {
    return !point.isZero(0.0) && !(model.mass.inverse_inertia[body] > 0.0);
  }
  void add(BodyIndex body, NoIntervalLaw why) {
    NoIntervalLaw& found = on[static_cast<std::size_t>(body)];
    if (found == NoIntervalLaw::kNone) found = why;
  }
  // `other`: -1 where the other end cannot move.
  void add_pair(BodyIndex body, BodyIndex other, NoIntervalLaw why) {
    add(body, why);
    if (other >= 0) {
      add(other, why);
    } else if (from_outside == NoIntervalLaw::kNone) {
      from_outside = why;
    }
  }
  void add_joints(const RunInterval& interval) {
    if (interval.joints.empty()) return;
    const std::vector<Body>& bodies = interval.compiled->scene.bodies;
    const auto index = bodies_by_name(bodies);
    const auto movable = [&](const std::string& name) {
      const auto found = index.find(name);
      return found == index.end() || has_infinite_mass(bodies[found->second]) ? kNoBody : found->second;
    };
    for (const Joint& joint : interval.joints) {
      const BodyIndex ends[] = {movable(joint.body), movable(joint.to)};
      if (ends[0] >= 0) add_pair(ends[0], ends[1], NoIntervalLaw::kJoints);
      if (ends[0] < 0 && ends[1] >= 0) add_pair(ends[1], kNoBody, NoIntervalLaw::kJoints);
    }
  }
};

// Sums over the bodies that move freely.
struct Sums {
  double mass = 0.0;
  Vec2 moment = Vec2::Zero();  // Σ m x, kg m
  Vec2 momentum = Vec2::Zero();
  double angular = 0.0;
  double kinetic = 0.0;

  Sums(const State& state, const Model& model) {
    for (BodyIndex i{0}; i < state.size(); ++i) {
      if (!model.infinite_mass(i)) add(state, model.mass, i);
    }
  }

 private:
  void add(const State& state, const MassProperties& of, int i) {
    const Vec2 p = of.mass[i] * state.velocity(i);
    const double spin = state.v.col(i)[2];
    mass += of.mass[i];
    moment += of.mass[i] * state.position(i);
    momentum += p;
    angular += cross(state.position(i), p) + of.inertia[i] * spin;
    kinetic += 0.5 * p.dot(state.velocity(i)) + 0.5 * of.inertia[i] * spin * spin;
  }
};

// Whether no impact of any of the surfaces loses energy.
bool all_elastic(const Surfaces& surfaces) {
  return std::all_of(surfaces.pairs.begin(), surfaces.pairs.end(), [](const SurfaceLaw& law) {
    return law.restitution == 1.0 && law.kinetic_friction == 0.0 && !law.sticks;
  });
}

// Whether a body was touched of which `is` holds.
template <class Is>
bool touched_any(const RunInterval& interval, const Is& is) {
  for (BodyIndex i{0}; i < static_cast<int>(interval.touched.size()); ++i) {
    if (interval.touched[i] && is(i)) return true;
  }
  return false;
}

NoIntervalLaw no_kinetic_law(const RunInterval& interval, const Actions& acting) {
  const Model& model = interval.compiled->model;
  if (acting.from_outside != NoIntervalLaw::kNone) return acting.from_outside;
  if (acting.within) return interval.joints.empty() ? NoIntervalLaw::kForces : NoIntervalLaw::kJoints;
  const bool walls = touched_any(interval, [&model](BodyIndex i) { return model.infinite_mass(i); });
  const bool driven = touched_any(interval, [&model](BodyIndex i) { return model.is_kinematic(i); });
  if (driven || (walls && !model.forces.gravity.isZero(0.0))) return NoIntervalLaw::kWalls;
  const bool hits = touched_any(interval, [](BodyIndex) { return true; });
  return hits && !all_elastic(model.surfaces) ? NoIntervalLaw::kLosses : NoIntervalLaw::kNone;
}

}  // namespace

IntervalTheory theory_of(const RunInterval& interval) {
  const Model& model = interval.compiled->model;
  IntervalTheory theory;
  if (interval.edited) {
    theory.no_velocity.assign(model.bodies(), NoIntervalLaw::kEdits);
    theory.no_momentum = theory.no_angular = theory.no_kinetic = NoIntervalLaw::kEdits;
    return theory;
  }
  const double t = interval.to - interval.from;
  const Vec2& g = model.forces.gravity;
  Actions acting(interval);
  theory.no_kinetic = no_kinetic_law(interval, acting);
  const bool walls = touched_any(interval, [&model](BodyIndex i) { return model.infinite_mass(i); });
  theory.no_momentum = walls ? NoIntervalLaw::kWalls : acting.from_outside;
  theory.no_angular = theory.no_momentum == NoIntervalLaw::kNone ? acting.turning : theory.no_momentum;
  theory.no_velocity = std::move(acting.on);
  theory.v = interval.before.v;
  theory.v.topRows<2>().colwise() += g * t;
  const Sums start(interval.before, model);
  theory.momentum = start.momentum + start.mass * t * g;
  theory.angular = start.angular + cross(Vec2(start.moment * t + 0.5 * t * t * start.momentum), g);
  theory.kinetic = start.kinetic + g.dot(Vec2(t * start.momentum + 0.5 * t * t * start.mass * g));
  return theory;
}

}  // namespace carom
