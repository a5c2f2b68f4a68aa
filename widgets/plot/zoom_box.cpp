#include "widgets/plot/zoom_box.h"

#include <QKeyEvent>
#include <qwt_axis.h>
#include <qwt_picker_machine.h>
#include <qwt_plot.h>

namespace carom {

ZoomBox::ZoomBox(QwtPlot* plot)
    : QwtPlotPicker(QwtAxis::XBottom, QwtAxis::YLeft, QwtPicker::RectRubberBand, QwtPicker::AlwaysOff,
                    plot->canvas()) {
  setStateMachine(new QwtPickerDragRectMachine);
  setMousePattern(QwtEventPattern::MouseSelect1, Qt::LeftButton, Qt::ControlModifier);
}

bool ZoomBox::accept(QPolygon& box) const {
  constexpr int kLeast = 8;  // px
  if (box.size() < 2) return false;
  QRect area = QRect(box.first(), box.last()).normalized();
  const bool flat = area.height() < kLeast;
  const bool narrow = area.width() < kLeast;
  if (flat && narrow) return false;
  const QRect whole = plot()->canvas()->rect();
  if (flat) area.setRect(area.left(), whole.top(), area.width(), whole.height());
  if (narrow) area.setRect(whole.left(), area.top(), whole.width(), area.height());
  box = QPolygon({area.topLeft(), area.bottomRight()});
  return true;
}

// Qwt's picker would move the mouse with the arrow keys, which move the marks here.
void ZoomBox::widgetKeyPressEvent(QKeyEvent* event) {
  if (isActive() && event->key() == Qt::Key_Escape) reset();
}

}  // namespace carom
