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

// The joints of a scene, laid out for evaluation, and which strings are taut. Bodies that joints join are
// advanced together, as one group of columns. With d from the other end to the body's end, a rod or a taut
// string is one row g = |d| - L with the normal n = d/|d|, a pin two rows g = n·d with n = x and y. J is the
// gradient of g in the coordinates (x, y, angle) of the bodies, M their masses and inertias. A weld has the
// pin's rows, taken at the centre of the body of the lesser inertia, and the angle between the bodies.
//
// - In flight (add_forces) forces Jᵀλ keep g'' = 0: J M⁻¹Jᵀ λ = -(J a + J'v - n·a_end), with the
//   accelerations a of the other forces and that of a kinematic end. So every integrator sees a smooth
//   right-hand side. Hairer and Wanner, Solving Ordinary Differential Equations II, section VII.1, the index
//   reduced to 1.
// - After a step (restore) positions go onto g = 0 by Newton's method, q += M⁻¹Jᵀμ with J M⁻¹Jᵀ μ = -g, and
//   velocities onto J v = n·v_end, both within rounding. A move of the order of the step's own error keeps the
//   order. The same, section VII.2, "projection".
// - At an impact (share) velocities change at once such that J v = n·v_end holds after it; strings only pull.
// - A joint that is new (jerk) makes its bodies move as it holds them by an impact that is wholly plastic: of
// all
//   velocities that it allows, those nearest to the ones before, by v·M v. So whatever the bodies exchange
//   through it has no part in their momentum and angular momentum, and what is lost is ½ uᵀ(J M⁻¹Jᵀ)⁻¹u, with
//   u = J v - n·v_end before.
//
// J M⁻¹Jᵀ is factored as L D Lᵀ within its skyline: a chain costs time in proportion to its length. A row that
// depends on those before it (a frame with more rods than it needs) gets no force of its own.
class JointConstraints {
 public:
  JointConstraints() = default;
  // As the bodies are at the start of a run.
  explicit JointConstraints(std::shared_ptr<const Model> model);

  [[nodiscard]] bool empty() const { return terms_->all.empty(); }

  // The bodies that are advanced together, each list in rising order; from here on a group is an index of it.
  void set_groups(const std::vector<std::vector<int>>& groups);
  [[nodiscard]] bool has_joints(int group) const { return !groups_[group].rows.empty(); }

  // Adds to the rates k of a group, which hold those of all other forces, what the joints do; t in s, absolute.
  void add_forces(int group, double t, const Motions& y, Motions& k);
  // Puts a group's motions onto its joints. False if positions are further off than rounding even so: bodies so
  // far from where the joints can hold them that no step nearby helps.
  bool restore(int group, double t, Motions& y);
  // Changes velocities at once by `change` (columns v, as many as members) and by what the joints add to it.
  // False if a string would have to push: it is slack then, and nothing else has happened.
  [[nodiscard]] bool share(int group, double t, const Eigen::Matrix3Xd& change, Motions& y);
  // The plastic impact that keeps taut strings from growing and makes new joints hold; the energy in J that it
  // takes. Strings that would have to push let go.
  double apply_taut_impulse(int group, double t, Motions& y);
  // The part of `change` that the joints let through.
  void project(int group, double t, const Motions& y, Eigen::Matrix3Xd& change);

  // What add_forces() costs each time, and all calls of restore() have cost, in units of
  // Trajectories::flight_work().
  [[nodiscard]] std::int64_t evaluation_work(int group) const;
  [[nodiscard]] std::int64_t restoring_work() const { return restoring_work_; }

  // The strings of a group, as indices of joints.
  [[nodiscard]] const std::vector<int>& strings(int group) const { return groups_[group].strings; }
  [[nodiscard]] double length(int joint) const { return terms_->all[joint].length; }  // m, of a rod or a string
  [[nodiscard]] bool taut(int joint) const { return taut_[joint] != 0; }
  void set_taut(int joint, bool on) { taut_[joint] = on ? 1 : 0; }
  // Of all joints, those that are no strings are taut; of joints that are new since then nothing is changed.
  [[nodiscard]] const std::vector<std::uint8_t>& strings_taut() const { return taut_; }
  void set_strings_taut(const std::vector<std::uint8_t>& taut) {
    std::copy(taut.begin(), taut.end(), taut_.begin());
  }
  // Of the same joints, the last of which may be missing there.
  void take_over(const JointConstraints& other) {
    std::copy(other.taut_.begin(), other.taut_.end(), taut_.begin());
  }
  // N s: what a joint gave to `body`, at one of its ends, in the last share() or apply_taut_impulse() of the
  // group.
  [[nodiscard]] Vec2 impulse(int group, int joint, int body) const;
  // N: what a taut string pulled with when add_forces() was called last.
  [[nodiscard]] double tension(int group, int joint) const;
  // m: how far a string is longer than its length; a rounding below zero for one at its length.
  [[nodiscard]] double overstretch(int group, int joint, double t, const Motions& y) const;

 private:
  friend struct KeptMembers;  // what a run keeps from step to step

  struct Ends {
    Vec2 arm_a, arm_b;   // m, turned
    Vec2 d;              // m
    Vec2 u;              // m/s
    Vec2 velocity_term;  // m/s²: of d'' what does not depend on accelerations of movable bodies
    Vec2 end_velocity;   // m/s, of a kinematic end
    double size;         // m: the numbers whose rounding the gap has
  };
  struct Row {
    int joint;
    int axis;              // of a pin or a weld: x, y, angle; 0 for others
    int a, b;              // columns; b = -1: no movable body
    int first;             // skyline: the first column of this row
    std::size_t offset;    // of column 0 of this row in the matrix, were it stored from there on
    std::size_t diagonal;  // in the matrix
  };
  struct Group {
    std::vector<Row> rows;
    std::vector<std::pair<int, int>> shared;  // rows i > j that have a body in common
    std::vector<int> strings;
    Eigen::Matrix3Xd inverse_mass;  // a column a member: 1/m, 1/m, 1/I
    // A column or element a row; all zero where a string is slack.
    Eigen::Matrix3Xd ja, jb;
    Eigen::Matrix2Xd normal;
    Eigen::VectorXd gap, velocity_term, end_rate, size, force;
    Eigen::Matrix3Xd rest;   // no change
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
  static void add_quadratures(const Group& g, Motions& y);

  std::shared_ptr<const Model> model_;
  const JointTerms* terms_ = nullptr;  // the model's
  std::vector<int> first_row_;         // by joint, in its group
  std::vector<std::uint8_t> taut_;
  std::vector<Group> groups_;
  std::int64_t restoring_work_ = 0;
};

}  // namespace carom
