#pragma once

#include <memory>

#include "physics/model/model.h"
#include "physics/model/needs.h"
#include "physics/scene/scene.h"

namespace carom {

// A scene and its model. A step sees the model alone; who needs names, such as files and messages, takes the
// scene: index i of the model is body i of its list, and likewise for joints and springs.
struct CompiledScene {
  Scene scene;  // with all bodies listed, those of the generators too
  Needs needs;  // the parts that the model has
  Model model;
};

// The scene must be valid (validate.h). A run of it starts at `start_time` (s), which sets the drives'
// positions.
[[nodiscard]] std::shared_ptr<const CompiledScene> compile(Scene scene, const Needs& needs,
                                                           double start_time = 0.0);

}  // namespace carom
