#include "widgets/plot/smooth_curve.h"

#include <QLineF>
#include <QPainter>
#include <QPen>
#include <QPolygonF>
#include <qwt_clipper.h>
#include <qwt_scale_map.h>

namespace carom {

void SmoothCurve::drawLines(QPainter* painter, const QwtScaleMap& x, const QwtScaleMap& y, const QRectF& canvas,
                            int from, int to) const {
  QPolygonF line;
  line.reserve(to - from + 1);
  for (int i = from; i <= to; ++i) line.append(QwtScaleMap::transform(x, y, sample(i)));
  // Clipped: the dashes of a steep line far outside would be countless.
  constexpr double kMargin = 10.0;  // px, more than the pen's width
  QwtClipper::clipPolygonF(canvas.adjusted(-kMargin, -kMargin, kMargin, kMargin), line, false);

  // A line that goes up and down everywhere is drawn in pieces: with 1400 points over the full height that
  // took 15 ms where one path took 90 ms. The dashes continue. A smooth line stays in one piece: seams would
  // be visible on it.
  constexpr double kPiece = 3000.0;  // px
  QPen dashes = pen();
  dashes.setCapStyle(Qt::FlatCap);
  double before = 0.0;  // px, length of the pieces that are drawn
  double piece = 0.0;   // px, length of the piece that begins at `begin`
  for (qsizetype begin = 0, i = 1; i < line.size(); ++i) {
    piece += QLineF(line[i - 1], line[i]).length();
    if (piece < kPiece && i + 1 < line.size()) continue;
    if (dashes.style() != Qt::SolidLine) dashes.setDashOffset(before / dashes.widthF());
    painter->setPen(dashes);
    painter->drawPolyline(line.constData() + begin, static_cast<int>(i - begin + 1));
    begin = i;
    before += piece;
    piece = 0.0;
  }
}

}  // namespace carom
