#include "physics/scene/facts.h"

#include <bit>
#include <concepts>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <map>
#include <string_view>
#include <type_traits>
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
      facts.rub = facts.rub || m.kinetic_friction > 0.0;
      facts.yield = facts.yield || m.restitution < 1.0;
      facts.sticks = facts.sticks || m.sticks;
    }
  }
  facts.sticky = has_sticking_surface(scene);
}

void look_at_forces(const Scene& scene, SceneFacts& facts) {
  const Forces& f = scene.forces;
  facts.drag = facts.moving > 0 && (f.linear_drag > 0.0 || f.quadratic_drag > 0.0);
  facts.attraction = f.attraction.has_value() && facts.moving > 1;
  for (const Spring& s : f.springs) {
    facts.springs = true;
    facts.one_sided = facts.one_sided || s.acts != SpringActs::kBoth;
  }
  for (const AppliedForce& a : f.applied) {
    const bool push = !a.force.isZero(0.0);
    const bool torque = a.torque != 0.0;
    if (!push && !torque) continue;
    facts.pushes = facts.pushes || push;
    facts.torques = facts.torques || torque;
    facts.timed = facts.timed || a.start > 0.0 || a.rise > 0.0 || a.end.has_value();
  }
}

void look_at_joints(const Scene& scene, SceneFacts& facts) {
  for (const Joint& l : scene.joints) {
    facts.joints = true;
    facts.strings = facts.strings || l.kind == JointKind::kString;
    facts.turning_joints = facts.turning_joints || l.kind == JointKind::kWeld || !l.point.isZero(0.0) ||
                           (!l.to.empty() && !l.anchor.isZero(0.0));
  }
}

// Takes in values one after the other. Each type's members are named in a structured binding, so that one that
// is new and forgotten here doesn't compile.
class Fingerprint {
 public:
  [[nodiscard]] std::uint64_t value() const { return hash_ != 0 ? hash_ : 1; }

  void add(double value) { add_bits(std::bit_cast<std::uint64_t>(value + 0.0)); }  // -0 is 0 in a file
  template <class Whole>
  requires std::integral<Whole> || std::is_enum_v<Whole>
  void add(Whole value) { add_bits(static_cast<std::uint64_t>(value)); }
  void add(std::string_view text) {
    add_bits(text.size());
    for (const char c : text) add_byte(static_cast<unsigned char>(c));
  }
  void add(const std::string& text) { add(std::string_view{text}); }
  void add(const Vec2& v) {
    add(v.x());
    add(v.y());
  }
  template <class T>
  void add(const std::optional<T>& value) {
    add(value.has_value());
    if (value) add(*value);
  }
  template <class T>
  void add(const std::vector<T>& values) {
    add_bits(values.size());
    for (const T& value : values) add(value);
  }
  void add(const Material& material) {
    const auto& [name, restitution, tangential_restitution, static_friction, kinetic_friction,
                 rolling_resistance, sticks, id] = material;
    add_all(name, restitution, tangential_restitution, static_friction, kinetic_friction, rolling_resistance,
            sticks);
  }
  void add(const MaterialPair& pair) {
    const auto& [a, b, surface, id] = pair;
    add_all(a, b, surface);
  }
  void add(const Drive& drive) {
    const auto& [velocity, amplitude, angular_frequency, phase] = drive;
    add_all(velocity, amplitude, angular_frequency, phase);
  }
  void add(const Disc& disc) {
    const auto& [radius] = disc;
    add(radius);
  }
  void add(const Box& box) {
    const auto& [width, height] = box;
    add_all(width, height);
  }
  void add(const Polygon& polygon) {
    const auto& [vertices, rounding] = polygon;
    add_all(vertices, rounding);
  }
  void add(const Wall& wall) {
    const auto& [length] = wall;
    add(length);
  }
  void add(const PlacedShape& placed) {
    const auto& [shape, position, angle, material] = placed;
    add(shape.index());
    std::visit([this](const auto& form) { add(form); }, shape);
    add_all(position, angle, material);
  }
  void add(const Compound& compound) {
    const auto& [shapes] = compound;
    add(shapes);
  }
  void add(const Body& body) {
    const auto& [name, shape, position, angle, velocity, spin, mass, density, inertia, fixed, drive, material,
                 group, id] = body;
    add(shape.index());
    std::visit([this](const auto& form) { add(form); }, shape);
    add_all(name, position, angle, velocity, spin, mass, density, inertia, fixed, drive, material, group);
  }
  void add(const Spring& spring) {
    const auto& [name, body, to, anchor, stiffness, damping, rest_length, acts, id] = spring;
    add_all(name, body, to, anchor, stiffness, damping, rest_length, acts);
  }
  void add(const Joint& joint) {
    const auto& [name, kind, body, point, to, anchor, length, angle, id] = joint;
    add_all(name, kind, body, point, to, anchor, length, angle);
  }
  void add(const Attraction& attraction) {
    const auto& [constant, softening] = attraction;
    add_all(constant, softening);
  }
  void add(const AppliedForce& force) {
    const auto& [body, newtons, torque, start, rise, end, id] = force;
    add_all(body, newtons, torque, start, rise, end);
  }
  void add(const Forces& forces) {
    const CommonForces& common = forces;
    const auto& [gravity, linear_drag, quadratic_drag, attraction] = common;
    add_all(gravity, linear_drag, quadratic_drag, forces.springs, attraction, forces.applied);
  }
  template <class... Values>
  void add_all(const Values&... values) {
    (add(values), ...);
  }

 private:
  void add_byte(unsigned char byte) { hash_ = (hash_ ^ byte) * 0x100000001b3ULL; }
  void add_bits(std::uint64_t bits) {
    for (int k = 0; k < 8; ++k) add_byte(static_cast<unsigned char>(bits >> (8 * k)));
  }

  std::uint64_t hash_ = 0xcbf29ce484222325ULL;
};

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

std::optional<std::string> why_not(const Scene& scene, IntegratorId integrator) {
  if (integrator != IntegratorId::kExactFlight) return std::nullopt;
  const SceneFacts f = facts_of(scene);
  std::vector<std::string> with;
  if (f.drag) with.emplace_back("drag");
  if (f.springs) with.emplace_back("springs");
  if (f.joints) with.emplace_back("links");
  if (f.sticky) with.emplace_back("surfaces that stick");
  if (f.attraction) with.emplace_back("attraction");
  if (f.timed) with.emplace_back("forces that start, rise or end");
  if (with.empty()) return std::nullopt;
  return fmt::format(
      "exact flight is not possible with {}; allowed: gravity and constant forces alone, or another integrator",
      fmt::join(with, " and "));
}

std::uint64_t fingerprint(const Scene& scene, double start_time) {
  const auto& [forces, materials, pairs, impact_law, several_impacts, bodies, generators, joints, ids_given] =
      scene;
  Fingerprint f;
  f.add_all(start_time, forces, materials, pairs, impact_law, several_impacts, all_bodies(scene), joints);
  return f.value();
}

}  // namespace carom
