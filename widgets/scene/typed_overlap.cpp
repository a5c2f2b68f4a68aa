#include "widgets/scene/typed_overlap.h"

#include <algorithm>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>

#include "widgets/scene/drag_limits.h"
#include "widgets/scene/overlap.h"

namespace carom {
namespace {

constexpr double kScale = 1000.0;  // px/m: lengths are said to the millimetre

std::pair<std::string, std::string> names_of(const Overlap& overlap) {
  return std::minmax(overlap.body.name, overlap.other.name);
}

}  // namespace

QString typed_overlap(const Scene& scene, const SceneEdits& edits) {
  const bool of_bodies = std::any_of(edits.begin(), edits.end(), [](const SceneEdit& edit) {
    return std::holds_alternative<Replace<Body>>(edit) || std::holds_alternative<Add<Body>>(edit);
  });
  if (!of_bodies) return {};
  Scene after = scene;
  try {
    apply_edits(after, edits);
  } catch (const std::out_of_range&) {
    return {};  // of a part that is gone: the edit itself is refused
  }
  std::map<std::pair<std::string, std::string>, double> before;  // m
  for (const Overlap& each : overlaps_among(scene.bodies, scene.joints)) before[names_of(each)] = each.depth;
  const Overlap* deepest = nullptr;
  const auto overlaps = overlaps_among(after.bodies, after.joints);
  for (const Overlap& each : overlaps) {
    if (each.depth > before[names_of(each)] && (deepest == nullptr || each.depth > deepest->depth))
      deepest = &each;
  }
  if (deepest == nullptr) return {};
  return overlap_text(*deepest, {.scale = kScale}) + ": they stay so, and play parts them.";
}

}  // namespace carom
