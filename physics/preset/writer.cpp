#include <cstdio>
#include <fmt/format.h>
#include <fstream>
#include <system_error>

#include "physics/motion/integrators.h"
#include "physics/preset/json_text.h"
#include "physics/preset/names.h"
#include "physics/preset/preset.h"

namespace carom {
namespace {

Json pair(const Vec2& v) { return Json::array({v.x(), v.y()}); }

Json shape_json(const Shape& shape) {
  if (const auto* disc = std::get_if<Disc>(&shape)) return {{"type", "disc"}, {"radius", disc->radius}};
  const Box& box = std::get<Box>(shape);
  return {{"type", "box"}, {"width", box.width}, {"height", box.height}};
}

// Members that hold their default are left out, as people leave them out.
Json body_json(const Body& b) {
  Json j;
  j["name"] = b.name;
  j["shape"] = shape_json(b.shape);
  j["position"] = pair(b.position);
  if (b.angle != 0.0) j["angle"] = b.angle;
  if (!b.velocity.isZero(0.0)) j["velocity"] = pair(b.velocity);
  if (b.spin != 0.0) j["spin"] = b.spin;
  if (b.mass) j["mass"] = *b.mass;
  if (b.density) j["density"] = *b.density;
  if (b.fixed) j["fixed"] = true;
  if (b.material != "default") j["material"] = b.material;
  return j;
}

Json material_json(const Material& m) {
  return {{"name", m.name},
          {"restitution", m.restitution},
          {"tangential_restitution", m.tangential_restitution},
          {"static_friction", m.static_friction},
          {"kinetic_friction", m.kinetic_friction}};
}

Json generator_json(const GridGenerator& g) {
  return {{"type", "grid"},           {"name", g.name},
          {"columns", g.columns},     {"rows", g.rows},
          {"origin", pair(g.origin)}, {"spacing", pair(g.spacing)},
          {"jitter", g.jitter},       {"radius", Json::array({g.radius_min, g.radius_max})},
          {"speed", g.speed_max},     {"density", g.density},
          {"material", g.material},   {"seed", g.seed}};
}

Json expectation_json(const Expectation& e) {
  Json j;
  j["observable"] = e.observable;
  if (!e.bodies.empty()) j["bodies"] = e.bodies;
  for (const auto& [id, name] : kReductionNames) {
    if (id == e.reduction) j["reduction"] = name;
  }
  if (e.reduction == Expectation::Reduction::kAt) j["time"] = e.time;
  if (e.reduction == Expectation::Reduction::kAtImpact) j["impact"] = e.impact;
  j["value"] = e.value;
  j["tolerance"] = e.tolerance;
  if (!e.source.empty()) j["source"] = e.source;
  return j;
}

// Objects and arrays of the first two levels are spread over lines, deeper ones stay on one.
void write_value(std::string& out, const Json& value, int depth) {
  constexpr int kSpreadDepth = 2;
  const bool spread = value.is_structured() && !value.empty() && depth < kSpreadDepth &&
                      !(depth > 0 && value.is_array() && !value.front().is_structured());
  if (!spread) {
    std::string line = value.dump();
    // A space after each separator outside of texts.
    bool in_text = false;
    for (std::size_t i = 0; i < line.size(); ++i) {
      out += line[i];
      if (line[i] == '\\') {
        out += line[++i];
      } else if (line[i] == '"') {
        in_text = !in_text;
      } else if (!in_text && (line[i] == ',' || line[i] == ':')) {
        out += ' ';
      }
    }
    return;
  }
  const std::string indent(static_cast<std::size_t>(2 * (depth + 1)), ' ');
  out += value.is_array() ? '[' : '{';
  bool first = true;
  for (const auto& item : value.items()) {
    out += first ? "\n" : ",\n";
    first = false;
    out += indent;
    if (value.is_object()) out += Json(item.key()).dump() + ": ";
    write_value(out, item.value(), depth + 1);
  }
  out += '\n';
  out += indent.substr(2);
  out += value.is_array() ? ']' : '}';
}

}  // namespace

std::string write_preset(const Scene& scene) {
  Json j;
  j["format"] = "carom-preset";
  j["version"] = kPresetVersion;
  j["title"] = scene.title;
  if (!scene.about.empty()) j["about"] = scene.about;
  if (!scene.observe.empty()) j["observe"] = scene.observe;
  j["duration"] = scene.duration;
  j["gravity"] = pair(scene.forces.gravity);
  j["method"] = {{"integrator", choice_of(kIntegrators, scene.method.integrator).name},
                 {"impacts", choice_of(kImpacts, scene.method.impacts).name},
                 {"contacts", choice_of(kContacts, scene.method.contacts).name},
                 {"step", scene.method.step}};
  for (const Material& m : scene.materials) j["materials"].push_back(material_json(m));
  for (const Body& b : scene.bodies) j["bodies"].push_back(body_json(b));
  if (scene.forces.quadratic_drag != 0.0) {
    j["forces"].push_back({{"type", "quadratic_drag"}, {"coefficient", scene.forces.quadratic_drag}});
  }
  for (const Spring& s : scene.forces.springs) {
    j["forces"].push_back({{"type", "spring"},
                           {"body", s.body},
                           {"anchor", pair(s.anchor)},
                           {"stiffness", s.stiffness},
                           {"rest_length", s.rest_length}});
  }
  for (const GridGenerator& g : scene.generators) j["generators"].push_back(generator_json(g));
  if (!scene.plots.empty()) j["plots"] = scene.plots;
  if (scene.view) j["view"] = {{"center", pair(scene.view->center)}, {"width", scene.view->width}};
  for (const Expectation& e : scene.expect) j["expect"].push_back(expectation_json(e));
  if (!scene.extra.empty()) j["extra"] = Json::parse(scene.extra);
  std::string text;
  write_value(text, j, 0);
  text += '\n';
  return text;
}

void save_preset(const Scene& scene, const std::filesystem::path& file) {
  const std::string text = write_preset(scene);
  const std::filesystem::path part = file.string() + ".part";
  {
    std::ofstream out(part, std::ios::binary | std::ios::trunc);
    out << text;
    out.flush();
    if (!out) {
      std::error_code ignored;
      std::filesystem::remove(part, ignored);
      throw SceneError(fmt::format(
          "{}: the file cannot be written; allowed: a place with room and the right to write", file.string()));
    }
  }
  std::error_code error;
  std::filesystem::rename(part, file, error);
  if (error) {
    std::error_code ignored;
    std::filesystem::remove(part, ignored);
    throw SceneError(
        fmt::format("{}: the file cannot be replaced ({}); allowed: a place with the right to write",
                    file.string(), error.message()));
  }
}

}  // namespace carom
