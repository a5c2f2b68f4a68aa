#include "physics/preset/expectation_json.h"

#include <fmt/format.h>

#include "physics/preset/names.h"
#include "physics/preset/object_reader.h"
#include "physics/preset/object_writer.h"
#include "physics/preset/observable_json.h"

namespace carom {
namespace {

using Reduction = Expectation::Reduction;

bool looks_over_time(Reduction reduction) {
  switch (reduction) {
    case Reduction::kAt:
    case Reduction::kAtImpact:
    case Reduction::kFinal:
      return false;
    case Reduction::kMaximum:
    case Reduction::kMinimum:
    case Reduction::kMean:
    case Reduction::kCount:
    case Reduction::kFit:
      return true;
  }
  return false;
}

std::vector<Setting> read_settings(const Json& json, const std::string& place) {
  if (!json.is_object()) refuse_value(place, quoted(json), "an object, {\"/bodies/0/mass\": 2, ...}");
  std::vector<Setting> settings;
  for (const auto& item : json.items()) {
    settings.push_back({item.key(), number(item.value(), fmt::format("{} {}", place, item.key()))});
  }
  return settings;
}

Sweep read_sweep(const Json& json, const std::string& place) {
  Sweep s;
  ObjectReader r(json, place);
  r.require_text("place", s.place);
  (void)r.require("values", "an array of numbers");
  r.read_array("values", [&](const Json& v, const std::string& at) { s.values.push_back(number(v, at)); });
  (void)r.require("reduction", quoted_names(kSweepNames));
  r.read_name("reduction", kSweepNames, s.reduction);
  r.finish();
  return s;
}

}  // namespace

Expectation read_expectation(const Json& json, const std::string& place) {
  Expectation e;
  ObjectReader r(json, place);
  const Observable& observable = read_observable(r, e.observable, e.bodies);
  if (observable.is_error()) refuse_value(r.at("observable"), "\"" + e.observable + "\"", "it in plots only");
  (void)r.require("reduction", quoted_names(kReductionNames));
  r.read_name("reduction", kReductionNames, e.reduction);
  if (e.reduction == Reduction::kAt) r.require_number("time", e.time, "s");
  if (e.reduction == Reduction::kAtImpact) {
    (void)r.require("impact", "1, 2, ...");
    r.read_integer("impact", e.impact, 1, 1e9);
  }
  if (e.reduction == Reduction::kCount) r.require_number("above", e.above, observable.unit);
  if (looks_over_time(e.reduction)) r.read("from", e.from);
  if (e.reduction != Reduction::kAt) r.read("until", e.until);
  if (const Json* v = r.find("with")) e.settings = read_settings(*v, r.at("with"));
  if (const Json* v = r.find("over")) e.over = read_sweep(*v, r.at("over"));
  r.require_number("value", e.value, observable.unit);
  r.require_number("tolerance", e.tolerance, observable.unit);
  r.read("source", e.source);
  r.finish();
  return e;
}

Json expectation_json(const Expectation& e) {
  ObjectWriter w(false);
  w.json["observable"] = e.observable;
  if (!e.bodies.empty()) w.json["bodies"] = e.bodies;
  w.json["reduction"] = name_of(kReductionNames, e.reduction);
  if (e.reduction == Reduction::kAt) w.json["time"] = e.time;
  if (e.reduction == Reduction::kAtImpact) w.json["impact"] = e.impact;
  if (e.reduction == Reduction::kCount) w.json["above"] = e.above;
  if (looks_over_time(e.reduction)) w.put("from", e.from, 0.0);
  if (e.until && e.reduction != Reduction::kAt) w.json["until"] = *e.until;
  for (const Setting& s : e.settings) w.json["with"][s.place] = s.value;
  if (e.over) {
    w.json["over"] = {{"place", e.over->place},
                      {"values", e.over->values},
                      {"reduction", name_of(kSweepNames, e.over->reduction)}};
  }
  w.json["value"] = e.value;
  w.json["tolerance"] = e.tolerance;
  w.put("source", e.source, std::string());
  return w.json;
}

}  // namespace carom
