#pragma once

#include <utility>
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

// Buffers for resolve_at_once().
struct HitsAtOnce {
  std::vector<Hit> hits;
  std::vector<Hit> together;
  ImpactCluster cluster;
};

// Where impacts are not located in time: resolves those of buffers.hits at once that share bodies and touch at
// one moment, or within one step if the scene says so. The others are left to the caller. A step has h s;
// `within` is now, in s after the epoch. The hits are used up.
void resolve_at_once(World& world, HitsAtOnce& buffers, double h, double within);

}  // namespace carom
