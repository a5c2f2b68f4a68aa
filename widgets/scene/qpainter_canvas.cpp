#include "widgets/scene/qpainter_canvas.h"

#include <QImage>
#include <QPaintEngine>
#include <QPainter>

#include "widgets/scene/paint_drawing.h"

namespace carom {

namespace {

// OpenGL has no samples that would smooth the lines, so they are painted apart.
void paint_tools_smoothly(QPainter& painter, const Picture& picture) {
  if (picture.overlay.empty()) return;
  if (painter.paintEngine()->type() != QPaintEngine::OpenGL2) {
    paint_tools(painter, picture.overlay, picture.camera, picture.theme);
    return;
  }
  const double ratio = painter.device()->devicePixelRatioF();
  QImage layer((picture.camera.viewport * ratio).toSize(), QImage::Format_ARGB32_Premultiplied);
  layer.setDevicePixelRatio(ratio);
  layer.fill(Qt::transparent);
  QPainter on_layer(&layer);
  on_layer.setFont(painter.font());
  paint_tools(on_layer, picture.overlay, picture.camera, picture.theme);
  painter.drawImage(QPointF(), layer);
}

}  // namespace

void paint_overlay(QPainter& painter, const Picture& picture) {
  paint_text(painter, picture.drawing, picture.camera, picture.theme,
             obstacles_of_names(picture.overlay, picture.camera));
  paint_tools_smoothly(painter, picture);
  if (!picture.focus_frame) return;
  painter.setPen(QPen(picture.theme.accent, 2.0));
  painter.setBrush(Qt::NoBrush);
  painter.drawRect(QRectF(QPointF(), picture.camera.viewport).adjusted(1.0, 1.0, -1.0, -1.0));
}

QPainterCanvas::QPainterCanvas(const Picture& picture, QWidget* parent) : QWidget(parent), picture_(picture) {
  setAttribute(Qt::WA_OpaquePaintEvent);
  setAttribute(Qt::WA_TransparentForMouseEvents);
}

void QPainterCanvas::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  paint_shapes(painter, picture_.drawing, picture_.camera, picture_.theme);
  paint_overlay(painter, picture_);
}

}  // namespace carom
