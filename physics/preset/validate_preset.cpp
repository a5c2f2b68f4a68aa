#include "physics/preset/validate_preset.h"

#include <fmt/format.h>

#include "physics/preset/preset.h"
#include "physics/scene/value_checks.h"

namespace carom {
namespace {

void check_sweep(const std::string& at, const Sweep& sweep) {
  using Reduction = Sweep::Reduction;
  const bool parabola =
      sweep.reduction == Reduction::kWhereMaximum || sweep.reduction == Reduction::kWhereMinimum;
  const std::size_t least = parabola ? 3 : sweep.reduction == Reduction::kExponent ? 2 : 1;
  if (sweep.values.size() < least || sweep.values.size() > kMostSweepValues) {
    refuse_by(Rule::kOrderOfNumbers, at + "/values", fmt::format("{} values", sweep.values.size()),
              fmt::format("{} to {} for this reduction", least, kMostSweepValues));
  }
  for (std::size_t i = 0; i < sweep.values.size(); ++i) {
    const std::string place = fmt::format("{}/values/{}", at, i);
    check_range(place, sweep.values[i], any_number(""));
    if (sweep.reduction == Reduction::kExponent && !(sweep.values[i] >= kLeastPositive))
      refuse_by(Rule::kOrderOfNumbers, place, fmt::format("{}", sweep.values[i]), positive("").text());
    if (i > 0 && least > 1 && !(sweep.values[i] > sweep.values[i - 1]))
      refuse_by(Rule::kOrderOfNumbers, place, fmt::format("{}", sweep.values[i]),
                "values in rising order for this reduction");
  }
}

void check_expectation(const std::string& at, const Expectation& e, const NamedBodies& bodies) {
  for (std::size_t k = 0; k < e.bodies.size(); ++k)
    (void)named_body(bodies, fmt::format("{}/bodies/{}", at, k), e.bodies[k]);
  check_range(at + "/tolerance", e.tolerance, from_zero(""));
  check_range(at + "/time", e.time, from_zero("s"));
  check_range(at + "/from", e.from, from_zero("s"));
  if (e.until) {
    check_range(at + "/until", *e.until, from_zero("s"));
    check_order(at + "/until", *e.until, e.from, "from");
  }
  if (e.reduction == Expectation::Reduction::kAtImpact && e.impact < 1)
    refuse_value(at + "/impact", fmt::format("{}", e.impact), "1, 2, ...");
  for (const Setting& s : e.settings) {
    check_range(fmt::format("{}/with {}", at, s.place), s.value, any_number(""));
  }
  if (e.over) check_sweep(at + "/over", *e.over);
}

void check_plot(const std::string& at, const Plot& plot, const NamedBodies& bodies) {
  const auto check = [&](const std::string& place, const QuantityName& quantity) {
    for (std::size_t k = 0; k < quantity.bodies.size(); ++k)
      (void)named_body(bodies, fmt::format("{}/bodies/{}", place, k), quantity.bodies[k]);
  };
  for (std::size_t i = 0; i < plot.y.size(); ++i) check(fmt::format("{}/y/{}", at, i), plot.y[i]);
  if (plot.x) check(at + "/x", *plot.x);
}

// Their number only.
void check_plots(const std::vector<Plot>& plots) {
  check_count("/plots", plots.size(), kMostPlots, "plots");
  std::size_t curves = 0;
  for (std::size_t i = 0; i < plots.size(); ++i) {
    curves += plots[i].y.size();
    check_count(fmt::format("/plots/{}/y", i), plots[i].y.size(), kMostPlotCurves, "curves");
    if (curves > kMostCurvesInAll) {
      refuse_by(Rule::kCountInAll, fmt::format("/plots/{}/y", i),
                fmt::format("{} curves in all plots so far", curves),
                fmt::format("up to {}", kMostCurvesInAll));
    }
  }
}

}  // namespace

void validate(const Preset& preset, const ForcePlaces& places) {
  check_method("/method", preset.method);
  check_count("/compare", preset.compare.size(), kMostCompared, "methods");
  for (std::size_t i = 0; i < preset.compare.size(); ++i) {
    check_method(fmt::format("/compare/{}", i), preset.compare[i]);
  }
  check_range("/duration", preset.duration, positive("s"));
  if (preset.saved && !from_zero("s").contains(preset.saved->time))
    refuse_by(Rule::kSavedRun, "/state/time", fmt::format("{}", preset.saved->time), from_zero("s").text());
  validate(preset.scene, places, {start_time(preset.saved), state_belongs(preset.scene, preset.saved)});
  check_integrator("/method", preset.scene, preset.method);
  for (std::size_t i = 0; i < preset.compare.size(); ++i) {
    check_integrator(fmt::format("/compare/{}", i), preset.scene, preset.compare[i]);
  }
  const std::vector<Body> all = all_bodies(preset.scene);
  NamedBodies bodies;
  for (const Body& b : all) bodies.emplace(b.name, &b);
  check_count("/expect", preset.expect.size(), kMostExpectations, "expectations");
  for (std::size_t i = 0; i < preset.expect.size(); ++i)
    check_expectation(fmt::format("/expect/{}", i), preset.expect[i], bodies);
  check_plots(preset.plots);
  for (std::size_t i = 0; i < preset.plots.size(); ++i)
    check_plot(fmt::format("/plots/{}", i), preset.plots[i], bodies);
  if (preset.view) {
    check_vector("/view/center", preset.view->center, "m");
    check_range("/view/width", preset.view->width, positive("m"));
  }
}

void validate(const Preset& preset) { validate(preset, written_places(preset.scene.forces)); }

}  // namespace carom
