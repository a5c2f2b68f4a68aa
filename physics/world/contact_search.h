#pragma once

#include "physics/world/pair_list.h"
#include "physics/world/resting_contacts.h"
#include "physics/world/world.h"

namespace carom {

// What two bodies on their trajectories do next.
struct NextContact {
  enum Kind {
    kNone,         // they do not meet while both trajectories last
    kImpact,       // they meet at `time`
    kPenetrating,  // they penetrate and do not part: left to the step's end
    kPressed       // they touch from `time` on, and something presses them together: likewise, at rest
  };
  Kind kind = kNone;
  double time = 0.0;  // s after the epoch
};

// What is known of pairs beside their trajectories.
struct SearchRules {
  const PairList& end_of_step;     // pairs that wait for the step's end
  const RestingContacts* resting;  // null without
  double closing_share;            // of the bodies' speeds: below this they don't close
  [[nodiscard]] bool rests(int a, int b) const {
    return (resting != nullptr && resting->supports(a, b)) || end_of_step.rests(a, b);
  }
};

// Searches the first contact of a < b, which can meet, on their trajectories. Costs are taken from the step's
// budget; a search that has to be given up is told by a notice.
[[nodiscard]] NextContact next_contact(World& world, const SearchRules& rules, int a, int b);

}  // namespace carom
