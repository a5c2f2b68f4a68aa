#pragma once

#include <QString>

#include "physics/record/frame.h"

namespace carom {

// What the tooltip of body `index` says, as rich text: name, mass, place, motion and the force of its contacts.
[[nodiscard]] QString body_text(const Frame& frame, int index);

}  // namespace carom
