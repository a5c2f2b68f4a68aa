#include <algorithm>
#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "physics/run/run_setup.h"
#include "tests/support/compounds.h"
#include "tests/support/scenes.h"

// A gas of compounds that is turned, shifted, mirrored or written in another order moves as before.
namespace carom {
namespace {

using Bodies = std::vector<Body>;

const Vec2 kShift(3.0, -1.0);
constexpr double kTurn = 0.9;

Vec2 mirrored(const Vec2& v) { return {-v.x(), v.y()}; }

PlainShape mirrored(PlainShape shape) {
  if (auto* polygon = std::get_if<Polygon>(&shape)) {
    for (Vec2& v : polygon->vertices) v = mirrored(v);
    std::reverse(polygon->vertices.begin(), polygon->vertices.end());
  }
  return shape;
}

Shape mirrored_form(const Shape& shape) {
  if (const auto* compound = std::get_if<Compound>(&shape)) {
    Compound other = *compound;
    for (PlacedShape& s : other.shapes) s = {mirrored(s.shape), mirrored(s.position), -s.angle, s.material};
    return other;
  }
  if (const auto* polygon = std::get_if<Polygon>(&shape)) return shape_of(mirrored(PlainShape{*polygon}));
  return shape;
}

// What is done to the bodies, and how their places are brought back.
struct Change {
  const char* name;
  std::function<void(Bodies&)> make;
  std::function<Vec2(const Vec2&)> back;
  bool turns = false;
};

std::vector<Change> changes() {
  const auto same = [](const Vec2& place) { return place; };
  return {{"turned and shifted",
           [](Bodies& bodies) {
             for (Body& b : bodies) {
               b.position = turned_by(kTurn, b.position) + kShift;
               b.velocity = turned_by(kTurn, b.velocity);
               b.angle += kTurn;
             }
           },
           [](const Vec2& place) { return turned_by(-kTurn, Vec2(place - kShift)); }, true},
          {"mirrored",
           [](Bodies& bodies) {
             for (Body& b : bodies) {
               b.shape = mirrored_form(b.shape);
               b.position = mirrored(b.position);
               b.velocity = mirrored(b.velocity);
               b.angle = -b.angle;
               b.spin = -b.spin;
             }
           },
           [](const Vec2& place) { return mirrored(place); }},
          {"bodies in another order", [](Bodies& bodies) { std::reverse(bodies.begin(), bodies.end()); }, same},
          {"shapes in another order",
           [](Bodies& bodies) {
             for (Body& b : bodies) {
               if (auto* compound = std::get_if<Compound>(&b.shape))
                 std::reverse(compound->shapes.begin(), compound->shapes.end());
             }
           },
           same}};
}

TEST(CompoundSymmetry, DirectionsPlacesAndOrderAreAllTheSame) {
  const std::vector<Method> methods = {
      {IntegratorId::kExactFlight, ImpactsId::kLocated, ContactsId::kImpulse, 0.01},
      {IntegratorId::kRk4, ImpactsId::kLocated, ContactsId::kLasting, 0.01},
      {IntegratorId::kVelocityVerlet, ImpactsId::kStepEnd, ContactsId::kImpulse, 0.002}};
  for (const Method& method : methods) {
    const auto run_of = [&](Bodies bodies) {
      RunSetup s = test::setup_with(std::move(bodies), 0.9, 0.3);
      s.method = method;
      Simulation run(s);
      while (run.impact_count() < 12) run.step();
      return run;
    };
    const Bodies plain = test::gas_of_compounds(7);
    const Simulation run = run_of(plain);
    for (const Change& change : changes()) {
      // At a step's end, how far bodies are pushed apart depends on how many are near, by boxes along the axes.
      if (method.impacts == ImpactsId::kStepEnd && change.turns) continue;
      Bodies changed = plain;
      change.make(changed);
      const Simulation other = run_of(changed);
      EXPECT_NEAR(other.time(), run.time(), 1e-12) << change.name;
      for (int i = 0; i < run.state().size(); ++i) {
        const std::string& name = run.bodies()[static_cast<std::size_t>(i)].name;
        if (has_infinite_mass(run.bodies()[static_cast<std::size_t>(i)])) continue;
        const auto same = std::find_if(other.bodies().begin(), other.bodies().end(),
                                       [&](const Body& b) { return b.name == name; });
        const Vec2 place = other.state().position(static_cast<int>(same - other.bodies().begin()));
        EXPECT_LT((change.back(place) - run.state().position(i)).norm(), 1e-10)
            << change.name << ", " << name << ", " << static_cast<int>(method.integrator);
      }
    }
  }
}

}  // namespace
}  // namespace carom
