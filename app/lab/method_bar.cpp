#include "app/lab/method_bar.h"

#include <QActionGroup>
#include <QEvent>
#include <QInputDialog>
#include <QMenu>
#include <QToolBar>
#include <QToolButton>
#include <algorithm>
#include <array>
#include <optional>

#include "physics/dynamics/integrators/integrators.h"
#include "physics/scene/facts.h"
#include "physics/scene/validate.h"
#include "widgets/base/ask.h"
#include "widgets/base/method_names.h"
#include "widgets/base/number_text.h"
#include "widgets/base/plain_text.h"
#include "widgets/scene/edit_names.h"

namespace carom {
namespace {

// Steps to choose from, in s.
constexpr std::array kSteps = {0.0001, 0.0002, 0.0005, 0.001, 0.002, 0.005, 0.01, 0.02, 0.05};
constexpr double kTypedMost = 1e6;  // ms
// Tolerances of the adaptive integrator to choose from, in m and m/s.
constexpr std::array kTolerances = {1e-2, 1e-3,  1e-4,  1e-5,  1e-6,  1e-7, 1e-8,
                                    1e-9, 1e-10, 1e-11, 1e-12, 1e-13, 1e-14};

void name(QToolButton* button, std::string_view text) { button->setText(text_of(text) + QStringLiteral(" ▾")); }

QToolButton* make_button(QWidget* window, QMenu* menu, const QString& tip) {
  auto* button = new QToolButton(window);
  button->setObjectName("choice");
  button->setPopupMode(QToolButton::InstantPopup);
  button->setMenu(menu);
  button->setToolTip(tip);
  return button;
}

}  // namespace

MethodBar::MethodBar(QMenu* methods, QWidget* window) : QObject(window), window_(window) {
  integrator_menu_ = add_choices(methods, tr("&Integrator"), kIntegrators, &Method::integrator);
  integrator_ = make_button(window, integrator_menu_, tr("How free motion is advanced; applies from now on"));
  impacts_ = make_button(window, add_choices(methods, tr("&Impacts"), kImpacts, &Method::impacts),
                         tr("When impacts are resolved; applies from now on"));
  contacts_ = make_button(window, add_choices(methods, tr("&Contacts"), kContacts, &Method::contacts),
                          tr("How lasting contacts are treated; applies from now on"));
  add_steps(methods);
  step_ = make_button(window, steps_, {});
}

template <class Table, class Member>
QMenu* MethodBar::add_choices(QMenu* methods, const QString& title, const Table& table, Member member) {
  QMenu* menu = methods->addMenu(title);
  menu->setToolTipsVisible(true);
  auto* group = new QActionGroup(menu);
  for (const auto& choice : table) {
    QAction* action = group->addAction(menu->addAction(text_of(choice.label)));
    action->setToolTip(text_of(choice.tip));
    action->setData(static_cast<int>(choice.id));
    action->setCheckable(true);
    connect(action, &QAction::triggered, this, [this, member, id = choice.id] {
      Method method = method_;
      method.*member = id;
      emit methodChosen(method);
    });
    connect(menu, &QMenu::aboutToShow, action,
            [this, action, member, id = choice.id] { action->setChecked(method_.*member == id); });
  }
  return menu;
}

void MethodBar::add_steps(QMenu* methods) {
  steps_ = methods->addMenu(tr("&Step"));
  for (const double step : kSteps)
    add_number(steps_, QString("h = %1 ms").arg(1e3 * step, 0, 'g', 4), &Method::step, step);
  steps_->addSeparator();
  QAction* another = steps_->addAction(tr("Another..."), this, &MethodBar::ask_for_step);
  another->setCheckable(true);
  connect(steps_, &QMenu::aboutToShow, another, [this, another] {
    another->setChecked(std::find(kSteps.begin(), kSteps.end(), method_.step) == kSteps.end());
  });
  tolerances_ = methods->addMenu(tr("&Tolerance"));
  for (const double tolerance : kTolerances)
    add_number(tolerances_, tr("tolerance %1").arg(short_figure(tolerance)), &Method::tolerance, tolerance);
}

void MethodBar::add_number(QMenu* menu, const QString& text, double Method::*member, double value) {
  QAction* action = menu->addAction(text, this, [this, member, value] { choose(member, value); });
  action->setCheckable(true);
  connect(menu, &QMenu::aboutToShow, action,
          [this, action, member, value] { action->setChecked(method_.*member == value); });
}

void MethodBar::choose(double Method::*member, double value) {
  Method method = method_;
  method.*member = value;
  emit methodChosen(method);
}

void MethodBar::ask_for_step() {
  auto* dialog = new QInputDialog(window_);
  dialog->setWindowTitle(tr("Length of a step"));
  const double least = 1e3 * kStepRange.low;  // ms
  const double largest = 1e3 * kStepRange.high;
  const int decimals = decimals_of(least);
  dialog->setLabelText(tr("h in ms, from %1 to %2:").arg(fixed_text(least, decimals), fixed_text(largest, 0)));
  dialog->setInputMode(QInputDialog::DoubleInput);
  dialog->setDoubleDecimals(decimals);
  // Wider than allowed: a field that takes no minus would make 3 of a typed -3.
  dialog->setDoubleRange(-kTypedMost, kTypedMost);
  dialog->setDoubleValue(1e3 * method_.step);
  ask(dialog, [this, dialog, least, largest, decimals] {
    const double typed = dialog->doubleValue();
    if (typed >= least && typed <= largest) return choose(&Method::step, 1e-3 * typed);
    show_message(window_, dialog->windowTitle(),
                 tr("h lies between %1 and %2 ms; it is still %3 ms.")
                     .arg(fixed_text(least, decimals), fixed_text(largest, 0),
                          QString::number(1e3 * method_.step, 'g', 4)));
  });
}

void MethodBar::add_to(QToolBar* bar) {
  bar_ = bar;
  bar->installEventFilter(this);
  for (QToolButton* choice : {integrator_, impacts_, contacts_, step_}) {
    bar->addWidget(choice);
    auto* gap = new QWidget;
    gap->setFixedWidth(4);
    bar->addWidget(gap);
  }
}

bool MethodBar::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Resize) show_names();
  return QObject::eventFilter(watched, event);
}

void MethodBar::show_document(const Preset& document) {
  method_ = document.method;
  show_names();
  show_allowed(document.scene);
}

void MethodBar::show_names() {
  const IntegratorChoice& integrator = choice_of(kIntegrators, method_.integrator);
  const auto& impacts = choice_of(kImpacts, method_.impacts);
  const auto& contacts = choice_of(kContacts, method_.contacts);
  name(integrator_, integrator.label);
  name(impacts_, impacts.label);
  name(contacts_, contacts.label);
  const bool adaptive = integrator.adaptive;
  const bool exact = integrator.order == 0;
  const QString step = QString("%1 ms ▾").arg(1e3 * method_.step, 0, 'g', 4);
  step_->setText(adaptive ? tr("tolerance %1 ▾").arg(short_figure(method_.tolerance))
                 : exact  ? tr("results every %1").arg(step)
                          : "h = " + step);
  step_->setToolTip(
      adaptive ? tr("Largest error of a step, in m and m/s; applies from now on")
      : exact  ? tr("Exact flight needs no step: this is only the interval of the results; applies from now on")
               : tr("Length of a step; applies from now on"));
  step_->setMenu(adaptive ? tolerances_ : steps_);
  tolerances_->menuAction()->setEnabled(adaptive);

  // In a narrow window short names replace labels, and the integrator's is elided.
  const auto missing = [this] { return bar_->sizeHint().width() - bar_->width(); };
  emit roomFreed();
  if (missing() <= 0) return;
  name(impacts_, impacts.name);
  name(contacts_, contacts.name);
  if (const int more = missing(); more > 0) emit roomMissing(more);
  if (const int more = missing(); more > 0) {
    const QFontMetrics metrics = integrator_->fontMetrics();
    const QString text = integrator_->text();
    integrator_->setText(metrics.elidedText(text, Qt::ElideMiddle, metrics.horizontalAdvance(text) - more));
  }
}

void MethodBar::show_allowed(const Scene& scene) {
  for (QAction* action : integrator_menu_->actions()) {
    const auto id = static_cast<IntegratorId>(action->data().toInt());
    const std::optional<std::string> reason = why_not(scene, id);
    action->setEnabled(!reason);
    action->setToolTip(
        plain_tip(reason ? QString::fromStdString(*reason) : text_of(choice_of(kIntegrators, id).tip)));
  }
}

}  // namespace carom
