#pragma once

namespace carom {

// How two surfaces behave in contact: a Material (physics/scene/material.h), which says more of each, without
// its name. All dimensionless.
struct SurfaceLaw {
  double restitution = 1.0;
  double tangential_restitution = 0.0;
  double static_friction = 0.0;
  double kinetic_friction = 0.0;
  double rolling_resistance = 0.0;
  bool sticks = false;

  friend bool operator==(const SurfaceLaw&, const SurfaceLaw&) = default;
};

}  // namespace carom
