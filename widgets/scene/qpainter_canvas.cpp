#include "widgets/scene/qpainter_canvas.h"

#include <QPainter>

#include "widgets/scene/paint_drawing.h"

namespace carom {

void paint_overlay(QPainter& painter, const Picture& picture) {
  paint_text(painter, picture.drawing, picture.camera, picture.theme);
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
