#include "physics/preset/joint_json.h"

#include "physics/preset/names.h"
#include "physics/preset/object_writer.h"

namespace carom {

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

}  // namespace carom
