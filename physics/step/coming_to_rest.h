#pragma once

#include <algorithm>

#include "physics/model/surface_law.h"

// When a pair whose bounces lose energy comes to rest on each other, instead of bouncing faster and faster.
namespace carom {

// m/s: the speed by which an impact is told from a contact that closes gently. Bodies that stick don't rebound,
// but meet by an impact whenever they close faster than they could rest.
[[nodiscard]] inline double impact_speed(const SurfaceLaw& law, double closing) {
  return law.sticks ? closing : law.restitution * closing;
}

// m/s; a pressed contact that rebounds slower than this is at rest: it would hop by v²/2g = 5e-14 m.
inline constexpr double kRestSpeed = 1e-6;

// Of |a| h, where a is the acceleration that presses the pair: slower rebounds under explicit Euler are at
// rest. They tend to e |a| h/(1 - e) and would never die out. At most 5, so that nearly elastic bodies still
// bounce (and show that drift).
[[nodiscard]] inline double last_rebound_of_euler(double restitution) {
  return std::min(1.5 * restitution / (1.0 - restitution), 5.0);
}

}  // namespace carom
