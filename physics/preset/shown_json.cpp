#include <fmt/format.h>
#include <map>

#include "physics/observe/expression.h"
#include "physics/observe/observables.h"
#include "physics/preset/names.h"
#include "physics/preset/sections_json.h"

namespace carom {
namespace {

// Bodies that any observable asks for, at most.
constexpr std::size_t kMostObserved = 2;

// The members "observable" and "bodies" of an object, as many bodies as the observable asks for. Errors against
// a reference are there in plots only.
void read_observable(FieldReader& r, bool in_plot, std::string& name, std::vector<std::string>& bodies) {
  if (r.writes()) {
    r.put(kObservableKey.name, name);
    if (!bodies.empty()) r.put(kObservedBodiesKey.name, bodies);
    return;
  }
  std::vector<std::string> names;
  std::map<int, std::vector<std::string>> by_bodies;
  for (const Observable& o : observables()) {
    if (!in_plot && o.is_error() && !r.reads()) continue;
    names.emplace_back(o.name);
    by_bodies[o.bodies].emplace_back(o.name);
  }
  r.needed(kObservableKey, [&](const ValueReader& v) { name = names[v.word(names)]; });
  r.member(kObservedBodiesKey, [&](const ValueReader& v) {
    v.list({0, kMostObserved}, [&](const ValueReader& body) { bodies.push_back(body.text(kNameLength)); });
  });
  for (const auto& [count, group] : by_bodies) {
    Json then = {{"properties", {{"bodies", {{"minItems", count}, {"maxItems", count}}}}}};
    if (count > 0) then["required"] = Json::array({"bodies"});
    r.also({{"if",
             {{"properties", {{"observable", {{"enum", group}}}}}, {"required", Json::array({"observable"})}}},
            {"then", then}});
  }
  if (!r.reads()) return;
  const Observable& observable = *find_observable(name);
  if (observable.is_error() && !in_plot)
    refuse_value(r.at("observable"), "\"" + name + "\"", "it in plots only");
  if (static_cast<int>(bodies.size()) != observable.bodies) {
    refuse_value(r.at("bodies"), fmt::format("{} names", bodies.size()),
                 fmt::format("{} for \"{}\"", observable.bodies, name));
  }
}

// A quantity that may have a closed form beside it; `with_x`: it is drawn over another one.
void read_line(FieldReader& r, bool with_x, QuantityName& q) {
  read_observable(r, true, q.observable, q.bodies);
  r.member({"theory", "its closed form in t and, over another quantity, in x"}, [&](const ValueReader& v) {
    q.theory = v.text({1, kLongestTitle});
    if (!v.has_value()) return;
    try {
      (void)Expression(q.theory, with_x);
    } catch (const SceneError& error) {
      throw RuleError(Rule::kClosedForm, fmt::format("{}: {}", v.place(), error.what()));
    }
  });
  r.field({"residual", "what is shown is the observable less the theory"}, q.residual);
  r.also({{"if", {{"properties", {{"residual", {{"const", true}}}}}, {"required", Json::array({"residual"})}}},
          {"then", {{"required", Json::array({"theory"})}}}});
  if (q.residual && q.theory.empty())
    refuse_value(r.at("residual"), "true", "false, or a \"theory\" beside it");
}

void read_notes(FieldReader& r, Plot& plot) {
  r.read_objects({"notes", "remarks at points of the plot"}, kMostNotes,
                 [&](FieldReader& note, const std::string&) {
                   Vec2 at = Vec2::Zero();
                   PlotNote& to = plot.notes.emplace_back();
                   note.required({"at", "two numbers, in the units of the axes"}, at, any_number(""));
                   note.required({"text", "a few words"}, to.text, Count{1, kLongestTitle});
                   to.x = at.x();
                   to.y = at.y();
                 });
}

Json quantity_json(const QuantityName& q) {
  Json j = {{"observable", q.observable}};
  if (!q.bodies.empty()) j["bodies"] = q.bodies;
  if (!q.theory.empty()) j["theory"] = q.theory;
  if (q.residual) j["residual"] = true;
  return j;
}

}  // namespace

Plot read_plot(const ValueReader& value) {
  Plot plot;
  const auto name = [&](const ValueReader& v) { plot.id = kPlotNames[v.word(words_of(kPlotNames))]; };
  const auto named = [&](const ValueReader& v) {
    v.object([&](FieldReader& r) {
      r.needed({"plot", "the name of one"}, name);
      read_notes(r, plot);
    });
  };
  const auto own = [&](const ValueReader& v) {
    v.object([&](FieldReader& r) {
      read_notes(r, plot);
      r.field({"title", "made of what it shows if there is none"}, plot.title, kWords);
      const bool with_x = r.has("x");
      r.needed({"y", "an array of {\"observable\": ..., \"bodies\": [...]}"}, [&](const ValueReader& y) {
        y.list({1, kMostPlotCurves}, [&](const ValueReader& line) {
          line.object([&](FieldReader& q) { read_line(q, with_x, plot.y.emplace_back()); });
        });
      });
      r.member({"x", "what they are drawn over"}, [&](const ValueReader& x) {
        x.object([&](FieldReader& q) {
          plot.x.emplace();
          read_observable(q, true, plot.x->observable, plot.x->bodies);
        });
      });
      r.field({"logarithmic", "the axis of y"}, plot.logarithmic);
    });
  };
  value.one_of(!value.is_object() ? 0U : value.has("plot") ? 1U : 2U, {name, named, own});
  return plot;
}

Json plot_json(const Plot& plot) {
  if (!plot.id.empty() && plot.notes.empty()) return plot.id;
  Json j;
  for (const PlotNote& note : plot.notes)
    j["notes"].push_back({{"at", pair_json({note.x, note.y})}, {"text", note.text}});
  if (!plot.id.empty()) {
    j["plot"] = plot.id;
    return j;
  }
  if (!plot.title.empty()) j["title"] = plot.title;
  j["y"] = Json::array();
  for (const QuantityName& q : plot.y) j["y"].push_back(quantity_json(q));
  if (plot.x) j["x"] = quantity_json(*plot.x);
  if (plot.logarithmic) j["logarithmic"] = true;
  return j;
}

void read_expectation(FieldReader& r, Expectation& e) {
  read_observable(r, false, e.observable, e.bodies);
  reduction_fields(r, e);
  Json with;
  for (const Setting& s : e.settings) with[s.place] = s.value;
  if (!with.is_null()) r.put(kSettingsKey.name, with);
  r.member(kSettingsKey, [&](const ValueReader& v) {
    v.numbers(kMostSettings, kSetNumber, [&](const std::string& place, double x) {
      e.settings.push_back({place, x});
    });
  });
  r.object(kSweepKey, e.over);
  value_fields(r, e);
}

}  // namespace carom
