#include "physics/record/frame.h"

#include <string_view>
#include <unordered_map>

#include "physics/math/vectors.h"

namespace carom {
namespace {

std::vector<JointState> joint_states(const Simulation& simulation) {
  const std::vector<Joint>& joints = simulation.joints();
  std::vector<JointState> states;
  if (joints.empty()) return states;
  std::unordered_map<std::string_view, int> index;
  for (const Body& body : simulation.bodies()) index.emplace(body.name, static_cast<int>(index.size()));
  const auto now = [&](int i) { return Eigen::Vector3d(simulation.state().q.col(i)); };
  const auto at_start = [&](int i) {
    return Eigen::Vector3d(q_of(initial_motion(simulation.bodies()[static_cast<std::size_t>(i)])));
  };
  const auto end = [](const Eigen::Vector3d& q, const Vec2& own) {
    return Vec2(q.head<2>() + turned_by(q[2], own));
  };
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const Joint& joint = joints[i];
    const int body = index.at(joint.body);
    const int other = joint.to.empty() ? -1 : index.at(joint.to);
    JointState& s = states.emplace_back();
    s.kind = joint.kind;
    s.from = other < 0 ? joint.anchor : end(now(other), joint.anchor);
    s.to = end(now(body), joint.point);
    s.in_plane = other < 0;
    const Vec2 start = other < 0 ? joint.anchor : end(at_start(other), joint.anchor);
    s.length = joint.length.value_or((end(at_start(body), joint.point) - start).norm());
    s.taut = joint.kind != JointKind::kString || simulation.is_taut(static_cast<int>(i));
  }
  return states;
}

}  // namespace

void take_moment(const Simulation& simulation, Frame& frame) {
  frame.time = simulation.time();
  frame.method = simulation.method();
  frame.steps = simulation.steps();
  frame.impact_count = simulation.impact_count();
  frame.evaluations = simulation.evaluations();
  frame.rejected_steps = simulation.rejected_steps();
  frame.state = simulation.state();
  frame.joints = joint_states(simulation);
  frame.contacts = simulation.contact_forces();
  frame.totals = simulation.totals();
  frame.ledger = simulation.ledger();
  frame.status = simulation.status();
  if (const auto& lost = simulation.lost()) {
    frame.lost = lost->text(simulation.bodies(), simulation.time());
  } else {
    frame.lost.reset();
  }
}

}  // namespace carom
