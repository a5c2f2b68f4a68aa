#include <fmt/format.h>

#include "physics/preset/expectation_json.h"
#include "physics/preset/file_text.h"
#include "physics/preset/force_json.h"
#include "physics/preset/joint_json.h"
#include "physics/preset/method_json.h"
#include "physics/preset/names.h"
#include "physics/preset/plot_json.h"
#include "physics/preset/preset.h"
#include "physics/preset/preset_file.h"
#include "physics/preset/preset_json.h"
#include "physics/preset/schema.h"
#include "physics/preset/setting.h"
#include "physics/preset/state_json.h"
#include "physics/preset/validate_preset.h"
#include "physics/preset/value_reader.h"
#include "physics/scene/fingerprint.h"
#include "physics/scene/polygon.h"

namespace carom {
namespace {

// How a surface behaves: the keys that materials and pairs of materials share.
void read_surface(FieldReader& r, Material& m) {
  r.read({"restitution", "rebound speed over closing speed"}, m.restitution, kRestitutionRange);
  r.read({"tangential_restitution", "reversed share of the slip"}, m.tangential_restitution,
         kTangentialRestitution);
  r.read({"kinetic_friction", "coefficient"}, m.kinetic_friction, kFrictionCoefficient);
  m.static_friction = m.kinetic_friction;
  r.read({"static_friction", "coefficient, kinetic_friction or more"}, m.static_friction, kFrictionCoefficient);
  r.read({"rolling_resistance", "moment over radius and normal force"}, m.rolling_resistance,
         kFrictionCoefficient);
  r.read({"sticks", "bodies stay joined from their first impact on"}, m.sticks);
}

void read_material(FieldReader& r, Material& m) {
  r.require({"name", "a name of its own"}, m.name, kName);
  read_surface(r, m);
}

void read_pair(FieldReader& r, MaterialPair& p) {
  r.needed({"materials", "the names of two materials, [\"a\", \"b\"]"}, [&](const ValueReader& names) {
    std::vector<std::string> two;
    names.list({2, 2}, [&](const ValueReader& name) { two.push_back(name.text(kName)); });
    p.a = two.front();
    p.b = two.back();
  });
  read_surface(r, p.surface);
}

void read_shape(FieldReader& r, Shape& shape) {
  r.cases(
      {"type", "the kind of shape"}, {"disc", "box", "polygon", "wall"}, [&](std::size_t kind, FieldReader& k) {
        if (kind == 0) {
          Disc disc;
          k.require({"radius", "of the disc; 0 for a point-like body"}, disc.radius, kDiscRadius);
          shape = disc;
        } else if (kind == 1) {
          Box box;
          k.require({"width", "along its own x axis"}, box.width, positive("m"));
          k.require({"height", "along its own y axis"}, box.height, positive("m"));
          shape = box;
        } else if (kind == 2) {
          Polygon polygon;
          k.needed({"vertices", "points of a convex polygon in order, [[x, y], ...], in m"},
                   [&](const ValueReader& v) {
                     v.list({2, kMostPolygonPoints},
                            [&](const ValueReader& p) { polygon.vertices.push_back(p.pair(any_number("m"))); });
                   });
          k.read({"rounding", "by which it grows on all sides"}, polygon.rounding, from_zero("m"));
          shape = std::move(polygon);
        } else {
          Wall wall;
          k.read({"length", "of a thin wall; without it a half-plane"}, wall.length, positive("m"));
          shape = wall;
        }
      });
}

void read_drive(FieldReader& r, Drive& d) {
  r.read({"velocity", "[x, y]"}, d.velocity, any_number("m/s"));
  r.read({"amplitude", "[x, y]"}, d.amplitude, any_number("m"));
  r.read({"angular_frequency", "of the oscillation"}, d.angular_frequency, from_zero("rad/s"));
  r.read({"phase", "of the oscillation"}, d.phase, any_number("rad"));
}

void read_body(FieldReader& r, Body& b) {
  r.require({"name", "a name of its own"}, b.name, kName);
  r.needed({"shape",
            "{\"type\": \"disc\", \"radius\": r}, {\"type\": \"box\", \"width\": w, \"height\": h}, {\"type\": "
            "\"polygon\", \"vertices\": [[x, y], ...]} or {\"type\": \"wall\"}"},
           [&](const ValueReader& v) { v.object([&](FieldReader& shape) { read_shape(shape, b.shape); }); });
  r.require({"position", "of the centre of mass, two numbers, [x, y]"}, b.position, any_number("m"));
  r.read({"angle", "counter-clockwise"}, b.angle, any_number("rad"));
  r.read({"velocity", "[x, y]"}, b.velocity, any_number("m/s"));
  r.read({"spin", "counter-clockwise"}, b.spin, any_number("rad/s"));
  r.read({"mass", "or a density"}, b.mass, positive("kg"));
  r.read({"density", "or a mass"}, b.density, positive("kg/m²"));
  r.also({{"not", {{"required", {"mass", "density"}}}}});
  r.read({"inertia", "about the centre of mass"}, b.inertia, positive("kg m²"));
  r.read({"fixed", "it never moves"}, b.fixed);
  r.member({"drive", "it moves as it is told"}, [&](const ValueReader& v) {
    v.object([&](FieldReader& drive) { read_drive(drive, b.drive.emplace()); });
  });
  r.read({"material", "the name of one"}, b.material, kName);
  r.read({"group", "bodies of one group do not collide with each other"}, b.group, kPerhapsName);
}

void read_generator(FieldReader& r, GridGenerator& g) {
  r.cases({"type", "the kind of generator"}, {"grid"}, [&](std::size_t, FieldReader& k) {
    k.require({"name", "the stem of the bodies' names"}, g.name, kStem);
    k.read({"columns", "discs side by side"}, g.columns, Whole{1, kMostBodies});
    k.read({"rows", "discs one over the other"}, g.rows, Whole{1, kMostBodies});
    k.require({"origin", "the first disc's centre, two numbers, [x, y]"}, g.origin, any_number("m"));
    k.read({"spacing", "from disc to disc, [x, y]"}, g.spacing, any_number("m"));
    k.read({"jitter", "by which each disc is moved at most"}, g.jitter, from_zero("m"));
    k.needed({"radius", "two numbers, [least, largest]"}, [&](const ValueReader& v) {
      const Vec2 radius = v.pair(positive("m"));
      g.radius_min = radius.x();
      g.radius_max = radius.y();
    });
    k.read({"speed", "largest velocity component"}, g.speed_max, from_zero("m/s"));
    k.read({"density", "of each disc"}, g.density, positive("kg/m²"));
    k.read({"material", "the name of one"}, g.material, kName);
    k.read({"seed", "of the random numbers"}, g.seed, Whole{0.0, 9e15});
  });
}

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

// Only Carom writes the section of a saved run, so any fault in it breaks the rule for saved runs.
template <class Read>
void of_saved_run(const Read& read) {
  try {
    read();
  } catch (const SceneError& error) {
    throw RuleError(Rule::kSavedRun, error.what());
  }
}

void read_preset_object(FieldReader& r, Preset& preset, ForcePlaces& places) {
  read_format(r);
  r.require({"title", "a few words"}, preset.title, kWords);
  r.read({"about", "what the experiment is, a paragraph"}, preset.about, kText);
  r.read({"observe", "what to look at, a few words"}, preset.observe, kText);
  r.read({"duration", "how long a run lasts"}, preset.duration, positive("s"));
  r.read({"gravity", "[x, y]"}, preset.scene.forces.gravity, any_number("m/s²"));
  r.member({"method", "how the run is computed"},
           [&](const ValueReader& v) { v.object([&](FieldReader& m) { read_method(m, preset.method); }); });
  const auto each = [](auto& list, const auto& read) {
    return [&list, read](FieldReader& element, const std::string&) { read(element, list.emplace_back()); };
  };
  r.read_objects({"compare", "other methods to run beside it"}, kMostCompared,
                 each(preset.compare, read_method));
  r.read_objects({"materials", "surfaces"}, kMostMaterials, each(preset.scene.materials, read_material));
  r.read_objects({"bodies", "what moves, and what it meets"}, kMostBodies,
                 each(preset.scene.bodies, read_body));
  int forces = 0;
  r.read_objects({"forces", "beside gravity"}, kMostForces, [&](FieldReader& element, const std::string& at) {
    read_force(element, at, forces++, preset.scene.forces, places);
  });
  r.read_objects({"material_pairs", "how two materials meet"}, kMostMaterialPairs,
                 each(preset.scene.pairs, read_pair));
  r.read_choice({"impact_law", "of impacts off the line of centres"}, kImpactLawNames, preset.scene.impact_law);
  r.read_choice({"several_impacts", "contacts that close at one time"}, kSeveralImpactsNames,
                preset.scene.several_impacts);
  r.read_objects({"generators", "many bodies from a few numbers"}, kMostBodies,
                 each(preset.scene.generators, read_generator));
  r.read_objects({"links", "rods, strings, pins and welds"}, kMostJoints,
                 each(preset.scene.joints, read_joint));
  r.member({"plots", "to open with"}, [&](const ValueReader& v) {
    v.list({0, kMostPlots}, [&](const ValueReader& plot) { preset.plots.push_back(read_plot(plot)); });
  });
  r.member({"view", "what the window shows at first"}, [&](const ValueReader& v) {
    v.object([&](FieldReader& view) {
      preset.view.emplace();
      view.read({"center", "[x, y]"}, preset.view->center, any_number("m"));
      view.require({"width", "of the part that is shown"}, preset.view->width, positive("m"));
    });
  });
  r.read_objects({"expect", "what the experiment must show"}, kMostExpectations,
                 each(preset.expect, read_expectation));
  r.member({"state", "where a saved run goes on"}, [&](const ValueReader& v) {
    if (v.has_value()) {
      of_saved_run([&] { preset.saved = read_clock(v.value()); });
    } else {
      (void)v.free_object();
    }
  });
  r.member({"extra", "kept as it is"}, [&](const ValueReader& v) { preset.extra = v.free_object(); });
}

}  // namespace

Preset preset_of(const Json& json) {
  Preset preset;
  ForcePlaces places;
  ValueReader(json, "").object([&](FieldReader& r) { read_preset_object(r, preset, places); });
  validate(preset, places);
  if (state_belongs(preset.scene, preset.saved)) of_saved_run([&] { read_state(json.at("state"), preset); });
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
  Preset preset = parse_preset(file_text(file, "a preset file"), file.string());
  preset.topic = valid_utf8(file.parent_path().filename().string());
  return preset;
}

}  // namespace carom
