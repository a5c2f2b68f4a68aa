#include "widgets/scene/bubble.h"

#include <QFontMetricsF>
#include <QPainter>
#include <algorithm>
#include <limits>

#include "widgets/theme/theme.h"

namespace carom {
namespace {

constexpr double kFromMouse = 16.0;  // px
constexpr double kToEdge = 2.0;
constexpr double kPadding = 10.0;
constexpr double kCorner = 5.0;
constexpr double kBetween = 2.0;       // px, of the two lines
constexpr double kFaultGround = 0.14;  // share of the red
constexpr int kValueSize = 14;         // px
constexpr int kDetailSize = 12;

QFont value_font(QFont font) {
  font.setPixelSize(kValueSize);
  font.setWeight(QFont::DemiBold);
  return font;
}

QFont detail_font(QFont font) {
  font.setPixelSize(kDetailSize);
  font.setWeight(QFont::Normal);
  return font;
}

}  // namespace

Bubble refusal_bubble(const QString& sentences, const QPointF& mouse, const QPointF& from) {
  const qsizetype end = sentences.indexOf(". ") + 1;
  if (end == 0) return {sentences, {}, mouse, from, true};
  return {sentences.left(end), sentences.mid(end + 1), mouse, from, true};
}

QRectF place_of(const Bubble& bubble, const QSizeF& size, const QSizeF& view) {
  const double right = bubble.mouse.x() < bubble.from.x() ? -1.0 : 1.0;
  const double down = bubble.mouse.y() > bubble.from.y() ? 1.0 : -1.0;
  const QPointF last(view.width() - size.width() - kToEdge, view.height() - size.height() - kToEdge);
  const QPointF half(0.5 * size.width() + kFromMouse, 0.5 * size.height() + kFromMouse);
  QRectF best;
  int least = std::numeric_limits<int>::max();
  for (const QPointF& side :
       {QPointF(right, down), QPointF(-right, down), QPointF(right, -down), QPointF(-right, -down)}) {
    QRectF wanted(QPointF(), size);
    wanted.moveCenter(bubble.mouse + QPointF(side.x() * half.x(), side.y() * half.y()));
    const QPointF corner(std::max(kToEdge, std::min(wanted.left(), last.x())),
                         std::max(kToEdge, std::min(wanted.top(), last.y())));
    const QRectF place(corner, size);
    const int covered = 2 * bubble.clear_of.covered_by(place) + (corner == wanted.topLeft() ? 0 : 1);
    if (covered >= least) continue;
    least = covered;
    best = place;
  }
  return best;
}

QRectF rect_of(const Bubble& bubble, const QFont& font, const QSizeF& view) {
  const QFontMetricsF of_value(value_font(font));
  const QFontMetricsF of_detail(detail_font(font));
  const double width =
      std::max(of_value.horizontalAdvance(bubble.value), of_detail.horizontalAdvance(bubble.detail));
  const double second = bubble.detail.isEmpty() ? 0.0 : of_detail.height() + kBetween;
  return place_of(bubble, {width + 2 * kPadding, of_value.height() + second + 1.4 * kPadding}, view);
}

void paint_bubble(QPainter& painter, const Bubble& bubble, const QSizeF& view, const Theme& theme) {
  const QFont large = value_font(painter.font());
  const QFont small = detail_font(painter.font());
  const QRectF rect = rect_of(bubble, painter.font(), view);
  painter.setPen(QPen(bubble.fault ? theme.danger : theme.border, 1.0));
  painter.setBrush(bubble.fault ? blend(theme.panel, theme.danger, kFaultGround) : theme.panel);
  painter.drawRoundedRect(rect, kCorner, kCorner);
  const QPointF text = rect.topLeft() + QPointF(kPadding, 0.7 * kPadding);
  const QFontMetricsF of_value(large);
  painter.setFont(large);
  painter.setPen(theme.text);
  painter.drawText(text + QPointF(0.0, of_value.ascent()), bubble.value);
  if (bubble.detail.isEmpty()) return;
  painter.setFont(small);
  painter.setPen(theme.muted);
  painter.drawText(text + QPointF(0.0, of_value.height() + kBetween + QFontMetricsF(small).ascent()),
                   bubble.detail);
}

}  // namespace carom
