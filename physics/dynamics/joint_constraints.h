#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "physics/dynamics/state.h"
#include "physics/model/model.h"
#include "physics/scene/scene.h"

namespace carom {

// The joints of a scene, arranged for evaluation, and which strings are taut. Bodies connected by joints are
// advanced together, as one group of columns. With d from the other end to the body's end, a rod or a taut
// string has one row g = |d| - L with the normal n = d/|d|; a pin has two rows g = n·d with n = x and y. A
// weld has a pin's rows, taken at the centre of the body with the smaller inertia, and the angle between the
// bodies. J is the gradient of g in the bodies' coordinates (x, y, angle), M their masses and inertias.
//
// - In flight (add_forces), forces Jᵀλ keep g'' = 0: J M⁻¹Jᵀ λ = -(J a + J'v - n·a_end), with the
//   accelerations a of the other forces and a_end of a kinematic end. So every integrator sees a smooth
//   right-hand side. Hairer and Wanner, Solving Ordinary Differential Equations II, section VII.1, index
//   reduced to 1.
// - After a step (restore), Newton's method projects positions onto g = 0, q += M⁻¹Jᵀμ with J M⁻¹Jᵀ μ = -g,
//   and velocities onto J v = n·v_end, both within rounding. A change of the order of the step's own error
//   preserves the order. The same, section VII.2, "projection".
// - At an impact (share), velocities change at once such that J v = n·v_end holds after it; strings only
//   pull.
// - New joints and tightening strings (apply_taut_impulse) act by a perfectly plastic impact: of all
//   velocities that the joints allow, it takes those nearest to the ones before, in the norm v·M v. What the
//   bodies exchange through joints does not change their total momentum and angular momentum. The energy lost
//   is ½ uᵀ(J M⁻¹Jᵀ)⁻¹u, with u = J v - n·v_end before.
//
// J M⁻¹Jᵀ is factored as L D Lᵀ within its skyline: the cost of a chain is proportional to its length. A row
// that depends on those before it (a frame with more rods than it needs) gets no force of its own. Call
// set_groups() before anything that takes a group.
class JointConstraints {
 public:
  JointConstraints() = default;
  // Strings are taut or slack as the bodies are at the start of a run.
  explicit JointConstraints(std::shared_ptr<const Model> model);

  [[nodiscard]] bool empty() const { return terms_.all.empty(); }

  // One more joint, the last: call set_groups() again.
  void add_weld(const Weld& weld);
  [[nodiscard]] const std::vector<Weld>& welds() const { return welds_; }  // those added
  [[nodiscard]] const WeldedBodies& welded() const { return welded_; }     // by the scene or since
  [[nodiscard]] JointIndex last() const { return JointIndex{static_cast<int>(terms_.all.size()) - 1}; }
  [[nodiscard]] std::vector<BodyPair> joined() const { return terms_.joined(); }

  // Sets the groups of bodies that are advanced together, each in rising order. `group` below is an index
  // into them.
  void set_groups(const std::vector<std::vector<BodyIndex>>& groups);
  [[nodiscard]] bool has_joints(GroupIndex group) const { return !groups_[group].rows.empty(); }

  // Adds the joint forces to the rates k of a group, which already have all other forces; t in s, absolute.
  void add_forces(GroupIndex group, double t, const Motions& y, Motions& k);
  // Projects a group's motions onto its joints. False if positions keep an error beyond rounding: the bodies
  // are too far from any place that satisfies the joints.
  bool restore(GroupIndex group, double t, Motions& y);
  // Changes velocities at once by `change` (one column v per member) and by the joints' impulses. False if a
  // string would have to push: that string is slack now, and nothing else has changed.
  [[nodiscard]] bool share(GroupIndex group, double t, const Eigen::Matrix3Xd& change, Motions& y);
  // The plastic impact that stops taut strings from lengthening and makes new joints hold. Returns the energy
  // lost, in J. Strings that would have to push become slack.
  double apply_taut_impulse(GroupIndex group, double t, Motions& y);
  // Projects `change` onto the velocity changes that the joints allow.
  void project(GroupIndex group, double t, const Motions& y, Eigen::Matrix3Xd& change);

  // The cost of one add_forces(), and of all calls of restore() so far, in units of
  // Trajectories::flight_work().
  [[nodiscard]] std::int64_t evaluation_work(GroupIndex group) const;
  [[nodiscard]] std::int64_t restoring_work() const { return restoring_work_; }

  // The strings of a group.
  [[nodiscard]] const std::vector<JointIndex>& strings(GroupIndex group) const {
    return groups_[group].strings;
  }
  [[nodiscard]] double length(JointIndex joint) const {
    return terms_.all[joint].length;
  }  // m, of a rod or a string
  [[nodiscard]] bool taut(JointIndex joint) const { return taut_[static_cast<std::size_t>(joint)] != 0; }
  void set_taut(JointIndex joint, bool on) { taut_[static_cast<std::size_t>(joint)] = on ? 1 : 0; }
  // By joint; true for all that are not strings. Setting it leaves joints that are newer than `taut`
  // unchanged.
  [[nodiscard]] const std::vector<std::uint8_t>& strings_taut() const { return taut_; }
  void set_strings_taut(const std::vector<std::uint8_t>& taut) {
    std::copy(taut.begin(), taut.end(), taut_.begin());
  }
  // N s, the impulse of a joint on `body`, at one of its ends, in the group's last share() or
  // apply_taut_impulse().
  [[nodiscard]] Vec2 impulse(GroupIndex group, JointIndex joint, BodyIndex body) const;
  // N, the tension of a taut string in the last add_forces().
  [[nodiscard]] double tension(GroupIndex group, JointIndex joint) const;
  // m, how much longer a string is than its length; for one at its length it may be below zero by rounding.
  [[nodiscard]] double overstretch(GroupIndex group, JointIndex joint, double t, const Motions& y) const;

 private:
  friend struct KeptMembers;  // what a run keeps from step to step

  struct Ends {
    Vec2 arm_a, arm_b;   // m, turned
    Vec2 d;              // m
    Vec2 u;              // m/s
    Vec2 velocity_term;  // m/s², the part of d'' without accelerations of movable bodies
    Vec2 end_velocity;   // m/s, of a kinematic end
    double size;         // m, of the terms of the gap, for its rounding
  };
  struct Row {
    JointIndex joint;
    int axis;              // of a pin or a weld: x, y, angle; 0 for others
    int a, b;              // columns; b = -1: no movable body
    int first;             // skyline: the first column of this row
    std::size_t offset;    // of this row's column 0 in the matrix, as if it were stored
    std::size_t diagonal;  // in the matrix
  };
  struct Group {
    std::vector<Row> rows;
    std::vector<std::pair<int, int>> shared;  // rows i > j that have a body in common
    std::vector<JointIndex> strings;
    Eigen::Matrix3Xd inverse_mass;  // one column per member: 1/m, 1/m, 1/I
    // One column or element per row; all zero where a string is slack.
    Eigen::Matrix3Xd ja, jb;
    Eigen::Matrix2Xd normal;
    Eigen::VectorXd gap, velocity_term, end_rate, size, force;
    Eigen::Matrix3Xd rest;   // zero change
    Eigen::VectorXd matrix;  // J M⁻¹Jᵀ within its skyline, then L
    Eigen::VectorXd inverse_pivot;
  };

  [[nodiscard]] Ends ends_of(const JointTerm& joint, double t, const Motions& y, int a, int b) const;
  void fill_row(Group& g, int row, double t, const Motions& y) const;
  void fill_rows(Group& g, double t, const Motions& y) const;
  void relax(Group& g, double t, Motions& y) const;
  static double entry(const Group& g, int i, int j);
  static void factor(Group& g);
  static void solve(Group& g);  // g.force in place
  template <class Columns>
  static double along(const Group& g, int row, const Columns& v);  // (J v) of a row
  template <class Columns>
  static void apply(const Group& g, Columns&& v);  // v += M⁻¹Jᵀ force
  static void add_quadratures(const Group& g, const Motions& y, Motions& to);

  std::shared_ptr<const Model> model_;
  JointTerms terms_;  // the model's, then those of `welds_`
  std::vector<Weld> welds_;
  WeldedBodies welded_;
  ArrayOf<JointIndex, int> first_row_;  // in its group
  std::vector<std::uint8_t> taut_;      // by joint
  ArrayOf<GroupIndex, Group> groups_;
  std::int64_t restoring_work_ = 0;
};

}  // namespace carom
