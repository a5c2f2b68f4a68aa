#include "widgets/print/print_pages.h"

#include <QBuffer>
#include <QCoreApplication>
#include <QPageSize>
#include <QPdfWriter>
#include <algorithm>

#include "widgets/print/print_blocks.h"
#include "widgets/print/save_file.h"
#include "widgets/theme/theme.h"

namespace carom {
namespace {

constexpr double kFootLine = 30.0;  // px below the text

}  // namespace

PrintPages::PrintPages(std::vector<PrintBlock> blocks, const QString& footer)
    : blocks_(std::move(blocks)), footer_(footer) {
  place();
}

void PrintPages::place() {
  double used = 0.0;
  for (std::size_t first = 0; first < blocks_.size();) {
    // A block with the blocks that must follow on its page.
    std::size_t end = first;
    double height = 0.0;
    do {
      if (end > first) height += blocks_[end].gap;
      height += blocks_[end].height;
    } while (blocks_[end++].with_next && end < blocks_.size());
    if (pages_.empty() || used + blocks_[first].gap + height > kTextHeight) {
      pages_.emplace_back();
      used = 0.0;
    }
    for (; first < end; ++first) {
      if (used > 0.0) used += blocks_[first].gap;
      pages_.back().push_back({first, QRectF(kSide, kTop + used, kTextWidth, blocks_[first].height)});
      used += blocks_[first].height;
    }
  }
  for (std::vector<Placed>& page : pages_) {
    const auto growing =
        std::count_if(page.begin(), page.end(), [&](const Placed& p) { return blocks_[p.block].grows; });
    if (growing == 0) continue;
    const double more = (kTop + kTextHeight - page.back().where.bottom()) / static_cast<double>(growing);
    double down = 0.0;
    for (Placed& placed : page) {
      placed.where.translate(0.0, down);
      if (!blocks_[placed.block].grows) continue;
      placed.where.setHeight(placed.where.height() + more);
      down += more;
    }
  }
}

void PrintPages::paint(int page, QPainter& painter) const {
  painter.setRenderHints(QPainter::Antialiasing | QPainter::TextAntialiasing);
  for (const Placed& placed : pages_[static_cast<std::size_t>(page)]) {
    painter.save();
    blocks_[placed.block].paint(painter, placed.where);
    painter.restore();
  }
  const Theme& theme = light_theme();
  const QRectF foot(kSide, kTop + kTextHeight + kFootLine, kTextWidth, 16.0);
  painter.setPen(QPen(theme.border, 0.75));
  painter.drawLine(foot.topLeft() - QPointF(0.0, 6.0), foot.topRight() - QPointF(0.0, 6.0));
  painter.setPen(theme.muted);
  painter.setFont(print_font(10));
  const QString number = QCoreApplication::translate("PrintPages", "Page %1 of %2").arg(page + 1).arg(count());
  const double room = foot.width() - QFontMetricsF(painter.font()).horizontalAdvance(number) - 20.0;
  painter.drawText(foot, Qt::AlignLeft | Qt::AlignVCenter,
                   QFontMetricsF(painter.font()).elidedText(footer_, Qt::ElideRight, room));
  painter.drawText(foot, Qt::AlignRight | Qt::AlignVCenter, number);
}

bool PrintPages::save(const QString& path, const QString& title, QString* error) const {
  QBuffer buffer;
  buffer.open(QIODevice::WriteOnly);
  {
    constexpr int kUnitsPerInch = 1200;
    QPdfWriter writer(&buffer);
    writer.setTitle(title);
    writer.setCreator("Carom");
    writer.setResolution(kUnitsPerInch);
    writer.setPageSize(QPageSize(QPageSize::A4));
    writer.setPageMargins({});
    QPainter painter(&writer);
    painter.scale(kUnitsPerInch / kPixelsPerInch, kUnitsPerInch / kPixelsPerInch);
    for (int page = 0; page < count(); ++page) {
      if (page > 0) writer.newPage();
      paint(page, painter);
    }
  }
  return save_file(
      path, [&](OutputFile& file) { write_bytes(file, buffer.data()); }, error);
}

}  // namespace carom
