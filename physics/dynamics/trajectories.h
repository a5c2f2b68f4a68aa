#pragma once

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
  [[nodiscard]] int islands() const { return static_cast<int>(flights_.islands.size()); }
  [[nodiscard]] int island_of(int body) const { return flights_.island_of[body]; }  // -1: fixed
  // In rising order.
  [[nodiscard]] std::span<const int> members(int island) const {
    return flights_.members_of(flights_.islands[island]);
  }

  // Takes over the epoch, switched springs and counts of other trajectories, and all motions as they are there
  // at a time at which each is known, settled. The last bodies and the last joint may be missing there.
  void adopt(Trajectories& other, double time);
  // All islands start anew at this absolute time, from the motions that they have.
  void begin(double epoch);
  [[nodiscard]] double epoch() const { return flights_.epoch; }
  // Moves the epoch on; no motion changes.
  void shift_epoch(double by);
  [[nodiscard]] double start(int body) const {
    const int k = flights_.island_of[body];
    return k < 0 ? -Flights::kForever : flights_.islands[k].start;
  }
  [[nodiscard]] double end(int body) const {
    const int k = flights_.island_of[body];
    return k < 0 ? Flights::kForever : flights_.islands[k].end;
  }

  // The motion at the start and at the end of the body's trajectory.
  [[nodiscard]] auto at_start(int body) const { return flights_.at_start.col(body); }
  [[nodiscard]] auto at_end(int body) const { return flights_.at_end.col(body); }
  // start <= time <= end, or later until the trajectory is rebuilt.
  [[nodiscard]] Motion at(int body, double time) { return flights_.at(body, time); }
  // On a parabola only (see is_parabolic): q in m and rad at a time, and v.
  [[nodiscard]] Eigen::Vector3d parabola(int body, double time) const { return flights_.parabola(body, time); }
  [[nodiscard]] Eigen::Vector3d parabola_velocity(int body, double time) const {
    return flights_.parabola_velocity(body, time);
  }
  // True if every free flight is a parabola, by the forces and under this integrator.
  [[nodiscard]] bool is_parabolic() const { return flights_.parabolic; }
  [[nodiscard]] Eigen::Vector3d constant_acceleration(int body) const { return flights_.constant.col(body); }
  // m/s², m/s², rad/s²: of a movable body at the start of its trajectory.
  [[nodiscard]] Eigen::Vector3d acceleration(int body) { return flights_.acceleration(body); }
  // Bounds how much the paths of an island's bodies bend along its trajectory, for whoever searches on it:
  // curvature_bound(body) in m/s² is of the centre's path, turn_bound(body) in rad/s² is ω² + |α|.
  void bound_curvature(int island);
  [[nodiscard]] double curvature_bound(int body) const { return curvature_bound_[body]; }
  [[nodiscard]] double turn_bound(int body) const { return turn_bound_[body]; }

  // Settles an island at a time of its trajectory; the trajectory is to be laid anew.
  void advance_to(int island, double time);
  // Puts a body's motion in place of the settled one: position and velocity as an impact or a push left them.
  void set_velocity(int body, const Vec2& velocity, double spin);
  void set_pose(int body, const Eigen::Vector3d& q);
  // What contacts that last do to a body (m/s², m/s², rad/s²), on trajectories that are laid from now on.
  void set_contact_acceleration(int body, const Eigen::Vector3d& by);
  // What flights of the adaptive integrator may cost between two calls of begin_step(), in evaluations, of
  // which attraction makes each cost more: about a second of work for few bodies.
  static constexpr std::int64_t kMostFlightWork = 5'000'000;
  static constexpr std::int64_t kMostFlightWorkPerBody = 200'000;
  // Counts the flights from here on, and remembers which springs and strings act, for undo_step().
  void begin_step();
  // After a step that was given up: springs, strings and what strings took are again as at its beginning.
  // Motions are not.
  void undo_step();
  [[nodiscard]] std::int64_t flight_work() const { return flights_.flight_work; }  // since begin_step()
  // Lays an island's trajectory from its start to `horizon` at the most. Where the step doesn't, `reach` in m
  // bounds the path, and `turn` in rad how far bodies with corners turn. Throws LostMotion if the motion at its
  // end could not be reckoned with, or where flights of the adaptive integrator have cost more than they may.
  static constexpr double kUsualTurn = 6.0;  // rad
  void rebuild(int island, double horizon, double reach, double turn_bound = kUsualTurn);
  // True if joints hold the body.
  [[nodiscard]] bool is_jointed(int body) const {
    const int k = flights_.island_of[body];
    const int group = k < 0 ? -1 : flights_.islands[k].group;
    return group >= 0 && flights_.joints.has_joints(group);
  }
  [[nodiscard]] bool is_taut(int joint) const { return flights_.joints.taut(joint); }  // of a string
  [[nodiscard]] double length(int joint) const {
    return flights_.joints.length(joint);
  }  // m, of a rod or a string
  // An impact of two settled bodies, at least one of them jointed. `a_by` and `b_by` are how (v, spin) of the
  // two would change were they free; zero for immovable ones. answer() makes of them how they change as joints
  // share the impulse at once, push() changes the motions of all that share it. False if a string would have to
  // push: it is slack from then on, and the answer is another one.
  void project_changes(int a, int b, Eigen::Vector3d& a_by, Eigen::Vector3d& b_by);
  [[nodiscard]] bool apply_changes(int a, int b, const Eigen::Vector3d& a_by, const Eigen::Vector3d& b_by);
  // The plastic impact that makes a joint hold which has been put in, between settled bodies: the energy in J
  // that it takes, and the impulse in N s on `body`, at one end of it.
  struct Engagement {
    double taken;
    Vec2 impulse;
  };
  [[nodiscard]] Engagement engage(int joint, int body);
  // Settles a jointed island's positions and velocities onto its joints again, after positions were set.
  void restore_joints(int island);
  // Settles an island at its trajectory's end, where a spring may switch; the energy in J that a spring let go
  // with it.
  double advance_to_end(int island);
  // After an impact changed velocities: springs whose margin has jumped to the other side switch now; the
  // energy in J that they let go.
  double recheck_switches(int island) { return switches_.recheck(flights_, flights_.islands[island]); }

  [[nodiscard]] std::int64_t evaluations() const { return flights_.evaluations; }
  [[nodiscard]] std::int64_t rejected_steps() const { return rejected_steps_; }
  // s, absolute: when first the tolerance could not be kept; negative: never.
  [[nodiscard]] double tolerance_missed_since() const { return tolerance_missed_since_; }
  // s, absolute: when first a step led so far off that joints could not be restored; negative: never.
  [[nodiscard]] double joints_missed_since() const { return joints_missed_since_; }
  // s, absolute: when first springs or strings switched more often than is followed; negative: never.
  [[nodiscard]] double switches_missed_since() const { return switches_.missed_since(); }
  // J: what strings took that jerked taut.
  [[nodiscard]] double lost_to_joints() const { return switches_.lost_to_joints(); }

  // All that changes in a run, and what is known of the time ahead (where `ahead` is given); put back into
  // trajectories of the same scene, they go on for the same bytes (trajectory_state.cpp).
  void keep(TrajectoryState& to, TrajectoriesAhead* ahead) const;
  void restore(const TrajectoryState& from, const TrajectoriesAhead* ahead);
  // The first fault that makes a state none of these trajectories, as "place: what" (of its sizes all but these
  // are right); nothing if there is none.
  [[nodiscard]] std::optional<std::string> fault_of(const TrajectoryState& state,
                                                    const TrajectoriesAhead* ahead) const;

 private:
  friend struct KeptMembers;

  void limit_to_adaptive_step(Flights::Island& island);
  [[noreturn]] void lose(const Flights::Island& island, LossReason reason) const;
  void check_flight(const Flights::Island& island) const;

  // What a step that is given up puts back.
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
