#pragma once

#include "widgets/scene/drawing.h"

class QPainter;

namespace carom {

// The picked impact: its line dashed, arrows hollow before and solid after, and the texts, kept within the
// view.
void paint_jump(QPainter& painter, const Drawing& drawing, const Camera& camera, const Theme& theme);

}  // namespace carom
