#include "widgets/smooth_curve.h"

#include <QLineF>
#include <QPainter>
#include <QPen>
#include <QPolygonF>
#include <algorithm>
#include <qwt_clipper.h>
#include <qwt_scale_map.h>

namespace carom {

void SmoothCurve::drawLines(QPainter* painter, const QwtScaleMap& x, const QwtScaleMap& y, const QRectF& canvas,
                            int from, int to) const {
  QPolygonF line;
  line.reserve(to - from + 1);
  for (int i = from; i <= to; ++i) line.append(QwtScaleMap::transform(x, y, sample(i)));
  // Far outside the dashes of a steep line would be countless.
  constexpr double kMargin = 10.0;  // px, more than the pen's width
  QwtClipper::clipPolygonF(canvas.adjusted(-kMargin, -kMargin, kMargin, kMargin), line, false);

  // In pieces, because the raster engine's time grows with the square of a path's crossings; the dashes go on.
  constexpr qsizetype kPiece = 64;  // points
  QPen dashes = pen();
  dashes.setCapStyle(Qt::FlatCap);
  double length = 0.0;  // px, of what is drawn
  for (qsizetype begin = 0; begin + 1 < line.size(); begin += kPiece) {
    const qsizetype count = std::min(kPiece + 1, line.size() - begin);
    if (dashes.style() != Qt::SolidLine) dashes.setDashOffset(length / dashes.widthF());
    painter->setPen(dashes);
    painter->drawPolyline(line.constData() + begin, static_cast<int>(count));
    for (qsizetype i = begin + 1; i < begin + count; ++i) length += QLineF(line[i - 1], line[i]).length();
  }
}

}  // namespace carom
