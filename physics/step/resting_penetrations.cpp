#include <algorithm>
#include <optional>

#include "physics/contact/contact_velocity.h"
#include "physics/model/pair_size.h"
#include "physics/step/island_spin.h"
#include "physics/step/pair_motion.h"
#include "physics/step/penetrations.h"
#include "physics/step/resting_contacts.h"

// Penetrations that contact forces don't remove.
namespace carom {
namespace {

// Of what presses a contact in a step, times the step: smaller penetrations are left to the contact forces.
constexpr double kShallow = 0.5;
// Relative to the size: a smaller penetration is rounding, and one beyond kDeep is removed in several steps.
constexpr double kPenetration = 1e-12;
constexpr double kDeep = 0.05;
constexpr double kLargePenetration = 1e-6;  // where there is a large island: smaller ones stay
// Times the deepest of them: landings that are open by more are not closed as those are removed.
constexpr double kPushes = 2.0;

}  // namespace

// Projects positions out of penetrations that the contact forces don't remove; velocities stay.
void RestingContacts::project_penetrations(World& world) {
  Contacts& c = found_.contacts;
  double deepest = 0.0;  // of the size
  double size = 0.0;     // m, the least of a penetrating pair
  for (int i = 0; i < c.size(); ++i) {
    const double shallow =
        found_.is_new(i) ? 0.0
                         : kShallow * found_.press[static_cast<std::size_t>(i)] * step_length_ * step_length_;
    const double sizes = world.shapes().size[c.a[i]] + world.shapes().size[c.b[i]];
    if (!(c.gap[i] < -std::max(shallow, 16.0 * kPenetration * sizes))) continue;
    const double of_pair = pair_size(world.shapes(), c.a[i], c.b[i]);
    deepest = std::max(deepest, -c.gap[i] / of_pair);
    size = size > 0.0 ? std::min(size, of_pair) : of_pair;
  }
  if (!(deepest > 0.0)) return;
  const int contacts = c.size();
  add_landings(world, -kPushes * *std::min_element(c.gap.begin(), c.gap.end()));
  prepare(world);
  if (c.size() > contacts) prepared_ = false;
  if (has_large_island() && !(deepest > kLargePenetration)) {
    c.resize(contacts);
    return;
  }
  ContactSolverOptions options = solver_options();
  options.tolerance = kPenetration * size;
  options.enough = 0.0;
  options.large_tolerance = kLargePenetration * size;
  options.large_motion = nullptr;
  project_prepared(world.mass(), c, deepest > kDeep ? kPenetrationFraction : 1.0, moved_, options, workspace_);
  const double before = world.field().potential_energy(world.state.q);
  for (BodyIndex i{0}; i < world.state.size(); ++i) {
    if (world.infinite_mass(i) || moved_.col(i).isZero(0.0)) continue;
    world.trajectories.set_pose(i, world.trajectories.at_start(i).head<3>() + moved_.col(i));
    world.state.q.col(i) = world.trajectories.at_start(i).head<3>();
  }
  world.sums.ledger.penetration_correction += world.field().potential_energy(world.state.q) - before;
  keep_angular_momentum(world, c, workspace_.islands, moved_, bodies_);
  for (const IslandIndex k : world.trajectories.islands()) {
    if (world.trajectories.is_jointed(world.trajectories.members(k).front())) world.restore_joints(k);
  }
  c.resize(contacts);
  for (int i = 0; i < contacts; ++i) c.gap[i] += contact_velocity(c, i, moved_).normal;
}

// Adds the landings that are open by less than this (m) to the contacts: what is parted elsewhere is not to be
// moved into each other there.
void RestingContacts::add_landings(const World& world, double open) {
  Contacts& c = found_.contacts;
  for (const Landing& landing : found_.landings) {
    const std::optional<Contact> contact = contact_at_start(world, landing);
    if (!contact || contact->gap > open) continue;
    const auto& [a, b, id] = landing;
    const int i = c.size();
    c.resize(i + 1);
    set_place(c, i, {a, b}, contact->normal, {contact->point, contact->gap, id},
              pose_at_start(world, a).position, pose_at_start(world, b).position);
  }
}

}  // namespace carom
