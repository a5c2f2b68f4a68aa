#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <fstream>
#include <sstream>
#include <system_error>

#include "physics/preset/expectation_json.h"
#include "physics/preset/force_json.h"
#include "physics/preset/link_json.h"
#include "physics/preset/method_json.h"
#include "physics/preset/names.h"
#include "physics/preset/object_reader.h"
#include "physics/preset/plot_json.h"
#include "physics/preset/preset.h"
#include "physics/preset/preset_json.h"
#include "physics/preset/setting.h"
#include "physics/preset/state_json.h"
#include "physics/scene/fingerprint.h"

namespace carom {
namespace {

// How a surface behaves: the keys that materials and pairs of materials share.
void read_surface(ObjectReader& r, Material& m) {
  r.read("restitution", m.restitution);
  r.read("tangential_restitution", m.tangential_restitution);
  r.read("kinetic_friction", m.kinetic_friction);
  m.static_friction = m.kinetic_friction;
  r.read("static_friction", m.static_friction);
  r.read("rolling_resistance", m.rolling_resistance);
  r.read("sticks", m.sticks);
}

Material read_material(const Json& json, const std::string& place) {
  Material m;
  ObjectReader r(json, place);
  r.require_text("name", m.name);
  read_surface(r, m);
  r.finish();
  return m;
}

MaterialPair read_pair(const Json& json, const std::string& place) {
  MaterialPair p;
  ObjectReader r(json, place);
  const std::string_view allowed = "the names of two materials, [\"a\", \"b\"]";
  const Json& names = r.require("materials", allowed);
  if (!names.is_array() || names.size() != 2)
    refuse_value(r.at("materials"), quoted(names), std::string(allowed));
  p.a = ObjectReader::text(names[0], r.at("materials/0"));
  p.b = ObjectReader::text(names[1], r.at("materials/1"));
  read_surface(r, p.surface);
  r.finish();
  return p;
}

Shape read_shape(const Json& json, const std::string& place) {
  ObjectReader r(json, place);
  std::string type;
  r.require_text("type", type);
  Shape shape;
  if (type == "disc") {
    Disc disc;
    r.require_number("radius", disc.radius, "m");
    shape = disc;
  } else if (type == "box") {
    Box box;
    r.require_number("width", box.width, "m");
    r.require_number("height", box.height, "m");
    shape = box;
  } else if (type == "polygon") {
    Polygon polygon;
    (void)r.require("vertices", "an array of points, [[x, y], ...], in m");
    r.read_array("vertices", [&](const Json& v, const std::string& at) {
      polygon.vertices.push_back(pair_of_numbers(v, at));
    });
    r.read("rounding", polygon.rounding);
    shape = std::move(polygon);
  } else if (type == "wall") {
    Wall wall;
    r.read("length", wall.length);
    shape = wall;
  } else {
    refuse_value(r.at("type"), "\"" + type + "\"", "\"disc\", \"box\", \"polygon\", \"wall\"");
  }
  r.finish();
  return shape;
}

Drive read_drive(const Json& json, const std::string& place) {
  Drive d;
  ObjectReader r(json, place);
  r.read("velocity", d.velocity);
  r.read("amplitude", d.amplitude);
  r.read("angular_frequency", d.angular_frequency);
  r.read("phase", d.phase);
  r.finish();
  return d;
}

Body read_body(const Json& json, const std::string& place) {
  Body b;
  ObjectReader r(json, place);
  r.require_text("name", b.name);
  b.shape = read_shape(
      r.require(
          "shape",
          "{\"type\": \"disc\", \"radius\": r}, {\"type\": \"box\", \"width\": w, \"height\": h}, {\"type\": "
          "\"polygon\", \"vertices\": [[x, y], ...]} or {\"type\": \"wall\"}"),
      r.at("shape"));
  b.position = pair_of_numbers(r.require("position", "two numbers, [x, y], in m"), r.at("position"));
  r.read("angle", b.angle);
  r.read("velocity", b.velocity);
  r.read("spin", b.spin);
  r.read("mass", b.mass);
  r.read("density", b.density);
  r.read("inertia", b.inertia);
  r.read("fixed", b.fixed);
  if (const Json* v = r.find("drive")) b.drive = read_drive(*v, r.at("drive"));
  r.read("material", b.material);
  r.read("group", b.group);
  r.finish();
  return b;
}

GridGenerator read_generator(const Json& json, const std::string& place) {
  GridGenerator g;
  ObjectReader r(json, place);
  std::string type;
  r.require_text("type", type);
  if (type != "grid") refuse_value(r.at("type"), "\"" + type + "\"", "\"grid\"");
  r.require_text("name", g.name);
  r.read_integer("columns", g.columns, 1, kMostBodies);
  r.read_integer("rows", g.rows, 1, kMostBodies);
  g.origin = pair_of_numbers(r.require("origin", "two numbers, [x, y], in m"), r.at("origin"));
  r.read("spacing", g.spacing);
  r.read("jitter", g.jitter);
  const Vec2 radius =
      pair_of_numbers(r.require("radius", "two numbers, [least, largest], in m"), r.at("radius"));
  g.radius_min = radius.x();
  g.radius_max = radius.y();
  r.read("speed", g.speed_max);
  r.read("density", g.density);
  r.read("material", g.material);
  r.read_integer("seed", g.seed, 0.0, 9e15);
  r.finish();
  return g;
}

}  // namespace

Scene scene_of(const Json& json) {
  Scene scene;
  ForcePlaces places;
  ObjectReader r(json, "");
  const Json& format = r.require("format", "\"carom-preset\"");
  if (format != "carom-preset") refuse_value("/format", quoted(format), "\"carom-preset\"");
  const Json& version = r.require("version", fmt::format("{}", kPresetVersion));
  if (!version.is_number_integer() || version.get<double>() < 1)
    refuse_value("/version", quoted(version), fmt::format("{}", kPresetVersion));
  if (version.get<double>() > kPresetVersion) {
    throw SceneError(fmt::format(
        "/version: this preset has version {}, made by a newer Carom; this one reads up to version {}",
        quoted(version), kPresetVersion));
  }
  r.require_text("title", scene.title);
  r.read("about", scene.about);
  r.read("observe", scene.observe);
  r.read("duration", scene.duration);
  r.read("gravity", scene.forces.gravity);
  if (const Json* v = r.find("method")) scene.method = read_method(*v, "/method");
  r.read_array("compare",
               [&](const Json& v, const std::string& at) { scene.compare.push_back(read_method(v, at)); });
  r.read_array("materials",
               [&](const Json& v, const std::string& at) { scene.materials.push_back(read_material(v, at)); });
  r.read_array("bodies",
               [&](const Json& v, const std::string& at) { scene.bodies.push_back(read_body(v, at)); });
  int forces = 0;
  r.read_array("forces",
               [&](const Json& v, const std::string&) { read_force(v, forces++, scene.forces, places); });
  r.read_array("material_pairs",
               [&](const Json& v, const std::string& at) { scene.pairs.push_back(read_pair(v, at)); });
  r.read_name("impact_law", kImpactLawNames, scene.impact_law);
  r.read_name("several_impacts", kSeveralImpactsNames, scene.several_impacts);
  r.read_array("generators", [&](const Json& v, const std::string& at) {
    scene.generators.push_back(read_generator(v, at));
  });
  r.read_array("links", [&](const Json& v, const std::string& at) { scene.links.push_back(read_link(v, at)); });
  r.read_array("plots", [&](const Json& v, const std::string& at) { scene.plots.push_back(read_plot(v, at)); });
  if (const Json* v = r.find("view")) {
    View view;
    ObjectReader inner(*v, "/view");
    inner.read("center", view.center);
    inner.require_number("width", view.width, "m");
    inner.finish();
    scene.view = view;
  }
  r.read_array("expect",
               [&](const Json& v, const std::string& at) { scene.expect.push_back(read_expectation(v, at)); });
  const Json* state = r.find("state");
  if (state != nullptr) scene.saved = read_clock(*state);
  if (const Json* v = r.find("extra")) {
    if (!v->is_object()) refuse_value("/extra", quoted(*v), "an object, {...}");
    scene.extra = v->dump();
  }
  r.finish();
  validate(scene, places);
  if (state_belongs(scene)) read_state(*state, scene);
  settle_places(scene, places);
  return scene;
}

Scene parse_preset(std::string_view text, const std::string& origin) {
  try {
    return scene_of(parse_json(text));
  } catch (const SceneError& error) {
    throw SceneError(fmt::format("{}: {}", origin, error.what()));
  }
}

Scene read_preset(const std::filesystem::path& file) {
  std::error_code error;
  if (std::filesystem::is_directory(file, error)) {
    throw SceneError(fmt::format("{}: this is a folder; allowed: a preset file", file.string()));
  }
  std::ifstream in(file, std::ios::binary);
  if (!in)
    throw SceneError(
        fmt::format("{}: the file cannot be read; allowed: a readable preset file", file.string()));
  std::ostringstream text;
  text << in.rdbuf();
  Scene scene = parse_preset(text.view(), file.string());
  scene.topic = file.parent_path().filename().string();
  return scene;
}

}  // namespace carom
