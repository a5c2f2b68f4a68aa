#pragma once

#include <QString>

#include "physics/record/frame.h"

namespace carom {

// What the tooltip of body `index` says, as rich text: name, mass, place, motion and the force of its contacts.
[[nodiscard]] QString body_text(const Frame& frame, int index);

// "disc, 1 kg"
[[nodiscard]] QString kind_text(const Body& body);
// What a screen reader says of body `index`: "light, disc, 1 kg, x −0.85 m, y −0.16 m, 2 m/s at 15°".
[[nodiscard]] QString spoken_text(const Frame& frame, int index);

}  // namespace carom
