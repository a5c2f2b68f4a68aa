#include "tests/support/random_scene.h"

#include <fmt/format.h>
#include <numbers>

#include "physics/collision/pair_contact.h"
#include "physics/model/geometry.h"
#include "physics/preset/preset.h"
#include "tests/support/draws.h"
#include "tests/support/scenes.h"

namespace carom::test {
namespace {

// s; a multiple of the longest step, so that no scene is too stiff for an integrator.
constexpr double kSlow = 0.2;
constexpr double kLargestRadius = 0.25;  // of a disc, in units
constexpr double kLongestRun = 2.0;      // s: 60 of the longest steps

// True if the last body penetrates an earlier one that it can collide with.
bool last_overlaps(const std::vector<Body>& bodies) {
  const Geometry shapes = geometry(bodies);
  const State state = initial_state(bodies);
  const BodyIndex last{static_cast<int>(bodies.size()) - 1};
  for (BodyIndex i{0}; i < last; ++i) {
    if (has_infinite_mass(bodies[i]) && has_infinite_mass(bodies[last])) continue;
    if (contact_between(shapes, i, state.q.col(i), last, state.q.col(last)).gap <= 0.0) return true;
  }
  return false;
}

// True if a kinematic body leaves room for two discs of any size between itself and the static bodies, for
// the longest run: crushed discs must penetrate. Its shape is taken as its bounding circle.
bool never_crushes(const Body& kinematic, const std::vector<Body>& fixed, double unit) {
  std::vector<Body> bodies = fixed;
  bodies.push_back(disc("around", kinematic.position, {0.0, 0.0},
                        bounding_radius(kinematic.shape) + 4.0 * kLargestRadius * unit));
  const Geometry shapes = geometry(bodies);
  State state = initial_state(bodies);
  const BodyIndex last{static_cast<int>(fixed.size())};
  for (double t = 0.0; t < kLongestRun; t += 0.01) {
    const Vec2 position =
        kinematic.position + t * kinematic.drive->velocity +
        std::sin(kinematic.drive->angular_frequency * t + kinematic.drive->phase) * kinematic.drive->amplitude;
    state.q.col(last).head<2>() = position;
    for (BodyIndex i{0}; i < last; ++i) {
      if (contact_between(shapes, i, state.q.col(i), last, state.q.col(last)).gap <= 0.0) return false;
    }
  }
  return true;
}

void add_boxes(Draws& dice, double unit, Preset& s) {
  if (dice.chance(0.7)) s.scene.bodies = room(unit, dice.chance(0.2) ? 0.01 * unit : 0.5 * unit);
  for (int i = dice.up_to(3); i > 0; --i) {
    s.scene.bodies.push_back(wall(fmt::format("box-{}", i), dice.in_square(unit),
                                  dice.between(0.01, 0.6) * unit, dice.between(0.01, 0.6) * unit,
                                  dice.angle()));
  }
  if (!dice.chance(0.4)) return;
  for (int tries = 0; tries < 10; ++tries) {
    Body kinematic =
        wall("driven", dice.in_square(unit), dice.between(0.1, 0.6) * unit, 0.2 * unit, dice.angle());
    kinematic.fixed = false;
    Drive drive;
    if (dice.chance(0.6)) drive.velocity = dice.in_square(unit);
    if (dice.chance(0.6)) {
      drive.amplitude = dice.in_square(0.2 * unit);
      drive.angular_frequency = dice.between(0.5, 10.0);
      drive.phase = dice.angle();
    }
    kinematic.drive = drive;
    if (!never_crushes(kinematic, s.scene.bodies, unit)) continue;
    s.scene.bodies.push_back(kinematic);
    return;
  }
}

// A box, a capsule, a triangle or a thin wall, as large as a disc of this radius.
Shape cornered_shape(Draws& dice, double radius) {
  const double thin = dice.between(0.2, 1.0) * radius;
  switch (dice.up_to(3)) {
    case 0:
      return Box{1.8 * radius, 1.5 * thin};
    case 1:
      return Polygon{{{0.0, 0.0}, {radius, 0.0}}, 0.5 * thin};
    case 2:
      return Polygon{{{0.0, 0.0}, {1.5 * radius, 0.0}, {0.3 * radius, thin}},
                     dice.chance(0.5) ? 0.1 * radius : 0.0};
    default:
      return Wall{2.0 * radius};
  }
}

// An L, an arrow head, a dumb-bell, a hammer or two flush boxes, as large as a disc of this radius.
Shape shape_of_parts(Draws& dice, double radius) {
  const double r = radius;
  const double thin = dice.between(0.2, 0.8) * radius;
  switch (dice.up_to(4)) {
    case 0:
      return Polygon{{{0, 0}, {1.5 * r, 0}, {1.5 * r, thin}, {thin, thin}, {thin, 1.5 * r}, {0, 1.5 * r}}};
    case 1:
      return Polygon{{{0, 0}, {r, -0.7 * r}, {0.2 * thin, 0}, {r, 0.7 * r}}};
    case 2:
      return Compound{{{Disc{0.4 * r}, {-0.6 * r, 0.0}, 0.0, {}},
                       {Disc{0.4 * r}, {0.6 * r, 0.0}, 0.0, {}},
                       {Box{1.2 * r, 0.4 * thin}, {0.0, 0.0}, 0.0, {}}}};
    case 3:
      return Compound{{{Box{1.4 * r, 0.3 * thin}, {0.0, 0.0}, 0.0, {}},
                       {Box{0.5 * thin, r}, {0.6 * r, 0.0}, dice.between(-0.3, 0.3), {}}}};
    default:
      return Compound{
          {{Box{0.8 * r, thin}, {-0.4 * r, 0.0}, 0.0, {}}, {Box{0.8 * r, thin}, {0.4 * r, 0.0}, 0.0, {}}}};
  }
}

std::vector<std::string> add_bodies(Draws& dice, double unit, bool may_overlap, bool compounds,
                                    RandomScene& random) {
  std::vector<Body>& bodies = random.preset.scene.bodies;
  std::vector<std::string> names;
  const int wanted = 1 + dice.up_to(11);
  const double speed = dice.chance(0.1) ? 0.0 : dice.between(0.1, 4.0) * unit;
  random.cornered = dice.chance(0.4) || compounds;
  for (int tries = 0; tries < 200 && static_cast<int>(names.size()) < wanted; ++tries) {
    const double radius = std::exp(dice.between(std::log(0.02), std::log(kLargestRadius))) * unit;
    const double mass = std::exp(dice.between(std::log(0.01), std::log(100.0)));
    const std::string name = fmt::format("disc-{}", names.size() + 1);
    bodies.push_back(disc(name, dice.in_square(unit), dice.in_square(speed), radius, mass));
    if (dice.chance(0.3)) bodies.back().spin = dice.between(-10.0, 10.0);
    if (random.cornered && dice.chance(0.5)) {
      bodies.back().shape = compounds ? shape_of_parts(dice, radius) : cornered_shape(dice, radius);
      bodies.back().angle = dice.angle();
    }
    if (last_overlaps(bodies)) {
      if (!may_overlap) {
        bodies.pop_back();
        continue;
      }
      random.overlaps = true;
    }
    names.push_back(name);
  }
  return names;
}

void add_forces(Draws& dice, double unit, const std::vector<std::string>& discs, bool cornered, Preset& s) {
  const auto mass = [&](const std::string& name) {
    for (const Body& b : s.scene.bodies) {
      if (b.name == name) return *b.mass;
    }
    return 1.0;
  };
  const auto any = [&]() -> const std::string& {
    return discs[dice.up_to(static_cast<int>(discs.size()) - 1)];
  };
  if (dice.chance(0.5))
    s.scene.forces.gravity = dice.chance(0.7) ? Vec2(0.0, -9.81 * unit) : dice.in_square(5.0 * unit);
  if (discs.empty()) return;
  double lightest = mass(discs[0]);
  for (const std::string& name : discs) lightest = std::min(lightest, mass(name));
  if (dice.chance(0.15)) s.scene.forces.linear_drag = dice.between(0.0, 1.0) * lightest / kSlow;
  if (dice.chance(0.15)) s.scene.forces.quadratic_drag = dice.between(0.0, 0.3) * lightest / unit;
  if (dice.chance(0.3)) {
    for (int i = dice.up_to(3); i >= 0; --i) {
      Spring spring;
      spring.name = fmt::format("spring-{}", i);
      spring.body = any();
      spring.to = any();
      if (spring.to == spring.body) {
        spring.to.clear();
        spring.anchor = dice.in_square(unit);
      }
      const double light = spring.to.empty() ? mass(spring.body) : std::min(mass(spring.body), mass(spring.to));
      spring.stiffness = dice.between(0.01, 1.0) * light / (kSlow * kSlow);
      if (dice.chance(0.5)) spring.damping = dice.between(0.0, 1.0) * light / kSlow;
      if (dice.chance(0.7)) spring.rest_length = dice.between(0.1, 1.5) * unit;
      spring.acts = static_cast<SpringActs>(dice.up_to(3));
      s.scene.forces.springs.push_back(spring);
    }
  }
  // Not for bodies with corners: the contact search is slow for thin bodies thrown about by such a pull.
  if (dice.chance(0.1) && !cornered) {
    // The heaviest body pulls a neighbour at 0.3 units as strongly as gravity does.
    s.scene.forces.attraction = Attraction{dice.between(0.1, 1.0) * unit * unit * unit / 100.0,
                                           dice.chance(0.5) ? dice.between(0.05, 0.3) * unit : 0.0};
  }
  if (dice.chance(0.15)) {
    AppliedForce force;
    force.body = any();
    force.force = dice.in_square(10.0 * unit) * mass(force.body);
    if (dice.chance(0.5)) force.start = dice.between(0.0, 0.5);
    if (dice.chance(0.5)) force.rise = dice.between(0.0, 0.5);
    if (dice.chance(0.5)) force.end = force.start + dice.between(0.0, 0.5);
    if (dice.chance(0.3)) force.torque = dice.between(-1.0, 1.0) * lightest * unit * unit;
    s.scene.forces.applied.push_back(force);
  }
}

// Some springs and forces act beside a centre; by draws of their own, so that all else of a seed stays.
void move_points(std::uint64_t seed, Scene& scene) {
  Draws dice(~seed);
  if (!dice.chance(0.4)) return;
  const auto point_of = [&](const std::string& name) {
    for (const Body& body : scene.bodies) {
      if (body.name == name && dice.chance(0.5)) return dice.in_square(0.5 * bounding_radius(body.shape));
    }
    return Vec2(Vec2::Zero());
  };
  for (Spring& spring : scene.forces.springs) {
    spring.point = point_of(spring.body);
    if (!spring.to.empty()) spring.anchor = point_of(spring.to);
  }
  for (AppliedForce& force : scene.forces.applied) force.point = point_of(force.body);
}

RandomScene random_scene_of(std::uint64_t seed, bool compounds) {
  Draws dice(seed);
  RandomScene random;
  Preset& s = random.preset;
  s.title = fmt::format("random scene {}", seed);
  double unit = 1.0;  // m
  if (dice.chance(0.1)) unit = 1e-3;
  if (dice.chance(0.1)) unit = 1e3;
  Material material;
  material.restitution = dice.chance(0.4) ? 1.0 : dice.chance(0.15) ? 0.0 : dice.between(0.0, 1.0);
  if (dice.chance(0.5)) {
    material.kinetic_friction = dice.between(0.0, 1.0);
    material.static_friction = material.kinetic_friction + (dice.chance(0.5) ? dice.between(0.0, 0.5) : 0.0);
    if (dice.chance(0.3)) material.tangential_restitution = dice.between(-1.0, 1.0);
  }
  s.scene.materials = {material};
  if (dice.chance(0.2)) s.scene.several_impacts = SeveralImpactsId::kSimultaneous;
  add_boxes(dice, unit, s);
  const bool may_overlap = dice.chance(0.05);
  const std::vector<std::string> discs = add_bodies(dice, unit, may_overlap, compounds, random);
  add_forces(dice, unit, discs, random.cornered, s);
  move_points(seed, s.scene);
  s.method.step = dice.chance(0.5) ? 1.0 / 120.0 : dice.between(1.0 / 480.0, 1.0 / 30.0);
  s.method.tolerance = 1e-8 * unit;
  s.duration = 1.0;
  return random;
}

}  // namespace

RandomScene random_scene(std::uint64_t seed) { return random_scene_of(seed, false); }
RandomScene random_scene_of_compounds(std::uint64_t seed) { return random_scene_of(seed, true); }

}  // namespace carom::test
