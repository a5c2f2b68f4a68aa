#include "widgets/print/print_blocks.h"

#include <QTextLayout>
#include <algorithm>
#include <cmath>
#include <memory>

#include "widgets/theme/theme.h"

namespace carom {
namespace {

constexpr int kText = 12;         // px, size of plain text
constexpr double kNames = 104.0;  // px, room of an entry's name
constexpr double kRule = 30.0;    // px between lines to write on
constexpr double kLine = 0.75;    // px

const Theme& theme() { return light_theme(); }

// Text wrapped into lines once, for any paint device.
struct Lines {
  Lines(const QString& text, const QFont& font, double width) : layout(text, font) {
    QTextOption option;
    option.setUseDesignMetrics(true);
    layout.setTextOption(option);
    layout.beginLayout();
    for (QTextLine line = layout.createLine(); line.isValid(); line = layout.createLine()) {
      line.setLineWidth(width);
      line.setPosition({0.0, height});
      height += std::ceil(1.12 * line.height());
    }
    layout.endLayout();
  }
  QTextLayout layout;
  double height = 0.0;
};

}  // namespace

QFont print_font(int size, bool bold) {
  QFont font;
  font.setPixelSize(size);
  font.setBold(bold);
  font.setHintingPreference(QFont::PreferNoHinting);
  return font;
}

PrintBlock print_text(const QString& text, const QFont& font, const QColor& color) {
  auto lines = std::make_shared<Lines>(text, font, PrintPages::kTextWidth);
  PrintBlock block;
  block.height = lines->height;
  block.paint = [lines, color](QPainter& painter, const QRectF& where) {
    painter.setPen(color);
    lines->layout.draw(&painter, where.topLeft());
  };
  return block;
}

PrintBlock print_heading(const QString& text) {
  PrintBlock block = print_text(text, print_font(16, true), theme().text);
  block.gap = 24.0;
  block.with_next = true;
  return block;
}

PrintBlock print_entry(const QString& name, const QString& text) {
  auto lines = std::make_shared<Lines>(text, print_font(kText), PrintPages::kTextWidth - kNames);
  PrintBlock block;
  block.height = lines->height;
  block.gap = 5.0;
  block.paint = [lines, name](QPainter& painter, const QRectF& where) {
    const Lines label(name, print_font(kText), kNames - 8.0);
    painter.setPen(theme().muted);
    label.layout.draw(&painter, where.topLeft());
    painter.setPen(theme().text);
    lines->layout.draw(&painter, where.topLeft() + QPointF(kNames, 0.0));
  };
  return block;
}

PrintBlock print_ruled(int lines) {
  PrintBlock block;
  block.height = lines * kRule;
  block.gap = 4.0;
  block.grows = true;
  block.paint = [](QPainter& painter, const QRectF& where) {
    painter.setPen(QPen(theme().strong_grid, kLine));
    for (double y = where.top() + kRule; y <= where.bottom() + 1e-6; y += kRule)
      painter.drawLine(QPointF(where.left(), y), QPointF(where.right(), y));
  };
  return block;
}

PrintBlock print_fields(const std::vector<PrintField>& fields) {
  PrintBlock block;
  block.height = 24.0;
  block.gap = 18.0;
  block.paint = [fields](QPainter& painter, const QRectF& where) {
    constexpr double kGap = 20.0;
    constexpr double kBase = 6.0;  // px of the words above the line's foot
    const double room = where.width() - kGap * static_cast<double>(fields.size() - 1);
    double x = where.left();
    for (const PrintField& field : fields) {
      const double end = x + field.share * room;
      painter.setFont(print_font(kText));
      painter.setPen(theme().muted);
      painter.drawText(QPointF(x, where.bottom() - kBase), field.name);
      const double start = x + QFontMetricsF(painter.font()).horizontalAdvance(field.name) + 8.0;
      painter.setPen(QPen(theme().muted, kLine));
      painter.drawLine(QPointF(start, where.bottom() - 2.0), QPointF(end, where.bottom() - 2.0));
      painter.setPen(theme().text);
      const QFontMetricsF metrics(painter.font());
      painter.drawText(QPointF(start + 4.0, where.bottom() - kBase),
                       metrics.elidedText(field.text, Qt::ElideRight, end - start - 8.0));
      x = end + kGap;
    }
  };
  return block;
}

PrintBlock print_row(std::vector<PrintBlock> blocks, int columns, double gap) {
  PrintBlock row;
  for (const PrintBlock& block : blocks) row.height = std::max(row.height, block.height);
  row.paint = [blocks = std::move(blocks), columns, gap](QPainter& painter, const QRectF& where) {
    const double width = (where.width() - gap * (columns - 1)) / columns;
    for (std::size_t i = 0; i < blocks.size(); ++i) {
      painter.save();
      blocks[i].paint(painter, QRectF(where.left() + static_cast<double>(i) * (width + gap), where.top(), width,
                                      blocks[i].height));
      painter.restore();
    }
  };
  return row;
}

}  // namespace carom
