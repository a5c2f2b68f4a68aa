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

// Keeps the unsaved work of a session, with its starts, in files, at most ten seconds behind, and offers it in
// a bar after a crash.
class WorkRecovery : public QObject {
  Q_OBJECT

 public:
  // `view` is the user's view, if the camera was moved; it is kept with the work.
  WorkRecovery(Session& session, NoticeBar& bar, std::function<std::optional<View>()> view, QObject* parent);

  // Keeps work in this folder from now on, and offers work left there by closed windows.
  void begin(const QString& folder);
  void keep_now();
  // The session shows the work of restoreAsked().
  void restored();
  // Stops keeping: the work is saved or discarded.
  void end();
  // The reason why unsaved work is not kept; empty if it is kept.
  [[nodiscard]] const QString& not_kept() const { return not_kept_; }

 signals:
  void restoreAsked(const carom::Preset& work, const carom::KeptStarts& starts,
                    const carom::WorkSource& source);
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
  std::uint64_t kept_ = 0;  // the session's revision at that time
};

}  // namespace carom
