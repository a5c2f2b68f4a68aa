#pragma once

#include "widgets/base/figure_table.h"

namespace carom {

class BodiesGrid;

// Paints the cells that can be edited as boxes, and edits them.
class CellDelegate : public FigureDelegate {
  Q_OBJECT

 public:
  explicit CellDelegate(BodiesGrid* grid);

  QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem& option,
                        const QModelIndex& index) const override;
  void setEditorData(QWidget* editor, const QModelIndex& index) const override;
  // The editor hands its text to the grid itself.
  void setModelData(QWidget* /*editor*/, QAbstractItemModel* /*model*/,
                    const QModelIndex& /*index*/) const override {}
  void updateEditorGeometry(QWidget* editor, const QStyleOptionViewItem& option,
                            const QModelIndex& index) const override;

 protected:
  bool eventFilter(QObject* editor, QEvent* event) override;
  void paint_ground(QPainter* painter, const QStyleOptionViewItem& option,
                    const QModelIndex& index) const override;

 private:
  BodiesGrid* grid_;
};

}  // namespace carom
