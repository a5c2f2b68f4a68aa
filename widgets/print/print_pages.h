#pragma once

#include <QPainter>
#include <QRectF>
#include <QString>
#include <functional>
#include <vector>

namespace carom {

// A piece of a printed page, as wide as its text: px of 1/96 inch.
struct PrintBlock {
  double height = 0.0;
  double gap = 0.0;        // above it, except at the top of a page
  bool with_next = false;  // never the last on its page, like a heading
  bool grows = false;      // shares the rest of the page with other such blocks
  std::function<void(QPainter& painter, const QRectF& where)> paint;
};

// Places blocks on portrait A4 pages, one below the other, undivided, with a footer: `footer` at the left, the
// page's number at the right.
class PrintPages {
 public:
  static constexpr double kPixelsPerInch = 96.0;
  static constexpr double kWidth = 8.27 * kPixelsPerInch;  // px
  static constexpr double kHeight = 11.69 * kPixelsPerInch;
  static constexpr double kSide = 72.0;    // left and right of the text
  static constexpr double kTop = 64.0;     // above it
  static constexpr double kBottom = 76.0;  // below it, with the footer
  static constexpr double kTextWidth = kWidth - 2.0 * kSide;
  static constexpr double kTextHeight = kHeight - kTop - kBottom;

  PrintPages(std::vector<PrintBlock> blocks, const QString& footer);

  [[nodiscard]] int count() const { return static_cast<int>(pages_.size()); }
  // Paints a page with a painter scaled to px.
  void paint(int page, QPainter& painter) const;
  // Saves a PDF. The file is replaced only when it is complete; otherwise returns false with the reason in
  // `error`.
  [[nodiscard]] bool save(const QString& path, const QString& title, QString* error) const;

 private:
  struct Placed {
    std::size_t block;
    QRectF where;
  };
  void place();

  std::vector<PrintBlock> blocks_;
  QString footer_;
  std::vector<std::vector<Placed>> pages_;
};

}  // namespace carom
