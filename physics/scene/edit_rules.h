#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "physics/scene/edit.h"

// What edits are about, and what they take along. Plain functions of a scene and an edit of it.
namespace carom {

// The part of this id; null if there is none.
template <class Part>
[[nodiscard]] const Part* part_of(const std::vector<Part>& list, Id<Part> id) {
  const auto found = std::find_if(list.begin(), list.end(), [id](const Part& part) { return part.id == id; });
  return found == list.end() ? nullptr : &*found;
}

// Whether an edit is about where things are and how fast they move, in a scene as it stands: a part that is
// new, other ends of a joint or a spring, another place, angle, velocity or spin of a body. All other edits are
// about what things are (mass, size, surface, forces, laws, ...), or take a part away.
[[nodiscard]] bool is_about_motion(const Scene& now, const SceneEdit& edit);

// The edits, completed by what they need: parts that name a body or a material follow its new name; joints,
// springs and forces go with the body that is removed. Throws std::out_of_range if there is no part of an id.
[[nodiscard]] SceneEdits with_followers(const Scene& scene, const SceneEdits& edits);

// What a scene's parts with names were called before edits and are called after them; an empty new name: it
// is gone.
struct Renamed {
  std::string from;
  std::string to;
};
[[nodiscard]] std::vector<Renamed> renamed_bodies(const Scene& before, const Scene& after);

}  // namespace carom
