#pragma once

#include <vector>

#include "physics/world/pair_list.h"
#include "physics/world/world.h"

namespace carom {

// Fraction of a penetration that the pseudo-spring takes away in a step, dimensionless: small enough that a
// deep one parts without a burst of speed (positions move, velocities don't), large enough that it is gone in
// some 20 steps.
inline constexpr double kPenetrationFraction = 0.2;

// At the end of a step of h s: each of these pairs that penetrates gets its impulse if it closes, in their
// order, and is moved apart, a resting pair for good, another by kPenetrationFraction, shared by inverse mass.
// The state must be published; positions in it follow.
void resolve_penetrations(World& world, const std::vector<WaitingPair>& pairs, double h);

}  // namespace carom
