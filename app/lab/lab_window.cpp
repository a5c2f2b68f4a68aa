#include "app/lab/lab_window.h"

#include <QAction>
#include <QApplication>
#include <QCloseEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QInputDialog>
#include <QLabel>
#include <QMenu>
#include <QMessageBox>
#include <QSignalBlocker>
#include <QStringList>
#include <QTabWidget>
#include <QToolBar>
#include <QToolButton>
#include <algorithm>

#include "app/lab/notice_bar.h"
#include "app/lab/preset_library.h"
#include "physics/dynamics/integrators/integrators.h"
#include "physics/model/needs.h"
#include "physics/preset/preset.h"
#include "physics/preset/preset_file.h"
#include "physics/scene/facts.h"
#include "physics/scene/validate.h"
#include "widgets/compare/compare_panel.h"
#include "widgets/compare/study_panel.h"
#include "widgets/plot/plot_panel.h"
#include "widgets/plot/reading_table.h"
#include "widgets/run/experiment_list.h"
#include "widgets/run/ledger_table.h"
#include "widgets/run/run_tables.h"
#include "widgets/run/transport_bar.h"
#include "widgets/scene/scene_view.h"
#include "widgets/theme/method_names.h"
#include "widgets/theme/number_text.h"
#include "widgets/theme/plain_text.h"

// The layout of the window is in lab_layout.cpp; here is what it does.
namespace carom {

LabWindow::LabWindow(const Theme& theme) : theme_(theme) {
  keep_messages_plain();
  make_actions();
  make_body();
  make_menus();
  make_tool_bar();
  fill_library();
  setMinimumSize(900, 600);  // below it the tool bar is cut
  resize(1280, 800);
  view_->setFocus();  // so that the keys of the scene work at once
  connect_session();
}

// What goes, piece by piece, tells the window nothing any more.
LabWindow::~LabWindow() {
  hide();
  session_.disconnect(this);
  for (const QObject* child : findChildren<QObject*>()) child->disconnect(this);
}

void LabWindow::connect_session() {
  connect(&session_, &Session::framesChanged, this, &LabWindow::show_frame);
  connect(&session_, &Session::noticesChanged, this, &LabWindow::show_notices);
  connect(&session_, &Session::documentChanged, this, &LabWindow::show_method);
  connect(&session_, &Session::documentChanged, this, &LabWindow::show_needs);
  connect(&session_, &Session::modifiedChanged, this, [this](bool modified) {
    setWindowModified(modified);
    if (!modified && autosave_ != nullptr) autosave_->forget();
  });
  connect(&session_, &Session::plotsChanged, this, [this] {
    plots_->change_plots(preset().plots);
    session_.record(plots_->curves());
  });
  connect(&session_, &Session::bodiesChanged, this, [this] {
    plots_->set_bodies(session_.bodies());
    session_.record(plots_->curves());
  });
}

// --- scenes
// -----------------------------------------------------------------------------------------------------------

bool LabWindow::open(const std::string& file_or_name) {
  try {
    const std::filesystem::path file = find_preset(file_or_name);
    const Preset preset = read_preset(file);
    if (!may_discard()) {
      list_->set_current(session_.name());
      return false;
    }
    const std::vector<LibraryEntry> library = preset_library();
    const bool built_in =
        std::any_of(library.begin(), library.end(), [&](const auto& e) { return e.file == file; });
    show_scene(preset, QString::fromStdString(built_in ? file.stem().string() : ""),
               built_in ? QString() : QString::fromStdString(file.string()));
    return true;
  } catch (const SceneError& error) {
    tell(this, tr("This preset cannot be opened"), tr("This preset cannot be opened."),
         QString::fromStdString(error.what()));
    list_->set_current(session_.name());
    return false;
  }
}

void LabWindow::show_scene(const Preset& preset, const QString& name, const QString& file) {
  plots_->set_plots(preset.plots, all_bodies(preset.scene));
  session_.open(preset, plots_->chosen(), plots_->curves(), name, file);
  constexpr int kSoon = 200;  // ms: a scene that is there by then flashes no notice
  QTimer::singleShot(kSoon, this, &LabWindow::show_preparing);
  view_->set_view(preset.view);
  transport_->set_duration(preset.duration);
  list_->set_current(name);
  setWindowTitle(QString("%1[*] – Carom").arg(QString::fromStdString(preset.title)));
  about_->setText(QString("<p><b>%1</b></p><p>%2</p><p>%3</p>")
                      .arg(QString::fromStdString(preset.title).toHtmlEscaped(),
                           QString::fromStdString(preset.observe).toHtmlEscaped(),
                           QString::fromStdString(preset.about).toHtmlEscaped().replace("\n", "<br>")));
  study_->set_scene(preset, name.isEmpty() ? QFileInfo(file).completeBaseName() : name);
  if (!preset.compare.empty()) tabs_->setCurrentWidget(compare_);
}

// A large scene takes seconds to be ready; nothing of the one before may stand for it.
void LabWindow::show_preparing() {
  if (frame() != nullptr) return;
  view_->clear();
  time_chip_->setText("t = …");
  speed_chip_->setText(TransportBar::speed_text(session_.speed()));
  show_notices();
}

void LabWindow::choose_file() {
  const QString file =
      QFileDialog::getOpenFileName(this, tr("Open a preset"), QFileInfo(session_.file()).path(),
                                   tr("Carom presets (*.json);;All files (*)"));
  if (!file.isEmpty()) open(QFileInfo(file).absoluteFilePath().toStdString());
}

bool LabWindow::write(const QString& file) {
  try {
    session_.save(file);
    return true;
  } catch (const SceneError& error) {
    tell(this, tr("This preset cannot be saved"), QString::fromStdString(error.what()));
    return false;
  }
}

bool LabWindow::save() { return session_.file().isEmpty() ? saveAs() : write(session_.file()); }

bool LabWindow::saveAs() {
  const QString file =
      ask_for_file(tr("Save the preset"), session_.file().isEmpty() ? "experiment.json" : session_.file(),
                   tr("Carom presets (*.json)"), "json");
  return !file.isEmpty() && write(file);
}

bool LabWindow::may_discard() {
  if (!isWindowModified()) return true;
  QMessageBox box(QMessageBox::NoIcon, tr("Save the changes?"),
                  tr("This experiment was changed. Save it before it is closed?"),
                  QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, this);
  box.setDefaultButton(QMessageBox::Save);
  const int answer = box.exec();
  if (answer == QMessageBox::Save) return save();
  return answer == QMessageBox::Discard;
}

void LabWindow::closeEvent(QCloseEvent* event) {
  if (!may_discard()) return event->ignore();
  session_.forget_wait();
  setWindowModified(false);
  if (autosave_ != nullptr) autosave_->forget();
  event->accept();
}

// --- running
// ----------------------------------------------------------------------------------------------------------

void LabWindow::set_playing(bool playing) {
  // Nothing moves any more: what to do about it is said once more.
  if (playing && frame() != nullptr && frame()->lost) {
    lost_bar_->show();
    return show_notices();
  }
  session_.set_playing(playing);
}

void LabWindow::compare_usual() {
  if (!session_.compares_usual()) {
    tabs_->setCurrentWidget(compare_);
    const QSignalBlocker part_of_this_edit(plots_);
    if (session_.first_reference() != ReferenceId::kNone) plots_->set_shown("error", true);
  }
  session_.compare_usual(plots_->chosen(), plots_->curves());
}

void LabWindow::choose_step() {
  Method method = preset().method;
  bool chosen = false;
  const double ms =
      QInputDialog::getDouble(this, tr("Length of a step"), tr("h in ms, from 0.000001 to 1000:"),
                              1e3 * method.step, 1e3 * kLeastStep, 1e3 * kLargestStep, 6, &chosen);
  if (!chosen) return;
  method.step = 1e-3 * ms;
  session_.change_method(method);
}

void LabWindow::spawn(double x, double y) {
  try {
    session_.put_in(x, y);
  } catch (const SceneError& error) {
    tell(this, tr("No body can be put here"), QString::fromStdString(error.what()));
  }
}

void LabWindow::run_until(double time) {
  session_.run_until(time);
  plots_->show_now();
}

void LabWindow::show_frame() {
  const auto& frames = session_.frames();
  if (frames.empty()) return;
  const Frame& frame = *frames.front();
  const auto& recorders = session_.recorders();
  std::vector<Method> methods;
  for (const auto& each : frames) methods.push_back(each->method);
  const std::vector<QString> names = names_of(methods);
  std::vector<PlottedRun> plotted;
  for (std::size_t i = 0; i < frames.size(); ++i) plotted.push_back({recorders[i], names[i]});
  plots_->update_from(plotted);
  view_->set_frame(frames.front(), {frames.begin() + 1, frames.end()});
  transport_->update_from(frame, *recorders.front());
  QWidget* tab = tabs_->currentWidget();
  if (tab == bodies_) bodies_->update_from(frame, session_.bodies());
  if (tab == impacts_) impacts_->update_from(frame, *recorders.front());
  if (tab == ledger_) ledger_->update_from(frame);
  if (tab == reading_) reading_->update_from(plots_->runs(), plots_->contents(), plots_->marks());
  if (tab == compare_) compare_->update_from(frames);
  tabs_->setTabText(1, tr("Impacts (%1)").arg(frame.impact_count));

  time_chip_->setToolTip(tr("Simulated time\n%1 steps, %2 rejected\n%3 evaluations of a body's acceleration")
                             .arg(frame.steps)
                             .arg(frame.rejected_steps)
                             .arg(frame.evaluations));
  time_chip_->setText(QString("t = %1 s").arg(frame.time, 0, 'f', 3));
  // What was asked for, or what this machine can give if that is clearly less.
  QString speed = TransportBar::speed_text(session_.speed());
  const bool slow =
      frame.playing && frame.realised_speed > 0.0 && frame.realised_speed < 0.85 * session_.speed();
  if (slow) speed += tr(", runs at ×%1").arg(frame.realised_speed, 0, 'g', 2);
  speed_chip_->setText(speed);
  show_notices();
}

void LabWindow::show_notices() {
  const auto frame = this->frame();
  QStringList notices;
  if (frame == nullptr) notices << tr("preparing the scene …");
  if (!session_.waits().isEmpty()) notices << session_.waits();
  if (!not_kept_.isEmpty()) notices << not_kept_;
  if (session_.again()) notices << tr("the run goes there again: t = %1 s").arg(*session_.again(), 0, 'f', 1);
  show_lost();
  // The bar says it whole.
  const bool said = frame != nullptr && frame->lost && lost_bar_->isVisibleTo(this);
  if (frame != nullptr && frame->status != "ok" && !said) notices << QString::fromStdString(frame->status);
  for (const auto& each : session_.frames()) {
    if (each->rows_known_until < each->time) {
      notices << tr("going through the run again: t = %1 s").arg(each->rows_known_until, 0, 'f', 1);
    } else if (!each->lost && each->time + each->method.step <= frame->time) {
      notices << tr("another method catches up: t = %1 s").arg(each->time, 0, 'f', 1);
    }
  }
  status_ = notices.join("; ");
  status_chip_->setVisible(!status_.isEmpty());
  status_chip_->setToolTip(plain_tip(status_));
  place_chips();
}

// Said once for each loss, so that a bar that was dismissed stays away.
void LabWindow::show_lost() {
  const Frame* lost = session_.lost();
  const QString why = lost == nullptr ? QString() : QString::fromStdString(*lost->lost);
  if (why == lost_) return;
  lost_ = why;
  if (why.isEmpty()) return lost_bar_->hide();
  lost_bar_->say(session_.frames().size() > 1 ? tr("A run is %1").arg(why) : tr("The run is %1").arg(why),
                 tr("Restart"), tr("Dismiss"));
}

void LabWindow::show_method() {
  const Method m = preset().method;
  const auto set = [](QToolButton* button, std::string_view s) {
    button->setText(QString::fromUtf8(s.data(), static_cast<qsizetype>(s.size())) + QStringLiteral(" ▾"));
  };
  const IntegratorChoice& integrator = choice_of(kIntegrators, m.integrator);
  const auto& impacts = choice_of(kImpacts, m.impacts);
  const auto& contacts = choice_of(kContacts, m.contacts);
  set(integrator_button_, integrator.label);
  set(impacts_button_, impacts.label);
  set(contacts_button_, contacts.label);
  const bool adaptive = integrator.adaptive;
  const bool exact = integrator.order == 0;
  const QString step = QString("%1 ms ▾").arg(1e3 * m.step, 0, 'g', 4);
  step_button_->setText(adaptive ? tr("tolerance %1 ▾").arg(short_figure(m.tolerance))
                        : exact  ? tr("results every %1").arg(step)
                                 : "h = " + step);
  step_button_->setToolTip(
      adaptive ? tr("Largest error of a step, in m and m/s; holds from now on")
      : exact  ? tr("Exact flight needs no step: this is only the interval of the results; holds from now on")
               : tr("Length of a step; holds from now on"));
  step_button_->setMenu(adaptive ? tolerances_ : steps_);
  tolerances_->menuAction()->setEnabled(adaptive);

  // In a narrow window names stand for labels, and of the integrator's what fits.
  const auto missing = [this] { return tool_bar_->sizeHint().width() - tool_bar_->width(); };
  if (missing() <= 0) return;
  set(impacts_button_, impacts.name);
  set(contacts_button_, contacts.name);
  if (const int more = missing(); more > 0) {
    const QFontMetrics metrics = integrator_button_->fontMetrics();
    const QString text = integrator_button_->text();
    integrator_button_->setText(
        metrics.elidedText(text, Qt::ElideMiddle, metrics.horizontalAdvance(text) - more));
  }
}

void LabWindow::show_needs() {
  const Preset& preset = this->preset();
  const NeedsText text = text_of(needs_of(preset.scene), preset.scene, preset.method.contacts);
  const auto joined = [](const std::vector<std::string>& parts) {
    QStringList list;
    for (const std::string& part : parts) list << QString::fromStdString(part);
    return list.isEmpty() ? tr("nothing") : list.join(", ");
  };
  needs_ = tr("modelled: %1 · not needed: %2").arg(joined(text.modelled), joined(text.not_needed));
  needs_chip_->setToolTip(plain_tip(
      tr("Modelled: %1.\nNot needed by this scene: %2.").arg(joined(text.modelled), joined(text.not_needed))));
  ledger_->set_scene(preset);
  study_->edit_scene(preset);
  compare_->set_scene(preset, session_.reference());
  for (QAction* action : integrators_->actions()) {
    const auto id = static_cast<IntegratorId>(action->data().toInt());
    const std::optional<std::string> reason = why_not(preset.scene, id);
    const std::string_view tip = choice_of(kIntegrators, id).tip;
    action->setEnabled(!reason);
    action->setToolTip(plain_tip(reason ? QString::fromStdString(*reason)
                                        : QString::fromUtf8(tip.data(), static_cast<qsizetype>(tip.size()))));
  }
  place_chips();
}

}  // namespace carom
