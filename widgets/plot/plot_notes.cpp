#include "widgets/plot/plot_notes.h"

#include <QFont>
#include <QFontMetricsF>
#include <QPainter>
#include <algorithm>
#include <qwt_plot.h>
#include <qwt_scale_map.h>

#include "physics/preset/preset.h"

namespace carom {
namespace {

constexpr double kRing = 3.5;     // px, radius
constexpr double kAway = 6.0;     // px, from the point to the words
constexpr double kPadding = 4.0;  // px
constexpr int kWords = Qt::AlignLeft | Qt::AlignTop | Qt::TextWordWrap;

QFont words_font() {
  QFont font;
  font.setPixelSize(11);
  return font;
}

QString words_of(const PlotNote& note) { return QString::fromStdString(note.text); }

}  // namespace

PlotNotes::PlotNotes(QwtPlot* plot) {
  setRenderHint(RenderAntialiased);
  constexpr double kOnTop = 100.0;
  setZ(kOnTop);
  attach(plot);
}

void PlotNotes::set_notes(const std::vector<PlotNote>& notes) { notes_ = notes; }

void PlotNotes::set_theme(const Theme& theme) { theme_ = theme; }

// Right of the point and above it, or on the side with room.
std::optional<PlotNotes::Place> PlotNotes::place(const PlotNote& note, const QwtScaleMap& x,
                                                 const QwtScaleMap& y, const QRectF& canvas) const {
  const QPointF point = QwtScaleMap::transform(x, y, {note.x, note.y});
  if (!canvas.contains(point)) return std::nullopt;
  const double most = std::max(80.0, 0.45 * canvas.width());
  QRectF words = QFontMetricsF(words_font()).boundingRect(QRectF(0.0, 0.0, most, 1e4), kWords, words_of(note));
  words.adjust(-kPadding, -0.5 * kPadding, kPadding, 0.5 * kPadding);
  words.moveBottomLeft(point + QPointF(kAway, -kAway));
  if (words.right() > canvas.right()) words.moveRight(point.x() - kAway);
  if (words.top() < canvas.top()) words.moveTop(point.y() + kAway);
  if (words.left() < canvas.left()) words.moveLeft(canvas.left());
  if (words.bottom() > canvas.bottom()) words.moveBottom(canvas.bottom());
  return Place{point, words};
}

std::optional<std::size_t> PlotNotes::at(const QPointF& pixel) const {
  const QwtScaleMap x = plot()->canvasMap(xAxis());
  const QwtScaleMap y = plot()->canvasMap(yAxis());
  const QRectF canvas = QRectF(plot()->canvas()->contentsRect());
  for (std::size_t i = notes_.size(); i-- > 0;) {
    const std::optional<Place> found = place(notes_[i], x, y, canvas);
    if (!found) continue;
    if (found->words.contains(pixel) || (pixel - found->point).manhattanLength() <= 2.0 * kRing) return i;
  }
  return std::nullopt;
}

void PlotNotes::draw(QPainter* painter, const QwtScaleMap& x, const QwtScaleMap& y,
                     const QRectF& canvas) const {
  for (const PlotNote& note : notes_) {
    const std::optional<Place> found = place(note, x, y, canvas);
    if (!found) continue;
    painter->setPen(QPen(theme_.accent, 1.5));
    painter->setBrush(theme_.panel);
    painter->drawEllipse(found->point, kRing, kRing);
    QColor ground = theme_.panel;
    ground.setAlphaF(0.85F);
    painter->setPen(Qt::NoPen);
    painter->setBrush(ground);
    painter->drawRoundedRect(found->words, 3.0, 3.0);
    painter->setPen(theme_.text);
    painter->setFont(words_font());
    painter->drawText(found->words.adjusted(kPadding, 0.5 * kPadding, -kPadding, -0.5 * kPadding), kWords,
                      words_of(note));
  }
}

}  // namespace carom
