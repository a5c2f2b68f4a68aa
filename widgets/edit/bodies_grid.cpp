#include "widgets/edit/bodies_grid.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QHeaderView>
#include <QKeyEvent>
#include <QMenu>
#include <QResizeEvent>
#include <algorithm>
#include <map>
#include <set>

#include "widgets/base/plain_text.h"
#include "widgets/edit/cell_delegate.h"
#include "widgets/edit/cell_field.h"

namespace carom {
namespace {

// Keys that begin to type. Space plays.
bool types(const QKeyEvent& key) {
  const bool command = (key.modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier)) != 0;
  return !command && !key.text().isEmpty() && key.text()[0].isPrint() && key.key() != Qt::Key_Space;
}

// The cells of a spreadsheet's text; the headings of this table are no values.
std::vector<QStringList> pasted_lines(QString text, const QAbstractItemModel& rows) {
  std::vector<QStringList> lines;
  while (text.endsWith('\n') || text.endsWith('\r')) text.chop(1);
  for (QString line : text.split('\n')) {
    if (line.endsWith('\r')) line.chop(1);
    lines.push_back(line.split('\t'));
  }
  const QString head = rows.headerData(0, Qt::Horizontal, Qt::DisplayRole).toString();
  if (lines.size() > 1 && lines.front().front() == head) lines.erase(lines.begin());
  return lines;
}

// Bodies and surfaces with values that are pasted one after the other.
struct Pasted {
  std::vector<Body> bodies;
  std::set<int> changed{};  // rows
  std::map<std::string, SceneEdits> surfaces{};
  std::vector<std::pair<int, int>> taken{};  // cells
  BodiesModel::Faults faults{};

  void put(const BodiesModel& rows, int row, int column, const QString& text) {
    // The word of a fixed body comes back as it was copied.
    if (text.trimmed().isEmpty() || text == spreadsheet_text(rows.cell(row, column))) return;
    const QString why_not = rows.why_not(row, column);
    const TypedCell typed =
        why_not.isEmpty() ? typed_cell(*rows.surfaces(), bodies, row, column, text) : TypedCell{{}, why_not};
    if (!typed.fault.isEmpty()) faults[{row, column}] = typed.fault;
    if (typed.made.edits.empty()) return;
    Body& body = bodies[static_cast<std::size_t>(row)];
    if (column == BodiesModel::kRestitution) {
      surfaces[body.material] = typed.made.edits;  // of bodies that share it the last one
    } else {
      body = std::get<Replace<Body>>(typed.made.edits.front()).part;
      changed.insert(row);
    }
    taken.emplace_back(row, column);
  }
  [[nodiscard]] SceneEdits edits() const {
    SceneEdits all;
    for (const int each : changed) all.emplace_back(Replace<Body>{bodies[static_cast<std::size_t>(each)]});
    for (const auto& [name, made] : surfaces) all.insert(all.end(), made.begin(), made.end());
    return all;
  }
};

}  // namespace

BodiesGrid::BodiesGrid(QWidget* parent)
    : FigureTable(new BodiesModel, tr("Bodies"), parent),
      rows_(static_cast<BodiesModel*>(model())),
      value_(new PlainLabel(viewport())) {
  setItemDelegate(new CellDelegate(this));
  setSelectionBehavior(QAbstractItemView::SelectItems);
  setSelectionMode(QAbstractItemView::ContiguousSelection);
  setEditTriggers(DoubleClicked | EditKeyPressed | AnyKeyPressed);
  value_->setObjectName("bubble");
  value_->setContentsMargins(6, 2, 6, 2);
  value_->hide();
  make_columns_menu();
}

// --- the columns
// -----------------------------------------------------------------------------------------------------------

void BodiesGrid::make_columns_menu() {
  columns_menu_ = new QMenu(this);
  for (std::size_t i = 0; i < column_choices().size(); ++i) {
    const ColumnChoice& choice = column_choices()[i];
    QAction* action = columns_menu_->addAction(tr(choice.text));
    action->setCheckable(true);
    action->setChecked(choice.usual);
    show_column(i, choice.usual);
    connect(action, &QAction::toggled, this, [this, i](bool shown) { show_column(i, shown); });
  }
  horizontalHeader()->setContextMenuPolicy(Qt::CustomContextMenu);
  connect(horizontalHeader(), &QWidget::customContextMenuRequested, this,
          [this](const QPoint& at) { columns_menu_->popup(horizontalHeader()->mapToGlobal(at)); });
}

void BodiesGrid::show_column(std::size_t choice, bool shown) {
  for (const int column : column_choices()[choice].columns) setColumnHidden(column, !shown);
  // The shown ones share the width anew.
  QResizeEvent same(size(), size());
  resizeEvent(&same);
}

QStringList BodiesGrid::shown_columns() const {
  QStringList ids;
  for (std::size_t i = 0; i < column_choices().size(); ++i) {
    if (columns_menu_->actions()[static_cast<qsizetype>(i)]->isChecked()) ids << column_choices()[i].id;
  }
  return ids;
}

void BodiesGrid::show_columns(const QStringList& ids) {
  for (std::size_t i = 0; i < column_choices().size(); ++i)
    columns_menu_->actions()[static_cast<qsizetype>(i)]->setChecked(ids.contains(column_choices()[i].id));
}

void BodiesGrid::set_theme(const Theme& theme) {
  theme_ = theme;
  viewport()->update();
}

// --- what is shown
// -----------------------------------------------------------------------------------------------------------

void BodiesGrid::show(const std::shared_ptr<const Scene>& scene, const std::shared_ptr<const Frame>& frame) {
  const bool could_edit = rows_->can_edit();
  rows_->show(scene, frame);
  if (says_why_not_ && could_edit != rows_->can_edit()) {
    if (currentIndex().isValid()) {
      say_why_not(currentIndex());
    } else {
      say({});
    }
  }
  if (field_ == nullptr) return;
  const int row = currentIndex().row();
  const bool same =
      row >= 0 && row < rows_->shown_bodies() && rows_->bodies()[static_cast<std::size_t>(row)].id == edited_;
  if (same && rows_->can_edit()) return;
  field_->restore();
  end(field_);
}

void BodiesGrid::show_selection(const std::vector<std::string>& names) {
  rows_->mark(names);
  if (names == selection_) return;
  selection_ = names;
  if (field_ != nullptr || names_of_marked_cells() == names) return;
  shows_selection_ = true;
  clearSelection();
  for (int row = 0; row < rows_->shown_bodies() && !names.empty(); ++row) {
    if (!rows_->is_marked(row)) continue;
    const QModelIndex index = rows_->index(row, std::max(currentIndex().column(), 0));
    if (!rows_->is_marked(std::max(currentIndex().row(), 0)) || !currentIndex().isValid())
      selectionModel()->setCurrentIndex(index, QItemSelectionModel::NoUpdate);
    scrollTo(index);
    break;
  }
  shows_selection_ = false;
}

std::vector<std::string> BodiesGrid::names_of_marked_cells() const {
  std::set<int> marked;
  for (const QItemSelectionRange& range : selectionModel()->selection()) {
    for (int row = range.top(); row <= range.bottom(); ++row) marked.insert(row);
  }
  std::vector<std::string> names;
  for (const int row : marked) {
    if (!rows_->is_sum(row)) names.push_back(rows_->bodies()[static_cast<std::size_t>(row)].name);
  }
  return names;
}

void BodiesGrid::selectionChanged(const QItemSelection& selected, const QItemSelection& deselected) {
  FigureTable::selectionChanged(selected, deselected);
  if (shows_selection_) return;
  const std::vector<std::string> names = names_of_marked_cells();
  if (names.empty() || names == selection_) return;
  selection_ = names;
  emit chosen(names);
}

void BodiesGrid::currentChanged(const QModelIndex& current, const QModelIndex& previous) {
  FigureTable::currentChanged(current, previous);
  if (current.isValid() && !shows_selection_ && field_ == nullptr) say_why_not(current);
}

void BodiesGrid::say_why_not(const QModelIndex& index) {
  const QString* fault = rows_->fault(index.row(), index.column());
  const QString why = fault != nullptr ? *fault : rows_->why_not(index.row(), index.column());
  if (why.isEmpty() && !says_why_not_) return;  // what else was said stays
  say(why);
  says_why_not_ = !why.isEmpty();
}

void BodiesGrid::say(const QString& sentence) {
  says_why_not_ = false;
  emit said(sentence);
}

// --- typing
// -----------------------------------------------------------------------------------------------------------

bool BodiesGrid::can_edit(const QModelIndex& index) const {
  return index.isValid() && index.flags().testFlag(Qt::ItemIsEditable);
}

bool BodiesGrid::edit(const QModelIndex& index, EditTrigger trigger, QEvent* event) {
  if (!index.isValid()) return false;
  const bool asked = trigger == DoubleClicked || trigger == EditKeyPressed || trigger == AnyKeyPressed;
  if (asked && !can_edit(index)) say_why_not(index);
  return FigureTable::edit(index, trigger, event);
}

void BodiesGrid::begin(CellField* field, int row, int column) {
  field_ = field;
  edited_ = rows_->bodies()[static_cast<std::size_t>(row)].id;
  if (BodiesModel::is_of_motion(column))
    connect(field, &QLineEdit::textEdited, this, &BodiesGrid::pauseRequested);
  connect(field, &TypedField::refused, this, &BodiesGrid::say);
  connect(field, &TypedField::dropped, this, &BodiesGrid::say);
  connect(field, &TypedField::valued, this, [this, field](const QString& text) { show_value(*field, text); });
  connect(field, &CellField::left, this, [this, field] { end(field); });
}

QString BodiesGrid::value_of(int row, int column, const QString& text) const {
  return rows_->can_edit() ? value_of_cell(*rows_->surfaces(), rows_->bodies(), row, column, text) : QString();
}

// Under the field, or over it where there is no room.
void BodiesGrid::show_value(const QWidget& field, const QString& text) {
  constexpr int kGap = 2;  // px
  value_->setText(text);
  value_->setVisible(!text.isEmpty());
  value_->adjustSize();
  const QRect at = field.geometry();
  const int under = at.bottom() + kGap;
  const bool fits = under + value_->height() <= viewport()->height();
  const int left = std::min(at.left(), viewport()->width() - value_->width());
  value_->move(std::max(left, 0), fits ? under : at.top() - kGap - value_->height());
  value_->raise();
}

void BodiesGrid::end(CellField* field) {
  if (field == nullptr || field_ != field) return;
  field_ = nullptr;
  value_->hide();
  const bool had_focus = field->hasFocus();
  closeEditor(field, QAbstractItemDelegate::NoHint);
  if (had_focus) setFocus();
}

QString BodiesGrid::take(int row, int column, const QString& text) {
  if (!rows_->can_edit()) return tr("Nothing can be edited at this moment.");
  const TypedCell typed = typed_cell(*rows_->surfaces(), rows_->bodies(), row, column, text);
  return typed.made.edits.empty() ? typed.fault : hand_out(typed.made.edits, typed.made.name);
}

QString BodiesGrid::hand_out(const SceneEdits& edits, const QString& name) {
  rows_->set_faults({});
  say({});
  refusal_.clear();
  hands_out_ = true;
  emit edited(edits, name);
  hands_out_ = false;
  return refusal_;
}

void BodiesGrid::refuse(const QString& sentence) {
  if (hands_out_) {
    refusal_ = sentence;
  } else {
    say(sentence);
  }
}

bool BodiesGrid::go_down(int rows) {
  const QModelIndex next = currentIndex().siblingAtRow(currentIndex().row() + rows);
  if (!next.isValid() || rows_->is_sum(next.row())) return false;
  setCurrentIndex(next);
  return true;
}

bool BodiesGrid::go_right(int columns) {
  QModelIndex next = currentIndex();
  do {
    next = next.siblingAtColumn(next.column() + columns);
  } while (next.isValid() && !can_edit(next));
  if (next.isValid()) setCurrentIndex(next);
  return next.isValid();
}

void BodiesGrid::go_on(bool right) { focusNextPrevChild(right); }

bool BodiesGrid::focusNextPrevChild(bool next) {
  if (hasFocus() && currentIndex().isValid() && go_right(next ? 1 : -1)) return true;
  return FigureTable::focusNextPrevChild(next);
}

bool BodiesGrid::event(QEvent* event) {
  if (event->type() != QEvent::ShortcutOverride) return FigureTable::event(event);
  const auto* key = static_cast<QKeyEvent*>(event);
  // What is typed at a cell is no key of the window, also where it can't be taken; but no number begins with a
  // letter.
  if (!key->matches(QKeySequence::Paste) && !(types(*key) && rows_->can_edit() && begins_cell(*key)))
    return FigureTable::event(event);
  event->accept();
  return true;
}

bool BodiesGrid::begins_cell(const QKeyEvent& key) const {
  const QModelIndex cell = currentIndex();
  return cell.isValid() && (rows_->is_text(cell.column()) || !key.text()[0].isLetter());
}

void BodiesGrid::keyPressEvent(QKeyEvent* event) {
  if (event->matches(QKeySequence::Paste)) {
    paste();
  } else if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) {
    edit(currentIndex(), EditKeyPressed, event);
  } else if (types(*event) && !begins_cell(*event)) {
    event->ignore();
  } else {
    if (event->key() == Qt::Key_Escape) {
      rows_->set_faults({});
      say({});
    }
    FigureTable::keyPressEvent(event);
  }
}

// --- the clipboard
// -----------------------------------------------------------------------------------------------------------

QString BodiesGrid::copied() const {
  const QItemSelection marked = selectionModel()->selection();
  if (marked.isEmpty()) return text();
  const QItemSelectionRange& range = marked.front();
  QStringList lines;
  for (int row = range.top(); row <= range.bottom(); ++row) {
    QStringList cells;
    for (int column = range.left(); column <= range.right(); ++column) {
      if (!isColumnHidden(column)) cells << spreadsheet_text(rows_->cell(row, column));
    }
    lines << cells.join('\t');
  }
  return lines.join('\n');
}

void BodiesGrid::paste() {
  const QItemSelection marked = selectionModel()->selection();
  const QModelIndex from = marked.isEmpty() ? currentIndex() : QModelIndex(marked.front().topLeft());
  if (!from.isValid()) return;
  if (!rows_->can_edit()) return say(tr("Nothing can be edited at this moment."));
  Pasted pasted{.bodies = rows_->bodies()};
  int row = from.row();
  int without_body = 0;  // rows
  for (const QStringList& line : pasted_lines(QGuiApplication::clipboard()->text(), *rows_)) {
    if (row >= rows_->shown_bodies()) {
      // The row of the sums comes back with what it sums.
      const int last = rows_->rowCount() - 1;
      if (line.front() != rows_->index(last, from.column()).data().toString()) ++without_body;
      continue;
    }
    int column = from.column();
    for (const QString& cell : line) {
      while (column < rows_->columnCount() && isColumnHidden(column)) ++column;
      if (column >= rows_->columnCount()) break;
      // What follows from others comes back with them.
      if (!BodiesModel::follows(column) || column == from.column()) pasted.put(*rows_, row, column, cell);
      ++column;
    }
    ++row;
  }
  const SceneEdits edits = pasted.edits();
  const std::size_t values = pasted.taken.size();
  QString refusal;
  if (!edits.empty())
    refusal = hand_out(edits, values == 1 ? tr("Paste 1 value") : tr("Paste %1 values").arg(values));
  for (const auto& cell : pasted.taken) {
    if (!refusal.isEmpty()) pasted.faults[cell] = refusal;
  }
  if (pasted.faults.empty()) {
    if (without_body > 0)
      say(without_body == 1 ? tr("1 row had no body to go to.")
                            : tr("%1 rows had no body to go to.").arg(without_body));
    return;
  }
  const auto& [place, first] = *pasted.faults.begin();
  const std::size_t count = pasted.faults.size();
  rows_->set_faults(pasted.faults);
  scrollTo(rows_->index(place.first, place.second));
  say(count == 1 ? first : tr("%1 values can't be, the first because: %2").arg(count).arg(first));
}

}  // namespace carom
