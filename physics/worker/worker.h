#pragma once

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <mutex>
#include <stop_token>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "physics/preset/preset.h"
#include "physics/record/frame.h"
#include "physics/scene/scene.h"
#include "physics/worker/run_group.h"

namespace carom {

// Runs a scene under one method, or under several side by side, on its own thread at a chosen pace, and
// publishes complete frames. Calls return at once; they are carried out between two steps, in their order.
// The lock guards only the exchange of commands and of the newest frames; it is never held while stepping or
// painting. A load, a restart and the destructor don't wait for the step under way: they interrupt it. The
// runs pause while nobody takes their frames and too much data is waiting (kMostWaiting).
//
// Of several runs the first is the scene's own and sets the pace: the others follow it and never pass it. One
// added later starts at t = 0, and the first waits for it. A lost run stays where it is and says why in
// its frames (Frame::lost); playing then stops. Playing also stops if the thread runs out of memory or has
// any other error: then all runs stay until the next load or restart.
//
// Edits of the runs can be undone, the last first, and redone: the runs that change go back to the last key
// frame before it and are replayed to the present moment at full speed, as if the edit had never been made
// (Frame::replay_until). A short replay is not shown. After a restart since the edit the runs are those of the
// start that undo_or_redo() names. An edit that leaves the runs for a new start keeps them for return_to().
class Worker {
 public:
  // Identifies an edit of the runs since the last load.
  using EditId = RunGroup::EditId;

  // The scene must be valid; `curves` are recorded from the start of its runs.
  explicit Worker(const Preset& preset, const std::vector<Curve>& curves = {});
  ~Worker();
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  // Stops at t = 0, with the methods of the scene.
  void load(const Preset& preset, const std::vector<Curve>& curves = {},
            ReferenceId reference = ReferenceId::kNone);
  // Stops at t = 0 of this preset, which edits may have made of the one before.
  void restart(const Preset& start);
  // The same with other curves and another reference.
  void start_from(const Preset& start, const std::vector<Curve>& curves, ReferenceId reference);
  // The same as an edit of the runs.
  EditId restart(const Preset& start, const std::vector<Curve>& curves, ReferenceId reference);
  // Keeps the runs as they stand, for the edit that leaves them: start_from() or cut() follows. `again`: the
  // edit is made again, and the moment that it first left is the one to return to.
  EditId keep_runs(EditId again = 0) { return keep_runs(again, false); }
  // The same for an edit that is taken back, until a new one follows.
  EditId keep_taken_back() { return keep_runs(0, true); }
  // Back to the moment that this edit first left, stopped. Runs that are kept no more are replayed up to there.
  void return_to(EditId edit, const std::vector<Curve>& curves, ReferenceId reference);
  // Goes on from this earlier moment (s) of the runs that keep_runs() has just kept for the edit, stopped. What
  // was done to them later is not done again; `later` are the edits of the preset that still come.
  void cut(EditId edit, double time, const std::vector<RunEdit>& later);
  // Shows a moment of the past, instead of the one under way (take_shown()); the runs stay where they are.
  // Returns its number: each call has a larger one.
  std::uint64_t show(const PastMoment& moment);
  // Plays at the chosen pace, until `until` if that is ahead; or stops.
  void set_playing(bool playing, double until = std::numeric_limits<double>::infinity());
  void step_once();              // one step of the first run's method, stopped
  void set_speed(double speed);  // simulated seconds per second, > 0
  // Whether playing is much slower near impacts of the first run.
  void slow_near_impacts(bool slow);
  // Changes the methods of these runs from now on; as a part of the last edit if `part_of` names it.
  EditId set_methods(const std::vector<std::pair<std::size_t, Method>>& methods, EditId part_of = 0);
  EditId set_method(const Method& method, std::size_t run = 0) { return set_methods({{run, method}}); }
  EditId add_method(const Method& method);  // one more run; at most kMostCompared besides the first
  EditId remove_method(std::size_t run);    // not the first
  void set_reference(ReferenceId reference);
  // Other stops of the preset. The first run meets them from its start on, and playing at a pace, or a single
  // step, halts in the step in which it meets one: see Frame::halt, and show() for the moment itself.
  void watch_stops(const std::vector<Stop>& stops);
  // Edits the scene of all runs now; as a part of the last edit if `part_of` names it.
  EditId edit_scene(const SceneEdits& edits, EditId part_of = 0);
  // Undoes the last edit that is not undone, or redoes the last one that is. Then `start` is what the runs
  // start from, and `reference` is the one to use.
  void undo_or_redo(EditId edit, const Preset& start, ReferenceId reference);
  void end_replay();            // stays at the moment that is reached
  void run_until(double time);  // at full speed, then stops; publishes frames on the way
  // Sets the curves to record from now on. Those that were not recorded before come from the start on: the
  // run waits while it is replayed.
  void record(const std::vector<Curve>& curves);

  // Most numbers in rows, and impacts, that wait, apart from those of one step.
  static constexpr std::size_t kMostWaiting = 1'000'000;

  // The changes since the last call, a frame for each run; none if nothing changed. Never from before the
  // last load or restart.
  [[nodiscard]] std::vector<std::shared_ptr<const Frame>> take_frames();
  // Moments of the past: the one of the last show(), or the runs on the way there, at least every
  // kPicturePeriod; no frames if there is nothing new. Never from before the last load or restart.
  struct Shown {
    std::vector<std::shared_ptr<const Frame>> frames{};
    std::uint64_t number = 0;  // of the call of show()
    bool there = false;        // this is the moment itself
  };
  static constexpr std::chrono::milliseconds kPicturePeriod{50};
  [[nodiscard]] Shown take_shown();
  // Returns when take_frames() has frames, or after this time.
  void wait_for_frames(std::chrono::milliseconds longest);

 private:
  struct Work;  // the thread's own data
  struct Command {
    enum class When {
      kDisplayed,  // when the runs are at the displayed moment
      kAtOnce,
      kBegins  // starts all runs again, in whatever state they are
    };
    std::function<void(Work&)> what;
    When when = When::kDisplayed;
  };
  void post(std::function<void(Work&)> command, Command::When when = Command::When::kDisplayed);
  // Does nothing if the runs were interrupted in the middle of a step.
  void post_to_runs(const std::function<void(Work&)>& command);
  // Also saves the state of the runs before, so that the edit can be undone.
  EditId post_edit(const std::function<void(RunGroup&, EditId)>& command, EditId part_of = 0);
  // Interrupts the step under way. The command begins all runs, which then stand still.
  void post_begin(const std::function<void(Work&, const std::stop_token&)>& command);
  EditId keep_runs(EditId again, bool taken_back);
  void work(const std::stop_token& stop, const Preset& first, const std::vector<Curve>& curves,
            std::stop_token interrupt);
  void wait_for_work(const std::stop_token& stop, const Work& work, std::vector<Command>& commands);
  static void advance(const std::stop_token& stop, Work& work);
  [[nodiscard]] static double slower_near_impacts(Work& work, double due,
                                                  std::chrono::steady_clock::time_point now);
  void advance_past(Work& work);
  [[nodiscard]] static bool is_worth_a_frame(const Work& work);
  static void carry_out(Work& work, std::vector<Command>& commands);
  void publish(Work& work);
  void publish_failure(Work& work, const std::string& why);
  void hand_over(const Work& work, std::vector<std::shared_ptr<Frame>> frames);
  [[nodiscard]] bool too_much_waits() const;  // with the lock held

  std::mutex mutex_;
  std::condition_variable_any wake_;
  std::condition_variable published_;
  std::vector<Command> commands_;
  std::stop_source interrupt_;  // of the runs started last
  std::vector<std::shared_ptr<Frame>> newest_;
  std::uint64_t newest_start_ = 0;  // of the frames: the value of starts_ at their time
  Shown shown_;
  std::uint64_t shown_start_ = 0;  // of these, likewise
  std::uint64_t shows_ = 0;        // calls of show() so far
  std::uint64_t starts_ = 1;       // loads and restarts so far, and the first start
  EditId edits_ = 0;
  std::jthread thread_;  // last: it uses all of the above
};

}  // namespace carom
