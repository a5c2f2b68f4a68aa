#include "widgets/scene/grid.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace carom {
namespace {

constexpr double kLeastSpacing = 18.0;      // px between neighbouring lines
constexpr double kLongestScaleBar = 150.0;  // px
constexpr double kRounding = 1.0 + 1e-9;    // tolerance for a step that misses by rounding only
constexpr std::int64_t kLinesPerStrong = 5;

}  // namespace

double step_not_above(double value) {
  const double decade = std::pow(10.0, std::floor(std::log10(value * kRounding)));
  for (const double step : {5.0, 2.0}) {
    if (step * decade <= value * kRounding) return step * decade;
  }
  return decade;
}

double step_not_below(double value) {
  const double below = step_not_above(value);
  return below * kRounding >= value ? below : step_not_above(2.5 * below);
}

double grid_spacing(const Camera& camera) { return step_not_below(kLeastSpacing / camera.scale); }

void place_grid(const Camera& camera, Grid& grid) {
  grid.lines.clear();
  const double spacing = grid_spacing(camera);
  grid.scale_bar = step_not_above(kLongestScaleBar / camera.scale);
  const WorldRect seen = camera.visible();
  for (const bool strong : {false, true}) {
    for (const bool vertical : {true, false}) {
      const int axis = vertical ? 0 : 1;
      const auto first = static_cast<std::int64_t>(std::ceil(seen.lower[axis] / spacing));
      const auto last = static_cast<std::int64_t>(std::floor(seen.upper[axis] / spacing));
      for (std::int64_t k = first; k <= last; ++k) {
        if ((k % kLinesPerStrong == 0) != strong) continue;
        grid.lines.push_back({vertical, strong, static_cast<double>(k) * spacing});
      }
    }
  }
}

QRectF line_rect(const Grid::Line& line, const Camera& camera, double width, double pixel_ratio) {
  const double thick = std::max(1.0, std::round(width * pixel_ratio)) / pixel_ratio;
  const QPointF at = camera.to_screen(Vec2::Constant(line.at));
  const double low = (line.vertical ? at.x() : at.y()) - thick / 2;
  const double snapped = std::round(low * pixel_ratio) / pixel_ratio;
  if (line.vertical) return {snapped, 0.0, thick, camera.viewport.height()};
  return {0.0, snapped, camera.viewport.width(), thick};
}

QString length_text(double metres) {
  if (metres >= 1000.0) return number_text(metres / 1000.0) + " km";
  if (metres >= 1.0) return number_text(metres) + " m";
  if (metres >= 0.01) return number_text(metres * 100.0) + " cm";
  if (metres >= 1e-4) return number_text(metres * 1000.0) + " mm";
  return number_text(metres) + " m";
}

QString number_text(double value, int digits) {
  return QString::number(value, 'g', digits).replace('-', QChar(0x2212));
}

}  // namespace carom
