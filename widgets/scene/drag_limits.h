#pragma once

#include <optional>

#include "physics/scene/edit.h"
#include "widgets/scene/drag.h"

namespace carom {

// What joints and other bodies leave of an edit. With Ctrl joints take the lengths that it needs, and overlaps
// stay.

// Sets what is beside the bodies that change: those that joints make one with them follow, if they may.
void set_beside(DragStart& start, Surroundings beside, bool may_follow = true);

// While the mouse is down: followers come along, joints hold, and overlaps are said.
[[nodiscard]] Dragged within_joints(const DragStart& start, Dragged wanted, const DragPoint& point);

// When it is let go: overlaps are solved by the least change. Nothing if there is no room near by.
[[nodiscard]] std::optional<Dragged> without_overlaps(const DragStart& start, const Dragged& dragged,
                                                      const DragPoint& point);

// The edits that it is; those of its `joints` too if any of them is another one.
[[nodiscard]] SceneEdits edits_of(const Dragged& change, bool joints);
// Of bodies as they are seen: the velocity of one that is driven straight on is that of its drive.
[[nodiscard]] SceneEdits edits_as_seen(Dragged change, bool joints);

// "light and heavy overlap by 3.2 cm"
[[nodiscard]] QString overlap_text(const Overlap& overlap, const DragPoint& point);

}  // namespace carom
