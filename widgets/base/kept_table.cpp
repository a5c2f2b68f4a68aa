#include "widgets/base/kept_table.h"

#include <QHeaderView>
#include <QMouseEvent>
#include <QPaintEvent>
#include <QPainter>
#include <QScrollBar>
#include <algorithm>
#include <utility>

namespace carom {

// The heading of the kept column stays over it.
class KeptHeader : public QHeaderView {
 public:
  explicit KeptHeader(KeptTable* table) : QHeaderView(Qt::Horizontal, table), table_(table) {
    setSectionsClickable(true);
  }

 protected:
  void paintEvent(QPaintEvent* event) override {
    QHeaderView::paintEvent(event);
    const int width = table_->covered_left();
    if (width == 0) return;
    QPainter painter(viewport());
    const QRect place(0, 0, width, height());
    painter.fillRect(place, palette().brush(QPalette::Base));
    paintSection(&painter, place, 0);
  }
  // What is seen there is pressed, not what has been scrolled below it.
  void mousePressEvent(QMouseEvent* event) override {
    on_kept_ = event->position().x() < table_->covered_left();
    if (!on_kept_) return QHeaderView::mousePressEvent(event);
    if (event->button() == Qt::LeftButton) emit sectionPressed(0);
  }
  void mouseMoveEvent(QMouseEvent* event) override {
    if (!on_kept_) QHeaderView::mouseMoveEvent(event);
  }
  void mouseReleaseEvent(QMouseEvent* event) override {
    if (!std::exchange(on_kept_, false)) return QHeaderView::mouseReleaseEvent(event);
    if (event->button() == Qt::LeftButton) emit sectionClicked(0);
  }

 private:
  KeptTable* table_;
  bool on_kept_ = false;  // the button is down
};

KeptTable::KeptTable(QWidget* parent) : QTableView(parent) { setHorizontalHeader(new KeptHeader(this)); }

// A column that takes half of the table scrolls as the others do.
int KeptTable::covered_left() const {
  const bool kept = model() != nullptr && wants_first_column() && horizontalHeader()->offset() > 0 &&
                    2 * columnWidth(0) <= viewport()->width();
  return kept ? columnWidth(0) : 0;
}

// Rows that leave no room for another one scroll as these do.
int KeptTable::first_kept() const {
  const int rows = model() == nullptr ? 0 : model()->rowCount();
  if (rows == 0) return 0;
  const int wanted = std::min(wanted_rows(), rows);
  const int height = verticalHeader()->defaultSectionSize();
  const bool out_of_sight = rowViewportPosition(rows - 1) + height > viewport()->height();
  return out_of_sight && (wanted + 1) * height <= viewport()->height() ? rows - wanted : rows;
}

int KeptTable::kept_top() const {
  const int rows = model() == nullptr ? 0 : model()->rowCount();
  return viewport()->height() - (rows - first_kept()) * verticalHeader()->defaultSectionSize();
}

void KeptTable::mousePressEvent(QMouseEvent* event) {
  marks_rest_ = event->position().y() < kept_top();
  QTableView::mousePressEvent(event);
}

void KeptTable::mouseReleaseEvent(QMouseEvent* event) {
  QTableView::mouseReleaseEvent(event);
  marks_rest_ = false;
}

QModelIndex KeptTable::indexAt(const QPoint& at) const {
  // What is marked from above the kept rows on ends above them, as the rest scrolls there.
  if (marks_rest_ && at.y() >= kept_top()) return indexAt({at.x(), kept_top() - 1});
  const QModelIndex below = QTableView::indexAt(at);
  if (model() == nullptr) return below;
  int row = below.isValid() ? below.row() : rowAt(at.y());
  int column = below.isValid() ? below.column() : columnAt(at.x());
  if (at.x() >= 0 && at.x() < covered_left()) column = 0;
  if (at.y() >= kept_top() && first_kept() < model()->rowCount())
    row = first_kept() + (at.y() - kept_top()) / verticalHeader()->defaultSectionSize();
  return row < 0 || column < 0 ? QModelIndex() : model()->index(row, column);
}

QRect KeptTable::visualRect(const QModelIndex& index) const {
  QRect rect = QTableView::visualRect(index);
  if (!rect.isValid()) return rect;
  if (index.column() == 0 && covered_left() > 0) rect.moveLeft(0);
  if (index.row() >= first_kept())
    rect.moveTop(kept_top() + (index.row() - first_kept()) * verticalHeader()->defaultSectionSize());
  return rect;
}

// Out from below what is kept; what is kept is in sight already.
void KeptTable::scrollTo(const QModelIndex& index, ScrollHint hint) {
  const int x = horizontalScrollBar()->value();
  const int y = verticalScrollBar()->value();
  const bool kept_column = index.column() == 0 && covered_left() > 0;
  const bool kept_row = index.isValid() && index.row() >= first_kept();
  QTableView::scrollTo(index, hint);
  if (!index.isValid()) return;
  const QRect rect = QTableView::visualRect(index);
  if (kept_column) {
    horizontalScrollBar()->setValue(x);
  } else if (index.column() > 0 && rect.left() < covered_left()) {
    horizontalScrollBar()->setValue(horizontalScrollBar()->value() + rect.left() - covered_left());
  }
  if (kept_row) {
    verticalScrollBar()->setValue(y);
  } else if (rect.bottom() >= kept_top()) {
    verticalScrollBar()->setValue(verticalScrollBar()->value() + rect.bottom() + 1 - kept_top());
  }
}

void KeptTable::paint_cell(QPainter& painter, const QModelIndex& index) const {
  QStyleOptionViewItem option;
  initViewItemOption(&option);
  option.rect = visualRect(index);
  if (selectionModel()->isSelected(index)) option.state |= QStyle::State_Selected;
  if (index == currentIndex() && hasFocus()) option.state |= QStyle::State_HasFocus;
  painter.fillRect(option.rect, option.palette.brush(QPalette::Base));
  itemDelegateForIndex(index)->paint(&painter, option, index);
}

void KeptTable::paintEvent(QPaintEvent* event) {
  QTableView::paintEvent(event);
  if (model() == nullptr) return;
  QPainter painter(viewport());
  const int rows = model()->rowCount();
  const int first = first_kept();
  const bool column = covered_left() > 0;
  const int last = rowAt(kept_top() - 1) < 0 ? rows - 1 : rowAt(kept_top() - 1);
  for (int row = std::max(rowAt(0), 0); column && row <= std::min(last, first - 1); ++row)
    paint_cell(painter, model()->index(row, 0));
  if (first < rows)
    painter.fillRect(viewport()->rect().adjusted(0, kept_top(), 0, 0), palette().brush(QPalette::Base));
  for (int row = first; row < rows; ++row) {
    for (int c = model()->columnCount() - 1; c >= 0; --c) {
      if (!isColumnHidden(c)) paint_cell(painter, model()->index(row, c));
    }
  }
  if (!column) return;
  painter.setPen(palette().color(QPalette::Mid));
  painter.drawLine(covered_left() - 1, 0, covered_left() - 1, viewport()->height());
}

// Nothing is moved on the screen: what is kept stays.
void KeptTable::scrollContentsBy(int dx, int dy) {
  QTableView::scrollContentsBy(dx, dy);
  viewport()->update();
  horizontalHeader()->viewport()->update();
}

void KeptTable::selectionChanged(const QItemSelection& selected, const QItemSelection& deselected) {
  QTableView::selectionChanged(selected, deselected);
  viewport()->update();
}

}  // namespace carom
