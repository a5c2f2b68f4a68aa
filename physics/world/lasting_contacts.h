#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <utility>
#include <vector>

#include "physics/contact/contact_solver.h"
#include "physics/model/convex.h"

namespace carom {

// What holds two bodies at one point during a step.
struct ContactForce {
  int a = 0;
  int b = 0;                      // a < b
  std::uint32_t id = 0;           // of the manifold's point; stays while the same features touch
  Vec2 point = Vec2::Zero();      // m, at the step's start
  Vec2 normal = Vec2::UnitX();    // from a to b
  double normal_force = 0.0;      // N, mean over the step: the force on b along the normal
  double tangential_force = 0.0;  // N, along the normal turned by +90°
  double rolling_moment = 0.0;    // N m
  bool sticks = false;            // did not slip
};

// A point of a pair that contacts hold elsewhere, which closes too fast to last.
struct Landing {
  int a = 0;
  int b = 0;
  std::uint32_t id = 0;  // of the manifold's point
};

// The lasting contacts of a simulation: those of the step under way, and what the next step starts from. Points
// are in the order of (a, b), so that both lists can be walked side by side.
//
// In each step (lasting_contacts.cpp)
// 1. the manifolds of all pairs that may touch within the step are found, and what the forces can press
//    together becomes a contact (see Simulation::is_slow);
// 2. overlaps are projected out: positions move, velocities don't;
// 3. velocities are made to fit the contacts at once: what touches down loses its closing speed;
// 4. contact forces, constant during the step, are found such that at its end the velocities fit again, after
//    the integrator's own flight. They act on the tracks as any other force does. A contact that is still open
//    by a gap g may close at g/h.
// With impacts at their own time a step is divided where something touches down.
// So sliding and resting under constant forces are exact; where contacts turn with the bodies the order is 1.
struct LastingContacts {
  Contacts contacts;
  std::vector<std::uint32_t> id;
  std::vector<Vec2> point;
  std::vector<ContactForce> forces;  // of the last step
  // Of step 4, in N, N and N m: where the next step starts, beside forces, and where this one does, beside
  // contacts. Part of a step counts for its share: what a very short one leaves is mostly the solver's
  // tolerance.
  std::vector<Eigen::Vector3d> hold, guess;
  std::vector<std::uint8_t> sticks;

  std::vector<std::pair<int, int>> near;   // pairs that may meet in this step, in rising order
  std::vector<Landing> landings;           // that may happen in this step
  std::vector<std::pair<int, int>> holds;  // those with a contact, likewise
  std::vector<std::uint8_t> held;          // by body: a contact pressed it in the last step
  std::vector<int> pushed;                 // bodies that contact forces act on
  Eigen::Matrix3Xd acceleration;           // m/s², rad/s²: of all other forces, at the step's start
  Eigen::Matrix3Xd before, after, free;    // velocities, m/s and rad/s
  Eigen::Matrix3Xd mean;                   // likewise, those that the contacts' work is booked at
  Eigen::Matrix3Xd moved;                  // m, rad
  std::vector<Pose> poses;
  std::vector<double> reach;  // m: how far each body may come within a whole step
  ContactWorkspace workspace;
};

}  // namespace carom
