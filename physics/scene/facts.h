#pragma once

#include <optional>
#include <set>
#include <string>
#include <string_view>

#include "physics/scene/method.h"
#include "physics/scene/scene.h"

namespace carom {

// The properties of a scene that decide how its motion can be computed, gathered in one pass over the bodies.
struct SceneFacts {
  int moving = 0;
  int infinite_mass = 0;
  bool spinning = false;      // a moving body has a spin at the start
  bool cornered = false;      // a moving body is not a disc, so impacts off its centre turn it
  bool drives = false;        // a body is kinematic, even if it stands still
  bool accelerating = false;  // a kinematic body changes its velocity
  bool rub = false;           // two bodies that can collide have kinetic friction
  bool yield = false;         // two bodies that can collide have restitution below 1
  bool sticks = false;        // two bodies that can collide would stay joined
  bool sticky = false;        // some surface sticks, whether or not a body has it
  bool springs = false;
  bool turning_springs = false;              // a spring pulls beside a centre
  bool one_sided = false;                    // a spring pushes or pulls only
  std::set<std::string_view> common_forces;  // the kinds of those that a scene has once and that act
  bool joints = false;
  bool strings = false;
  bool turning_joints = false;  // joints can turn bodies
  bool pushes = false;          // applied forces
  bool torques = false;         // applied torques, or forces beside a centre
  bool off_centre = false;      // applied forces beside a centre
  bool timed = false;           // applied forces that start, rise or end
  bool hand = false;            // a hand pulls
};

[[nodiscard]] SceneFacts facts_of(const Scene& scene);

// What of the scene this integrator cannot run, as "springs and drag"; empty if it can run it all.
[[nodiscard]] std::string what_prevents(const Scene& scene, IntegratorId integrator);

// Why this integrator cannot run the scene, with "allowed: ..."; nothing if it can. Exact flight needs a
// flight in closed form.
[[nodiscard]] std::optional<std::string> why_not(const Scene& scene, IntegratorId integrator);

}  // namespace carom
