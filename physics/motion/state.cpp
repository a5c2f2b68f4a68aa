#include "physics/motion/state.h"

#include <limits>

#include "physics/motion/drive.h"

namespace carom {

Motion initial_motion(const Body& body, double time) {
  Motion m = Motion::Zero();
  q_of(m) << body.position, body.angle;
  v_of(m) << body.velocity, body.spin;
  if (body.drive) {
    q_of(m).head<2>() = drive_position(*body.drive, body.position, time);
    v_of(m).head<2>() = drive_velocity(*body.drive, time);
  }
  return m;
}

State initial_state(const std::vector<Body>& bodies) {
  State state;
  state.resize(static_cast<int>(bodies.size()));
  for (int i = 0; i < state.size(); ++i) state.set_motion(i, initial_motion(bodies[i]));
  return state;
}

MassProperties mass_properties(const std::vector<Body>& bodies) {
  const auto n = static_cast<Eigen::Index>(bodies.size());
  MassProperties m{Eigen::VectorXd::Zero(n), Eigen::VectorXd::Zero(n),
                   Eigen::VectorXd::Constant(n, std::numeric_limits<double>::infinity()),
                   Eigen::VectorXd::Constant(n, std::numeric_limits<double>::infinity())};
  for (Eigen::Index i = 0; i < n; ++i) {
    const Body& b = bodies[static_cast<std::size_t>(i)];
    if (is_immovable(b)) continue;
    m.mass[i] = mass_of(b);
    m.inertia[i] = inertia_of(b);
    m.inverse_mass[i] = 1.0 / m.mass[i];
    m.inverse_inertia[i] = m.inertia[i] > 0.0 ? 1.0 / m.inertia[i] : 0.0;
  }
  return m;
}

}  // namespace carom
