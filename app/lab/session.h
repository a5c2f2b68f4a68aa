#pragma once

#include <QObject>
#include <QRandomGenerator>
#include <QTimer>
#include <QUndoStack>
#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "app/lab/document_change.h"
#include "app/lab/document_edit.h"
#include "physics/preset/preset.h"
#include "physics/record/recorder.h"
#include "physics/worker/worker.h"

namespace carom {

// The work of the lab: a document, its runs side by side on a thread of their own, and their records. Every
// change of the document is an edit that can be undone. An edit is in document() at once; the runs follow when
// their thread gets to it, and a timer takes their frames.
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
  // All bodies as they start, in the order of the runs.
  [[nodiscard]] const std::vector<Body>& bodies() const { return bodies_; }
  // Throws SceneError if the file can't be written; the document stays unchanged.
  void save(const QString& file);

  // Whether there is unsaved work.
  [[nodiscard]] bool modified() const;
  void mark_modified() { edits_.resetClean(); }                       // whatever is undone
  [[nodiscard]] std::uint64_t revision() const { return revision_; }  // changes with each edit
  [[nodiscard]] QUndoStack& edits() { return edits_; }

  // --- edits
  // Changes a method from now on, of one or several runs. Changes of one `drag` are undone together.
  void change_method(const Method& method, std::size_t run = 0);
  void change_step(double step, const std::vector<std::size_t>& runs, int drag);
  // Adds a method, or replaces the last one if there are too many.
  void add_method(const Method& method);
  // Adds a method unless it is present already.
  void compare_with(const Method& method);
  void remove_method(std::size_t run);
  void choose_reference(ReferenceId reference);
  // Restarts under the method of the reference, explicit Euler and RK4; or returns to the earlier comparison.
  // Shows `plots` then.
  void compare_usual(const std::vector<Plot>& plots, const std::vector<Curve>& curves);
  [[nodiscard]] bool compares_usual() const { return document_.before_usual.has_value(); }
  // The best reference that the scene allows; none where it would be costly.
  [[nodiscard]] ReferenceId first_reference() const;
  // Edits the scene. At the start, and where an edit is about motion, the runs begin anew: later from the shown
  // moment, which becomes the start. Other edits hold in the runs from the shown moment on, and in the start.
  // Bodies are replaced as they stand in the frame's scene. Edits of one `drag` (> 0) are undone together.
  // A playing run is paused first. Nothing changes where the scene would not be valid (editRefused).
  void edit(const SceneEdits& edits, const QString& text, int drag = 0);
  // Takes back the edits of a drag that is not finished, if they are the last ones.
  void cancel(int drag);
  // Adds a disc of random radius like the existing ones at this point (m), from now on. Throws SceneError where
  // it is not allowed in a run.
  void add_body(double x, double y);
  void change_plots(const std::vector<Plot>& plots);

  // --- the runs
  // Stops at the document's duration; beyond it there is no end. Ends a replay where it is, and stops there.
  void set_playing(bool playing);
  void restart();
  void step_once() { worker_.step_once(); }
  void set_speed(double speed);
  [[nodiscard]] double speed() const { return speed_; }
  // Runs to `time` as fast as possible; returns when it is reached, or when a run is lost.
  void run_until(double time);
  void record(const std::vector<Curve>& curves);
  // The newest frame of each run, the document's own method first; none until the scene is ready.
  [[nodiscard]] const std::vector<std::shared_ptr<const Frame>>& frames() const { return frames_; }
  [[nodiscard]] std::shared_ptr<const Frame> frame() const {
    return frames_.empty() ? nullptr : frames_.front();
  }
  // The scene as it stands, for edits: with those that no frame has shown yet. None while a run plays.
  [[nodiscard]] const std::shared_ptr<const Scene>& scene() const { return scene_; }
  [[nodiscard]] const std::vector<std::shared_ptr<Recorder>>& recorders() const { return recorders_; }
  [[nodiscard]] const Frame* lost() const;  // a lost run, if any
  // s: progress of the runs that are recomputed after an undone edit.
  [[nodiscard]] std::optional<double> replayed() const { return replayed_; }
  // Pauses the run and calls `then` when its newest frame has arrived. Any change of the run, or playing,
  // drops `then`. `what` is shown meanwhile.
  void when_still(const QString& what, std::function<void()> then);
  void forget_wait();
  [[nodiscard]] const QString& waits() const { return waits_; }

 signals:
  void documentChanged();
  void bodiesChanged();  // of the document, with its plots
  void plotsChanged();   // of the document
  void editRefused(const QString& why);
  void modifiedChanged(bool modified);
  void framesChanged();
  void noticesChanged();

 private:
  friend class DocumentEdit;
  // Undoes or redoes an edit; returns the change that does the opposite.
  DocumentChange go_to(const DocumentChange& change, const DocumentEdit::What& what,
                       void (Worker::*runs)(Worker::EditId, const Preset& start, ReferenceId));
  void push(const DocumentEdit::What& what, const DocumentChange& change);
  DocumentChange assign(const DocumentChange& change);
  [[nodiscard]] Worker::EditId edit_runs(const SceneEdits& edits, const DocumentChange& change, int drag);
  [[nodiscard]] const DocumentEdit* last_edit() const;
  [[nodiscard]] bool at_start() const;
  void begin_runs();
  void take_times_of_edits();
  void poll();
  void check_modified();

  Worker worker_;
  Document document_;
  QRandomGenerator sizes_{1};  // of the discs that are added: the same in every session
  QString name_, file_;
  std::vector<Body> bodies_;
  QUndoStack edits_;
  bool was_modified_ = false;
  std::uint64_t revision_ = 0;

  std::vector<Curve> curves_;
  std::vector<std::shared_ptr<const Frame>> frames_;
  std::shared_ptr<const Scene> scene_;
  Worker::EditId awaited_ = 0;  // an edit of the runs that is in scene_, but in no frame yet; 0: none
  bool begins_ = false;         // the runs begin anew: the frames are from before
  bool will_begin_ = false;     // they are about to, with the curves that are chosen by then
  std::vector<std::shared_ptr<Recorder>> recorders_;
  std::optional<double> replayed_;
  double speed_ = 1.0;
  std::function<void()> then_;
  QString waits_;
  QTimer timer_;
};

}  // namespace carom
