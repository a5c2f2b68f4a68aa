#include "physics/dynamics/state.h"

#include "physics/scene/drive.h"

namespace carom {

Motion initial_motion(const Body& body, double time) {
  const Body now = moved_by_drive(body, time);
  Motion m = Motion::Zero();
  q_of(m) << now.position, now.angle;
  v_of(m) << now.velocity, now.spin;
  return m;
}

Motion motion_at_start(const BodyStarts& starts, BodyIndex body) {
  Motion m = Motion::Zero();
  q_of(m) = starts.q.col(body);
  v_of(m) = starts.v.col(body);
  return m;
}

State initial_state(const std::vector<Body>& bodies) {
  State state;
  state.resize(static_cast<int>(bodies.size()));
  for (BodyIndex i{0}; i < state.size(); ++i) state.set_motion(i, initial_motion(bodies[i]));
  return state;
}

}  // namespace carom
