#include "physics/preset/preset_file.h"

#include <fmt/format.h>

#include "physics/files/output_file.h"
#include "physics/preset/names.h"
#include "physics/preset/preset.h"
#include "physics/preset/preset_json.h"
#include "physics/preset/sections_json.h"
#include "physics/preset/value_reader.h"
#include "physics/scene/facts.h"

namespace carom {
namespace {

// The first two keys: what the file is.
void read_format(FieldReader& r) {
  r.needed({"format", "\"carom-preset\""}, [](const ValueReader& v) { (void)v.word({"carom-preset"}); });
  r.needed({"version", "1"}, [](const ValueReader& v) {
    if (v.has_value() && v.value().is_number_integer() && v.value().get<double>() > kPresetVersion) {
      throw SceneError(fmt::format(
          "/version: this preset has version {}, made by a newer Carom; this one reads up to version {}",
          quoted(v.value()), kPresetVersion));
    }
    (void)v.whole({kPresetVersion, kPresetVersion});
  });
}

// The section of a saved run is written by Carom alone: a fault of it is one of a rule.
template <class Read>
void of_saved_run(const Read& read) {
  try {
    read();
  } catch (const SceneError& error) {
    throw RuleError(Rule::kSavedRun, error.what());
  }
}

void read_preset_object(FieldReader& r, Preset& preset, ForcePlaces& places) {
  preset.method = unstated_method();
  read_format(r);
  head_fields(r, preset);
  r.member({"method", "how the run is computed"},
           [&](const ValueReader& v) { v.object([&](FieldReader& m) { fields(m, preset.method); }); });
  const auto each = [](auto& list) {
    return [&list](FieldReader& element, const std::string&) { fields(element, list.emplace_back()); };
  };
  r.read_objects({"compare", "other methods to run beside it"}, kMostCompared,
                 [&](FieldReader& element, const std::string&) {
                   fields(element, preset.compare.emplace_back(unstated_method()));
                 });
  r.read_objects({"materials", "surfaces"}, kMostMaterials, each(preset.scene.materials));
  r.read_objects({"bodies", "what moves, and what it meets"}, kMostBodies, each(preset.scene.bodies));
  int forces = 0;
  r.read_objects({"forces", "beside gravity"}, kMostForces, [&](FieldReader& element, const std::string& at) {
    read_force(element, at, forces++, preset.scene.forces, places);
  });
  r.read_objects({"material_pairs", "how two materials meet"}, kMostMaterialPairs, each(preset.scene.pairs));
  law_fields(r, preset.scene);
  r.read_objects({"generators", "many bodies from a few numbers"}, kMostBodies, each(preset.scene.generators));
  r.read_objects({"links", "rods, strings, pins and welds"}, kMostJoints, each(preset.scene.joints));
  r.read_objects({"added", "bodies that come in during a run"}, kMostBodies,
                 [&](FieldReader& element, const std::string&) {
                   LateBody late;
                   fields(element, late);
                   preset.edits.push_back({late.time, 0, SceneEdits{Add<Body>{late.body}}});
                 });
  r.read_objects({"stop", "where a run stops before its end"}, kMostStops, each(preset.stops));
  r.member({"plots", "to open with"}, [&](const ValueReader& v) {
    v.list({0, kMostPlots}, [&](const ValueReader& plot) { preset.plots.push_back(read_plot(plot)); });
  });
  window_fields(r, preset);
  r.read_objects(
      {"expect", "what the experiment must show"}, kMostExpectations,
      [&](FieldReader& e, const std::string&) { read_expectation(e, preset.expect.emplace_back()); });
  r.member({"state", "where a saved run goes on"}, [&](const ValueReader& v) {
    if (v.has_value()) {
      of_saved_run([&] { preset.saved = read_clock(v.value()); });
    } else {
      (void)v.free_object();
    }
  });
  r.member({"extra", "kept as it is"}, [&](const ValueReader& v) { preset.extra = v.free_object(); });
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

// Without what stops of this kind have by default: a wall stands beside no name.
Json stop_json(const Stop& stop) {
  return written_by(stop, false, [&stop](FieldReader& r, Stop& members) {
    members.kind = stop.kind;
    fields(r, members);
  });
}

}  // namespace

Preset preset_of(const Json& json) {
  Preset preset;
  ForcePlaces places;
  ValueReader(json, "").object([&](FieldReader& r) { read_preset_object(r, preset, places); });
  validate(preset, places);
  if (state_belongs(preset.scene, preset.saved))
    of_saved_run([&] { read_checkpoint(json.at("state"), preset); });
  resolve_places(preset, places);
  return preset;
}

Json preset_schema() {
  Preset preset;
  ForcePlaces places;
  FieldReader description;
  read_preset_object(description, preset, places);
  Json schema = {{"$schema", "http://json-schema.org/draft-07/schema#"},
                 {"title", "Carom preset"},
                 {"description", "An experiment of colliding bodies in a plane, in SI units"}};
  std::string rules = "The reader looks at these, too:";
  for (const RuleText& rule : kRules) rules += fmt::format(" {}", rule.text);
  schema["$comment"] = std::move(rules);
  schema.update(description.schema());
  return schema;
}

Preset parse_preset(std::string_view text, const std::string& origin) {
  const auto named = [&](const SceneError& error) {
    return fmt::format("{}: {}", shortened(origin, kMostOfFileName), error.what());
  };
  try {
    return preset_of(parse_json(text));
  } catch (const RuleError& error) {
    throw RuleError(error.rule, named(error));
  } catch (const SceneError& error) {
    throw SceneError(named(error));
  }
}

Preset read_preset(const std::filesystem::path& file) {
  Preset preset = parse_preset(file_text(file), file.string());
  preset.topic = valid_utf8(file.parent_path().filename().string());
  return preset;
}

Json preset_json(const Preset& preset, bool all) {
  Json j;
  j["format"] = "carom-preset";
  j["version"] = kPresetVersion;
  j["title"] = preset.title;
  if (!preset.about.empty()) j["about"] = preset.about;
  if (!preset.observe.empty()) j["observe"] = preset.observe;
  j["duration"] = preset.duration;
  j["gravity"] = pair_json(preset.scene.forces.gravity);
  j["method"] = written(preset.method, all);
  for (const Method& m : preset.compare) j["compare"].push_back(written(m, all));
  const auto put = [&](const char* key, const auto& list, bool whole) {
    for (const auto& each : list) j[key].push_back(written(each, whole));
  };
  put("materials", preset.scene.materials, false);
  put("material_pairs", preset.scene.pairs, false);
  j.update(written_by(SetLaws{preset.scene.impact_law, preset.scene.several_impacts}, false,
                      [](FieldReader& r, SetLaws& laws) { law_fields(r, laws); }));
  put("bodies", preset.scene.bodies, all);
  if (Json forces = forces_json(preset.scene.forces, all); !forces.empty()) j["forces"] = std::move(forces);
  put("generators", preset.scene.generators, true);
  for (const Joint& l : preset.scene.joints) j["links"].push_back(joint_json(l, all));
  for (const RunEdit& edit : preset.edits)
    j["added"].push_back(written(LateBody{edit.time, added_body(edit)}, all));
  for (const Stop& stop : preset.stops) j["stop"].push_back(stop_json(stop));
  for (const Plot& plot : preset.plots) j["plots"].push_back(plot_json(plot));
  if (preset.view) j["view"] = written(*preset.view, true);
  if (preset.tool != SceneTool::kSelect) j["tool"] = name_of(kSceneToolNames, preset.tool);
  for (const Expectation& e : preset.expect) j["expect"].push_back(written_by(e, false, read_expectation));
  if (preset.saved) j["state"] = state_json(*preset.saved, preset.scene);
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
