#pragma once

#include <Eigen/Core>
#include <vector>

#include "physics/scene/scene.h"

namespace carom {

// Masses and inertias. Fixed and kinematic bodies have infinite ones, with inverses of 0. A point-like body
// has inertia 0 and inverse inertia 0.
struct MassProperties {
  Eigen::VectorXd inverse_mass;     // 1/kg
  Eigen::VectorXd inverse_inertia;  // 1/(kg m²), about the centre
  Eigen::VectorXd mass;             // kg
  Eigen::VectorXd inertia;          // kg m²
};

// Of the bodies of a valid scene.
[[nodiscard]] MassProperties mass_properties(const std::vector<Body>& bodies);

}  // namespace carom
