#include <algorithm>
#include <utility>

#include "widgets/edit/inspected.h"
#include "widgets/edit/inspected_corners.h"
#include "widgets/edit/reshaping.h"
#include "widgets/edit/units.h"

namespace carom {
namespace {

constexpr std::size_t kMostShown = 12;

// The lines of a shape, in order.
struct ShapeLine {
  const char* label;
  const char* key;            // as its fields have it
  bool vector = false;        // two components in one line
  const char* act = nullptr;  // the verb of an undo name without values, "Move shape 1 of C"
};
constexpr auto kShapeLines = std::to_array<ShapeLine>({
    {"Radius", "shape/radius"},
    {"Width", "shape/width"},
    {"Height", "shape/height"},
    {"Length", "shape/length"},
    {"Rounding", "shape/rounding"},
    {"Position", "position", true, "Move"},
    {"Angle", "angle", false, "Turn"},
});

const std::vector<PlacedShape>& shapes_of(const Body& body) { return std::get<Compound>(body.shape).shapes; }

std::string place_of(std::size_t shape) { return "shapes/" + std::to_string(shape) + "/"; }
QString subject_of(std::size_t shape) { return QStringLiteral("shape %1").arg(shape + 1); }

QString section_of(const Body& body, std::size_t shape) {
  return QStringLiteral("Shape %1 · %2").arg(shape + 1).arg(kShapeWords[shapes_of(body)[shape].shape.index()]);
}

Inspected inspected_number(const Scene& scene, const Body& body, std::size_t shape, const ShapeLine& line,
                           const FieldRow& row, Keeps keeps) {
  const QString component = row.place.part < 0 ? "" : row.place.part == 0 ? "x" : "y";
  Inspected value;
  value.label = component;
  value.name = QString::fromUtf8(line.label) + (component.isEmpty() ? "" : " ") + component;
  value.subject = subject_of(shape);
  value.meaning = row.meaning;
  value.range = row.range;
  value.values = {std::get<double>(row.value)};
  value.edits = [attached = attached_in(scene), body, place = row.place,
                 keeps](const std::vector<double>& values) {
    return reshaping(attached, body, resized(body, with_field(body, place, values[0]).shape, keeps));
  };
  const QString whose = value.subject + " of " + QString::fromStdString(body.name);
  value.undo_name = [line, whose, name = value.name, unit = row.range.unit](const std::vector<double>& before,
                                                                            const std::vector<double>& after) {
    if (line.act != nullptr) return QString::fromUtf8(line.act) + " " + whose;
    return name + " of " + whose + " " + change_text(before[0], after[0], unit);
  };
  return value;
}

InspectedRow surface_row(const Scene& scene, const Body& body, std::size_t shape) {
  QStringList names;
  for (const Material& material : scene.materials) names << QString::fromStdString(material.name);
  const QString usual = QString::fromStdString(Material{}.name);
  if (!names.contains(usual)) names << usual;
  const QString now = QString::fromStdString(shapes_of(body)[shape].material);
  InspectedChoice choice;
  choice.name = "Surface of " + subject_of(shape);
  choice.meaning = "The material of its surface";
  choice.words = QStringList{"as the body"} + names;
  choice.chosen = now.isEmpty() ? 0 : static_cast<int>(names.indexOf(now)) + 1;
  choice.edits = [body, shape, words = choice.words](int index) {
    Body changed = body;
    std::get<Compound>(changed.shape).shapes[shape].material =
        index == 0 ? std::string() : words[index].toStdString();
    return NamedEdits{
        {Replace<Body>{changed}},
        "Surface of " + subject_of(shape) + " of " + QString::fromStdString(body.name) + ": " + words[index]};
  };
  return {.section = section_of(body, shape), .label = "Surface", .choice = choice};
}

}  // namespace

std::vector<InspectedRow> inspected_shapes(const Scene& scene, const Body& body,
                                           const std::set<QString>& unfolded, Keeps keeps) {
  std::vector<InspectedRow> shown;
  if (!std::holds_alternative<Compound>(body.shape)) return shown;
  const std::vector<FieldRow> rows = field_rows(body);
  const std::size_t count = shapes_of(body).size();
  for (std::size_t shape = 0; shape < std::min(count, kMostShown); ++shape) {
    for (const ShapeLine& line : kShapeLines) {
      InspectedRow out{.section = section_of(body, shape), .label = QString::fromUtf8(line.label)};
      for (const FieldRow& row : rows) {
        const bool same = row.place.key == place_of(shape) + line.key && (row.place.part >= 0) == line.vector;
        if (same && std::holds_alternative<double>(row.value))
          out.values.push_back(inspected_number(scene, body, shape, line, row, keeps));
      }
      if (!out.values.empty()) shown.push_back(std::move(out));
    }
    std::vector<InspectedRow> corners = inspected_corners(scene, body, shape, unfolded, keeps);
    std::move(corners.begin(), corners.end(), std::back_inserter(shown));
    shown.push_back(surface_row(scene, body, shape));
  }
  if (count > kMostShown)
    shown.push_back({.section = "Shapes", .text = QStringLiteral("and %1 more").arg(count - kMostShown)});
  return shown;
}

}  // namespace carom
