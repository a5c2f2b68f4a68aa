#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <numbers>

#include "physics/run/run_setup.h"
#include "tests/hard_cases/stress_scenes.h"

// Rods: one whose tip jams on the floor, one that falls on it, a chain with a heavy end. Springs and drag.
namespace carom::stress {
namespace {

// A thin rod of 1 m and 1 kg that leans to the right at `angle` to the floor, its lower tip `height` above
// it.
Body leaning_rod(double angle, double height) {
  Body b = disc("rod", {0.0, height + 0.5 * std::sin(angle)}, 0.0);
  b.shape = Wall{1.0};
  b.angle = angle;
  return b;
}

// Its tip slides to the left on the floor, and friction presses it in: with tan θ = 2 no force of the floor
// is consistent if μ > 4/3 (Painlevé 1895). The solution is an impact without collision.
std::vector<double> painleve(const StressSetting& setting) {
  Body rod = leaning_rod(std::atan(2.0), 0.0);
  rod.velocity = {-3.0, 0.0};
  Simulation simulation(scene(setting, {half_plane("floor", {0, 0}), rod}, 0.0, 2.0));
  const auto [rise, overlap] = look_to(simulation, 2.0);
  return {rise, overlap};
}
constexpr std::string_view kStepOfEuler = "theory: what a step of explicit Euler gains in free fall";
constexpr StressFigure kPainleveFigures[] = {
    {"largest rise of energy in a step", "Mg²h²/2", kLargestRise, kStepOfEuler},
    {"largest overlap", "m", kRounding, "theory: rigid; 1e-9 m is rounding"},
};

std::vector<double> rod_tip(const StressSetting& setting) {
  Simulation simulation(scene(
      setting, {half_plane("floor", {0, 0}), leaning_rod(80.0 * std::numbers::pi / 180.0, 0.5)}, 0.5, 0.3));
  const auto [rise, overlap] = look_to(simulation, 5.0);
  return {rise, simulation.notices().gained, overlap};
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

// Σ m lᵖ of the beads and the end, where l is the distance along the chain: kg m, kg m².
double chain_moment(int power) {
  double sum = 0.0;
  for (int i = 1; i <= kRods; ++i)
    sum += (i == kRods ? kHeavyEnd : kBead) * std::pow(kChain * i / kRods, power);
  return sum;
}

// 30 rods end to end with a bead at each joint and a mass 1000 times a bead's at the end, released at this
// angle from the vertical.
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
// Semi-implicit Euler conserves v² + ω²x² - ωz xv of a small swing, z = ωh, so that the energy oscillates by
// z/2 of itself to either side. The chain swings nearly as one rod: by its modes, Σ E z/(2 - z) over Σ E, the
// bound for a very small swing is 1.0013 z/2. At 1° it is larger by terms of the square of the angle: so z is
// the limit.
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
// The beads oscillate across the pull of the heavy end, the fastest at 2√(Mg/(ml)) = 626/s: z = ω h is 0.65.
// Explicit Euler would multiply their energy by 1 + z² a step (see the case spring-z), so the Euler method
// here is the semi-implicit one. It takes the part of the rods' forces that grows with the square of the spin
// from the step's start. In a wide swing that feeds energy to the beads, faster with a longer step: there
// order 2 is needed.
constexpr IntegratorId kHungIntegrators[] = {IntegratorId::kSemiImplicitEuler, IntegratorId::kRk4};
constexpr IntegratorId kSwingIntegrators[] = {IntegratorId::kVelocityVerlet, IntegratorId::kRk4};
constexpr double kChainSteps[] = {kChainStep};

constexpr StressCase kRodCases[] = {
    {"painleve", "a rod whose tip slides so that friction 2 presses it in, tan θ = 2", painleve,
     kPainleveFigures},
    {"rod-tip", "a rod dropped on its tip, friction 0.3, e = 0.5", rod_tip, kTipFigures},
    {"chain-30", "30 rods with beads, 1000 times heavier at the end, let go at 1°", chain_30, kChainFigures,
     kHungIntegrators, kChainSteps},
    {"chain-30-swing", "the same let go at 30°", chain_30_swing, kChainFigures, kSwingIntegrators, kChainSteps},
};

// --- integrators on either side of their stability limits, against their stability functions

constexpr int kSteps = 20;
constexpr double kRate = 10.0;  // ω of the spring, b/m of the drag, 1/s
// Relative, for each step: some roundings of 1e-16.
constexpr double kStability = 1e-12;

// Energy after so many steps of the spring x'' = -ω²x over the initial energy, x = 1 and v = 0; z = ωh.
double spring_theory(IntegratorId integrator, double z, int steps) {
  switch (integrator) {
    case IntegratorId::kExplicitEuler:
      return std::pow(1.0 + z * z, steps);
    case IntegratorId::kRk4:
      return std::pow(1.0 - std::pow(z, 6) / 72.0 + std::pow(z, 8) / 576.0, steps);
    case IntegratorId::kSemiImplicitEuler: {
      // (x, v/ω) is multiplied by A = (1 - z², z; -z, 1) with det A = 1, so Aⁿ = s(n) A - s(n - 1) I with
      // s(n) = sin nθ/sin θ and cos θ = 1 - z²/2; beyond z = 2 sinh replaces sin, with signs.
      const double c = 1.0 - 0.5 * z * z;
      const auto ratio = [c](int n) {
        if (std::abs(c) < 1.0) return std::sin(n * std::acos(c)) / std::sin(std::acos(c));
        const double phi = std::acosh(-c);
        return (n % 2 == 0 ? -1.0 : 1.0) * std::sinh(n * phi) / std::sinh(phi);
      };
      const double x = ratio(steps) * (1.0 - z * z) - ratio(steps - 1);
      const double v = -ratio(steps) * z;
      return x * x + v * v;
    }
    default:
      return std::numeric_limits<double>::quiet_NaN();
  }
}

std::vector<double> spring_z(const StressSetting& setting) {
  RunSetup s = scene(setting, {disc("disc", {1.0, 0.0}, 0.1)}, 1.0, 0.0, 0.0);
  Spring& spring = s.scene.forces.springs.emplace_back();
  spring.body = "disc";
  spring.stiffness = kRate * kRate;
  Simulation simulation(s);
  const double before = simulation.totals().energy();
  simulation.advance_to(kSteps * setting.method.step);
  const auto steps = static_cast<int>(simulation.steps());  // fewer if the run is lost
  const double grown = simulation.totals().energy() / before;
  const double theory = spring_theory(setting.method.integrator, kRate * setting.method.step, steps);
  return {std::pow(grown / theory, 1.0 / steps) - 1.0, std::pow(grown, 1.0 / steps)};
}
constexpr StressFigure kSpringFigures[] = {
    {"error of the energy factor a step", "1", kStability,
     "theory: 1 + z² for explicit Euler; 1 - z⁶/72 + z⁸/576 for RK4 (stable to 2√2); powers of the matrix for "
     "semi-implicit Euler (stable to 2)"},
    {"energy factor a step", "1"},
};

// A body under F = -b v; z = b h/m. A step multiplies its velocity by R(-z).
std::vector<double> stiff_drag(const StressSetting& setting) {
  Body body = disc("disc", {0, 0}, 0.1);
  body.velocity = {1.0, 0.0};
  RunSetup s = scene(setting, {body}, 1.0, 0.0, 0.0);
  s.scene.forces.linear_drag = kRate;
  const Simulation simulation = run(s, kSteps * setting.method.step);
  const auto steps = static_cast<double>(simulation.steps());  // fewer if the run is lost
  const double z = kRate * setting.method.step;
  const double factor = setting.method.integrator == IntegratorId::kRk4
                            ? 1.0 - z + z * z / 2.0 - z * z * z / 6.0 + z * z * z * z / 24.0
                            : 1.0 - z;
  const double grown = simulation.state().v(0, 0);
  return {std::pow(std::abs(grown), 1.0 / steps) / std::abs(factor) - 1.0,
          std::pow(std::abs(grown), 1.0 / steps)};
}
constexpr StressFigure kDragFigures[] = {
    {"error of the velocity factor a step", "1", kStability,
     "theory: |1 - z| for explicit Euler (stable to 2); 1 - z + z²/2 - z³/6 + z⁴/24 for RK4 (stable to 2.785)"},
    {"velocity factor a step", "1"},
};

// z = 1.9, 2.1, 2.7 and 2.9.
constexpr double kZSteps[] = {0.19, 0.21, 0.27, 0.29};
constexpr IntegratorId kSpringIntegrators[] = {IntegratorId::kExplicitEuler, IntegratorId::kSemiImplicitEuler,
                                               IntegratorId::kRk4};

constexpr StressCase kIntegratorCases[] = {
    {"spring-z", "a spring at z = ωh of 1.9, 2.1, 2.7 and 2.9; ω = 10/s", spring_z, kSpringFigures,
     kSpringIntegrators, kZSteps},
    {"stiff-drag", "linear drag at z = bh/m of 1.9, 2.1, 2.7 and 2.9; b/m = 10/s", stiff_drag, kDragFigures,
     kEulerAndRk4, kZSteps},
};

}  // namespace

std::span<const StressCase> rods() { return kRodCases; }

std::span<const StressCase> integrators() { return kIntegratorCases; }

}  // namespace carom::stress
