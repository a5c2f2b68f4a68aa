#include "physics/preset/expectation_json.h"

#include <fmt/format.h>

#include "physics/preset/names.h"
#include "physics/preset/object_writer.h"
#include "physics/preset/observable_json.h"
#include "physics/preset/preset.h"

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

void read_sweep(FieldReader& r, Sweep& s) {
  r.require({"place", "the JSON pointer of a number of this file"}, s.place, kWords);
  r.needed({"values", "an array of numbers"}, [&](const ValueReader& v) {
    v.list({1, kMostSweepValues}, [&](const ValueReader& x) { s.values.push_back(x.number(any_number(""))); });
  });
  r.cases({"reduction", "what the numbers of the runs are reduced to"}, words_of(kSweepNames),
          [&](std::size_t i, FieldReader&) { s.reduction = kSweepNames[i].first; });
}

}  // namespace

void read_expectation(FieldReader& r, Expectation& e) {
  read_observable(r, false, e.observable, e.bodies);
  r.cases({"reduction", "the number that is looked at"}, words_of(kReductionNames),
          [&](std::size_t i, FieldReader& k) {
            e.reduction = kReductionNames[i].first;
            if (e.reduction == Reduction::kAt) k.require({"time", "when"}, e.time, from_zero("s"));
            if (e.reduction == Reduction::kAtImpact)
              k.needed({"impact", "after which impact: 1, 2, ..."}, [&](const ValueReader& v) {
                e.impact = static_cast<int>(v.whole({1, 1e9}));
              });
            if (e.reduction == Reduction::kCount)
              k.require({"above", "in the observable's unit"}, e.above, any_number(""));
            if (looks_over_time(e.reduction)) k.read({"from", "when it begins"}, e.from, from_zero("s"));
            if (e.reduction != Reduction::kAt) k.read({"until", "when it ends"}, e.until, from_zero("s"));
          });
  r.member({"with", "numbers of this file by their JSON pointers"}, [&](const ValueReader& v) {
    v.numbers(kMostSettings, any_number(""), [&](const std::string& place, double x) {
      e.settings.push_back({place, x});
    });
  });
  r.member({"over", "one run for each of several values"}, [&](const ValueReader& v) {
    v.object([&](FieldReader& sweep) { read_sweep(sweep, e.over.emplace()); });
  });
  r.require({"value", "in the observable's unit"}, e.value, any_number(""));
  r.require({"tolerance", "in the observable's unit"}, e.tolerance, from_zero(""));
  r.read({"source", "where the value comes from"}, e.source, kText);
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
