#pragma once

#include <functional>
#include <vector>

#include "physics/step/impact_cluster.h"
#include "physics/step/world.h"

namespace carom {

// A pair a < b that closes and overlaps at a step's end, or will within it.
struct Hit {
  BodyIndex a;
  BodyIndex b;
  Contact contact;
  double moment = 0.0;  // s from now: when the surfaces touch, as their gap and speed say

  friend BodyPair ends_of(const Hit& hit) { return {hit.a, hit.b}; }
};

// Buffers for resolve_in_order().
struct HitsInOrder {
  std::vector<Hit> hits;
  std::vector<Hit> together;
  ImpactCluster cluster;
};

// Where impacts are not located in time: resolves those of buffers.hits in the order in which they touch. Those
// that share bodies and touch at one moment, or within one step if the scene says so, are resolved at once;
// each that is left alone, or has no solution with the others, by `resolve_alone`. A step has h s; `within` is
// now, in s after the epoch. The hits are used up.
void resolve_in_order(World& world, HitsInOrder& buffers, double h, double within,
                      const std::function<void(const Hit&)>& resolve_alone);

}  // namespace carom
