#pragma once

#include <QObject>
#include <QRandomGenerator>
#include <QUndoStack>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/lab/edit_history.h"
#include "app/lab/hand_edits.h"
#include "app/lab/method_edits.h"
#include "app/lab/session_starts.h"
#include "physics/preset/preset.h"

namespace carom {

// The work of the lab: a document and its runs. Every change of the document is an edit that can be undone. An
// edit is in document() at once; the runs follow.
class Session : public QObject {
  Q_OBJECT

 public:
  explicit Session(QObject* parent = nullptr);
  ~Session() override { edits().disconnect(this); }

  // Sets another document, at t = 0, with its visible plots and the curves that they need. `name` is that of a
  // built-in experiment, `file` the target of save(); both may be empty. Clears the undo stack.
  void open(const Preset& preset, const std::vector<Plot>& plots, const std::vector<Curve>& curves,
            const QString& name, const QString& file);
  // The document as save() would write it now.
  [[nodiscard]] const Preset& document() const { return history_.document().preset; }
  [[nodiscard]] const QString& name() const { return name_; }
  [[nodiscard]] const QString& file() const { return file_; }
  // Throws SceneError if the file can't be written; the document stays unchanged.
  void save(const QString& file);

  // Whether there is unsaved work.
  [[nodiscard]] bool modified() const;
  // What was done, with the signals of what it changes.
  [[nodiscard]] EditHistory& history() { return history_; }
  [[nodiscard]] QUndoStack& edits() { return history_.stack(); }

  // --- edits
  // Of the methods and their reference.
  [[nodiscard]] MethodEdits& methods() { return methods_; }
  // Edits the scene. At the start, and where an edit is about motion, the runs begin anew: later from the shown
  // moment, which becomes the start; undo returns to that moment of the run. Other edits hold in the runs from
  // the shown moment on, and in the start. Bodies are replaced as they stand in the runs' shown scene. Edits of
  // one `drag` (> 0) are undone together. A run that plays is paused first where they need that. Nothing
  // changes where the scene would not be valid (EditHistory::editRefused).
  void edit(const SceneEdits& edits, const QString& text, int drag = 0);
  // Whether these edits of the shown scene wait until the runs stand still: those that are about motion or
  // remove bodies, and all of a moment of the past. Others hold in a run that plays.
  [[nodiscard]] bool needs_pause(const SceneEdits& edits);
  // Pauses the runs, and then hands over the edits as they are of the moment that is reached.
  void pause_for(const SceneEdits& edits, const QString& text,
                 const std::function<void(const SceneEdits&)>& then);
  // Takes back the edits of a drag that is not finished, if they are the last ones.
  void cancel(int drag);
  // Adds a disc at this point, from now on; without a radius one of random radius like the existing ones (m).
  // Throws SceneError where it is not allowed in a run. Returns its name; none if it was refused.
  std::string add_body(double x, double y, std::optional<double> radius = std::nullopt);
  void change_plots(const std::vector<Plot>& plots);
  // Nothing changes where they are not allowed.
  void change_stops(const std::vector<Stop>& stops, const QString& text);
  // The same of the duration (s) of the runs; `drag` as in edit().
  void change_duration(double duration, const QString& text, int drag = 0);
  // Where a moment of the past is shown, the runs go on from there: what came later is gone, until that is
  // undone. All other edits of a run there do this first.
  void go_on_from_here();

  // --- the runs
  // Pulls their bodies while they play.
  [[nodiscard]] HandEdits& hand() { return hand_; }
  // To play them, and where they start.
  [[nodiscard]] SessionStarts& starts() { return starts_; }
  [[nodiscard]] LabRuns& runs() { return history_.runs(); }
  [[nodiscard]] const LabRuns& runs() const { return history_.runs(); }

 signals:
  void modifiedChanged(bool modified);

 private:
  [[nodiscard]] Worker::EditId edit_runs(const SceneEdits& edits, const DocumentChange& change, int drag,
                                         Worker::EditId part_of);
  void check_modified();
  void push_valid(const DocumentEdit::What& what, const DocumentChange& change);
  [[nodiscard]] bool goes_on_with_new_start(int drag) const;
  void name_new_start(double time, const SceneEdits& edits, const QString& by, DocumentChange& change,
                      DocumentEdit::What& what);

  EditHistory history_;
  MethodEdits methods_{history_};
  SessionStarts starts_{history_};
  HandEdits hand_{history_};
  QRandomGenerator sizes_{1};  // of the discs that are added: the same in every session
  QString name_, file_;
  bool was_modified_ = false;
};

}  // namespace carom
