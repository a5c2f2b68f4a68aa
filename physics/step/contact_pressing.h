#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <vector>

#include "physics/step/contact_force.h"
#include "physics/step/neighbours.h"
#include "physics/step/world.h"

namespace carom {

// Times pressed_speed(): a contact that closes faster is hit.
inline constexpr double kGentlyClosed = 2.0;

// What presses bodies together in a step: all forces at its start, and the contact forces of the last step or
// part of one. It decides whether a contact that closes is a hit or comes to rest.
class ContactPressing {
 public:
  // For a step of step_length s, at the start of trajectories on which no contact forces act. If it may be
  // divided, what happens within it is followed in scenes with few contacts.
  void find(World& world, double step_length, bool may_divide, const ContactMemory& memory);
  // Whether what rebounds with e < 1 and slower than forces change a speed in a step rests, pressed or not:
  // where bodies rattle, their bounces would be too many to follow.
  void calm(bool calms) { calms_ = calms; }
  // After the contact forces have changed.
  void update(const World& world, const ContactMemory& memory);

  // m/s²: how fast the pair a < b would close at this point along this normal without its own contacts, and
  // faster where those at other points tilt it. In a scene with few contacts those bodies that nothing moves
  // are one, such as the tiles of a floor.
  [[nodiscard]] double between(const World& world, const ContactMemory& memory, BodyIndex a, BodyIndex b,
                               const Vec2& point, const Vec2& normal) const;
  // m/s: a contact that `press` (m/s²) closes rests if it rebounds slower than this: the press would close it
  // again within a step, or within a small part of one where bounces are followed. noise() if nothing presses
  // it.
  [[nodiscard]] double rest_speed(const World& world, double press, double restitution) const;
  // m/s: how fast forces can make a contact close within a step; at least its rest speed.
  [[nodiscard]] double pressed_speed(BodyIndex a, BodyIndex b, double rest) const {
    return std::max(rest, step_length_ * std::max(acceleration(a), acceleration(b)));
  }
  // Whether contacts begin, end and bounce at their own times within this step.
  [[nodiscard]] bool follows_bounces() const { return follows_bounces_; }
  // m/s: slower motions are rounding, or what the order of the method leaves.
  [[nodiscard]] double noise() const { return noise_; }
  // m/s: the largest change of a speed by other forces than those of contacts in a step.
  [[nodiscard]] double change_by_forces() const { return change_by_forces_; }
  // m/s²: a body's acceleration by other forces than those of contacts.
  [[nodiscard]] double acceleration(BodyIndex body) const { return acceleration_.col(body).head<2>().norm(); }

 private:
  // Accelerations of its two bodies by a contact force, m/s² and rad/s².
  struct Push {
    Eigen::Vector3d of_a;
    Eigen::Vector3d of_b;
  };

  double step_length_ = 0.0;  // s
  bool follows_bounces_ = false;
  bool calms_ = false;
  std::vector<Push> pushes_;       // parallel to the forces of the memory
  Eigen::Matrix3Xd acceleration_;  // m/s², rad/s²: of all other forces
  Eigen::Matrix3Xd pressing_;      // likewise, of all forces
  double noise_ = 0.0;
  double change_by_forces_ = 0.0;
};

// Moves the points of forces to where their contacts are when `passed` s of their part are over, to press
// bodies together there. Where a body has slid over a seam its contact goes on at the same place, with another
// body. Those that have ended press no more.
void carry_forces(World& world, double passed, const Neighbours& neighbours, ContactMemory& memory);

}  // namespace carom
