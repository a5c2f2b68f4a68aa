#include "widgets/compare/compare_panel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QItemSelectionModel>
#include <QLabel>
#include <QPushButton>
#include <QScrollBar>
#include <QSignalBlocker>
#include <QSlider>
#include <QStandardItemModel>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>

#include "physics/dynamics/integrators/integrators.h"
#include "physics/model/needs.h"
#include "physics/preset/preset.h"
#include "physics/scene/facts.h"
#include "widgets/base/method_names.h"
#include "widgets/base/number_text.h"
#include "widgets/base/plain_text.h"
#include "widgets/base/rounding.h"
#include "widgets/compare/compare_table.h"

namespace carom {
namespace {

// The slider covers 0.1 to 100 ms, with a hundred positions a decade.
constexpr double kLeastOfSlider = 1e-4;  // s
constexpr int kDecades = 3;
constexpr int kPlaces = 100;

// Rounded to two digits, as people choose steps.
double step_at(int place) {
  const double step = kLeastOfSlider * std::pow(10.0, static_cast<double>(place) / kPlaces);
  const double unit = std::pow(10.0, std::floor(std::log10(step)) - 1.0);
  return std::round(step / unit) * unit;
}

int place_of(double step) {
  const double place = kPlaces * std::log10(step / kLeastOfSlider);
  return static_cast<int>(std::lround(std::clamp(place, 0.0, 1.0 * kDecades * kPlaces)));
}

struct ReferenceText {
  ReferenceId id;
  const char* label;
  const char* tip;
};
constexpr std::array<ReferenceText, 3> kReferences = {{
    {ReferenceId::kNone, "no reference", "No reference is computed and no errors are shown"},
    {ReferenceId::kExactFlight, "against exact flight",
     "The parabola in closed form, impacts at their own time"},
    {ReferenceId::kRefined, "against a refined run",
     "The adaptive fifth order at a tolerance of 1e−12, impacts at their own time; where contacts last, the "
     "fifth order "
     "at an eighth of the step"},
}};

void set_enabled(QComboBox* box, int row, const std::optional<std::string>& why_not, const QString& tip) {
  auto* item = static_cast<QStandardItemModel*>(box->model())->item(row);
  item->setEnabled(!why_not);
  item->setToolTip(plain_tip(why_not ? QString::fromStdString(*why_not) : tip));
}

}  // namespace

ComparePanel::ComparePanel(const Theme& theme, QWidget* parent) : QScrollArea(parent) {
  auto* inside = new QWidget;
  setWidget(inside);
  setWidgetResizable(true);
  setFrameShape(QFrame::NoFrame);
  setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setStyleSheet("QScrollArea, QScrollArea > QWidget > QWidget, #bar { background: transparent; }");
  auto* column = new QVBoxLayout(inside);
  column->setContentsMargins(0, 4, 0, 0);
  column->setSpacing(4);
  table_ = new CompareTable(theme);
  constexpr int kLeastHeight = 120;  // px: three methods
  table_->setMinimumHeight(kLeastHeight);
  column->addWidget(make_actions());
  column->addWidget(table_, 1);
  column->addWidget(make_choices());
  connect(table_->selectionModel(), &QItemSelectionModel::currentRowChanged, this, &ComparePanel::show_chosen);
  step_timer_.setSingleShot(true);
  constexpr int kModeration = 80;  // ms
  step_timer_.setInterval(kModeration);
  connect(&step_timer_, &QTimer::timeout, this, &ComparePanel::take_step);
}

QWidget* ComparePanel::make_actions() {
  auto* bar = new QWidget;
  bar->setObjectName("bar");
  auto* row = new QHBoxLayout(bar);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(6);
  usual_ = new QPushButton(tr("Euler | RK4 | exact"));
  usual_->setToolTip(
      tr("This scene from the start by the method of the reference, by explicit Euler and by RK4; again: back "
         "(C)"));
  connect(usual_, &QPushButton::clicked, this, &ComparePanel::usualAsked);
  add_ = new QToolButton;
  add_->setText(QStringLiteral("+"));
  add_->setToolTip(
      tr("One more method, a copy of the chosen one to be changed below; up to %1").arg(1 + kMostCompared));
  connect(add_, &QToolButton::clicked, this, [this] { emit methodAdded(methods_[chosen()]); });
  remove_ = new QToolButton;
  remove_->setText(QString(kMinus));
  for (QToolButton* button : {add_, remove_}) button->setObjectName("choice");
  remove_->setToolTip(tr("Removes the chosen method; the first one is the scene's own"));
  connect(remove_, &QToolButton::clicked, this, [this] { emit methodRemoved(chosen()); });
  references_ = new QComboBox;
  for (const ReferenceText& reference : kReferences) references_->addItem(tr(reference.label));
  connect(references_, &QComboBox::activated, this,
          [this](int i) { emit referenceChosen(kReferences[static_cast<std::size_t>(i)].id); });
  uncertainty_ = new PlainLabel;
  uncertainty_->setObjectName("muted");
  uncertainty_->setToolTip(
      tr("Error of the reference itself: the distance of a less refined run, or how far "
         "rounding has grown"));
  for (QWidget* w : std::initializer_list<QWidget*>{usual_, add_, remove_}) row->addWidget(w);
  row->addStretch(1);
  for (QWidget* w : std::initializer_list<QWidget*>{references_, uncertainty_}) row->addWidget(w);
  return bar;
}

template <class Table, class Member>
QComboBox* ComparePanel::make_choice(const Table& table, Member member, bool short_names, const QString& tip) {
  auto* box = new QComboBox;
  box->setToolTip(tip);
  box->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  constexpr int kLeastWidth = 72;  // px
  box->setMinimumWidth(kLeastWidth);
  for (const auto& choice : table) {
    box->addItem(text_of(short_names ? choice.name : choice.label));
    box->setItemData(box->count() - 1, text_of(choice.label) + ": " + text_of(choice.tip), Qt::ToolTipRole);
  }
  connect(box, &QComboBox::activated, this, [this, &table, member](int i) {
    Method method = methods_[chosen()];
    method.*member = table[static_cast<std::size_t>(i)].id;
    emit methodChanged(method, chosen());
  });
  return box;
}

QWidget* ComparePanel::make_choices() {
  auto* bar = new QWidget;
  bar->setObjectName("bar");
  auto* row = new QHBoxLayout(bar);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(6);
  integrators_ =
      make_choice(kIntegrators, &Method::integrator, false, tr("How the chosen run advances free motion"));
  impacts_ = make_choice(kImpacts, &Method::impacts, true, tr("When the chosen run resolves impacts"));
  contacts_ = make_choice(kContacts, &Method::contacts, true, tr("How the chosen run treats lasting contacts"));
  step_ = new QSlider(Qt::Horizontal);
  step_->setAccessibleName(tr("Step of the chosen run"));
  step_->setRange(0, kDecades * kPlaces);
  step_->setPageStep(kPlaces / 4);
  step_->setMinimumWidth(60);
  step_->setToolTip(
      tr("Length of a step, from now on; of the adaptive integrator and of exact flight only the interval "
         "of the results"));
  step_text_ = new PlainLabel;
  step_text_->setMinimumWidth(step_text_->fontMetrics().horizontalAdvance("h = 0.00 ms"));
  all_ = new QCheckBox(tr("all"));
  all_->setToolTip(tr("The slider sets the step of all methods at once"));
  connect(step_, &QSlider::valueChanged, this, [this](int place) {
    step_text_->setText(tr("h = %1 ms").arg(short_figure(1e3 * step_at(place))));
    if (!step_timer_.isActive()) step_timer_.start();
    step_of_ = chosen();
  });
  connect(step_, &QSlider::sliderPressed, this, [this] { ++drag_; });
  row->addWidget(integrators_, 5);
  for (QComboBox* box : {impacts_, contacts_}) row->addWidget(box, 2);
  row->addWidget(step_, 2);
  row->addWidget(step_text_);
  row->addWidget(all_);
  return bar;
}

void ComparePanel::take_step() {
  std::vector<std::size_t> runs = {step_of_};
  if (all_->isChecked()) {
    runs.resize(methods_.size());
    std::iota(runs.begin(), runs.end(), std::size_t{0});
  }
  emit stepChanged(step_at(step_->value()), runs, drag_);
}

std::size_t ComparePanel::chosen() const {
  const int row = table_->currentIndex().row();
  return row < 0 || static_cast<std::size_t>(row) >= methods_.size() ? 0 : static_cast<std::size_t>(row);
}

QSize ComparePanel::minimumSizeHint() const {
  constexpr int kLeastWidth = 120;  // px
  return {kLeastWidth, widget()->minimumSizeHint().height() + horizontalScrollBar()->sizeHint().height()};
}

void ComparePanel::set_theme(const Theme& theme) { table_->set_theme(theme); }

void ComparePanel::set_scene(const Preset& preset, ReferenceId reference) {
  if (preset.title != preset_.title) step_timer_.stop();
  const bool more = preset.compare.size() == methods_.size();  // one was added
  preset_ = preset;
  reference_ = reference;
  methods_ = {preset.method};
  methods_.insert(methods_.end(), preset.compare.begin(), preset.compare.end());
  for (std::size_t i = 0; i < kReferences.size(); ++i) {
    set_enabled(references_, static_cast<int>(i), why_not(setup_of(preset), kReferences[i].id),
                tr(kReferences[i].tip));
    if (kReferences[i].id == reference) references_->setCurrentIndex(static_cast<int>(i));
  }
  for (std::size_t i = 0; i < kIntegrators.size(); ++i) {
    set_enabled(integrators_, static_cast<int>(i), why_not(preset.scene, kIntegrators[i].id),
                text_of(kIntegrators[i].tip));
  }
  if (more && table_->model()->rowCount() >= static_cast<int>(methods_.size())) {
    table_->selectRow(static_cast<int>(methods_.size()) - 1);
  }
  show_chosen();
}

void ComparePanel::show_chosen() {
  if (methods_.empty()) return;
  const Method& m = methods_[chosen()];
  const auto place = [](const auto& table, auto id) {
    return static_cast<int>(
        std::find_if(table.begin(), table.end(), [id](const auto& c) { return c.id == id; }) - table.begin());
  };
  integrators_->setCurrentIndex(place(kIntegrators, m.integrator));
  impacts_->setCurrentIndex(place(kImpacts, m.impacts));
  contacts_->setCurrentIndex(place(kContacts, m.contacts));
  if (!step_->isSliderDown() && !step_timer_.isActive()) {
    const QSignalBlocker quiet(step_);
    step_->setValue(place_of(m.step));
    step_text_->setText(tr("h = %1 ms").arg(short_figure(1e3 * m.step)));
  }
  add_->setEnabled(methods_.size() <= kMostCompared);
  remove_->setEnabled(chosen() > 0);
}

void ComparePanel::update_from(const std::vector<std::shared_ptr<const Frame>>& frames) {
  const int before = table_->model()->rowCount();
  table_->update_from(frames);
  if (before == 0) table_->selectRow(0);
  if (static_cast<int>(frames.size()) == before + 1 && before > 0) table_->selectRow(before);
  if (frames.empty() || !frames.front()->error) {
    uncertainty_->setText({});
    return;
  }
  double most = 0.0;
  for (const auto& frame : frames) most = std::max(most, frame->error ? frame->error->uncertainty : 0.0);
  const QString rounding = text_of_rounding(most, reach_of(*frames.front()));
  uncertainty_->setText((rounding.isEmpty() ? "± " + short_figure(most, 1) : rounding) + " m");
}

}  // namespace carom
