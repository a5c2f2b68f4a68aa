#include "physics/dynamics/integrators/integrators.h"

#include <cmath>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "physics/preset/preset.h"
#include "physics/preset/preset_file.h"
#include "tests/support/fitted_order.h"
#include "tests/support/scenes.h"
#include "tests/support/source_folder.h"

namespace carom {
namespace {

using test::disc;
using test::fitted_order;
using test::preset_with;

State end_state(const Preset& s, const Method& m, double time) {
  Simulation run(setup_of(s));
  run.set_method(m);
  run.advance_to(time);
  return run.state();
}

double fitted_order(const Preset& s, Method m, const std::vector<double>& steps, const Vec2& exact, int body) {
  std::vector<double> errors;
  for (const double h : steps) {
    m.step = h;
    errors.push_back((end_state(s, m, 2.0).position(body) - exact).norm());
  }
  return fitted_order(steps, errors);
}

Preset preset(const std::string& file) { return read_preset(test::preset_file(file)); }

TEST(Integrators, SmoothOrderIsThatOfTheTable) {
  Preset s = preset_with({disc("d", {1.0, 0.0}, {0.0, 1.0}, 0.1, 0.5)});
  Spring spring;
  spring.body = "d";
  spring.anchor = {-0.1, 0.05};
  spring.stiffness = 40.0;
  spring.damping = 0.3;
  spring.rest_length = 0.3;
  s.scene.forces.springs = {spring};
  const Method fine{IntegratorId::kDormandPrince, ImpactsId::kLocated, ContactsId::kImpulse, 1.0 / 4096};
  const Vec2 exact = end_state(s, fine, 2.0).position(0);
  for (const IntegratorChoice& choice : kIntegrators) {
    if (choice.order == 0 || choice.adaptive) continue;
    const std::vector<double> steps = choice.order > 1
                                          ? std::vector{1.0 / 64, 1.0 / 128, 1.0 / 256, 1.0 / 512}
                                          : std::vector{1.0 / 4096, 1.0 / 8192, 1.0 / 16384, 1.0 / 32768};
    const double order =
        fitted_order(s, {choice.id, ImpactsId::kLocated, ContactsId::kImpulse, 0.0}, steps, exact, 0);
    EXPECT_NEAR(order, choice.order, 0.3) << choice.name;
  }
}

// The finding that everything rests on: only located impacts keep the order.
TEST(Integrators, OrderThroughImpacts) {
  const Preset s = preset("numerical-methods/drag-projectile.json");
  const int body = 3;
  const Method fine{IntegratorId::kRk4, ImpactsId::kLocated, ContactsId::kImpulse, 1.0 / 4096};
  const Vec2 exact = end_state(s, fine, 2.0).position(body);
  EXPECT_NEAR(exact.x(), s.expect[0].value, 1e-13);
  EXPECT_NEAR(exact.y(), s.expect[1].value, 1e-13);
  const auto order = [&](IntegratorId integrator, ImpactsId impacts, const std::vector<double>& steps) {
    return fitted_order(s, {integrator, impacts, ContactsId::kImpulse, 0.0}, steps, exact, body);
  };
  std::vector<double> coarse;
  std::vector<double> small;
  for (const int n : {32, 64, 128, 256, 512}) coarse.push_back(1.0 / n);
  for (const int n : {512, 1024, 2048, 4096, 8192, 16384, 32768}) small.push_back(1.0 / n);
  const double rk4 = order(IntegratorId::kRk4, ImpactsId::kLocated, coarse);
  const double euler = order(IntegratorId::kExplicitEuler, ImpactsId::kLocated, small);
  const double semi = order(IntegratorId::kSemiImplicitEuler, ImpactsId::kLocated, small);
  EXPECT_GT(rk4, 3.7);
  EXPECT_LT(rk4, 4.3);
  EXPECT_NEAR(euler, 1.0, 0.1);
  EXPECT_NEAR(semi, 1.0, 0.15);
  for (const IntegratorChoice& choice : kIntegrators) {
    if (choice.order == 0 || choice.adaptive) continue;
    const double at_end = order(choice.id, ImpactsId::kStepEnd, small);
    EXPECT_LT(at_end, 1.5) << choice.name;
    EXPECT_GT(at_end, 0.6) << choice.name;
  }
}

// Energy of the spring box after n steps over that before, for z = ωh.
double energy_ratio(IntegratorId id, double z, int steps) {
  Preset s = preset("numerical-methods/spring-box.json");
  s.scene.bodies = {s.scene.bodies[2]};  // without its walls
  s.method = {id, ImpactsId::kLocated, ContactsId::kImpulse, z / 5.0};
  Simulation run(setup_of(s));
  const double before = run.totals().energy();
  for (int i = 0; i < steps; ++i) run.step();
  return run.totals().energy() / before;
}

TEST(Integrators, SpringBoxEnergyFactors) {
  for (const double z : {0.3, 1.0, 1.9}) {
    EXPECT_NEAR(energy_ratio(IntegratorId::kExplicitEuler, z, 20) / std::pow(1.0 + z * z, 20), 1.0, 1e-12);
    const double factor = 1.0 - std::pow(z, 6) / 72.0 + std::pow(z, 8) / 576.0;
    EXPECT_NEAR(energy_ratio(IntegratorId::kRk4, z, 20) / std::pow(factor, 20), 1.0, 1e-12);
    // Semi-implicit Euler keeps v² + ω²x² - zωvx exactly (start: v = 0), so the energy sways about it.
    const double ratio = energy_ratio(IntegratorId::kSemiImplicitEuler, z, 1000);
    EXPECT_GT(ratio, 1.0 / (1.0 + z / 2.0) - 1e-9);
    EXPECT_LT(ratio, 1.0 / (1.0 - z / 2.0) + 1e-9);
    // Velocity Verlet keeps v² + ω²x²(1 - z²/4).
    for (int steps = 1000; steps < 1010; ++steps) {
      const double verlet = energy_ratio(IntegratorId::kVelocityVerlet, z, steps);
      EXPECT_GT(verlet, 1.0 - z * z / 4.0 - 1e-9);
      EXPECT_LT(verlet, 1.0 + 1e-9);
    }
  }
}

TEST(Integrators, StabilityLimits) {
  EXPECT_LT(energy_ratio(IntegratorId::kSemiImplicitEuler, 1.99, 300), 250.0);
  EXPECT_GT(energy_ratio(IntegratorId::kSemiImplicitEuler, 2.01, 300), 1e6);
  EXPECT_LT(energy_ratio(IntegratorId::kVelocityVerlet, 1.99, 300), 1.0);
  EXPECT_GT(energy_ratio(IntegratorId::kVelocityVerlet, 2.01, 300), 1e6);
  EXPECT_LT(energy_ratio(IntegratorId::kRk4, 2.82, 300), 1.0);
  EXPECT_GT(energy_ratio(IntegratorId::kRk4, 2.84, 300), 1.0);
  EXPECT_GT(energy_ratio(IntegratorId::kExplicitEuler, 0.1, 300), 10.0);
}

}  // namespace
}  // namespace carom
