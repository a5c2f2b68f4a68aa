#include "physics/model/mass.h"

#include <limits>

namespace carom {

MassProperties mass_properties(const std::vector<Body>& bodies) {
  const auto n = static_cast<Eigen::Index>(bodies.size());
  MassProperties m{Eigen::VectorXd::Zero(n), Eigen::VectorXd::Zero(n),
                   Eigen::VectorXd::Constant(n, std::numeric_limits<double>::infinity()),
                   Eigen::VectorXd::Constant(n, std::numeric_limits<double>::infinity())};
  for (Eigen::Index i = 0; i < n; ++i) {
    const Body& b = bodies[static_cast<std::size_t>(i)];
    if (has_infinite_mass(b)) continue;
    m.mass[i] = mass_of(b);
    m.inertia[i] = inertia_of(b);
    m.inverse_mass[i] = 1.0 / m.mass[i];
    m.inverse_inertia[i] = m.inertia[i] > 0.0 ? 1.0 / m.inertia[i] : 0.0;
  }
  return m;
}

}  // namespace carom
