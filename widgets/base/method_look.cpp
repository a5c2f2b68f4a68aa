#include "widgets/base/method_look.h"

#include <QPainter>

#include "physics/dynamics/integrators/integrators.h"

namespace carom {

QColor color_of(IntegratorId id, const Theme& theme) {
  // Indexed by the table of all integrators; the theme has six colours, the text colour is the seventh.
  std::size_t place = 0;
  while (place < kIntegrators.size() && kIntegrators[place].id != id) ++place;
  return place < theme.series.size() ? theme.series[place] : theme.text;
}

QPen line_of(const QColor& color, ImpactsId impacts) {
  QPen pen(color, 1.7);
  if (impacts != ImpactsId::kLocated) pen.setDashPattern({4.0, 2.5});
  return pen;
}

QwtSymbol symbol_of(const QColor& color, ImpactsId impacts, const Theme& theme, int size) {
  const bool located = impacts == ImpactsId::kLocated;
  return {located ? QwtSymbol::Ellipse : QwtSymbol::Rect, located ? QBrush(color) : QBrush(theme.panel),
          QPen(color, 1.4), QSize(size, size)};
}

void draw_sample(QPainter& painter, const QPointF& center, const QColor& color, ImpactsId impacts,
                 const Theme& theme, double width, int marker) {
  const QPointF half(0.5 * width, 0.0);
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(line_of(color, impacts));
  painter.drawLine(center - half, center + half);
  symbol_of(color, impacts, theme, marker).drawSymbol(&painter, center);
  painter.restore();
}

}  // namespace carom
