#pragma once

#include <optional>
#include <variant>

#include "physics/dynamics/state.h"
#include "physics/ledger/run_sums.h"
#include "physics/step/event_driven_impacts.h"
#include "physics/step/resting_contacts.h"
#include "physics/step/step_end_impacts.h"
#include "physics/step/world.h"

namespace carom {

// What a simulation steps with. Apart from simulation.h, so that only those who step need the headers of the
// solvers.
struct SimulationParts {
  // Motions and sums at the end of the last good step.
  struct LastGood {
    State state;
    RunSums sums;
  };

  World world;  // of the compiled scene's model
  std::variant<StepEndImpacts, EventDrivenImpacts> impacts{};
  std::optional<RestingContacts> resting{};
  LastGood last_good{};
};

}  // namespace carom
