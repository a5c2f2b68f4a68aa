#include "widgets/base/figure_table.h"

#include <QClipboard>
#include <QContextMenuEvent>
#include <QGuiApplication>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLocale>
#include <QMenu>
#include <QMetaMethod>
#include <QPainter>
#include <QTimer>
#include <algorithm>

#include "physics/files/csv.h"
#include "widgets/base/number_text.h"
#include "widgets/base/plain_text.h"

namespace carom {
namespace {

constexpr int kRowHeight = 22;       // px
constexpr int kLeastRowHeight = 20;  // px: of rows that scroll
constexpr int kInset = 5;            // px, of a cell's text

// In quotes where the table needs them.
QString quoted(const QString& text, char separator) {
  return QString::fromStdString(csv_text(text.toStdString(), separator));
}

}  // namespace

void FigureDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                           const QModelIndex& index) const {
  paint_ground(painter, option, index);
  QStyleOptionViewItem cell = option;
  cell.state &= ~(QStyle::State_HasFocus | QStyle::State_Selected);
  cell.rect.adjust(kInset, 0, -kInset, 0);
  const auto* model = static_cast<const FigureModel*>(index.model());
  if (model->is_idle(index.row(), index.column())) {
    cell.palette.setBrush(QPalette::Text, cell.palette.brush(QPalette::PlaceholderText));
  }
  QStyledItemDelegate::paint(painter, cell, index);
  if (!model->is_sum(index.row())) return;
  painter->setPen(option.palette.color(QPalette::Mid));
  painter->drawLine(option.rect.topLeft(), option.rect.topRight());
}

void FigureDelegate::paint_ground(QPainter* painter, const QStyleOptionViewItem& option,
                                  const QModelIndex& /*index*/) const {
  if (option.state & QStyle::State_Selected) painter->fillRect(option.rect, option.palette.highlight());
}

FigureModel::FigureModel(std::vector<Column> columns, QObject* parent)
    : QAbstractTableModel(parent), columns_(std::move(columns)) {}

int FigureModel::rowCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : rows_; }

int FigureModel::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(columns_.size());
}

QVariant FigureModel::data(const QModelIndex& index, int role) const {
  if (!knows(index.row())) return {};
  switch (role) {
    case Qt::DisplayRole: {
      const Cell content = cell(index.row(), index.column());
      if (const auto* text = std::get_if<QString>(&content)) return *text;
      if (const auto* value = std::get_if<double>(&content))
        return figure(*value, columns_[static_cast<std::size_t>(index.column())].digits);
      if (const auto* vector = std::get_if<Vec2>(&content)) return figures(*vector);
      return {};
    }
    case Qt::ToolTipRole: {
      const Cell content = cell(index.row(), index.column());
      const QString about = tip(index.row(), index.column());
      const QString below = about.isEmpty() ? about : "\n" + about;
      if (const auto* text = std::get_if<QString>(&content)) return plain_tip(about.isEmpty() ? *text : about);
      if (const auto* value = std::get_if<double>(&content)) return plain_tip(full_figure(*value) + below);
      if (const auto* vector = std::get_if<Vec2>(&content)) {
        return plain_tip(full_figure(vector->x()) + ", " + full_figure(vector->y()) + below);
      }
      return {};
    }
    case Qt::TextAlignmentRole:
      return headerData(index.column(), Qt::Horizontal, role);
    case Qt::FontRole: {
      if (!is_sum(index.row())) return {};
      QFont font;
      font.setBold(true);
      return font;
    }
    default:
      return {};
  }
}

QVariant FigureModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal) return {};
  const Column& column = columns_[static_cast<std::size_t>(section)];
  if (role == Qt::DisplayRole) return broken_ ? QString::fromUtf8(column.heading) : heading(section);
  if (role == Qt::TextAlignmentRole) {
    return static_cast<int>((column.text ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
  }
  return {};
}

QString FigureModel::heading(int column) const {
  return QString::fromUtf8(columns_[static_cast<std::size_t>(column)].heading).replace('\n', ' ');
}

void FigureModel::break_headings(bool broken) {
  if (broken == broken_) return;
  broken_ = broken;
  emit headerDataChanged(Qt::Horizontal, 0, columnCount() - 1);
}

void FigureModel::rows_changed(int rows) {
  known_rows_ = rows;
  if (rows > rows_) {
    beginInsertRows({}, rows_, rows - 1);
    rows_ = rows;
    endInsertRows();
  } else if (rows < rows_) {
    beginRemoveRows({}, rows, rows_ - 1);
    rows_ = rows;
    endRemoveRows();
  }
  if (rows_ > 0) emit dataChanged(index(0, 0), index(rows_ - 1, columnCount() - 1));
}

void FigureModel::set_columns(std::vector<Column> columns) {
  beginResetModel();
  columns_ = std::move(columns);
  rows_ = known_rows_ = 0;
  endResetModel();
}

FigureTable::FigureTable(FigureModel* model, const QString& name, QWidget* parent)
    : KeptTable(parent), model_(model) {
  setAccessibleName(name);
  model->setParent(this);
  setModel(model);
  setItemDelegate(new FigureDelegate(this));
  setShowGrid(false);
  setWordWrap(false);
  setTextElideMode(Qt::ElideRight);
  setSelectionBehavior(QAbstractItemView::SelectRows);
  setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
  setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
  setCornerButtonEnabled(false);
  setTabKeyNavigation(false);  // Tab moves the focus to the next widget
  verticalHeader()->hide();
  verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
  verticalHeader()->setDefaultSectionSize(kRowHeight);
  horizontalHeader()->setSectionResizeMode(QHeaderView::Fixed);
  horizontalHeader()->setHighlightSections(false);
  horizontalHeader()->setMinimumSectionSize(0);
  connect(model, &QAbstractItemModel::modelReset, this, &FigureTable::share_width);
  connect(model, &QAbstractItemModel::rowsInserted, this, &FigureTable::share_width);
  for (const auto rows : {&QAbstractItemModel::rowsInserted, &QAbstractItemModel::rowsRemoved})
    connect(model, rows, this, &FigureTable::fit_rows);
  connect(model, &QAbstractItemModel::modelReset, this, &FigureTable::fit_rows);
  // Columns grow with their figures, but not at every frame.
  constexpr int kGrowsAfter = 100;  // ms
  auto* grows = new QTimer(this);
  grows->setSingleShot(true);
  grows->setInterval(kGrowsAfter);
  connect(model, &QAbstractItemModel::dataChanged, grows, [grows] {
    if (!grows->isActive()) grows->start();
  });
  connect(grows, &QTimer::timeout, this, [this] {
    if (!isVisible()) return;
    for (int c = 0; c < model_->columnCount(); ++c) {
      if (!model_->is_text(c) && least_width(c) > columnWidth(c)) return share_width();
    }
  });
}

QString spreadsheet_text(const FigureModel::Cell& cell, char separator) {
  const auto number = [](double value) { return QString::number(value, 'g', QLocale::FloatingPointShortest); };
  if (const auto* vector = std::get_if<Vec2>(&cell))
    return number(vector->x()) + separator + number(vector->y());
  if (const auto* value = std::get_if<double>(&cell)) return number(*value);
  const auto* text = std::get_if<QString>(&cell);
  return text == nullptr ? QString() : *text;
}

QString FigureTable::text(char separator) const {
  using Cell = FigureModel::Cell;
  QStringList lines;
  QStringList heads;
  const int columns = model_->columnCount();
  std::vector<bool> is_vector(static_cast<std::size_t>(columns), false);
  for (int c = 0; c < columns; ++c) {
    if (isColumnHidden(c)) continue;
    for (int r = 0; r < model_->rowCount(); ++r) {
      if (std::holds_alternative<Vec2>(model_->cell(r, c))) is_vector[static_cast<std::size_t>(c)] = true;
    }
    const QString head = model_->heading(c);
    const bool vector = is_vector[static_cast<std::size_t>(c)];
    const QStringList whole = vector ? QStringList{head + ", x", head + ", y"} : QStringList{head};
    for (const QString& each : whole) heads << quoted(each, separator);
  }
  lines << heads.join(separator);
  for (int r = 0; r < model_->rowCount(); ++r) {
    QStringList fields;
    for (int c = 0; c < columns; ++c) {
      if (isColumnHidden(c)) continue;
      const Cell cell = model_->cell(r, c);
      const auto* words = std::get_if<QString>(&cell);
      fields << (words == nullptr ? spreadsheet_text(cell, separator) : quoted(*words, separator));
      // A column of vectors is two columns in every line.
      if (is_vector[static_cast<std::size_t>(c)] && !std::holds_alternative<Vec2>(cell)) fields << QString();
    }
    lines << fields.join(separator);
  }
  return lines.join('\n') + '\n';
}

bool FigureTable::event(QEvent* event) {
  // The table's own copy, not that of the window.
  if (event->type() == QEvent::ShortcutOverride &&
      static_cast<QKeyEvent*>(event)->matches(QKeySequence::Copy)) {
    event->accept();
    return true;
  }
  return QTableView::event(event);
}

void FigureTable::keyPressEvent(QKeyEvent* event) {
  if (event->matches(QKeySequence::Copy)) {
    QGuiApplication::clipboard()->setText(copied());
  } else {
    QTableView::keyPressEvent(event);
  }
}

void FigureTable::contextMenuEvent(QContextMenuEvent* event) {
  auto* menu = new QMenu(this);
  menu->setAttribute(Qt::WA_DeleteOnClose);
  QAction* copy =
      menu->addAction(tr("&Copy the table"), this, [this] { QGuiApplication::clipboard()->setText(text()); });
  copy->setShortcut(QKeySequence::Copy);
  if (isSignalConnected(QMetaMethod::fromSignal(&FigureTable::saveAsked)))
    menu->addAction(tr("&Save the table..."), this, &FigureTable::saveAsked);
  menu->popup(event->globalPos());
}

int FigureTable::wanted_rows() const {
  const int rows = model_->rowCount();
  int sum = rows - 1;
  while (sum >= 0 && !model_->is_sum(sum)) --sum;
  return sum < 0 ? 0 : rows - sum;
}

void FigureTable::resizeEvent(QResizeEvent* event) {
  QTableView::resizeEvent(event);
  share_width();
  fit_rows();
}

// Where rows scroll they are of a height that lets whole ones fill the table: none is cut in half.
void FigureTable::fit_rows() {
  const int height = viewport()->height();
  const bool scrolls = model_->rowCount() * kRowHeight > height && height >= kRowHeight;
  verticalHeader()->setDefaultSectionSize(scrolls ? height / (height / kLeastRowHeight) : kRowHeight);
}

// px: a column of text keeps nine tenths of its share and cuts what is longer; figures and heads are never cut.
int FigureTable::least_width(int column) const {
  if (isColumnHidden(column)) return 0;
  if (model_->is_text(column)) return 9 * model_->weight(column) / 10;
  return std::max(sizeHintForColumn(column) + 2 * kInset, horizontalHeader()->sectionSizeHint(column));
}

int FigureTable::least_width() const {
  int width = 0;
  for (int c = 0; c < model_->columnCount(); ++c) width += least_width(c);
  return width;
}

// Columns divide the width by weight, but none is narrower than its least: then the table scrolls. Headings are
// broken where their lines save width that is needed.
void FigureTable::share_width() {
  model_->break_headings(false);
  if (least_width() > viewport()->width()) model_->break_headings(true);
  struct Share {
    int column;
    int weight;
    int least;  // px
  };
  std::vector<Share> shares;
  int weights = 0;
  int needed = 0;
  for (int c = 0; c < model_->columnCount(); ++c) {
    if (isColumnHidden(c)) continue;
    shares.push_back({c, model_->weight(c), least_width(c)});
    weights += shares.back().weight;
    needed += shares.back().least;
  }
  // First those that need most of their share: the others have what they leave.
  std::sort(shares.begin(), shares.end(),
            [](const Share& a, const Share& b) { return a.least * b.weight > b.least * a.weight; });
  int left = std::max(viewport()->width(), needed);
  for (const auto& [column, weight, least] : shares) {
    const int width = std::max(least, left * weight / weights);
    horizontalHeader()->resizeSection(column, width);
    left -= width;
    weights -= weight;
  }
}

}  // namespace carom
