#include <algorithm>
#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <map>
#include <string>
#include <string_view>

#include "physics/preset/preset.h"
#include "physics/preset/preset_file.h"
#include "physics/preset/preset_json.h"
#include "physics/preset/sections_json.h"
#include "physics/run/checkpoint.h"
#include "physics/run/scene_now.h"
#include "physics/run/simulation.h"
#include "physics/scene/fingerprint.h"
#include "physics/scene/range_check.h"
#include "physics/scene/value_checks.h"

namespace carom {
namespace {

constexpr std::string_view kForces = "/forces/";
constexpr const char* kPlaceAllowed =
    "the JSON pointer of a number of this preset, such as /gravity/1 or /bodies/0/position/0";

// The number that stands at a JSON pointer; nullptr if there is none.
Json* number_at(Json& json, const std::string& place) {
  try {
    const Json::json_pointer pointer(place);
    if (!json.contains(pointer)) return nullptr;
    Json& found = json.at(pointer);
    return found.is_number() ? &found : nullptr;
  } catch (const Json::exception&) {
    return nullptr;  // not a JSON pointer
  }
}

// Of each force the place in the file and the one in a file that Carom writes.
std::map<int, int> moves(const Forces& forces, const ForcePlaces& file) {
  const ForcePlaces written = written_places(forces);
  std::map<int, int> pairs;
  for (const auto& [type, place] : file.common) {
    if (const auto to = written.common.find(type); to != written.common.end()) pairs.emplace(place, to->second);
  }
  for (std::size_t i = 0; i < file.springs.size(); ++i) pairs.emplace(file.springs[i], written.springs[i]);
  for (std::size_t i = 0; i < file.applied.size(); ++i) pairs.emplace(file.applied[i], written.applied[i]);
  return pairs;
}

// The place in a file that Carom writes.
std::string moved(const std::string& place, const std::map<int, int>& moves) {
  if (!place.starts_with(kForces)) return place;
  int index = -1;
  const char* end = place.data() + place.size();
  const auto [rest, error] = std::from_chars(place.data() + kForces.size(), end, index);
  if (error != std::errc()) return place;
  const auto found = moves.find(index);
  return found == moves.end() ? place : fmt::format("{}{}{}", kForces, found->second, std::string(rest, end));
}

Json full_json(const Preset& preset) {
  Json json = preset_json(preset, true);
  json.erase("expect");
  json.erase("extra");
  return json;
}

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
    check_range(place, sweep.values[i], kSetNumber);
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
  RangeCheck check(at);
  reduction_fields(check, e);
  value_fields(check, e);
  if (e.until) check_order(at + "/until", *e.until, e.from, "from");
  for (const Setting& s : e.settings) {
    check_range(fmt::format("{}/with {}", at, s.place), s.value, kSetNumber);
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

// Repeats what a check says of a body that comes in later, at its place in the file: in the scene that was
// checked it stands after the bodies of the list.
template <class Check>
void check_late_bodies(std::size_t listed, const Check& check) {
  const auto at_its_place = [listed](const std::string& line) {
    constexpr std::string_view kBodies = "/bodies/";
    std::size_t index = 0;
    if (!line.starts_with(kBodies)) return line;
    const char* const end = line.data() + line.size();
    const auto [rest, error] = std::from_chars(line.data() + kBodies.size(), end, index);
    if (error != std::errc() || index < listed) return line;
    return fmt::format("/added/{}/body{}", index - listed, std::string_view(rest, end));
  };
  try {
    check();
  } catch (const RuleError& error) {
    throw RuleError(error.rule, at_its_place(error.what()));
  } catch (const SceneError& error) {
    throw SceneError(at_its_place(error.what()));
  }
}

// They are good in the scene as it is when all of them are there.
void check_late_bodies(const Preset& preset, const ForcePlaces& places, const RunBegin& begin) {
  if (preset.edits.empty()) return;
  Scene scene = preset.scene;
  double last = 0.0;
  for (std::size_t i = 0; i < preset.edits.size(); ++i) {
    const double time = preset.edits[i].time;
    const std::string place = fmt::format("/added/{}/time", i);
    check_range(place, time, kMomentOfRun);
    check_order(place, time, last, "the time before it");
    last = time;
    scene.bodies.push_back(added_body(preset.edits[i]));
  }
  check_late_bodies(preset.scene.bodies.size(), [&] { validate(scene, places, begin); });
  check_integrator("/added", scene, preset.method);
  for (const Method& method : preset.compare) check_integrator("/added", scene, method);
}

// How many there are.
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

Preset variant(const Preset& preset, const std::vector<Setting>& settings) {
  Json json = full_json(preset);
  for (const Setting& s : settings) {
    Json* number = number_at(json, s.place);
    if (number == nullptr) refuse_by(Rule::kPlaces, s.place, "a setting where no number stands", kPlaceAllowed);
    // Counts and seeds are whole numbers in a file.
    if (number->is_number_integer() && std::floor(s.value) == s.value && std::abs(s.value) < 9e15) {
      *number = static_cast<std::int64_t>(s.value);
    } else {
      *number = s.value;
    }
  }
  Preset changed = preset_of(json);
  changed.topic = preset.topic;
  return changed;
}

const Body& added_body(const RunEdit& edit) {
  return std::get<Add<Body>>(std::get<SceneEdits>(edit.what).front()).part;
}

std::vector<Body> all_bodies(const Preset& preset) {
  std::vector<Body> bodies = all_bodies(preset.scene);
  for (const RunEdit& edit : preset.edits) bodies.push_back(added_body(edit));
  return bodies;
}

void resolve_places(Preset& preset, const ForcePlaces& places) {
  const auto has_places = [](const Expectation& e) { return e.over || !e.settings.empty(); };
  if (std::none_of(preset.expect.begin(), preset.expect.end(), has_places)) return;
  Json json = full_json(preset);
  const auto pairs = moves(preset.scene.forces, places);
  const auto resolve = [&](const std::string& at, std::string& place) {
    std::string now = moved(place, pairs);
    if (number_at(json, now) == nullptr) refuse_by(Rule::kPlaces, at, "\"" + place + "\"", kPlaceAllowed);
    place = std::move(now);
  };
  for (std::size_t i = 0; i < preset.expect.size(); ++i) {
    Expectation& e = preset.expect[i];
    for (Setting& s : e.settings) resolve(fmt::format("/expect/{}/with", i), s.place);
    if (e.over) resolve(fmt::format("/expect/{}/over/place", i), e.over->place);
  }
}

Preset saved_preset(const Preset& document, const Simulation& simulation) {
  if (const auto& lost = simulation.lost()) {
    throw SceneError("the run cannot be saved as it stands: it is " +
                     lost->text(simulation.bodies(), simulation.time()));
  }
  Preset out = document;
  out.scene = scene_now(simulation);
  out.expect.clear();
  out.method = simulation.method();
  std::erase_if(out.edits, [&](const RunEdit& edit) { return simulation.is_due(edit); });
  out.saved = SavedRun{.time = simulation.time()};
  out.saved->checkpoint = std::make_shared<Checkpoint>(simulation.checkpoint());
  out.saved->fingerprint = fingerprint(out.scene, simulation.time());
  try {
    validate(out);
    check_checkpoint(out.scene, *out.saved->checkpoint);
  } catch (const SceneError& error) {
    throw SceneError(std::string("the run cannot be saved as it stands: ") + error.what());
  }
  return out;
}

void validate(const Preset& preset, const ForcePlaces& places) {
  check_fields("/method", preset.method);
  check_count("/compare", preset.compare.size(), kMostCompared, "methods");
  for (std::size_t i = 0; i < preset.compare.size(); ++i) {
    check_fields(fmt::format("/compare/{}", i), preset.compare[i]);
  }
  check_range("/duration", preset.duration, kDuration);
  if (preset.saved && !kMomentOfRun.contains(preset.saved->time))
    refuse_by(Rule::kSavedRun, "/state/time", fmt::format("{}", preset.saved->time), kMomentOfRun.text());
  const RunBegin begin{start_time(preset.saved), state_belongs(preset.scene, preset.saved)};
  validate(preset.scene, places, begin);
  check_integrator("/method", preset.scene, preset.method);
  for (std::size_t i = 0; i < preset.compare.size(); ++i) {
    check_integrator(fmt::format("/compare/{}", i), preset.scene, preset.compare[i]);
  }
  check_late_bodies(preset, places, begin);
  const std::vector<Body> all = all_bodies(preset);
  NamedBodies bodies;
  for (const Body& b : all) bodies.emplace(b.name, &b);
  check_count("/stop", preset.stops.size(), kMostStops, "stops");
  for (std::size_t i = 0; i < preset.stops.size(); ++i)
    check_stop(fmt::format("/stop/{}", i), preset.stops[i], bodies);
  check_count("/expect", preset.expect.size(), kMostExpectations, "expectations");
  for (std::size_t i = 0; i < preset.expect.size(); ++i)
    check_expectation(fmt::format("/expect/{}", i), preset.expect[i], bodies);
  check_plots(preset.plots);
  for (std::size_t i = 0; i < preset.plots.size(); ++i)
    check_plot(fmt::format("/plots/{}", i), preset.plots[i], bodies);
  if (preset.view) check_fields("/view", *preset.view);
}

void validate(const Preset& preset) { validate(preset, written_places(preset.scene.forces)); }

RunSetup setup_of(const Preset& preset) {
  RunSetup setup{preset.scene, preset.method, preset.saved, preset.edits};
  const auto count = [&](const QuantityName& quantity) {
    if (quantity.bodies.size() == 2) setup.counted_pairs.emplace_back(quantity.bodies[0], quantity.bodies[1]);
  };
  for (const Plot& plot : preset.plots) {
    for (const QuantityName& y : plot.y) count(y);
    if (plot.x) count(*plot.x);
  }
  return setup;
}

}  // namespace carom
