#pragma once

#include <QString>
#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "physics/scene/edit.h"
#include "physics/scene/limits.h"
#include "physics/scene/part_id.h"
#include "widgets/edit/quantity.h"
#include "widgets/scene/drag.h"
#include "widgets/scene/part_ends.h"

namespace carom {

// A value that a drag changes, and that can be typed instead.
struct TypedValue {
  QString name;  // as in sentences: "Speed"
  Range range;
  double value = 0.0;  // SI
};

// The numbers of a disc, a box or a thin wall, in the order of its fields; none of other shapes.
[[nodiscard]] std::vector<TypedValue> typed_sizes(const Shape& shape);

// What a typed value makes of the scene, or one sentence on why it can't be.
struct TypedEdit {
  SceneEdits edits;
  QString name;    // of the edit
  QString value;   // with its unit, for the bubble
  QString detail;  // may be empty
  QString fault;
};

// The values of one thing that can be dragged. They come from where the drag began, or from what was typed
// last, however the scene changes meanwhile.
class TypedThing {
 public:
  virtual ~TypedThing() = default;
  [[nodiscard]] virtual QString subject() const = 0;  // whose values they are: "light"
  [[nodiscard]] virtual std::vector<TypedValue> values() const = 0;
  // That formulas know, beside g, pi and e.
  [[nodiscard]] virtual FormulaNames formula_names() const { return {}; }
  // Sets one of them. `yields`: joints take the lengths that it needs, and overlaps stay.
  [[nodiscard]] virtual TypedEdit set(std::size_t index, double value, bool yields) = 0;
  // To try a value that is not taken yet.
  [[nodiscard]] virtual std::unique_ptr<TypedThing> clone() const = 0;
};

// A body or its handle: `now` is the first body of the start as the drag has left it, `scale` in px/m. What
// joints and other bodies leave of a typed value is as for a drag.
[[nodiscard]] std::unique_ptr<TypedThing> typed_body(DragStart start, const Body& now, double scale);

// The length of a joint or of a spring at rest; size and direction of a force.
[[nodiscard]] std::unique_ptr<TypedThing> typed_part(const Scene& scene, const PartId& part);
// The same of one whose end is being dragged: its length is that to the mouse, which tells the direction;
// nothing if that can't be.
[[nodiscard]] std::unique_ptr<TypedThing> typed_end(const std::shared_ptr<EndDrag>& drag,
                                                    const DragPoint& mouse);

}  // namespace carom
