#pragma once

#include <QObject>
#include <QString>
#include <memory>
#include <utility>
#include <vector>

#include "app/lab/edit_history.h"
#include "app/lab/kept_starts.h"

namespace carom {

// The runs of a document as steps of undo, and its starts: back to the present one, to the first, to any since
// the document was opened.
class SessionStarts : public QObject {
  Q_OBJECT

 public:
  explicit SessionStarts(EditHistory& history);

  // Plays or pauses; from the end of the run again from the start. A run is one step of undo, entered here
  // where the last step is none: taken back, the runs stand where they stood before.
  void set_playing(bool playing);
  void play_on();  // without an end
  // Steps from what is shown (LabRuns::step_by()): a new step belongs to a run.
  void step_by(int steps);
  // Ends the run and stops at the start, as one step of undo.
  void restart();

  // A start since the document was opened. Each but the present one is gone to as one step of undo.
  struct Known {
    QString name;
    std::shared_ptr<const Start> start;  // none: the present one
  };
  // The first one, as opened or saved, stands first.
  [[nodiscard]] std::vector<Known> known() const;
  void set_first(Start start) { first_ = std::make_shared<const Start>(std::move(start)); }
  // The document has another preset, which begins so.
  void begin(Start start) {
    set_first(std::move(start));
    recovered_.clear();
  }
  // They as a file holds them: the first one, the present one and the last of the others.
  [[nodiscard]] KeptStarts kept() const;
  // Those of a session that had this document.
  void recover(const KeptStarts& starts);
  void go_to(const Known& known);
  void go_to_first();
  // Takes the newest start back, and makes its edit in the start before it instead; says why not, where it
  // can't. One sentence on that; empty: nothing is known that stands against it.
  void put_into_start_before();
  [[nodiscard]] QString why_not_into_start_before() const;

 private:
  void enter_run();
  void leave(const QString& text, const Start& start);
  [[nodiscard]] int newest_start_edit() const;
  [[nodiscard]] Document before_edit(int place) const;

  EditHistory& history_;
  LabRuns& runs_;  // its
  std::shared_ptr<const Start> first_;
  std::vector<Known> recovered_;  // beside the first and the present one
};

}  // namespace carom
