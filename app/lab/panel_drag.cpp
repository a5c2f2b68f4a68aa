#include "app/lab/panel_drag.h"

#include <QAbstractButton>
#include <QApplication>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QWidget>
#include <algorithm>
#include <utility>

namespace carom {

void PanelDrag::watch(QWidget* widget, std::function<bool(const QPoint&)> in_head) {
  heads_.push_back({widget, std::move(in_head)});
  widget->installEventFilter(this);
}

// While it is dragged, the filter is the application's: the mouse and Escape are the drag's, whoever has the
// focus. The press goes on to what is in the head.
bool PanelDrag::eventFilter(QObject* watched, QEvent* event) {
  if (!watched->isWidgetType()) return false;
  switch (event->type()) {
    case QEvent::MouseButtonPress: {
      const auto* mouse = static_cast<QMouseEvent*>(event);
      if (dragging_) return true;
      if (mouse->button() == Qt::LeftButton)
        press(watched, mouse->position().toPoint(), mouse->globalPosition().toPoint());
      return false;
    }
    case QEvent::MouseMove: {
      const auto* mouse = static_cast<QMouseEvent*>(event);
      if (!pressed_) return false;
      if (mouse->buttons().testFlag(Qt::LeftButton)) return drag(mouse->globalPosition().toPoint());
      if (dragging_) emit cancelled();
      end();
      return false;
    }
    case QEvent::MouseButtonRelease: {
      const bool was_dragging = dragging_;
      end();
      if (was_dragging) emit dropped(static_cast<QMouseEvent*>(event)->globalPosition().toPoint());
      return was_dragging;
    }
    case QEvent::ShortcutOverride:
    case QEvent::KeyPress:
      if (!dragging_ || static_cast<QKeyEvent*>(event)->key() != Qt::Key_Escape) return false;
      end();
      emit cancelled();
      event->accept();
      return true;
    default:
      return false;
  }
}

void PanelDrag::press(const QObject* watched, const QPoint& at, const QPoint& global) {
  const bool taken = std::any_of(heads_.begin(), heads_.end(),
                                 [&](const Head& head) { return head.widget == watched && head.in_head(at); });
  if (taken) pressed_ = global;
}

bool PanelDrag::drag(const QPoint& to) {
  constexpr int kStart = 4;  // px
  if (!dragging_) {
    if ((to - *pressed_).manhattanLength() < kStart) return false;
    dragging_ = true;
    qApp->installEventFilter(this);
    QApplication::setOverrideCursor(Qt::ClosedHandCursor);
    // A button in the head is not pressed by it.
    for (const Head& head : heads_) {
      if (auto* button = qobject_cast<QAbstractButton*>(head.widget)) button->setDown(false);
    }
  }
  emit moved(to);
  return true;
}

void PanelDrag::end() {
  pressed_.reset();
  if (!std::exchange(dragging_, false)) return;
  qApp->removeEventFilter(this);
  QApplication::restoreOverrideCursor();
}

}  // namespace carom
