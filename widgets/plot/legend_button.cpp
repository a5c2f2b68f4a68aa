#include "widgets/plot/legend_button.h"

#include <QPainter>
#include <algorithm>

#include "widgets/base/plain_text.h"

namespace carom {
namespace {

constexpr int kSample = 16;  // px, the line's length
constexpr int kGap = 5;      // px, between the line and the name
constexpr int kPadding = 4;  // px, left and right

}  // namespace

LegendButton::LegendButton(const QString& label, const QString& tip, QWidget* parent) : QToolButton(parent) {
  setText(label);
  setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
  setCheckable(true);
  setChecked(true);
  setAccessibleName(tr("Show the curve %1").arg(label));
  const auto set_tip = [this, tip](bool shown) {
    const QString click = shown ? tr("Click to hide the curve “%1”") : tr("Click to show the curve “%1”");
    setToolTip(plain_tip((tip.isEmpty() ? QString() : tip + "\n") + click.arg(text())));
  };
  set_tip(true);
  connect(this, &QToolButton::toggled, this, set_tip);
}

void LegendButton::set_look(const QPen& line, const QColor& text) {
  line_ = line;
  text_ = text;
  QFont small = font();
  small.setPixelSize(11);
  setFont(small);
  updateGeometry();
  update();
}

QSize LegendButton::sizeHint() const {
  return {2 * kPadding + kSample + kGap + fontMetrics().horizontalAdvance(text()), fontMetrics().height() + 4};
}

QSize LegendButton::minimumSizeHint() const {
  const int least = fontMetrics().horizontalAdvance("m…");
  return {2 * kPadding + kSample + kGap + std::min(least, fontMetrics().horizontalAdvance(text())),
          sizeHint().height()};
}

void LegendButton::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const double middle = 0.5 * height();
  painter.setOpacity(isChecked() ? 1.0 : 0.35);
  painter.setPen(line_);
  painter.drawLine(QPointF(kPadding, middle), QPointF(kPadding + kSample, middle));

  painter.setOpacity(1.0);
  QFont label_font = font();
  label_font.setStrikeOut(!isChecked());
  label_font.setUnderline(underMouse() || (hasFocus() && window()->testAttribute(Qt::WA_KeyboardFocusChange)));
  painter.setFont(label_font);
  painter.setPen(text_);
  const QRect place = rect().adjusted(kPadding + kSample + kGap, 0, 0, 0);
  painter.drawText(place, Qt::AlignLeft | Qt::AlignVCenter,
                   painter.fontMetrics().elidedText(text(), Qt::ElideRight, place.width()));
}

}  // namespace carom
