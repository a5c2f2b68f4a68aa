#pragma once

#include <QObject>
#include <QTimer>
#include <QUndoStack>
#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "app/lab/edits.h"
#include "physics/preset/preset.h"
#include "physics/record/recorder.h"
#include "physics/session/worker.h"

namespace carom {

// What the lab works on: a document, its runs side by side on a thread of their own, and what is recorded of
// them. Every change of the document is an edit that can be undone. An edit holds in document() at once; the
// runs follow when their thread gets to it, and their frames come by a timer.
class Session : public QObject {
  Q_OBJECT

 public:
  explicit Session(QObject* parent = nullptr);
  ~Session() override { edits_.disconnect(this); }

  // Another document, at t = 0, with the plots that are shown of it and the curves that they need. `name` is
  // that of a built-in experiment, `file` where save() would write; both may be empty. Nothing can be undone.
  void open(const Preset& preset, const std::vector<Plot>& plots, const std::vector<Curve>& curves,
            const QString& name, const QString& file);
  // As it would be saved now.
  [[nodiscard]] const Preset& document() const { return document_; }
  [[nodiscard]] const QString& name() const { return name_; }
  [[nodiscard]] const QString& file() const { return file_; }
  [[nodiscard]] ReferenceId reference() const { return reference_; }
  // All bodies as they came in, in the order that the runs have them.
  [[nodiscard]] const std::vector<Body>& bodies() const { return bodies_; }
  // Throws SceneError if the file can't be written; the document stays what it is.
  void save(const QString& file);

  // There is work that is not saved.
  [[nodiscard]] bool modified() const;
  void mark_modified() { edits_.resetClean(); }                       // whatever is undone
  [[nodiscard]] std::uint64_t revision() const { return revision_; }  // another one after each edit
  [[nodiscard]] QUndoStack& edits() { return edits_; }

  // --- edits
  // From now on. Of several runs: those of one `drag` are undone as one.
  void change_method(const Method& method, std::size_t run = 0);
  void change_step(double step, const std::vector<std::size_t>& runs, int drag);
  // In the place of the last one if there are as many as there may be.
  void add_method(const Method& method);
  // Unless it is among the methods already.
  void compare_with(const Method& method);
  void remove_method(std::size_t run);
  void choose_reference(ReferenceId reference);
  // From the start under the method of the reference, explicit Euler and RK4; or back to what was compared
  // before. `plots` are shown then.
  void compare_usual(const std::vector<Plot>& plots, const std::vector<Curve>& curves);
  [[nodiscard]] bool compares_usual() const { return before_usual_.has_value(); }
  // The best reference that the scene allows; none where it would cost much unasked.
  [[nodiscard]] ReferenceId first_reference() const;
  // A disc of random radius like those that are there, at this point (m). Throws SceneError where it can't be.
  void put_in(double x, double y);
  void change_plots(const std::vector<Plot>& plots);

  // --- the runs
  void set_playing(bool playing);  // stops at the document's duration; beyond it there is no end
  void restart();
  void step_once() { worker_.step_once(); }
  void set_speed(double speed);
  [[nodiscard]] double speed() const { return speed_; }
  // Runs on to `time` as fast as it goes; returns when it is there, or a run is lost before.
  void run_until(double time);
  void record(const std::vector<Curve>& curves);
  // The newest of each run, the document's own method first; none until the scene is ready.
  [[nodiscard]] const std::vector<std::shared_ptr<const Frame>>& frames() const { return frames_; }
  [[nodiscard]] std::shared_ptr<const Frame> frame() const {
    return frames_.empty() ? nullptr : frames_.front();
  }
  [[nodiscard]] const std::vector<std::shared_ptr<Recorder>>& recorders() const { return recorders_; }
  [[nodiscard]] const Frame* lost() const;  // a run that can't go on
  // s: how far the runs have come again that an undone edit made anew. What was before is shown meanwhile.
  [[nodiscard]] std::optional<double> again() const { return again_; }
  // Stops the run, and goes on with `then` when the newest moment has come. Whatever makes the run another one
  // or goes on with it forgets `then`. `what` is told meanwhile.
  void when_still(const QString& what, std::function<void()> then);
  void forget_wait();
  [[nodiscard]] const QString& waits() const { return waits_; }

 signals:
  void documentChanged();
  void bodiesChanged();  // there are others now, or in another order
  void plotsChanged();   // of the document
  void modifiedChanged(bool modified);
  void framesChanged();
  void noticesChanged();

 private:
  friend class DocumentEdit;
  void take_back(const Edited& before, Worker::EditId runs);
  void put_back(const Edited& after, Worker::EditId runs);

  [[nodiscard]] Edited edited() const;
  void push(const DocumentEdit::What& what, const Edited& after);
  void assign(const Edited& to);
  void assign_bodies(const std::vector<Body>& put_in);
  void follow_bodies();
  void poll();
  void check_modified();

  Worker worker_;
  Preset document_;
  std::size_t own_bodies_ = 0;  // of the document's list: the others were put in
  QString name_, file_;
  ReferenceId reference_ = ReferenceId::kNone;
  std::optional<Methods> before_usual_;
  std::vector<Body> bodies_;
  std::shared_ptr<const std::vector<Body>> followed_;  // their order is that of bodies_
  QUndoStack edits_;
  bool was_modified_ = false;
  std::uint64_t revision_ = 0;

  std::vector<Curve> curves_;
  std::vector<std::shared_ptr<const Frame>> frames_;
  std::vector<std::shared_ptr<Recorder>> recorders_;
  std::vector<std::shared_ptr<Recorder>> arriving_;  // of runs that are not shown yet
  std::optional<double> again_;
  double speed_ = 1.0;
  std::function<void()> then_;
  QString waits_;
  QTimer timer_;
};

}  // namespace carom
