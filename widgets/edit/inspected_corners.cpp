#include "widgets/edit/inspected_corners.h"

#include <algorithm>
#include <memory>
#include <utility>
#include <variant>

#include "physics/math/vectors.h"
#include "physics/scene/polygon.h"
#include "widgets/edit/reshaping.h"

namespace carom {
namespace {

using Corners = std::vector<Vec2>;

constexpr std::size_t kMostOpen = 8;  // corners of a list that is not folded at first
constexpr std::size_t kFewest = 3;    // without a rounding
constexpr std::size_t kFewestRounded = 2;

// Where the polygon is.
struct Origin {
  Attached attached;
  Body body;
  std::optional<std::size_t> shape;  // of a compound
  Keeps keeps = Keeps::kDensity;

  [[nodiscard]] const Polygon* polygon() const {
    if (!shape) return std::get_if<Polygon>(&body.shape);
    return std::get_if<Polygon>(&std::get<Compound>(body.shape).shapes[*shape].shape);
  }
  // As the inspector calls its list.
  [[nodiscard]] QString list() const { return shape ? QStringLiteral("shape %1").arg(*shape + 1) : QString(); }
  // "block", "shape 2 of hammer".
  [[nodiscard]] QString whose() const {
    const QString name = QString::fromStdString(body.name);
    return shape ? list() + " of " + name : name;
  }
  [[nodiscard]] std::string key(std::size_t corner) const {
    const std::string before = shape ? "shapes/" + std::to_string(*shape) + "/" : "";
    return before + "shape/vertices/" + std::to_string(corner);
  }
};
using OriginPtr = std::shared_ptr<const Origin>;

QString corner_text(std::size_t corner) { return QStringLiteral("Corner %1").arg(corner + 1); }

// "edges that cross are not allowed"; empty: they are a polygon.
QString fault_at(const Origin& origin, const Corners& corners) {
  const auto fault = fault_of(corners, origin.polygon()->rounding);
  return fault ? QString::fromStdString(*fault).section(';', 0, 0) : QString();
}

SceneEdits with_corners(const Origin& origin, const Corners& corners) {
  Polygon polygon = *origin.polygon();
  polygon.vertices = corners;
  const bool valid = fault_at(origin, corners).isEmpty();
  // Whoever makes the edit says what is wrong.
  const auto reshaped = [&](const Shape& shape) {
    if (valid) return reshaping(origin.attached, origin.body, resized(origin.body, shape, origin.keeps));
    Body changed = origin.body;
    changed.shape = shape;
    return SceneEdits{Replace<Body>{changed}};
  };
  if (!origin.shape) return reshaped(polygon);
  Compound compound = std::get<Compound>(origin.body.shape);
  PlacedShape& placed = compound.shapes[*origin.shape];
  placed.position += turned_by(placed.angle, centre_of(polygon) - centre_of(*origin.polygon()));
  placed.shape = std::move(polygon);
  return reshaped(compound);
}

Corners moved(const Origin& origin, std::size_t corner, int component, double value) {
  Corners corners = origin.polygon()->vertices;
  corners[corner][component] = value;
  return corners;
}

Inspected coordinate(const OriginPtr& origin, std::size_t corner, const FieldRow& row) {
  const int component = row.place.part;
  Inspected value;
  value.label = component == 0 ? "x" : "y";
  value.name = corner_text(corner) + ' ' + value.label;
  value.subject = origin->list();
  value.meaning = "in the frame of its shape; the other corners stay where they are";
  value.range = row.range;
  value.values = {std::get<double>(row.value)};
  value.edits = [=](const std::vector<double>& values) {
    return with_corners(*origin, moved(*origin, corner, component, values[0]));
  };
  value.undo_name = [=](const std::vector<double>&, const std::vector<double>&) {
    return corner_text(corner) + " of " + origin->whose();
  };
  value.fault = [=](const std::vector<double>& values) {
    const QString fault = fault_at(*origin, moved(*origin, corner, component, values[0]));
    return fault.isEmpty() ? fault : corner_text(corner) + " can't be there: " + fault + '.';
  };
  return value;
}

// A new corner in the middle of the edge behind this one.
InspectedAction adding(const Origin& origin, std::size_t corner) {
  Corners corners = origin.polygon()->vertices;
  InspectedAction action{.text = "+", .name = "Add a corner after corner " + QString::number(corner + 1)};
  if (!origin.list().isEmpty()) action.name += " of " + origin.list();
  action.meaning = action.name + ": in the middle of its edge";
  if (corners.size() >= kMostPolygonPoints) {
    action.refusal = QStringLiteral("A polygon has at most %1 corners.").arg(kMostPolygonPoints);
    return action;
  }
  const Vec2 middle = 0.5 * (corners[corner] + corners[(corner + 1) % corners.size()]);
  corners.insert(corners.begin() + static_cast<std::ptrdiff_t>(corner) + 1, middle);
  action.edits = {with_corners(origin, corners), "Add a corner to " + origin.whose()};
  return action;
}

InspectedAction removal(const Origin& origin, std::size_t corner) {
  const Polygon& polygon = *origin.polygon();
  Corners corners = polygon.vertices;
  InspectedAction action{.text = QChar(0x2212), .name = "Remove corner " + QString::number(corner + 1)};
  if (!origin.list().isEmpty()) action.name += " of " + origin.list();
  action.meaning = action.name;
  const bool rounded = polygon.rounding > 0.0;
  const std::size_t fewest = rounded ? kFewestRounded : kFewest;
  if (corners.size() <= fewest) {
    action.refusal = QStringLiteral("A %1 has at least %2 corners.")
                         .arg(rounded ? "rounded polygon" : "polygon without a rounding")
                         .arg(fewest);
    return action;
  }
  corners.erase(corners.begin() + static_cast<std::ptrdiff_t>(corner));
  if (const QString fault = fault_at(origin, corners); !fault.isEmpty()) {
    action.refusal = corner_text(corner) + " can't go: " + fault + '.';
    return action;
  }
  action.edits = {with_corners(origin, corners),
                  action.name + " of " + QString::fromStdString(origin.body.name)};
  return action;
}

}  // namespace

std::vector<InspectedRow> inspected_corners(const Scene& scene, const Body& body,
                                            std::optional<std::size_t> shape, const std::set<QString>& unfolded,
                                            Keeps keeps) {
  const auto origin = std::make_shared<const Origin>(Origin{attached_in(scene), body, shape, keeps});
  if (origin->polygon() == nullptr) return {};
  const std::size_t count = origin->polygon()->vertices.size();
  std::vector<InspectedRow> shown;
  const QString section = shape ? QStringLiteral("Shape %1 · polygon").arg(*shape + 1) : "Corners";
  const bool folded = count > kMostOpen && !unfolded.contains(origin->list());
  if (count > kMostOpen) {
    InspectedAction action{.text = QString(folded ? "Show %1 corners" : "Fold %1 corners").arg(count)};
    if (shape) action.name = action.text + " of " + origin->list();
    action.meaning = "The places of its corners";
    action.folds = origin->list();
    shown.push_back({.section = section, .actions = {action}});
  }
  if (folded) return shown;
  const std::vector<FieldRow> rows = field_rows(body);
  for (std::size_t corner = 0; corner < count; ++corner) {
    InspectedRow out{.section = section, .label = corner_text(corner)};
    for (const FieldRow& row : rows) {
      if (row.place.key == origin->key(corner)) out.values.push_back(coordinate(origin, corner, row));
    }
    out.actions = {adding(*origin, corner), removal(*origin, corner)};
    shown.push_back(std::move(out));
  }
  return shown;
}

}  // namespace carom
