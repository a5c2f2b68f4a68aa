#pragma once

#include <array>
#include <optional>
#include <vector>

#include "physics/scene/scene.h"

namespace carom {

// The bodies at the two ends of a new joint, none in the plane, and where the ends are, in m.
struct JointEnds {
  std::array<std::optional<Body>, 2> bodies;
  std::array<Vec2, 2> places;
};

// The bodies as they move once the joint holds them: the plastic impulse M⁻¹Aᵀλ takes out what the rows A of
// the joint don't allow, so that momentum stays where both can move. Only those whose motion changes; none of a
// string, which may part its ends. A motion that the plane or a driven body prescribes is taken over.
[[nodiscard]] std::vector<Body> as_joined(JointKind kind, const JointEnds& ends);

}  // namespace carom
