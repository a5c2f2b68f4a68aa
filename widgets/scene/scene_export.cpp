#include "widgets/scene/scene_export.h"

#include <QPainter>
#include <algorithm>

#include "physics/preset/preset.h"
#include "widgets/print/picture_file.h"
#include "widgets/print/save_file.h"
#include "widgets/scene/paint_drawing.h"

namespace carom {
namespace {

constexpr int kMargin = 40;  // px around a fitted scene

}  // namespace

SceneLook scene_look(const Frame& frame, const std::optional<View>& view, const DrawingOptions& options,
                     const Theme& theme, QSize pixels) {
  SceneLook look;
  look.options = options;
  look.theme = theme;
  look.camera.viewport = pixels;
  if (view) {
    look.camera.show(*view);
  } else {
    look.camera.fit(bounds(frame), QMarginsF(kMargin, kMargin, kMargin, kMargin));
  }
  look.side = std::min(pixels.width(), pixels.height()) / look.camera.scale;
  return look;
}

SceneLook on_viewport(SceneLook look, const QSizeF& viewport) {
  const WorldRect shown = look.camera.visible();
  look.camera.viewport = viewport;
  look.camera.fit(shown, {});
  return look;
}

void paint_scene(QPainter& painter, const Frame& frame, SceneLook& look, std::span<const Frame> others) {
  look.peaks.observe(frame);
  OtherRuns outlines;
  for (const Frame& other : others) outlines.push_back(std::make_shared<const Frame>(other));
  const Drawing drawing = make_drawing({frame, frame.impacts, look.camera, look.options, look.theme,
                                        arrow_scale(look.peaks, look.side) * look.times, outlines});
  paint_drawing(painter, drawing, look.camera, look.theme);
}

void write_scene_picture(OutputFile& file, const Frame& frame, const std::optional<View>& view,
                         const DrawingOptions& options, const Theme& theme, QSize pixels) {
  if (pixels.isEmpty()) return write_picture(file, pixels, {});  // reports the error
  SceneLook look = scene_look(frame, view, options, theme, pixels);
  write_picture(file, pixels, [&](QPainter& painter) { paint_scene(painter, frame, look); });
}

bool save_scene_picture(const Frame& frame, const std::optional<View>& view, const DrawingOptions& options,
                        const Theme& theme, QSize pixels, const QString& path, QString* error) {
  return save_file(
      path, [&](OutputFile& file) { write_scene_picture(file, frame, view, options, theme, pixels); }, error);
}

}  // namespace carom
