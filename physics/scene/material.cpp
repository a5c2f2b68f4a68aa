#include "physics/scene/material.h"

#include <algorithm>
#include <cmath>

namespace carom {

Material mixed_surface(const Material& a, const Material& b) {
  Material m;
  m.name.clear();
  m.restitution = std::min(a.restitution, b.restitution);
  m.tangential_restitution = std::min(a.tangential_restitution, b.tangential_restitution);
  m.static_friction = std::sqrt(a.static_friction * b.static_friction);
  m.kinetic_friction = std::sqrt(a.kinetic_friction * b.kinetic_friction);
  m.rolling_resistance = std::sqrt(a.rolling_resistance * b.rolling_resistance);
  m.sticks = a.sticks || b.sticks;
  return m;
}

Material mixed(const Material& a, const Material& b) {
  Material m = mixed_surface(a, b);
  m.name = a.name + "/" + b.name;
  return m;
}

}  // namespace carom
