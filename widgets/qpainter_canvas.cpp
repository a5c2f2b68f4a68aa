#include "widgets/qpainter_canvas.h"

#include <QPainter>

#include "widgets/paint_drawing.h"

namespace carom {

QPainterCanvas::QPainterCanvas(const Picture& picture, QWidget* parent) : QWidget(parent), picture_(picture) {
  setAttribute(Qt::WA_OpaquePaintEvent);
  setAttribute(Qt::WA_TransparentForMouseEvents);
}

void QPainterCanvas::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  paint_drawing(painter, picture_.drawing, picture_.camera, picture_.theme);
}

}  // namespace carom
