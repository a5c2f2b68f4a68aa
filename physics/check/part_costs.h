#pragma once

#include <optional>
#include <vector>

#include "physics/model/needs.h"
#include "physics/world/run_setup.h"

namespace carom {

// What one part of the model costs a run.
struct PartCost {
  const PartEntry* entry = nullptr;
  bool needed = false;
  // s of CPU time a step, the medians of several pieces of the run. With: the run as it is, or (of a part that
  // is not needed) with the part put into its model. Without: the scene without what needs the part, or the run
  // as it is. None where the run can't be without.
  double with = 0.0;
  std::optional<double> without;
};

// Measures each part, in the order of part_entries(), by runs of `setup` from its start to `until` (s),
// repeated as long as a figure needs: some seconds in all. The setup must be valid.
[[nodiscard]] std::vector<PartCost> part_costs(const RunSetup& setup, double until);

}  // namespace carom
