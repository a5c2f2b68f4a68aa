#include "physics/step/island_spin.h"

#include <span>
#include <vector>

#include "physics/math/sort_unique.h"
#include "physics/math/vectors.h"

namespace carom {
namespace {

// Lists the bodies of an island. False if one of them has infinite mass or joints.
bool list_free_bodies(const World& world, const Contacts& contacts, std::span<const int> island,
                      std::vector<BodyIndex>& bodies) {
  bodies.clear();
  for (const int c : island) {
    for (const BodyIndex i : {contacts.a[c], contacts.b[c]}) {
      if (world.infinite_mass(i) || world.trajectories.is_jointed(i)) return false;
      bodies.push_back(i);
    }
  }
  sort_unique(bodies);
  return true;
}

void turn_back(World& world, std::span<const BodyIndex> bodies, const Eigen::Matrix3Xd& moved) {
  double mass = 0.0;
  double gained = 0.0;  // kg m²/s
  Vec2 centre = Vec2::Zero();
  for (const BodyIndex i : bodies) {
    const auto y = world.trajectories.at_start(i);
    const double m = world.mass().mass[i];
    mass += m;
    centre += m * y.head<2>();
    gained += m * cross(Vec2(moved.col(i).head<2>()), Vec2(y.segment<2>(3)));
  }
  centre /= mass;
  double inertia = 0.0;
  for (const BodyIndex i : bodies)
    inertia += world.mass().mass[i] * (world.trajectories.at_start(i).head<2>() - centre).squaredNorm();
  if (gained == 0.0 || !(inertia > 0.0)) return;
  for (const BodyIndex i : bodies) {
    const auto y = world.trajectories.at_start(i);
    const Vec2 v = y.segment<2>(3);
    const Vec2 after = v - gained / inertia * crossed(y.head<2>() - centre);
    world.sums.ledger.penetration_correction +=
        0.5 * world.mass().mass[i] * (after.squaredNorm() - v.squaredNorm());
    world.trajectories.set_velocity(i, after, y[5]);
  }
}

}  // namespace

void keep_angular_momentum(World& world, const Contacts& contacts, const Islands& islands,
                           const Eigen::Matrix3Xd& moved, std::vector<BodyIndex>& scratch) {
  for (int k = 0; k < islands.size(); ++k) {
    if (list_free_bodies(world, contacts, islands.of(k), scratch)) turn_back(world, scratch, moved);
  }
}

}  // namespace carom
