#include "physics/study/study.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <fmt/format.h>
#include <mutex>

#include "physics/check/measure_run.h"
#include "physics/compare/chaos.h"
#include "physics/compare/comparison.h"
#include "physics/compare/reference.h"
#include "physics/dynamics/integrators/integrators.h"
#include "physics/math/cancelled.h"
#include "physics/math/parallel.h"
#include "physics/model/needs.h"
#include "physics/preset/preset.h"
#include "physics/scene/facts.h"
#include "physics/scene/validate.h"

namespace carom {
namespace {

constexpr double kPast = 0.1;  // of the compared time: how far a run continues to find late impacts
// A chaotic scene is compared where neighbours have separated by this factor: errors of methods, larger than
// rounding, are then still small against the scene.
constexpr double kMostGrowth = 300.0;
// An end earlier in the run is no time to compare at.
constexpr double kLeastOfRun = 0.05;

constexpr double kCoarsestStep = 16.0;  // of the default steps, relative to the scene's own
constexpr double kLeastSteps = 8.0;     // of a run at the coarsest step

bool contains(const auto& list, const auto& value) {
  return list.empty() || std::find(list.begin(), list.end(), value) != list.end();
}

void add_remark(std::string& remarks, const std::string& more) {
  if (!remarks.empty()) remarks += "; ";
  remarks += more;
}

double distance_to_impacts(const std::vector<TimedImpact>& impacts, double time) {
  double least = std::numeric_limits<double>::infinity();
  for (const TimedImpact& i : impacts) least = std::min(least, std::abs(i.time - time));
  return least;
}

// The time to compare at, and in words why it is not the end of the run.
double compared_time(const Preset& preset, const StudyOptions& options, const Chaos& chaos, StudyFacts& facts) {
  std::string& remarks = facts.remarks;
  const double wanted = options.until.value_or(preset.duration);
  const bool rests = chaos.resting_since > kLeastOfRun * wanted && chaos.resting_since < wanted;
  const bool chaotic = chaos.horizon < wanted;
  const std::string resting = fmt::format(
      "from t = {:.4g} s on bounces follow faster than the method resolves (Zeno)", chaos.resting_since);
  if (options.until) {
    if (chaotic) {
      add_remark(remarks, fmt::format("WARNING: the compared time lies beyond the horizon, {:.3g} s: the "
                                      "errors there say nothing about the methods",
                                      chaos.horizon));
    }
    if (rests) add_remark(remarks, resting + ": impacts can't be matched there");
    const double near = distance_to_impacts(chaos.impacts, wanted);
    if (near < 1e-3 * wanted) {
      add_remark(remarks, fmt::format("an impact lies {:.2g} s from the compared time", near));
    }
    return wanted;
  }
  double end = wanted;
  if (rests) {
    end = chaos.resting_since;
    add_remark(remarks, resting + ": compared before");
  }
  if (std::isfinite(chaos.horizon)) {
    const auto late = std::find_if(chaos.growth.begin(), chaos.growth.end(),
                                   [](double growth) { return growth > kMostGrowth; });
    const double parted =
        late == chaos.growth.end() ? end : chaos.time[static_cast<std::size_t>(late - chaos.growth.begin())];
    const double sane = std::min(parted, 0.5 * chaos.horizon);
    if (sane < end) {
      end = sane;
      add_remark(
          remarks,
          fmt::format("{}: compared {}", chaotic ? "the run lasts beyond the horizon" : "the motion is chaotic",
                      sane < parted
                          ? std::string("well before it")
                          : fmt::format("while neighbours have parted {:g}-fold or less", kMostGrowth)));
    }
  }
  const double time = plan_time(chaos.impacts, end);
  if (time < end) add_remark(remarks, "moved away from impacts");
  return time;
}

std::string words_for(const Reference& r) {
  const auto& integrator = choice_of(kIntegrators, r.method.integrator);
  if (r.exact) return fmt::format("{}, impacts at their own time", integrator.label);
  std::string made = fmt::format("{}, impacts at their own time, h = {:.4g} s after {} halving{}",
                                 integrator.label, r.method.step, r.halvings, r.halvings == 1 ? "" : "s");
  if (r.converged) return made;
  return fmt::format("{}; NOT CONVERGED: two refinements differ by {:.1g} of the length", made,
                     r.relative_error);
}

// The largest difference from the file's figures.
std::string words_for(const std::vector<StatedFigure>& figures) {
  if (figures.empty()) return {};
  const auto worst = std::max_element(
      figures.begin(), figures.end(),
      [](const StatedFigure& x, const StatedFigure& y) { return x.difference < y.difference; });
  return fmt::format("off the file's own figure{} by {}{:.1e} {} ({})", figures.size() == 1 ? "" : "s",
                     figures.size() == 1 ? "" : "at most ", worst->difference, worst->unit, worst->text);
}

void measure_accuracy(StudyRow& row, const RunSetup& setup, const Reference& reference, const Chaos& chaos,
                      std::span<const MovingBody> moving, double time, const std::stop_token& stop) {
  const RunSummary run =
      run_and_summarize(setup, row.method, time, (1.0 + kPast) * time, blown_up_above(chaos), stop);
  static_cast<Comparison&>(row) = compare(run, reference.run, moving, time);
  row.steps = run.steps;
  row.evaluations = run.evaluations;
  row.rejected_steps = run.rejected_steps;
  row.impacts = run.impact_count;
  row.status = run.status;
}

// s of one run to `time`. Short runs are repeated until a clock can measure them.
double time_once(const Simulation& start, double time, const std::stop_token& stop) {
  using Clock = std::chrono::steady_clock;
  constexpr double kMeasurable = 2e-3;  // s
  double sum = 0.0;
  int runs = 0;
  do {
    Simulation run = start;
    const auto from = Clock::now();
    if (stop.stop_possible()) {
      run.advance_to(time, [&stop] { throw_if_cancelled(stop); });
    } else {
      run.advance_to(time);
    }
    sum += std::chrono::duration<double>(Clock::now() - from).count();
    ++runs;
  } while (sum < kMeasurable);
  return sum / runs;
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

void measure_times(StudyTable& table, const Preset& preset, const StudyCallbacks& callbacks) {
  std::vector<StudyRow>& rows = table.rows;
  std::vector<std::vector<double>> times(rows.size());
  const int all = table.facts.repeats * static_cast<int>(rows.size());
  for (int k = 0; k < all; ++k) {
    const auto i = static_cast<std::size_t>(k) % rows.size();
    if (rows[i].status.starts_with("blew up")) continue;  // it never reached the compared time
    Preset with_method = preset;
    with_method.method = rows[i].method;
    times[i].push_back(time_once(Simulation(setup_of(with_method)), table.facts.time, callbacks.stop));
    rows[i].wall_time = median(times[i]);
    rows[i].wall_least = *std::min_element(times[i].begin(), times[i].end());
    rows[i].wall_most = *std::max_element(times[i].begin(), times[i].end());
    if (callbacks.row) callbacks.row(table.facts, rows[i]);
    if (callbacks.progress) callbacks.progress("times, alone", k + 1, all);
  }
}

}  // namespace

std::vector<double> default_steps(const Preset& preset) {
  std::vector<double> steps;
  double h = std::min({kCoarsestStep * preset.method.step, preset.duration / kLeastSteps, kLargestStep});
  for (int k = 0; k < kDefaultSteps && h >= kLeastStep; ++k, h *= 0.5) steps.push_back(h);
  return steps;
}

std::vector<Method> plan_methods(const Preset& preset, const StudyOptions& options) {
  std::vector<double> steps = options.steps.empty() ? default_steps(preset) : options.steps;
  std::vector<double> tolerances = options.tolerances;
  if (tolerances.empty()) {
    for (int digits = 3; digits <= 12; ++digits) tolerances.push_back(std::pow(10.0, -digits));
  }
  std::sort(steps.begin(), steps.end(), std::greater<>());
  std::sort(tolerances.begin(), tolerances.end(), std::greater<>());

  const Needs needs = needs_of(preset.scene);
  std::vector<Method> methods;
  for (const IntegratorChoice& integrator : kIntegrators) {
    if (!contains(options.integrators, integrator.id)) continue;
    if (const auto refused = why_not(preset.scene, integrator.id)) {
      if (options.integrators.empty()) continue;
      throw SceneError("--integrators: " + *refused);
    }
    for (const auto& impacts : kImpacts) {
      if (!contains(options.impacts, impacts.id)) continue;
      Method m = preset.method;
      m.integrator = integrator.id;
      m.impacts = impacts.id;
      if (integrator.order == 0 && impacts.id != ImpactsId::kLocated) continue;
      if (!needs.has(Part::kRestingContacts)) m.contacts = ContactsId::kImpulse;
      switch (error_parameter(m)) {
        case ErrorParameter::kStep:
          for (const double step : steps) {
            m.step = step;
            methods.push_back(m);
          }
          break;
        case ErrorParameter::kTolerance:
          for (const double tolerance : tolerances) {
            m.tolerance = tolerance;
            methods.push_back(m);
          }
          break;
        case ErrorParameter::kNone:
          methods.push_back(m);
          break;
      }
    }
  }
  if (methods.empty()) {
    throw SceneError(
        "--impacts: exact-flight with step-end is not allowed; allowed: located, exact flight is nothing else");
  }
  return methods;
}

double plan_time(const std::vector<TimedImpact>& impacts, double end) {
  const double from = 0.75 * end;
  std::vector<double> times;
  for (const TimedImpact& i : impacts) times.push_back(i.time);
  std::sort(times.begin(), times.end());
  const auto room = [&](double t) {  // s, to the nearest impact
    const auto after = std::lower_bound(times.begin(), times.end(), t);
    double least = std::numeric_limits<double>::infinity();
    if (after != times.end()) least = *after - t;
    if (after != times.begin()) least = std::min(least, t - *std::prev(after));
    return least;
  };
  // Halfway between two bounces a ball turns round, and a time error does not show in its position.
  constexpr double kOffTheMiddle = 0.35;
  double best = end;
  double most = 0.0;
  const auto consider = [&](double t) {
    if (t < from || t > end || room(t) <= most) return;
    best = t;
    most = room(t);
  };
  consider(from);
  for (std::size_t i = 0; i + 1 < times.size(); ++i) {
    consider(std::lerp(times[i], times[i + 1], kOffTheMiddle));
  }
  if (room(end) >= 0.5 * most) return end;
  const double grain = 1e-4 * std::pow(10.0, std::ceil(std::log10(end)));
  const double rounded = std::round(best / grain) * grain;
  return rounded > 0.0 && rounded < end && room(rounded) >= 0.9 * most ? rounded : best;
}

StudyTable run_study(const Preset& preset, const std::string& name, const StudyOptions& options,
                     const StudyCallbacks& callbacks) {
  const auto report = [&](std::string_view stage, int done, int of) {
    throw_if_cancelled(callbacks.stop);
    if (callbacks.progress) callbacks.progress(stage, done, of);
  };
  const std::vector<Method> methods = plan_methods(preset, options);
  StudyTable table;
  StudyFacts& facts = table.facts;
  facts.preset = name;
  facts.title = preset.title;
  facts.repeats = options.repeats;
  facts.duration = options.until.value_or(preset.duration);

  const RunSetup setup = setup_of(preset);
  report("neighbours", 0, 1);
  const Chaos chaos = follow_neighbours(setup, study_reference_method(setup), (1.0 + kPast) * facts.duration,
                                        options.threads, callbacks.stop);
  facts.time = compared_time(preset, options, chaos, facts);
  facts.length = chaos.length;
  facts.arc = chaos.largest_arc();
  facts.exponent = chaos.exponent;
  facts.growth = chaos.growth_at(facts.time);
  facts.horizon = chaos.horizon;

  report("reference", 0, 1);
  const Reference reference =
      make_reference(setup, chaos, facts.time, (1.0 + kPast) * facts.time, callbacks.stop);
  facts.reference = words_for(reference);
  facts.reference_position_error = reference.position_error;
  facts.reference_velocity_error = reference.velocity_error;
  facts.reference_angle_error = reference.angle_error;
  facts.reference_spin_error = reference.spin_error;
  facts.reference_energy_error = reference.energy_error;
  facts.stated = words_for(
      check_stated_figures(preset, reference.method, std::min(facts.duration, chaos.horizon), callbacks.stop));

  for (std::size_t i = 0; i < methods.size(); ++i) {
    StudyRow row;
    row.index = static_cast<int>(i);
    row.method = methods[i];
    table.rows.push_back(row);
  }
  // The longest runs come first, so that no core waits long at the end.
  std::vector<std::size_t> order(table.rows.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::stable_sort(order.begin(), order.end(), [&](std::size_t x, std::size_t y) {
    return table.rows[x].method.step < table.rows[y].method.step;
  });
  const std::vector<MovingBody> moving = moving_bodies(all_bodies(preset.scene));
  std::mutex mutex;
  int done = 0;
  const int all = static_cast<int>(order.size());
  report("accuracy", 0, all);
  parallel_for(all, options.threads, [&](int k) {
    throw_if_cancelled(callbacks.stop);
    StudyRow& row = table.rows[order[static_cast<std::size_t>(k)]];
    measure_accuracy(row, setup, reference, chaos, moving, facts.time, callbacks.stop);
    const std::lock_guard lock(mutex);
    if (callbacks.row) callbacks.row(facts, row);
    report("accuracy", ++done, all);
  });
  measure_times(table, preset, callbacks);
  return table;
}

}  // namespace carom
