#include "physics/scene/needs.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <map>
#include <unordered_set>

namespace carom {
namespace {

// What decides the needs, gathered in one pass over the bodies.
struct Facts {
  int moving = 0;
  int immovable = 0;
  bool spinning = false;      // a moving body turns
  bool cornered = false;      // a moving body is no disc: impacts beside its centre turn it
  bool driven = false;        // an immovable body moves
  bool accelerating = false;  // ... and changes its velocity
  bool rub = false;           // two bodies that can meet have kinetic friction
  bool yield = false;         // two bodies that can meet have restitution below 1
  bool sticks = false;        // two bodies that can meet would stay joined
  bool sticky = false;        // a surface of the scene sticks, whether a body has it or not
  bool springs = false;
  bool coupling_springs = false;
  bool dampers = false;
  bool drag = false;
  bool attraction = false;
  bool links = false;
  bool strings = false;
  bool turning_links = false;  // links turn bodies
  bool pushes = false;         // applied forces
  bool torques = false;        // applied torques
  bool switched = false;       // forces that start, rise, end or act one way
  bool timed = false;          // applied forces that start, rise or end
};

// Bodies can meet if one of them moves. Which of them ever do, is left open.
void look_at_materials(const Scene& scene, const std::vector<Body>& bodies, Facts& facts) {
  struct Users {
    int all = 0;
    int moving = 0;
  };
  std::map<std::string, Users> users;
  for (const Body& b : bodies) {
    Users& u = users[b.material];
    ++u.all;
    if (!is_immovable(b)) ++u.moving;
  }
  std::vector<std::string> names;
  for (const auto& [name, u] : users) names.push_back(name);
  const std::vector<Material> surfaces = meetings(scene, names);
  auto surface = surfaces.begin();
  for (const auto& [name_a, a] : users) {
    for (const auto& [name_b, b] : users) {
      const Material& m = *surface++;
      const bool meet = a.moving > 0 && (&a == &b ? a.all > 1 : b.all > 0);
      if (!meet) continue;
      facts.rub = facts.rub || m.kinetic_friction > 0.0;
      facts.yield = facts.yield || m.restitution < 1.0;
      facts.sticks = facts.sticks || m.sticks;
    }
  }
  facts.sticky = has_sticking_surface(scene);
}

void look_at_forces(const Scene& scene, const std::vector<Body>& bodies, Facts& facts) {
  const Forces& f = scene.forces;
  facts.drag = facts.moving > 0 && (f.linear_drag > 0.0 || f.quadratic_drag > 0.0);
  facts.attraction = f.attraction.has_value() && facts.moving > 1;
  std::unordered_set<std::string> moving;
  if (!f.springs.empty()) {
    for (const Body& b : bodies) {
      if (!is_immovable(b)) moving.insert(b.name);
    }
  }
  for (const Spring& s : f.springs) {
    facts.springs = true;
    facts.dampers = facts.dampers || s.damping > 0.0;
    facts.switched = facts.switched || s.acts != SpringActs::kBoth;
    facts.coupling_springs = facts.coupling_springs || moving.contains(s.to);
  }
  for (const AppliedForce& a : f.applied) {
    const bool push = !a.force.isZero(0.0);
    const bool torque = a.torque != 0.0;
    if (!push && !torque) continue;
    facts.pushes = facts.pushes || push;
    facts.torques = facts.torques || torque;
    facts.timed = facts.timed || a.start > 0.0 || a.rise > 0.0 || a.end.has_value();
  }
  facts.switched = facts.switched || facts.timed;
}

void look_at_links(const Scene& scene, Facts& facts) {
  for (const Link& l : scene.links) {
    facts.links = true;
    facts.strings = facts.strings || l.kind == LinkKind::kString;
    facts.turning_links = facts.turning_links || l.kind == LinkKind::kWeld || !l.point.isZero(0.0) ||
                          (!l.to.empty() && !l.anchor.isZero(0.0));
  }
  facts.switched = facts.switched || facts.strings;
}

Facts facts_of(const Scene& scene) {
  const std::vector<Body> bodies = all_bodies(scene);
  Facts facts;
  for (const Body& b : bodies) {
    ++(is_immovable(b) ? facts.immovable : facts.moving);
    if (!is_immovable(b)) {
      facts.spinning = facts.spinning || b.spin != 0.0;
      facts.cornered = facts.cornered || !std::holds_alternative<Disc>(b.shape);
    }
    if (!b.drive) continue;
    // A drive with an amplitude and no frequency still shifts its body, by A sin φ.
    facts.driven = facts.driven || !b.drive->velocity.isZero(0.0) || !b.drive->amplitude.isZero(0.0);
    facts.accelerating =
        facts.accelerating || (!b.drive->amplitude.isZero(0.0) && b.drive->angular_frequency > 0.0);
  }
  look_at_materials(scene, bodies, facts);
  look_at_forces(scene, bodies, facts);
  look_at_links(scene, facts);
  return facts;
}

}  // namespace

Needs needs_of(const Scene& scene) {
  const Facts f = facts_of(scene);
  const bool meet = f.moving > 0 && f.moving + f.immovable > 1;
  Needs n;
  // Without friction nothing turns a disc but a torque, and impacts turn all other shapes. Tangential
  // restitution acts only within the bound that kinetic friction sets, so it needs friction as well.
  n.friction = f.rub;
  n.rotation = f.spinning || f.torques || f.rub || f.turning_links || f.sticks || (meet && f.cornered);
  const bool links = f.links || f.sticks;
  n.smooth_forces = f.drag || f.springs || links || f.attraction || f.pushes || f.torques;
  n.velocity_forces = f.drag || f.dampers;
  n.coupled_forces = f.coupling_springs || f.attraction;
  n.links = links;
  n.drives = f.driven || f.pushes || f.torques;
  n.switching = f.switched;
  // Uniform gravity gives two free bodies the same acceleration: it presses only against immovable ones. With
  // e = 1 and no relative acceleration every impact parts its pair for good; with e < 1 several bodies can
  // collapse onto one another.
  const bool relative_acceleration = f.drag || f.springs || links || f.attraction || f.pushes ||
                                     f.accelerating || (!scene.forces.gravity.isZero(0.0) && f.immovable > 0);
  n.lasting_contacts = meet && (relative_acceleration || f.yield);
  n.closed_form_flight = !f.drag && !f.springs && !f.links && !f.sticky && !f.attraction && !f.timed;
  return n;
}

NeedsText text_of(const Needs& needs, const Scene& scene) {
  const Facts f = facts_of(scene);
  NeedsText text;
  const auto modelled = [&](const char* noun, bool is) {
    if (is) text.modelled.emplace_back(noun);
  };
  // Parts that every scene is asked about.
  const auto either = [&](const char* noun, bool is) {
    (is ? text.modelled : text.not_needed).emplace_back(noun);
  };
  modelled("normal impulses", f.moving > 0 && f.moving + f.immovable > 1);
  modelled("gravity", f.moving > 0 && !scene.forces.gravity.isZero(0.0));
  modelled("springs", f.springs);
  modelled("dampers", f.dampers);
  modelled("links", f.links);
  modelled("sticking", f.sticks);
  modelled("attraction", f.attraction);
  modelled("applied forces", f.pushes || f.torques);
  either("rotation", needs.rotation);
  either("friction", needs.friction);
  either("drag", needs.velocity_forces && (f.drag || !f.dampers));
  either("coupled forces", needs.coupled_forces);
  either("driven bodies", needs.drives && (f.driven || !(f.pushes || f.torques)));
  either("switched forces", needs.switching);
  const bool as_impacts = needs.lasting_contacts && scene.method.contacts == ContactsId::kImpulse;
  either(as_impacts ? "lasting contacts (as repeated impacts)" : "lasting contacts", needs.lasting_contacts);
  return text;
}

std::optional<std::string> why_not(const Scene& scene, IntegratorId integrator) {
  if (integrator != IntegratorId::kExactFlight) return std::nullopt;
  const Facts f = facts_of(scene);
  std::vector<std::string> with;
  if (f.drag) with.emplace_back("drag");
  if (f.springs) with.emplace_back("springs");
  if (f.links) with.emplace_back("links");
  if (f.sticky) with.emplace_back("surfaces that stick");
  if (f.attraction) with.emplace_back("attraction");
  if (f.timed) with.emplace_back("forces that start, rise or end");
  if (with.empty()) return std::nullopt;
  return fmt::format(
      "exact flight is not possible with {}; allowed: gravity and constant forces alone, or another integrator",
      fmt::join(with, " and "));
}

}  // namespace carom
