#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "physics/dynamics/force_field.h"
#include "physics/dynamics/integrators/integrators.h"
#include "physics/dynamics/joint_constraints.h"
#include "physics/dynamics/state.h"
#include "physics/model/model.h"
#include "physics/scene/method.h"

namespace carom {

// The flight of every body under the integrator: the context that all parts of the trajectories share
// (physics/dynamics/trajectories.h).
//
// Bodies that forces or joints couple form an island and are advanced together; any other moving body is an
// island of its own. Fixed bodies belong to no island; a kinematic body is an island that follows its drive.
// The motion of an island at any time is one step of the integrator from the island's start, followed, where
// joints hold its bodies, by a projection onto the joints.
//
// Times are in s after the epoch.
struct Flights {
  static constexpr double kForever = 1e300;  // s

  struct Island {
    double start = 0.0;
    double end = 0.0;
    double next_step = 0.0;  // s, of the adaptive integrator; 0: not known yet
    int first = 0;           // its members start here in `members`
    int count = 1;
    GroupIndex group = kNoGroup;      // of more than one member
    std::optional<Switch> switching;  // flips at the end
    bool kinematic = false;

    [[nodiscard]] bool coupled() const { return group != kNoGroup; }
  };
  // What an island of several members works with; a column a member.
  struct Group {
    double cached = -kForever;  // the time of `now`
    Motions from, now;
    Eigen::Matrix3Xd change;  // of velocities by an impact
    bool missed = false;      // `now` is off the joints
    bool end_missed = false;  // so is the end of the trajectory, or joints bend it too far to search on it
    bool rates_known = false;
    Motions start_rates;  // at the island's start, where they are known
    Stages<Motions> stages;
  };

  Flights() = default;
  // At the start of a run, from the positions and velocities of the bodies.
  Flights(std::shared_ptr<const Model> model, const Method& method);
  void set_method(const Method& method);
  // One more joint, which couples its bodies: all islands are made anew, and their motions start where
  // `at_start` says.
  void add_weld(const Weld& weld);

  [[nodiscard]] int bodies() const { return static_cast<int>(model->bodies()); }
  [[nodiscard]] std::span<const BodyIndex> members_of(const Island& island) const {
    return {members.data() + island.first, static_cast<std::size_t>(island.count)};
  }
  [[nodiscard]] BodyIndex body_of(const Island& island) const { return members[island.first]; }
  [[nodiscard]] Eigen::Index column_of(const Island& island, BodyIndex body) const;
  // Drops what is known of the island's flight, after its start has changed.
  void forget(const Island& island) {
    if (!island.coupled()) return;
    groups[island.group].cached = -kForever;
    groups[island.group].rates_known = false;
  }
  void gather(const Island& island);  // motions at the start, into the group's `from`
  void spread(const Island& island);  // and back

  void make_islands();
  // The motion advanced by h with these rows; the others stay what they are.
  template <int kGiven>
  void fly_rows(const Island& island, double h, Motion& out);
  // The motion advanced to `time`: of an island of one body into `out`, of a group.
  void fly_one(const Island& island, double time, Motion& out);
  const Motions& fly_group(const Island& island, double time);
  const Motions& group_at(const Island& island, double time);  // likewise, without a step at its start
  const Motions& rates_of(const Island& island, double time, const Motions& y);  // of a group
  [[nodiscard]] Motion at(BodyIndex body, double time);
  // q in m and rad alone, and with v: on a parabola a fraction of the work.
  [[nodiscard]] Eigen::Vector3d place(BodyIndex body, double time) {
    if (!is_on_parabola(body, time)) return at(body, time).head<3>();
    count_flight();
    return parabola(body, time);
  }
  [[nodiscard]] Kinematics kinematics(BodyIndex body, double time) {
    if (!is_on_parabola(body, time)) return at(body, time).head<kMotionRows>();
    count_flight();
    Kinematics y;
    y << parabola(body, time), parabola_velocity(body, time);
    return y;
  }
  void count_flight() {
    evaluations += evaluations_a_flight;
    flight_work += evaluations_a_flight;
  }
  // Those of all bodies.
  void read(double time, State& into);
  // Whether the body is between the ends of its trajectory there, on a parabola.
  [[nodiscard]] bool is_on_parabola(BodyIndex body, double time) const {
    if (!parabolic || field.has_quadratures() || island_of[body] == kNoIsland) return false;
    const Island& island = islands[island_of[body]];
    return !island.kinematic && time != island.start && time != island.end;
  }
  // Whether the body's acceleration by contacts changes during the step.
  [[nodiscard]] bool is_bent(BodyIndex body) const {
    return field.contact_changes() && !field.contact_rate(body).isZero(0.0);
  }
  // On a parabola only, which may be bent: q in m and rad at a time, and v.
  [[nodiscard]] Eigen::Vector3d parabola(BodyIndex body, double time) const {
    const double start = island_of[body] == kNoIsland ? time : islands[island_of[body]].start;
    const double h = time - start;
    Eigen::Vector3d q =
        at_start.col(body).head<3>() + h * (at_start.col(body).segment<3>(3) + 0.5 * h * constant.col(body));
    if (field.contact_changes()) q += h * h * (0.5 * (start - bent_from) + h / 6.0) * field.contact_rate(body);
    return q;
  }
  [[nodiscard]] Eigen::Vector3d parabola_velocity(BodyIndex body, double time) const {
    const double start = island_of[body] == kNoIsland ? time : islands[island_of[body]].start;
    const double h = time - start;
    Eigen::Vector3d v = at_start.col(body).segment<3>(3) + h * constant.col(body);
    if (field.contact_changes()) v += h * (start - bent_from + 0.5 * h) * field.contact_rate(body);
    return v;
  }
  // m/s², m/s², rad/s²
  [[nodiscard]] Eigen::Vector3d parabola_acceleration(BodyIndex body, double time) const {
    Eigen::Vector3d a = constant.col(body);
    if (field.contact_changes()) a += (time - bent_from) * field.contact_rate(body);
    return a;
  }
  // kg m²/s: what gravity has given to a body's angular momentum about the origin by this time, on a parabola
  // and under gravity alone.
  [[nodiscard]] double angular_impulse_of_gravity(BodyIndex body, double time) const {
    const double known = at_start.col(body)[6 + kGravityAngularImpulse];
    if (island_of[body] == kNoIsland || model->forces.gravity.isZero(0.0)) return known;
    const double h = time - islands[island_of[body]].start;
    const auto y = at_start.col(body);
    Vec2 mean = y.head<2>() + h * (0.5 * y.segment<2>(3) + (h / 6.0) * constant.col(body).head<2>());
    if (field.contact_changes()) {
      const double start = islands[island_of[body]].start;
      mean += h * h * ((start - bent_from) / 6.0 + h / 24.0) * field.contact_rate(body).head<2>();
    }
    return known + h * field.torque_of_gravity(body, mean);
  }
  // m/s², m/s², rad/s²: of a movable body at the start of its island.
  [[nodiscard]] Eigen::Vector3d acceleration(BodyIndex body);
  // Likewise of an island's bodies that forces move, if they were in this state at `time`, by the springs,
  // strings and contacts that act now; into their columns of `by`.
  void accelerations(const Island& island, const State& state, double time, Eigen::Matrix3Xd& by);
  // The error estimate of the adaptive integrator's step that ends at `time`, relative to its tolerance's unit.
  double error_of(const Island& island, double time);
  // The plastic impact that makes new joints and taut strings hold; the energy in J that it takes. A string
  // that would have to push becomes slack.
  double apply_taut_impulse(const Island& island);

  std::shared_ptr<const Model> model;
  ForceField field;
  JointConstraints joints;
  ArrayOf<IslandIndex, Island> islands;
  std::vector<BodyIndex> members;
  ArrayOf<GroupIndex, Group> groups;
  std::vector<IslandIndex> island_of;  // by body; none: fixed
  Motions at_start, at_end;            // by body
  Eigen::Matrix3Xd constant;           // accelerations by body: m/s², m/s², rad/s²
  double bent_from = 0.0;              // s: when those by contacts are as in `constant`
  IntegratorId integrator = IntegratorId::kRk4;
  bool adaptive = false;
  bool parabolic = false;  // every free flight is a parabola
  bool general = false;    // the untrimmed program: no short cut for parabolas
  int evaluations_a_flight = 0;
  double tolerance = 0.0;
  double epoch = 0.0;  // s, absolute
  std::int64_t evaluations = 0;
  std::int64_t flight_work = 0;  // evaluations since the step began, weighted by their cost
};

}  // namespace carom
