#include "physics/run/scene_now.h"

#include <string_view>
#include <unordered_map>

#include "physics/run/simulation.h"

namespace carom {

Scene scene_now(const Simulation& run) {
  Scene scene = run.compiled()->scene;
  scene.joints = run.joints();
  if (scene.forces.hand) scene.forces.hand->place = run.field().hand_place();
  std::unordered_map<std::string_view, double> angles;  // by body, at the start
  for (const Body& b : run.bodies()) angles.emplace(b.name, b.angle);
  for (std::size_t i = 0; i < scene.joints.size(); ++i) {
    Joint& joint = scene.joints[i];
    if (joint.kind == JointKind::kRod || joint.kind == JointKind::kString) {
      joint.length = run.length(JointIndex{static_cast<int>(i)});
    } else if (joint.kind == JointKind::kWeld && !joint.angle) {
      joint.angle = angles.at(joint.body) - (joint.to.empty() ? 0.0 : angles.at(joint.to));
    }
  }
  const State& state = run.state();
  for (BodyIndex i{0}; i < state.size(); ++i) {
    Body& b = scene.bodies[static_cast<std::size_t>(i)];
    if (b.id.number == 0) b.id.number = kFirstGenerated + static_cast<std::uint32_t>(i);
    if (has_infinite_mass(b)) continue;
    b.position = state.position(i);
    b.angle = state.q.col(i)[2];
    b.velocity = state.velocity(i);
    b.spin = state.v.col(i)[2];
  }
  return scene;
}

}  // namespace carom
