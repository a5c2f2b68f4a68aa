#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "physics/dynamics/flights.h"

namespace carom {

// The moments at which one-sided springs and strings start and stop to act.
//
// The margin of a switch is > 0 where it acts and < 0 where it doesn't: in N the tension of a taut string, in m
// the stretch of a slack one.
class SwitchSearch {
 public:
  // What flights may cost between two calls of Trajectories::begin_step(), in evaluations, before switches are
  // not followed any more in that step; from then on a fiftieth of it.
  static constexpr std::int64_t kMostWork = 5'000'000;
  static constexpr std::int64_t kMostWorkPerBody = 20'000;

  SwitchSearch() = default;
  explicit SwitchSearch(const Model& model);

  // s: how long a trajectory of the island may be for its switches to be followed, where no step limits it.
  [[nodiscard]] double time_to_follow(const Flights& flights, const Flights::Island& island) const;
  // Ends the trajectory of an island at the first moment at which one of its switches flips, unless following
  // them has cost more than it may.
  void end_at_first(Flights& flights, Flights::Island& island);
  // Flips a switch; the energy in J that is gone with a spring. A string that becomes taut takes its impulse.
  double flip(Flights& flights, const Flights::Island& island, const Switch& a_switch, double time);
  // After an impact changed velocities: springs whose margin has jumped to the other side flip now; the energy
  // in J that they release.
  double recheck(Flights& flights, const Flights::Island& island);

  [[nodiscard]] double lost_to_joints() const { return lost_to_joints_; }  // J: by taut impulses
  void set_lost_to_joints(double lost) { lost_to_joints_ = lost; }
  // s, absolute: when first switches flipped more often than is followed; negative: never.
  [[nodiscard]] double missed_since() const { return missed_since_; }
  void add_joint() { released_at_.push_back(-1.0); }

 private:
  friend struct KeptMembers;

  // What a switch is between.
  struct Ends {
    BodyIndex body;
    BodyIndex other;          // a movable body, or -1
    BodyIndex drive;          // a kinematic body at the other end, or -1
    bool turns, other_turns;  // the end is beside the centre of its body
    double length;            // m, at which it switches
  };
  [[nodiscard]] static Ends ends_of(const Model& model, const Switch& a_switch);

  // The margin in the state of the switch at one time.
  struct Sample {
    double time = 0.0;  // s
    double margin = 0.0;
  };
  // A switch that leaves its state between two times at which the trajectory was sampled.
  struct Leaving {
    Switch a_switch;
    double before = 0.0, after = 0.0;  // s
    double margin_before = 0.0, margin_after = 0.0;
  };

  [[nodiscard]] bool may_follow(const Flights& flights, const Flights::Island& island);
  void list(const Flights& flights, const Flights::Island& island);
  // In how many parts of equal length a trajectory is looked at.
  [[nodiscard]] int parts_of(Flights& flights, const Flights::Island& island) const;
  void sample(Flights& flights, const Flights::Island& island, double time, std::vector<double>& margins);
  // The first time at which the switch is seen out of its state between three samples in it, with the last one
  // before that in it.
  [[nodiscard]] static std::optional<Leaving> dip(Flights& flights, const Flights::Island& island,
                                                  const Switch& a_switch, std::array<Sample, 3> at);
  void find_leaving(Flights& flights, Flights::Island& island, double& first);
  void find_roots(Flights& flights, Flights::Island& island, double& first);

  std::vector<Switch> listed_;                // the island's switches
  std::vector<std::vector<double>> margins_;  // theirs at the ends of the trajectory's parts
  std::vector<double> margins_at_first_;
  std::vector<Leaving> leaving_;
  double missed_since_ = -1.0;
  double lost_to_joints_ = 0.0;
  // What the switches of each body allow a trajectory.
  struct Reach {
    bool turns = false;                                       // one is beside its centre
    double swing = 0.0;                                       // rad/s, of the drives at their other ends
    double passing = 0.0;                                     // m/s, of these drives
    double length = std::numeric_limits<double>::infinity();  // m, the shortest at which one switches
  };
  std::vector<Reach> reaches_;
  // s, absolute, by joint: when a string last became taut and would have had to push.
  std::vector<double> released_at_;
};

}  // namespace carom
