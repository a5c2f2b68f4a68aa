#include "widgets/plot/quantity_picker.h"

#include <QComboBox>
#include <QCompleter>
#include <QCoreApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QMouseEvent>
#include <QStandardItemModel>
#include <algorithm>
#include <array>

#include "physics/observe/observables.h"
#include "physics/observe/quantity_name.h"
#include "widgets/base/method_names.h"
#include "widgets/plot/plot_content.h"

namespace carom {
namespace {

constexpr std::array<std::pair<Topic, const char*>, 8> kTopics = {{
    {Topic::kBody, "of one body"},
    {Topic::kPair, "of two bodies"},
    {Topic::kEnergy, "energy of all bodies"},
    {Topic::kMomentum, "momentum of all bodies"},
    {Topic::kLedger, "where the energy went"},
    {Topic::kAllBodies, "over all moving bodies"},
    {Topic::kRun, "of the run"},
    {Topic::kError, "against the reference"},
}};

// Where two quantities have the same label: of one body and of all.
QString told_apart(const Observable& o) {
  QString label = text_of(o.label);
  const auto all = observables();
  const bool one =
      std::count_if(all.begin(), all.end(), [&](const Observable& a) { return a.label == o.label; }) < 2;
  if (one) return label;
  return (o.bodies > 0 ? QCoreApplication::translate("QuantityPicker", "%1, one body")
                       : QCoreApplication::translate("QuantityPicker", "%1, all bodies"))
      .arg(label);
}

void add_topics(QComboBox* box) {
  auto* model = static_cast<QStandardItemModel*>(box->model());
  for (const auto& [topic, title] : kTopics) {
    auto* head = new QStandardItem(QCoreApplication::translate("QuantityPicker", title));
    head->setFlags(Qt::NoItemFlags);
    model->appendRow(head);
    for (const Observable& o : observables()) {
      if (o.topic != topic) continue;
      const QString label = told_apart(o);
      box->addItem("   " + shown_unit(o).behind(label), text_of(o.name));
    }
  }
}

// Searched by typing: there may be a thousand entries. A click marks the entry, so that typing replaces it.
class SearchBox : public QComboBox {
 public:
  explicit SearchBox(QWidget* parent) : QComboBox(parent) {
    setEditable(true);
    lineEdit()->installEventFilter(this);
  }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override {
    if (watched == lineEdit() && event->type() == QEvent::MouseButtonRelease &&
        !lineEdit()->hasSelectedText() && lineEdit()->text() == itemText(currentIndex())) {
      lineEdit()->selectAll();
    }
    return QComboBox::eventFilter(watched, event);
  }
};

QComboBox* search_box(QWidget* parent) {
  auto* box = new SearchBox(parent);
  box->setInsertPolicy(QComboBox::NoInsert);
  box->completer()->setCompletionMode(QCompleter::PopupCompletion);
  box->completer()->setFilterMode(Qt::MatchContains);
  box->setMaxVisibleItems(14);
  return box;
}

bool is_heading(const QComboBox& box, int entry) {
  return !box.model()->flags(box.model()->index(entry, 0)).testFlag(Qt::ItemIsEnabled);
}

// Takes the first entry that contains what was typed, or else shows the present one again.
void choose_typed(QComboBox& box) {
  const QString typed = box.currentText().trimmed();
  const QString present = box.itemText(box.currentIndex());
  if (typed != present.trimmed() && !typed.isEmpty()) {
    for (int i = 0; i < box.count(); ++i) {
      if (!is_heading(box, i) && box.itemText(i).contains(typed, Qt::CaseInsensitive))
        return box.setCurrentIndex(i);
    }
  }
  box.setEditText(present);
}

QComboBox* body_box(const std::vector<Body>& bodies, QWidget* parent) {
  QComboBox* box = search_box(parent);
  box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  box->setMinimumContentsLength(8);
  for (const Body& body : bodies) box->addItem(QString::fromStdString(body.name));
  // Moving bodies come first: people look at these.
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (has_infinite_mass(bodies[i])) continue;
    box->setCurrentIndex(static_cast<int>(i));
    break;
  }
  return box;
}

}  // namespace

QuantityPicker::QuantityPicker(const std::vector<Body>& bodies, const QString& none, QWidget* parent)
    : QWidget(parent),
      observable_(search_box(this)),
      first_(body_box(bodies, this)),
      second_(body_box(bodies, this)) {
  if (!none.isEmpty()) observable_->addItem(none, QString());
  add_topics(observable_);
  connect(observable_->lineEdit(), &QLineEdit::editingFinished, this, [this] { choose_typed(*observable_); });
  observable_->setAccessibleName(tr("Quantity"));
  first_->setAccessibleName(tr("Body"));
  second_->setAccessibleName(tr("Other body"));
  // The second body differs from the first.
  for (std::size_t i = static_cast<std::size_t>(first_->currentIndex()) + 1; i < bodies.size(); ++i) {
    if (has_infinite_mass(bodies[i])) continue;
    second_->setCurrentIndex(static_cast<int>(i));
    break;
  }
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(6);
  row->addWidget(observable_, 3);
  row->addWidget(first_, 2);
  row->addWidget(second_, 2);
  connect(observable_, &QComboBox::currentIndexChanged, this, [this](int now) {
    if (is_heading(*observable_, now)) return observable_->setCurrentIndex(chosen_);
    chosen_ = now;
    show_bodies();
    emit changed();
  });
  for (QComboBox* box : {first_, second_}) {
    connect(box, &QComboBox::currentTextChanged, this, &QuantityPicker::changed);
  }
  if (none.isEmpty()) observable_->setCurrentIndex(1);
  show_bodies();
}

void QuantityPicker::show_bodies() {
  const Observable* observable = find_observable(observable_->currentData().toString().toStdString());
  first_->setVisible(observable != nullptr && observable->bodies > 0);
  second_->setVisible(observable != nullptr && observable->bodies > 1);
}

void QuantityPicker::set_quantity(const QuantityName& quantity) {
  observable_->setCurrentIndex(observable_->findData(QString::fromStdString(quantity.observable)));
  if (!quantity.bodies.empty()) first_->setCurrentText(QString::fromStdString(quantity.bodies[0]));
  if (quantity.bodies.size() > 1) second_->setCurrentText(QString::fromStdString(quantity.bodies[1]));
}

QuantityName QuantityPicker::quantity() const {
  QuantityName quantity;
  quantity.observable = observable_->currentData().toString().toStdString();
  const Observable* observable = find_observable(quantity.observable);
  if (observable == nullptr) return quantity;
  if (observable->bodies > 0) quantity.bodies.push_back(first_->currentText().toStdString());
  if (observable->bodies > 1) quantity.bodies.push_back(second_->currentText().toStdString());
  return quantity;
}

}  // namespace carom
