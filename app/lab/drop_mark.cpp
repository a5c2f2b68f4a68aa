#include "app/lab/drop_mark.h"

#include <QPainter>

namespace carom {

DropMark::DropMark(QWidget* parent) : QWidget(parent) {
  setAttribute(Qt::WA_TransparentForMouseEvents);
  hide();
}

void DropMark::show_at(const QRect& place, const QString& word) {
  word_ = word;
  setGeometry(place);
  raise();
  show();
  update();
}

void DropMark::paintEvent(QPaintEvent* /*event*/) {
  constexpr double kTint = 0.25;
  constexpr double kLine = 2.0;  // px
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QColor accent = palette().color(QPalette::Highlight);
  QColor tint = accent;
  tint.setAlphaF(kTint);
  painter.setPen(QPen(accent, kLine));
  painter.setBrush(tint);
  painter.drawRoundedRect(QRectF(rect()).adjusted(kLine, kLine, -kLine, -kLine), 6.0, 6.0);
  // The word stands on a ground of its own, whatever is below.
  QRectF ground = painter.boundingRect(QRectF(rect()), Qt::AlignCenter, word_);
  ground.adjust(-12.0, -6.0, 12.0, 6.0);
  painter.setBrush(palette().color(QPalette::Base));
  painter.drawRoundedRect(ground, 6.0, 6.0);
  painter.setPen(palette().color(QPalette::WindowText));
  painter.drawText(ground, Qt::AlignCenter, word_);
}

}  // namespace carom
