#include <QApplication>
#include <QLocale>

#include "app/lab/autosave.h"
#include "app/lab/lab_window.h"
#include "app/lab/notice_bar.h"
#include "physics/preset/preset.h"
#include "physics/scene/validate.h"
#include "widgets/plot/plot_panel.h"
#include "widgets/scene/scene_view.h"

// Unsaved work in the lab's window: kept while it goes on, offered after an end that nobody wanted.
namespace carom {
namespace {

constexpr int kKeepPeriod = 5000;  // ms: half of what a crash may cost

QString time_text(const QDateTime& time) {
  const QLocale locale;
  const QString clock = time.toString("HH:mm");
  return time.date() == QDate::currentDate() ? clock : locale.toString(time.date(), "d MMMM") + ", " + clock;
}

}  // namespace

void LabWindow::keep_work(const QString& folder) {
  autosave_ = std::make_unique<Autosave>(folder);
  connect(&keeping_, &QTimer::timeout, this, &LabWindow::keep_now);
  keeping_.start(kKeepPeriod);
  offered_ = kept_work(folder);
  offer_work();
}

void LabWindow::keep_now() {
  if (autosave_ == nullptr || !isWindowModified() || session_.revision() == kept_) return;
  try {
    Preset work = preset();
    if (const std::optional<View> view = view_->moved_view()) work.view = view;
    autosave_->keep(work);
    kept_ = session_.revision();
    not_kept_.clear();
  } catch (const SceneError& error) {
    not_kept_ = tr("Unsaved work is not kept: %1").arg(QString::fromStdString(error.what()));
  }
  show_notices();
}

// One after the other; what cannot be read is told and set aside.
void LabWindow::offer_work() {
  if (offered_.empty()) return restore_bar_->hide();
  const KeptWork& work = offered_.front();
  const QString time = time_text(work.time());
  try {
    restore_bar_->say(tr("Carom ended unexpectedly. The work of %1 on “%2” can be brought back.")
                          .arg(time, QString::fromStdString(work.preset().title)),
                      tr("Restore"), tr("Discard"));
  } catch (const SceneError& error) {
    restore_bar_->say(tr("Carom ended unexpectedly. The work of %1 cannot be brought back: %2")
                          .arg(time, QString::fromStdString(error.what())),
                      {}, tr("OK"));
    offered_.front().set_aside();
  }
}

void LabWindow::restore_work() {
  if (offered_.empty()) return;
  try {
    const Preset work = offered_.front().preset();
    if (!may_discard()) return;
    show_scene(work, {}, {});
    session_.mark_modified();
    keep_now();
    // It goes when it is kept as this window's own.
    if (not_kept_.isEmpty()) offered_.front().remove();
    offered_.erase(offered_.begin());
  } catch (const SceneError&) {
    // What could be read a moment ago: offer_work() tells.
  }
  offer_work();
}

void LabWindow::discard_work() {
  if (offered_.empty()) return;
  offered_.front().remove();
  offered_.erase(offered_.begin());
  offer_work();
}

}  // namespace carom
