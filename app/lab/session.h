#pragma once

#include <QObject>
#include <QRandomGenerator>
#include <QUndoStack>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/lab/document_change.h"
#include "app/lab/document_edit.h"
#include "app/lab/lab_runs.h"
#include "physics/preset/preset.h"

namespace carom {

// The work of the lab: a document and its runs. Every change of the document is an edit that can be undone. An
// edit is in document() at once; the runs follow.
class Session : public QObject {
  Q_OBJECT

 public:
  explicit Session(QObject* parent = nullptr);
  ~Session() override { edits_.disconnect(this); }

  // Sets another document, at t = 0, with its visible plots and the curves that they need. `name` is that of a
  // built-in experiment, `file` the target of save(); both may be empty. Clears the undo stack.
  void open(const Preset& preset, const std::vector<Plot>& plots, const std::vector<Curve>& curves,
            const QString& name, const QString& file);
  // The document as save() would write it now.
  [[nodiscard]] const Preset& document() const { return document_.preset; }
  [[nodiscard]] const QString& name() const { return name_; }
  [[nodiscard]] const QString& file() const { return file_; }
  [[nodiscard]] ReferenceId reference() const { return document_.reference; }
  [[nodiscard]] const StartOrigin& start() const { return document_.start; }
  // All bodies as they start, in the order of the runs.
  [[nodiscard]] const std::vector<Body>& bodies() const { return bodies_; }
  // Throws SceneError if the file can't be written; the document stays unchanged.
  void save(const QString& file);

  // Whether there is unsaved work.
  [[nodiscard]] bool modified() const;
  [[nodiscard]] std::uint64_t revision() const { return revision_; }  // changes with each edit
  [[nodiscard]] QUndoStack& edits() { return edits_; }

  // --- edits
  // Changes a method from now on, of one or several runs. Changes of one `drag` are undone together.
  void change_method(const Method& method, std::size_t run = 0);
  void change_step(double step, const std::vector<std::size_t>& runs, int drag);
  // Adds a method, or replaces the last one if there are too many.
  void add_method(const Method& method);
  void remove_method(std::size_t run);
  void choose_reference(ReferenceId reference);
  // Restarts under the method of the reference, explicit Euler and RK4; or returns to the earlier comparison.
  // Shows `plots` then.
  void compare_usual(const std::vector<Plot>& plots, const std::vector<Curve>& curves);
  [[nodiscard]] bool compares_usual() const { return document_.before_usual.has_value(); }
  // Edits the scene. At the start, and where an edit is about motion, the runs begin anew: later from the shown
  // moment, which becomes the start; undo returns to that moment of the run. Other edits hold in the runs from
  // the shown moment on, and in the start. Bodies are replaced as they stand in the frame's scene. Edits of one
  // `drag` (> 0) are undone together. A playing run is paused first. Nothing changes where the scene would not
  // be valid (editRefused).
  void edit(const SceneEdits& edits, const QString& text, int drag = 0);
  // The names of the bodies that are selected now: undo of a later edit of the scene asks for them again.
  void set_selection(const std::vector<std::string>& names) { selection_ = names; }
  // Takes back the edits of a drag that is not finished, if they are the last ones.
  void cancel(int drag);
  // Adds a disc of random radius like the existing ones at this point (m), from now on. Throws SceneError where
  // it is not allowed in a run. Returns its name; none if it was refused (editRefused).
  std::string add_body(double x, double y);
  void change_plots(const std::vector<Plot>& plots);
  // Nothing changes where they are not allowed (editRefused).
  void change_stops(const std::vector<Stop>& stops, const QString& text);
  // Where a moment of the past is shown, the runs go on from there: what came later is gone, until that is
  // undone. All other edits of a run there do this first.
  void go_on_from_here();

  // --- runs and starts (session_starts.cpp)
  // Plays or pauses; from the end of the run again from the start. A run is one step of undo, entered here
  // where the last step is none: taken back, the runs stand where they stood before.
  void set_playing(bool playing);
  void play_on();  // without an end
  // Ends the run and stops at the start, as one step of undo.
  void restart();
  // A start since the document was opened. Each but the present one is gone to as one step of undo.
  struct KnownStart {
    QString name;
    std::shared_ptr<const Start> start;  // none: the present one
  };
  // The first one, as opened or saved, stands first.
  [[nodiscard]] std::vector<KnownStart> starts() const;
  void go_to(const KnownStart& known);
  void go_to_first_start();
  // Takes the newest start back, and makes its edit in the start before it instead; editRefused says why not.
  void put_into_start_before();

  // --- the runs
  [[nodiscard]] LabRuns& runs() { return runs_; }
  [[nodiscard]] const LabRuns& runs() const { return runs_; }

 signals:
  void documentChanged();
  void bodiesChanged();  // of the document, with its plots
  void plotsChanged();   // of the document
  void editRefused(const QString& why);
  void selectionReturned(const std::vector<std::string>& names);
  void modifiedChanged(bool modified);

 private:
  friend class DocumentEdit;
  // Undo and redo of an edit; each returns the change that does the opposite.
  DocumentChange take_back(const DocumentChange& change, const DocumentEdit::What& what);
  DocumentChange make_again(const DocumentChange& change, const DocumentEdit::What& what);
  DocumentChange go_to(const DocumentChange& change, const DocumentEdit::What& what);
  void push(const DocumentEdit::What& what, const DocumentChange& change);
  // `begins`: the runs begin anew with it.
  DocumentChange assign(const DocumentChange& change, bool begins);
  [[nodiscard]] Worker::EditId edit_runs(const SceneEdits& edits, const DocumentChange& change, int drag,
                                         Worker::EditId part_of);
  [[nodiscard]] bool may_edit_moment();
  [[nodiscard]] std::vector<RunEdit> edits_left() const;
  void cut_at_shown(DocumentEdit::What& what);
  [[nodiscard]] const DocumentEdit* last_edit() const;
  void take_times_of_edits();
  void check_modified();
  void enter_run();
  void leave_start(const QString& text, const Start& start);
  [[nodiscard]] bool goes_on_with_new_start(int drag) const;
  void name_new_start(double time, const SceneEdits& edits, const QString& by, DocumentChange& change,
                      DocumentEdit::What& what);
  [[nodiscard]] int newest_start_edit() const;
  [[nodiscard]] Document before_edit(int place) const;
  [[nodiscard]] const DocumentEdit& edit_at(int place) const;

  Document document_;
  std::shared_ptr<const Start> first_start_;
  LabRuns runs_;
  QRandomGenerator sizes_{1};  // of the discs that are added: the same in every session
  QString name_, file_;
  std::vector<Body> bodies_;
  std::vector<std::string> selection_;
  QUndoStack edits_;
  bool was_modified_ = false;
  std::uint64_t revision_ = 0;
};

}  // namespace carom
