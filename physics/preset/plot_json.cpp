#include "physics/preset/plot_json.h"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "physics/measure/expression.h"
#include "physics/preset/names.h"
#include "physics/preset/object_writer.h"
#include "physics/preset/observable_json.h"

namespace carom {
namespace {

QuantityName read_quantity(const Json& json, const std::string& place) {
  QuantityName q;
  ObjectReader r(json, place);
  (void)read_observable(r, q.observable, q.bodies);
  r.finish();
  return q;
}

// A quantity that may have a closed form beside it; `with_x`: it is drawn over another one.
QuantityName read_line(const Json& json, const std::string& place, bool with_x) {
  QuantityName q;
  ObjectReader r(json, place);
  (void)read_observable(r, q.observable, q.bodies);
  if (const Json* theory = r.find("theory")) {
    q.theory = ObjectReader::text(*theory, r.at("theory"));
    try {
      (void)Expression(q.theory, with_x);
    } catch (const SceneError& error) {
      throw SceneError(fmt::format("{}: {}", r.at("theory"), error.what()));
    }
  }
  r.read("residual", q.residual);
  if (q.residual && q.theory.empty())
    refuse_value(r.at("residual"), "true", "false, or a \"theory\" beside it");
  r.finish();
  return q;
}

PlotNote read_note(const Json& json, const std::string& place) {
  PlotNote note;
  ObjectReader r(json, place);
  const Vec2 at = pair_of_numbers(r.require("at", "two numbers, in the units of the axes"), r.at("at"));
  note.x = at.x();
  note.y = at.y();
  r.require_text("text", note.text);
  if (note.text.empty()) refuse_value(r.at("text"), "\"\"", "a few words");
  r.finish();
  return note;
}

Json note_json(const PlotNote& note) {
  ObjectWriter w(false);
  w.json["at"] = pair_json({note.x, note.y});
  w.json["text"] = note.text;
  return w.json;
}

// One of the plots that have a name.
std::string read_name(const Json& json, const std::string& place) {
  if (json.is_string()) {
    const auto name = json.get<std::string>();
    if (std::find(kPlotNames.begin(), kPlotNames.end(), name) != kPlotNames.end()) return name;
  }
  refuse_value(place, quoted(json),
               fmt::format("\"{}\", or an object {{\"y\": [...], ...}}", fmt::join(kPlotNames, "\", \"")));
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

Plot read_plot(const Json& json, const std::string& place) {
  Plot plot;
  if (!json.is_object()) {
    plot.id = read_name(json, place);
    return plot;
  }
  ObjectReader r(json, place);
  r.read_array("notes", [&](const Json& v, const std::string& at) { plot.notes.push_back(read_note(v, at)); });
  if (const Json* name = r.find("plot")) {
    plot.id = read_name(*name, r.at("plot"));
    r.finish();
    return plot;
  }
  r.read("title", plot.title);
  (void)r.require("y", "an array of {\"observable\": ..., \"bodies\": [...]}");
  const bool with_x = r.find("x") != nullptr;
  r.read_array("y", [&](const Json& v, const std::string& at) { plot.y.push_back(read_line(v, at, with_x)); });
  if (plot.y.empty()) refuse_value(r.at("y"), "[]", "at least one quantity");
  if (const Json* x = r.find("x")) plot.x = read_quantity(*x, r.at("x"));
  r.read("logarithmic", plot.logarithmic);
  r.finish();
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
