#pragma once

#include "widgets/scene/drawing.h"
#include "widgets/scene/obstacles.h"

class QPainter;

namespace carom {

// The picked impact: its lines dashed, arrows hollow before and solid after, and the texts, clear of the
// obstacles too.
void paint_jump(QPainter& painter, const Drawing& drawing, const Camera& camera, const Theme& theme,
                const Obstacles& obstacles);

}  // namespace carom
