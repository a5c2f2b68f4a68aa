#include "physics/preset/plot_json.h"

#include <fmt/format.h>

#include "physics/observe/expression.h"
#include "physics/preset/names.h"
#include "physics/preset/object_writer.h"
#include "physics/preset/observable_json.h"
#include "physics/preset/preset.h"

namespace carom {
namespace {

// A quantity with an optional closed form; `with_x`: it is drawn over another quantity.
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
  r.read({"residual", "what is shown is the observable less the theory"}, q.residual);
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
                   note.require({"at", "two numbers, in the units of the axes"}, at, any_number(""));
                   note.require({"text", "a few words"}, to.text, {1, kLongestTitle});
                   to.x = at.x();
                   to.y = at.y();
                 });
}

Json note_json(const PlotNote& note) {
  ObjectWriter w(false);
  w.json["at"] = pair_json({note.x, note.y});
  w.json["text"] = note.text;
  return w.json;
}

Json quantity_json(const QuantityName& q) {
  ObjectWriter w(false);
  w.json["observable"] = q.observable;
  if (!q.bodies.empty()) w.json["bodies"] = q.bodies;
  w.put("theory", q.theory, std::string());
  w.put("residual", q.residual, false);
  return w.json;
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
      r.read({"title", "made of what it shows if there is none"}, plot.title, kWords);
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
      r.read({"logarithmic", "the axis of y"}, plot.logarithmic);
    });
  };
  value.one_of(!value.is_object() ? 0U : value.has("plot") ? 1U : 2U, {name, named, own});
  return plot;
}

Json plot_json(const Plot& plot) {
  if (!plot.id.empty() && plot.notes.empty()) return plot.id;
  ObjectWriter w(false);
  for (const PlotNote& note : plot.notes) w.json["notes"].push_back(note_json(note));
  if (!plot.id.empty()) {
    w.json["plot"] = plot.id;
    return w.json;
  }
  w.put("title", plot.title, std::string());
  w.json["y"] = Json::array();
  for (const QuantityName& q : plot.y) w.json["y"].push_back(quantity_json(q));
  if (plot.x) w.json["x"] = quantity_json(*plot.x);
  w.put("logarithmic", plot.logarithmic, false);
  return w.json;
}

}  // namespace carom
