#include "physics/preset/link_json.h"

#include "physics/preset/names.h"
#include "physics/preset/object_reader.h"
#include "physics/preset/object_writer.h"

namespace carom {

Link read_link(const Json& json, const std::string& place) {
  Link link;
  ObjectReader r(json, place);
  r.require("type", quoted_names(kLinkNames));
  r.read_name("type", kLinkNames, link.kind);
  r.read("name", link.name);
  r.require_text("body", link.body);
  r.read("point", link.point);
  if (const Json* to = r.find("to")) {
    link.to = ObjectReader::text(*to, r.at("to"));
    if (link.to.empty()) refuse_value(r.at("to"), "an empty name", "the name of a body");
    r.read("anchor", link.anchor);
  } else {
    link.anchor = pair_of_numbers(
        r.require("anchor", "two numbers, [x, y], in m: a point of the plane, or \"to\": the name of a body"),
        r.at("anchor"));
  }
  r.read("length", link.length);
  r.read("angle", link.angle);
  r.finish();
  return link;
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
