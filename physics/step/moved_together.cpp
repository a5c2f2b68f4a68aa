#include "physics/step/moved_together.h"

#include <cmath>
#include <span>

#include "physics/collision/pair_contact.h"
#include "physics/step/pair_motion.h"

namespace carom {
namespace {

// Joints that are restored may bring a body back.
constexpr int kMostMoves = 8;

// 1/kg: of the bodies that move as this one is moved.
double inverse_mass(const World& world, std::span<const BodyIndex> bodies) {
  double mass = 0.0;
  for (const BodyIndex i : bodies) mass += world.mass().mass[i];
  return bodies.empty() ? 0.0 : 1.0 / mass;
}

// m: moves the bodies as they are; joints that hold them are restored.
void move(World& world, std::span<const BodyIndex> bodies, const Vec2& by) {
  if (bodies.empty()) return;
  double& correction = world.sums.ledger.penetration_correction;
  correction -= world.field().potential_energy(world.state.q);
  for (const BodyIndex i : bodies) {
    const Eigen::Vector3d q = world.trajectories.at_start(i).head<3>();
    world.trajectories.set_pose(i, q + Eigen::Vector3d(by.x(), by.y(), 0.0));
    world.state.q.col(i) = world.trajectories.at_start(i).head<3>();
  }
  correction += world.field().potential_energy(world.state.q);
  if (world.trajectories.is_jointed(bodies.front()))
    world.restore_joints(world.trajectories.island_of(bodies.front()));
}

}  // namespace

Contact moved_together(World& world, BodyIndex a, BodyIndex b, const Contact& apart) {
  const auto moving = [&world, a, b](const BodyIndex& body) -> std::span<const BodyIndex> {
    if (world.infinite_mass(body)) return {};
    if (!world.trajectories.is_jointed(body) ||
        world.trajectories.island_of(a) == world.trajectories.island_of(b))
      return {&body, 1};
    return world.trajectories.members(world.trajectories.island_of(body));
  };
  Contact contact = apart;
  for (int k = 0;; ++k) {
    const Contact now =
        contact_again(world.shapes(), a, pose_at_start(world, a), b, pose_at_start(world, b), apart);
    if (k == kMostMoves || std::abs(now.gap) <= touch_tolerance(world, a, b)) break;
    const double share_a = inverse_mass(world, moving(a));
    const double share_b = inverse_mass(world, moving(b));
    const Vec2 by = now.gap / (share_a + share_b) * now.normal;
    move(world, moving(a), share_a * by);
    move(world, moving(b), -share_b * by);
    contact.point += 0.5 * (share_a - share_b) * by;
  }
  return contact;
}

}  // namespace carom
