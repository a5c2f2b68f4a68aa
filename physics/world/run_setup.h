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

struct Checkpoint;  // physics/world/checkpoint.h

// Where a saved run continues.
struct SavedRun {
  double time = 0.0;  // s, >= 0: the clock at the start; drives and timed forces count from 0
  // Of the checkpoint's scene (physics/scene/facts.h); 0: there is only a clock.
  std::uint64_t fingerprint = 0;
  // None if the scene was changed since: the run continues from its bodies and its clock alone.
  std::shared_ptr<const Checkpoint> checkpoint{};
};

// What a simulation starts from.
struct RunSetup {
  Scene scene;
  Method method;
  std::optional<SavedRun> saved{};
  // Names of two bodies each: their impacts are counted separately (see ImpactCounts).
  std::vector<std::pair<std::string, std::string>> counted_pairs{};
};

// s: the clock at the start of a run.
[[nodiscard]] inline double start_time(const std::optional<SavedRun>& saved) {
  return saved ? saved->time : 0.0;
}

// Whether the checkpoint of a saved run is one of this scene.
[[nodiscard]] bool state_belongs(const Scene& scene, const std::optional<SavedRun>& saved);

}  // namespace carom
