#pragma once

#include <QObject>
#include <QTimer>
#include <functional>
#include <optional>
#include <vector>

#include "app/lab/autosave.h"
#include "physics/preset/preset.h"

namespace carom {

class NoticeBar;
class Session;

// Unsaved work of a session: kept in a file while it goes on, at most ten seconds behind, and offered in a bar
// after an end that nobody wanted.
class WorkRecovery : public QObject {
  Q_OBJECT

 public:
  // `view` is where the user looks, if the camera was moved: it is kept with the work.
  WorkRecovery(Session& session, NoticeBar& bar, std::function<std::optional<View>()> view, QObject* parent);

  // From now on work is kept in this folder; what lies there of windows that ended is offered.
  void begin(const QString& folder);
  void keep_now();
  // The session shows what restoreAsked() told of.
  void restored();
  // Nothing more is kept: the work is saved, or given up.
  void end();
  // Why unsaved work is not kept; empty if it is.
  [[nodiscard]] const QString& not_kept() const { return not_kept_; }

 signals:
  void restoreAsked(const carom::Preset& work);
  void keptChanged();

 private:
  void offer();
  void restore();
  void discard();

  Session& session_;
  NoticeBar& bar_;
  std::function<std::optional<View>()> view_;
  QTimer timer_;
  std::optional<Autosave> autosave_;
  std::vector<KeptWork> offered_;  // the first one is in the bar
  QString not_kept_;
  std::uint64_t kept_ = 0;  // the session's revision then
};

}  // namespace carom
