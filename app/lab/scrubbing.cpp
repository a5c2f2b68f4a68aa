#include "app/lab/scrubbing.h"

#include <QCoreApplication>
#include <QKeyEvent>
#include <utility>

namespace carom {

void Scrubbing::begin() {
  plays_ = runs_.plays();
  from_ = runs_.shown_moment();
  qApp->installEventFilter(this);
}

void Scrubbing::to(double time) {
  if (from_) runs_.go_to(time);
}

void Scrubbing::end() {
  qApp->removeEventFilter(this);
  from_.reset();
  if (std::exchange(plays_, false)) runs_.set_playing(true);
}

bool Scrubbing::eventFilter(QObject* /*watched*/, QEvent* event) {
  // As a shortcut it would be the window's.
  if (event->type() != QEvent::ShortcutOverride && event->type() != QEvent::KeyPress) return false;
  if (!from_ || static_cast<QKeyEvent*>(event)->key() != Qt::Key_Escape) return false;
  runs_.go_back_to(*std::exchange(from_, std::nullopt));
  event->accept();
  return true;
}

}  // namespace carom
