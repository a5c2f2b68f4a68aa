#include "app/lab/lab_window.h"

#include <QAction>
#include <QApplication>
#include <QCloseEvent>
#include <QElapsedTimer>
#include <QFileDialog>
#include <QFileInfo>
#include <QInputDialog>
#include <QLabel>
#include <QMenu>
#include <QMessageBox>
#include <QRandomGenerator>
#include <QStringList>
#include <QTabWidget>
#include <QThread>
#include <QToolBar>
#include <QToolButton>
#include <algorithm>
#include <cmath>

#include "app/lab/notice_bar.h"
#include "app/lab/preset_library.h"
#include "physics/dynamics/integrators/integrators.h"
#include "physics/model/needs.h"
#include "physics/preset/preset.h"
#include "physics/preset/preset_file.h"
#include "physics/preset/validate_preset.h"
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
#include "widgets/theme/number_text.h"
#include "widgets/theme/plain_text.h"

// The layout of the window is in lab_layout.cpp; here is what it does.
namespace carom {

LabWindow::LabWindow(const Theme& theme) : theme_(theme) {
  keep_messages_plain();
  Preset empty;
  empty.title = "Empty scene";
  worker_ = std::make_unique<Worker>(empty);
  make_actions();
  make_body();
  make_menus();
  make_tool_bar();
  fill_library();
  setMinimumSize(900, 600);  // below it the tool bar is cut
  resize(1280, 800);
  view_->setFocus();  // so that the keys of the scene work at once
  connect(&timer_, &QTimer::timeout, this, &LabWindow::poll);
  timer_.start(16);
}

// What goes, piece by piece, tells the window nothing any more.
LabWindow::~LabWindow() {
  hide();
  for (const QObject* child : findChildren<QObject*>()) child->disconnect(this);
}

// --- scenes
// -----------------------------------------------------------------------------------------------------------

bool LabWindow::open(const std::string& file_or_name) {
  try {
    const std::filesystem::path file = find_preset(file_or_name);
    const Preset preset = read_preset(file);
    if (!may_discard()) {
      list_->set_current(name_);
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
    list_->set_current(name_);
    return false;
  }
}

void LabWindow::show_scene(const Preset& preset, const QString& name, const QString& file) {
  plots_->set_plots(preset.plots, all_bodies(preset.scene));
  forget_wait();
  name_ = name;
  file_ = file;
  before_ = all_bodies(preset.scene);
  duration_ = preset.duration;
  recorders_.clear();
  frames_.clear();
  frame_.reset();
  before_usual_.reset();
  reference_ = preset.compare.empty() ? ReferenceId::kNone : usual_reference(setup_of(preset));
  worker_->load(preset, plots_->curves(), reference_);
  constexpr int kSoon = 200;  // ms: a scene that is there by then flashes no notice
  QTimer::singleShot(kSoon, this, &LabWindow::show_preparing);
  view_->set_view(preset.view);
  transport_->set_duration(duration_);
  list_->set_current(name);
  setWindowTitle(QString("%1[*] – Carom").arg(QString::fromStdString(preset.title)));
  about_->setText(QString("<p><b>%1</b></p><p>%2</p><p>%3</p>")
                      .arg(QString::fromStdString(preset.title).toHtmlEscaped(),
                           QString::fromStdString(preset.observe).toHtmlEscaped(),
                           QString::fromStdString(preset.about).toHtmlEscaped().replace("\n", "<br>")));
  study_->set_scene(preset, name.isEmpty() ? QFileInfo(file).completeBaseName() : name);
  if (!preset.compare.empty()) tabs_->setCurrentWidget(compare_);
  mark_changed(false);
  show_method();
  show_needs();
}

// A large scene takes seconds to be ready; nothing of the one before may stand for it.
void LabWindow::show_preparing() {
  if (frame_ != nullptr) return;
  view_->clear();
  time_chip_->setText("t = …");
  speed_chip_->setText(TransportBar::speed_text(speed_));
  show_notices();
}

Preset LabWindow::preset() const {
  Preset preset = worker_->preset();
  preset.plots = plots_->chosen();
  return preset;
}

void LabWindow::choose_file() {
  const QString file = QFileDialog::getOpenFileName(this, tr("Open a preset"), QFileInfo(file_).path(),
                                                    tr("Carom presets (*.json);;All files (*)"));
  if (!file.isEmpty()) open(QFileInfo(file).absoluteFilePath().toStdString());
}

bool LabWindow::write(const QString& file) {
  try {
    save_preset(preset(), file.toStdString());
  } catch (const SceneError& error) {
    tell(this, tr("This preset cannot be saved"), QString::fromStdString(error.what()));
    return false;
  }
  file_ = file;
  mark_changed(false);
  return true;
}

bool LabWindow::save() { return file_.isEmpty() ? saveAs() : write(file_); }

bool LabWindow::saveAs() {
  const QString file = ask_for_file(tr("Save the preset"), file_.isEmpty() ? "experiment.json" : file_,
                                    tr("Carom presets (*.json)"), "json");
  return !file.isEmpty() && write(file);
}

void LabWindow::mark_changed(bool changed) {
  setWindowModified(changed);
  if (changed) ++edits_;
  if (!changed && autosave_ != nullptr) autosave_->forget();
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
  forget_wait();
  mark_changed(false);
  event->accept();
}

// --- running
// ----------------------------------------------------------------------------------------------------------

void LabWindow::set_playing(bool playing) {
  if (playing) forget_wait();
  // Nothing moves any more: what to do about it is said once more.
  if (playing && frame_ != nullptr && frame_->lost) {
    lost_bar_->show();
    return show_notices();
  }
  // Play stops at the experiment's end; pressed again there, it goes on.
  worker_->set_playing(playing, duration_);
}

void LabWindow::restart() {
  forget_wait();
  worker_->restart();
}

void LabWindow::when_still(const QString& what, std::function<void()> then) {
  set_playing(false);
  forget_wait();
  if (!frame_->playing) return then();
  then_ = std::move(then);
  waits_ = what;
  show_notices();
}

// Not from within what told of the frame.
void LabWindow::go_on() {
  QTimer::singleShot(0, this, std::exchange(then_, nullptr));
  forget_wait();
}

void LabWindow::forget_wait() {
  then_ = nullptr;
  if (waits_.isEmpty()) return;
  waits_.clear();
  show_notices();
}

void LabWindow::change_method(const Method& method, std::size_t run) {
  worker_->set_method(method, run);
  mark_changed(true);
  show_method();
  show_needs();
}

void LabWindow::choose_step() {
  Method method = worker_->preset().method;
  bool chosen = false;
  const double ms =
      QInputDialog::getDouble(this, tr("Length of a step"), tr("h in ms, from 0.000001 to 1000:"),
                              1e3 * method.step, 1e3 * kLeastStep, 1e3 * kLargestStep, 6, &chosen);
  if (!chosen) return;
  method.step = 1e-3 * ms;
  change_method(method);
}

void LabWindow::spawn(double x, double y) {
  Preset preset = worker_->preset();
  // A disc like those that are there, between half and one and a half times their radius; in a scene without
  // any, a twentieth of the view.
  Body body;
  double radius = preset.view ? preset.view->width / 20.0 : 0.1;
  body.density = 1.0;
  for (const Body& b : before_) {
    const auto* disc = std::get_if<Disc>(&b.shape);
    if (is_immovable(b) || disc == nullptr || disc->radius == 0.0) continue;
    radius = disc->radius;
    body.density = mass_of(b) / area(b.shape);
    body.material = b.material;
    break;
  }
  body.name = free_body_name(preset.scene, "new");
  body.shape = Disc{radius * (0.5 + QRandomGenerator::global()->generateDouble())};
  body.position = {x, y};
  preset.scene.bodies.push_back(body);
  try {
    validate(preset);
  } catch (const SceneError& error) {
    return tell(this, tr("No body can be put here"), QString::fromStdString(error.what()));
  }
  worker_->add_body(body);
  before_.push_back(body);
  plots_->set_bodies(before_);
  mark_changed(true);
  show_needs();
}

void LabWindow::run_until(double time) {
  worker_->run_until(time);
  const double step = worker_->preset().method.step;
  QElapsedTimer shown;
  shown.start();
  // Until the worker has stopped at the time; the first frames may still be of the moment before.
  const auto lost = [this] {
    return std::any_of(frames_.begin(), frames_.end(),
                       [](const auto& frame) { return frame->lost.has_value(); });
  };
  while (frame_ == nullptr || frame_->playing || (frame_->time < time - (1.0 + 1e-9) * step && !lost())) {
    QThread::msleep(2);
    poll();
    QApplication::processEvents();
  }
  plots_->show_now();
}

void LabWindow::poll() {
  const std::vector<std::shared_ptr<const Frame>> news = worker_->take_frames();
  if (news.empty()) return;
  // Each run keeps its recorder, whatever runs were put in or taken out before it.
  std::vector<std::shared_ptr<Recorder>> recorders;
  for (const auto& frame : news) {
    const auto own = std::find_if(recorders_.begin(), recorders_.end(),
                                  [&](const auto& recorder) { return recorder->run() == frame->run; });
    recorders.push_back(own == recorders_.end() ? std::make_shared<Recorder>() : *own);
    recorders.back()->add(*frame);
  }
  recorders_ = std::move(recorders);
  frames_ = news;
  frame_ = news.front();
  show_frame();
  if (then_ != nullptr && !frame_->playing) go_on();
}

void LabWindow::show_frame() {
  const Recorder& recorder = *recorders_.front();
  follow_bodies();
  show_compared();
  transport_->update_from(*frame_, recorder);
  QWidget* tab = tabs_->currentWidget();
  if (tab == bodies_) bodies_->update_from(*frame_, before_);
  if (tab == impacts_) impacts_->update_from(*frame_, recorder);
  if (tab == ledger_) ledger_->update_from(*frame_);
  if (tab == reading_) reading_->update_from(plots_->runs(), plots_->contents(), plots_->marks());
  if (tab == compare_) compare_->update_from(frames_);
  tabs_->setTabText(1, tr("Impacts (%1)").arg(frame_->impact_count));

  time_chip_->setToolTip(tr("Simulated time\n%1 steps, %2 rejected\n%3 evaluations of a body's acceleration")
                             .arg(frame_->steps)
                             .arg(frame_->rejected_steps)
                             .arg(frame_->evaluations));
  time_chip_->setText(QString("t = %1 s").arg(frame_->time, 0, 'f', 3));
  // What was asked for, or what this machine can give if that is clearly less.
  QString speed = TransportBar::speed_text(speed_);
  const bool slow = frame_->playing && frame_->realised_speed > 0.0 && frame_->realised_speed < 0.85 * speed_;
  if (slow) speed += tr(", runs at ×%1").arg(frame_->realised_speed, 0, 'g', 2);
  speed_chip_->setText(speed);
  show_notices();
}

// They come in the order of their times, which is another where one was put in before another that is still to
// come: plots know bodies by their place.
void LabWindow::follow_bodies() {
  if (frame_->bodies == bodies_shown_) return;
  bodies_shown_ = frame_->bodies;
  const std::vector<Body>& now = *bodies_shown_;
  const auto same_name = [](const Body& a, const Body& b) { return a.name == b.name; };
  if (now.size() <= before_.size() && std::equal(now.begin(), now.end(), before_.begin(), same_name)) return;
  auto next = before_.begin();
  for (const Body& body : now) {
    const auto at = std::find_if(next, before_.end(), [&](const Body& b) { return b.name == body.name; });
    if (at == before_.end()) continue;
    std::rotate(next, at, at + 1);
    ++next;
  }
  plots_->set_plots(plots_->chosen(), before_);
  worker_->record(plots_->curves());
}

void LabWindow::show_notices() {
  QStringList notices;
  if (frame_ == nullptr) notices << tr("preparing the scene …");
  if (!waits_.isEmpty()) notices << waits_;
  if (!not_kept_.isEmpty()) notices << not_kept_;
  show_lost();
  // The bar says it whole.
  const bool said = frame_ != nullptr && frame_->lost && lost_bar_->isVisibleTo(this);
  if (frame_ != nullptr && frame_->status != "ok" && !said) notices << QString::fromStdString(frame_->status);
  for (const auto& frame : frames_) {
    if (frame->rows_known_until < frame->time) {
      notices << tr("going through the run again: t = %1 s").arg(frame->rows_known_until, 0, 'f', 1);
    } else if (!frame->lost && frame->time + frame->method.step <= frame_->time) {
      notices << tr("another method catches up: t = %1 s").arg(frame->time, 0, 'f', 1);
    }
  }
  status_ = notices.join("; ");
  status_chip_->setVisible(!status_.isEmpty());
  status_chip_->setToolTip(plain_tip(status_));
  place_chips();
}

// Said once for each loss, so that a bar that was dismissed stays away.
void LabWindow::show_lost() {
  const auto lost =
      std::find_if(frames_.begin(), frames_.end(), [](const auto& frame) { return frame->lost.has_value(); });
  const QString why = lost == frames_.end() ? QString() : QString::fromStdString(*(*lost)->lost);
  if (why == lost_) return;
  lost_ = why;
  if (why.isEmpty()) return lost_bar_->hide();
  lost_bar_->say(frames_.size() > 1 ? tr("A run is %1").arg(why) : tr("The run is %1").arg(why), tr("Restart"),
                 tr("Dismiss"));
}

void LabWindow::show_method() {
  const Method m = worker_->preset().method;
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
  const Preset preset = worker_->preset();
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
  compare_->set_scene(preset, reference_);
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
