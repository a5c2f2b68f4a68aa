#pragma once

#include <QString>
#include <span>
#include <vector>

#include "physics/scene/scene.h"

namespace carom {

// How several bodies are put in line: by a side or the middle of their bounds, or with equal gaps to the right
// or upwards.
enum class Alignment { kLeft, kCentre, kRight, kTop, kMiddle, kBottom, kAcross, kUpwards };

// The bodies so; the bounds of all of them say where, and the outer ones of equal gaps stay. Half-planes stay
// and do not count.
[[nodiscard]] std::vector<Body> aligned(std::span<const Body> bodies, Alignment alignment);
// "Align 3 bodies at the left", "Distribute 3 bodies across"
[[nodiscard]] QString name_of(Alignment alignment, std::span<const Body> bodies);

}  // namespace carom
