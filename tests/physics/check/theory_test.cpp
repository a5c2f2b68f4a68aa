#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <gtest/gtest.h>
#include <map>

#include "physics/preset/preset.h"
#include "physics/preset/preset_file.h"
#include "physics/record/sampler.h"
#include "physics/scene/validate.h"
#include "tests/support/preset_files.h"
#include "tests/support/scenes.h"
#include "tests/support/source_folder.h"

// Closed forms beside what is measured: their residuals, and that of every preset that states one.
namespace carom {
namespace {

struct Residuals {
  double largest = 0.0;
  double at = 0.0;  // s
};

// The largest residual of a line at all that the sampler sees, but for the times that `leave_out` names.
template <class LeaveOut>
Residuals residuals(const Preset& preset, const Quantity& quantity, const LeaveOut& leave_out) {
  Simulation simulation(setup_of(preset));
  simulation.watch_impacts(true);
  Sampler sampler({{quantity, std::nullopt}});
  sampler.begin(simulation);
  simulation.advance_to(preset.duration, [&] { sampler.after_step(simulation); });
  const Rows rows = sampler.take();
  Residuals found;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    EXPECT_TRUE(std::isfinite(rows.values[i])) << rows.times[i];
    if (std::abs(rows.values[i]) <= found.largest || leave_out(rows.times[i])) continue;
    found = {std::abs(rows.values[i]), rows.times[i]};
  }
  return found;
}

Quantity residual_of(const QuantityName& line, const std::optional<QuantityName>& x, const Preset& preset) {
  const std::vector<Body> bodies = all_bodies(preset.scene);
  Quantity quantity = quantity_of(line, bodies);
  std::optional<Quantity> over;
  if (x) over = quantity_of(*x, bodies);
  quantity.less = theory_of(line, over);
  return quantity;
}

// What a preset's method may leave, and within a step of which moment it isn't asked.
struct Bound {
  double most;
  double but_at = -1.0;  // s
};

// Rounding, where flight and impacts have closed forms: some eps a bounce of the size of the path, as the time
// of an impact is rounded and the speed turns it into a place. Else what is said beside it.
const std::map<std::string, Bound> kBounds = {
    {"head-on", {1e-14}},
    {"ball-in-a-box", {5e-14}},
    {"incline-hops", {1e-14}},
    {"superball", {2e-14}},
    // Contacts that last are solved to 1e-10 g h a step; the step in which slip ends is shared by both.
    {"slide-to-roll", {1e-11, 3.0 / (3.0 * 0.2 * 9.81)}},
    {"disc-on-incline", {2e-11}},
    // Dormand-Prince of order 5 at z = ωh = 0.034: its error constant is below 1e-3, so z⁵/1000 of the 0.15 m
    // swing at half a swing.
    {"spring-bumpers", {1e-10}},
    // RK4 at z = ωh = 1: the phase falls behind by z⁴/120 of ωt, 0.42 rad of 50, and the swing has 1 m; with
    // the higher orders of so coarse a step no more than all of it.
    {"spring-box", {0.6}},
    // A law of means for 500 grains: within 4 % of the 125 J at the start, and 3 % for the one seed.
    {"granular-cooling", {9.0}},
};

TEST(Theory, OfEachPresetIsWhatItsMethodGives) {
  std::size_t lines = 0;
  std::map<std::string, int> seen;
  for (const std::filesystem::path& file : test::preset_files()) {
    const Preset preset = read_preset(file);
    const std::string name = file.stem().string();
    for (const Plot& plot : preset.plots) {
      for (const QuantityName& line : plot.y) {
        if (line.theory.empty()) continue;
        SCOPED_TRACE(name + ": " + line.theory);
        ++lines;
        ++seen[name];
        const auto bound = kBounds.find(name);
        ASSERT_NE(bound, kBounds.end()) << "a theory without a bound";
        const double h = preset.method.step;
        const auto near = [&](double t) { return std::abs(t - bound->second.but_at) <= h; };
        const Residuals found = residuals(preset, residual_of(line, plot.x, preset), near);
        EXPECT_LE(found.largest, bound->second.most) << "at t = " << found.at << " s";
      }
    }
  }
  EXPECT_EQ(seen.size(), kBounds.size());
  EXPECT_GE(lines, 14u);
}

// Where the slip ends within a step, the velocity at the step's end is right.
TEST(Theory, OfSlideToRollHoldsThroughTheStepInWhichTheSlipEnds) {
  const Preset preset = read_preset(test::preset_file("friction/slide-to-roll.json"));
  const QuantityName line{"velocity_x", {"disc"}, "max(2, 3 - 0.2*9.81*t)", true};
  const Residuals found =
      residuals(preset, residual_of(line, std::nullopt, preset), [](double) { return false; });
  EXPECT_LE(found.largest, 1e-11);
}

Preset drag_scene(double step) {
  Preset preset;
  preset.scene.bodies = {test::disc("a", {0.0, 0.0}, {2.0, 0.0})};
  preset.scene.bodies[0].mass = 3.0;
  preset.scene.forces.linear_drag = 1.0;
  preset.duration = 3.0;
  preset.method.step = step;
  return preset;
}

// v = 2 exp(-t/3): RK4 has the Taylor polynomial of exp to the fourth order, so a step is off by (h/3)⁵/120 of
// the speed and t/h of them by t h⁴/(3⁵ 120).
TEST(Theory, OfLinearDragShowsTheMethodsOrder) {
  const QuantityName line{"velocity_x", {"a"}, "2*exp(-t/3)", true};
  for (const double h : {0.3, 0.1, 0.03}) {
    const Preset preset = drag_scene(h);
    const Residuals found =
        residuals(preset, residual_of(line, std::nullopt, preset), [](double) { return false; });
    const double expected = 2.0 * std::exp(-1.0) * 3.0 * std::pow(h, 4) / (243.0 * 120.0);
    EXPECT_NEAR(found.largest / expected, 1.0, 0.1) << h;
  }
}

// Of a spring: the phase of RK4 falls behind by z⁴/120 of ωt, z = ωh, and the swing is 1 m.
TEST(Theory, OfASpringShowsTheMethodsOrder) {
  Preset preset = read_preset(test::preset_file("numerical-methods/spring-box.json"));
  const QuantityName line{"x", {"disc"}, "cos(5*t)", true};
  for (const double h : {0.02, 0.004}) {
    preset.method.step = h;
    const Residuals found =
        residuals(preset, residual_of(line, std::nullopt, preset), [](double) { return false; });
    EXPECT_NEAR(found.largest / (std::pow(5.0 * h, 4) / 120.0 * 50.0), 1.0, 0.05) << h;
  }
}

// v² = v₀² - 2 g (y - y₀), over the height instead of time.
TEST(Theory, OverAnotherQuantityMayHangOnIt) {
  Preset preset;
  preset.scene.bodies = {test::disc("a", {0.0, 1.0}, {0.0, 4.0})};
  preset.scene.forces.gravity = {0.0, -9.81};
  preset.duration = 0.4;
  preset.method.integrator = IntegratorId::kExactFlight;
  const QuantityName line{"velocity_y", {"a"}, "sqrt(16 - 2*9.81*(x - 1)) + 0*t", true};
  const Residuals found =
      residuals(preset, residual_of(line, QuantityName{"y", {"a"}}, preset), [](double) { return false; });
  EXPECT_LE(found.largest, 1e-13);
  EXPECT_GT(residuals(preset,
                      residual_of({"velocity_y", {"a"}, "sqrt(16 - 2*9.8*(x - 1))"}, QuantityName{"y", {"a"}},
                                  preset),
                      [](double) { return false; })
                .largest,
            1e-3);
}

// The residual is a quantity of its own, beside the measured one.
TEST(Theory, MakesAQuantityOfItsOwn) {
  const Preset preset = drag_scene(0.1);
  const Quantity measured = quantity_of({"velocity_x", {"a"}}, preset.scene.bodies);
  const Quantity one = residual_of({"velocity_x", {"a"}, "2*exp(-t/3)"}, std::nullopt, preset);
  EXPECT_NE(measured, one);
  EXPECT_EQ(one, residual_of({"velocity_x", {"a"}, "2*exp(-t/3)"}, std::nullopt, preset));
  EXPECT_NE(one, residual_of({"velocity_x", {"a"}, "2*exp(-t/4)"}, std::nullopt, preset));
}

}  // namespace
}  // namespace carom
