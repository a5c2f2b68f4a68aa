#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "physics/ledger/impact_record.h"
#include "physics/model/compiled_scene.h"
#include "physics/run/run_setup.h"

namespace carom {

class Simulation;

// The impacts of one moment with the states before and after each. Constant once made.
struct JumpMoment {
  std::shared_ptr<const CompiledScene> compiled;  // of the run
  std::vector<Joint> joints;                      // after the step: those of the scene and of bodies that stuck
  std::vector<ImpactRecord> records;              // at least one
  std::vector<Jump> jumps;                        // one each

  [[nodiscard]] double time() const { return records.front().time; }  // s
  [[nodiscard]] const State& before() const { return jumps.front().before; }
  [[nodiscard]] const State& after() const { return jumps.back().after; }
  // Those that collide and those whose velocities jump, as through a joint; in rising order.
  [[nodiscard]] std::vector<BodyIndex> bodies() const;
};

// The moments with impacts of the last step, in the order of time; of a step with too many impacts to record
// their jumps only the first ones. The run watches its impacts.
[[nodiscard]] std::vector<std::shared_ptr<const JumpMoment>> jump_moments(const Simulation& run);
// The last moment with impacts of the last step; nullptr if there is none, or if its jumps are not recorded.
[[nodiscard]] std::shared_ptr<const JumpMoment> last_jump_moment(const Simulation& run);
// The first moment with impacts of a run, by repeating it from its start to `end` (s); nullptr if there is none
// until then, or its jumps are not recorded. Before each step `go_on` is asked; if it returns false there is no
// result.
[[nodiscard]] std::shared_ptr<const JumpMoment> first_jump_moment(const RunSetup& setup, double end,
                                                                  const std::function<bool()>& go_on);

}  // namespace carom
