#include <cmath>
#include <limits>

#include "physics/stress/stress_cases.h"
#include "physics/stress/stress_scenes.h"
#include "physics/world/run_setup.h"

// Integrators on either side of where they are stable, beside their stability functions.
namespace carom::stress {
namespace {

constexpr int kSteps = 20;
constexpr double kRate = 10.0;  // ω of the spring, b/m of the drag, 1/s
// Relative, a step: some roundings of 1e-16 each.
constexpr double kStability = 1e-12;

// Energy after so many steps of the spring x'' = -ω²x over that at the start, x = 1 and v = 0; z = ωh.
double spring_theory(IntegratorId integrator, double z, int steps) {
  switch (integrator) {
    case IntegratorId::kExplicitEuler:
      return std::pow(1.0 + z * z, steps);
    case IntegratorId::kRk4:
      return std::pow(1.0 - std::pow(z, 6) / 72.0 + std::pow(z, 8) / 576.0, steps);
    case IntegratorId::kSemiImplicitEuler: {
      // (x, v/ω) is multiplied by A = (1 - z², z; -z, 1) with det A = 1, so Aⁿ = s(n) A - s(n - 1) I with
      // s(n) = sin nθ/sin θ and cos θ = 1 - z²/2; beyond z = 2 sinh takes the place of sin, with signs.
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
  const auto steps = static_cast<int>(simulation.steps());  // fewer where the run is lost
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
  Simulation simulation(s);
  simulation.advance_to(kSteps * setting.method.step);
  const auto steps = static_cast<double>(simulation.steps());  // fewer where the run is lost
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

constexpr StressCase kCases[] = {
    {"spring-z", "a spring at z = ωh of 1.9, 2.1, 2.7 and 2.9; ω = 10/s", spring_z, kSpringFigures,
     kSpringIntegrators, kZSteps},
    {"stiff-drag", "linear drag at z = bh/m of 1.9, 2.1, 2.7 and 2.9; b/m = 10/s", stiff_drag, kDragFigures,
     kEulerAndRk4, kZSteps},
};

}  // namespace

std::span<const StressCase> integrators() { return kCases; }

}  // namespace carom::stress
