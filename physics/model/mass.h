#pragma once

#include <Eigen/Core>
#include <vector>

#include "physics/scene/scene.h"

namespace carom {

// Inverse masses and inertias, zero for immovable bodies, whose masses are infinite.
struct MassProperties {
  Eigen::VectorXd inverse_mass;     // 1/kg
  Eigen::VectorXd inverse_inertia;  // 1/(kg m²), about the centre
  Eigen::VectorXd mass;             // kg
  Eigen::VectorXd inertia;          // kg m²
};

[[nodiscard]] MassProperties mass_properties(const std::vector<Body>& bodies);

}  // namespace carom
