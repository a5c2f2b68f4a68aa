#include "widgets/edit/drag_label.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <cmath>

namespace carom {
namespace {

constexpr int kSlack = 4;  // px, until a press is a pull
constexpr double kFine = 0.1;

int x_of(const QMouseEvent* event) { return static_cast<int>(std::lround(event->globalPosition().x())); }

}  // namespace

DragLabel::DragLabel(const QString& text, QWidget* parent) : PlainLabel(text, parent) {
  setCursor(Qt::SizeHorCursor);
  setFocusPolicy(Qt::ClickFocus);  // for Esc
}

void DragLabel::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return;
  last_x_ = x_of(event);
  pulling_ = false;
  pixels_ = 0.0;
}

void DragLabel::mouseMoveEvent(QMouseEvent* event) {
  if (!last_x_) return;
  const int moved_by = x_of(event) - *last_x_;
  if (!pulling_) {
    if (std::abs(moved_by) < kSlack) return;
    pulling_ = true;
    emit began();
  }
  last_x_ = x_of(event);
  pixels_ += moved_by * (event->modifiers().testFlag(Qt::ShiftModifier) ? kFine : 1.0);
  emit moved(pixels_);
}

void DragLabel::mouseReleaseEvent(QMouseEvent* /*event*/) {
  last_x_.reset();
  pulling_ = false;
}

bool DragLabel::event(QEvent* event) {
  // Esc ends the pull before it is a shortcut of the window.
  if (event->type() == QEvent::ShortcutOverride && pulling_ &&
      static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape) {
    event->accept();
    return true;
  }
  return PlainLabel::event(event);
}

void DragLabel::keyPressEvent(QKeyEvent* event) {
  if (event->key() != Qt::Key_Escape || !pulling_) {
    PlainLabel::keyPressEvent(event);
    return;
  }
  last_x_.reset();
  pulling_ = false;
  emit moved(0.0);
}

}  // namespace carom
