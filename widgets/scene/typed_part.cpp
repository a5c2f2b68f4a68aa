#include <algorithm>
#include <numbers>
#include <utility>
#include <variant>

#include "physics/scene/edit_rules.h"
#include "widgets/edit/derived_fields.h"
#include "widgets/edit/inspected_parts.h"
#include "widgets/edit/units.h"
#include "widgets/scene/edit_names.h"
#include "widgets/scene/part_ends.h"
#include "widgets/scene/typed_value.h"

// Values of joints, springs and forces that are typed at the mouse.
namespace carom {
namespace {

QString title_of(const Scene& scene, const PartId& part) {
  const auto shown = inspected_part(scene, part);
  return shown ? shown->title : QString();
}

// That of a rod, also for the ends of a spring.
Range range_of_length() {
  Joint rod;
  rod.kind = JointKind::kRod;
  const std::vector<FieldRow> rows = field_rows(rod);
  return std::find_if(rows.begin(), rows.end(), [](const FieldRow& row) { return row.place.key == "length"; })
      ->range;
}

// The length that the inspector shows.
class TypedLength : public TypedThing {
 public:
  TypedLength(QString title, Inspected shown) : title_(std::move(title)), shown_(std::move(shown)) {}

  [[nodiscard]] QString subject() const override { return title_; }
  [[nodiscard]] std::vector<TypedValue> values() const override {
    return {{shown_.name, shown_.range, shown_.values[0]}};
  }
  [[nodiscard]] TypedEdit set(std::size_t /*index*/, double value, bool /*yields*/) override {
    const std::vector<double> before = std::exchange(shown_.values, {value});
    return {shown_.edits(shown_.values),
            shown_.undo_name(before, shown_.values),
            quantity_text(value, shown_.range.unit),
            {},
            {}};
  }
  [[nodiscard]] std::unique_ptr<TypedThing> clone() const override {
    return std::make_unique<TypedLength>(*this);
  }

 private:
  QString title_;
  Inspected shown_;
};

// The end that the mouse drags, at a typed distance from the other one.
class TypedEnd : public TypedThing {
 public:
  TypedEnd(std::shared_ptr<EndDrag> drag, const DragPoint& mouse, const Vec2& other)
      : drag_(std::move(drag)), mouse_(mouse), other_(other), along_((mouse.at - other).normalized()) {
    mouse_.snapping = false;
  }

  [[nodiscard]] QString subject() const override {
    return title_of(*drag_->began().frame->scene, drag_->part());
  }
  [[nodiscard]] std::vector<TypedValue> values() const override {
    return {{"Length", range_of_length(), (mouse_.at - other_).norm()}};
  }
  [[nodiscard]] TypedEdit set(std::size_t /*index*/, double value, bool /*yields*/) override {
    DragPoint typed = mouse_;
    typed.at = other_ + value * along_;
    const Joined moved = drag_->to(typed);
    if (moved.fault.isEmpty()) mouse_ = typed;
    return {moved.edits, moved.name, quantity_text(value, "m"), moved.detail, moved.fault};
  }
  [[nodiscard]] std::unique_ptr<TypedThing> clone() const override { return std::make_unique<TypedEnd>(*this); }

 private:
  std::shared_ptr<EndDrag> drag_;  // one drag, also of what is only tried
  DragPoint mouse_;
  Vec2 other_;  // m
  Vec2 along_;
};

class TypedForce : public TypedThing {
 public:
  TypedForce(QString title, AppliedForce before, const AppliedForce& now)
      : title_(std::move(title)), before_(std::move(before)), now_(now) {}

  [[nodiscard]] QString subject() const override { return title_; }
  [[nodiscard]] std::vector<TypedValue> values() const override {
    std::vector<TypedValue> values;
    for (const FieldRow& row : derived_rows(now_))
      values.push_back({row.label, row.range, std::get<double>(row.value)});
    return values;
  }
  [[nodiscard]] TypedEdit set(std::size_t index, double value, bool /*yields*/) override {
    const double size = index == 0 ? value : now_.force.norm();
    const double degrees = index == 0 ? direction(now_.force) : value / kDegree;
    now_.force = size * unit_vector(degrees);
    return {{Replace<AppliedForce>{now_}},
            name_of_force(before_, now_),
            quantity_text(size, "N") + " at " + quantity_text(degrees * kDegree, "rad"),
            {},
            {}};
  }
  [[nodiscard]] std::unique_ptr<TypedThing> clone() const override {
    return std::make_unique<TypedForce>(*this);
  }

 private:
  static constexpr double kDegree = std::numbers::pi / 180.0;  // rad
  QString title_;
  AppliedForce before_;
  AppliedForce now_;
};

// Where a force acts, along the axes of its body.
class TypedFoot : public TypedThing {
 public:
  TypedFoot(QString title, const SceneEdits& edits, QString name)
      : title_(std::move(title)),
        now_(std::get<Replace<AppliedForce>>(edits[0]).part),
        name_(std::move(name)) {}

  [[nodiscard]] QString subject() const override { return title_; }
  [[nodiscard]] std::vector<TypedValue> values() const override {
    return {{"x", any_number("m"), now_.point.x()}, {"y", any_number("m"), now_.point.y()}};
  }
  [[nodiscard]] TypedEdit set(std::size_t index, double value, bool /*yields*/) override {
    now_.point[static_cast<Eigen::Index>(index)] = value;
    return {{Replace<AppliedForce>{now_}},
            name_,
            "at (" + quantity_text(now_.point.x(), "m") + ", " + quantity_text(now_.point.y(), "m") + ")",
            {},
            {}};
  }
  [[nodiscard]] std::unique_ptr<TypedThing> clone() const override {
    return std::make_unique<TypedFoot>(*this);
  }

 private:
  QString title_;
  AppliedForce now_;
  QString name_;
};

std::unique_ptr<TypedThing> typed_length(const Scene& scene, const PartId& part) {
  const auto shown = inspected_part(scene, part);
  if (!shown) return nullptr;
  for (const InspectedRow& row : shown->rows) {
    if (row.values.size() != 1) continue;
    const Inspected& value = row.values[0];
    const bool length = value.name == "Length" || value.name == "Rest length";
    if (length && value.refusal.isEmpty()) return std::make_unique<TypedLength>(shown->title, value);
  }
  return nullptr;
}

// As `edits` have it, if they do.
std::unique_ptr<TypedThing> typed_force(const Scene& scene, Id<AppliedForce> id, const SceneEdits& edits) {
  const AppliedForce* force = part_of(scene.forces.applied, id);
  if (force == nullptr || force->force.isZero(0.0)) return nullptr;
  const AppliedForce now = edits.empty() ? *force : std::get<Replace<AppliedForce>>(edits[0]).part;
  return std::make_unique<TypedForce>(title_of(scene, id), *force, now);
}

}  // namespace

std::unique_ptr<TypedThing> typed_part(const Scene& scene, const PartId& part) {
  const auto* force = std::get_if<Id<AppliedForce>>(&part);
  return force != nullptr ? typed_force(scene, *force, {}) : typed_length(scene, part);
}

std::unique_ptr<TypedThing> typed_end(const std::shared_ptr<EndDrag>& drag, const DragPoint& mouse) {
  const Scene& scene = *drag->began().frame->scene;
  if (const auto* id = std::get_if<Id<AppliedForce>>(&drag->part())) {
    const Joined moved = drag->to(mouse);
    if (drag->end() == kFoot)
      return std::make_unique<TypedFoot>(title_of(scene, drag->part()), moved.edits, moved.name);
    return typed_force(scene, *id, moved.edits);
  }
  const Vec2 other = drag->end() == 0 ? drag->line().from : drag->line().to;
  if (mouse.at == other) return nullptr;
  return std::make_unique<TypedEnd>(drag, mouse, other);
}

}  // namespace carom
