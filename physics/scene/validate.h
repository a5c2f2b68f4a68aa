#pragma once

#include <optional>
#include <string>
#include <vector>

#include "physics/scene/limits.h"
#include "physics/scene/method.h"
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

// When a run of the scene begins.
struct RunBegin {
  double time = 0.0;  // s: where drives are then, joints must fit
  // It goes on from a state that it was saved with: what a run has made of its joints is right, even a slack
  // string that a push left too long, and as many as stuck together.
  bool goes_on = false;
};

// Checks all that a reader cannot see one value at a time: ranges, unique names, references, and what is
// modelled. Throws SceneError with the JSON pointer of the first fault.
void validate(const Scene& scene, const ForcePlaces& places, const RunBegin& begin = {});
void validate(const Scene& scene);
// The numbers of a method, and whether its integrator can run the scene, which is valid. Throw SceneError.
void check_method(const std::string& place, const Method& method);
void check_integrator(const std::string& place, const Scene& scene, const Method& method);

}  // namespace carom
