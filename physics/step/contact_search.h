#pragma once

#include "physics/step/pair_list.h"
#include "physics/step/resting_contacts.h"
#include "physics/step/world.h"

namespace carom {

// The next contact of two bodies on their trajectories.
struct NextContact {
  enum Kind {
    kNone,         // no contact while both trajectories last
    kImpact,       // contact at `time`
    kPenetrating,  // they penetrate and do not separate: resolved at the step's end
    kPressed       // they touch from `time` on, pressed together: likewise, as a resting pair
  };
  Kind kind = kNone;
  double time = 0.0;  // s after the epoch
};

// What the search knows about pairs apart from their trajectories.
struct SearchRules {
  const PairList& end_of_step;     // pairs that wait for the step's end
  const RestingContacts* resting;  // null without resting contacts
  double closing_share;            // of the bodies' speeds: a smaller closing speed counts as zero
  double from;                     // s after the epoch: earlier contacts don't count
  double until;                    // s after the epoch: nor do later ones
  bool lands_first;                // a landing ends this part: supported pairs that may land do so by it alone
  [[nodiscard]] bool rests(BodyIndex a, BodyIndex b, const ShapePair& parts) const {
    const bool supported =
        resting != nullptr && resting->finder().supports(a, b, parts) && !resting->finder().is_hit(a, b);
    return supported || end_of_step.rests(a, b);
  }
};

// m: a pair touches if its gap is no larger: within rounding or, where contact forces hold it, within
// their error in the middle of a step.
[[nodiscard]] double closed_gap(const World& world, const RestingContacts* resting, BodyIndex a, BodyIndex b,
                                double rounding);

// Finds the first contact of bodies a < b, which can collide, on their trajectories. The cost is taken from
// the step's budget; a search that is given up is reported by a notice.
[[nodiscard]] NextContact next_contact(World& world, const SearchRules& rules, BodyIndex a, BodyIndex b,
                                       const ShapePair& parts);

}  // namespace carom
