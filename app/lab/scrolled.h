#pragma once

#include <QEvent>
#include <QScrollArea>
#include <QScrollBar>

namespace carom {

// Scrolls its content, with the parent's background.
template <class Area>
Area* scrolled(QWidget* inside) {
  auto* area = new Area;
  area->setWidget(inside);
  area->setWidgetResizable(true);
  area->setFrameShape(QFrame::NoFrame);
  area->setStyleSheet("QScrollArea, QScrollArea > QWidget > QWidget { background: transparent; }");
  return area;
}

// Scrolls vertically only: as wide as its content.
class TallArea : public QScrollArea {
 public:
  [[nodiscard]] QSize minimumSizeHint() const override {
    const int bar = verticalScrollBar()->sizeHint().width();
    return {widget() == nullptr ? 0 : widget()->minimumSizeHint().width() + bar, 0};
  }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override {
    if (watched == widget() && event->type() == QEvent::LayoutRequest) updateGeometry();
    return QScrollArea::eventFilter(watched, event);
  }
};

}  // namespace carom
