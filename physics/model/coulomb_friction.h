#pragma once

#include <algorithm>

namespace carom {

// Coulomb's law: friction takes what would stop the slip, and at most μ times the normal impulse (N s) or force
// (N). Rolling resistance is the same law for the moment and the turning at a contact, with a length in m in
// the place of μ. Where both contact directions change each other's velocity, as in eccentric impacts, the law
// holds along the path of the impulse: impact/routh_path.cpp.
[[nodiscard]] inline double limited_by_friction(double wanted, double coefficient, double normal) {
  const double most = coefficient * normal;
  return std::min(std::max(wanted, -most), most);
}

}  // namespace carom
