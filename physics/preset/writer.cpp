#include "physics/files/output_file.h"
#include "physics/preset/expectation_json.h"
#include "physics/preset/force_json.h"
#include "physics/preset/joint_json.h"
#include "physics/preset/method_json.h"
#include "physics/preset/names.h"
#include "physics/preset/object_writer.h"
#include "physics/preset/plot_json.h"
#include "physics/preset/preset.h"
#include "physics/preset/preset_file.h"
#include "physics/preset/preset_json.h"
#include "physics/preset/state_json.h"

namespace carom {
namespace {

Json shape_json(const Shape& shape) {
  if (const auto* disc = std::get_if<Disc>(&shape)) return {{"type", "disc"}, {"radius", disc->radius}};
  if (const auto* box = std::get_if<Box>(&shape))
    return {{"type", "box"}, {"width", box->width}, {"height", box->height}};
  if (const auto* polygon = std::get_if<Polygon>(&shape)) {
    Json vertices = Json::array();
    for (const Vec2& v : polygon->vertices) vertices.push_back(pair_json(v));
    Json j = {{"type", "polygon"}, {"vertices", vertices}};
    if (polygon->rounding != 0.0) j["rounding"] = polygon->rounding;
    return j;
  }
  Json j = {{"type", "wall"}};
  if (const Wall& wall = std::get<Wall>(shape); wall.length) j["length"] = *wall.length;
  return j;
}

Json drive_json(const Drive& d, bool all) {
  ObjectWriter w(all);
  w.json = Json::object();
  w.put("velocity", d.velocity, Vec2(Vec2::Zero()));
  w.put("amplitude", d.amplitude, Vec2(Vec2::Zero()));
  w.put("angular_frequency", d.angular_frequency, 0.0);
  w.put("phase", d.phase, 0.0);
  return w.json;
}

Json body_json(const Body& b, bool all) {
  ObjectWriter w(all);
  w.json["name"] = b.name;
  w.json["shape"] = shape_json(b.shape);
  w.json["position"] = pair_json(b.position);
  w.put("angle", b.angle, 0.0);
  w.all = all && !has_infinite_mass(b);
  w.put("velocity", b.velocity, Vec2(Vec2::Zero()));
  w.put("spin", b.spin, 0.0);
  if (b.mass) w.json["mass"] = *b.mass;
  if (b.density) w.json["density"] = *b.density;
  if (w.all && !b.mass && !b.density) w.json["density"] = 1.0;
  if (b.inertia) w.json["inertia"] = *b.inertia;
  if (b.fixed) w.json["fixed"] = true;
  if (b.drive) w.json["drive"] = drive_json(*b.drive, all);
  if (b.material != "default") w.json["material"] = b.material;
  if (!b.group.empty()) w.json["group"] = b.group;
  return w.json;
}

// Adds a surface to `j`, which has a name or the names of two materials.
Json surface_json(Json j, const Material& m) {
  j["restitution"] = m.restitution;
  j["tangential_restitution"] = m.tangential_restitution;
  j["static_friction"] = m.static_friction;
  j["kinetic_friction"] = m.kinetic_friction;
  j["rolling_resistance"] = m.rolling_resistance;
  if (m.sticks) j["sticks"] = true;
  return j;
}

Json generator_json(const GridGenerator& g) {
  return {{"type", "grid"},
          {"name", g.name},
          {"columns", g.columns},
          {"rows", g.rows},
          {"origin", pair_json(g.origin)},
          {"spacing", pair_json(g.spacing)},
          {"jitter", g.jitter},
          {"radius", Json::array({g.radius_min, g.radius_max})},
          {"speed", g.speed_max},
          {"density", g.density},
          {"material", g.material},
          {"seed", g.seed}};
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

Json preset_json(const Preset& preset, bool all) {
  Json j;
  j["format"] = "carom-preset";
  j["version"] = kPresetVersion;
  j["title"] = preset.title;
  if (!preset.about.empty()) j["about"] = preset.about;
  if (!preset.observe.empty()) j["observe"] = preset.observe;
  j["duration"] = preset.duration;
  j["gravity"] = pair_json(preset.scene.forces.gravity);
  j["method"] = method_json(preset.method, all);
  for (const Method& m : preset.compare) j["compare"].push_back(method_json(m, all));
  for (const Material& m : preset.scene.materials)
    j["materials"].push_back(surface_json({{"name", m.name}}, m));
  for (const MaterialPair& p : preset.scene.pairs)
    j["material_pairs"].push_back(surface_json({{"materials", {p.a, p.b}}}, p.surface));
  if (preset.scene.impact_law != ImpactLawId::kEnergetic)
    j["impact_law"] = name_of(kImpactLawNames, preset.scene.impact_law);
  if (preset.scene.several_impacts != SeveralImpactsId::kPairwise)
    j["several_impacts"] = name_of(kSeveralImpactsNames, preset.scene.several_impacts);
  for (const Body& b : preset.scene.bodies) j["bodies"].push_back(body_json(b, all));
  if (Json forces = forces_json(preset.scene.forces, all); !forces.empty()) j["forces"] = std::move(forces);
  for (const GridGenerator& g : preset.scene.generators) j["generators"].push_back(generator_json(g));
  for (const Joint& l : preset.scene.joints) j["links"].push_back(joint_json(l, all));
  for (const Plot& plot : preset.plots) j["plots"].push_back(plot_json(plot));
  if (preset.view) j["view"] = {{"center", pair_json(preset.view->center)}, {"width", preset.view->width}};
  for (const Expectation& e : preset.expect) j["expect"].push_back(expectation_json(e));
  if (preset.saved) j["state"] = state_json(*preset.saved);
  if (!preset.extra.empty()) j["extra"] = Json::parse(preset.extra);
  return j;
}

std::string write_preset(const Preset& preset) {
  std::string text;
  write_value(text, preset_json(preset, false), 0);
  text += '\n';
  return text;
}

void save_preset(const Preset& preset, const std::filesystem::path& file) {
  const std::string text = write_preset(preset);
  (void)parse_preset(text, file.string());
  OutputFile out(file.string());
  out.write(text);
  out.commit();
}

}  // namespace carom
