#include "physics/preset/plot_json.h"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>

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

Json quantity_json(const QuantityName& q) {
  ObjectWriter w(false);
  w.json["observable"] = q.observable;
  if (!q.bodies.empty()) w.json["bodies"] = q.bodies;
  return w.json;
}

}  // namespace

Plot read_plot(const Json& json, const std::string& place) {
  Plot plot;
  if (!json.is_object()) {
    if (json.is_string()) plot.id = json.get<std::string>();
    if (std::find(kPlotNames.begin(), kPlotNames.end(), plot.id) == kPlotNames.end()) {
      refuse_value(place, quoted(json),
                   fmt::format("\"{}\", or an object {{\"y\": [...], ...}}", fmt::join(kPlotNames, "\", \"")));
    }
    return plot;
  }
  ObjectReader r(json, place);
  r.read("title", plot.title);
  (void)r.require("y", "an array of {\"observable\": ..., \"bodies\": [...]}");
  r.read_array("y", [&](const Json& v, const std::string& at) { plot.y.push_back(read_quantity(v, at)); });
  if (plot.y.empty()) refuse_value(r.at("y"), "[]", "at least one quantity");
  if (const Json* x = r.find("x")) plot.x = read_quantity(*x, r.at("x"));
  r.read("logarithmic", plot.logarithmic);
  r.finish();
  return plot;
}

Json plot_json(const Plot& plot) {
  if (!plot.id.empty()) return plot.id;
  ObjectWriter w(false);
  w.put("title", plot.title, std::string());
  w.json["y"] = Json::array();
  for (const QuantityName& q : plot.y) w.json["y"].push_back(quantity_json(q));
  if (plot.x) w.json["x"] = quantity_json(*plot.x);
  w.put("logarithmic", plot.logarithmic, false);
  return w.json;
}

}  // namespace carom
