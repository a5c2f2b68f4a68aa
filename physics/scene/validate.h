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

// The index of each force of a scene in the array /forces of its file.
struct ForcePlaces {
  std::optional<int> linear_drag;
  std::optional<int> quadratic_drag;
  std::vector<int> springs;
  std::optional<int> attraction;
  std::vector<int> applied;
};

// The places in a file that Carom writes: first the drags, then springs, attraction, applied forces.
[[nodiscard]] ForcePlaces written_places(const Forces& forces);

// How a run of the scene begins.
struct RunBegin {
  double time = 0.0;  // s; joints must fit the positions of the drives at this time
  // The run continues from a saved state. Its joints are accepted as they are: a slack string may be too long
  // after a push, and any number of bodies may have stuck together.
  bool goes_on = false;
};

// Checks ranges, unique names, references, and whether the scene can be modelled. Throws SceneError with the
// JSON pointer of the first fault; without `places` the pointers are those of written_places().
void validate(const Scene& scene, const ForcePlaces& places, const RunBegin& begin = {});
void validate(const Scene& scene);
// Check the numbers of a method, and whether its integrator can run a valid scene. Throw SceneError.
void check_method(const std::string& place, const Method& method);
void check_integrator(const std::string& place, const Scene& scene, const Method& method);

}  // namespace carom
