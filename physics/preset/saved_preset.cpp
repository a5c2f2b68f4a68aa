#include "physics/preset/saved_preset.h"

#include <string>
#include <string_view>
#include <unordered_map>

#include "physics/preset/preset.h"
#include "physics/preset/validate_preset.h"
#include "physics/scene/fingerprint.h"
#include "physics/world/run_state.h"

namespace carom {

Preset saved_preset(const Preset& document, const Simulation& simulation) {
  if (const auto& lost = simulation.lost()) {
    throw SceneError("the run cannot be saved as it stands: it is " +
                     lost->text(simulation.bodies(), simulation.time()));
  }
  Preset out = document;
  out.scene.generators.clear();
  out.expect.clear();
  out.method = simulation.method();
  out.scene.bodies = simulation.bodies();
  const State& state = simulation.state();
  // Values that a file may leave to the start must be explicit now.
  out.scene.joints = simulation.joints();
  std::unordered_map<std::string_view, double> angles;  // by body
  for (const Body& b : out.scene.bodies) angles.emplace(b.name, b.angle);
  for (std::size_t i = 0; i < out.scene.joints.size(); ++i) {
    Joint& joint = out.scene.joints[i];
    if (joint.kind == JointKind::kRod || joint.kind == JointKind::kString) {
      joint.length = simulation.length(static_cast<int>(i));
    } else if (joint.kind == JointKind::kWeld && !joint.angle) {
      joint.angle = angles.at(joint.body) - (joint.to.empty() ? 0.0 : angles.at(joint.to));
    }
  }
  for (int i = 0; i < state.size(); ++i) {
    Body& b = out.scene.bodies[static_cast<std::size_t>(i)];
    if (has_infinite_mass(b)) continue;
    b.position = state.position(i);
    b.angle = state.q(2, i);
    b.velocity = state.velocity(i);
    b.spin = state.v(2, i);
  }
  out.saved = SavedRun{.time = simulation.time()};
  out.saved->state = std::make_shared<RunState>(simulation.run_state());
  out.saved->fingerprint = fingerprint(out.scene, simulation.time());
  try {
    validate(out);
    check_state(out.scene, simulation.time(), *out.saved->state);
  } catch (const SceneError& error) {
    throw SceneError(std::string("the run cannot be saved as it stands: ") + error.what());
  }
  return out;
}

}  // namespace carom
