#pragma once

#include <Eigen/Core>
#include <Eigen/QR>
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "physics/collision/tip_on_face.h"
#include "physics/contact/contact_rows.h"
#include "physics/dynamics/state.h"
#include "physics/step/contact_finder.h"
#include "physics/step/neighbours.h"
#include "physics/step/world.h"

namespace carom {

// The Gauss points, of a step, and the share that the force at one of them has in the linear force at a time;
// its integral from 0 on. Times are of the step.
inline constexpr std::array<double, 2> kGaussPoints{0.21132486540518711775, 0.78867513459481288225};
[[nodiscard]] double gauss_share(std::size_t point, double time);
[[nodiscard]] double gauss_share_until(std::size_t point, double time);

// A contact that breaks away from static friction at the end of a part of a step.
struct GaussBreak {
  double time = 0.0;  // s, absolute
  BodyIndex a, b;
  std::uint32_t id = 0;
  double slips = 0.0;  // σ from then on
};

// A part of a step in which contact forces are linear.
struct GaussStep {
  World& world;
  double h;      // s, from the epoch on
  double least;  // s: modes last so long; h: it can't be divided
  const Neighbours& neighbours;
  double tolerance;   // m/s: of velocities that contacts ask for
  double slip_speed;  // m/s: a contact that slips slower may stick
  FoundContacts& found;
  std::span<const GaussBreak> breaks;  // at its start
  // In a pile something is near its limit nearly always: only in a scene of so few contacts are contacts at
  // their limits followed, and gaps closed that constant forces leave.
  static constexpr int kFew = 32;
  [[nodiscard]] bool is_of_few() const { return found.contacts.size() <= kFew; }
};

// A contact that is closed at the start.
struct GaussContact {
  struct AtPoint {
    Vec2 normal = Vec2::UnitX();
    Vec2 point = Vec2::Zero();                          // m
    Vec2 arm_a = Vec2::Zero(), arm_b = Vec2::Zero();    // m
    double normal_force = 0.0, tangential_force = 0.0;  // N
    double gap = 0.0;                                   // m
    double slip = 0.0;                                  // m/s
  };
  struct AtTime {
    Vec2 normal = Vec2::UnitX();
    Vec2 arm_a = Vec2::Zero(), arm_b = Vec2::Zero();  // m
    double gap = 0.0;                                 // m
    double parting = 0.0, slip = 0.0;                 // m/s
  };
  int contact = 0;
  BodyIndex a, b;
  Eigen::Index column_a = 0, column_b = 0;  // of its bodies in the island
  std::optional<TipOnFace> tip;             // that touches at the start
  int face = 0;                             // contacts of the same face slip alike
  bool presses = true;
  bool spared = false;  // it has been taken to press no more, as others hold its bodies
  bool sticks = false;
  bool holds = false;       // it has the tangential force of all that stick on its face
  double slips = 0.0;       // σ, if it presses, rubs and does not stick
  bool at_limit = false;    // not sticking, static friction is full, and others may hold it still
  bool held_still = false;  // by others: its friction stays as it is
  bool broke_away = false;  // at the start, from static friction
  bool comes_back = false;  // it opens now and closes later within the step
  double stays_open = 0.0;  // m: the gap that it is to have at the end
  double breaks_at = 0.0;   // s, if above 0: when it breaks away
  double breaks_to = 0.0;   // σ from then on
  AtTime start{}, halfway{}, end{};
  std::array<AtPoint, 2> at{};
  int row = 0;  // of its normal in the island's system; then that of its tangent, if it sticks
};

// A body at a time.
struct PosedMotion {
  Kinematics y;
  Pose pose;
};
[[nodiscard]] PosedMotion posed(const World& world, BodyIndex body, const Kinematics& y);

// Bodies that closed contacts join, and the contacts' forces at the Gauss points of a step (gauss_contacts.h).
class GaussIsland {
 public:
  // The closed contacts among these, with the modes and the forces that constant forces have. False if forces
  // can't be linear, or need not be.
  bool begin(const GaussStep& step, std::span<const int> contacts);
  // Finds forces for the modes as they stand, and puts them on the trajectories. False if there are none.
  bool solve(const GaussStep& step);
  // The forces from before that, and the flights under them, after it has found none.
  bool take_back(const GaussStep& step);
  // Whether fewer of the contacts that press would hold their bodies as well.
  [[nodiscard]] bool is_redundant() const;
  // A face breaks away at this time, in s.
  void note_break(int face, double time, double slips);
  // Shares what holds a face among its contacts, by how much each can hold.
  void share_friction(const GaussStep& step);
  // The constant forces again.
  void put_back(const GaussStep& step) const;

  [[nodiscard]] std::vector<GaussContact>& closed() { return closed_; }
  [[nodiscard]] const std::vector<GaussContact>& closed() const { return closed_; }
  [[nodiscard]] std::span<const int> contacts() const { return contacts_; }
  [[nodiscard]] const PosedMotion& at_end(BodyIndex body) const { return sampled(body).end; }

 private:
  // A body at the times at which it is looked at.
  struct Sampled {
    PosedMotion start, halfway, end;
    std::array<PosedMotion, 2> at;
    std::array<Vec2, 2> mean;  // m: where arms start
  };

  bool list(const GaussStep& step);
  [[nodiscard]] GaussContact* same_contact(const GaussStep& step, int i);
  [[nodiscard]] int face_of(const GaussStep& step, int i) const;
  // Gives a contact the tangential forces of all that stick on its face.
  void hold_face(GaussContact& holder);
  bool start(const GaussStep& step, GaussContact& c) const;
  [[nodiscard]] std::optional<TipOnFace> tip_over_seam(const GaussStep& step, const GaussContact& c) const;
  [[nodiscard]] std::pair<double, double> friction_on(const GaussStep& step, int face) const;
  [[nodiscard]] bool is_needed(const GaussStep& step) const;
  void sample(const GaussStep& step, std::size_t place);
  [[nodiscard]] const Sampled& sampled(BodyIndex body) const;
  [[nodiscard]] Eigen::Index column(BodyIndex body) const;
  bool look(const GaussStep& step);
  [[nodiscard]] bool is_continued(const GaussStep& step) const;
  [[nodiscard]] double off(const GaussStep& step, double left) const;
  void build(const GaussStep& step);
  void add_column(const GaussStep& step, const GaussContact& c, std::size_t point, int to, double normal,
                  double tangential);
  void correct(const GaussStep& step);
  void push(const GaussStep& step);
  bool fly(const GaussStep& step);

  std::span<const int> contacts_;
  std::vector<GaussContact> closed_;
  std::vector<bool> held_;                                    // by face
  std::vector<BodyIndex> bodies_;                             // in rising order
  bool jointed_ = false;                                      // some of them
  std::vector<Sampled> sampled_;                              // by place in bodies_, as are the columns below
  Eigen::Matrix3Xd constant_;                                 // accelerations by the constant forces
  std::array<Eigen::Matrix3Xd, 2> by_;                        // likewise by those at the Gauss points
  Eigen::Matrix3Xd answers_;                                  // velocities, to a unit impulse
  std::vector<std::array<GaussContact::AtPoint, 2>> before_;  // by contact: at the Gauss points, before solve()
  int rows_ = 0;
  Eigen::MatrixXd matrix_;           // accelerations of the contacts, as they are at the end, to unit forces
  Eigen::MatrixXd wanted_, change_;  // by row, at the Gauss points
  std::array<Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd>, 2> solver_;  // for forces at each point
};

// A contact in these motions of its bodies; a corner that has left its face stays on the face's line. False if
// there is none.
bool find_contact(const GaussStep& step, const GaussContact& c, const PosedMotion& of_a,
                  const PosedMotion& of_b, Contact& contact, RowVelocity& velocity);
// Likewise where the bodies are nearest: the point of this id or, where a corner has come to face the other
// body by another edge, the one nearest to touching.
bool find_contact(const World& world, BodyIndex a, const PosedMotion& of_a, BodyIndex b,
                  const PosedMotion& of_b, std::uint32_t id, Contact& contact, RowVelocity& velocity);
[[nodiscard]] GaussContact::AtTime at_time(const Contact& contact, const PosedMotion& of_a,
                                           const PosedMotion& of_b, const RowVelocity& velocity);
// That of a contact that does not stick.
[[nodiscard]] double friction_of(const GaussStep& step, const GaussContact& c);
// m: of a contact at this point, smaller gaps are rounding.
[[nodiscard]] double closed_within(const GaussStep& step, BodyIndex a, BodyIndex b, const Vec2& point);

}  // namespace carom
