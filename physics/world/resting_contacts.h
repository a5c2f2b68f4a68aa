#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "physics/collision/pair_contact.h"
#include "physics/contact/contact_solver.h"
#include "physics/model/convex.h"
#include "physics/world/contact_force.h"
#include "physics/world/near_pairs.h"
#include "physics/world/world.h"

namespace carom {

// State of resting contacts between two steps.
struct ContactMemory {
  std::vector<ContactForce> forces;      // of the last step, in the order of (a, b)
  std::vector<Eigen::Vector3d> support;  // N, N and N m, parallel to forces: the solver's initial guess
  std::vector<std::uint8_t> held;        // by body: whether a contact pressed it; empty before the first step
  std::vector<int> pushed;               // bodies that contact forces act on
};

// A contact point that closes too fast to rest, of a pair that is supported at other points.
struct Landing {
  int a = 0;
  int b = 0;
  std::uint32_t id = 0;  // of the manifold's point
};

struct LandingTime {
  Landing landing;
  double time = 0.0;  // s after the epoch
};

// Forces that support bodies at rest, sliding or rolling on others.
//
// In each step, or part of one, support()
// 1. finds the manifolds of all pairs that may touch within the step; a point that the forces can press
//    together becomes a contact (rest_speed());
// 2. projects penetrations out: positions move, velocities don't;
// 3. stops approaches: a contact that closes, or would within the step, loses its closing speed at once;
// 4. finds contact forces, constant during the step, such that the velocities satisfy the contacts at its
//    end, after the integrator's own flight. They act on the trajectories like any other force. A contact
//    that is still open by a gap g may close at g/h.
// So sliding and resting under constant forces are exact; where contacts turn with the bodies the order is 1.
//
// Order of calls: begin_step(), then for each part of the step support(), the flight, record_forces(); at the
// end rebound_at_end().
class RestingContacts {
 public:
  // Starts a step of h s at the clock's time.
  void begin_step(World& world, double h);
  // Supports bodies for h s from the trajectories' epoch on. The state must be published.
  void support(World& world, double h);
  // On trajectories already built: the first landing before `end` (s after the epoch).
  [[nodiscard]] std::optional<LandingTime> first_landing(World& world, double end) const;
  // Lets the landed pair rebound by the law of impacts, if the rebound is faster than rest_speed().
  void land(World& world, const LandingTime& landing) const;
  // Enters the work of the contact forces until `passed` s after the epoch into the ledger; `share` is its
  // share of the time for which the forces were found.
  void record_forces(World& world, double passed, double share);
  // Of these pairs, those that penetrate at the step's end and close faster than a contact may rest rebound
  // by the law of impacts.
  void rebound_at_end(World& world, const std::vector<std::pair<int, int>>& pairs) const;
  // Takes all contact forces off the trajectories and forgets the contacts.
  void release(World& world);
  // After a step that was given up.
  void forget_forces() { memory_.forces.clear(); }

  // m/s: a contact that rebounds slower than this rests; the forces that press it would close it within a
  // step.
  [[nodiscard]] double rest_speed(const World& world, int a, int b, const Vec2& normal,
                                  double restitution) const;
  // Whether a contact supports the pair in this step; a < b.
  [[nodiscard]] bool supports(int a, int b) const;
  // Whether a supported pair moves so slowly that any touch in this step rests.
  [[nodiscard]] bool stays_supported(const World& world, int a, int b) const;
  // Pairs that may touch in this step, and supported pairs; each in rising order.
  [[nodiscard]] const std::vector<std::pair<int, int>>& near() const { return near_; }
  [[nodiscard]] const std::vector<std::pair<int, int>>& supported() const { return supported_; }

  [[nodiscard]] const std::vector<ContactForce>& forces() const { return memory_.forces; }  // of the last step
  [[nodiscard]] const ContactMemory& memory() const { return memory_; }
  void restore(const ContactMemory& memory) { memory_ = memory; }

 private:
  void find_contacts(World& world, double h);
  void add_contacts(World& world, int a, int b, const Manifold& m, double rounding, double h, std::size_t last);
  void project_penetrations(World& world);
  void stop_approaches(World& world, double h);
  void find_forces(World& world, double h);
  void record_impulses(World& world, double share) const;
  [[nodiscard]] ContactSolverOptions solver_options() const;
  // m/s: the largest change of a speed by forces in a step.
  [[nodiscard]] double change_by_forces() const;
  [[nodiscard]] bool has_large_island() const { return !workspace_.large_islands.blocks.empty(); }

  double step_length_ = 0.0;  // s: the method's step, or the step under way if that is longer
  ContactMemory memory_;
  NearPairs near_pairs_;
  Contacts contacts_;
  // Parallel to contacts_.
  std::vector<std::uint32_t> id_;
  std::vector<Vec2> point_;
  std::vector<Eigen::Vector3d> guess_;  // N, N and N m
  std::vector<std::uint8_t> sticks_;

  std::vector<std::pair<int, int>> near_;
  std::vector<std::pair<int, int>> supported_;
  std::vector<Landing> landings_;           // that may happen in this step
  Eigen::Matrix3Xd acceleration_;           // m/s², rad/s²: of all other forces, at the step's start
  Eigen::Matrix3Xd before_, after_, free_;  // velocities, m/s and rad/s
  Eigen::Matrix3Xd mean_;                   // likewise, those at which the contacts' work is taken
  Eigen::Matrix3Xd moved_;                  // m, rad
  std::vector<Pose> poses_;
  std::vector<double> reach_;  // m: how far each body may move within a whole step
  ContactWorkspace workspace_;
};

}  // namespace carom
