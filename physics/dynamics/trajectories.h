#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "physics/dynamics/flights.h"
#include "physics/dynamics/lost_motion.h"
#include "physics/dynamics/switch_search.h"
#include "physics/dynamics/trajectory_state.h"

namespace carom {

// The motion of every body as a function of time, each known over an interval of its own.
//
// An island (physics/dynamics/flights.h) has a start, to which its motion was advanced last, and a trajectory:
// the integrator's map from there on, valid up to its end. What is found on a trajectory (an impact's time,
// say) is therefore found on the integrator's own map.
//
// A trajectory ends at the horizon that is asked for, or before: where an applied force changes its law, where
// a one-sided spring or a string starts or stops to act (located to the last bit), after one accepted step of
// the adaptive integrator, or, without a step to limit it, where the body has moved by `reach`.
//
// Order of calls: begin() once; in each step begin_step(), then for each island rebuild() its trajectory,
// advance_to() a time on it, change velocities there, and rebuild() again. One thread at a time.
// Times are in s after the epoch. The trajectory of a fixed body is its place for ever.
class Trajectories {
 public:
  Trajectories() = default;
  // At the start of a run, from the positions and velocities of the bodies.
  Trajectories(const std::shared_ptr<const Model>& model, const Method& method);

  void set_method(const Method& method) { flights_.set_method(method); }
  [[nodiscard]] const ForceField& field() const { return flights_.field; }
  void set_hand_place(const Vec2& place) { flights_.field.set_hand_place(place); }  // m
  [[nodiscard]] Indices<IslandIndex> islands() const { return flights_.islands.indices(); }
  [[nodiscard]] IslandIndex island_of(BodyIndex body) const { return flights_.island_of[body]; }  // none: fixed
  // In rising order.
  [[nodiscard]] std::span<const BodyIndex> members(IslandIndex island) const {
    return flights_.members_of(flights_.islands[island]);
  }

  // Starts all islands at this absolute time, from their present motions.
  void begin(double epoch);
  [[nodiscard]] double epoch() const { return flights_.epoch; }
  // Moves the epoch on; no motion changes.
  void shift_epoch(double by);
  [[nodiscard]] double start(BodyIndex body) const {
    const IslandIndex k = flights_.island_of[body];
    return k == kNoIsland ? -Flights::kForever : flights_.islands[k].start;
  }
  [[nodiscard]] double end(BodyIndex body) const {
    const IslandIndex k = flights_.island_of[body];
    return k == kNoIsland ? Flights::kForever : flights_.islands[k].end;
  }

  // The motion at the start and at the end of the body's trajectory.
  [[nodiscard]] auto at_start(BodyIndex body) const { return flights_.at_start.col(body); }
  [[nodiscard]] auto at_end(BodyIndex body) const { return flights_.at_end.col(body); }
  // start <= time <= end, or later until the trajectory is rebuilt.
  [[nodiscard]] Motion at(BodyIndex body, double time) { return flights_.at(body, time); }
  [[nodiscard]] Eigen::Vector3d place(BodyIndex body, double time) { return flights_.place(body, time); }
  [[nodiscard]] Kinematics kinematics(BodyIndex body, double time) { return flights_.kinematics(body, time); }
  // Likewise of all bodies.
  void read(double time, State& into) { flights_.read(time, into); }
  // All bodies at a time, each no earlier than its start, for who only looks: neither the work since
  // begin_step() nor any later motion knows of it.
  void look_at(double time, State& into);
  // Whether a body's acceleration by contacts changes: its parabola is bent.
  [[nodiscard]] bool is_bent(BodyIndex body) const { return flights_.is_bent(body); }
  // On a parabola only (see is_parabolic): q in m and rad at a time, and v.
  [[nodiscard]] Eigen::Vector3d parabola(BodyIndex body, double time) const {
    return flights_.parabola(body, time);
  }
  [[nodiscard]] Eigen::Vector3d parabola_velocity(BodyIndex body, double time) const {
    return flights_.parabola_velocity(body, time);
  }
  // kg m²/s, under gravity alone: what it has given to the body's angular momentum about the origin.
  [[nodiscard]] double angular_impulse_of_gravity(BodyIndex body, double time) const {
    return flights_.angular_impulse_of_gravity(body, time);
  }
  // True if every free flight is a parabola, by the forces and under this integrator.
  [[nodiscard]] bool is_parabolic() const { return flights_.parabolic; }
  [[nodiscard]] Eigen::Vector3d constant_acceleration(BodyIndex body) const {
    return flights_.constant.col(body);
  }
  // m/s², m/s², rad/s²: of a movable body at the start of its trajectory.
  [[nodiscard]] Eigen::Vector3d acceleration(BodyIndex body) { return flights_.acceleration(body); }
  // Likewise of an island's bodies that forces move, if they were in this state at `time`, by the springs,
  // strings and contacts that act now; into their columns of `by`. No motion changes.
  void accelerations(IslandIndex island, const State& state, double time, Eigen::Matrix3Xd& by) {
    flights_.accelerations(flights_.islands[island], state, time, by);
  }
  // Sets the bounds for a search on an island's trajectory: curvature_bound(body) in m/s² bounds the
  // acceleration of the centre, turn_bound(body) in rad/s² bounds ω² + |α|.
  void bound_curvature(IslandIndex island);
  [[nodiscard]] double curvature_bound(BodyIndex body) const { return curvature_bound_[body]; }
  [[nodiscard]] double turn_bound(BodyIndex body) const { return turn_bound_[body]; }

  // Moves an island's start to a time of its trajectory; call rebuild() before the trajectory is used again.
  void advance_to(IslandIndex island, double time);
  // Set a body's velocity or position at the island's start, after an impact or a push.
  void set_velocity(BodyIndex body, const Vec2& velocity, double spin);
  void set_pose(BodyIndex body, const Eigen::Vector3d& q);
  // Acceleration of a body by resting contacts (m/s², m/s², rad/s²), for trajectories rebuilt from now on.
  void set_contact_acceleration(BodyIndex body, const Eigen::Vector3d& by);
  // Per s: how it changes, from the epoch on, until end_contact_rates() or the next set_contact_acceleration().
  void set_contact_rate(BodyIndex body, const Eigen::Vector3d& rate);
  void end_contact_rates() { flights_.field.end_contact_rates(); }
  // Budget of the adaptive integrator between two calls of begin_step(), in evaluations weighted by their cost
  // (attraction makes each cost more): about a second of work for few bodies.
  static constexpr std::int64_t kMostFlightWork = 5'000'000;
  static constexpr std::int64_t kMostFlightWorkPerBody = 200'000;
  // Resets flight_work() and saves for undo_step() which springs and strings act.
  void begin_step();
  // After an abandoned step: restores springs, strings and the loss to strings as at its beginning, but no
  // motions.
  void undo_step();
  [[nodiscard]] std::int64_t flight_work() const { return flights_.flight_work; }  // since begin_step()
  // Rebuilds an island's trajectory from its start, at most to `horizon`. Where no step limits it, `reach` in m
  // bounds the path, and `turn_bound` in rad the rotation of bodies with corners. Throws LostMotion if the
  // motion at its end is not finite or too large, or if the adaptive integrator has spent its budget.
  static constexpr double kUsualTurn = 6.0;  // rad
  void rebuild(IslandIndex island, double horizon, double reach, double turn_bound = kUsualTurn);
  // True if joints hold the body.
  [[nodiscard]] bool is_jointed(BodyIndex body) const {
    const IslandIndex k = flights_.island_of[body];
    const GroupIndex group = k == kNoIsland ? kNoGroup : flights_.islands[k].group;
    return group != kNoGroup && flights_.joints.has_joints(group);
  }
  [[nodiscard]] bool is_jointed(std::span<const BodyIndex> bodies) const {
    return std::any_of(bodies.begin(), bodies.end(), [this](BodyIndex i) { return is_jointed(i); });
  }
  [[nodiscard]] bool is_taut(JointIndex joint) const { return flights_.joints.taut(joint); }  // of a string
  [[nodiscard]] double length(JointIndex joint) const {
    return flights_.joints.length(joint);
  }  // m, of a rod or a string
  // An impact of bodies at their islands' starts, some of them jointed. `by` are the changes of (v, spin) of
  // each without joints; zero for bodies of infinite mass. project_changes() replaces them by the changes with
  // the joints' impulses, apply_changes() changes the motions of all jointed bodies. It returns false if a
  // string would have to push: the string is slack from then on; project the changes again.
  void project_changes(std::span<const BodyIndex> bodies, Eigen::Ref<Eigen::Matrix3Xd> by);
  [[nodiscard]] bool apply_changes(std::span<const BodyIndex> bodies,
                                   const Eigen::Ref<const Eigen::Matrix3Xd>& by);
  // Welds two bodies by a plastic impact at a time at which all motions are known. The islands are others
  // from then on, and all of them start at that time.
  struct WeldImpact {
    double taken;  // J, lost
    Vec2 impulse;  // N s, on weld.body
  };
  [[nodiscard]] WeldImpact add_weld(const Weld& weld, double time);
  // Those added so far; they are joints too, after those of the model.
  [[nodiscard]] const std::vector<Weld>& welds() const { return flights_.joints.welds(); }
  // The bodies that are one, by a joint of the model or a weld since.
  [[nodiscard]] const WeldedBodies& welded() const { return flights_.joints.welded(); }
  // Projects a jointed island's positions and velocities onto its joints, after positions were set.
  void restore_joints(IslandIndex island);
  // Moves an island's start to its trajectory's end, where a spring may switch. Returns the energy in J that a
  // spring released.
  double advance_to_end(IslandIndex island);
  // After an impact changed velocities: flips springs whose margin has changed its sign. Returns the energy in
  // J that they released.
  double recheck_switches(IslandIndex island) { return switches_.recheck(flights_, flights_.islands[island]); }

  [[nodiscard]] std::int64_t evaluations() const { return flights_.evaluations; }
  [[nodiscard]] std::int64_t rejected_steps() const { return rejected_steps_; }
  // s, absolute: when first the tolerance could not be kept; negative: never.
  [[nodiscard]] double tolerance_missed_since() const { return tolerance_missed_since_; }
  // s, absolute: when first a step moved bodies so far that joints could not be restored; negative: never.
  [[nodiscard]] double joints_missed_since() const { return joints_missed_since_; }
  // s, absolute: when first springs or strings switched more often than is followed; negative: never.
  [[nodiscard]] double switches_missed_since() const { return switches_.missed_since(); }
  // J: loss in taut impulses of strings.
  [[nodiscard]] double lost_to_joints() const { return switches_.lost_to_joints(); }

  // All that changes in a run and, where `ahead` is given, what is known of the time ahead. Restored into
  // trajectories of the same scene, they continue with the same bytes (trajectory_state.cpp).
  void keep(TrajectoryState& to, TrajectoriesAhead* ahead) const;
  void restore(const TrajectoryState& from, const TrajectoriesAhead* ahead);

 private:
  friend struct KeptMembers;

  void limit_to_adaptive_step(Flights::Island& island);
  [[noreturn]] void lose(const Flights::Island& island, LossReason reason) const;
  void check_flight(const Flights::Island& island) const;

  // What undo_step() restores.
  struct StepStart {
    ForceField::Switches springs;
    std::vector<std::uint8_t> taut;
    double lost_to_joints = 0.0;
  };

  Flights flights_;
  SwitchSearch switches_;
  Eigen::VectorXd curvature_bound_, turn_bound_;  // by body
  StepStart step_start_;
  std::int64_t rejected_steps_ = 0;
  double tolerance_missed_since_ = -1.0;
  double joints_missed_since_ = -1.0;
};

}  // namespace carom
