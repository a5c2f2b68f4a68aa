#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>
#include <random>

#include "physics/run/run_setup.h"
#include "tests/hard_cases/stress_scenes.h"

// Large islands: a pile, discs that start penetrating, discs of very different sizes, a gas.
namespace carom::stress {
namespace {

constexpr double kMillimetres = 1e3;  // of a metre
constexpr double kRadius = 0.25;      // m, of the discs of pile and gas

// 1000 discs dropped from a jittered grid into a closed container as wide as the grid: the set-up of the
// peers' measurements, plus a lid.
RunSetup pile_scene(const StressSetting& setting, double rolling) {
  constexpr int kColumns = 32;
  constexpr double kWidth = kColumns * 0.55;
  RunSetup s = scene(
      setting,
      {half_plane("floor", {0, 0}), half_plane("left", {0, 0}, -0.5 * std::numbers::pi),
       half_plane("right", {kWidth, 0}, 0.5 * std::numbers::pi), half_plane("lid", {0, 30}, std::numbers::pi)},
      0.0, 0.5);
  s.scene.materials[0].rolling_resistance = rolling;
  const GridGenerator rows{.name = "disc",
                           .columns = kColumns,
                           .rows = 31,
                           .origin = {0.275, 0.5},
                           .spacing = {0.55, 0.75},
                           .jitter = 0.02,
                           .radius_min = kRadius,
                           .radius_max = kRadius,
                           .seed = 1};
  GridGenerator last = rows;
  last.name = "last";
  last.columns = 8;
  last.rows = 1;
  last.origin.y() += 31 * rows.spacing.y();
  last.seed = 2;
  s.scene.generators = {rows, last};
  return s;
}

// m: the largest distance that any body has moved.
double farthest(const State& now, const State& then) {
  return (now.q - then.q).topRows<2>().colwise().norm().maxCoeff();
}

double drift_of(const Simulation& s) {
  const Ledger ledger = s.ledger();
  return ledger.numerical_drift(s.totals().energy()) / ledger.initial;
}

std::vector<double> pile(const StressSetting& setting) {
  Simulation simulation = run(pile_scene(setting, 0.05), 50.0);
  const State then = simulation.state();
  simulation.advance_to(60.0);
  const Penetrations overlaps = penetrations_of(simulation);
  return {simulation.totals().kinetic() / moving_mass(simulation),
          simulation.state().v.row(2).cwiseAbs().maxCoeff(),
          farthest(simulation.state(), then),
          kMillimetres * overlaps.largest,
          kMillimetres * overlaps.mean,
          drift_of(simulation)};
}
constexpr StressFigure kPileFigures[] = {
    {"kinetic energy per mass", "J/kg", 1e-9, "theory: it comes to rest; 1e-9 J/kg after 60 s is asked for"},
    {"largest spin", "rad/s", 1e-6, "theory: rolling resistance stops it; 1e-6 rad/s after 60 s is asked for"},
    {"creep over the last 10 s", "m", kRest, "theory: at rest; less than 1e-6 m"},
    {"largest overlap", "mm", 39.0, "peer: Box2D v3 at 60 Hz overlaps by 39 mm"},
    {"mean overlap", "mm", 7.0, "peer: Box2D v3 at 60 Hz overlaps by 7 mm in the mean"},
    {"numerical drift over the energy at the start", "1"},
};

std::vector<double> pile_no_rolling(const StressSetting& setting) {
  const Simulation simulation = run(pile_scene(setting, 0.0), 20.0);
  return {simulation.totals().rotational / moving_mass(simulation), drift_of(simulation)};
}
constexpr StressFigure kNoRollingFigures[] = {
    {"rolling energy left per mass", "J/kg"},
    {"numerical drift over the energy at the start", "1"},
};

// A square of discs that penetrate by a quarter of a diameter, without gravity.
std::vector<double> overlapping_start(const StressSetting& setting) {
  constexpr double kSmall = 0.1;  // m
  RunSetup s = scene(setting, {}, 0.5, 0.3, 0.0);
  s.scene.generators = {{.columns = 10,
                         .rows = 10,
                         .spacing = Vec2::Constant(1.5 * kSmall),
                         .jitter = 0.01 * kSmall,
                         .radius_min = kSmall,
                         .radius_max = kSmall}};
  Simulation simulation(s);
  double fastest = 0.0;
  simulation.advance_to(
      2.0, [&] { fastest = std::max(fastest, simulation.state().v.topRows<2>().colwise().norm().maxCoeff()); });
  return {fastest, kMillimetres * penetrations_of(simulation).largest};
}
constexpr StressFigure kOverlappingFigures[] = {
    {"largest speed gained", "m/s", kRounding,
     "theory: positions are moved apart; velocities are not; 1e-9 m/s is rounding"},
    {"overlap left after 2 s", "mm"},
};

// A disc of 1000 m on a floor; a disc of a millimetre in the corner between them, touching both; another on
// top of the large disc; and five that fall on the floor nearby.
std::vector<double> sizes(const StressSetting& setting) {
  constexpr double kLarge = 1e3;   // m
  constexpr double kSmall = 1e-3;  // m
  const auto sized = [](const char* name, Vec2 at, double radius) {
    return disc(name, at, radius, std::numbers::pi * radius * radius);
  };
  std::vector<Body> bodies = {half_plane("floor", {0, 0}), sized("large", {0.0, kLarge}, kLarge),
                              sized("in the corner", {2.0 * std::sqrt(kLarge * kSmall), kSmall}, kSmall),
                              sized("on top", {0.0, 2.0 * kLarge + kSmall}, kSmall)};
  for (int i = 0; i < 5; ++i) {
    bodies.push_back(sized("", {60.0 + 0.01 * i, 1.0 + 0.1 * i}, kSmall));
    bodies.back().name = fmt::format("falling-{}", i + 1);
  }
  Simulation simulation(scene(setting, bodies, 0.0, 0.5));
  double largest = 0.0;
  simulation.advance_to(5.0, [&] { largest = std::max(largest, penetrations_of(simulation).largest); });
  return {largest / kSmall};
}
constexpr StressFigure kSizesFigures[] = {
    {"largest overlap over the small radius", "1", kRounding / 1e-3,
     "theory: rigid whatever the sizes; 1e-9 m is rounding among coordinates of 1000 m"}};

// Uniform in [0, 1) and normal with mean 0 and variance 1 (Box and Muller), the same with every library.
double uniform(std::mt19937_64& random) { return static_cast<double>(random() >> 11U) * 0x1p-53; }
double normal(std::mt19937_64& random) {
  const double radius = std::sqrt(-2.0 * std::log(1.0 - uniform(random)));
  return radius * std::cos(2.0 * std::numbers::pi * uniform(random));
}

// 1000 frictionless discs in a square box of five times their area, rms speed 1 m/s, no net momentum: the
// set-up of the peers' measurements.
std::vector<double> gas(const StressSetting& setting) {
  constexpr int kSide = 32;
  constexpr int kCount = 1000;
  const double width = std::sqrt(kCount * std::numbers::pi * kRadius * kRadius / 0.2);
  std::vector<Body> bodies = {half_plane("floor", {0, 0}), half_plane("left", {0, 0}, -0.5 * std::numbers::pi),
                              half_plane("right", {width, 0}, 0.5 * std::numbers::pi),
                              half_plane("lid", {0, width}, std::numbers::pi)};
  std::mt19937_64 random(1);
  const double cell = width / kSide;
  for (int i = 0; i < kCount; ++i) {
    const Vec2 jitter(uniform(random) - 0.5, uniform(random) - 0.5);
    const int row = i / kSide;
    Vec2 place(cell * (i % kSide + 0.5), cell * (row + 0.5));
    place += 0.9 * (cell - 2.0 * kRadius) * jitter;
    bodies.push_back(disc(fmt::format("disc-{}", i + 1), place, kRadius));
    bodies.back().velocity = {normal(random), normal(random)};
  }
  Vec2 mean = Vec2::Zero();
  for (const Body& b : bodies) mean += b.velocity / kCount;
  double square = 0.0;
  for (Body& b : bodies) {
    if (b.fixed) continue;
    b.velocity -= mean;
    square += b.velocity.squaredNorm() / kCount;
  }
  for (Body& b : bodies) b.velocity /= std::sqrt(square);

  Simulation simulation(scene(setting, bodies, 1.0, 0.0, 0.0));
  const double before = simulation.totals().kinetic();
  const std::int64_t impacts = setting.longer ? 1'000'000 : 100'000;
  while (simulation.impact_count() < impacts && !simulation.lost()) simulation.step();
  return {simulation.totals().kinetic() / before - 1.0, static_cast<double>(simulation.impact_count())};
}
constexpr StressFigure kGasFigures[] = {
    {"relative change of the energy", "1", 1e-12,
     "theory: elastic impacts keep it; each rounds by some 1e-16 and 1e6 of them at random by 1e-13"},
    {"impacts", "1"},
};
// Nothing acts between impacts, so that the step affects only the cost.
constexpr double kGasSteps[] = {0.1};

constexpr StressCase kCases[] = {
    {"pile", "1000 discs into a closed container for 60 s, friction 0.5, rolling resistance 0.05", pile,
     kPileFigures},
    {"pile-no-rolling", "the same without rolling resistance, for 20 s", pile_no_rolling, kNoRollingFigures},
    {"overlapping-start", "100 discs that start a quarter of a diameter inside one another", overlapping_start,
     kOverlappingFigures},
    {"sizes", "discs of 1 mm beside and on one of 1000 m", sizes, kSizesFigures},
    {"gas", "1000 elastic discs for 1e5 impacts; with --long 1e6", gas, kGasFigures, kEulerAndRk4, kGasSteps},
};

}  // namespace

std::span<const StressCase> piles() { return kCases; }

}  // namespace carom::stress
