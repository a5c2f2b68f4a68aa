#include "widgets/edit/cell_delegate.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QKeyEvent>
#include <QPainter>

#include "widgets/edit/bodies_grid.h"
#include "widgets/edit/cell_field.h"

namespace carom {
namespace {

// Whether this key would put the text of several cells into one.
bool pastes_cells(const QKeyEvent& key) {
  if (!key.matches(QKeySequence::Paste)) return false;
  const QString text = QGuiApplication::clipboard()->text().trimmed();
  return text.contains('\t') || text.contains('\n');
}

}  // namespace

CellDelegate::CellDelegate(BodiesGrid* grid) : FigureDelegate(grid), grid_(grid) {}

QWidget* CellDelegate::createEditor(QWidget* parent, const QStyleOptionViewItem& /*option*/,
                                    const QModelIndex& index) const {
  const int row = index.row();
  const int column = index.column();
  auto* field = new CellField(
      [grid = grid_, row, column](const QString& text) { return grid->take(row, column, text); },
      [grid = grid_, row, column](const QString& text) { return grid->value_of(row, column, text); }, parent);
  field->setAccessibleName(index.data(Qt::AccessibleTextRole).toString());
  if (column != BodiesModel::kBody) field->setAlignment(Qt::AlignRight);
  grid_->begin(field, row, column);
  return field;
}

void CellDelegate::setEditorData(QWidget* editor, const QModelIndex& index) const {
  static_cast<CellField*>(editor)->show_text(grid_->rows().full_text(index.row(), index.column()));
}

void CellDelegate::updateEditorGeometry(QWidget* editor, const QStyleOptionViewItem& option,
                                        const QModelIndex& /*index*/) const {
  editor->setGeometry(option.rect.adjusted(1, 1, -1, -1));
}

bool CellDelegate::eventFilter(QObject* editor, QEvent* event) {
  if (event->type() != QEvent::KeyPress && event->type() != QEvent::ShortcutOverride) return false;
  const int key = static_cast<QKeyEvent*>(event)->key();
  const bool cells = pastes_cells(*static_cast<QKeyEvent*>(event));
  const bool enter = key == Qt::Key_Return || key == Qt::Key_Enter;
  const bool tab = key == Qt::Key_Tab || key == Qt::Key_Backtab;
  if (!enter && !tab && !cells && key != Qt::Key_Escape) return false;
  event->accept();
  if (event->type() == QEvent::ShortcutOverride) return true;
  auto* field = static_cast<CellField*>(editor);
  if (key == Qt::Key_Escape || cells) {
    field->restore();
    grid_->end(field);
    if (cells) grid_->paste();
  } else if (field->accept_typed()) {
    grid_->end(field);
    if (tab) grid_->go_on(key == Qt::Key_Tab);
    if (enter) grid_->go_down(static_cast<QKeyEvent*>(event)->modifiers().testFlag(Qt::ShiftModifier) ? -1 : 1);
  }
  return true;
}

void CellDelegate::paint_ground(QPainter* painter, const QStyleOptionViewItem& option,
                                const QModelIndex& index) const {
  constexpr int kBar = 3;          // px, before the name of a selected body
  constexpr double kRounding = 4;  // px
  const Theme& theme = grid_->theme();
  const BodiesModel& rows = grid_->rows();
  if (rows.is_marked(index.row())) {
    painter->fillRect(option.rect, theme.accent_ground);
    if (index.column() == 0)
      painter->fillRect(QRect(option.rect.topLeft(), QSize(kBar, option.rect.height())), theme.accent);
  }
  const bool boxed = index.flags().testFlag(Qt::ItemIsEditable);
  const bool current = option.state.testFlag(QStyle::State_HasFocus);
  const bool marked = option.state.testFlag(QStyle::State_Selected);
  const bool wrong = rows.fault(index.row(), index.column()) != nullptr;
  const bool changed = rows.is_changed(index.row(), index.column());
  if (!boxed && !current && !marked && !wrong) return;
  painter->save();
  painter->setRenderHint(QPainter::Antialiasing);
  const QColor line = wrong ? theme.danger : current || marked || changed ? theme.accent : theme.border;
  painter->setPen(QPen(line, current || changed ? 2.0 : 1.0));
  painter->setBrush(boxed ? QBrush(theme.window) : QBrush(Qt::NoBrush));
  painter->drawRoundedRect(QRectF(option.rect).adjusted(4.5, 2.5, -2.5, -2.5), kRounding, kRounding);
  painter->restore();
}

}  // namespace carom
