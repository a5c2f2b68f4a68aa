#include "widgets/compare/study_panel.h"

#include <QActionGroup>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QMenu>
#include <QMouseEvent>
#include <QProgressBar>
#include <QStackedWidget>
#include <QToolButton>
#include <QToolTip>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <thread>

#include "physics/dynamics/integrators/integrators.h"
#include "physics/preset/preset.h"
#include "physics/preset/start_fingerprint.h"
#include "physics/study/study_table.h"
#include "widgets/base/ask.h"
#include "widgets/base/elided_label.h"
#include "widgets/base/method_names.h"
#include "widgets/base/number_text.h"
#include "widgets/base/plain_text.h"
#include "widgets/compare/error_plot.h"
#include "widgets/compare/log_scale.h"
#include "widgets/compare/order_table.h"
#include "widgets/compare/study_plot.h"
#include "widgets/compare/study_steps.h"
#include "widgets/print/save_file.h"

namespace carom {
namespace {

constexpr int kPoll = 50;             // ms
constexpr int kPollOfTimes = 250;     // ms: drawing must not disturb the timed runs
constexpr double kTableShare = 0.34;  // of the width
constexpr int kNarrowestTable = 165;  // px
constexpr int kWidestTable = 300;     // px
constexpr int kButton = 23;           // px, high
constexpr int kLow = 230;             // px: a lower panel has its buttons at the side
constexpr int kNarrow = 480;          // px: a low panel that is narrower has no room for the table

// Whether one study holds for both: beside the start, what decides the motion and a study doesn't vary, and
// whether it goes on from the inner state of a saved run.
bool move_alike(const Preset& a, const Preset& b) {
  return fingerprint_of_start(a) == fingerprint_of_start(b) && a.duration == b.duration &&
         a.method.contacts == b.method.contacts &&
         state_belongs(a.scene, a.saved) == state_belongs(b.scene, b.saved);
}

QString words_of(const StudyFacts& facts) {
  return QString::fromStdString(compared_text(facts) + "; " + horizon_text(facts) + "; " +
                                reference_text(facts));
}

bool save_text(const QString& path, const std::vector<std::string>& lines, QString* error) {
  return save_file(
      path,
      [&](OutputFile& file) {
        for (const std::string& line : lines) file.line(line);
      },
      error);
}

}  // namespace

StudyPanel::StudyPanel(const Theme& theme, QWidget* parent) : QWidget(parent) {
  layout_ = new QBoxLayout(QBoxLayout::LeftToRight, this);
  layout_->setContentsMargins(0, 5, 0, 0);
  buttons_ = new QBoxLayout(QBoxLayout::TopToBottom);
  layout_->addLayout(buttons_);
  run_button_ = make_button(tr("Run the study"), {});
  error_button_ = make_button({}, tr("Which error is drawn"));
  against_button_ = make_button({}, tr("Quantity on the other axis"));
  steps_button_ = make_button({}, tr("Which steps the study takes"));
  export_button_ = make_button(tr("Export..."), tr("Save the table (CSV, every digit) or the picture"));
  for (QToolButton* button : {run_button_, steps_button_, error_button_, against_button_})
    buttons_->addWidget(button);
  buttons_->addStretch();
  buttons_->addWidget(export_button_);
  connect(run_button_, &QToolButton::clicked, this, [this] { running() ? cancel() : start(); });
  connect(steps_button_, &QToolButton::clicked, this, &StudyPanel::choose_steps);
  connect(export_button_, &QToolButton::clicked, this, &StudyPanel::choose_file);
  make_choices();

  pages_ = new QStackedWidget;
  layout_->addWidget(pages_, 1);
  hint_ = new PlainLabel;
  hint_->setObjectName("muted");
  hint_->setWordWrap(true);
  hint_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  hint_->setMinimumSize(1, 1);
  pages_->addWidget(hint_);

  auto* content = new QWidget;
  pages_->addWidget(content);
  auto* column = new QVBoxLayout(content);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  auto* side_by_side = new QHBoxLayout;
  side_by_side->setSpacing(10);
  column->addLayout(side_by_side, 1);
  auto* left = new QVBoxLayout;
  left->setSpacing(0);
  side_by_side->addLayout(left, 1);
  other_ = new PlainLabel;
  other_->setObjectName("caption");
  other_->setWordWrap(true);
  other_->hide();
  left->addWidget(other_);
  plot_ = new ErrorPlot(theme, ErrorPlot::Place::kWindow);
  plot_->canvas()->setMouseTracking(true);
  plot_->canvas()->installEventFilter(this);
  left->addWidget(plot_, 1);
  orders_ = new OrderTable(theme);
  side_by_side->addWidget(orders_);

  below_ = new QStackedWidget;
  below_->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Minimum);
  column->addWidget(below_);
  auto* under_way = new QWidget;
  auto* line = new QHBoxLayout(under_way);
  line->setContentsMargins(0, 0, 0, 0);
  stage_ = new ElidedLabel;
  stage_->setObjectName("caption");
  line->addWidget(stage_);
  progress_ = new QProgressBar;
  progress_->setTextVisible(false);
  progress_->setFixedHeight(6);
  progress_->setMinimumWidth(40);
  line->addWidget(progress_, 1);
  below_->addWidget(under_way);
  words_ = new PlainLabel;
  words_->setObjectName("caption");
  words_->setWordWrap(true);
  words_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Minimum);
  below_->addWidget(words_);
  first_words_ = new ElidedLabel;
  first_words_->setObjectName("caption");
  below_->addWidget(first_words_);

  connect(&timer_, &QTimer::timeout, this, &StudyPanel::poll);
  show_words();
}

StudyPanel::~StudyPanel() = default;

QToolButton* StudyPanel::make_button(const QString& name, const QString& tip) {
  auto* button = new QToolButton;
  button->setObjectName("choice");
  button->setStyleSheet("QToolButton#choice { padding: 2px 6px; font-size: 12px; }");
  button->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
  button->setFixedHeight(kButton);
  button->setText(name);
  button->setToolTip(tip);
  return button;
}

void StudyPanel::make_choices() {
  const auto add = [this](QToolButton* button, const QStringList& names, auto&& choose) {
    auto* menu = new QMenu(button);
    auto* group = new QActionGroup(menu);
    for (qsizetype i = 0; i < names.size(); ++i) {
      QAction* action = group->addAction(menu->addAction(names[i]));
      action->setCheckable(true);
      connect(action, &QAction::triggered, this, [this, button, i, name = names[i], choose] {
        choose(i);
        button->setText(name + QStringLiteral(" ▾"));
        show_points();
      });
    }
    button->setMenu(menu);
    button->setPopupMode(QToolButton::InstantPopup);
    menu->actions().constFirst()->setChecked(true);
    button->setText(names.constFirst() + QStringLiteral(" ▾"));
  };
  QStringList errors;
  for (const StudyError& error : kStudyErrors) errors << tr("%1 error / %2").arg(tr(error.label), error.unit);
  add(error_button_, errors, [this](qsizetype i) { error_ = static_cast<std::size_t>(i); });
  add(against_button_, {tr("against step"), tr("against wall time")},
      [this](qsizetype i) { against_time_ = i == 1; });
}

void StudyPanel::set_theme(const Theme& theme) {
  plot_->set_theme(theme);
  orders_->set_theme(theme);
}

// --- the study
// -----------------------------------------------------------------------------------------------------------

void StudyPanel::set_scene(const Preset& preset, const QString& name) {
  name_ = name;
  own_ = preset.method;
  steps_.clear();
  edit_scene(preset);
  show_steps();
}

void StudyPanel::edit_scene(const Preset& preset) {
  preset_ = preset;
  current_ = studied_ && move_alike(*studied_, preset_);
  show_words();
}

QString StudyPanel::words() const {
  return other_->text().isEmpty() ? words_->text() : other_->text() + ' ' + words_->text();
}

void StudyPanel::start(StudyOptions options) {
  cancel();
  study_.reset();
  studied_ = preset_;
  current_ = true;
  studied_->method.step = own_.step;
  studied_->method.tolerance = own_.tolerance;
  if (options.steps.empty()) options.steps = steps_;
  // Leaves one core to the lab.
  options.threads = std::max(1, static_cast<int>(std::thread::hardware_concurrency()) - 1);
  so_far_ = {};
  study_ = std::make_unique<BackgroundStudy>(*studied_, name_.toStdString(), std::move(options));
  timer_.start(kPoll);
  show_points();
  show_words();
}

void StudyPanel::choose_steps() {
  Preset own = preset_;
  own.method.step = own_.step;
  const std::vector<double> usual = default_steps(own);
  auto* dialog = new StudyStepsDialog(steps_.empty() ? usual : steps_, usual, this);
  ask(dialog, [this, dialog, usual] {
    steps_ = dialog->steps();
    if (steps_ == usual) steps_.clear();
    show_steps();
  });
}

void StudyPanel::show_steps() {
  steps_button_->setText(steps_.empty() ? tr("usual steps...")
                                        : tr("%n steps...", nullptr, static_cast<int>(steps_.size())));
}

void StudyPanel::cancel() {
  if (study_ != nullptr) study_->stop();
}

void StudyPanel::poll() {
  if (study_ == nullptr) return;
  StudySoFar so_far = study_->so_far();
  if (so_far.changes == so_far_.changes) return;
  so_far_ = std::move(so_far);
  if (so_far_.phase != StudySoFar::Phase::kRunning) {
    study_.reset();
    timer_.stop();
  } else if (so_far_.stage.starts_with("times")) {
    timer_.setInterval(kPollOfTimes);
  }
  stale_ = true;
  if (isVisible()) show_points();
  show_words();
}

// --- what is shown
// -----------------------------------------------------------------------------------------------------------

void StudyPanel::show_points() {
  stale_ = false;
  std::vector<StudyGroup> groups = groups_of(so_far_.table);
  orders_->set_groups(groups);
  plot_->show_study(so_far_.table.facts, std::move(groups),
                    against_time_ ? ErrorAgainst::kWallTime : ErrorAgainst::kStep, error_);
}

void StudyPanel::show_words() {
  using Phase = StudySoFar::Phase;
  const StudyTable& table = so_far_.table;
  run_button_->setText(running() ? tr("Cancel") : tr("Run the study"));
  run_button_->setToolTip(
      running()
          ? tr("Stop the study; its results so far stay")
          : plain_tip(
                tr("Run “%1” under every method that it allows").arg(QString::fromStdString(preset_.title))));
  export_button_->setEnabled(!running() && !table.rows.empty());
  const bool refused = so_far_.phase == Phase::kRefused;
  hint_->setText(
      refused ? QString::fromStdString(so_far_.refusal)
              : tr("Runs this scene under every integrator, both choices for impacts and a row of steps, and "
                   "shows how wrong each run is and how long it takes. A click on a point takes its method "
                   "into the "
                   "comparison."));
  pages_->setCurrentIndex(!studied_ || (table.rows.empty() && !running()) ? 0 : 1);

  show_below();
  const QString title = studied_ ? QString::fromStdString(studied_->title) : QString();
  const QString other = current_ || !studied_ ? QString()
                        : studied_->title == preset_.title
                            ? tr("Before this scene was edited.")
                            : tr("Not for the scene shown, but for %1.").arg(title);
  other_->setText(other);
  other_->setVisible(!other.isEmpty());
  if (running()) {
    const QString stage = so_far_.stage.empty() ? tr("start") : QString::fromStdString(so_far_.stage);
    stage_->set_whole(so_far_.of > 1 ? tr("%1: %2 of %3").arg(stage).arg(so_far_.done).arg(so_far_.of) : stage);
    progress_->setRange(0, so_far_.of > 1 ? so_far_.of : 0);  // busy indicator where nothing can be counted
    progress_->setValue(so_far_.done);
  } else if (!table.rows.empty()) {
    const QString stopped = so_far_.phase == Phase::kCancelled ? tr("Stopped before it was done. ") : QString();
    words_->setText(stopped + words_of(table.facts));
    first_words_->set_whole(words_->text());
    for (QLabel* label : {words_, static_cast<QLabel*>(first_words_)})
      label->setToolTip("<p>" + stopped.toHtmlEscaped() + "</p><p>" +
                        words_of(table.facts).toHtmlEscaped().replace("; ", ".</p><p>") + ".</p>");
  }
}

void StudyPanel::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  if (stale_) show_points();
}

// A low panel has room for one line.
void StudyPanel::show_below() {
  const bool low = height() < kLow;
  below_->setMaximumHeight(low ? first_words_->sizeHint().height() : QWIDGETSIZE_MAX);
  below_->setCurrentIndex(running() ? 0 : low ? 2 : 1);
}

void StudyPanel::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  const bool low = height() < kLow;
  show_below();
  layout_->setDirection(low ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
  layout_->setSpacing(low ? 10 : 4);
  buttons_->setSpacing(low ? 2 : 4);
  buttons_->setDirection(low ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight);
  orders_->setVisible(!low || width() >= kNarrow);
  orders_->setFixedWidth(std::clamp(static_cast<int>(kTableShare * width()), kNarrowestTable, kWidestTable));
}

QString StudyPanel::tip_of(const StudyRow& row) const {
  const auto error = [](double value, const char* unit) {
    return std::isnan(value) ? tr("none") : QString("%1 %2").arg(short_figure(value, 3), unit);
  };
  QStringList lines;
  lines << QString("%1, %2").arg(text_of(choice_of(kIntegrators, row.method.integrator).label),
                                 text_of(choice_of(kImpacts, row.method.impacts).label));
  switch (error_parameter(row.method)) {
    case ErrorParameter::kStep:
      lines << tr("h = %1 s").arg(short_figure(row.method.step));
      break;
    case ErrorParameter::kTolerance:
      lines << tr("tolerance %1 m").arg(short_figure(row.method.tolerance));
      break;
    case ErrorParameter::kNone:
      lines << tr("no step: the same at every one");
      break;
  }
  for (const StudyError& e : kStudyErrors) {
    lines << tr("%1 error %2").arg(tr(e.label), error(row.*e.value, e.unit));
  }
  lines << (std::isnan(row.wall_time) ? tr("not timed yet")
                                      : tr("wall time %1 (%2 to %3)")
                                            .arg(duration_label(row.wall_time), duration_label(row.wall_least),
                                                 duration_label(row.wall_most)));
  lines << tr("%1 impacts, %2 without a partner; %3 evaluations")
               .arg(row.impacts)
               .arg(row.unmatched)
               .arg(row.evaluations);
  if (row.status != "ok") lines << QString::fromStdString(row.status);
  lines << (current_ ? tr("Click: run the scene with this method")
                     : tr("This is not the scene shown: a click does nothing"));
  return lines.join('\n');
}

bool StudyPanel::eventFilter(QObject* watched, QEvent* event) {
  if (watched != plot_->canvas()) return QWidget::eventFilter(watched, event);
  QWidget* canvas = plot_->canvas();
  switch (event->type()) {
    case QEvent::MouseMove: {
      const auto* mouse = static_cast<QMouseEvent*>(event);
      const StudyRow* row = plot_->row_at(mouse->position());
      plot_->mark(row);
      canvas->setCursor(row != nullptr ? Qt::PointingHandCursor : Qt::ArrowCursor);
      QToolTip::showText(mouse->globalPosition().toPoint(),
                         row != nullptr ? plain_tip(tip_of(*row)) : QString(), canvas);
      return true;
    }
    case QEvent::Leave:
      plot_->mark(nullptr);
      break;
    case QEvent::MouseButtonRelease: {
      const auto* mouse = static_cast<QMouseEvent*>(event);
      const StudyRow* row = plot_->row_at(mouse->position());
      if (mouse->button() != Qt::LeftButton || row == nullptr || !current_) break;
      emit methodChosen(Method(row->method));  // a copy, as the click may change the rows
      return true;
    }
    default:
      break;
  }
  return QWidget::eventFilter(watched, event);
}

// --- files
// -----------------------------------------------------------------------------------------------------------

bool StudyPanel::save(const QString& file, QString* error) const {
  if (QFileInfo(file).suffix().toLower() == "csv") return save_text(file, study_csv(so_far_.table), error);
  return save_study_picture(so_far_.table, light_theme(), file, error);
}

void StudyPanel::choose_file() {
  const std::vector<FileKind> kinds = {{tr("SVG picture (*.svg)"), "svg"},
                                       {tr("PDF (*.pdf)"), "pdf"},
                                       {tr("PNG picture (*.png)"), "png"},
                                       {tr("CSV table, every digit (*.csv)"), "csv"}};
  ask_for_file(this, tr("Save the study"), QString::fromStdString(so_far_.table.facts.preset) + "-study", kinds,
               [this](const QString& file) {
                 QString error;
                 if (!save(file, &error)) show_message(this, tr("The study cannot be saved"), error);
               });
}

}  // namespace carom
