#pragma once

#include <QString>

#include "widgets/scene/shape_tools.h"
#include "widgets/scene/typed_value.h"

namespace carom {

// The sizes of a body that is being drawn: a disc's radius, a box's width and height, a thin wall's length. It
// makes no edits: the body is added when typing ends.
class TypedDrawing : public TypedThing {
 public:
  // Drawn from a press at `from`, m, which stays where it is: the centre of a disc, else a corner or an end.
  TypedDrawing(QString noun, Drawn drawn, const Vec2& from);

  [[nodiscard]] QString subject() const override { return noun_; }
  [[nodiscard]] std::vector<TypedValue> values() const override;
  [[nodiscard]] TypedEdit set(std::size_t index, double value, bool yields) override;
  [[nodiscard]] std::unique_ptr<TypedThing> clone() const override;
  [[nodiscard]] const Drawn& drawn() const { return drawn_; }

 private:
  QString noun_;
  Drawn drawn_;
  Vec2 from_;  // m
  Vec2 side_;  // of a box, on which it lies of that place: ±1, ±1
};

}  // namespace carom
