#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>

#include "widgets/edit/field_rows.h"
#include "widgets/edit/inspected.h"
#include "widgets/edit/units.h"

namespace carom {
namespace {

constexpr std::size_t kMostShown = 20;  // surfaces, and pairs of them

struct SurfaceLine {
  const char* key;    // as its fields have it
  const char* name;   // in sentences and undo names; UTF-8
  const char* label;  // UTF-8
};
constexpr auto kSurfaceLines = std::to_array<SurfaceLine>({
    {"restitution", "e", "Bounce e"},
    {"kinetic_friction", "µ", "Friction µ"},
    {"static_friction", "µs", "Static µs"},
    {"rolling_resistance", "Rolling resistance", "Rolling"},
});
constexpr std::size_t kMainLines = 2;  // what most lessons are about: first e

QString text_of(const std::string& text) { return QString::fromStdString(text); }

// Static friction is never less than kinetic friction: it rises with it, and stops there.
Material with_number(Material material, const FieldPlace& place, double value) {
  if (place.key == "static_friction") value = std::max(value, material.kinetic_friction);
  material = with_field(std::move(material), place, value);
  if (place.key == "kinetic_friction") material.static_friction = std::max(material.static_friction, value);
  return material;
}

// A surface in the scene: that of a material or of a pair.
struct Surface {
  Material law;
  QString name;     // "wood", "wood on rubber"
  QString section;  // its head
  std::function<SceneEdit(const Material&)> edit;
};

Surface surface_of(const Material& material) {
  const QString name = text_of(material.name);
  return {material, name, "Surface " + name, [](const Material& changed) -> SceneEdit {
            // "default", if the scene doesn't list it, is added.
            if (changed.id.number == 0) return Add<Material>{changed, Add<Material>::kAtEnd};
            return Replace<Material>{changed};
          }};
}

Surface surface_of(const MaterialPair& pair) {
  const QString name = text_of(pair.a) + " on " + text_of(pair.b);
  return {pair.surface, name, "Pair " + name, [pair](const Material& changed) -> SceneEdit {
            MaterialPair replaced = pair;
            replaced.surface = changed;
            return Replace<MaterialPair>{replaced};
          }};
}

Inspected surface_value(const Surface& surface, const FieldRow& row, const char* name) {
  Inspected value;
  value.name = QString::fromUtf8(name);
  value.subject = surface.name;
  value.meaning = row.meaning;
  value.range = row.range;
  value.values = {std::get<double>(row.value)};
  value.edits = [surface, place = row.place](const std::vector<double>& values) {
    return SceneEdits{surface.edit(with_number(surface.law, place, values[0]))};
  };
  if (row.place.key == "static_friction") {
    value.fault = [least = surface.law.kinetic_friction](const std::vector<double>& values) {
      return values[0] >= least
                 ? QString()
                 : QString::fromUtf8("µs is never less than the friction µ, %1 here: lower µ first.")
                       .arg(field_text(least, {}));
    };
  }
  // What rises with it is said too.
  const double followed = row.place.key == "kinetic_friction" ? surface.law.static_friction : HUGE_VAL;
  value.undo_name = [text = value.name + " of " + value.subject + " ", unit = row.range.unit, followed](
                        const std::vector<double>& from, const std::vector<double>& to) {
    const QString changed = text + change_text(from[0], to[0], unit);
    return to[0] > followed ? changed + QString::fromUtf8(", µs too") : changed;
  };
  return value;
}

void add_numbers(std::vector<InspectedRow>& shown, const Surface& surface) {
  const std::vector<FieldRow> rows = field_rows(surface.law);
  for (const SurfaceLine& line : kSurfaceLines) {
    for (const FieldRow& row : rows) {
      if (row.place.key == line.key)
        shown.push_back({.section = surface.section,
                         .label = QString::fromUtf8(line.label),
                         .values = {surface_value(surface, row, line.name)}});
    }
  }
}

void add_sticks(std::vector<InspectedRow>& shown, const Surface& surface) {
  InspectedChoice choice;
  choice.name = "Sticking of " + surface.name;
  choice.meaning = "Whether bodies stay joined from their first impact on";
  choice.words = QStringList{"no", "from the first impact on"};
  choice.chosen = surface.law.sticks ? 1 : 0;
  choice.edits = [surface](int index) {
    Material changed = surface.law;
    changed.sticks = index == 1;
    return NamedEdits{{surface.edit(changed)}, surface.name + (changed.sticks ? " sticks" : " doesn't stick")};
  };
  shown.push_back({.section = surface.section, .label = "Sticks", .choice = choice});
}

void add_name(std::vector<InspectedRow>& shown, const Material& material) {
  InspectedName named;
  named.name = "Name of surface " + text_of(material.name);
  named.of = "A surface";
  named.text = text_of(material.name);
  named.edits = [material](const QString& name) {
    Material renamed = material;
    renamed.name = name.toStdString();
    return NamedEdits{{Replace<Material>{renamed}}, "Rename " + text_of(material.name) + " to " + name};
  };
  shown.push_back({.section = surface_of(material).section, .label = "Name", .named = named});
}

// Who needs a surface, in one sentence; empty: nobody.
QString use_of(const Scene& scene, const std::string& material) {
  const auto has_it = [&](const auto& part) { return part.material == material; };
  const auto wears_it = [&](const Body& body) {
    bool wears = false;
    each_material(body, [&](const std::string& worn) { wears = wears || worn == material; });
    return wears;
  };
  const QString name = text_of(material);
  const auto body = std::find_if(scene.bodies.begin(), scene.bodies.end(), wears_it);
  if (body != scene.bodies.end()) {
    const auto count = std::count_if(body, scene.bodies.end(), wears_it);
    const QString who = text_of(body->name) + (count > 1 ? QString(" and %1 more").arg(count - 1) : QString());
    return QString("%1 is the surface of %2.").arg(name, who);
  }
  const auto grid = std::find_if(scene.generators.begin(), scene.generators.end(), has_it);
  if (grid != scene.generators.end())
    return QString("%1 is the surface of the grid of %2.").arg(name, text_of(grid->name));
  for (const MaterialPair& pair : scene.pairs) {
    if (pair.a == material || pair.b == material)
      return QString("%1 has a law of its own with %2.")
          .arg(name, text_of(pair.a == material ? pair.b : pair.a));
  }
  return {};
}

InspectedAction removal(const Scene& scene, const Material& material) {
  const QString name = text_of(material.name);
  return {.text = "Remove",
          .name = "Remove surface " + name,
          .meaning = "Takes this surface out of the scene",
          .edits = {{Remove<Material>{material.id}}, "Remove surface " + name},
          .refusal = use_of(scene, material.name)};
}

InspectedRow addition(const Scene& scene) {
  Material added;
  added.name = free_surface_name(scene, "surface");
  const QString text = "Add surface " + text_of(added.name);
  return {.section = "More surfaces",
          .actions = {{.text = "Add a surface",
                       .meaning = "A new one, for any body",
                       .edits = {{Add<Material>{added}}, text}}}};
}

// The names that bodies can have for their surface.
std::vector<std::string> material_names(const Scene& scene) {
  std::vector<std::string> names;
  for (const Material& material : scene.materials) names.push_back(material.name);
  const std::string plain = Material{}.name;
  if (std::find(names.begin(), names.end(), plain) == names.end()) names.push_back(plain);
  return names;
}

// One of the two names of a pair.
InspectedRow side(const Scene& scene, const MaterialPair& pair, std::string MaterialPair::*name) {
  const std::vector<std::string> names = material_names(scene);
  const bool first = name == &MaterialPair::a;
  InspectedChoice choice;
  choice.name = (first ? "First of " : "Second of ") + surface_of(pair).name;
  choice.meaning = "A surface with a law of its own with the other";
  for (const std::string& each : names) choice.words << text_of(each);
  choice.chosen = static_cast<int>(std::find(names.begin(), names.end(), pair.*name) - names.begin());
  choice.edits = [pair, name, names](int index) {
    MaterialPair changed = pair;
    changed.*name = names[static_cast<std::size_t>(index)];
    return NamedEdits{{Replace<MaterialPair>{changed}},
                      surface_of(pair).section + " → " + surface_of(changed).name};
  };
  return {.section = surface_of(pair).section, .label = first ? "Between" : "and", .choice = choice};
}

void add_pair(std::vector<InspectedRow>& shown, const Scene& scene, const MaterialPair& pair) {
  const Surface surface = surface_of(pair);
  shown.push_back(side(scene, pair, &MaterialPair::a));
  shown.push_back(side(scene, pair, &MaterialPair::b));
  add_numbers(shown, surface);
  add_sticks(shown, surface);
  const InspectedAction remove{.text = "Remove",
                               .name = "Remove pair " + surface.name,
                               .meaning = "They combine as all surfaces do",
                               .edits = {{Remove<MaterialPair>{pair.id}}, "Remove pair " + surface.name}};
  shown.push_back({.section = surface.section, .actions = {remove}});
}

// The first two surfaces without a law of their own, two different ones if there are any; it begins as they
// combine now.
std::optional<MaterialPair> free_pair(const Scene& scene) {
  const std::vector<std::string> names = material_names(scene);
  const auto is_listed = [&](const std::string& a, const std::string& b) {
    return std::any_of(scene.pairs.begin(), scene.pairs.end(), [&](const MaterialPair& pair) {
      return (pair.a == a && pair.b == b) || (pair.a == b && pair.b == a);
    });
  };
  for (std::size_t apart = 1; apart <= names.size(); ++apart) {
    for (std::size_t i = 0; i < names.size(); ++i) {
      const std::string& other = names[(i + apart) % names.size()];
      if (!is_listed(names[i], other))
        return MaterialPair{names[i], other, combined_material(scene, names[i], other)};
    }
  }
  return std::nullopt;
}

void add_more(std::vector<InspectedRow>& shown, std::size_t all, const QString& section) {
  if (all <= kMostShown) return;
  shown.push_back(
      {.section = section, .text = QString("and %1 more").arg(static_cast<qulonglong>(all - kMostShown))});
}

// The bodies with a surface of their own: a copy of the one that they have, which meets all others alike.
NamedEdits split(const Scene& scene, const std::vector<Body>& bodies) {
  const std::string old = bodies.front().material;
  Material own = material_named(scene, old);
  own.name = free_surface_name(scene, old);
  own.id = {};
  SceneEdits edits{Add<Material>{own}};
  for (const MaterialPair& pair : scene.pairs) {
    MaterialPair copy = pair;
    copy.id = {};
    if (pair.a == old) copy.a = own.name;
    if (pair.b == old) copy.b = own.name;
    if (pair.a == old || pair.b == old) edits.emplace_back(Add<MaterialPair>{copy});
    if (pair.a == old && pair.b == old) {
      copy.a = old;
      edits.emplace_back(Add<MaterialPair>{copy});
    }
  }
  for (SceneEdit& edit : edits_of(bodies, [&](Body& body) { body.material = own.name; }))
    edits.push_back(std::move(edit));
  return {edits, "Surface of " + subject_of(bodies) + ": " + text_of(own.name)};
}

std::ptrdiff_t users_of(const Scene& scene, const std::string& material) {
  return std::count_if(scene.bodies.begin(), scene.bodies.end(),
                       [&](const Body& body) { return body.material == material; });
}

std::optional<Surface> shared_surface(const Scene& scene, const std::vector<Body>& bodies) {
  const auto same = [&](const Body& body) { return body.material == bodies.front().material; };
  if (!std::all_of(bodies.begin(), bodies.end(), same)) return std::nullopt;
  return surface_of(material_named(scene, bodies.front().material));
}

InspectedRow choice_of_surface(const Scene& scene, const std::vector<Body>& bodies) {
  const std::vector<std::string> names = material_names(scene);
  std::set<std::string> worn;
  for (const Body& body : bodies) worn.insert(body.material);
  InspectedChoice choice;
  choice.name = "Surface";
  choice.meaning = "The material of its surface";
  for (const std::string& name : names) choice.words << text_of(name);
  choice.other = QString("%1 surfaces").arg(static_cast<qulonglong>(worn.size()));
  if (worn.size() == 1) {
    choice.chosen = static_cast<int>(std::find(names.begin(), names.end(), *worn.begin()) - names.begin());
    const std::ptrdiff_t users = users_of(scene, *worn.begin());
    if (users > static_cast<std::ptrdiff_t>(bodies.size())) choice.remark = QString("%1 bodies").arg(users);
  }
  choice.edits = [names, bodies](int index) {
    const std::string& name = names[static_cast<std::size_t>(index)];
    return NamedEdits{edits_of(bodies, [&](Body& body) { body.material = name; }),
                      QString("Surface of %1: %2").arg(subject_of(bodies), text_of(name))};
  };
  return {.label = "Surface", .choice = std::move(choice)};
}

}  // namespace

std::string free_surface_name(const Scene& scene, const std::string& stem) {
  for (int number = 2;; ++number) {
    std::string name = stem + " " + std::to_string(number);
    const auto taken = [&](const Material& material) { return material.name == name; };
    if (std::none_of(scene.materials.begin(), scene.materials.end(), taken)) return name;
  }
}

std::vector<InspectedRow> inspected_surface(const Scene& scene, const std::vector<Body>& bodies) {
  std::vector<InspectedRow> shown{choice_of_surface(scene, bodies)};
  if (const std::optional<Surface> surface = shared_surface(scene, bodies)) {
    add_numbers(shown, *surface);
    shown.resize(kMainLines);
    shown.back().section.clear();
  }
  return shown;
}

std::vector<InspectedRow> more_of_surface(const Scene& scene, const std::vector<Body>& bodies) {
  std::vector<InspectedRow> shown;
  const std::optional<Surface> surface = shared_surface(scene, bodies);
  if (!surface) return shown;
  add_numbers(shown, *surface);
  shown.resize(kMainLines);
  shown.erase(shown.begin());
  const auto users = users_of(scene, surface->law.name);
  if (users <= static_cast<std::ptrdiff_t>(bodies.size())) return shown;
  const QString section = surface->section + QString(" · %1 bodies share it").arg(users);
  for (InspectedRow& row : shown) row.section = section;
  const InspectedAction only_here{
      .text = "Only here",
      .meaning = "Gives " + subject_of(bodies) + " a surface of its own that begins like this one",
      .edits = split(scene, bodies)};
  shown.push_back({.section = section, .actions = {only_here}});
  return shown;
}

Inspected inspected_restitution(const Scene& scene, const Body& body) {
  std::vector<InspectedRow> rows;
  add_numbers(rows, surface_of(material_named(scene, body.material)));
  return rows.front().values.front();
}

std::vector<InspectedRow> inspected_surfaces(const Scene& scene) {
  std::vector<InspectedRow> shown;
  for (std::size_t i = 0; i < std::min(scene.materials.size(), kMostShown); ++i) {
    const Material& material = scene.materials[i];
    const Surface surface = surface_of(material);
    add_name(shown, material);
    add_numbers(shown, surface);
    add_sticks(shown, surface);
    shown.push_back({.section = surface.section, .actions = {removal(scene, material)}});
  }
  InspectedRow more = addition(scene);
  add_more(shown, scene.materials.size(), more.section);
  for (std::size_t i = 0; i < std::min(scene.pairs.size(), kMostShown); ++i)
    add_pair(shown, scene, scene.pairs[i]);
  add_more(shown, scene.pairs.size(), more.section);
  if (const std::optional<MaterialPair> pair = free_pair(scene))
    more.actions.push_back({.text = "Add a pair",
                            .meaning = "A law of their own for two surfaces",
                            .edits = {{Add<MaterialPair>{*pair}}, "Add pair " + surface_of(*pair).name}});
  shown.push_back(std::move(more));
  return shown;
}

}  // namespace carom
