#include "physics/motion/state.h"

#include <limits>

namespace carom {

State initial_state(const std::vector<Body>& bodies) {
  const auto n = static_cast<Eigen::Index>(bodies.size());
  State s;
  s.q.resize(3, n);
  s.v.resize(3, n);
  s.dissipated = Eigen::VectorXd::Zero(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const Body& b = bodies[static_cast<std::size_t>(i)];
    s.q.col(i) << b.position, b.angle;
    s.v.col(i) << b.velocity, b.spin;
  }
  return s;
}

MassProperties mass_properties(const std::vector<Body>& bodies) {
  const auto n = static_cast<Eigen::Index>(bodies.size());
  MassProperties m{Eigen::VectorXd::Zero(n), Eigen::VectorXd::Zero(n),
                   Eigen::VectorXd::Constant(n, std::numeric_limits<double>::infinity()),
                   Eigen::VectorXd::Constant(n, std::numeric_limits<double>::infinity())};
  for (Eigen::Index i = 0; i < n; ++i) {
    const Body& b = bodies[static_cast<std::size_t>(i)];
    if (b.fixed) continue;
    m.mass[i] = mass_of(b);
    m.inertia[i] = m.mass[i] * inertia_per_mass(b.shape);
    m.inverse_mass[i] = 1.0 / m.mass[i];
    m.inverse_inertia[i] = 1.0 / m.inertia[i];
  }
  return m;
}

}  // namespace carom
