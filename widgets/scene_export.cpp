#include "widgets/scene_export.h"

#include <QPainter>
#include <algorithm>

#include "widgets/paint_drawing.h"
#include "widgets/picture_file.h"

namespace carom {
namespace {

constexpr int kMargin = 40;  // px about a fitted scene

}  // namespace

bool save_scene_picture(const Frame& frame, const std::optional<View>& view, const DrawingOptions& options,
                        const Theme& theme, QSize pixels, const QString& path, QString* error) {
  if (pixels.isEmpty()) return save_picture(path, pixels, {}, error);  // which says what is wrong

  Camera camera;
  camera.viewport = pixels;
  if (view) {
    camera.show(*view);
  } else {
    camera.fit(bounds(frame), QMarginsF(kMargin, kMargin, kMargin, kMargin));
  }
  Peaks peaks;
  peaks.observe(frame);
  const double side = std::min(pixels.width(), pixels.height()) / camera.scale;
  const Drawing drawing =
      make_drawing({frame, frame.impacts, camera, options, theme, arrow_scale(peaks, side)});
  const auto paint = [&](QPainter& painter) { paint_drawing(painter, drawing, camera, theme); };
  return save_picture(path, pixels, paint, error);
}

}  // namespace carom
