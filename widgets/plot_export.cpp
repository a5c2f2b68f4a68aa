#include "widgets/plot_export.h"

#include <QPainter>
#include <optional>

#include "widgets/picture_file.h"
#include "widgets/plot_render.h"
#include "widgets/run_plot.h"
#include "widgets/theme.h"

namespace carom {
namespace {

constexpr int kMargin = 10;   // px
constexpr int kHeader = 28;   // px
constexpr int kSample = 22;   // px, of a line in the legend
constexpr int kGap = 6;       // px
constexpr int kBetween = 16;  // px, entries of the legend

QFont font_of(int pixels, bool bold) {
  QFont font;
  font.setPixelSize(pixels);
  font.setBold(bold);
  return font;
}

QSize size_of(const RunPlot& plot) { return plot.size() + QSize(2 * kMargin, kMargin); }

// Within its margins.
void paint(RunPlot& plot, QPainter& painter, const QRectF& where) {
  const Theme& theme = light_theme();
  painter.setRenderHint(QPainter::Antialiasing);
  double x = where.left();
  const double base = where.top() + 14;
  const auto write = [&](const QString& text, const QFont& font, const QColor& color) {
    painter.setFont(font);
    painter.setPen(color);
    painter.drawText(QPointF(x, base), text);
    x += QFontMetricsF(font).horizontalAdvance(text);
  };
  write(plot.content().title, font_of(13, true), theme.text);
  x += kGap;
  write(plot.content().unit, font_of(12, false), theme.muted);
  x += kBetween;
  for (const auto& [label, pen] : plot.legend()) {
    painter.setPen(pen);
    painter.drawLine(QPointF(x, base - 4.0), QPointF(x + kSample, base - 4.0));
    x += kSample + kGap;
    write(label, font_of(11, false), theme.muted);
    x += kBetween;
  }
  render_plot(*plot.plot(), painter, where.adjusted(0, kHeader, 0, 0));
}

// Of the size on the screen, with margins, on white.
void paint(RunPlot& plot, QPainter& painter) {
  const QSize size = size_of(plot);
  painter.fillRect(QRect(QPoint(), size), light_theme().panel);
  paint(plot, painter, QRectF(QPointF(), size).adjusted(kMargin, kMargin, -kMargin, -kMargin));
}

// In the colours of paper, and without the line under the mouse.
template <class Draw>
void on_paper(RunPlot& plot, const Draw& draw) {
  const Theme theme = plot.theme();
  plot.set_theme(light_theme());
  plot.set_cursor(std::nullopt);
  draw();
  plot.set_theme(theme);
}

}  // namespace

bool save_plot_picture(RunPlot& plot, const QString& path, QString* error) {
  bool saved = false;
  constexpr int kDots = 2;
  on_paper(plot, [&] {
    saved = save_picture(
        path, size_of(plot), [&](QPainter& painter) { paint(plot, painter); }, error, kDots);
  });
  return saved;
}

QPixmap plot_picture(RunPlot& plot) {
  QPixmap picture(size_of(plot));
  on_paper(plot, [&] {
    QPainter painter(&picture);
    paint(plot, painter);
  });
  return picture;
}

void paint_plot(RunPlot& plot, QPainter& painter, const QRectF& where) {
  on_paper(plot, [&] { paint(plot, painter, where); });
}

}  // namespace carom
