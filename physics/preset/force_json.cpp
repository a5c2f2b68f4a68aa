#include "physics/preset/force_json.h"

#include <fmt/format.h>

#include "physics/preset/names.h"
#include "physics/preset/object_writer.h"

namespace carom {
namespace {

void read_once(std::optional<int>& place, int index, const std::string& at, const std::string& what) {
  if (place) refuse_by(Rule::kKeysTogether, at, "a second " + what, "one");
  place = index;
}

void read_spring(FieldReader& r, Spring& s) {
  r.read({"name", "its own, if any"}, s.name, kPerhapsName);
  r.require({"body", "the name of the body that it acts on"}, s.body, kName);
  if (r.reads() && r.has("to") == r.has("anchor")) {
    refuse_value(r.at("anchor"), r.has("to") ? "\"anchor\" beside \"to\"" : "a spring without its other end",
                 "either \"anchor\": [x, y], in m, or \"to\": the name of a body");
  }
  r.read({"to", "the body at the other end"}, s.to, kName);
  r.read({"anchor", "the point of the plane at the other end, [x, y]"}, s.anchor, any_number("m"));
  r.also({{"oneOf", {{{"required", Json::array({"to"})}}, {{"required", Json::array({"anchor"})}}}}});
  r.require({"stiffness", "force over stretch"}, s.stiffness, positive("N/m"));
  r.read({"damping", "force over the stretch's speed"}, s.damping, from_zero("N s/m"));
  r.read({"rest_length", "of the spring that pulls at nothing"}, s.rest_length, from_zero("m"));
  r.read_choice({"acts", "which way it acts"}, kSpringActsNames, s.acts);
}

void read_applied(FieldReader& r, AppliedForce& f) {
  r.require({"body", "the name of the body that it acts on"}, f.body, kName);
  r.read({"force", "at the body's centre, [x, y]"}, f.force, any_number("N"));
  r.read({"torque", "counter-clockwise"}, f.torque, any_number("N m"));
  r.read({"start", "when it sets in"}, f.start, from_zero("s"));
  r.read({"rise", "within which it grows to all of it"}, f.rise, from_zero("s"));
  r.read({"end", "when it ends"}, f.end, from_zero("s"));
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

void read_force(FieldReader& r, const std::string& at, int index, Forces& forces, ForcePlaces& places) {
  const auto one = [&](std::optional<int>& place, const char* what) {
    if (r.reads()) read_once(place, index, at, what);
  };
  r.cases({"type", "the kind of force"}, {"linear_drag", "quadratic_drag", "spring", "attraction", "force"},
          [&](std::size_t kind, FieldReader& k) {
            if (kind == 0) {
              one(places.linear_drag, "linear drag");
              k.require({"coefficient", "b in F = -b v"}, forces.linear_drag, from_zero("kg/s"));
            } else if (kind == 1) {
              one(places.quadratic_drag, "quadratic drag");
              k.require({"coefficient", "c in F = -c |v| v"}, forces.quadratic_drag, from_zero("kg/m"));
            } else if (kind == 2) {
              read_spring(k, forces.springs.emplace_back());
              places.springs.push_back(index);
            } else if (kind == 3) {
              one(places.attraction, "attraction");
              forces.attraction.emplace();
              k.require({"constant", "G"}, forces.attraction->constant, positive("N m²/kg²"));
              k.read({"softening", "of close encounters"}, forces.attraction->softening, from_zero("m"));
            } else {
              read_applied(k, forces.applied.emplace_back());
              places.applied.push_back(index);
            }
          });
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
