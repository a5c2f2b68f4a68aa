#pragma once

#include <cstdint>
#include <vector>

#include "physics/step/hits_in_order.h"
#include "physics/step/neighbours.h"
#include "physics/step/pair_list.h"
#include "physics/step/world.h"

namespace carom {

// Fraction of a penetration that the pseudo-spring removes in a step, dimensionless: small enough that a deep
// one separates without a burst of speed (positions move, velocities don't), large enough that it is gone in
// some 20 steps.
inline constexpr double kPenetrationFraction = 0.2;

// How a pair a < b is moved apart.
struct Push {
  BodyIndex a;
  BodyIndex b;
  Vec2 by;  // kg m: b, and a the opposite way, divided by their masses
};

// Buffers for resolve_penetrations().
struct PenetrationScratch {
  Neighbours neighbours;
  HitsInOrder in_order;
  // By body: struck in some round; hit in the last one, or joined to what was.
  enum Mark : std::uint8_t { kStruck = 1, kStirred = 2, kBoth = kStruck | kStirred };
  std::vector<std::uint8_t> marks;
  std::vector<Push> pushes;
};

// At the end of a step of h s: pairs that penetrate and close get their impulses in the order in which they
// met, those of one moment that share bodies at once (hits_in_order.h), and in the next round so do those that
// these set off: the order of the list decides nothing. It does in the end, where what still closes, mostly by
// gravity, gets its impulse, and resting pairs do. These are moved apart completely, by inverse mass, and last
// all others by kPenetrationFraction, or less in a crowd. The state must be published; its positions are
// updated. The result is the largest effect of the impacts.
[[nodiscard]] ImpactEffect resolve_penetrations(World& world, const std::vector<WaitingPair>& pairs,
                                                PenetrationScratch& scratch, double h);

}  // namespace carom
