#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "physics/run/run_setup.h"
#include "tests/hard_cases/stress_scenes.h"

// Impacts that are fast, many at once, or infinitely many.
namespace carom::stress {
namespace {

// Relative error of the energy at each impact.
constexpr double kPerImpact = 1e-12;

// A disc of 1 cm that flies 1000 radii a step between two walls without thickness, for a second.
std::vector<double> bullet(const StressSetting& setting) {
  constexpr double kRadius = 0.01;  // m
  constexpr double kSpeed = 1000.0 * kRadius * 60.0;
  constexpr double kHalf = 0.5;  // m
  constexpr double kTime = 1.0;  // s
  const auto wall = [](const char* name, double x) {
    Body b = half_plane(name, {x, 0.0}, std::asin(1.0));
    b.shape = Wall{1.0};
    return b;
  };
  Body ball = disc("ball", {0, 0}, kRadius);
  ball.velocity = {kSpeed, 0.0};
  Simulation simulation(scene(setting, {wall("left", -kHalf), wall("right", kHalf), ball}, 1.0, 0.0, 0.0));
  double beyond = 0.0;
  simulation.advance_to(
      kTime, [&] { beyond = std::max(beyond, std::abs(simulation.state().q(0, 2)) + kRadius - kHalf); });
  // The unfolded path: the centre has a free width w and starts in its middle.
  const double width = 2.0 * (kHalf - kRadius);
  const double unfolded = kSpeed * kTime / width + 0.5;
  const double bounces = std::floor(unfolded);
  const double part = unfolded - bounces;
  const double x = width * ((std::fmod(bounces, 2.0) == 0.0 ? part : 1.0 - part) - 0.5);
  return {beyond, (bounces - static_cast<double>(simulation.impact_count())) / bounces,
          simulation.state().q(0, 2) - x};
}
constexpr StressFigure kBulletFigures[] = {
    {"largest penetration", "m", kRounding, "theory: none; 1e-9 m is rounding on a path of 10 m a step"},
    {"share of the bounces missed", "1", 0.0, "theory: the path unfolded counts them"},
    {"error of the place after 1 s", "m", kRounding, "theory: the path unfolded; 1e-9 m of 600 m is rounding"},
};

// `count` equal discs: all but the first touch each other; the first comes in at 1 m/s.
std::vector<double> cradle(const StressSetting& setting, int count) {
  constexpr double kRadius = 0.125;  // m; sums of it are exact in doubles
  std::vector<Body> balls;
  for (int i = 0; i < count; ++i)
    balls.push_back(disc(fmt::format("ball-{}", i + 1), {2.0 * kRadius * i, 0.0}, kRadius));
  balls[0].position.x() -= 1.0;
  balls[0].velocity = {1.0, 0.0};
  const Simulation simulation = run(scene(setting, balls, 1.0, 0.0, 0.0), 2.0);
  const Eigen::VectorXd v = simulation.state().v.row(0);
  return {v[count - 1] - 1.0, v.head(count - 1).cwiseAbs().maxCoeff(),
          2.0 * simulation.totals().kinetic() - 1.0};
}
std::vector<double> cradle_5(const StressSetting& s) { return cradle(s, 5); }
std::vector<double> cradle_20(const StressSetting& s) { return cradle(s, 20); }
constexpr StressFigure kCradleFigures[] = {
    {"error of the last ball's speed", "m/s", kPerImpact, "theory: pair by pair equal masses swap velocities"},
    {"largest speed of the others", "m/s", kPerImpact, "theory: pair by pair equal masses swap velocities"},
    {"relative change of the energy", "1", kPerImpact, "theory: elastic impacts keep it"},
};

std::vector<double> galperin(const StressSetting& setting) {
  constexpr double kRatio = 1e4;
  // Exactly upright: discs diverge from any line that is not their own.
  Body wall = box("wall", {-0.1, 0.0}, 0.2, 1.4);
  wall.fixed = true;
  Body heavy = disc("heavy", {1.5, 0.0}, 0.3, kRatio);
  heavy.velocity = {-0.5, 0.0};
  Simulation simulation(scene(setting, {wall, disc("light", {0.6, 0.0}, 0.1), heavy}, 1.0, 0.0, 0.0));
  const double before = simulation.totals().kinetic();
  simulation.advance_to(12.0);
  constexpr double kCount = 314.0;
  return {static_cast<double>(simulation.impact_count()) - kCount,
          simulation.totals().kinetic() / before - 1.0};
}
constexpr StressFigure kGalperinFigures[] = {
    {"impacts off 314", "1", 0.0, "theory: ⌈π/arctan√(m/M)⌉ - 1 with M/m = 1e4 (Galperin 2003)"},
    {"relative change of the energy", "1", kPerImpact, "theory: elastic impacts keep it"},
};

std::vector<double> inelastic_collapse(const StressSetting& setting) {
  std::vector<Body> discs = {disc("left", {-1.2, 0.0}, 0.1), disc("middle", {0, 0}, 0.1),
                             disc("right", {1.2, 0.0}, 0.1)};
  discs[0].velocity = {1.0, 0.0};
  discs[2].velocity = {-0.4, 0.0};
  const Simulation simulation = run(scene(setting, discs, 0.065, 0.0, 0.0), 3.0);
  constexpr double kTogether = 0.2;  // m/s, of the centre of mass
  return {(simulation.state().v.row(0).array() - kTogether).abs().maxCoeff(),
          simulation.totals().momentum.x() / (3.0 * kTogether) - 1.0,
          static_cast<double>(simulation.impact_count())};
}
constexpr StressFigure kCollapseFigures[] = {
    {"error of the common velocity", "m/s", 1e-11,
     "theory: e < 7 - 4√3: they go on together; the last impacts part them by some 1e-12 of their speed"},
    {"relative change of the momentum", "1", kPerImpact, "theory: impacts keep it"},
    {"impacts", "1"},
};

constexpr double kDropHeight = 1.0;  // m
constexpr double kDropTime = 5.0;    // s

// Five touching boxes in a stack, dropped on a floor; all elastic.
std::vector<double> drop_stack(const StressSetting& setting) {
  constexpr int kBoxes = 5;
  std::vector<Body> bodies = {half_plane("floor", {0, 0})};
  for (int i = 0; i < kBoxes; ++i)
    bodies.push_back(box(fmt::format("box-{}", i + 1), {0.0, kDropHeight + i + 0.5}, 1.0, 1.0));
  Simulation simulation(scene(setting, bodies, 1.0, 0.0));
  const double before = simulation.totals().energy();
  simulation.advance_to(kDropTime);
  return {(simulation.totals().energy() - before) / (kBoxes * kGravity * kDropHeight),
          static_cast<double>(simulation.impact_count())};
}
// Explicit Euler gains ½ m g² τ² in a flight of τ, so at most ½ m g² h T in all. If gravity is integrated
// exactly, only the error of the impacts is left, some hundred of them.
double falling_gain(const Method& method) {
  if (method.integrator != IntegratorId::kExplicitEuler) return 100.0 * kPerImpact;
  return 0.5 * kGravity * method.step * kDropTime / kDropHeight;
}
constexpr StressFigure kDropFigures[] = {
    {"change of the energy over that of the drop", "1", kNoLimit,
     "theory: elastic impacts keep it to 1e-12 each; explicit Euler's flight gains up to ½mg²hT", falling_gain},
    {"impacts", "1"},
};

constexpr StressCase kCases[] = {
    {"bullet", "a disc at 1000 radii a step between two walls without thickness", bullet, kBulletFigures},
    {"cradle-5", "Newton's cradle of 5 touching discs, e = 1", cradle_5, kCradleFigures},
    {"cradle-20", "Newton's cradle of 20 touching discs, e = 1", cradle_20, kCradleFigures},
    {"galperin", "Galperin's billiard with masses as 1 to 1e4", galperin, kGalperinFigures},
    {"inelastic-collapse", "three discs, e = 0.065, that collapse onto one another", inelastic_collapse,
     kCollapseFigures},
    {"drop-stack", "five touching boxes with e = 1 dropped by 1 m, for 5 s", drop_stack, kDropFigures},
};

}  // namespace

std::span<const StressCase> impacts() { return kCases; }

}  // namespace carom::stress
