#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <type_traits>
#include <vector>

#include "physics/dynamics/state.h"
#include "physics/math/vectors.h"
#include "physics/model/model.h"
#include "physics/scene/drive.h"
#include "physics/scene/scene.h"

namespace carom {

// The smooth forces of a scene, arranged for evaluation. External forces (gravity, drag, springs to points
// and to bodies of infinite mass, applied forces) act body by body. Springs between movable bodies and
// attraction couple bodies, which must then be advanced together (`coupled_groups`).
//
// One-sided springs and forces that start, rise or end change their law at certain moments. Between two such
// moments the law is kept, so the right-hand side is smooth within a step. The caller ends a step at each
// moment (`next_break`, `switch_margin`) and then calls `set_phase` or `set_engaged`.
class ForceField {
 public:
  ForceField() = default;
  // Begins with the laws in force at the start of a run.
  explicit ForceField(std::shared_ptr<const Model> model);

  // Rate of a movable body at absolute time t (s) under the external forces; y and k are columns of kRows, or
  // of kRowsWithoutGravity, or of kMotionRows if has_quadratures() is false.
  template <class Y, class K>
  void external_rate(BodyIndex body, double t, const Y& y, K&& k) const {
    k.template head<3>() = y.template segment<3>(3);
    k.template segment<3>(3) << terms_->gravity, 0.0;
    if (in_contact_) {
      k.template segment<3>(3) += contact_.col(body);
      if (contact_changes_) k.template segment<3>(3) += (t - contact_from_) * contact_rate_.col(body);
    }
    constexpr int kGiven = std::decay_t<K>::RowsAtCompileTime;
    if constexpr (kGiven > kMotionRows) {
      k.template tail<kGiven - kMotionRows>().setZero();
      if constexpr (kGiven == kRows)
        k[6 + kGravityAngularImpulse] = torque_of_gravity(body, y.template head<2>());
      if (has_quadratures_)
        (this->*add_external_)(body, t, y.template head<3>(), y.template segment<3>(3), k.data());
    }
  }
  // N m: of uniform gravity about the origin, on a movable body at x (m).
  [[nodiscard]] double torque_of_gravity(BodyIndex body, const Vec2& x) const {
    return model_->mass.mass[body] * cross(x, terms_->gravity);
  }
  // m/s², m/s², rad/s²: the acceleration of a body by resting contacts, from now on.
  [[nodiscard]] bool in_contact() const { return in_contact_; }
  [[nodiscard]] auto contact_acceleration(BodyIndex body) const { return contact_.col(body); }
  void set_contact_acceleration(BodyIndex body, const Eigen::Vector3d& by) {
    if (!in_contact_) {
      contact_ = Eigen::Matrix3Xd::Zero(3, static_cast<Eigen::Index>(model_->bodies()));
      contact_rate_ = contact_;
    }
    in_contact_ = true;
    contact_.col(body) = by;
    if (contact_changes_) contact_rate_.col(body).setZero();
  }
  // Per s: how it changes from the absolute time `from` (s) on, one for all bodies.
  [[nodiscard]] bool contact_changes() const { return contact_changes_; }
  [[nodiscard]] auto contact_rate(BodyIndex body) const { return contact_rate_.col(body); }
  void set_contact_rate(BodyIndex body, const Eigen::Vector3d& rate, double from) {
    contact_changes_ = true;
    contact_from_ = from;
    contact_rate_.col(body) = rate;
  }
  void end_contact_rates() {
    if (contact_changes_) contact_rate_.setZero();
    contact_changes_ = false;
  }
  // Adds the coupling forces among `members` to their rates; columns in the order of the members.
  void add_couplings(std::span<const BodyIndex> members, const Motions& y, Motions& k) const;

  // False if all quadratures but that of gravity stay zero.
  [[nodiscard]] bool has_quadratures() const { return has_quadratures_; }
  // True if only gravity and forces that never change act: flight is a parabola.
  [[nodiscard]] bool is_constant() const { return constant_; }
  // From now on joints, which the model does not have, exert forces too.
  void add_joints() {
    has_quadratures_ = true;
    constant_ = false;
  }
  // m/s², m/s², rad/s²; of a movable body where is_constant(), zero for others.
  [[nodiscard]] Eigen::Vector3d constant_acceleration(BodyIndex body) const;

  // Groups of bodies that forces or the given pairs couple; a body paired with itself is a group if nothing
  // else couples it.
  [[nodiscard]] std::vector<std::vector<BodyIndex>> coupled_groups(
      const std::vector<BodyPair>& pairs = {}) const;

  // J: of gravity (zero at the origin), of springs, and of attraction (zero far away).
  [[nodiscard]] double potential_energy(const Eigen::Matrix3Xd& q) const;
  // J: the part of it that changes when `body` is moved to `position` and all others stay.
  [[nodiscard]] double potential_energy_of(BodyIndex body, const Vec2& position,
                                           const Eigen::Matrix3Xd& q) const;

  [[nodiscard]] bool has_breaks() const { return !terms_->applied.empty(); }
  // s: the next moment after t at which an applied force on the body changes its law; infinite if there is
  // none.
  [[nodiscard]] double next_break(BodyIndex body, double t) const;
  void set_phase(BodyIndex body, double t);  // the laws in force just after t

  // One-sided springs that have an end at `body`.
  [[nodiscard]] std::span<const SpringIndex> switching_springs(BodyIndex body) const {
    return terms_->switching.empty() ? std::span<const SpringIndex>() : terms_->switching[body];
  }
  [[nodiscard]] bool has_switching_springs() const { return terms_->one_sided; }
  // > 0 where the spring acts, < 0 where it doesn't, in N or m; for positions and velocities of its ends.
  [[nodiscard]] double switch_margin(SpringIndex spring, const Motion& body, const Motion& other) const;
  [[nodiscard]] bool engaged(SpringIndex spring) const {
    return engaged_[static_cast<std::size_t>(spring)] != 0;
  }
  // Which springs act, by spring.
  using Switches = std::vector<std::uint8_t>;
  [[nodiscard]] const Switches& switches() const { return engaged_; }
  void set_switches(const Switches& engaged) { engaged_ = engaged; }
  // The hand of the model, which moves during the run.
  [[nodiscard]] const Vec2& hand_place() const { return hand_place_; }  // m
  void set_hand_place(const Vec2& place) { hand_place_ = place; }
  // N: on its body, if the grip is here (m) and moves so (m/s).
  [[nodiscard]] Vec2 pull_of_hand(const Vec2& grip, const Vec2& velocity) const {
    return terms_->hand->stiffness * (hand_place_ - grip) - terms_->hand->damping * velocity;
  }
  [[nodiscard]] bool attracts() const { return terms_->attraction.has_value(); }
  void set_engaged(SpringIndex spring, bool on) { engaged_[static_cast<std::size_t>(spring)] = on ? 1 : 0; }
  // J, where it acts, for positions of its ends.
  [[nodiscard]] double spring_energy(SpringIndex spring, const Motion& body, const Motion& other) const {
    return spring_energy(spring, line_of(terms_->springs[spring], body, other).along.norm());
  }
  [[nodiscard]] BodyIndex spring_body(SpringIndex spring) const { return terms_->springs[spring].body; }
  [[nodiscard]] BodyIndex spring_other(SpringIndex spring) const {
    return terms_->springs[spring].other;
  }  // -1: a point
  // Position and velocity of a spring's other end if it is a point or a body of infinite mass.
  [[nodiscard]] Motion spring_end(SpringIndex spring, double t) const;

 private:
  friend struct KeptMembers;  // what a run keeps from step to step

  struct Pull {
    Vec2 force;   // N, on `body`
    double loss;  // W, of the damper
  };
  // From a spring's other end to that on its body.
  struct SpringLine {
    Vec2 along;    // m
    Vec2 rate;     // m/s
    Vec2 arm;      // m, from the body's centre to its end
    Vec2 far_arm;  // m, likewise of a movable body at the other end
  };
  // For columns that begin with the rows of a motion; `far` has the point itself if that body can't move.
  template <class Own, class Far>
  static SpringLine line_of(const SpringTerm& spring, const Own& own, const Far& far) {
    SpringLine line;
    line.arm = arm_at(spring.point, own[2]);
    line.far_arm = arm_at(spring.other >= 0 ? spring.other_point : Vec2(Vec2::Zero()), far[2]);
    line.along = own.template head<2>() + line.arm - far.template head<2>() - line.far_arm;
    line.rate = own.template segment<2>(3) + own[5] * crossed(line.arm) - far.template segment<2>(3) -
                far[5] * crossed(line.far_arm);
    return line;
  }
  // m: from the centre of a body at an angle (rad) to a point of it.
  static Vec2 arm_at(const Vec2& point, double angle) {
    return point.isZero(0.0) ? point : turned_by(angle, point);
  }
  // Has code only for the parts that the model has.
  using AddExternal = void (ForceField::*)(BodyIndex, double, const Eigen::Vector3d&, const Eigen::Vector3d&,
                                           double*) const;
  template <bool kOnEach, bool kSprings, bool kApplied>
  void add_external(BodyIndex body, double t, const Eigen::Vector3d& q, const Eigen::Vector3d& v,
                    double* k) const;
  static AddExternal add_external_of(const ForceTerms& terms);
  [[nodiscard]] Pull pull(const SpringTerm& spring, const Vec2& d, const Vec2& u) const;
  [[nodiscard]] double spring_energy(SpringIndex spring, double length) const;  // J, where it acts
  [[nodiscard]] double coupling_energy(SpringIndex spring, const Eigen::Matrix3Xd& q) const;
  // m: where its other end is.
  static Vec2 other_end(const SpringTerm& spring, const Eigen::Matrix3Xd& q);
  static Vec2 place_of(const Eigen::Matrix3Xd& q, BodyIndex body, const Vec2& point) {
    const auto own = q.col(body);
    return own.head<2>() + arm_at(point, own[2]);
  }
  // N m: what turns nothing, as a point-like body takes no torque.
  [[nodiscard]] double untaken(BodyIndex body, double torque) const {
    return model_->mass.inverse_inertia[body] > 0.0 ? 0.0 : torque;
  }
  // W: that it takes from its spin all the same, as that stays.
  [[nodiscard]] double idle_power(BodyIndex body, double torque, double spin) const {
    return untaken(body, torque) * spin;
  }
  [[nodiscard]] double attraction_energy(BodyIndex a, BodyIndex b, const Vec2& d) const;

  std::shared_ptr<const Model> model_;
  const ForceTerms* terms_ = nullptr;  // the model's
  AddExternal add_external_ = nullptr;
  bool has_quadratures_ = false;
  bool constant_ = true;
  std::vector<std::uint8_t> engaged_;      // by spring
  ArrayOf<AppliedForceIndex, int> phase_;  // 0 before, 1 rising, 2 full, 3 after
  Vec2 hand_place_ = Vec2::Zero();
  bool in_contact_ = false;
  bool contact_changes_ = false;
  double contact_from_ = 0.0;  // s, absolute
  Eigen::Matrix3Xd contact_, contact_rate_;
};

}  // namespace carom
