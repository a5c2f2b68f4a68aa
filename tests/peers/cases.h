#pragma once

#include "tests/peers/box_cases.h"
#include "tests/peers/disc_cases.h"

// All cases, written once, for the world of any engine.
namespace carom::peers {

template <World W>
std::vector<Case> cases() {
  constexpr double kStep = 1.0 / 60.0;
  const std::vector<double> both = {kStep, 0.25 * kStep};
  return {
      {"stack-20", both, [](double h) { return stack_case<W>(20, h); }},
      {"pyramid-20", both, [](double h) { return pyramid_case<W>(20, h); }},
      {"pyramid-40", both, [](double h) { return pyramid_case<W>(40, h); }},
      {"mass-ratio", both, [](double h) { return mass_ratio_case<W>(1e6, h); }},
      {"pile-1000", both, [](double h) { return pile_case<W>(1000, h); }},
      {"pile-5000", both, [](double h) { return pile_case<W>(5000, h); }},
      {"pile-10000", both, [](double h) { return pile_case<W>(10000, h); }},
      {"incline", both, [](double h) { return incline_case<W>(false, h); }},
      {"incline-turned", both, [](double h) { return incline_case<W>(true, h); }},
      {"slide-to-roll", both, [](double h) { return rolling_case<W>(3.0, 0.0, h); }},
      {"spinning-disc", both, [](double h) { return rolling_case<W>(0.0, 20.0, h); }},
      {"bounce", both, bounce_case<W>},
      {"bullet", both, bullet_case<W>},
      {"cradle-5", both, [](double h) { return cradle_case<W>(5, h); }},
      {"overlapping-start", both, overlapping_start_case<W>},
      {"galperin-100", {1e-3}, [](double h) { return galperin_case<W>(100.0, h); }},
      {"gas-1000", both, [](double h) { return gas_case<W>(1000, h); }},
  };
}

}  // namespace carom::peers
