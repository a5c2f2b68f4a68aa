#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

#include "physics/stress/stress_cases.h"
#include "physics/stress/stress_scenes.h"
#include "physics/world/run_setup.h"

// Rods: one whose tip sticks into the floor, one that falls on it, a chain with a heavy end.
namespace carom::stress {
namespace {

// A thin rod of 1 m and 1 kg that leans to the right by `angle` from the floor, its lower tip `height` above
// it.
Body leaning_rod(double angle, double height) {
  Body b;
  b.name = "rod";
  b.shape = Wall{1.0};
  b.position = {0.0, height + 0.5 * std::sin(angle)};
  b.angle = angle;
  b.mass = 1.0;
  return b;
}

// Its tip on the floor slides to the left, and friction presses it in: with tan θ = 2 no force of the floor is
// consistent if μ > 4/3 (Painlevé 1895). An impact without collision is the way out.
std::vector<double> painleve(const StressSetting& setting) {
  Body rod = leaning_rod(std::atan(2.0), 0.0);
  rod.velocity = {-3.0, 0.0};
  Simulation simulation(scene(setting, {half_plane("floor", {0, 0}), rod}, 0.0, 2.0));
  EnergyRise rise(simulation);
  double overlap = 0.0;
  simulation.advance_to(2.0, [&] {
    rise.look(simulation);
    overlap = std::max(overlap, penetrations_of(simulation).largest);
  });
  return {rise.largest(), overlap};
}
constexpr std::string_view kStepOfEuler = "theory: what a step of explicit Euler gains in free fall";
constexpr StressFigure kPainleveFigures[] = {
    {"largest rise of energy in a step", "Mg²h²/2", kLargestRise, kStepOfEuler},
    {"largest overlap", "m", kRounding, "theory: rigid; 1e-9 m is rounding"},
};

std::vector<double> rod_tip(const StressSetting& setting) {
  Simulation simulation(scene(
      setting, {half_plane("floor", {0, 0}), leaning_rod(80.0 * std::numbers::pi / 180.0, 0.5)}, 0.5, 0.3));
  EnergyRise rise(simulation);
  double overlap = 0.0;
  simulation.advance_to(5.0, [&] {
    rise.look(simulation);
    overlap = std::max(overlap, penetrations_of(simulation).largest);
  });
  return {rise.largest(), simulation.notices().gained, overlap};
}
constexpr StressFigure kTipFigures[] = {
    {"largest rise of energy in a step", "Mg²h²/2", kLargestRise, kStepOfEuler},
    {"energy gained by impacts", "J", 0.0, "theory: energetic restitution never gains (Stronge 1990)"},
    {"largest overlap", "m", kRounding, "theory: rigid; 1e-9 m is rounding"},
};

constexpr int kRods = 30;
constexpr double kChain = 3.0;              // m
constexpr double kBead = 1e-3;              // kg
constexpr double kHeavyEnd = 1.0;           // kg
constexpr double kChainStep = 1.0 / 960.0;  // s

// Σ m lᵖ of the beads and the end, l being the way along the chain: kg m, kg m².
double chain_moment(int power) {
  double sum = 0.0;
  for (int i = 1; i <= kRods; ++i)
    sum += (i == kRods ? kHeavyEnd : kBead) * std::pow(kChain * i / kRods, power);
  return sum;
}

// 30 rods end to end with a bead at each joint and a mass 1000 times a bead's at the end, let go at this angle
// from hanging down.
std::vector<double> chain(const StressSetting& setting, double angle) {
  constexpr double kLength = kChain / kRods;
  const Vec2 along(std::sin(angle), -std::cos(angle));
  RunSetup s = scene(setting, {}, 0.0, 0.0);
  for (int i = 1; i <= kRods; ++i) {
    Body bead = disc(fmt::format("bead-{}", i), kLength * i * along, 0.01, i == kRods ? kHeavyEnd : kBead);
    bead.group = "chain";
    Joint& rod = s.scene.joints.emplace_back();
    rod.body = bead.name;
    rod.length = kLength;
    if (i > 1) rod.to = s.scene.bodies.back().name;
    s.scene.bodies.push_back(bead);
  }
  Simulation simulation(s);
  const double before = simulation.totals().energy();
  double stretch = 0.0;
  double drift = 0.0;
  simulation.advance_to(5.0, [&] {
    Vec2 end = Vec2::Zero();
    for (int i = 0; i < kRods; ++i) {
      const Vec2 next = simulation.state().position(i);
      stretch = std::max(stretch, std::abs((next - end).norm() / kLength - 1.0));
      end = next;
    }
    drift = std::max(drift, std::abs(simulation.totals().energy() - before));
  });
  return {stretch, drift / (kGravity * chain_moment(1) * (1.0 - std::cos(angle)))};
}
std::vector<double> chain_30(const StressSetting& s) { return chain(s, std::numbers::pi / 180.0); }
std::vector<double> chain_30_swing(const StressSetting& s) { return chain(s, std::numbers::pi / 6.0); }
// Semi-implicit Euler keeps v² + ω²x² - ωz xv of a small swing, z = ωh, so that the energy sways by z/2 of
// itself to either side. The chain swings nearly as one rod: by its modes, Σ E z/(2 - z) over Σ E, the bound
// for a very small swing is 1.0013 z/2. At 1° it is larger than that by some squares of the angle: so z is the
// limit.
double pendulum_sway(const Method& method) {
  return std::sqrt(kGravity * chain_moment(1) / chain_moment(2)) * method.step;
}
constexpr StressFigure kChainFigures[] = {
    {"largest relative error of a rod's length", "1", kRounding, "theory: rigid; 1e-9 is rounding"},
    {"largest change of the energy over that of the swing", "1", kNoLimit,
     "theory: under semi-implicit Euler a pendulum's energy sways by z/2 = √(g/L) h/2 of itself; z is "
     "allowed",
     pendulum_sway},
};
// The beads swing across the pull of the heavy end, the fastest at 2√(Mg/(ml)) = 626/s: z = ω h is 0.65.
// Explicit Euler would multiply their energy by 1 + z² a step (see the case spring-z); so Euler is the
// semi-implicit one. That takes the part of the rods' forces which grows with the square of the spin from the
// step's start, which feeds the beads in a wide swing, the faster the longer the step: there an order 2 is
// needed.
constexpr IntegratorId kHungIntegrators[] = {IntegratorId::kSemiImplicitEuler, IntegratorId::kRk4};
constexpr IntegratorId kSwingIntegrators[] = {IntegratorId::kVelocityVerlet, IntegratorId::kRk4};
constexpr double kChainSteps[] = {kChainStep};

constexpr StressCase kCases[] = {
    {"painleve", "a rod whose tip slides so that friction 2 presses it in, tan θ = 2", painleve,
     kPainleveFigures},
    {"rod-tip", "a rod dropped on its tip, friction 0.3, e = 0.5", rod_tip, kTipFigures},
    {"chain-30", "30 rods with beads, 1000 times heavier at the end, let go at 1°", chain_30, kChainFigures,
     kHungIntegrators, kChainSteps},
    {"chain-30-swing", "the same let go at 30°", chain_30_swing, kChainFigures, kSwingIntegrators, kChainSteps},
};

}  // namespace

std::span<const StressCase> rods() { return kCases; }

}  // namespace carom::stress
