#pragma once

#include <QAbstractTableModel>
#include <QStyledItemDelegate>
#include <variant>
#include <vector>

#include "physics/scene/scene.h"
#include "widgets/base/kept_table.h"

namespace carom {

// Rows of figures: headings have the units, figures are right-aligned, tooltips show all digits. The text of a
// cell is made when it is painted, so an update costs only the visible cells.
class FigureModel : public QAbstractTableModel {
 public:
  struct Column {
    const char* heading;  // UTF-8, of one line or two
    int weight;           // share of the width
    bool text = false;    // left-aligned
    int digits = 4;       // significant digits of a figure, at most
  };
  using Cell = std::variant<std::monostate, QString, double, Vec2>;

  FigureModel(std::vector<Column> columns, QObject* parent);

  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
  [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
  [[nodiscard]] QString heading(int column) const;  // in one line
  // Whether headings of two lines stand in two, or in one.
  void break_headings(bool broken);
  [[nodiscard]] int weight(int column) const { return columns_[static_cast<std::size_t>(column)].weight; }
  [[nodiscard]] bool is_text(int column) const { return columns_[static_cast<std::size_t>(column)].text; }

  [[nodiscard]] virtual Cell cell(int row, int column) const = 0;
  [[nodiscard]] virtual bool is_sum(int row) const = 0;                                    // bold, under a line
  [[nodiscard]] virtual bool is_idle(int /*row*/, int /*column*/) const { return false; }  // pale
  // Description of the cell, for its tooltip.
  [[nodiscard]] virtual QString tip(int /*row*/, int /*column*/) const { return {}; }

 protected:
  // Not those that are about to go: views may ask for them until then.
  [[nodiscard]] bool knows(int row) const { return row < known_rows_; }
  // Reports that all rows may have changed, and that there are now `rows`.
  void rows_changed(int rows);
  // Other columns, and no rows until rows_changed().
  void set_columns(std::vector<Column> columns);

 private:
  std::vector<Column> columns_;
  bool broken_ = true;
  int rows_ = 0;
  int known_rows_ = 0;  // other than rows_ while rows come or go
};

// Aligns text with the headings, draws no frame around the current cell, and a line above a sum.
class FigureDelegate : public QStyledItemDelegate {
 public:
  using QStyledItemDelegate::QStyledItemDelegate;
  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;

 protected:
  // What is under the text: the ground of a selected cell.
  virtual void paint_ground(QPainter* painter, const QStyleOptionViewItem& option,
                            const QModelIndex& index) const;
};

// The cell for spreadsheets: every digit, and `separator` between the components of a vector.
[[nodiscard]] QString spreadsheet_text(const FigureModel::Cell& cell, char separator = '\t');

// A plain table that divides its width among the columns. Where it has to scroll, names in the first column and
// sums in the last rows stay in sight. Ctrl+C, or a right click, copies it; a right click saves it too.
class FigureTable : public KeptTable {
  Q_OBJECT

 public:
  FigureTable(FigureModel* model, const QString& name, QWidget* parent);

  // Text for spreadsheets: tabs between the cells, every digit, two cells for a vector.
  [[nodiscard]] QString text() const { return text('\t'); }
  // The same for a CSV file.
  [[nodiscard]] QString csv() const { return text(','); }

 signals:
  void saveAsked();  // as a CSV file

 protected:
  // What Ctrl+C copies.
  [[nodiscard]] virtual QString copied() const { return text(); }
  [[nodiscard]] bool wants_first_column() const override { return model_->is_text(0); }
  [[nodiscard]] int wanted_rows() const override;
  bool event(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void contextMenuEvent(QContextMenuEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  [[nodiscard]] QString text(char separator) const;
  [[nodiscard]] int least_width(int column) const;
  [[nodiscard]] int least_width() const;  // px, of all columns
  void share_width();
  void fit_rows();

  FigureModel* model_;
};

}  // namespace carom
