#pragma once

#include <vector>

#include "physics/step/near_pairs.h"
#include "physics/step/pair_list.h"
#include "physics/step/penetrations.h"
#include "physics/step/world.h"

namespace carom {

class RestingContacts;

// Impacts at the step's end (the founding report's loop): all bodies fly for h. Then each penetrating pair,
// in the order of index pairs, gets its impulse if it approaches, and a pseudo-spring moves it apart.
class StepEndImpacts {
 public:
  // A step of h s. `resting` has begun it and supports its parts, or is null without resting contacts, which
  // otherwise remove all penetrations.
  void step(World& world, RestingContacts* resting, double h);

 private:
  void step_with_contacts(World& world, RestingContacts& resting, double h);
  static void fly(World& world, double start, double h);

  NearPairs near_pairs_;
  PenetrationScratch penetrations_;
  std::vector<WaitingPair> pairs_;
};

}  // namespace carom
