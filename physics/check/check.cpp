#include "physics/check/check.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

#include "physics/check/measure_run.h"
#include "physics/math/least_squares.h"
#include "physics/math/parallel.h"
#include "physics/model/needs.h"
#include "physics/observe/observables.h"
#include "physics/preset/names.h"
#include "physics/preset/preset.h"
#include "physics/preset/preset_file.h"

namespace carom {
namespace {

using Reduction = Expectation::Reduction;

// x of the vertex of the parabola through three points.
double vertex(double x0, double y0, double x1, double y1, double x2, double y2) {
  const double a = (x1 - x0) * (y1 - y2);
  const double b = (x1 - x2) * (y1 - y0);
  if (a == b) return x1;  // on a straight line
  return x1 - 0.5 * ((x1 - x0) * a - (x1 - x2) * b) / (a - b);
}

// x at the largest y, by a parabola; at an end of the sweep it is the end itself.
double where_largest(const std::vector<double>& x, const std::vector<double>& y) {
  const auto i = static_cast<std::size_t>(std::max_element(y.begin(), y.end()) - y.begin());
  if (i == 0 || i + 1 == y.size()) return x[i];
  return vertex(x[i - 1], y[i - 1], x[i], y[i], x[i + 1], y[i + 1]);
}

// Slope of ln y over ln x by least squares; NaN if some y is not positive.
double exponent(const std::vector<double>& x, const std::vector<double>& y) {
  std::vector<Vec2> points;
  for (std::size_t i = 0; i < x.size(); ++i) points.emplace_back(std::log(x[i]), std::log(y[i]));
  const double slope = fit_line(points).slope;
  return std::isfinite(slope) ? slope : std::numeric_limits<double>::quiet_NaN();
}

double reduced(const Sweep& sweep, std::vector<double> y) {
  if (std::any_of(y.begin(), y.end(), [](double v) { return std::isnan(v); }))
    return std::numeric_limits<double>::quiet_NaN();
  switch (sweep.reduction) {
    case Sweep::Reduction::kMean: {
      double sum = 0.0;
      for (const double v : y) sum += v;
      return sum / static_cast<double>(y.size());
    }
    case Sweep::Reduction::kMaximum:
      return *std::max_element(y.begin(), y.end());
    case Sweep::Reduction::kMinimum:
      return *std::min_element(y.begin(), y.end());
    case Sweep::Reduction::kWhereMaximum:
      return where_largest(sweep.values, y);
    case Sweep::Reduction::kWhereMinimum:
      for (double& v : y) v = -v;
      return where_largest(sweep.values, y);
    case Sweep::Reduction::kExponent:
      return exponent(sweep.values, y);
  }
  return std::numeric_limits<double>::quiet_NaN();
}

// The unit of a slope over time.
std::string per_second(std::string_view unit) {
  static constexpr auto kSpecial = std::to_array<std::pair<std::string_view, std::string_view>>(
      {{"s", "1"}, {"m/s", "m/s²"}, {"rad/s", "rad/s²"}, {"J", "W"}, {"N s", "N"}, {"kg m²/s", "N m"}});
  for (const auto& [of, rate] : kSpecial) {
    if (of == unit) return std::string(rate);
  }
  return fmt::format("{}/s", unit);
}

std::string unit_of(const Expectation& e) {
  if (e.over) {
    using enum Sweep::Reduction;
    if (e.over->reduction == kExponent) return "1";
    if (e.over->reduction == kWhereMaximum || e.over->reduction == kWhereMinimum) return "";
  }
  if (e.reduction == Reduction::kCount) return "1";
  const std::string_view unit = find_observable(e.observable)->unit;
  return e.reduction == Reduction::kFit ? per_second(unit) : std::string(unit);
}

// "/bodies/0/mass" as "mass of ball", other places without the leading slash.
std::string place_text(const std::string& place, const Preset& preset) {
  constexpr std::string_view kBodies = "/bodies/";
  if (place.starts_with(kBodies)) {
    const std::size_t slash = place.find('/', kBodies.size());
    const int index = std::atoi(place.c_str() + kBodies.size());
    if (slash != std::string::npos && index >= 0 &&
        static_cast<std::size_t>(index) < preset.scene.bodies.size())
      return fmt::format("{} of {}", place.substr(slash + 1),
                         preset.scene.bodies[static_cast<std::size_t>(index)].name);
  }
  return place.substr(place.starts_with('/') ? 1 : 0);
}

}  // namespace

std::string text_of(const Expectation& e, const Preset& preset) {
  std::string what = e.observable;
  for (std::size_t i = 0; i < e.bodies.size(); ++i) what += (i == 0 ? " of " : " and ") + e.bodies[i];
  std::string text;
  switch (e.reduction) {
    case Reduction::kAt:
      text = fmt::format("{} at {} s", what, e.time);
      break;
    case Reduction::kAtImpact:
      text = fmt::format("{} at impact {}", what, e.impact);
      break;
    case Reduction::kFinal:
      text = e.until ? fmt::format("{} at {} s", what, *e.until) : fmt::format("{} at the end", what);
      break;
    case Reduction::kCount:
      text = fmt::format("share of {} above {}", what, e.above);
      break;
    case Reduction::kFit:
      text = fmt::format("slope of {} over time", what);
      break;
    case Reduction::kMaximum:
    case Reduction::kMinimum:
    case Reduction::kMean:
      text = fmt::format("{} of {}", name_of(kReductionNames, e.reduction), what);
      break;
  }
  if (e.from > 0.0) text += fmt::format(" from {} s", e.from);
  if (e.until && e.reduction != Reduction::kAt && e.reduction != Reduction::kFinal)
    text += fmt::format(" until {} s", *e.until);
  for (std::size_t i = 0; i < e.settings.size(); ++i) {
    text += fmt::format("{} {} = {}", i == 0 ? ", with" : ",", place_text(e.settings[i].place, preset),
                        e.settings[i].value);
  }
  if (e.over) {
    const auto [least, most] = std::minmax_element(e.over->values.begin(), e.over->values.end());
    text += fmt::format("; {} over {} = {}...{}", name_of(kSweepNames, e.over->reduction),
                        place_text(e.over->place, preset), *least, *most);
  }
  return text;
}

ExpectationCheck::ExpectationCheck(const Preset& preset) : preset_(preset) {
  for (std::size_t i = 0; i < preset.expect.size(); ++i) {
    const Expectation& e = preset.expect[i];
    std::vector<Source>& sources = sources_.emplace_back();
    const auto add_run = [&](const std::vector<Setting>& settings) {
      auto run = std::find_if(runs_.begin(), runs_.end(), [&](const Run& r) { return r.settings == settings; });
      if (run == runs_.end()) {
        try {
          if (!settings.empty()) (void)variant(preset, settings);
        } catch (const SceneError& error) {
          throw SceneError(fmt::format("/expect/{}: with its settings: {}", i, error.what()));
        }
        run = runs_.insert(run, Run{settings, {}, {}});
      }
      run->expectations.push_back(e);
      sources.push_back(
          {static_cast<int>(run - runs_.begin()), static_cast<int>(run->expectations.size()) - 1});
    };
    if (!e.over) {
      add_run(e.settings);
      continue;
    }
    std::vector<Setting> settings = e.settings;
    settings.push_back({e.over->place, 0.0});
    for (const double value : e.over->values) {
      settings.back().value = value;
      add_run(settings);
    }
  }
}

void ExpectationCheck::run(int index) {
  Run& r = runs_[static_cast<std::size_t>(index)];
  const Preset preset = r.settings.empty() ? preset_ : variant(preset_, r.settings);
  r.values = measure_run(preset, r.expectations);
  r.knows_contact_forces = knows_contact_forces(preset.method, needs_of(preset.scene));
}

std::vector<Outcome> ExpectationCheck::outcomes() const {
  std::vector<Outcome> outcomes;
  for (std::size_t i = 0; i < preset_.expect.size(); ++i) {
    const Expectation& e = preset_.expect[i];
    std::vector<double> values;
    Outcome o;
    for (const Source& s : sources_[i]) {
      values.push_back(runs_[s.run].values[s.index]);
      if (is_contact_force(e.observable)) o.known = o.known && runs_[s.run].knows_contact_forces;
    }
    o.measured = e.over ? reduced(*e.over, std::move(values)) : values.front();
    o.error = o.measured - e.value;
    o.good = std::abs(o.error) <= e.tolerance;
    o.unit = unit_of(e);
    outcomes.push_back(std::move(o));
  }
  return outcomes;
}

std::vector<Outcome> check_expectations(const Preset& preset, int threads) {
  ExpectationCheck check(preset);
  parallel_for(check.runs(), threads, [&](int i) { check.run(i); });
  return check.outcomes();
}

}  // namespace carom
