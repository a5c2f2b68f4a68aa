#pragma once

#include <QObject>
#include <QTimer>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "app/lab/document_change.h"
#include "app/lab/playing_scene.h"
#include "physics/record/recorder.h"
#include "physics/worker/pace.h"
#include "physics/worker/worker.h"
#include "widgets/base/run_before.h"

namespace carom {

// The runs of a document side by side, on a thread of their own, with their records. They follow the document
// when their thread gets to it; a timer takes their frames.
class LabRuns : public QObject {
  Q_OBJECT

 public:
  // Of this document, which a session changes. Before load() nothing runs.
  explicit LabRuns(const Document& document);

  // --- the clock
  // Stops at the document's duration. Ends a replay where it is, and stops there.
  void set_playing(bool playing);
  void play_on();  // without an end
  void restart();
  void set_speed(double speed);
  [[nodiscard]] double speed() const { return speed_; }
  // Playing is much slower near the impacts of the first run.
  void slow_near_impacts(bool slow);
  // Whether it plays so now.
  [[nodiscard]] bool slow() const;
  // Runs to `time` as fast as possible; returns when it is reached, or when a run is lost.
  void run_until(double time);
  // Pauses the runs and calls `then` when the newest frame has arrived; at once if none has been shown. Any
  // change of the runs, or playing, drops `then`. `what` is shown meanwhile.
  void when_still(const QString& what, std::function<void()> then);
  void forget_wait();
  [[nodiscard]] const QString& waits() const { return waits_; }

  // --- the playhead (lab_playhead.cpp)
  // What is shown is the newest moment or, while the runs stand still, one of their record: it is computed
  // again on their thread, and until it is there the runs are shown on their way to it. To play from there
  // repeats what is recorded, and then goes on. Nothing happens without a record.
  void go_to(double time);  // s; at or after the newest moment: there
  void go_to_start();
  void go_to_end();
  // The newest moment, or that of the stop that ended the run within the newest step.
  void show_end();
  void go_to_impact(double time);   // s: just before this impact, or the end of its step where it is there
  void go_by_impact(bool forward);  // to the next impact, or the last one; else to the end, or the start
  // What is shown, to go back to it: at `past`, or else at the newest moment.
  struct ShownMoment {
    std::optional<PastMoment> past{};
    std::optional<double> impact{};  // s, if it is the moment of one
    bool picks_last = false;         // an impact of the last step is picked
  };
  [[nodiscard]] ShownMoment shown_moment() const;
  void go_back_to(const ShownMoment& shown);
  void step_by(int steps);  // from what is shown; forward at the newest moment: a new step
  [[nodiscard]] bool in_past() const { return playhead_.has_value(); }
  // Whether what is shown is the moment that was asked for.
  [[nodiscard]] bool there() const { return !playhead_ || playhead_->there; }
  // Whether they are shown on a way that takes long.
  [[nodiscard]] bool way_is_long() const { return playhead_ && playhead_->on_the_way; }
  [[nodiscard]] double shown_time() const;  // s, that was asked for
  // The stop of which the moment is shown, while it stands there (lab_stops.cpp).
  [[nodiscard]] std::optional<Stop> stopped() const;
  // s, of the impact that was gone to or stopped at, while its moment is shown; after a step on, of the last
  // one within it.
  [[nodiscard]] std::optional<double> picked() const;

  // --- what is known of them
  void record(const std::vector<Curve>& curves);
  using Frames = std::vector<std::shared_ptr<const Frame>>;
  // The shown frame of each run, the document's own method first; none until the scene is ready.
  [[nodiscard]] const Frames& frames() const {
    return playhead_ && !playhead_->frames.empty() ? playhead_->frames : frames_;
  }
  [[nodiscard]] std::shared_ptr<const Frame> frame() const {
    return frames().empty() ? nullptr : frames().front();
  }
  // The newest frame of each run, likewise.
  [[nodiscard]] const Frames& newest() const { return frames_; }
  // The shown scene, for edits: with those that no frame has shown yet. None while a run plays.
  [[nodiscard]] const std::shared_ptr<const Scene>& scene() const {
    return in_past() ? frames().front()->scene : scene_;
  }
  // The same, and while a run plays that of the shown frame. Its parts alone, where bodies need not be where
  // they are now, are the same object until an edit. None while the runs are on their way to what is shown.
  [[nodiscard]] std::shared_ptr<const Scene> shown_scene();
  [[nodiscard]] std::shared_ptr<const Scene> shown_parts();
  [[nodiscard]] bool plays() const { return frame() != nullptr && frame()->playing; }
  [[nodiscard]] const std::vector<std::shared_ptr<Recorder>>& recorders() const { return recorders_; }
  [[nodiscard]] const Frame* lost() const;  // a lost run, if any
  // The first method's run that the last new start has left, or what the last cut has cut off. A restart leaves
  // it, unless it is a run of the same start: then it is the one that the restart left.
  [[nodiscard]] const std::optional<RunBefore>& before() const { return before_; }
  // s: progress of the runs that are recomputed after an undone edit.
  [[nodiscard]] std::optional<double> replayed() const { return replayed_; }
  // Whether they have left the start, or are about to.
  [[nodiscard]] bool have_begun() const;
  [[nodiscard]] double duration() const { return document_.preset.duration; }  // s, of the document
  // Whether the next step would pass the document's duration.
  [[nodiscard]] bool at_end() const;
  // The scene of the moment that this edit left.
  [[nodiscard]] const std::shared_ptr<const Scene>& scene_left(Worker::EditId edit) const {
    return left_.at(edit).scene;
  }
  // Whether the runs are at the document's start, or about to be.
  [[nodiscard]] bool at_start() const;

  // --- changes of the document
  // Another document: all that was known is gone.
  void load(const std::vector<Curve>& curves);
  // The start has changed, and begin() follows: curves chosen until then need no replay.
  void await_begin();
  void begin();
  // Keeps the runs at the shown moment, for an edit that leaves them: begin() follows. `again`: it is made
  // again.
  Worker::EditId keep(Worker::EditId again = 0);
  // The same, and goes on from the shown moment of the past. `again`: from the one where the edit was made.
  Worker::EditId cut(Worker::EditId again = 0);
  // Back to the moment that this edit first left, which is shown at once. The document has the start of then.
  void return_to(Worker::EditId edit);
  // A run as a step of undo, entered at the newest moment: taken back to there, and made again as it was.
  struct Entered;
  [[nodiscard]] std::shared_ptr<Entered> enter() const;
  void take_back(Entered& run);
  void make_again(const Entered& run);
  // Begins with other methods than the document has so far, as an edit that can be undone.
  Worker::EditId begin_with(const Methods& methods, const std::vector<Curve>& curves);
  // An edit of the scene and of methods (of these runs), as a part of the last edit if `part_of` names it.
  Worker::EditId edit(const std::vector<std::pair<std::size_t, Method>>& methods, const SceneEdits& edits,
                      Worker::EditId part_of);
  void undo_or_redo(Worker::EditId edit);
  // The document has other stops.
  void watch_stops();
  // The document has another duration: a run that plays ends there.
  void watch_duration();
  // For edits of the methods.
  [[nodiscard]] Worker& worker() { return worker_; }

 signals:
  void framesChanged();
  void noticesChanged();

 private:
  // A moment before the newest one.
  struct Playhead {
    PastMoment moment;
    std::optional<double> impact{};                       // s, if it is the moment of one
    std::uint64_t first = 0;                              // number of Worker::show(), since there is a playhead
    std::uint64_t last = 0;                               // likewise: of this moment
    std::vector<std::shared_ptr<const RunSetup>> runs{};  // of which it is a moment
    Frames frames{};                                      // none: it has just left the newest moment
    bool there = false;
    bool on_the_way = false;  // the frames are of another moment
    bool plays = false;
    double passed = 0.0;  // s, while it plays: stops until there are behind
  };
  // What was shown when an edit left the runs.
  struct Left {
    Frames frames;
    std::vector<std::shared_ptr<Recorder>> recorders{};
    std::shared_ptr<const Scene> scene;
    std::optional<Playhead> playhead{};
    bool returned = false;
    std::optional<RunBefore> before{};  // that was pale then

    void stand_still();
    void keep_picture();  // alone, without the records
  };

  [[nodiscard]] RunBefore as_before() const;
  void leave_run();
  void poll();
  // What was just begun or edited is taken before the window is painted next, if it is ready by then: a move of
  // a drag, while nothing plays, is painted once, with what it has changed.
  void show_soon();
  void take_news(const Frames& news);
  void show_start();
  void show_again(const Frames& frames, const std::shared_ptr<const Scene>& scene,
                  const std::optional<Playhead>& playhead);
  // The playhead.
  [[nodiscard]] bool has_record() const;
  void seek(const PastMoment& moment, std::optional<double> impact = std::nullopt);
  void ask_worker(const PastMoment& moment);
  // Until the moment is there, what is shown stays.
  void stand_at(const PastMoment& moment, std::optional<double> impact = std::nullopt);
  void stand_at_impact(double time);  // s
  void step_from_impact(int steps);
  void play_past(bool playing);
  void play_past_on();
  void begin_past_pace(double time);                           // s
  [[nodiscard]] double past_due(Pace::Clock::time_point now);  // s
  void leave_past();
  void take_shown();
  void follow_runs();
  // Where stops were met.
  void take_halt(const Frames& before);
  void show_stop(const MetStop& met);
  [[nodiscard]] std::optional<double> impact_of(const MetStop& met) const;
  [[nodiscard]] const MetStop* stop_until(double time) const;
  void show_speeds(const Frames& frames);
  [[nodiscard]] std::shared_ptr<const Frame> with_impacts(const Frame& frame, std::size_t run) const;

  const Document& document_;
  Worker worker_;
  std::vector<Curve> curves_;
  Frames frames_;  // the newest
  std::shared_ptr<const Scene> scene_;
  PlayingScene playing_scene_;
  Worker::EditId awaited_ = 0;  // an edit that is in scene_, but in no frame yet; 0: none
  bool begins_ = false;         // the frames are from before the start
  bool will_begin_ = false;
  std::vector<std::shared_ptr<Recorder>> recorders_;
  std::map<Worker::EditId, Left> left_;
  std::optional<RunBefore> before_;
  std::optional<RunBefore> before_left_;  // the one before the run that was left: of another start
  std::optional<Playhead> playhead_;      // none: at the newest moment
  Pace pace_{Pace::Clock::now()};         // while the playhead plays
  bool picks_last_ = false;  // an impact of the last step is picked: a step on, or the impact, was asked for
  std::uint64_t halts_ = 0;  // number of the last one that was shown
  std::optional<double> replayed_;
  double speed_ = 1.0;
  bool slows_near_impacts_ = false;
  std::function<void()> then_;
  QString waits_;
  QTimer timer_;
};

struct LabRuns::Entered {
  double time = 0.0;  // s
  // What was shown; no frames: those of the start were not known yet.
  Frames frames{};
  std::shared_ptr<const Scene> scene{};
  std::optional<Playhead> playhead{};
  Worker::EditId kept = 0;  // the runs, once it is taken back
};

}  // namespace carom
