#include "widgets/plot/plot_export.h"

#include <QPainter>
#include <optional>

#include "widgets/plot/plot_render.h"
#include "widgets/plot/run_plot.h"
#include "widgets/print/picture_file.h"
#include "widgets/theme/theme.h"

namespace carom {
namespace {

constexpr int kMargin = 10;     // px
constexpr int kHeader = 28;     // px
constexpr int kLegendRow = 16;  // px, of each further row of the legend
constexpr int kSample = 22;     // px, of a line in the legend
constexpr int kGap = 6;         // px
constexpr int kBetween = 16;    // px, entries of the legend

QFont font_of(int pixels, bool bold) {
  QFont font;
  font.setPixelSize(pixels);
  font.setBold(bold);
  return font;
}

// Title, unit and legend, from the upper left; the legend continues in further rows.
struct Header {
  static constexpr double kBase = 14.0;  // px
  const QFont title_font = font_of(13, true);
  const QFont unit_font = font_of(12, false);
  const QFont label_font = font_of(11, false);

  struct Entry {
    QString label;
    QPen pen;
    QPointF at;
  };
  QPointF title{0.0, kBase};
  QPointF unit;
  std::vector<Entry> legend;
  double height = kHeader;

  Header(const RunPlot& plot, double width) {
    const auto length = [](const QString& text, const QFont& font) {
      return QFontMetricsF(font).horizontalAdvance(text);
    };
    double x = length(plot.content().title, title_font) + kGap;
    unit = {x, kBase};
    x += length(plot.content().unit.name, unit_font) + kBetween;
    double base = kBase;
    for (const auto& [label, pen] : plot.legend()) {
      const double end = x + kSample + kGap + length(label, label_font);
      if (end > width && x > 0.0) {
        x = 0.0;
        base += kLegendRow;
        height += kLegendRow;
      }
      legend.push_back({label, pen, {x, base}});
      x += kSample + kGap + length(label, label_font) + kBetween;
    }
  }
};

QSize size_of(const RunPlot& plot) {
  const double more = Header(plot, plot.width()).height - kHeader;
  return plot.size() + QSize(2 * kMargin, kMargin + static_cast<int>(more));
}

// Within its margins.
void paint(RunPlot& plot, QPainter& painter, const QRectF& where) {
  const Theme& theme = light_theme();
  const Header header(plot, where.width());
  painter.setRenderHint(QPainter::Antialiasing);
  const auto write = [&](const QPointF& at, const QString& text, const QFont& font, const QColor& color) {
    painter.setFont(font);
    painter.setPen(color);
    painter.drawText(where.topLeft() + at, text);
  };
  write(header.title, plot.content().title, header.title_font, theme.text);
  write(header.unit, plot.content().unit.name, header.unit_font, theme.muted);
  for (const Header::Entry& entry : header.legend) {
    const QPointF line = where.topLeft() + entry.at - QPointF(0.0, 4.0);
    painter.setPen(entry.pen);
    painter.drawLine(line, line + QPointF(kSample, 0.0));
    write(entry.at + QPointF(kSample + kGap, 0.0), entry.label, header.label_font, theme.muted);
  }
  render_plot(*plot.plot(), painter, where.adjusted(0, header.height, 0, 0));
}

// In the size on the screen, with margins, on white.
void paint(RunPlot& plot, QPainter& painter) {
  const QSize size = size_of(plot);
  painter.fillRect(QRect(QPoint(), size), light_theme().panel);
  paint(plot, painter, QRectF(QPointF(), size).adjusted(kMargin, kMargin, -kMargin, -kMargin));
}

// In the light colours, and without the line under the mouse.
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
