#include <algorithm>
#include <gtest/gtest.h>
#include <vector>

#include "physics/ledger/totals.h"
#include "physics/preset/preset.h"
#include "physics/preset/preset_file.h"
#include "physics/run/simulation.h"
#include "tests/support/draws.h"
#include "tests/support/effort.h"
#include "tests/support/source_folder.h"

// Discs that roll on between others get into wedges in which friction holds them at any pressure. They get no
// more than motion asks for: energy does not grow, and no more of it is booked as lost than is.
namespace carom {
namespace {

struct Pile {
  double static_friction, kinetic_friction, restitution;
  double rolling_resistance;
  IntegratorId integrator;
  double step;
};

// With forces that rounding had built up, from 362 J to 5e5 J were booked as friction in one step.
std::vector<Pile> piles() {
  std::vector<Pile> all = {{0.29, 0.21, 0.3, 0.01, IntegratorId::kDormandPrince, 0.01},
                           {0.52, 0.46, 0.77, 0.0, IntegratorId::kDormandPrince, 1.0 / 60.0},
                           {0.64, 0.56, 0.42, 0.01, IntegratorId::kVelocityVerlet, 1.0 / 60.0}};
  test::Draws draw(5);
  for (int k = test::by_effort(0, 0, 40); k > 0; --k) {
    Pile pile{
        draw.between(0.1, 0.9), draw.between(0.4, 1.0), draw.between(0.0, 0.8), 0.0, IntegratorId::kRk4, 0.01};
    pile.kinetic_friction *= pile.static_friction;
    all.push_back(pile);
  }
  return all;
}

TEST(JammedDiscs, BookWhatTheyLose) {
  for (const Pile& pile : piles()) {
    Preset preset = read_preset(test::preset_file("piles/pile-at-rest.json"));
    Material& wood = preset.scene.materials.front();
    wood.rolling_resistance = pile.rolling_resistance;
    wood.static_friction = pile.static_friction;
    wood.kinetic_friction = pile.kinetic_friction;
    wood.restitution = pile.restitution;
    preset.method.integrator = pile.integrator;
    preset.method.impacts = ImpactsId::kLocated;
    preset.method.step = pile.step;
    Simulation run(setup_of(preset));
    double energy = run.totals().energy();
    const double at_first = energy;
    double gained = 0.0;  // J, in a step
    run.advance_to(1.0, [&] {
      gained = std::max(gained, run.totals().energy() - energy);
      energy = run.totals().energy();
    });
    const Ledger ledger = run.ledger();
    const double booked = ledger.lost_to_friction + ledger.lost_to_restitution + ledger.lost_to_rolling;
    EXPECT_LT(gained, 1e-3) << pile.static_friction;
    EXPECT_LT(booked - (at_first - energy), 1.0) << pile.static_friction;
  }
}

}  // namespace
}  // namespace carom
