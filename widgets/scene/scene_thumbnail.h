#pragma once

#include <QPixmap>
#include <QSize>

#include "widgets/scene/drawing.h"

namespace carom {

// All bodies of a frame, small, with thin lines: for lists. `size` in logical pixels.
[[nodiscard]] QPixmap scene_thumbnail(const Frame& frame, const Theme& theme, QSize size, double pixel_ratio);

}  // namespace carom
