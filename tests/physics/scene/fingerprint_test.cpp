#include "physics/scene/fingerprint.h"

#include <functional>
#include <gtest/gtest.h>
#include <set>

#include "tests/support/scenes.h"

namespace carom {
namespace {

Body body(const std::string& name, const Shape& shape) {
  Body b = test::disc(name, {0.5, -0.25}, {1.0, 2.0});
  b.shape = shape;
  return b;
}

// Every type of part, each with members that haven't their defaults.
Scene of_everything() {
  Scene s;
  s.forces.gravity = {0.5, -9.81};
  s.forces.linear_drag = 0.1;
  s.forces.quadratic_drag = 0.2;
  s.forces.attraction = Attraction{2.0, 0.3};
  s.forces.springs = {
      {"spring", "disc", "box", {0.1, 0.2}, 3.0, 0.4, 0.5, SpringActs::kPull, {}},
      {"", "disc", "", {0.1, 0.2}, 3.0, 0.0, 0.0, SpringActs::kBoth, {}},
  };
  s.forces.applied = {{"disc", {1.0, 2.0}, 0.3, 0.4, 0.5, 6.0, {}}};
  s.materials = {{"default", 0.9, 0.1, 0.3, 0.2, 0.05, false, {}}, {"clay", 0.0, 0.0, 0.0, 0.0, 0.0, true, {}}};
  s.pairs = {{"default", "clay", {"pair", 0.5, 0.1, 0.2, 0.1, 0.0, false, {}}, {}}};
  s.impact_law = ImpactLawId::kNewton;
  s.several_impacts = SeveralImpactsId::kSimultaneous;
  s.bodies = {
      body("disc", Disc{0.2}),
      body("box", Box{0.2, 0.3}),
      body("polygon", Polygon{{{0.0, 0.0}, {1.0, 0.0}, {0.0, 1.0}}, 0.05}),
      body("wall", Wall{2.0}),
      body("plane", Wall{}),
      body("compound", Compound{{{Disc{0.1}, {0.1, 0.2}, 0.3, "clay"}, {Box{0.2, 0.1}, {0.0, 0.0}, 0.0, ""}}}),
  };
  Body& disc = s.bodies[0];
  disc.angle = 0.1;
  disc.spin = 0.2;
  disc.inertia = 0.3;
  disc.material = "clay";
  disc.group = "group";
  s.bodies[1].mass.reset();
  s.bodies[1].density = 2.5;
  s.bodies[3].fixed = true;
  s.bodies[4].drive = Drive{{0.1, 0.2}, {0.3, 0.4}, 5.0, 0.6};
  s.generators = {GridGenerator{.name = "grain", .columns = 2, .rows = 2}};
  s.joints = {
      {"rod", JointKind::kRod, "disc", {0.1, 0.0}, "box", {0.0, 0.1}, 1.5, {}, {}},
      {"pin", JointKind::kPin, "disc", {0.1, 0.0}, "", {0.0, 0.1}, {}, {}, {}},
      {"weld", JointKind::kWeld, "box", {0.0, 0.0}, "disc", {0.0, 0.0}, {}, 0.25, {}},
  };
  return s;
}

// What is written into saved runs: a later version must read it as that of the same scene.
TEST(Fingerprint, IsThatOfEarlierVersions) {
  EXPECT_EQ(fingerprint(Scene{}, 0.0), 0xa4ca53d582377be5ULL);
  EXPECT_EQ(fingerprint(of_everything(), 1.5), 0x30b80a2926508a97ULL);
}

TEST(Fingerprint, TellsApartWhatHasAPartInThePhysics) {
  const std::vector<std::function<void(Scene&)>> changes = {
      [](Scene& s) { s.bodies[0].group = "other"; },
      [](Scene& s) { s.bodies[0].inertia.reset(); },
      [](Scene& s) { std::get<Disc>(s.bodies[0].shape).radius = 0.3; },
      [](Scene& s) { std::get<Compound>(s.bodies[5].shape).shapes[1].angle = 0.1; },
      [](Scene& s) { s.bodies[4].drive->phase = 0.0; },
      [](Scene& s) { s.forces.linear_drag = 0.0; },
      [](Scene& s) { s.forces.attraction->softening = 0.0; },
      [](Scene& s) { s.forces.applied[0].end.reset(); },
      [](Scene& s) { s.forces.springs[0].acts = SpringActs::kPush; },
      [](Scene& s) { s.joints[1].kind = JointKind::kWeld; },
      [](Scene& s) { s.joints[2].angle.reset(); },
      [](Scene& s) { s.pairs[0].surface.restitution = 0.6; },
      [](Scene& s) { s.materials[1].sticks = false; },
      [](Scene& s) { s.generators[0].rows = 3; },
  };
  std::set<std::uint64_t> all = {fingerprint(of_everything(), 1.5), fingerprint(of_everything(), 1.6)};
  for (const auto& change : changes) {
    Scene s = of_everything();
    change(s);
    all.insert(fingerprint(s, 1.5));
  }
  EXPECT_EQ(all.size(), changes.size() + 2);
}

}  // namespace
}  // namespace carom
