#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "physics/scene/id.h"
#include "physics/scene/shape.h"

// The physics of an experiment as plain values in SI units, as a preset file states them. x points right, y
// up; angles are counter-clockwise, in radians.
namespace carom {

// How a surface behaves in contact. Two materials combine to the smaller restitution of the two and the
// geometric mean of each friction coefficient and of rolling resistance (see `mixed`).
struct Material {
  std::string name = "default";
  double restitution = 1.0;             // dimensionless, 0..1: normal rebound speed over closing speed
  double tangential_restitution = 0.0;  // dimensionless, -1..1: 0 stops the slip, 1 reverses it (superball)
  double static_friction = 0.0;         // dimensionless, >= kinetic_friction
  double kinetic_friction = 0.0;        // dimensionless, >= 0
  // Dimensionless, >= 0. A moment of up to this times R N resists the rolling of a disc of radius R under the
  // normal force N. Resting contacts only.
  double rolling_resistance = 0.0;
  // The two bodies stay joined from their first impact on; no other property of the surface matters then. Two
  // materials stick if one of them does.
  bool sticks = false;
  Id<Material> id{};

  bool operator==(const Material&) const = default;
};

// The default rule, for two materials that the scene does not list as a pair.
[[nodiscard]] Material mixed(const Material& a, const Material& b);

// Two materials with a surface law of their own, in place of `mixed`.
struct MaterialPair {
  std::string a;
  std::string b;     // may be the same
  Material surface;  // its name is not used
  Id<MaterialPair> id{};
};

// A prescribed motion: position(t) = position + velocity t + amplitude sin(ω t + φ), with its exact velocity.
// A piston has a velocity, a vibrating table an amplitude.
struct Drive {
  Vec2 velocity = Vec2::Zero();    // m/s
  Vec2 amplitude = Vec2::Zero();   // m
  double angular_frequency = 0.0;  // ω in rad/s, >= 0
  double phase = 0.0;              // φ in rad

  bool operator==(const Drive&) const = default;
};

struct Body {
  std::string name;
  Shape shape = Disc{};
  Vec2 position = Vec2::Zero();   // m, of the centre of mass
  double angle = 0.0;             // rad
  Vec2 velocity = Vec2::Zero();   // m/s
  double spin = 0.0;              // rad/s
  std::optional<double> mass;     // kg; either this or density
  std::optional<double> density;  // kg/m² (a plane has no volume)
  std::optional<double> inertia;  // kg m² about the centre of mass, > 0; none: that of a homogeneous body
  bool fixed = false;             // never moves: infinite mass and inertia
  std::optional<Drive> drive;     // prescribed motion: infinite mass and inertia
  std::string material = "default";
  std::string group;  // bodies of one group do not collide with each other; empty: no group
  Id<Body> id{};      // those of a generator have none
};

// Calls visit(name) for the material of the body and those of its shapes.
void each_material(auto& body, const auto& visit) {
  visit(body.material);
  auto* compound = std::get_if<Compound>(&body.shape);
  if (compound == nullptr) return;
  for (auto& placed : compound->shapes) {
    if (!placed.material.empty()) visit(placed.material);
  }
}

// The shapes of a compound `body` as bodies of their own, each where and how it moves, with its surface; of the
// same density, without a mass of their own. They have no name.
[[nodiscard]] std::vector<Body> bodies_of(const Compound& compound, const Body& body);

// True if no force or impact changes its motion: fixed or kinematic.
[[nodiscard]] inline bool has_infinite_mass(const Body& body) { return body.fixed || body.drive.has_value(); }

// kg; infinite for a fixed or kinematic body. A body with neither mass nor density has 1 kg/m².
[[nodiscard]] double mass_of(const Body& body);
// kg m² about the centre of mass; infinite for a fixed or kinematic body, 0 for a point-like one, which
// nothing turns.
[[nodiscard]] double inertia_of(const Body& body);
// m: how far the outline reaches from the centre of mass, so that an error of the angle moves no point of it
// farther than this times the error in rad. 0 for a point-like body.
[[nodiscard]] double turning_radius(const Body& body);

// Which way a spring acts along its line, with the stretch s = length - rest_length.
enum class SpringActs {
  kBoth,       // F = -k s - c s' at any length
  kPush,       // a bumper: only while s < 0 and it pushes; it never pulls
  kPull,       // a rubber band: only while s > 0 and it pulls; it never pushes
  kWhileShort  // while s < 0, also where its damper pulls
};

// A linear spring with a damper, from a body's centre to another body's centre or to a point of the plane. It
// exerts -k s - c s' on the body, along the line from the other end to it, and the opposite on the other
// body.
struct Spring {
  std::string name;            // may be empty
  std::string body;            // a body that moves
  std::string to;              // the body at the other end; empty: the point `anchor`
  Vec2 anchor = Vec2::Zero();  // m
  double stiffness = 1.0;      // N/m, > 0
  double damping = 0.0;        // N s/m, >= 0
  double rest_length = 0.0;    // m, >= 0
  SpringActs acts = SpringActs::kBoth;
  Id<Spring> id{};
};

// What a joint constrains between its two points.
enum class JointKind {
  kRod,     // their distance
  kString,  // their distance to at most its length; slack or pulling, with a taut impulse when it tightens
  kPin,     // both at one place; the bodies turn about it and do not collide with one another
  kWeld     // both at one place, and the angle between the bodies; they move as one and do not collide
};

// A massless joint between a point of a body and a point of another body or of the plane. Its forces do no
// work, except through a kinematic body. A string's taut impulse removes the speed that would lengthen it.
struct Joint {
  std::string name;  // may be empty
  JointKind kind = JointKind::kRod;
  std::string body;              // a body that moves
  Vec2 point = Vec2::Zero();     // m, from its centre, along its own axes
  std::string to;                // the body at the other end; empty: the plane
  Vec2 anchor = Vec2::Zero();    // m, from that body's centre along its own axes, or a point of the plane
  std::optional<double> length;  // m, > 0, of a rod or a string; none: the distance at the start
  // rad, weld only: the body's angle minus that of the other body (0 for the plane); none: as at the start. A
  // point-like body has no angle.
  std::optional<double> angle;
  Id<Joint> id{};  // a weld that a run makes has none
};

// Attraction between every two moving bodies: F = G m_a m_b d / (d² + ε²)^(3/2) along the line of their
// centres (Plummer).
struct Attraction {
  double constant = 1.0;   // G in N m²/kg², > 0
  double softening = 0.0;  // ε in m, >= 0
};

// A force at a body's centre and a torque. Both rise linearly from `start` over the time `rise` and end at
// `end`.
struct AppliedForce {
  std::string body;
  Vec2 force = Vec2::Zero();  // N
  double torque = 0.0;        // N m
  double start = 0.0;         // s, >= 0
  double rise = 0.0;          // s, >= 0; 0: all at once
  std::optional<double> end;  // s, >= start; none: never
  Id<AppliedForce> id{};
};

// A hand that pulls a body of a run: a spring with a damper from a point of the body to the hand. It is no part
// of an experiment: no file holds it.
struct Hand {
  std::string body;           // one that moves
  Vec2 grip = Vec2::Zero();   // m, in the body's own axes, from its centre of mass
  Vec2 place = Vec2::Zero();  // m, where the hand is
  double stiffness = 0.0;     // N/m, > 0
  double damping = 0.0;       // N s/m, >= 0, times the velocity of the grip

  bool operator==(const Hand&) const = default;
};

// The forces that a scene has once, on all bodies that move.
struct CommonForces {
  Vec2 gravity = Vec2::Zero();  // m/s²
  double linear_drag = 0.0;     // kg/s: F = -b v
  double quadratic_drag = 0.0;  // kg/m: F = -c |v| v
  std::optional<Attraction> attraction{};
};

struct Forces : CommonForces {
  std::vector<Spring> springs;
  std::vector<AppliedForce> applied;
  std::optional<Hand> hand{};
};

// How an impact ends whose normal misses a centre, so that the normal impulse turns the bodies and changes
// the slip. Without friction, and for discs, both laws agree.
enum class ImpactLawId {
  kEnergetic,  // Routh's path with Stronge's energetic restitution; never gains energy
  kNewton,     // u_n' = -e u_n whatever friction does; may gain energy, which is reported
};

// How impacts of bodies that touch several others are resolved.
enum class SeveralImpactsId {
  kPairwise,     // pair by pair, and at once only those that close at one moment: Newton's cradle
  kSimultaneous  // all touching pairs at once, with one restitution (Moreau)
};

// A grid of columns × rows discs, row by row from the lower left. Each is displaced by up to `jitter` in x
// and y; its radius and velocity are drawn uniformly, by a 64-bit Mersenne twister with `seed`.
struct GridGenerator {
  std::string name = "disc";      // bodies are called name-1, name-2, ...
  int columns = 1;                // >= 1
  int rows = 1;                   // >= 1
  Vec2 origin = Vec2::Zero();     // m, the first disc's centre
  Vec2 spacing = Vec2(1.0, 1.0);  // m
  double jitter = 0.0;            // m, >= 0
  double radius_min = 0.1;        // m, > 0
  double radius_max = 0.1;        // m, >= radius_min
  double speed_max = 0.0;         // m/s, each velocity component is drawn from [-speed_max, speed_max]
  double density = 1.0;           // kg/m²
  std::string material = "default";
  std::uint64_t seed = 1;
  Id<GridGenerator> id{};
};

// The physics of an experiment, as people write it.
struct Scene {
  Forces forces;
  std::vector<Material> materials;
  std::vector<MaterialPair> pairs;
  ImpactLawId impact_law = ImpactLawId::kEnergetic;
  SeveralImpactsId several_impacts = SeveralImpactsId::kPairwise;
  std::vector<Body> bodies;
  std::vector<GridGenerator> generators;
  std::vector<Joint> joints;
  std::uint32_t ids_given = 0;  // so far: the largest number
};

// The material called `name`; "default" exists in every scene. Throws std::out_of_range if there is none.
[[nodiscard]] Material material_named(const Scene& scene, const std::string& name);
// The surface law of two materials: that of their pair in the scene, else `mixed`.
[[nodiscard]] Material combined_material(const Scene& scene, const std::string& a, const std::string& b);
// The same for all pairs of these materials, an n×n table row by row.
[[nodiscard]] std::vector<Material> combined_materials(const Scene& scene,
                                                       const std::vector<std::string>& names);

// True if a material or a pair of materials sticks, whether or not a body has it.
[[nodiscard]] bool has_sticking_surface(const Scene& scene);
// Likewise for rolling resistance.
[[nodiscard]] bool has_rolling_resistance(const Scene& scene);
// A force that a scene has once, beside gravity, acts on each body alone.
[[nodiscard]] bool has_force_on_each_body(const Scene& scene);
[[nodiscard]] bool has_dampers(const Scene& scene);
[[nodiscard]] bool has_strings(const Scene& scene);

// All bodies: those of the list, then those of the generators in order.
[[nodiscard]] std::vector<Body> all_bodies(const Scene& scene);

// The first of `stem`-1, `stem`-2, ... that is no body's name.
[[nodiscard]] std::string free_body_name(const std::vector<Body>& bodies, const std::string& stem);

}  // namespace carom
