#include "widgets/plot/plot_gestures.h"

#include <QMouseEvent>
#include <QWheelEvent>
#include <cmath>
#include <qwt_axis.h>
#include <qwt_plot.h>

namespace carom {

PlotGestures::PlotGestures(QwtPlot* plot) : QObject(plot), plot_(plot) {
  plot->canvas()->setMouseTracking(true);
  plot->canvas()->setFocusPolicy(Qt::StrongFocus);
  plot->canvas()->installEventFilter(this);
}

QPointF PlotGestures::value_at(const QPointF& pixel) const {
  return {plot_->invTransform(QwtAxis::XBottom, pixel.x()), plot_->invTransform(QwtAxis::YLeft, pixel.y())};
}

bool PlotGestures::eventFilter(QObject* watched, QEvent* event) {
  switch (event->type()) {
    case QEvent::Wheel: {
      constexpr double kFactorPerNotch = 0.8;
      const auto* wheel = static_cast<QWheelEvent*>(event);
      const double factor = std::pow(kFactorPerNotch, wheel->angleDelta().y() / 120.0);
      const QPointF at = value_at(wheel->position());
      if (wheel->modifiers() & Qt::ControlModifier) {
        emit valueZoomAsked(at.y(), factor);
      } else {
        emit timeZoomAsked(at.x(), factor);
      }
      return true;
    }
    case QEvent::MouseButtonPress: {
      const auto* mouse = static_cast<QMouseEvent*>(event);
      // A drag with Ctrl belongs to the zoom box.
      const bool boxes = mouse->modifiers().testFlag(Qt::ControlModifier);
      if (mouse->button() == Qt::LeftButton && !boxes) grip_ = mouse->position();
      dragging_ = false;
      return false;
    }
    case QEvent::MouseMove: {
      const QPointF now = static_cast<QMouseEvent*>(event)->position();
      // A smaller movement is a click, not a drag.
      constexpr double kLeastDrag = 3.0;  // px
      if (grip_ && (dragging_ || (now - *grip_).manhattanLength() >= kLeastDrag)) {
        dragging_ = true;
        emit panAsked(value_at(*grip_), value_at(now));
        grip_ = now;
      }
      emit hovered(value_at(now));
      return false;
    }
    case QEvent::MouseButtonRelease: {
      const auto* mouse = static_cast<QMouseEvent*>(event);
      if (grip_ && !dragging_ && mouse->button() == Qt::LeftButton) {
        emit clicked(value_at(mouse->position()), mouse->modifiers());
      }
      grip_.reset();
      return false;
    }
    case QEvent::MouseButtonDblClick:
      grip_.reset();
      emit resetAsked(value_at(static_cast<QMouseEvent*>(event)->position()));
      return true;
    case QEvent::Leave:
      emit hovered(std::nullopt);
      return false;
    default:
      return QObject::eventFilter(watched, event);
  }
}

}  // namespace carom
