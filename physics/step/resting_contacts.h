#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "physics/contact/contact_solver.h"
#include "physics/math/anderson_mixing.h"
#include "physics/step/contact_finder.h"
#include "physics/step/contact_force.h"
#include "physics/step/contact_pressing.h"
#include "physics/step/contact_turning.h"
#include "physics/step/face_ends.h"
#include "physics/step/gauss_contacts.h"
#include "physics/step/hits_in_order.h"
#include "physics/step/world.h"

namespace carom {

struct LandingTime {
  Landing landing;
  double time = 0.0;  // s after the epoch
};

// Forces that support bodies at rest, sliding or rolling on others.
//
// In each step, or part of one, support()
// 1. finds the manifolds of all pairs that may touch within the step; a point that the forces can press
//    together becomes a contact (contact_finder.h, contact_pressing.h);
// 2. projects deep penetrations out: positions move, velocities don't;
// 3. stops approaches: a contact that closes, or may within the step (contact_finder.h), loses its speed;
// 4. finds contact forces, constant during the step, such that the velocities satisfy the contacts at its
//    end, after the integrator's own flight (contact_turning.h). They act on the trajectories like any other
//    force. A new contact that is still open by a gap g may close at g/h.
// 5. where contacts turn or forces change, replaces them in small islands by forces that are linear in time
//    (gauss_contacts.h), and ends the part where the first of those contacts changes its mode.
// So sliding and resting under constant forces are exact; otherwise the order is the integrator's, at most 4
// with linear forces and 2 with constant ones.
//
// Order of calls: begin_step(), then for each part of the step support(), the flight, record_forces(); at the
// end rebound_at_end().
class RestingContacts {
 public:
  // Starts a step of h s at the clock's time.
  void begin_step(World& world, double h);
  // Supports bodies for h s from the trajectories' epoch on; with may_divide for less, where before that a disc
  // or corner runs off the end of a face (face_ends.h), a contact changes its mode (gauss_contacts.h) or a
  // force its law. Without it, as support_part() does. The state must be published.
  // `hit`: bodies have been hit or have landed at the start.
  void support(World& world, double h, bool may_divide, bool hit);
  // s: for how long support() was.
  [[nodiscard]] double supported() const { return supported_; }
  // Where few bodies move, ends the part at this time (s after the epoch), at which something lands: forces
  // keep contacts closed best at its end. False if that changes nothing.
  bool end_part(World& world, double time);
  // Likewise where impacts are not located in time, for a part of a step: at most `left` parts of kMostParts,
  // fewer where bodies in a crowd move or turn so fast that contacts found now soon are others. How many.
  int support_part(World& world, double step, int left);
  static constexpr int kMostParts = 16;
  // On trajectories already built: the first landing before `end` (s after the epoch).
  [[nodiscard]] std::optional<LandingTime> first_landing(World& world, double end) const;
  // Lets the landed pair rebound by the law of impacts, if the rebound is faster than rest_speed(). Others that
  // land at the same moment are stopped with it, all at once at the start of the next part, if none rebounds.
  void land(World& world, const LandingTime& landing);
  // Until the step's end, what rattles comes to rest (ContactPressing::calm).
  void calm() { pressing_.calm(true); }
  // Whether the landings of these bodies are found by first_landing().
  [[nodiscard]] bool awaits(BodyIndex a, BodyIndex b) const;
  // Where the pair hits at the trajectories' start: faster than that.
  [[nodiscard]] std::optional<Contact> hit_now(const World& world, const Landing& landing) const;
  // Enters the work of the contact forces until `passed` s after the epoch into the ledger; `share` is its
  // share of the time for which the forces were found.
  void record_forces(World& world, double passed, double share);
  // Of these pairs, those that penetrate at the step's end and close faster than a contact may rest rebound
  // by the law of impacts.
  void rebound_at_end(World& world, const std::vector<BodyPair>& pairs) const;
  // Whether an impact of these bodies changes the contact forces, in a scene with few, or the time of a
  // landing, where few move: they are found again then.
  [[nodiscard]] bool is_disturbed(const World& world, BodyIndex a, BodyIndex b) const;
  // Takes all contact forces off the trajectories and forgets the contacts.
  void release(World& world);
  // After a step that was given up.
  void forget_forces() { memory_ = {}; }

  // Whether contact forces press the pair a < b together in this part of a step, in which bounces are followed.
  [[nodiscard]] bool holds(BodyIndex a, BodyIndex b) const;
  // m/s: a contact of the pair a < b that rebounds slower than this rests (ContactPressing::rest_speed).
  [[nodiscard]] double rest_speed(const World& world, BodyIndex a, BodyIndex b, const Vec2& point,
                                  const Vec2& normal, double restitution) const;
  [[nodiscard]] const ContactFinder& finder() const { return finder_; }

  [[nodiscard]] const std::vector<ContactForce>& forces() const { return memory_.forces; }  // of the last step
  [[nodiscard]] const ContactMemory& memory() const { return memory_; }
  void restore(const ContactMemory& memory) { memory_ = memory; }

 private:
  void take_off_forces(World& world);
  void support_found(World& world, double h);
  void find_contacts(World& world, double h);
  bool keep_what_sinks(const World& world);
  double end_of_faces(World& world, double h);
  [[nodiscard]] double shortest_part(const World& world) const;
  double hold(World& world, double h, double least);
  [[nodiscard]] int parts_at_once(const World& world, double h);
  void project_penetrations(World& world);
  void add_landings(const World& world, double open);
  void strike(World& world, double h);
  void join_what_rests(World& world);
  bool stop_approaches(World& world, double h);
  void find_impacts(const World& world);
  void let_leave(const World& world);
  double find_forces(World& world, double h, double least);
  double find_best_forces(World& world, double h, double least);
  [[nodiscard]] bool may_guess_roughly(const World& world) const;
  double guess_forces(World& world, double h, double accuracy);
  double improve_forces(World& world, double h, double least);
  [[nodiscard]] std::optional<Approach> rebound(const World& world, BodyIndex a, BodyIndex b,
                                                const ShapePair& parts) const;
  void remember_forces(const World& world, double h);
  ContactSolverReport solve_flight(World& world, double h, const ContactSolverOptions& options);
  ContactSolverReport solve(const World& world, const Eigen::Matrix3Xd& from,
                            const ContactSolverOptions& options);
  ContactSolverReport solve_going_straight_on(World& world, double h, const ContactSolverOptions& options);
  [[nodiscard]] bool is_unsolved(const ContactSolverReport& report) const;
  void list_breaking(double still);
  [[nodiscard]] bool is_few() const { return found_.contacts.size() <= kFewContactsOfScene; }
  void push_as_before(World& world);
  void fly(World& world, double h);
  [[nodiscard]] ContactSolverOptions solver_options() const;
  [[nodiscard]] bool has_large_island() const { return workspace_.has_large_island(); }
  void prepare(const World& world);
  void read_velocities(const World& world);

  void list_landing_with(const World& world, const Landing& landing, const SurfaceLaw& law);

  double supported_ = 0.0;    // s
  double whole_step_ = 0.0;   // s: the method's step, or the step under way if that is longer
  double step_length_ = 0.0;  // s: that, or of the part under way
  ContactMemory memory_;
  bool may_divide_ = false;
  bool hit_ = false;  // in this part, at its start
  ContactPressing pressing_;
  ContactFinder finder_;
  FoundContacts found_;
  Contacts at_start_;                            // as found
  std::vector<Eigen::Vector3d> support_before_;  // N, N and N m, likewise
  GuessedFlight flight_;
  ContactSolverReport guessed_;             // of the last constant forces
  Eigen::Matrix3Xd before_, after_, free_;  // velocities, m/s and rad/s
  Eigen::Matrix3Xd moved_;                  // m, rad; or per s
  std::vector<std::uint8_t> sticks_;
  std::vector<std::optional<double>> impacts_;  // m/s, by contact: how fast it closed, if it is an impact
  std::vector<int> breaking_;                   // contacts
  Contacts solved_;                             // of the round before
  Eigen::Matrix3Xd solved_after_;               // likewise
  AndersonMixing mixing_;                       // of what joints and forces change in the contacts' flight
  Eigen::VectorXd off_;                         // m/s and rad/s: its residual, by body
  HitsInOrder in_order_;
  GaussContacts linear_;
  std::vector<TouchNearEnd> near_ends_;
  std::vector<Landing> together_;     // that land at one moment, at the start of the next part
  std::vector<std::uint8_t> struck_;  // by body, in this step
  std::vector<BodyIndex> bodies_;     // of an island
  std::vector<int> partners_;         // by body: how many others it may touch
  bool prepared_ = false;
  ContactWorkspace workspace_;
};

}  // namespace carom
