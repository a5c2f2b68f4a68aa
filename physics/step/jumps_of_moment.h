#pragma once

#include <optional>

#include "physics/step/world.h"

namespace carom {

// The jumps of impacts at one moment: one for each entry of the log, the first of which has all of the motion.
class JumpsOfMoment {
 public:
  // Before the impacts, `within` s after the trajectories' epoch.
  JumpsOfMoment(World& world, double within);
  // After one of them has been recorded.
  void add(World& world);

 private:
  double within_;
  std::optional<Jump> next_;  // if jumps are wanted: the state before it, and less the ledger before it
};

}  // namespace carom
