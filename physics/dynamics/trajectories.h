#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "physics/dynamics/force_field.h"
#include "physics/dynamics/integrators/integrators.h"
#include "physics/dynamics/joint_constraints.h"
#include "physics/dynamics/lost_motion.h"
#include "physics/dynamics/state.h"
#include "physics/dynamics/trajectory_state.h"
#include "physics/model/model.h"
#include "physics/scene/method.h"
#include "physics/scene/scene.h"

namespace carom {

// The motion of every body as a function of time, each known over an interval of its own.
//
// Bodies that forces or joints couple form an island and are advanced together; any other moving body is an
// island of its own. An island has a start, at which its motion was last settled, and a trajectory: the
// integrator's map from there on, valid up to its end. Between start and end the motion at any time is one step
// of the integrator, of the length that it takes to get there, so what is found on a trajectory (an impact's
// time, say) is found on the integrator's own map. Where joints hold bodies, the map is that of the integrator
// followed by a move onto the joints (physics/dynamics/joints.h).
//
// A trajectory ends at the horizon that is asked for, or before: where an applied force changes its law, where
// a one-sided spring starts or stops to act, or a string to be taut (located to the last bit), after one
// accepted step of the adaptive integrator, or, without a step to limit it, where the body has moved by
// `reach`.
//
// Times are in s after the epoch. Fixed bodies belong to no island; kinematic bodies are islands that no one
// settles.
class Trajectories {
 public:
  Trajectories() = default;
  // At the start of a run, from the positions and velocities of the bodies.
  Trajectories(std::shared_ptr<const Model> model, const Method& method);

  void set_method(const Method& method);
  [[nodiscard]] const ForceField& field() const { return field_; }
  [[nodiscard]] int islands() const { return static_cast<int>(islands_.size()); }
  [[nodiscard]] int island_of(int body) const { return island_of_[body]; }  // -1: fixed
  // In rising order.
  [[nodiscard]] std::span<const int> members(int island) const { return members_of(islands_[island]); }

  // Takes over the epoch, switched springs and counts of other trajectories, and all motions as they are there
  // at a time at which each is known, settled. The last bodies and the last joint may be missing there.
  void take_over(Trajectories& other, double time);
  // All islands start anew at this absolute time, from the motions that they have.
  void begin(double epoch);
  [[nodiscard]] double epoch() const { return epoch_; }
  // Moves the epoch on; no motion changes.
  void shift_epoch(double by);
  [[nodiscard]] double start(int body) const {
    return island_of_[body] < 0 ? -kForever : islands_[island_of_[body]].start;
  }
  [[nodiscard]] double end(int body) const {
    return island_of_[body] < 0 ? kForever : islands_[island_of_[body]].end;
  }

  // The motion where the body's island was settled last, and where its trajectory ends.
  [[nodiscard]] auto at_start(int body) const { return at_start_.col(body); }
  [[nodiscard]] auto at_end(int body) const { return at_end_.col(body); }
  [[nodiscard]] Motion at(int body,
                          double time);  // start <= time <= end, or before another call of trajectory()
  // On a parabola only (see is_parabolic): q at a time, m and rad.
  [[nodiscard]] Eigen::Vector3d parabola(int body, double time) const {
    const double h = island_of_[body] < 0 ? 0.0 : time - islands_[island_of_[body]].start;
    return at_start_.col(body).head<3>() +
           h * (at_start_.col(body).segment<3>(3) + 0.5 * h * constant_.col(body));
  }
  [[nodiscard]] Eigen::Vector3d parabola_velocity(int body, double time) const {
    const double h = island_of_[body] < 0 ? 0.0 : time - islands_[island_of_[body]].start;
    return at_start_.col(body).segment<3>(3) + h * constant_.col(body);
  }
  // True if every free flight is a parabola, by the forces and under this integrator.
  [[nodiscard]] bool is_parabolic() const { return parabolic_; }
  [[nodiscard]] Eigen::Vector3d constant_acceleration(int body) const { return constant_.col(body); }
  // m/s², m/s², rad/s²: of a body as it was settled; of a movable one.
  [[nodiscard]] Eigen::Vector3d acceleration(int body);
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
  // What they may cost, of any integrator, before springs and strings are not followed any more in that step;
  // from then on a fiftieth of it.
  static constexpr std::int64_t kMostSwitchWork = 5'000'000;
  static constexpr std::int64_t kMostSwitchWorkPerBody = 20'000;
  // Counts the flights from here on, and remembers which springs and strings act, for undo_step().
  void begin_step();
  // After a step that was given up: springs, strings and what strings took are again as at its beginning.
  // Motions are not.
  void undo_step();
  [[nodiscard]] std::int64_t flight_work() const { return flight_work_; }  // since begin_step()
  // Lays an island's trajectory from its start to `horizon` at the most. Where the step doesn't, `reach` in m
  // bounds the path, and `turn` in rad how far bodies with corners turn. Throws LostMotion if the motion at its
  // end could not be reckoned with, or where flights of the adaptive integrator have cost more than they may.
  static constexpr double kUsualTurn = 6.0;  // rad
  void rebuild(int island, double horizon, double reach, double turn_bound = kUsualTurn);
  // True if joints hold the body.
  [[nodiscard]] bool is_jointed(int body) const {
    const int k = island_of_[body];
    return k >= 0 && islands_[k].group >= 0 && joints_.has_joints(islands_[k].group);
  }
  [[nodiscard]] bool is_taut(int joint) const { return joints_.taut(joint); }     // of a string
  [[nodiscard]] double length(int joint) const { return joints_.length(joint); }  // m, of a rod or a string
  // An impact of two settled bodies, at least one of them jointed. `a_by` and `b_by` are how (v, spin) of the
  // two would change were they free; zero for immovable ones. answer() makes of them how they change as joints
  // share the impulse at once, push() changes the motions of all that share it. False if a string would have to
  // push: it is slack from then on, and the answer is another one.
  void answer(int a, int b, Eigen::Vector3d& a_by, Eigen::Vector3d& b_by);
  [[nodiscard]] bool push(int a, int b, const Eigen::Vector3d& a_by, const Eigen::Vector3d& b_by);
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
  double recheck_switches(int island);

  [[nodiscard]] std::int64_t evaluations() const { return evaluations_; }
  [[nodiscard]] std::int64_t rejected_steps() const { return rejected_steps_; }
  // s, absolute: when first the tolerance could not be kept; negative: never.
  [[nodiscard]] double tolerance_missed_since() const { return tolerance_missed_since_; }
  // s, absolute: when first a step led so far off that joints could not be restored; negative: never.
  [[nodiscard]] double joints_missed_since() const { return joints_missed_since_; }
  // s, absolute: when first springs or strings switched more often than is followed; negative: never.
  [[nodiscard]] double switches_missed_since() const { return switches_missed_since_; }
  // J: what strings took that jerked taut.
  [[nodiscard]] double lost_to_joints() const { return lost_to_joints_; }

  // All that changes in a run, and what is known of the time ahead (where `ahead` is given); put back into
  // trajectories of the same scene, they go on for the same bytes (track_state.cpp).
  void keep(TrajectoryState& to, TrajectoriesAhead* ahead) const;
  void put_back(const TrajectoryState& from, const TrajectoriesAhead* ahead);
  // The first fault that makes a state none of these trajectories, as "place: what" (of its sizes all but these
  // are right); nothing if there is none.
  [[nodiscard]] std::optional<std::string> fault_of(const TrajectoryState& state,
                                                    const TrajectoriesAhead* ahead) const;

 private:
  template <class Self, class Kept, class Ahead, class Each>
  static void each_kept(Self& trajectories, Kept& kept, Ahead* ahead, const Each& each);

  static constexpr double kForever = 1e300;  // s

  struct Island {
    double start = 0.0;
    double end = 0.0;
    double next_step = 0.0;  // s, of the adaptive integrator; 0: not known yet
    int first = 0;           // its members stand from here on in members_
    int count = 1;
    int group = -1;      // room in groups_, of more than one member
    int switching = -1;  // the switch (spring or string) that flips at the end
    bool kinematic = false;
  };
  struct Group {
    double cached = -kForever;  // the time that `now` is at
    Motions from, now;
    Eigen::Matrix3Xd change;  // of velocities at once
    bool missed = false;      // `now` is off the joints
    bool rates_known = false;
    Motions start_rates;  // at the island's start, if they are known
    Stages<Motions> stages;
  };
  // A switch that leaves its state between two times at which the trajectory was looked at.
  struct Leaving {
    int a_switch = 0;
    double before = 0.0, after = 0.0;  // s
    double margin_before = 0.0, margin_after = 0.0;
  };

  [[nodiscard]] std::span<const int> members_of(const Island& island) const {
    return {members_.data() + island.first, static_cast<std::size_t>(island.count)};
  }
  void forget(const Island& island) {
    if (island.group < 0) return;
    groups_[island.group].cached = -kForever;
    groups_[island.group].rates_known = false;
  }
  [[nodiscard]] const std::vector<Body>& bodies() const { return model_->bodies(); }
  [[nodiscard]] Eigen::Index column_of(const Island& island, int body) const;
  [[nodiscard]] int body_of(const Island& island) const { return members_[island.first]; }
  const Motions& rates_of(const Island& island, double time, const Motions& y);  // of a group
  const Motions& group_at(const Island& island, double time);
  void gather(const Island& island);  // the settled motions of a group, side by side
  void spread(const Island& island);  // and back
  // The settled motion advanced to `time`: of an island of one body into `out`, of a group.
  void fly_one(const Island& island, double time, Motion& out);
  const Motions& fly_group(const Island& island, double time);
  [[nodiscard]] double time_to_end(const Island& island, double reach, double turn_bound) const;
  [[nodiscard]] bool outruns_joints(const Island& island);
  double error_of(const Island& island, double time);
  [[nodiscard]] double first_step(const Island& island);
  [[nodiscard]] bool is_lost(const Island& island) const;
  void limit_to_adaptive_step(Island& island);
  void find_switch(Island& island);
  [[nodiscard]] bool follows_switches(const Island& island);
  void list_switches(const Island& island);
  void look_at_switches(const Island& island, double time, std::vector<double>& margins);
  [[noreturn]] void lose(const Island& island, LossReason reason) const;
  void check_flight(const Island& island) const;
  // Switches are the springs, by their indices, and then the joints, of which strings switch.
  [[nodiscard]] bool is_joint(int a_switch) const { return a_switch >= field_.springs(); }
  [[nodiscard]] bool has_switches(const Island& island) const {
    if (!model_->needs.has(Part::kSwitching)) return false;
    return field_.has_switching_springs() || (island.group >= 0 && !joints_.strings(island.group).empty());
  }
  double flip(const Island& island, int a_switch, double time);
  double apply_taut_impulse(const Island& island);  // J: what it takes
  [[nodiscard]] double margin_at(const Island& island, int a_switch, double time);
  [[nodiscard]] bool is_on(int a_switch) const {
    return is_joint(a_switch) ? joints_.taut(a_switch - field_.springs()) : field_.engaged(a_switch);
  }
  void set_on(int a_switch, bool on);
  int set_change(int body, const Eigen::Vector3d& by);

  std::shared_ptr<const Model> model_;
  ForceField field_;
  JointConstraints joints_;
  std::vector<Island> islands_;
  std::vector<int> members_;
  std::vector<Group> groups_;
  std::vector<int> island_of_;
  Motions at_start_;
  Motions at_end_;
  Eigen::Matrix3Xd constant_;
  Eigen::VectorXd curvature_bound_;
  Eigen::VectorXd turn_bound_;
  IntegratorId integrator_ = IntegratorId::kRk4;
  bool adaptive_ = false;
  bool parabolic_ = false;
  bool general_ = false;  // never take the parabola's short cuts
  int evaluations_a_flight_ = 0;
  double tolerance_ = 0.0;
  double epoch_ = 0.0;
  std::int64_t evaluations_ = 0;
  std::int64_t flight_work_ = 0;
  std::vector<int> switches_;                   // of the island whose trajectory is laid
  std::array<std::vector<double>, 5> margins_;  // theirs at the trajectory's start, quarters and end
  std::vector<double> margins_at_first_;
  std::vector<Leaving> leaving_;
  struct StepStart {
    ForceField::Switches springs;
    std::vector<std::uint8_t> taut;
    double lost_to_joints = 0.0;
  };
  StepStart step_start_;
  std::int64_t rejected_steps_ = 0;
  double tolerance_missed_since_ = -1.0;
  double joints_missed_since_ = -1.0;
  double switches_missed_since_ = -1.0;
  double lost_to_joints_ = 0.0;
  std::vector<double>
      released_at_;  // s, absolute, by joint: when a string last became taut and would have to push
};

}  // namespace carom
