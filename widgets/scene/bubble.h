#pragma once

#include <QPointF>
#include <QRectF>
#include <QSizeF>
#include <QString>

#include "widgets/scene/obstacles.h"

class QFont;
class QPainter;

namespace carom {

struct Theme;

// The value beside the mouse.
struct Bubble {
  QString value;   // empty: no bubble
  QString detail;  // under the value
  QPointF mouse;   // px, beside which it stands, on the side away from
  QPointF from;    // where the mouse came from
  bool fault = false;
  Obstacles clear_of{};
};

// A red one that says why something can't be; its second sentence stands under the first.
[[nodiscard]] Bubble refusal_bubble(const QString& sentences, const QPointF& mouse, const QPointF& from);
// Where what is so large stands beside the mouse, in px: in the first quarter around it that lies within the
// view and covers nothing, that to which the mouse went before the others.
[[nodiscard]] QRectF place_of(const Bubble& bubble, const QSizeF& size, const QSizeF& view);
[[nodiscard]] QRectF rect_of(const Bubble& bubble, const QFont& font, const QSizeF& view);
void paint_bubble(QPainter& painter, const Bubble& bubble, const QSizeF& view, const Theme& theme);

}  // namespace carom
