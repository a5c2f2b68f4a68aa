#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "physics/scene/method.h"
#include "physics/scene/scene.h"

namespace carom {

struct RunState;  // physics/world/run_state.h

// Where a run goes on that was saved on its way.
struct SavedRun {
  double time = 0.0;  // s, >= 0: what the clock shows at the start; drives and timed forces count from 0
  // Of the scene that the state belongs to (physics/scene/facts.h); 0: a clock alone.
  std::uint64_t fingerprint = 0;
  // None where the scene was changed since: the run goes on from its bodies and its clock alone.
  std::shared_ptr<const RunState> state{};
};

// What a simulation starts from.
struct RunSetup {
  Scene scene;
  Method method;
  std::optional<SavedRun> saved{};
  // Names of two bodies each: the impacts between them are counted one pair by one (see ImpactCounts).
  std::vector<std::pair<std::string, std::string>> counted_pairs{};
};

// s: what the clock shows at the start of a run.
[[nodiscard]] inline double start_time(const std::optional<SavedRun>& saved) {
  return saved ? saved->time : 0.0;
}

// Whether the state of a saved run is one of this scene.
[[nodiscard]] bool state_belongs(const Scene& scene, const std::optional<SavedRun>& saved);

}  // namespace carom
