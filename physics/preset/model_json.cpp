#include <fmt/format.h>

#include "physics/dynamics/integrators/integrators.h"
#include "physics/preset/names.h"
#include "physics/preset/object_writer.h"
#include "physics/preset/sections_json.h"

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

void read_method(FieldReader& r, Method& m) {
  r.read_choice({"integrator", "how free motion is advanced"}, kIntegrators, m.integrator);
  r.read_choice({"impacts", "when impacts are resolved"}, kImpacts, m.impacts);
  r.read_choice({"contacts", "how lasting contacts are treated"}, kContacts, m.contacts);
  r.read({"step", "length of a step, or interval of the results"}, m.step, kStepRange);
  r.read({"tolerance", "of the adaptive integrator, a step"}, m.tolerance, kToleranceRange);
}

Json method_json(const Method& m, bool all) {
  Json j = {{"integrator", choice_of(kIntegrators, m.integrator).name},
            {"impacts", choice_of(kImpacts, m.impacts).name},
            {"contacts", choice_of(kContacts, m.contacts).name},
            {"step", m.step}};
  if (all || choice_of(kIntegrators, m.integrator).adaptive || m.tolerance != Method{}.tolerance)
    j["tolerance"] = m.tolerance;
  return j;
}

void read_joint(FieldReader& r, Joint& joint) {
  r.read({"name", "its own, if any"}, joint.name, kPerhapsName);
  r.require({"body", "the name of a body that moves"}, joint.body, kName);
  r.read({"point", "of it, along its own axes, [x, y]"}, joint.point, any_number("m"));
  if (r.reads() && !r.has("to") && !r.has("anchor")) {
    refuse_value(r.at("anchor"), "a link without its other end",
                 "\"anchor\": [x, y], a point of the plane in m, or \"to\": the name of a body");
  }
  r.read({"to", "the body at the other end"}, joint.to, kName);
  r.read({"anchor", "the point of that body, or of the plane, [x, y]"}, joint.anchor, any_number("m"));
  r.also({{"anyOf", {{{"required", Json::array({"to"})}}, {{"required", Json::array({"anchor"})}}}}});
  r.cases({"type", "the kind of link"}, words_of(kJointNames), [&](std::size_t kind, FieldReader& k) {
    joint.kind = kJointNames[kind].first;
    if (joint.kind == JointKind::kRod || joint.kind == JointKind::kString)
      k.read({"length", "the distance at the start, or more of a string"}, joint.length, positive("m"));
    if (joint.kind == JointKind::kWeld)
      k.read({"angle", "the body's angle less that of the other"}, joint.angle, any_number("rad"));
  });
}

Json joint_json(const Joint& joint, bool all) {
  ObjectWriter w(all);
  w.json["type"] = name_of(kJointNames, joint.kind);
  w.put("name", joint.name, std::string());
  w.json["body"] = joint.body;
  w.put("point", joint.point, Vec2(Vec2::Zero()));
  if (joint.to.empty()) {
    w.json["anchor"] = pair_json(joint.anchor);
  } else {
    w.json["to"] = joint.to;
    w.put("anchor", joint.anchor, Vec2(Vec2::Zero()));
  }
  if (joint.length) w.json["length"] = *joint.length;
  if (joint.angle) w.json["angle"] = *joint.angle;
  return w.json;
}

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
