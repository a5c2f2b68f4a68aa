#include "physics/scene/facts.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <map>
#include <vector>

#include "physics/scene/method.h"

namespace carom {
namespace {

// Two bodies can collide if one of them moves; whether they ever do is left open.
void look_at_materials(const Scene& scene, const std::vector<Body>& bodies, SceneFacts& facts) {
  struct Users {
    int all = 0;
    int moving = 0;
  };
  std::map<std::string, Users> users;
  for (const Body& b : bodies) {
    each_material(b, [&](const std::string& name) {
      Users& u = users[name];
      ++u.all;
      if (!has_infinite_mass(b)) ++u.moving;
    });
  }
  std::vector<std::string> names;
  for (const auto& [name, u] : users) names.push_back(name);
  const std::vector<Material> surfaces = combined_materials(scene, names);
  auto surface = surfaces.begin();
  for (const auto& [name_a, a] : users) {
    for (const auto& [name_b, b] : users) {
      const Material& m = *surface++;
      const bool can_collide = a.moving > 0 && (&a == &b ? a.all > 1 : b.all > 0);
      if (!can_collide) continue;
      facts.rub = facts.rub || m.static_friction > 0.0;
      facts.yield = facts.yield || m.restitution < 1.0;
      facts.sticks = facts.sticks || m.sticks;
    }
  }
  facts.sticky = has_sticking_surface(scene);
}

// Of a joint or a spring: an end on a body is not its centre.
template <class Link>
bool acts_beside_centre(const Link& link) {
  return !link.point.isZero(0.0) || (!link.to.empty() && !link.anchor.isZero(0.0));
}

void look_at_forces(const Scene& scene, SceneFacts& facts) {
  const Forces& f = scene.forces;
  each_common_force(f, [&facts](const CommonForce& force, const auto& value, const auto&...) {
    const int least = force.on == ActsOn::kEachPair ? 2 : 1;
    if (acts(value) && facts.moving >= least) facts.common_forces.insert(force.kind);
  });
  for (const Spring& s : f.springs) {
    facts.springs = true;
    facts.turning_springs = facts.turning_springs || acts_beside_centre(s);
    facts.one_sided = facts.one_sided || s.acts != SpringActs::kBoth;
  }
  facts.hand = f.hand.has_value();
  for (const AppliedForce& a : f.applied) {
    const bool push = !a.force.isZero(0.0);
    const bool torque = a.torque != 0.0;
    if (!push && !torque) continue;
    const bool off_centre = push && !a.point.isZero(0.0);
    facts.pushes = facts.pushes || push;
    facts.torques = facts.torques || torque || off_centre;
    facts.off_centre = facts.off_centre || off_centre;
    facts.timed = facts.timed || a.start > 0.0 || a.rise > 0.0 || a.end.has_value();
  }
}

void look_at_joints(const Scene& scene, SceneFacts& facts) {
  for (const Joint& l : scene.joints) {
    facts.joints = true;
    facts.strings = facts.strings || l.kind == JointKind::kString;
    facts.turning_joints = facts.turning_joints || l.kind == JointKind::kWeld || acts_beside_centre(l);
  }
}

}  // namespace

SceneFacts facts_of(const Scene& scene) {
  const std::vector<Body> bodies = all_bodies(scene);
  SceneFacts facts;
  for (const Body& b : bodies) {
    ++(has_infinite_mass(b) ? facts.infinite_mass : facts.moving);
    if (!has_infinite_mass(b)) {
      facts.spinning = facts.spinning || b.spin != 0.0;
      facts.cornered = facts.cornered || !std::holds_alternative<Disc>(b.shape);
    }
    if (!b.drive) continue;
    facts.drives = true;
    facts.accelerating =
        facts.accelerating || (!b.drive->amplitude.isZero(0.0) && b.drive->angular_frequency > 0.0);
  }
  look_at_materials(scene, bodies, facts);
  look_at_forces(scene, facts);
  look_at_joints(scene, facts);
  return facts;
}

std::string what_prevents(const Scene& scene, IntegratorId integrator) {
  if (integrator != IntegratorId::kExactFlight) return {};
  const SceneFacts f = facts_of(scene);
  std::vector<std::string> with(f.common_forces.begin(), f.common_forces.end());
  if (f.springs) with.emplace_back("springs");
  if (f.joints) with.emplace_back("links");
  if (f.sticky) with.emplace_back("surfaces that stick");
  if (f.hand) with.emplace_back("a hand that pulls");
  if (f.timed) with.emplace_back("forces that start, rise or end");
  if (f.off_centre) with.emplace_back("forces beside a centre");
  return fmt::format("{}", fmt::join(with, " and "));
}

std::optional<std::string> why_not(const Scene& scene, IntegratorId integrator) {
  const std::string with = what_prevents(scene, integrator);
  if (with.empty()) return std::nullopt;
  return fmt::format(
      "exact flight is not possible with {}; allowed: gravity and constant forces alone, or another integrator",
      with);
}

}  // namespace carom
