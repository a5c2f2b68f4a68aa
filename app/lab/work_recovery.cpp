#include "app/lab/work_recovery.h"

#include <QFileInfo>
#include <QLocale>

#include "app/lab/notice_bar.h"
#include "app/lab/session.h"
#include "physics/scene/validate.h"

namespace carom {
namespace {

constexpr int kKeepPeriod = 5000;  // ms: half of the work that a crash may lose

QString time_text(const QDateTime& time) {
  const QString clock = time.toString("HH:mm");
  return time.date() == QDate::currentDate() ? clock : QLocale().toString(time.date(), "d MMMM") + ", " + clock;
}

}  // namespace

WorkRecovery::WorkRecovery(Session& session, NoticeBar& bar, std::function<std::optional<View>()> view,
                           QObject* parent)
    : QObject(parent), session_(session), bar_(bar), view_(std::move(view)) {
  connect(&bar, &NoticeBar::accepted, this, &WorkRecovery::restore);
  connect(&bar, &NoticeBar::dismissed, this, &WorkRecovery::discard);
  connect(&timer_, &QTimer::timeout, this, &WorkRecovery::keep_now);
  connect(&session, &Session::modifiedChanged, this, [this](bool modified) {
    if (!modified && autosave_) autosave_->forget();
  });
}

void WorkRecovery::begin(const QString& folder) {
  autosave_.emplace(folder);
  timer_.start(kKeepPeriod);
  offered_ = kept_work(folder);
  offer();
}

void WorkRecovery::end() {
  timer_.stop();
  autosave_.reset();
}

void WorkRecovery::keep_now() {
  if (!autosave_ || !session_.modified() || session_.history().revision() == kept_) return;
  try {
    Preset work = session_.document();
    if (const std::optional<View> view = view_()) work.view = view;
    autosave_->keep(work, session_.starts().kept(), {session_.name(), session_.file()});
    kept_ = session_.history().revision();
    not_kept_.clear();
  } catch (const SceneError& error) {
    not_kept_ = tr("Unsaved work is not kept: %1").arg(QString::fromStdString(error.what()));
  }
  emit keptChanged();
}

// One after the other; unreadable work is reported and set aside.
void WorkRecovery::offer() {
  if (offered_.empty()) return bar_.hide();
  const KeptWork& work = offered_.front();
  const QString time = time_text(work.time());
  try {
    QString said = tr("Carom ended unexpectedly. The work of %1 on “%2” can be brought back.")
                       .arg(time, QString::fromStdString(work.preset().title));
    if (work.file_changed()) {
      said += " " + tr("%1 was changed since by another program: the work will be saved under a new name.")
                        .arg(QFileInfo(work.source().file).fileName());
    }
    bar_.say(said, tr("Restore"), tr("Discard"));
  } catch (const SceneError& error) {
    bar_.say(tr("Carom ended unexpectedly. The work of %1 cannot be brought back: %2")
                 .arg(time, QString::fromStdString(error.what())),
             {}, tr("OK"));
    offered_.front().set_aside();
  }
}

void WorkRecovery::restore() {
  if (offered_.empty()) return;
  try {
    const KeptWork& work = offered_.front();
    WorkSource source = work.source();
    if (work.file_changed()) source.file.clear();
    emit restoreAsked(work.preset(), work.starts(), source);
  } catch (const SceneError&) {
    offer();  // it was readable before: reports it now
  }
}

void WorkRecovery::restored() {
  keep_now();
  // It is removed when this window has kept it as its own.
  if (not_kept_.isEmpty()) offered_.front().remove();
  offered_.erase(offered_.begin());
  offer();
}

void WorkRecovery::discard() {
  if (offered_.empty()) return;
  offered_.front().remove();
  offered_.erase(offered_.begin());
  offer();
}

}  // namespace carom
