#include "physics/preset/link_json.h"

#include "physics/preset/names.h"
#include "physics/preset/object_writer.h"

namespace carom {

void read_link(FieldReader& r, Link& link) {
  r.read({"name", "its own, if any"}, link.name, kPerhapsName);
  r.require({"body", "the name of a body that moves"}, link.body, kName);
  r.read({"point", "of it, along its own axes, [x, y]"}, link.point, any_number("m"));
  if (r.reads() && !r.has("to") && !r.has("anchor")) {
    refuse_value(r.at("anchor"), "a link without its other end",
                 "\"anchor\": [x, y], a point of the plane in m, or \"to\": the name of a body");
  }
  r.read({"to", "the body at the other end"}, link.to, kName);
  r.read({"anchor", "the point of that body, or of the plane, [x, y]"}, link.anchor, any_number("m"));
  r.also({{"anyOf", {{{"required", Json::array({"to"})}}, {{"required", Json::array({"anchor"})}}}}});
  r.cases({"type", "the kind of link"}, words_of(kLinkNames), [&](std::size_t kind, FieldReader& k) {
    link.kind = kLinkNames[kind].first;
    if (link.kind == LinkKind::kRod || link.kind == LinkKind::kString)
      k.read({"length", "the distance at the start, or more of a string"}, link.length, positive("m"));
    if (link.kind == LinkKind::kWeld)
      k.read({"angle", "the body's angle less that of the other"}, link.angle, any_number("rad"));
  });
}

Json link_json(const Link& link, bool all) {
  ObjectWriter w(all);
  w.json["type"] = name_of(kLinkNames, link.kind);
  w.put("name", link.name, std::string());
  w.json["body"] = link.body;
  w.put("point", link.point, Vec2(Vec2::Zero()));
  if (link.to.empty()) {
    w.json["anchor"] = pair_json(link.anchor);
  } else {
    w.json["to"] = link.to;
    w.put("anchor", link.anchor, Vec2(Vec2::Zero()));
  }
  if (link.length) w.json["length"] = *link.length;
  if (link.angle) w.json["angle"] = *link.angle;
  return w.json;
}

}  // namespace carom
