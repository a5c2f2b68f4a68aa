#pragma once

#include <QString>
#include <string>

#include "physics/scene/scene.h"

namespace carom {

// A refusal of a scene, as validate() words it, for someone who has no file: "Rod 1, length" instead of
// "/links/0/length", and numbers with six digits at most. The scene is the refused one.
[[nodiscard]] QString refusal_text(const std::string& refusal, const Scene& scene);

}  // namespace carom
