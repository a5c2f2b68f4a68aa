#pragma once

#include <chrono>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <stop_token>
#include <utility>
#include <vector>

#include "physics/preset/preset.h"
#include "physics/record/frame.h"
#include "physics/worker/edit_lists.h"
#include "physics/worker/live_run.h"
#include "physics/worker/past_runs.h"

namespace carom {

// Several runs of one preset side by side, each under its own method. The first one leads: the others come as
// near to its time as their steps allow and never pass it, so where they stand follows from where it stands. An
// edit is applied when its run has come to the edit's time. Edits can be undone and redone: the runs that
// change are replayed from the last key frame before it, as if the edit had never been made. Runs that an edit
// leaves for a new start can be kept for a return to their moment.
//
// First load(), then begin(). A step throws StepInterrupted once the token of begin() is requested: call
// interrupt() then. The runs are unusable until the next begin(), and edits do nothing until then. One thread
// at a time.
class RunGroup {
 public:
  using Clock = std::chrono::steady_clock;
  using EditId = std::uint64_t;

  // What the next begin() starts. The preset must be valid.
  void load(const Preset& preset, const std::vector<Curve>& curves, ReferenceId reference);
  // Another start, with the curves and the reference of before.
  void start_from(const Preset& preset) { preset_ = preset; }
  // Edits so far can't be undone any more.
  void forget_edits() {
    other_sides_.clear();
    edit_lists_.clear();
    kept_.clear();
  }
  // All runs at t = 0.
  void begin(std::stop_token token);
  void interrupt();
  [[nodiscard]] bool interrupted() const { return interrupted_; }
  // How often all runs have begun, or have been returned to.
  [[nodiscard]] std::uint64_t starts() const { return starts_; }

  // Whole runs are kept for the last so many edits; those of earlier ones are replayed from their start.
  static constexpr std::ptrdiff_t kMostKept = 3;
  using Frames = std::vector<std::shared_ptr<Frame>>;
  // Puts the runs aside as they stand, for the edit that leaves them, with their frames that nobody has taken;
  // begin(), return_to() or cut() follows. An edit that is made again keeps the moment that it first left.
  // `taken_back`: they are kept for an edit that is taken back, until a new edit follows.
  void keep_runs(EditId edit, Frames untaken, bool taken_back = false);
  // The kept runs, instead of begin(): at the moment that the edit left, or on the way there (replay_until).
  // Returns their frames that nobody has taken, with these curves alone.
  [[nodiscard]] Frames return_to(EditId edit, const std::vector<Curve>& curves, ReferenceId reference,
                                 std::stop_token token);

  // Goes on from an earlier moment of the runs that this edit has just left, instead of begin(): from `time`
  // (s), or on the way there (replay_until). Where that is within a step of the first run, an edit of nothing
  // divides the step of each run there. What was done to the runs later is not done again, but `later`, edits
  // of the preset, still come. Returns the frames of the kept runs that nobody has taken.
  [[nodiscard]] Frames cut(EditId edit, double time, const std::vector<RunEdit>& later, std::stop_token token);

  // --- the past
  // Copies of the runs go to a moment of their past; the runs stay as they are.
  void seek_past(const PastMoment& moment);
  [[nodiscard]] PastRuns& past() { return past_; }
  [[nodiscard]] const PastRuns& past() const { return past_; }

  // Edits, from the displayed moment on, to which the runs go. Nothing happens for a run that there is not.
  void add_run(const Method& method);  // at t = 0; at most kMostCompared besides the first
  void remove_run(std::size_t run);    // not the first
  void set_method(std::size_t run, const Method& method, EditId edit);
  void edit_scene(const SceneEdits& edits, EditId edit);

  // Sets what is recorded of all runs.
  void record(const std::vector<Curve>& curves);
  void compare_with(ReferenceId reference);
  // The stops of the preset, which the first run is to meet.
  void watch_stops(const std::vector<Stop>& stops);

  // Call before an edit that can be undone.
  void remember(EditId edit) { other_sides_[edit] = other_side(); }
  // Takes the last remembered edit back, or makes the one again that was taken back last. `start`: what the
  // runs start from if they were begun again since the edit was made.
  void undo_or_redo(EditId edit, const Preset& start, ReferenceId reference);
  // s: the runs are being replayed up to here.
  [[nodiscard]] std::optional<double> replay_until() const { return replay_until_; }
  void end_replay() {
    replay_until_.reset();
    cut_.reset();
  }
  // The runs have come to where they were being replayed. False: there is a little more to replay, up to a cut
  // within a step.
  [[nodiscard]] bool end_reached_replay();

  // The runs, when they are not interrupted.
  [[nodiscard]] const LiveRun& first() const { return runs_.front().live; }
  // True if the first run's next step would end after `time`.
  [[nodiscard]] bool reaches(double time) const { return !may_step(runs_.front(), time); }
  void step_first();
  enum class Advance { kReached, kDeadline, kRunLost, kStopMet };
  // Steps the first run until it is within a step of `time`, and the others until they are within a step of it.
  // kRunLost: a run was just lost; kStopMet: the first run has just met a stop (LiveRun::met()).
  template <class Stop>
  Advance advance_to(double time, Clock::time_point deadline, const Stop& stop) {
    while (true) {
      Run& run = next_to_step();
      if (!may_step(run, time)) return Advance::kReached;
      if (Clock::now() >= deadline || stop()) return Advance::kDeadline;
      step(run);
      if (run.live.lost()) return Advance::kRunLost;
      if (&run == &runs_.front() && run.live.met() != nullptr) return Advance::kStopMet;
    }
  }
  // True if a run has not come as far as the first.
  [[nodiscard]] bool lags() const;
  // Replays, for about this long, a run of which more is to be recorded. False if there is none.
  bool catch_up(Clock::duration duration);
  [[nodiscard]] bool some_behind() const;

  // True if anything in the frames has changed since the last call of take_frames().
  [[nodiscard]] bool changed() const { return changed_; }
  // A frame for each run, without the fields that only the owner knows: playing and speed.
  [[nodiscard]] std::vector<std::shared_ptr<Frame>> take_frames();
  // A frame without bodies at t = 0, for a scene that could not begin.
  [[nodiscard]] std::shared_ptr<Frame> empty_frame();
  void clear_runs() {
    runs_.clear();
    past_.clear();
    for (auto& [edit, kept] : kept_) kept.drop_runs();
  }

 private:
  struct Run {
    LiveRun live;
    std::uint64_t id;
  };
  // What tells one run of a preset from another.
  struct MethodAndEdits {
    Method start;
    std::vector<RunEdit> edits;
  };
  // All runs, and which start they have.
  struct RunsBegun {
    std::uint64_t start = 0;
    std::vector<MethodAndEdits> runs;
  };
  // The same, with lists of edit_lists_.
  struct OtherSide {
    std::uint64_t start = 0;
    std::uint64_t scene = 0;  // that they began from: fingerprint_of_start()
    struct Begun {
      Method method;
      std::uint64_t run;
      EditLists::List edits;
    };
    std::vector<Begun> runs;
  };
  // What an edit left.
  struct Kept {
    Preset preset;
    RunsBegun begun;
    double time = 0.0;        // s
    std::vector<Run> runs{};  // empty: to be replayed
    Frames untaken{};
    bool returned = false;

    void drop_runs() {
      runs.clear();
      untaken.clear();
    }
  };

  [[nodiscard]] static std::vector<MethodAndEdits> runs_of(const Preset& preset);
  [[nodiscard]] static MethodAndEdits method_and_edits(const Run& run);
  [[nodiscard]] RunsBegun runs_begun() const;
  [[nodiscard]] OtherSide other_side();
  void record_all();
  void watch_first();
  void replay_to(double time);  // if the runs are not there yet
  void take_run(MethodAndEdits wanted, std::vector<Run>& old);
  void begin_run(MethodAndEdits wanted);
  [[nodiscard]] double displayed_time() const;
  [[nodiscard]] Run& next_to_step();
  [[nodiscard]] static bool may_step(const Run& run, double time);
  void step(Run& run);

  std::stop_token token_;
  bool interrupted_ = false;     // in the middle of a step: the runs are unusable
  double interrupted_at_ = 0.0;  // s: the displayed moment then
  Preset preset_;                // as loaded
  std::vector<Curve> curves_;
  ReferenceId reference_ = ReferenceId::kNone;
  StopRecord::Stops stops_;  // of the preset
  std::vector<Run> runs_;
  PastRuns past_;
  std::map<EditId, OtherSide> other_sides_;        // of edits: the runs before it, or after it if it is undone
  std::map<std::uint64_t, EditLists> edit_lists_;  // by run
  std::map<EditId, Kept> kept_;
  std::optional<double> replay_until_;
  struct Cut {
    EditId edit;
    double time;  // s
  };
  std::optional<Cut> cut_;  // to which the runs are being replayed
  std::uint64_t starts_ = 0;
  std::uint64_t start_ = 0;  // the one that the runs began from: its number among starts
  std::uint64_t ids_ = 0;
  bool changed_ = true;
};

}  // namespace carom
