#include <algorithm>
#include <array>

#include "widgets/edit/field_rows.h"
#include "widgets/edit/inspected.h"
#include "widgets/edit/units.h"

namespace carom {
namespace {

SetForces forces_of(const Scene& scene) {
  return {scene.forces.gravity, scene.forces.linear_drag, scene.forces.quadratic_drag, scene.forces.attraction};
}

// A number that the scene has once. `member` finds it in its forces.
InspectedRow force_row(const SetForces& forces, const QString& label, const QString& meaning,
                       const Range& range, double& (*member)(SetForces&)) {
  SetForces now = forces;
  Inspected value;
  value.name = label;
  value.meaning = meaning;
  value.range = range;
  value.values = {member(now)};
  value.edits = [forces, member](const std::vector<double>& values) {
    SetForces changed = forces;
    member(changed) = values[0];
    return SceneEdits{changed};
  };
  value.undo_name = [label, range](const std::vector<double>& from, const std::vector<double>& to) {
    return label + " " + change_text(from[0], to[0], range.unit);
  };
  return {"Forces", label, {std::move(value)}};
}

struct SurfaceLine {
  const char* key;   // as in fields.h
  const char* name;  // in sentences and undo names; UTF-8
};
constexpr auto kSurfaceLines = std::to_array<SurfaceLine>({
    {"restitution", "e"},
    {"kinetic_friction", "µ"},
    {"static_friction", "µs"},
    {"rolling_resistance", "Rolling resistance"},
});

// Static friction is never less than kinetic friction: the one that was not typed follows.
Material with_number(Material material, const FieldPlace& place, double value) {
  material = with_field(std::move(material), place, value);
  if (place.key == "kinetic_friction") material.static_friction = std::max(material.static_friction, value);
  if (place.key == "static_friction") material.kinetic_friction = std::min(material.kinetic_friction, value);
  return material;
}

// An edit of a surface; "default", if the scene doesn't list it, is added.
SceneEdit edit_of(const Material& material) {
  if (material.id.number == 0) return Add<Material>{material, Add<Material>::kAtEnd};
  return Replace<Material>{material};
}

Inspected surface_value(const Material& material, const FieldRow& row, const char* name) {
  Inspected value;
  value.name = QString::fromUtf8(name);
  value.subject = QString::fromStdString(material.name);
  value.meaning = row.meaning;
  value.range = row.range;
  value.values = {std::get<double>(row.value)};
  value.edits = [material, place = row.place](const std::vector<double>& values) {
    return SceneEdits{edit_of(with_number(material, place, values[0]))};
  };
  value.undo_name = [text = value.name + " of " + value.subject + " ", unit = row.range.unit](
                        const std::vector<double>& from, const std::vector<double>& to) {
    return text + change_text(from[0], to[0], unit);
  };
  return value;
}

void add_surface(std::vector<InspectedRow>& shown, const Material& material) {
  const std::vector<FieldRow> rows = field_rows(material);
  for (const SurfaceLine& line : kSurfaceLines) {
    for (const FieldRow& row : rows) {
      if (row.place.key != line.key) continue;
      const QString section = "Surface " + QString::fromStdString(material.name);
      shown.push_back({section, row.label, {surface_value(material, row, line.name)}});
    }
  }
}

}  // namespace

std::vector<InspectedRow> inspected_surface(const Scene& scene, const std::vector<Body>& bodies) {
  std::vector<InspectedRow> shown;
  const auto other = [&](const Body& body) { return body.material != bodies.front().material; };
  if (bodies.empty() || std::any_of(bodies.begin(), bodies.end(), other)) return shown;
  add_surface(shown, material_named(scene, bodies.front().material));
  // What most lessons are about, under the names that leave room for the other fields.
  shown.resize(2);
  const auto same = [&](const Body& body) { return body.material == bodies.front().material; };
  const auto users = std::count_if(scene.bodies.begin(), scene.bodies.end(), same);
  for (InspectedRow& row : shown) {
    row.label = row.values.front().name;
    if (users > 1) row.section += QString(" · %1 bodies").arg(users);
  }
  return shown;
}

std::vector<InspectedRow> inspected_scene(const Scene& scene) {
  const SetForces forces = forces_of(scene);
  std::vector<InspectedRow> shown;
  shown.push_back(force_row(forces, "Gravity x", "acceleration of every moving body to the right", kGravity,
                            [](SetForces& f) -> double& { return f.gravity.x(); }));
  shown.push_back(force_row(forces, "Gravity y", "acceleration of every moving body upwards", kGravity,
                            [](SetForces& f) -> double& { return f.gravity.y(); }));
  shown.push_back(force_row(forces, "Linear drag", "force against the motion, over speed", kLinearDrag,
                            [](SetForces& f) -> double& { return f.linear_drag; }));
  shown.push_back(force_row(forces, "Quadratic drag", "force against the motion, over speed squared",
                            kQuadraticDrag, [](SetForces& f) -> double& { return f.quadratic_drag; }));
  for (const Material& material : scene.materials) add_surface(shown, material);
  return shown;
}

}  // namespace carom
