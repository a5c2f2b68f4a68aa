#include "physics/preset/start_fingerprint.h"

#include <variant>

#include "physics/scene/fingerprint.h"

namespace carom {

std::uint64_t fingerprint_of_late_bodies(const RunEdit& edit) {
  const auto* edits = std::get_if<SceneEdits>(&edit.what);
  if (edits == nullptr) return 0;
  Scene alone;
  for (const SceneEdit& each : *edits) {
    if (const auto* add = std::get_if<Add<Body>>(&each)) alone.bodies.push_back(add->part);
  }
  return alone.bodies.empty() ? 0 : fingerprint(alone, edit.time);
}

std::uint64_t fingerprint_of_start(const Scene& scene, const std::optional<SavedRun>& saved,
                                   const std::vector<RunEdit>& late) {
  constexpr std::uint64_t kPrime = 0x100000001b3ULL;
  std::uint64_t start = fingerprint(scene, start_time(saved));
  for (const RunEdit& edit : late) {
    const std::uint64_t added = fingerprint_of_late_bodies(edit);
    if (added != 0) start = (start * kPrime) ^ added;  // their order counts: it is that of the run's bodies
  }
  return start != 0 ? start : 1;
}

std::uint64_t fingerprint_of_start(const Preset& preset) {
  return fingerprint_of_start(preset.scene, preset.saved, preset.edits);
}

}  // namespace carom
