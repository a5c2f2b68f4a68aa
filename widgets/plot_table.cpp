#include "widgets/plot_table.h"

namespace carom {
namespace {

// Sums over a laboratory's bodies that should be zero show rounding below this part of what they sum.
constexpr Rounding kValues{1e-9, 1.0};
// A drift is looked at down to rounding itself.
constexpr Rounding kDrift{1e-15, 1e-15};

}  // namespace

std::span<const PlotKind> plot_table() {
  static const std::vector<PlotKind> table = {
      {"energy",
       "Energy",
       "J",
       "Energy of all bodies that move freely",
       &Scales::energy,
       kValues,
       {{.label = "kinetic", .of_sample = [](const Sample& s) { return s.totals.kinetic(); }},
        {.label = "potential", .of_sample = [](const Sample& s) { return s.totals.potential; }},
        {.label = "total", .of_sample = [](const Sample& s) { return s.totals.energy(); }, .sum = true}}},
      {"momentum",
       "Momentum",
       "kg·m/s",
       "Momentum of all bodies that move freely",
       &Scales::momentum,
       kValues,
       {{.label = "x", .of_sample = [](const Sample& s) { return s.totals.momentum.x(); }},
        {.label = "y", .of_sample = [](const Sample& s) { return s.totals.momentum.y(); }}}},
      {"impulse",
       "Contact impulses",
       "N·s",
       "The normal impulse of each impact",
       &Scales::impulse,
       kValues,
       {{.label = "normal", .of_impact = [](const ImpactRecord& impact) { return impact.normal_impulse; }}}},
      {"ledger",
       "Ledger",
       "J",
       "Where the energy went since the start",
       &Scales::energy,
       kValues,
       {{.label = "restitution",
         .of_sample = [](const Sample& s) { return s.lost_to_restitution + s.lost_to_sticking; },
         .tip = "lost in impacts to restitution below 1, and where bodies stick together"},
        {.label = "friction",
         .of_sample = [](const Sample& s) { return s.lost_to_friction; },
         .tip = "lost to friction, in impacts and at contacts that last"},
        {.label = "drag",
         .of_sample = [](const Sample& s) { return s.lost_in_flight; },
         .tip = "lost to drag, to the dampers of springs, to rolling resistance and where strings jerk taut"},
        {.label = "put in",
         .of_sample = [](const Sample& s) { return s.put_in; },
         .tip = "put in by driven bodies, applied forces and the user, and by pushing overlaps apart"}}},
      {"drift",
       "Energy drift",
       "J",
       "Energy that the method itself gained or lost: what no entry of the ledger explains",
       &Scales::energy,
       kDrift,
       {{.label = "numerical", .of_sample = [](const Sample& s) { return s.drift; }}}},
      {"momentum_drift",
       "Momentum drift",
       "kg·m/s",
       "Momentum that the method itself gained or lost: what neither forces, walls nor the user explain",
       &Scales::momentum,
       kDrift,
       {{.label = "x", .of_sample = [](const Sample& s) { return s.momentum_drift.x(); }},
        {.label = "y", .of_sample = [](const Sample& s) { return s.momentum_drift.y(); }}}},
  };
  return table;
}

const std::vector<std::string>& default_plots() {
  static const std::vector<std::string> ids = {"energy", "momentum", "impulse"};
  return ids;
}

}  // namespace carom
