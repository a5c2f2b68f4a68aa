#pragma once

#include <optional>
#include <vector>

#include "physics/model/needs.h"
#include "physics/run/run_setup.h"

namespace carom {

// Cost of one part of the model in a run.
struct PartCost {
  const PartEntry* entry = nullptr;
  bool needed = false;
  // s of CPU time a step, medians over several pieces of the run. `with` is the run as it is, or with the
  // part added to its model if the scene does not need it. `without` is the scene without whatever needs the
  // part, or the run as it is. None if the run needs the part.
  double with = 0.0;
  std::optional<double> without;
};

// Measures each part, in the order of part_entries(), by runs of `setup` from its start to `until` (s),
// repeated as often as needed: some seconds in all. The setup must be valid.
[[nodiscard]] std::vector<PartCost> part_costs(const RunSetup& setup, double until);

}  // namespace carom
