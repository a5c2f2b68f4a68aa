#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

#include "tests/hard_cases/stress_scenes.h"

// Boxes, stones and dominoes that lean on each other.
namespace carom::stress {
namespace {

constexpr double kMillimetres = 1e3;  // of a metre
constexpr double kBoxFriction = 0.6;
constexpr double kStanding = 10.0;  // s

constexpr std::string_view kTuned40 =
    "peer: Box2D v3 tuned (64 sub-steps; 480 Hz) squashes a stack of 40 by 2.1 mm";
constexpr std::string_view kAtRest =
    "theory: it stands inside the friction cone and does not move; 1e-6 m is rest here";

// A stack of boxes of 1 m, from the lowest up: how far the top sinks, how far any box moves sideways, and the
// penetration at the end.
std::vector<double> stand(const StressSetting& setting, const std::vector<double>& masses) {
  std::vector<Body> bodies = {half_plane("floor", {0, 0})};
  for (std::size_t i = 0; i < masses.size(); ++i) {
    bodies.push_back(
        box(fmt::format("box-{}", i + 1), {0.0, static_cast<double>(i) + 0.5}, 1.0, 1.0, masses[i]));
  }
  const Simulation simulation = run(scene(setting, bodies, 0.0, kBoxFriction), kStanding);
  const Eigen::Matrix3Xd& q = simulation.state().q;
  return {kMillimetres * (static_cast<double>(masses.size()) - 0.5 - q(1, q.cols() - 1)),
          kMillimetres * q.row(0).cwiseAbs().maxCoeff(), kMillimetres * penetrations_of(simulation).largest};
}

constexpr StressFigure kStackFigures[] = {
    {"sag of the top", "mm", 2.1, kTuned40},
    {"lean", "mm", kMillimetres* kRest, kAtRest},
    {"largest overlap", "mm", 2.1, kTuned40},
};

std::vector<double> stack_20(const StressSetting& s) { return stand(s, std::vector<double>(20, 1.0)); }
std::vector<double> stack_40(const StressSetting& s) { return stand(s, std::vector<double>(40, 1.0)); }

std::vector<double> stack_heavy_top(const StressSetting& s) {
  std::vector<double> masses(10, 1.0);
  masses.back() = 1000.0;
  return stand(s, masses);
}

constexpr std::string_view kTunedHeavy =
    "peer: Box2D v3 tuned (64 sub-steps; 480 Hz) is squashed by 23 mm; untuned all peers fall";
constexpr StressFigure kHeavyTopFigures[] = {
    {"sag of the top", "mm", 23.0, kTunedHeavy},
    {"lean", "mm", kMillimetres* kRest, kAtRest},
    {"largest overlap", "mm", 23.0, kTunedHeavy},
};

std::vector<double> mass_ratio(const StressSetting& s) { return stand(s, {1.0, 1e6}); }

constexpr std::string_view kNoMass =
    "theory: at rest the impulses meet the weights whatever their ratio; 1e-6 m is rest here";
constexpr StressFigure kMassRatioFigures[] = {
    {"sag of the top", "mm", kMillimetres* kRest, kNoMass},
    {"lean", "mm", kMillimetres* kRest, kAtRest},
    {"largest overlap", "mm", kMillimetres* kRest, kNoMass},
};

constexpr int kPyramidBase = 20;

std::vector<double> pyramid_20(const StressSetting& setting) {
  std::vector<Body> bodies = {half_plane("floor", {0, 0})};
  for (int row = 0; row < kPyramidBase; ++row) {
    for (int i = 0; i < kPyramidBase - row; ++i) {
      const Vec2 place(i - 0.5 * (kPyramidBase - row - 1), row + 0.5);
      bodies.push_back(box(fmt::format("box-{}-{}", row + 1, i + 1), place, 1.0, 1.0));
    }
  }
  const Vec2 start = bodies.back().position;
  const Simulation simulation = run(scene(setting, bodies, 0.0, kBoxFriction), kStanding);
  const Vec2 moved = simulation.state().position(simulation.state().size() - 1) - start;
  return {-kMillimetres * moved.y(), kMillimetres * moved.x(),
          kMillimetres * penetrations_of(simulation).largest};
}

constexpr StressFigure kPyramidFigures[] = {
    {"sag of the top", "mm", 29.0, "peer: Box2D v3 at 60 Hz sinks by 29 mm"},
    {"sideways drift of the top", "mm", 2.3, "peer: Box2D v3 at 60 Hz drifts by 2.3 mm"},
    {"largest overlap", "mm", 3.8, "peer: Box2D v3 at 60 Hz overlaps by 3.8 mm"},
};

// Half a ring of equal stones whose joints point to its centre.
std::vector<double> arch(const StressSetting& setting) {
  constexpr int kStones = 11;
  constexpr double kInner = 1.7;  // m
  constexpr double kOuter = 2.3;  // m
  std::vector<Body> bodies = {half_plane("ground", {0, 0})};
  const auto at = [](double radius, int joint) -> Vec2 {
    const double angle = std::numbers::pi * joint / kStones;
    // The lowest stones stand flat: sin(pi) is not 0 in doubles.
    return {radius * std::cos(angle), joint == kStones ? 0.0 : radius * std::sin(angle)};
  };
  for (int i = 0; i < kStones; ++i) {
    bodies.push_back(plate(fmt::format("stone-{}", i + 1),
                           {at(kInner, i), at(kOuter, i), at(kOuter, i + 1), at(kInner, i + 1)}, 1.0));
  }
  constexpr int kKeystone = 1 + kStones / 2;
  const double start = bodies[kKeystone].position.y();
  const Simulation simulation = run(scene(setting, bodies, 0.0, kBoxFriction), kStanding);
  return {kMillimetres * (start - simulation.state().q(1, kKeystone)),
          kMillimetres * penetrations_of(simulation).largest};
}

constexpr std::string_view kHeyman =
    "theory: a half ring thicker than 0.1075 of its mean radius stands (Heyman 1969); here 0.3; 1e-6 m is rest";
constexpr StressFigure kArchFigures[] = {
    {"sag of the keystone", "mm", kMillimetres* kRest, kHeyman},
    {"largest overlap", "mm", kMillimetres* kRest, kHeyman},
};

std::vector<double> dominoes(const StressSetting& setting) {
  constexpr int kCount = 15;
  constexpr double kHeight = 1.0;  // m
  constexpr double kThickness = 0.1;
  constexpr double kSpacing = 0.5;
  std::vector<Body> bodies = {half_plane("table", {0, 0})};
  for (int i = 0; i < kCount; ++i) {
    bodies.push_back(box(fmt::format("domino-{}", i + 1), {kSpacing * i, 0.5 * kHeight}, kThickness, kHeight));
  }
  // Turns about its lower right edge with twice the energy that lifts it over the edge: ½ I ω² with the
  // moment of inertia d²/3 about the edge, against g (d - h)/2 (experiment 23 of the presets: 3 g (d -
  // h)/d²).
  const double d = std::hypot(kHeight, kThickness);
  const double spin = std::sqrt(2.0 * 3.0 * kGravity * (d - kHeight) / (d * d));
  bodies[1].spin = -spin;
  bodies[1].velocity = {0.5 * kHeight * spin, 0.5 * kThickness * spin};
  Simulation simulation(scene(setting, bodies, 0.0, kBoxFriction));
  EnergyRise rise(simulation);
  simulation.advance_to(kStanding, [&] { rise.look(simulation); });
  double standing = 0.0;
  constexpr double kUpright = std::numbers::pi / 6.0;
  for (int i = 1; i <= kCount; ++i) standing += simulation.state().q(2, i) > -kUpright ? 1.0 : 0.0;
  return {standing, rise.largest()};
}

constexpr StressFigure kDominoFigures[] = {
    {"left standing", "1", 0.0, "theory: each falls with more energy than the next needs to tip"},
    {"largest rise of energy in a step", "Mg²h²/2", kLargestRise,
     "theory: what a step of explicit Euler gains in free fall"},
};

constexpr StressCase kCases[] = {
    {"stack-20", "a stack of 20 boxes of 1 m for 10 s", stack_20, kStackFigures},
    {"stack-40", "a stack of 40 boxes of 1 m for 10 s", stack_40, kStackFigures},
    {"stack-heavy-top", "ten boxes, the highest 1000 times heavier, for 10 s", stack_heavy_top,
     kHeavyTopFigures},
    {"mass-ratio", "a box of 1 kg under one of 1e6 kg for 10 s", mass_ratio, kMassRatioFigures},
    {"pyramid-20", "a pyramid of touching boxes of 1 m, 20 in the lowest row, for 10 s", pyramid_20,
     kPyramidFigures},
    {"arch", "half a ring of 11 stones, friction 0.6, for 10 s", arch, kArchFigures},
    {"dominoes", "15 dominoes, the first tipped with twice the energy it needs", dominoes, kDominoFigures},
};

}  // namespace

std::span<const StressCase> stacks() { return kCases; }

}  // namespace carom::stress
