#pragma once

#include <vector>

#include "physics/step/neighbours.h"
#include "physics/step/pair_list.h"
#include "physics/step/world.h"

namespace carom {

// Fraction of a penetration that the pseudo-spring removes in a step, dimensionless: small enough that a deep
// one separates without a burst of speed (positions move, velocities don't), large enough that it is gone in
// some 20 steps.
inline constexpr double kPenetrationFraction = 0.2;

// At the end of a step of h s, in the order of the list: each pair that penetrates gets its impulse if it
// closes, and is moved apart, by inverse mass: a resting pair completely, another by kPenetrationFraction.
// The state must be published; its positions are updated. `neighbours` is memory to work in.
void resolve_penetrations(World& world, const std::vector<WaitingPair>& pairs, Neighbours& neighbours,
                          double h);

}  // namespace carom
