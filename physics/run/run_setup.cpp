#include "physics/run/run_setup.h"

#include "physics/scene/fingerprint.h"
#include "physics/step/run_clock.h"

namespace carom {

std::vector<Body> all_bodies(const RunSetup& setup) {
  std::vector<Body> bodies = all_bodies(setup.scene);
  for (const RunEdit& edit : setup.edits) {
    const auto* edits = std::get_if<SceneEdits>(&edit.what);
    if (edits == nullptr) continue;
    for (const SceneEdit& each : *edits) {
      if (const auto* add = std::get_if<Add<Body>>(&each)) bodies.push_back(add->part);
    }
  }
  return bodies;
}

bool is_due(const RunEdit& edit, double time, double step) {
  const double rounding = kSameMoment * step;
  return std::holds_alternative<Method>(edit.what) ? edit.time + rounding < time + step
                                                   : edit.time <= time + rounding;
}

bool was_due_before(const RunEdit& edit, double time, double step) {
  return edit.time + kSameMoment * step < time;
}

// Bodies that come in later have no part in the state, so that it stays that of the scene without them.
bool state_belongs(const Scene& scene, const std::optional<SavedRun>& saved) {
  return saved && saved->fingerprint != 0 && saved->fingerprint == fingerprint(scene, saved->time);
}

}  // namespace carom
