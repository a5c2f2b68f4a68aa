#include "widgets/run/stop_editor.h"

#include <QGridLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QRegularExpression>
#include <QScreen>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QVBoxLayout>
#include <algorithm>
#include <array>

#include "physics/scene/value_checks.h"
#include "widgets/base/plain_text.h"
#include "widgets/edit/choice_box.h"
#include "widgets/edit/quantity.h"

namespace carom {
namespace {

constexpr int kAny = 0;      // of the bodies in a box
constexpr int kWall = 1;     // of the partners
constexpr int kWidth = 420;  // px

// What is asked for each kind, in the order of StopKind.
struct Asked {
  const char* words;
  bool number, body, with, quantity, value;
};
constexpr auto kAsked = std::to_array<Asked>({
    {"at a time", false, false, false, false, true},
    {"at an impact, by its number", true, true, true, false, false},
    {"at every impact", false, true, true, false, false},
    {"when a body passes a value", false, true, false, true, true},
    {"when all is at rest", false, false, false, false, false},
    {"when K falls below", false, false, false, false, true},
});

const Asked& asked_of(StopKind kind) { return kAsked[static_cast<std::size_t>(kind)]; }

// The SI unit of its value.
const char* unit_of(StopKind kind, StopQuantity quantity) {
  constexpr auto kUnits = std::to_array<const char*>({"m", "m", "rad", "m/s"});
  if (kind == StopKind::kTime) return "s";
  return kind == StopKind::kKineticEnergy ? "J" : kUnits[static_cast<std::size_t>(quantity)];
}

double& value_of(Stop& stop) {
  if (stop.kind == StopKind::kTime) return stop.time;
  return stop.kind == StopKind::kKineticEnergy ? stop.below : stop.value;
}

QString name_of_stop(const Stop& stop) { return QString::fromStdString(sentence_of(stop)); }

int row_of(const ChoiceBox& box, const std::string& name, int without) {
  return name.empty() ? without : std::max(without, box.findText(QString::fromStdString(name)));
}

}  // namespace

StopEditor::StopEditor(QWidget* parent)
    : QFrame(parent, Qt::Popup),
      list_(new QListWidget(this)),
      sentence_(new QLineEdit(this)),
      fault_(new PlainLabel(this)),
      add_(new QPushButton(tr("Add"), this)),
      change_(new QPushButton(tr("Change"), this)),
      remove_(new QPushButton(tr("Remove"), this)) {
  setObjectName("panel");
  setFixedWidth(kWidth);
  auto* title = new PlainLabel(tr("The run stops"), this);
  title->setStyleSheet("font-weight: bold;");
  list_->setAccessibleName(tr("Stops"));
  list_->installEventFilter(this);
  sentence_->setAccessibleName(tr("Sentence of the stop"));
  sentence_->setPlaceholderText(tr("at the 3rd impact"));
  fault_->setObjectName("fault");
  fault_->setAccessibleName(tr("What is wrong"));
  fault_->setWordWrap(true);
  auto* buttons = new QHBoxLayout;
  for (QPushButton* button : {add_, change_, remove_}) {
    button->setAutoDefault(false);
    buttons->addWidget(button);
  }
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(12, 10, 12, 12);
  column->setSpacing(8);
  column->addWidget(title);
  column->addWidget(list_);
  column->addWidget(make_choices());
  column->addWidget(sentence_);
  column->addWidget(fault_);
  column->addLayout(buttons);
  connect_choices();
  connect(list_, &QListWidget::currentRowChanged, this, &StopEditor::choose_row);
  connect(sentence_, &QLineEdit::textEdited, this, &StopEditor::take_sentence);
  connect(sentence_, &QLineEdit::returnPressed, this, &StopEditor::take_enter);
  connect(add_, &QPushButton::clicked, this, &StopEditor::add);
  connect(change_, &QPushButton::clicked, this, &StopEditor::change);
  connect(remove_, &QPushButton::clicked, this, &StopEditor::remove);
  Stop first;
  first.kind = StopKind::kImpact;
  show_stop(first);
}

QWidget* StopEditor::make_choices() {
  auto* all = new QWidget(this);
  const auto box = [all](const QStringList& words, const QString& name) {
    auto* choices = new ChoiceBox(all);
    choices->addItems(words);
    choices->setAccessibleName(name);
    return choices;
  };
  QStringList kinds;
  for (const Asked& each : kAsked) kinds << tr(each.words);
  kind_ = box(kinds, tr("Kind of stop"));
  number_ = new QSpinBox(all);
  number_->setRange(1, 1'000'000'000);
  number_->setButtonSymbols(QAbstractSpinBox::NoButtons);
  number_->setAccessibleName(tr("Number of the impact"));
  of_ = new PlainLabel(tr("of"), all);
  body_ = box({}, tr("Body"));
  with_word_ = new PlainLabel(tr("with"), all);
  with_ = box({}, tr("Other body"));
  quantity_ = box({"x", "y", tr("angle"), tr("speed")}, tr("Quantity"));
  value_ = new QLineEdit(all);
  value_->setAccessibleName(tr("Value"));
  unit_ = new PlainLabel(all);
  way_ = box({tr("either way"), tr("upwards"), tr("downwards")}, tr("Direction"));
  for (ChoiceBox* names : {body_, with_}) {
    names->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    names->setMinimumContentsLength(8);
  }
  for (ChoiceBox* words : {kind_, quantity_, way_}) words->setSizeAdjustPolicy(QComboBox::AdjustToContents);
  auto* rows = new QVBoxLayout(all);
  rows->setContentsMargins(0, 0, 0, 0);
  rows->setSpacing(6);
  auto* bodies = new QHBoxLayout;
  bodies->addWidget(of_);
  bodies->addWidget(body_, 1);
  bodies->addWidget(with_word_);
  bodies->addWidget(with_, 1);
  auto* kinds_row = new QHBoxLayout;
  kinds_row->addWidget(kind_, 1);
  kinds_row->addWidget(number_);
  auto* values = new QHBoxLayout;
  values->addWidget(quantity_);
  values->addWidget(value_, 1);
  values->addWidget(unit_);
  values->addWidget(way_);
  for (QHBoxLayout* row : {kinds_row, bodies, values}) rows->addLayout(row);
  return all;
}

void StopEditor::connect_choices() {
  for (ChoiceBox* box : {kind_, body_, with_, quantity_, way_})
    connect(box, &QComboBox::currentIndexChanged, this, &StopEditor::take_choices);
  connect(number_, &QSpinBox::valueChanged, this, &StopEditor::take_choices);
  connect(value_, &QLineEdit::textEdited, this, &StopEditor::take_choices);
  connect(value_, &QLineEdit::returnPressed, this, &StopEditor::take_enter);
}

void StopEditor::set_document(const std::vector<Stop>& stops, const std::vector<Body>& bodies) {
  stops_ = stops;
  bodies_ = bodies;
  const std::optional<Stop> made = made_;
  const int row = list_->currentRow();
  const QSignalBlocker blockers[] = {QSignalBlocker(list_), QSignalBlocker(body_), QSignalBlocker(with_)};
  list_->clear();
  for (const Stop& stop : stops_) list_->addItem(name_of_stop(stop));
  list_->setCurrentRow(row < list_->count() ? row : -1);
  body_->clear();
  with_->clear();
  body_->addItem(tr("any body"));
  with_->addItems({tr("any body"), tr("a wall")});
  for (const Body& body : bodies_) {
    body_->addItem(QString::fromStdString(body.name));
    with_->addItem(QString::fromStdString(body.name));
  }
  if (made) {
    show_stop(*made);
  } else if (fault_->isVisibleTo(this)) {
    take_sentence();  // bodies that it names may be there now
  }
  enable();
}

void StopEditor::open_over(const QWidget& anchor, std::optional<std::size_t> stop) {
  list_->setCurrentRow(stop ? static_cast<int>(*stop) : -1);
  corner_ = anchor.mapToGlobal(QPoint(anchor.width(), 0));
  fit();
  show();
  stop ? list_->setFocus() : sentence_->setFocus();
  if (!stop) sentence_->selectAll();
}

void StopEditor::open_over(const QWidget& anchor, const Stop& begun) {
  show_stop(begun);
  open_over(anchor, std::nullopt);
  if (!asked_of(begun.kind).value) return;
  value_->setFocus();
  value_->selectAll();
}

// Its lower right corner stays over the anchor.
void StopEditor::fit() {
  constexpr int kMostRows = 6;
  constexpr int kGap = 8;  // px
  const int rows = std::clamp(list_->count(), 1, kMostRows);
  list_->setFixedHeight(rows * std::max(list_->sizeHintForRow(0), 1) + 2 * list_->frameWidth());
  layout()->activate();
  adjustSize();
  const QRect free = screen()->availableGeometry();
  const QPoint at = corner_ - QPoint(width(), height() + kGap);
  move(std::max(at.x(), free.left()), std::max(at.y(), free.top()));
}

void StopEditor::show_rows(StopKind kind, StopQuantity quantity) {
  const Asked& asked = asked_of(kind);
  number_->setVisible(asked.number);
  for (QWidget* part : std::initializer_list<QWidget*>{of_, body_}) part->setVisible(asked.body);
  for (QWidget* part : std::initializer_list<QWidget*>{with_word_, with_}) part->setVisible(asked.with);
  for (QWidget* part : std::initializer_list<QWidget*>{quantity_, way_}) part->setVisible(asked.quantity);
  for (QWidget* part : std::initializer_list<QWidget*>{value_, unit_}) part->setVisible(asked.value);
  unit_->setText(unit_of(kind, quantity));
}

void StopEditor::show_stop(const Stop& stop) {
  const QSignalBlocker blockers[] = {QSignalBlocker(kind_), QSignalBlocker(number_),   QSignalBlocker(body_),
                                     QSignalBlocker(with_), QSignalBlocker(quantity_), QSignalBlocker(way_)};
  kind_->setCurrentIndex(static_cast<int>(stop.kind));
  number_->setValue(stop.number);
  body_->setCurrentIndex(row_of(*body_, stop.body, kAny));
  with_->setCurrentIndex(stop.with_wall ? kWall : row_of(*with_, stop.with, kAny));
  quantity_->setCurrentIndex(static_cast<int>(stop.quantity));
  way_->setCurrentIndex(static_cast<int>(stop.way));
  Stop copy = stop;
  if (asked_of(stop.kind).value && !value_->hasFocus())
    value_->setText(QString::number(value_of(copy), 'g', QLocale::FloatingPointShortest));
  show_rows(stop.kind, stop.quantity);
  if (!sentence_->hasFocus()) sentence_->setText(name_of_stop(stop));
  take(stop);
}

void StopEditor::take_choices() {
  Stop stop;
  stop.kind = static_cast<StopKind>(kind_->currentIndex());
  stop.quantity = static_cast<StopQuantity>(quantity_->currentIndex());
  const Asked& asked = asked_of(stop.kind);
  show_rows(stop.kind, stop.quantity);
  if (asked.number) stop.number = number_->value();
  // A sentence that tells a body's passing needs one.
  const int first = asked.quantity && body_->currentIndex() == kAny && body_->count() > 1 ? 1 : 0;
  if (first > 0) {
    const QSignalBlocker blocker(body_);
    body_->setCurrentIndex(first);
  }
  if (asked.body && body_->currentIndex() > kAny) stop.body = body_->currentText().toStdString();
  stop.with_wall = asked.with && with_->currentIndex() == kWall;
  if (asked.with && with_->currentIndex() > kWall) stop.with = with_->currentText().toStdString();
  if (asked.quantity) {
    stop.way = static_cast<PassingWay>(way_->currentIndex());
  } else {
    stop.quantity = StopQuantity::kX;
  }
  if (asked.value) {
    const TypedQuantity typed = typed_quantity(value_->text(), unit_of(stop.kind, stop.quantity));
    if (!typed.change) return refuse(typed.fault);
    value_of(stop) = typed.change->of(0.0);
  }
  sentence_->setText(name_of_stop(stop));
  take(stop);
}

void StopEditor::take_sentence() {
  try {
    static const QRegularExpression decimal_comma("(?<=\\d),(?=\\d)");
    const QString sentence = sentence_->text().trimmed().replace(decimal_comma, ".");
    show_stop(stop_of("stop", sentence.toStdString()));
  } catch (const SceneError& error) {
    refuse(QString::fromStdString(error.what()));
  }
}

void StopEditor::take(const Stop& stop) {
  NamedBodies named;
  for (const Body& body : bodies_) named.emplace(body.name, &body);
  for (const std::string* name : {&stop.body, &stop.with}) {
    if (!name->empty() && !named.contains(*name))
      return refuse(tr("There is no body “%1” here.").arg(QString::fromStdString(*name)));
  }
  try {
    check_stop("stop", stop, named);
  } catch (const SceneError& error) {
    return refuse(QString::fromStdString(error.what()));
  }
  made_ = stop;
  fault_->hide();
  enable();
}

void StopEditor::refuse(const QString& why) {
  made_.reset();
  fault_->setText(why);
  fault_->show();
  enable();
}

void StopEditor::choose_row(int row) {
  if (row >= 0 && static_cast<std::size_t>(row) < stops_.size())
    show_stop(stops_[static_cast<std::size_t>(row)]);
  enable();
}

void StopEditor::enable() {
  const bool chosen = list_->currentRow() >= 0;
  list_->setVisible(!stops_.empty());
  add_->setEnabled(made_ && std::find(stops_.begin(), stops_.end(), *made_) == stops_.end());
  change_->setEnabled(chosen && add_->isEnabled());
  remove_->setEnabled(chosen);
  fit();
}

void StopEditor::add() {
  if (!add_->isEnabled()) return;
  std::vector<Stop> stops = stops_;
  stops.push_back(*made_);
  emit stopsChanged(stops, tr("Stop %1").arg(name_of_stop(*made_)));
}

void StopEditor::change() {
  if (!change_->isEnabled()) return;
  std::vector<Stop> stops = stops_;
  stops[static_cast<std::size_t>(list_->currentRow())] = *made_;
  emit stopsChanged(stops, tr("Stop %1").arg(name_of_stop(*made_)));
}

void StopEditor::remove() {
  if (!remove_->isEnabled()) return;
  std::vector<Stop> stops = stops_;
  const auto gone = stops.begin() + list_->currentRow();
  const QString text = tr("Remove stop %1").arg(name_of_stop(*gone));
  stops.erase(gone);
  emit stopsChanged(stops, text);
}

void StopEditor::take_enter() { change_->isEnabled() ? change() : add(); }

bool StopEditor::eventFilter(QObject* watched, QEvent* event) {
  if (watched == list_ && event->type() == QEvent::KeyPress &&
      static_cast<QKeyEvent*>(event)->key() == Qt::Key_Delete) {
    remove();
    return true;
  }
  return QFrame::eventFilter(watched, event);
}

}  // namespace carom
