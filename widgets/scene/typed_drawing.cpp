#include "widgets/scene/typed_drawing.h"

#include <cmath>
#include <utility>
#include <variant>

#include "physics/math/vectors.h"
#include "widgets/edit/units.h"

namespace carom {

TypedDrawing::TypedDrawing(QString noun, Drawn drawn, const Vec2& from)
    : noun_(std::move(noun)), drawn_(std::move(drawn)), from_(from) {
  const Vec2 across = drawn_.position - from;
  side_ = Vec2(std::copysign(1.0, across.x()), std::copysign(1.0, across.y()));
  if (const auto* box = std::get_if<Box>(&drawn_.shape)) {
    from_ = drawn_.position - 0.5 * Vec2(side_.x() * box->width, side_.y() * box->height);
  }
}

std::vector<TypedValue> TypedDrawing::values() const { return typed_sizes(drawn_.shape); }

TypedEdit TypedDrawing::set(std::size_t index, double value, bool /*yields*/) {
  if (auto* disc = std::get_if<Disc>(&drawn_.shape)) {
    disc->radius = value;
    drawn_.value = "r " + quantity_text(value, "m");
  } else if (auto* box = std::get_if<Box>(&drawn_.shape)) {
    (index == 0 ? box->width : box->height) = value;
    drawn_.position = from_ + 0.5 * Vec2(side_.x() * box->width, side_.y() * box->height);
    drawn_.value = quantity_text(box->width, "m") + " × " + quantity_text(box->height, "m");
  } else if (auto* wall = std::get_if<Wall>(&drawn_.shape)) {
    const double grown = value - wall->length.value_or(0.0);
    drawn_.position += turned_by(drawn_.angle, Vec2(0.5 * grown, 0.0));
    wall->length = value;
    drawn_.value = quantity_text(value, "m");
  }
  return {{}, {}, drawn_.value, {}, {}};
}

std::unique_ptr<TypedThing> TypedDrawing::clone() const { return std::make_unique<TypedDrawing>(*this); }

}  // namespace carom
