#pragma once

#include <optional>
#include <string>
#include <vector>

#include "physics/scene/limits.h"
#include "physics/scene/plain_text.h"
#include "physics/scene/scene.h"
#include "physics/scene/scene_error.h"

namespace carom {

// Where the forces of a scene stand in the array /forces of its file: one index for each.
struct ForcePlaces {
  std::optional<int> linear_drag;
  std::optional<int> quadratic_drag;
  std::vector<int> springs;
  std::optional<int> attraction;
  std::vector<int> applied;
};

// The places that forces have in a file that Carom writes: the drags, springs, attraction, applied forces.
[[nodiscard]] ForcePlaces written_places(const Forces& forces);

// Checks all that a reader cannot see one value at a time: ranges, unique names, references, what is modelled,
// and whether the integrator can run the scene. Throws SceneError with the JSON pointer of the first fault.
void validate(const Scene& scene, const ForcePlaces& places);
void validate(const Scene& scene);
// A method of a scene that is valid.
void validate_method(const std::string& place, const Scene& scene, const Method& method);

}  // namespace carom
