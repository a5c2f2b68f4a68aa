#pragma once

#include <QTableView>

namespace carom {

// A table whose first column and last rows can stay in sight: where the rest scrolls, it scrolls below them.
class KeptTable : public QTableView {
  Q_OBJECT

 public:
  explicit KeptTable(QWidget* parent = nullptr);

  [[nodiscard]] QModelIndex indexAt(const QPoint& at) const override;
  // Where the cell is seen, if it is kept.
  [[nodiscard]] QRect visualRect(const QModelIndex& index) const override;
  void scrollTo(const QModelIndex& index, ScrollHint hint = EnsureVisible) override;

 protected:
  [[nodiscard]] virtual bool wants_first_column() const = 0;
  [[nodiscard]] virtual int wanted_rows() const = 0;  // of the last ones

  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void scrollContentsBy(int dx, int dy) override;
  void selectionChanged(const QItemSelection& selected, const QItemSelection& deselected) override;

 private:
  friend class KeptHeader;
  // px that the kept column covers; 0 where it stands in its own place.
  [[nodiscard]] int covered_left() const;
  // The first of the rows that are kept out of their own place, and px where they begin.
  [[nodiscard]] int first_kept() const;
  [[nodiscard]] int kept_top() const;
  void paint_cell(QPainter& painter, const QModelIndex& index) const;

  bool marks_rest_ = false;  // the button is down, and went down above the kept rows
};

}  // namespace carom
