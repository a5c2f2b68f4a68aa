#include "physics/record/sampler.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

#include "physics/preset/preset.h"
#include "physics/record/replay.h"
#include "tests/support/body_literal.h"
#include "tests/support/resumed_run.h"
#include "tests/support/scenes.h"

namespace carom {
namespace {

using namespace test::literals;

using test::disc;
using test::room;

Curve curve(const char* observable, std::initializer_list<int> bodies = {}) {
  return {{find_observable(observable), {bodies.begin(), bodies.end()}}, std::nullopt};
}

// Drag, e < 1 and friction: every entry of the ledger grows.
Preset lossy() {
  std::vector<Body> bodies = room(1.0, 0.5);
  bodies.push_back(disc("a", {-0.5, 0.1}, {3.0, 1.0}));
  bodies.push_back(disc("b", {0.5, -0.1}, {-2.0, 2.0}));
  Preset s = test::preset_with(std::move(bodies), 0.8, 0.3);
  s.scene.forces.quadratic_drag = 0.05;
  s.scene.forces.gravity = {0.0, -1.0};
  s.method.step = 0.02;
  return s;
}

struct Sampled {
  Rows rows;
  std::vector<ImpactRecord> impacts;
  [[nodiscard]] double at(std::size_t row, std::size_t column) const {
    return rows.values[row * rows.curves->size() + column];
  }
  [[nodiscard]] bool before_impact(std::size_t row) const {
    return row + 1 < rows.size() && rows.times[row + 1] == rows.times[row];
  }
  [[nodiscard]] bool after_impact(std::size_t row) const {
    return row > 0 && rows.times[row - 1] == rows.times[row];
  }
};

Sampled run(const Preset& preset, double time, const std::vector<Curve>& curves) {
  Simulation simulation(setup_of(preset));
  simulation.watch_impacts(true);
  Sampler sampler(curves);
  sampler.begin(simulation);
  Sampled sampled;
  simulation.advance_to(time, [&] {
    sampler.after_step(simulation);
    const auto& impacts = simulation.last_impacts();
    sampled.impacts.insert(sampled.impacts.end(), impacts.begin(), impacts.end());
  });
  sampled.rows = sampler.take();
  return sampled;
}

TEST(Sampler, ClosesTheLedgerInEveryRow) {
  const Sampled s = run(lossy(), 2.0,
                        {curve("total_energy"), curve("lost_to_restitution"), curve("lost_to_friction"),
                         curve("lost_in_flight"), curve("put_in"), curve("numerical_drift")});
  ASSERT_GT(s.impacts.size(), 5U);
  EXPECT_TRUE(s.rows.from_the_start);
  EXPECT_EQ(s.rows.times.front(), 0.0);
  const double first = s.at(0, 0);
  for (std::size_t i = 0; i < s.rows.size(); ++i) {
    // At impacts the drift is taken for linear within the step.
    const double tolerance = s.before_impact(i) || s.after_impact(i) ? 1e-9 : 1e-12;
    EXPECT_NEAR(s.at(i, 0), first - s.at(i, 1) - s.at(i, 2) - s.at(i, 3) + s.at(i, 4) + s.at(i, 5), tolerance);
  }
  const std::size_t last = s.rows.size() - 1;
  EXPECT_GT(s.at(last, 1), 0.1);
  EXPECT_GT(s.at(last, 2), 0.01);
  EXPECT_GT(s.at(last, 3), 0.1);
}

// What impacts change jumps upright, by what the impact's record says; nothing else does.
TEST(Sampler, JumpsAtTheImpactsAlone) {
  const Sampled s = run(lossy(), 2.0,
                        {curve("lost_to_restitution"), curve("lost_to_friction"), curve("impacts"),
                         curve("lost_in_flight"), curve("x", {4}), curve("numerical_drift")});
  std::size_t jumps = 0;
  for (std::size_t i = 1; i < s.rows.size(); ++i) {
    const double restitution = s.at(i, 0) - s.at(i - 1, 0);
    const double friction = s.at(i, 1) - s.at(i - 1, 1);
    if (!s.after_impact(i)) {
      EXPECT_NEAR(restitution, 0.0, 1e-12) << s.rows.times[i];
      EXPECT_NEAR(friction, 0.0, 1e-12);
      EXPECT_EQ(s.at(i, 2), s.at(i - 1, 2));
      continue;
    }
    const ImpactRecord& impact = s.impacts[jumps++];
    EXPECT_EQ(s.rows.times[i], impact.time);
    EXPECT_NEAR(restitution, impact.lost_to_restitution, 1e-12);
    EXPECT_NEAR(friction, impact.lost_to_friction, 1e-12);
    EXPECT_EQ(s.at(i, 2), s.at(i - 1, 2) + 1.0);
    EXPECT_NEAR(s.at(i, 3), s.at(i - 1, 3), 1e-14);
    EXPECT_EQ(s.at(i, 4), s.at(i - 1, 4));
    EXPECT_EQ(s.at(i, 5), s.at(i - 1, 5));
  }
  EXPECT_EQ(jumps, s.impacts.size());
}

// 1 kg at 3 m/s runs into 2 kg at rest at t = 0.2 s: -1 and 2 m/s. Bodies' own quantities jump there too.
TEST(Sampler, ReadsBodiesAtAnImpact) {
  Preset preset = test::preset_with(
      {disc("A", {-1.0, 0.0}, {3.0, 0.0}, 0.2, 1.0), disc("B", {0.0, 0.0}, {0.0, 0.0}, 0.2, 2.0)});
  const Sampled s = run(preset, 0.5,
                        {curve("velocity_x", {0}), curve("body_kinetic_energy", {1}),
                         curve("impacts_between", {1, 0}), curve("body_momentum", {1})});
  ASSERT_EQ(s.impacts.size(), 1U);
  int jumps = 0;
  bool met = false;
  for (std::size_t i = 0; i < s.rows.size(); ++i) {
    met = met || s.after_impact(i);
    jumps += s.after_impact(i) ? 1 : 0;
    EXPECT_NEAR(s.at(i, 0), met ? -1.0 : 3.0, 1e-12) << s.rows.times[i];
    EXPECT_NEAR(s.at(i, 1), met ? 4.0 : 0.0, 1e-12);
    EXPECT_EQ(s.at(i, 2), met ? 1.0 : 0.0);
    EXPECT_NEAR(s.at(i, 3), met ? 4.0 : 0.0, 1e-12);
  }
  EXPECT_GE(jumps, 1);
  EXPECT_TRUE(met);
}

// A path over another quantity has two values a row; a body that is put in stands upright in the sums.
TEST(Sampler, ReadsPathsAndEdits) {
  Simulation simulation(setup_of(test::preset_with({disc("A", {0.0, 0.0}, {1.0, 0.5})})));
  const Curve path{{find_observable("y"), {0_b}}, Quantity{find_observable("x"), {0_b}}};
  Sampler sampler({path, curve("kinetic_energy")});
  sampler.begin(simulation);
  simulation.step();
  sampler.after_step(simulation);
  const RunEdit edit{0.005, 1, SceneEdits{Add<Body>{disc("B", {3.0, 0.0}, {2.0, 0.0})}}};
  simulation.set_edits({edit});
  simulation.apply_due();
  sampler.after_edit(simulation, edit);
  const Rows rows = sampler.take();
  ASSERT_EQ(rows.times, (std::vector<double>{0.0, 0.005, 0.005}));
  const std::vector<double> expected = {0.0, 0.0, 0.625, 0.0025, 0.005, 0.625, 0.0025, 0.005, 2.625};
  ASSERT_EQ(rows.values.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_NEAR(rows.values[i], expected[i], 1e-15);
  EXPECT_EQ(sampler.take().size(), 0U);
}

// Two discs a centimetre into one another, and a pile's contacts.
TEST(Sampler, ReadsOverlapsAndContacts) {
  Preset preset = test::preset_with({disc("A", {0.0, 0.0}, {0.0, 0.0}), disc("B", {0.19, 0.0}, {0.0, 0.0})});
  const Sampled s = run(preset, 0.005, {curve("overlap")});
  EXPECT_NEAR(s.at(0, 0), 0.01, 1e-15);

  Preset resting = test::preset_with(
      {test::wall("floor", {0.0, -0.5}, 4.0, 1.0), disc("ball", {0.0, 0.1}, {0.0, 0.0})}, 0.0);
  resting.scene.forces.gravity = {0.0, -9.81};
  resting.method.contacts = ContactsId::kLasting;
  const Sampled held = run(resting, 0.1, {curve("contacts"), curve("contact_force", {0, 1})});
  EXPECT_EQ(held.at(held.rows.size() - 1, 0), 1.0);
  EXPECT_NEAR(held.at(held.rows.size() - 1, 1), 9.81, 1e-12);
}

// Sums over the impacts, of a pair that is plotted, and of one that is not.
TEST(Sampler, CountsGoOnInASavedRun) {
  Preset preset = lossy();
  const auto number = [](const char* name, std::vector<std::string> bodies) {
    QuantityName quantity;
    quantity.observable = name;
    quantity.bodies = std::move(bodies);
    return quantity;
  };
  Plot plot;
  plot.y = {number("impacts_between", {"b", "a"}), number("wall_impacts", {})};
  preset.plots = {plot};
  const int n = static_cast<int>(preset.scene.bodies.size());
  const std::vector<Curve> curves = {curve("impacts_between", {n - 1, n - 2}),
                                     curve("impacts_between", {0, n - 2}),
                                     curve("wall_impacts"),
                                     curve("mutual_impacts"),
                                     curve("wall_impulse"),
                                     curve("impacts")};
  const Sampled whole = run(preset, 4.0, curves);
  Simulation half(setup_of(preset));
  half.advance_to(2.0);
  const Preset saved = test::saved_and_read(preset, half);
  const Sampled rest = run(saved, 4.0, curves);
  const std::size_t first = whole.rows.size() - rest.rows.size();
  EXPECT_GT(rest.at(0, 0), 0.0);
  for (std::size_t row = 0; row < rest.rows.size(); ++row) {
    for (const std::size_t column : {0U, 2U, 3U, 4U, 5U})
      ASSERT_EQ(rest.at(row, column), whole.at(first + row, column)) << row << " " << column;
    ASSERT_TRUE(std::isnan(rest.at(row, 1)));  // nobody has counted it
  }
}

}  // namespace
}  // namespace carom
