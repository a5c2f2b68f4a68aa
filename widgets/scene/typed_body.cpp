#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>
#include <utility>
#include <variant>

#include "physics/math/vectors.h"
#include "widgets/edit/derived_fields.h"
#include "widgets/edit/reshaping.h"
#include "widgets/edit/units.h"
#include "widgets/scene/corner_drag.h"
#include "widgets/scene/drag_limits.h"
#include "widgets/scene/edit_names.h"
#include "widgets/scene/typed_value.h"

// Values of bodies that are typed at the mouse.
namespace carom {
namespace {

QString polar_text(const Vec2& velocity) {
  const QString speed = quantity_text(velocity.norm(), "m/s");
  return velocity.isZero(0.0) ? speed : speed + " at " + quantity_text(radians(direction(velocity)), "rad");
}

class TypedBody : public TypedThing {
 public:
  TypedBody(DragStart start, const Body& now, double scale)
      : start_(std::move(start)), now_(now), scale_(scale) {
    start_.press = start_.bodies[0].position;
    for (const Vec2& velocity : {now_.velocity, start_.bodies[0].velocity}) {
      if (velocity.isZero(0.0)) continue;
      direction_ = radians(direction(velocity));
      break;
    }
  }

  [[nodiscard]] QString subject() const override { return QString::fromStdString(now_.name); }

  [[nodiscard]] FormulaNames formula_names() const override { return carom::formula_names(now_); }

  [[nodiscard]] std::vector<TypedValue> values() const override {
    switch (start_.kind) {
      case HandleKind::kBody:
        return {{"x", range_of("position", 0), now_.position.x()},
                {"y", range_of("position", 1), now_.position.y()}};
      case HandleKind::kVelocity:
        return {{"Speed", range_of("speed"), now_.velocity.norm()},
                {"Direction", range_of("direction"), direction_}};
      case HandleKind::kTurn:
        return {{"Angle", range_of("angle"), now_.angle}};
      case HandleKind::kSpin:
        return {{"Spin", range_of("spin"), now_.spin}};
      case HandleKind::kCorner:
        return {{"x", range_of("position", 0), corner_at(now_, start_.corner).x()},
                {"y", range_of("position", 1), corner_at(now_, start_.corner).y()}};
      default:
        return typed_sizes(now_.shape);
    }
  }

  [[nodiscard]] TypedEdit set(std::size_t index, double value, bool yields) override {
    const DragPoint point{
        .at = start_.press, .scale = scale_, .keys = yields ? Qt::ControlModifier : Qt::NoModifier};
    const Dragged kept = within_joints(start_, wanted(index, value), point);
    TypedEdit out;
    if (kept.fault && kept.overlaps.empty()) {
      out.fault = kept.value + ".";
      return out;
    }
    const std::optional<Dragged> left = without_overlaps(start_, kept, point);
    if (!left) {
      out.fault = QStringLiteral("There is no room there.");
      return out;
    }
    now_ = left->bodies[0];
    if (!now_.velocity.isZero(0.0)) direction_ = radians(direction(now_.velocity));
    refits_ |= left->refits;
    return {edits_as_seen(*left, refits_), left->name, left->value, left->detail, {}};
  }
  [[nodiscard]] std::unique_ptr<TypedThing> clone() const override {
    return std::make_unique<TypedBody>(*this);
  }

 private:
  // As the fields of the body state it, or those of one that moves freely: what has a handle has a field.
  [[nodiscard]] Range range_of(const char* key, int part = -1) const {
    Body body = now_;
    body.drive.reset();
    const std::vector<FieldRow> rows = all_rows(body);
    const auto row = std::find_if(rows.begin(), rows.end(), [&](const FieldRow& r) {
      return r.place.key == key && r.place.part == part;
    });
    assert(row != rows.end());
    return row->range;
  }

  // All bodies of the start, with this value of the first one.
  [[nodiscard]] Dragged wanted(std::size_t index, double value) const {
    switch (start_.kind) {
      case HandleKind::kBody:
        return placed(static_cast<Eigen::Index>(index), value);
      case HandleKind::kVelocity:
        return index == 0 ? thrown(value, direction_) : thrown(now_.velocity.norm(), value);
      case HandleKind::kTurn:
        return turned(value);
      case HandleKind::kSpin:
        return spun(value);
      case HandleKind::kCorner: {
        Vec2 corner = corner_at(now_, start_.corner);
        corner[static_cast<Eigen::Index>(index)] = value;
        return with_corner(start_, corner, scale_);
      }
      default:
        return sized(static_cast<Eigen::Index>(index), value);
    }
  }

  [[nodiscard]] Dragged placed(Eigen::Index axis, double value) const {
    Vec2 place = now_.position;
    place[axis] = value;
    Dragged out;
    out.bodies = start_.bodies;
    for (Body& body : out.bodies) body.position += place - start_.bodies[0].position;
    out.bodies[0].position = place;
    out.value = "x " + quantity_text(place.x(), "m") + ", y " + quantity_text(place.y(), "m");
    out.name = "Move " + name_of_bodies(start_.bodies);
    return out;
  }

  [[nodiscard]] Dragged thrown(double speed, double angle) const {
    const Vec2 velocity = speed * unit_vector(angle * 180.0 / std::numbers::pi);
    Dragged out;
    out.bodies = start_.bodies;
    for (Body& body : out.bodies) body.velocity += velocity - start_.bodies[0].velocity;
    out.bodies[0].velocity = velocity;
    out.value = polar_text(velocity);
    out.name = name_of_velocity(start_.bodies, out.bodies);
    return out;
  }

  [[nodiscard]] Dragged turned(double angle) const {
    Dragged out;
    out.bodies = start_.bodies;
    out.bodies[0].angle = angle;
    out.value = quantity_text(angle, "rad");
    out.name = "Turn " + name_of_bodies(start_.bodies);
    return out;
  }

  [[nodiscard]] Dragged spun(double spin) const {
    Dragged out;
    out.bodies = start_.bodies;
    out.bodies[0].spin = spin;
    out.value = quantity_text(spin, "rad/s");
    out.detail = turns_text(spin);
    out.name = name_of_spin(start_.bodies[0], out.bodies[0]);
    return out;
  }

  // The far side of a box stays where a drag of the handle lets it stay.
  [[nodiscard]] Dragged sized(Eigen::Index axis, double value) const {
    Dragged out;
    out.bodies = start_.bodies;
    Body& body = out.bodies[0];
    if (std::holds_alternative<Disc>(now_.shape)) {
      body = resized(body, Disc{value}, start_.keeps);
      out.value = "r " + quantity_text(value, "m");
    } else if (const auto* box = std::get_if<Box>(&now_.shape)) {
      Vec2 size(box->width, box->height);
      const double grown = value - std::exchange(size[axis], value);
      body = resized(body, Box{size.x(), size.y()}, start_.keeps);
      Vec2 side = side_of(start_.kind);
      side[1 - axis] = 0.0;
      body.position = now_.position + turned_by(body.angle, 0.5 * grown * side);
      out.value = quantity_text(size.x(), "m") + " × " + quantity_text(size.y(), "m");
    }
    if (std::holds_alternative<Compound>(now_.shape)) {
      const Vec2 size = 2.0 * half_extent(body.shape, 0.0);
      const double factor = value / size.x();
      body = resized(body, scaled(body.shape, factor), start_.keeps);
      out.value = quantity_text(value, "m") + " × " + quantity_text(factor * size.y(), "m");
    }
    if (const auto* wall = std::get_if<Wall>(&now_.shape)) {
      body = resized(body, Wall{value}, start_.keeps);
      const double grown = value - wall->length.value_or(0.0);
      body.position = now_.position + turned_by(body.angle, 0.5 * grown * side_of(start_.kind));
      out.value = quantity_text(value, "m");
    }
    if (!has_infinite_mass(body)) out.detail = QStringLiteral("m = %1 kg").arg(mass_of(body), 0, 'g', 3);
    out.name = "Resize " + name_of_bodies(start_.bodies);
    return out;
  }

  DragStart start_;
  Body now_;
  double scale_;
  double direction_ = 0.0;  // rad, of the velocity, which a body at rest has too
  bool refits_ = false;
};

}  // namespace

std::unique_ptr<TypedThing> typed_body(DragStart start, const Body& now, double scale) {
  return std::make_unique<TypedBody>(std::move(start), now, scale);
}

}  // namespace carom
