#include <cmath>
#include <fmt/format.h>
#include <fstream>
#include <set>
#include <sstream>
#include <system_error>

#include "physics/measure/observables.h"
#include "physics/motion/integrators.h"
#include "physics/preset/json_text.h"
#include "physics/preset/names.h"
#include "physics/preset/preset.h"

namespace carom {
namespace {

double number(const Json& value, const std::string& place) {
  if (!value.is_number()) refuse_value(place, quoted(value), "a number");
  const auto x = value.get<double>();
  if (!(std::abs(x) <= kLargestNumber))
    refuse_value(place, quoted(value), fmt::format("a number from -{0} to {0}", kLargestNumber));
  return x;
}

Vec2 pair_of_numbers(const Json& value, const std::string& place) {
  if (!value.is_array() || value.size() != 2) refuse_value(place, quoted(value), "two numbers, [x, y]");
  return {number(value[0], place + "/0"), number(value[1], place + "/1")};
}

// Reads the members of one object and, at the end, refuses those that nobody asked for.
class ObjectReader {
 public:
  ObjectReader(const Json& object, std::string place) : object_(object), place_(std::move(place)) {
    if (!object.is_object()) refuse_value(place_, quoted(object), "an object, {...}");
  }

  [[nodiscard]] std::string at(std::string_view key) const { return fmt::format("{}/{}", place_, key); }

  const Json* find(const std::string& key) {
    known_.insert(key);
    const auto found = object_.find(key);
    return found == object_.end() ? nullptr : &*found;
  }
  const Json& require(const std::string& key, std::string_view allowed) {
    const Json* value = find(key);
    if (value == nullptr)
      throw SceneError(
          fmt::format("{}: \"{}\" is missing; allowed: {}", place_.empty() ? "/" : place_, key, allowed));
    return *value;
  }

  void read(const std::string& key, double& to) {
    if (const Json* v = find(key)) to = number(*v, at(key));
  }
  void read(const std::string& key, std::optional<double>& to) {
    if (const Json* v = find(key)) to = number(*v, at(key));
  }
  void read(const std::string& key, Vec2& to) {
    if (const Json* v = find(key)) to = pair_of_numbers(*v, at(key));
  }
  void read(const std::string& key, bool& to) {
    if (const Json* v = find(key)) {
      if (!v->is_boolean()) refuse_value(at(key), quoted(*v), "true or false");
      to = v->get<bool>();
    }
  }
  void read(const std::string& key, std::string& to) {
    if (const Json* v = find(key)) to = text(*v, at(key));
  }
  template <class Integer>
  void read_integer(const std::string& key, Integer& to, double low, double high) {
    if (const Json* v = find(key)) {
      if (!v->is_number_integer() || v->get<double>() < low || v->get<double>() > high) {
        refuse_value(at(key), quoted(*v), fmt::format("a whole number from {} to {}", low, high));
      }
      to = v->get<Integer>();
    }
  }
  void require_number(const std::string& key, double& to, std::string_view unit) {
    to = number(require(key, fmt::format("a number, in {}", unit)), at(key));
  }
  void require_text(const std::string& key, std::string& to) { to = text(require(key, "a text"), at(key)); }

  // One of the names of a table of Choice.
  template <class Table, class Id>
  void read_choice(const std::string& key, const Table& table, Id& to) {
    const Json* v = find(key);
    if (v == nullptr) return;
    std::string names;
    for (const auto& choice : table) {
      if (v->is_string() && v->template get_ref<const std::string&>() == choice.name) {
        to = choice.id;
        return;
      }
      names += fmt::format("{}\"{}\"", names.empty() ? "" : ", ", choice.name);
    }
    refuse_value(at(key), quoted(*v), names);
  }

  // Calls each(element, place) for every element of an array.
  template <class Each>
  void read_array(const std::string& key, const Each& each) {
    const Json* v = find(key);
    if (v == nullptr) return;
    if (!v->is_array()) refuse_value(at(key), quoted(*v), "an array, [...]");
    for (std::size_t i = 0; i < v->size(); ++i) each((*v)[i], fmt::format("{}/{}", at(key), i));
  }

  void finish() const {
    for (const auto& item : object_.items()) {
      if (known_.contains(item.key())) continue;
      std::string allowed;
      for (const std::string& key : known_) allowed += (allowed.empty() ? "" : ", ") + key;
      throw SceneError(
          fmt::format("{}: unknown key; allowed here: {}", at(shortened(item.key())), shortened(allowed, 300)));
    }
  }

  static std::string text(const Json& value, const std::string& place) {
    if (!value.is_string()) refuse_value(place, quoted(value), "a text, \"...\"");
    return value.get<std::string>();
  }

 private:
  const Json& object_;
  std::string place_;
  std::set<std::string> known_;
};

Method read_method(const Json& json, const std::string& place) {
  Method m;
  ObjectReader r(json, place);
  r.read_choice("integrator", kIntegrators, m.integrator);
  r.read_choice("impacts", kImpacts, m.impacts);
  r.read_choice("contacts", kContacts, m.contacts);
  r.read("step", m.step);
  r.finish();
  return m;
}

Material read_material(const Json& json, const std::string& place) {
  Material m;
  ObjectReader r(json, place);
  r.require_text("name", m.name);
  r.read("restitution", m.restitution);
  r.read("tangential_restitution", m.tangential_restitution);
  r.read("kinetic_friction", m.kinetic_friction);
  m.static_friction = m.kinetic_friction;
  r.read("static_friction", m.static_friction);
  r.finish();
  return m;
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
  } else {
    refuse_value(r.at("type"), "\"" + type + "\"", "\"disc\", \"box\"");
  }
  r.finish();
  return shape;
}

Body read_body(const Json& json, const std::string& place) {
  Body b;
  ObjectReader r(json, place);
  r.require_text("name", b.name);
  b.shape = read_shape(
      r.require("shape",
                "{\"type\": \"disc\", \"radius\": r} or {\"type\": \"box\", \"width\": w, \"height\": h}"),
      r.at("shape"));
  b.position = pair_of_numbers(r.require("position", "two numbers, [x, y], in m"), r.at("position"));
  r.read("angle", b.angle);
  r.read("velocity", b.velocity);
  r.read("spin", b.spin);
  r.read("mass", b.mass);
  r.read("density", b.density);
  r.read("fixed", b.fixed);
  r.read("material", b.material);
  r.finish();
  return b;
}

void read_force(const Json& json, const std::string& place, Forces& forces) {
  ObjectReader r(json, place);
  std::string type;
  r.require_text("type", type);
  if (type == "quadratic_drag") {
    if (forces.quadratic_drag != 0.0) refuse_value(place, "a second quadratic drag", "one");
    r.require_number("coefficient", forces.quadratic_drag, "kg/m");
  } else if (type == "spring") {
    Spring s;
    r.require_text("body", s.body);
    s.anchor = pair_of_numbers(r.require("anchor", "two numbers, [x, y], in m"), r.at("anchor"));
    r.require_number("stiffness", s.stiffness, "N/m");
    r.read("rest_length", s.rest_length);
    forces.springs.push_back(s);
  } else {
    refuse_value(r.at("type"), "\"" + type + "\"", "\"quadratic_drag\", \"spring\"");
  }
  r.finish();
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

Expectation read_expectation(const Json& json, const std::string& place) {
  Expectation e;
  ObjectReader r(json, place);
  r.require_text("observable", e.observable);
  const Observable* observable = find_observable(e.observable);
  if (observable == nullptr) {
    std::string names;
    for (const Observable& o : observables()) names += fmt::format("{}{}", names.empty() ? "" : ", ", o.name);
    refuse_value(r.at("observable"), "\"" + e.observable + "\"", names);
  }
  r.read_array("bodies",
               [&](const Json& v, const std::string& at) { e.bodies.push_back(ObjectReader::text(v, at)); });
  if (static_cast<int>(e.bodies.size()) != observable->bodies) {
    refuse_value(r.at("bodies"), fmt::format("{} names", e.bodies.size()),
                 fmt::format("{} for \"{}\"", observable->bodies, e.observable));
  }
  std::string reduction;
  r.require_text("reduction", reduction);
  std::string names;
  bool known = false;
  for (const auto& [id, name] : kReductionNames) {
    if (name == reduction) {
      e.reduction = id;
      known = true;
    }
    names += fmt::format("{}\"{}\"", names.empty() ? "" : ", ", name);
  }
  if (!known) refuse_value(r.at("reduction"), "\"" + reduction + "\"", names);
  if (e.reduction == Expectation::Reduction::kAt) r.require_number("time", e.time, "s");
  if (e.reduction == Expectation::Reduction::kAtImpact) {
    (void)r.require("impact", "1, 2, ...");
    r.read_integer("impact", e.impact, 1, 1e9);
  }
  r.require_number("value", e.value, observable->unit);
  r.require_number("tolerance", e.tolerance, observable->unit);
  r.read("source", e.source);
  r.finish();
  return e;
}

Scene read_scene(const Json& json) {
  Scene scene;
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
  r.read_array("materials",
               [&](const Json& v, const std::string& at) { scene.materials.push_back(read_material(v, at)); });
  r.read_array("bodies",
               [&](const Json& v, const std::string& at) { scene.bodies.push_back(read_body(v, at)); });
  r.read_array("forces", [&](const Json& v, const std::string& at) { read_force(v, at, scene.forces); });
  r.read_array("generators", [&](const Json& v, const std::string& at) {
    scene.generators.push_back(read_generator(v, at));
  });
  r.read_array("plots", [&](const Json& v, const std::string& at) {
    const std::string name = ObjectReader::text(v, at);
    if (std::find(kPlotNames.begin(), kPlotNames.end(), name) == kPlotNames.end()) {
      refuse_value(at, quoted(v), fmt::format("\"{}\"", fmt::join(kPlotNames, "\", \"")));
    }
    scene.plots.push_back(name);
  });
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
  if (const Json* v = r.find("extra")) {
    if (!v->is_object()) refuse_value("/extra", quoted(*v), "an object, {...}");
    scene.extra = v->dump();
  }
  r.finish();
  return scene;
}

}  // namespace

Scene parse_preset(std::string_view text, const std::string& origin) {
  try {
    Scene scene = read_scene(parse_json(text));
    validate(scene);
    return scene;
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
