#include "widgets/plot_table.h"

namespace carom {

std::span<const PlotKind> plot_table() {
  static const std::vector<PlotKind> table = {
      {"energy",
       "Energy",
       "J",
       {{"kinetic", [](const Sample& s) { return s.totals.kinetic(); }},
        {"potential", [](const Sample& s) { return s.totals.potential; }},
        {"total", [](const Sample& s) { return s.totals.energy(); }}}},
      {"momentum",
       "Momentum",
       "kg·m/s",
       {{"x", [](const Sample& s) { return s.totals.momentum.x(); }},
        {"y", [](const Sample& s) { return s.totals.momentum.y(); }}}},
      {"impulse",
       "Contact impulses",
       "N·s",
       {{"normal", nullptr, [](const ImpactRecord& impact) { return impact.normal_impulse; }}}},
  };
  return table;
}

}  // namespace carom
