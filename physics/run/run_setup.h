#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "physics/scene/edit.h"
#include "physics/scene/method.h"
#include "physics/scene/scene.h"

namespace carom {

struct Checkpoint;  // physics/run/checkpoint.h

// Where a saved run continues.
struct SavedRun {
  double time = 0.0;  // s, >= 0: the clock at the start; drives and timed forces count from 0
  // Of the checkpoint's scene (physics/scene/fingerprint.h); 0: there is only a clock.
  std::uint64_t fingerprint = 0;
  // None if the scene was changed since: the run continues from its bodies and its clock alone.
  std::shared_ptr<const Checkpoint> checkpoint{};
};

// A change of a run at `time` (see is_due()): another method from there on, or another scene; no edits of the
// scene only divide a step there. In a run a replaced body keeps its place and motion, a replaced joint without
// a length or an angle those that it has; edits of generators concern the next start alone.
struct RunEdit {
  double time = 0.0;     // s
  std::uint64_t id = 0;  // tells the edits of a session apart; 0: of the preset file
  std::variant<Method, SceneEdits> what;
};

// Whether an edit is applied at `time` (s), the end of a step, in a run whose steps last `step` (s): a scene
// changes at the edit's time, where a step ends (Simulation::next_step()); a method at the last end of a step
// that is not after it, so that it holds at once in a run that is on its way there.
[[nodiscard]] bool is_due(const RunEdit& edit, double time, double step);
// Whether a run that stands at `time` (s) before its edits would have applied this one before.
[[nodiscard]] bool was_due_before(const RunEdit& edit, double time, double step);
// Whether both are one edit of a session, at one time.
[[nodiscard]] inline bool is_same(const RunEdit& a, const RunEdit& b) {
  return a.id == b.id && a.time == b.time;
}
// Whether it puts a hand to a place, or takes it off, and does nothing else.
[[nodiscard]] inline bool moves_hand(const RunEdit& edit) {
  const auto* edits = std::get_if<SceneEdits>(&edit.what);
  return edits != nullptr && edits->size() == 1 && std::holds_alternative<SetHand>(edits->front());
}
[[nodiscard]] inline bool is_earlier(const RunEdit& a, const RunEdit& b) { return a.time < b.time; }

// A complete description of a run: what a simulation starts from, and its edits. The same setup gives the same
// run bit by bit.
struct RunSetup {
  Scene scene;
  Method method;
  std::optional<SavedRun> saved{};
  std::vector<RunEdit> edits{};  // in the order in which they are applied
  // Names of two bodies each: their impacts are counted separately (see ImpactCounts).
  std::vector<std::pair<std::string, std::string>> counted_pairs{};
};

// s: the clock at the start of a run.
[[nodiscard]] inline double start_time(const std::optional<SavedRun>& saved) {
  return saved ? saved->time : 0.0;
}

// All bodies of the run: those of the scene, then those that edits add, as they start.
[[nodiscard]] std::vector<Body> all_bodies(const RunSetup& setup);

// Whether the checkpoint of a saved run is one of this scene.
[[nodiscard]] bool state_belongs(const Scene& scene, const std::optional<SavedRun>& saved);

}  // namespace carom
