#pragma once

#include <QRectF>
#include <QString>
#include <vector>

#include "widgets/scene/camera.h"

namespace carom {

// The largest of ..., 0.1, 0.2, 0.5, 1, 2, 5, ... not above `value`, and the smallest not below it; value > 0.
[[nodiscard]] double step_not_above(double value);
[[nodiscard]] double step_not_below(double value);

// Lines at round metres over the camera's view: 1-2-5 spacing, every fifth line strong.
struct Grid {
  struct Line {
    bool vertical = false;
    bool strong = false;
    double at = 0.0;  // m, x of a vertical line, y of a horizontal one
  };
  std::vector<Line> lines;  // strong ones last
  double scale_bar = 0.0;   // m, a round length of the scale bar; 0: none
};

// m, between neighbouring lines.
[[nodiscard]] double grid_spacing(const Camera& camera);
// Refills `grid` and keeps its capacity.
void place_grid(const Camera& camera, Grid& grid);

// Position of a line on the screen in logical pixels, aligned to device pixels so that it is sharp.
[[nodiscard]] QRectF line_rect(const Grid::Line& line, const Camera& camera, double width, double pixel_ratio);

// A length with a suitable unit: 2 mm, 50 cm, 1 m, 5 km.
[[nodiscard]] QString length_text(double metres);
// A plain number with a true minus sign.
[[nodiscard]] QString number_text(double value, int digits = 6);

}  // namespace carom
