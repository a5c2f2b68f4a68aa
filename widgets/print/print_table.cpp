#include <QCoreApplication>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

#include "widgets/base/figure_table.h"
#include "widgets/print/print_blocks.h"
#include "widgets/theme/theme.h"

namespace carom {
namespace {

constexpr double kRow = 20.0;        // px
constexpr double kInset = 5.0;       // px, of a cell
constexpr double kLine = 0.75;       // px
constexpr int kHeadText = 10;        // px
constexpr int kText = 11;            // px
constexpr double kLeastScale = 0.6;  // of a table that is wider than the page

const Theme& theme() { return light_theme(); }

struct Cell {
  QString text;
  bool left = true;
  bool pale = false;
};

struct Row {
  std::vector<Cell> cells;
  bool sum = false;
};

// The head stands first.
std::vector<Row> rows_of(const FigureModel& table, int most) {
  const int columns = table.columnCount();
  const auto left = [&](int column) {
    return (table.headerData(column, Qt::Horizontal, Qt::TextAlignmentRole).toInt() & Qt::AlignLeft) != 0;
  };
  std::vector<Row> rows(1);
  for (int c = 0; c < columns; ++c)
    rows[0].cells.push_back({table.headerData(c, Qt::Horizontal, Qt::DisplayRole).toString(), left(c), true});
  int more = 0;
  for (int r = 0; r < table.rowCount(); ++r) {
    Row row;
    row.sum = table.is_sum(r);
    bool has_values = false;
    for (int c = 0; c < columns; ++c) {
      row.cells.push_back({table.index(r, c).data().toString(), left(c), table.is_idle(r, c)});
      has_values = has_values || (!row.cells.back().pale && !row.cells.back().text.isEmpty());
    }
    if (!has_values) continue;
    const bool too_many = !row.sum && static_cast<int>(rows.size()) > most;
    if (row.sum && more > 0) {
      Row note;
      note.cells.push_back({QCoreApplication::translate("PrintTable", "and %1 more").arg(more), true, true});
      rows.push_back(note);
    }
    more += too_many ? 1 : 0;
    if (!too_many) rows.push_back(std::move(row));
  }
  return rows;
}

QFont font_of(const std::vector<Row>& rows, std::size_t row) {
  return print_font(row == 0 ? kHeadText : kText, rows[row].sum);
}

// px: what each column needs.
std::vector<double> least_widths(const std::vector<Row>& rows) {
  std::vector<double> widths(rows[0].cells.size());
  for (std::size_t r = 0; r < rows.size(); ++r) {
    const QFontMetricsF metrics(font_of(rows, r));
    if (rows[r].cells.size() < widths.size()) continue;  // a line across
    for (std::size_t c = 0; c < widths.size(); ++c) {
      const double text = metrics.size(0, rows[r].cells[c].text).width();
      widths[c] = std::max(widths[c], std::ceil(text) + 2.0 * kInset);
    }
  }
  return widths;
}

// px: shares of the page by the columns' weights, or what they need where that is more. Their sum may be wider
// than the page.
std::vector<double> widths_of(const FigureModel& table, const std::vector<Row>& rows) {
  std::vector<double> widths = least_widths(rows);
  double weights = 0.0;
  for (int c = 0; c < table.columnCount(); ++c) weights += table.weight(c);
  const double needed = std::accumulate(widths.begin(), widths.end(), 0.0);
  const double spare = std::max(0.0, PrintPages::kTextWidth - needed);
  for (int c = 0; c < table.columnCount(); ++c)
    widths[static_cast<std::size_t>(c)] += spare * table.weight(c) / weights;
  return widths;
}

void paint_row(QPainter& painter, const Row& row, const std::vector<double>& widths, const QRectF& where,
               bool head) {
  const QFontMetricsF metrics(painter.font());
  double x = where.left();
  // At the edges the cells' text is aligned with the page's text.
  for (std::size_t c = 0; c < row.cells.size(); ++c) {
    const Cell& cell = row.cells[c];
    const bool alone = row.cells.size() == 1;
    const double width = alone ? where.width() : widths[c];
    const double before = c == 0 ? 0.0 : kInset;
    const double after = c + 1 == widths.size() || alone ? 0.0 : kInset;
    const QRectF place(x + before, where.top(), width - before - after, where.height());
    painter.setPen(cell.pale ? theme().muted : theme().text);
    painter.drawText(place, (cell.left ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter,
                     head ? cell.text : metrics.elidedText(cell.text, Qt::ElideRight, place.width() + 0.5));
    x += width;
  }
}

}  // namespace

PrintBlock print_table(const FigureModel& table, int most) {
  std::vector<Row> rows = rows_of(table, most);
  std::vector<double> widths = widths_of(table, rows);
  const double wide = std::accumulate(widths.begin(), widths.end(), 0.0);
  const double scale = std::max(kLeastScale, PrintPages::kTextWidth / wide);
  for (double& width : widths) width *= PrintPages::kTextWidth / (scale * wide);
  const bool two_lines = std::any_of(rows[0].cells.begin(), rows[0].cells.end(),
                                     [](const Cell& cell) { return cell.text.contains('\n'); });
  const double head = (two_lines ? 1.7 : 1.0) * kRow;
  PrintBlock block;
  block.height = scale * (head + kRow * static_cast<double>(rows.size() - 1));
  block.gap = 8.0;
  block.paint = [rows = std::move(rows), widths = std::move(widths), head, scale](QPainter& painter,
                                                                                  const QRectF& where) {
    painter.save();
    painter.translate(where.topLeft());
    painter.scale(scale, scale);
    const double right = where.width() / scale;
    double y = 0.0;
    for (std::size_t r = 0; r < rows.size(); ++r) {
      const double height = r == 0 ? head : kRow;
      if (r == 1 || rows[r].sum) {
        painter.setPen(QPen(r == 1 ? theme().muted : theme().border, kLine));
        painter.drawLine(QPointF(0.0, y), QPointF(right, y));
      }
      painter.setFont(font_of(rows, r));
      paint_row(painter, rows[r], widths, QRectF(0.0, y, right, height), r == 0);
      y += height;
    }
    painter.restore();
  };
  return block;
}

}  // namespace carom
