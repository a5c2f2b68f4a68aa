#include "physics/scene/edit.h"

#include <algorithm>
#include <fmt/format.h>
#include <iterator>
#include <stdexcept>
#include <utility>

namespace carom {
namespace {

// The list in which parts of a kind stand.
std::vector<Body>& list_of(Scene& scene, Id<Body> /*kind*/) { return scene.bodies; }
std::vector<Joint>& list_of(Scene& scene, Id<Joint> /*kind*/) { return scene.joints; }
std::vector<Spring>& list_of(Scene& scene, Id<Spring> /*kind*/) { return scene.forces.springs; }
std::vector<AppliedForce>& list_of(Scene& scene, Id<AppliedForce> /*kind*/) { return scene.forces.applied; }
std::vector<Material>& list_of(Scene& scene, Id<Material> /*kind*/) { return scene.materials; }
std::vector<MaterialPair>& list_of(Scene& scene, Id<MaterialPair> /*kind*/) { return scene.pairs; }
std::vector<GridGenerator>& list_of(Scene& scene, Id<GridGenerator> /*kind*/) { return scene.generators; }

template <class Part>
auto found(std::vector<Part>& list, Id<Part> id) {
  const auto part = std::find_if(list.begin(), list.end(), [id](const Part& p) { return p.id == id; });
  if (id.number == 0 || part == list.end())
    throw std::out_of_range(
        fmt::format("an edit of a part with the id {}, which is not in the scene", id.number));
  return part;
}

template <class Part>
SceneEdit applied(Scene& scene, const Add<Part>& add) {
  std::vector<Part>& list = list_of(scene, Id<Part>{});
  const auto before = list.begin() + static_cast<std::ptrdiff_t>(std::min(add.at, list.size()));
  Part& part = *list.insert(before, add.part);
  if (part.id.number == 0) part.id.number = scene.ids_given + 1;
  scene.ids_given = std::max(scene.ids_given, part.id.number);
  return Remove<Part>{part.id};
}

template <class Part>
SceneEdit applied(Scene& scene, const Replace<Part>& replace) {
  return Replace<Part>{std::exchange(*found(list_of(scene, replace.part.id), replace.part.id), replace.part)};
}

template <class Part>
SceneEdit applied(Scene& scene, const Remove<Part>& remove) {
  std::vector<Part>& list = list_of(scene, remove.id);
  const auto part = found(list, remove.id);
  Add<Part> back{std::move(*part), static_cast<std::size_t>(part - list.begin())};
  list.erase(part);
  return back;
}

SceneEdit applied(Scene& scene, const SetForces& set) {
  CommonForces& forces = scene.forces;
  return std::exchange(forces, set);
}

SceneEdit applied(Scene& scene, const SetHand& set) {
  return SetHand{std::exchange(scene.forces.hand, set.hand)};
}

SceneEdit applied(Scene& scene, const SetLaws& set) {
  return SetLaws{std::exchange(scene.impact_law, set.impact_law),
                 std::exchange(scene.several_impacts, set.several_impacts)};
}

}  // namespace

void give_ids(Scene& scene) {
  const auto give = [&scene](auto& list) {
    for (auto& part : list) {
      if (part.id.number == 0) part.id.number = ++scene.ids_given;
    }
  };
  give(scene.bodies);
  give(scene.materials);
  give(scene.pairs);
  give(scene.generators);
  give(scene.joints);
  give(scene.forces.springs);
  give(scene.forces.applied);
}

SceneEdit apply_edit(Scene& scene, const SceneEdit& edit) {
  return std::visit([&scene](const auto& e) { return applied(scene, e); }, edit);
}

SceneEdits apply_edits(Scene& scene, const SceneEdits& edits) {
  SceneEdits back;
  try {
    for (const SceneEdit& edit : edits) back.push_back(apply_edit(scene, edit));
  } catch (const std::out_of_range&) {
    std::for_each(back.rbegin(), back.rend(), [&scene](const SceneEdit& edit) { apply_edit(scene, edit); });
    throw;
  }
  std::reverse(back.begin(), back.end());
  return back;
}

}  // namespace carom
