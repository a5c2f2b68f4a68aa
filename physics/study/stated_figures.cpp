#include "physics/study/stated_figures.h"

#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "physics/check/measure_run.h"
#include "physics/observe/observables.h"
#include "physics/preset/preset.h"

namespace carom {

std::vector<StatedFigure> check_stated_figures(const Preset& preset, const Reference& reference, double until,
                                               const std::stop_token& stop) {
  Preset with_method = preset;
  with_method.method = reference.method;
  std::vector<Expectation> stated;
  for (const Expectation& e : preset.expect) {
    const bool of_this_run = e.settings.empty() && !e.over;
    if (e.reduction == Expectation::Reduction::kAt && of_this_run && e.time <= until) stated.push_back(e);
  }
  std::vector<StatedFigure> figures;
  const std::vector<double> values = measure_run(with_method, stated, stop);
  for (std::size_t i = 0; i < stated.size(); ++i) {
    const Expectation& e = stated[i];
    figures.push_back({std::abs(values[i] - e.value),
                       fmt::format("{}{}{} at t = {:.6g} s", e.observable, e.bodies.empty() ? "" : " of ",
                                   fmt::join(e.bodies, " and "), e.time),
                       std::string(find_observable(e.observable)->unit)});
  }
  return figures;
}

}  // namespace carom
