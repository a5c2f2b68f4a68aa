#include "widgets/scene/scene_thumbnail.h"

#include <QPainter>

#include "widgets/scene/paint_drawing.h"

namespace carom {

QPixmap scene_thumbnail(const Frame& frame, const Theme& theme, QSize size, double pixel_ratio) {
  constexpr double kMargin = 4.0;  // px
  DrawingOptions options;
  options.grid = options.velocities = options.forces = options.contacts = options.names = false;
  options.line_scale = 0.55;
  Camera camera;
  camera.viewport = size;
  camera.fit(bounds(frame), QMarginsF(kMargin, kMargin, kMargin, kMargin));
  Drawing drawing = make_drawing({frame, {}, camera, options, theme, ArrowScale{}});
  for (Drawing::DiscItem& disc : drawing.discs) disc.oriented = false;

  QPixmap picture(size * pixel_ratio);
  picture.setDevicePixelRatio(pixel_ratio);
  picture.fill(theme.scene_ground);
  QPainter painter(&picture);
  paint_drawing(painter, drawing, camera, theme);
  return picture;
}

}  // namespace carom
