#include "physics/preset/force_json.h"

#include <fmt/format.h>

#include "physics/preset/names.h"
#include "physics/preset/object_reader.h"
#include "physics/preset/object_writer.h"

namespace carom {
namespace {

void read_once(std::optional<int>& place, int index, const std::string& at, const std::string& what) {
  if (place) refuse_value(at, "a second " + what, "one");
  place = index;
}

Spring read_spring(ObjectReader& r) {
  Spring s;
  r.read("name", s.name);
  r.require_text("body", s.body);
  const Json* to = r.find("to");
  const Json* anchor = r.find("anchor");
  if ((to == nullptr) == (anchor == nullptr)) {
    refuse_value(r.at("anchor"), to == nullptr ? "a spring without its other end" : "\"anchor\" beside \"to\"",
                 "either \"anchor\": [x, y], in m, or \"to\": the name of a body");
  }
  if (to != nullptr) {
    s.to = ObjectReader::text(*to, r.at("to"));
    if (s.to.empty()) refuse_value(r.at("to"), "an empty name", "the name of a body");
  } else {
    s.anchor = pair_of_numbers(*anchor, r.at("anchor"));
  }
  r.require_number("stiffness", s.stiffness, "N/m");
  r.read("damping", s.damping);
  r.read("rest_length", s.rest_length);
  r.read_name("acts", kSpringActsNames, s.acts);
  return s;
}

AppliedForce read_applied(ObjectReader& r) {
  AppliedForce f;
  r.require_text("body", f.body);
  r.read("force", f.force);
  r.read("torque", f.torque);
  r.read("start", f.start);
  r.read("rise", f.rise);
  r.read("end", f.end);
  return f;
}

Json spring_json(const Spring& s, bool all) {
  ObjectWriter w(all);
  w.json["type"] = "spring";
  w.put("name", s.name, std::string());
  w.json["body"] = s.body;
  if (s.to.empty()) {
    w.json["anchor"] = pair_json(s.anchor);
  } else {
    w.json["to"] = s.to;
  }
  w.json["stiffness"] = s.stiffness;
  w.put("damping", s.damping, 0.0);
  w.put("rest_length", s.rest_length, 0.0);
  if (s.acts != SpringActs::kBoth) w.json["acts"] = name_of(kSpringActsNames, s.acts);
  return w.json;
}

Json applied_json(const AppliedForce& f, bool all) {
  ObjectWriter w(all);
  w.json["type"] = "force";
  w.json["body"] = f.body;
  w.put("force", f.force, Vec2(Vec2::Zero()));
  w.put("torque", f.torque, 0.0);
  w.put("start", f.start, 0.0);
  w.put("rise", f.rise, 0.0);
  if (f.end) w.json["end"] = *f.end;
  return w.json;
}

}  // namespace

void read_force(const Json& json, int index, Forces& forces, ForcePlaces& places) {
  const std::string at = fmt::format("/forces/{}", index);
  ObjectReader r(json, at);
  std::string type;
  r.require_text("type", type);
  if (type == "linear_drag") {
    read_once(places.linear_drag, index, at, "linear drag");
    r.require_number("coefficient", forces.linear_drag, "kg/s");
  } else if (type == "quadratic_drag") {
    read_once(places.quadratic_drag, index, at, "quadratic drag");
    r.require_number("coefficient", forces.quadratic_drag, "kg/m");
  } else if (type == "spring") {
    forces.springs.push_back(read_spring(r));
    places.springs.push_back(index);
  } else if (type == "attraction") {
    read_once(places.attraction, index, at, "attraction");
    forces.attraction.emplace();
    r.require_number("constant", forces.attraction->constant, "N m²/kg²");
    r.read("softening", forces.attraction->softening);
  } else if (type == "force") {
    forces.applied.push_back(read_applied(r));
    places.applied.push_back(index);
  } else {
    refuse_value(r.at("type"), "\"" + type + "\"",
                 "\"linear_drag\", \"quadratic_drag\", \"spring\", \"attraction\", \"force\"");
  }
  r.finish();
}

Json forces_json(const Forces& forces, bool all) {
  Json j = Json::array();
  if (forces.linear_drag != 0.0) j.push_back({{"type", "linear_drag"}, {"coefficient", forces.linear_drag}});
  if (forces.quadratic_drag != 0.0)
    j.push_back({{"type", "quadratic_drag"}, {"coefficient", forces.quadratic_drag}});
  for (const Spring& s : forces.springs) j.push_back(spring_json(s, all));
  if (forces.attraction) {
    ObjectWriter w(all);
    w.json["type"] = "attraction";
    w.json["constant"] = forces.attraction->constant;
    w.put("softening", forces.attraction->softening, 0.0);
    j.push_back(w.json);
  }
  for (const AppliedForce& f : forces.applied) j.push_back(applied_json(f, all));
  return j;
}

}  // namespace carom
