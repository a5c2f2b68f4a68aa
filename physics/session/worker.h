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

namespace carom {

// Runs a scene under one method, or under several side by side, on a thread of its own and at a chosen pace,
// and publishes whole frames. Calls return at once: they are carried out between two steps, in their order. The
// lock guards only the hand-over of commands and of the newest frames; nobody holds it while stepping or
// painting. A load, a restart and the end don't wait for the step under way: they interrupt it. The runs wait
// while nobody takes their frames and too much is waiting there (kMostWaiting).
//
// Of several runs the one that is farthest behind goes first; one that is begun later starts at t = 0 and the
// others wait for it. The first run is the scene's own: it sets the pace. A run that is lost stands still and
// says why in its frames (Frame::lost); playing stops when one is. So it does where the thread runs out of
// memory or meets any other error: then all runs stand until the next load or restart.
//
// What is done to the runs can be taken back, the last first, and put back: the runs that it changed go once
// more from t = 0 to the moment that is shown, at full speed, as if it had never been done (Frame::again). What
// was done before a restart is taken back from the start.
class Worker {
 public:
  // Names what was done to the runs since the last load.
  using EditId = std::uint64_t;

  // The scene must be valid; `curves` are read off its runs from the start on.
  explicit Worker(const Preset& preset, const std::vector<Curve>& curves = {});
  ~Worker();
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  // Stops at t = 0, with the methods that the scene names.
  void load(const Preset& preset, const std::vector<Curve>& curves = {},
            ReferenceId reference = ReferenceId::kNone);
  // The same scene, stopped at t = 0; bodies that were added come in again at their time.
  void restart();
  // The same under other methods.
  EditId restart(const Method& method, const std::vector<Method>& compare, const std::vector<Curve>& curves,
                 ReferenceId reference);
  // Plays at the chosen pace, until `until` if that lies ahead; or stops.
  void set_playing(bool playing, double until = std::numeric_limits<double>::infinity());
  void step_once();              // one step of the first run's method, stopped
  void set_speed(double speed);  // simulated seconds per second, > 0
  // Of these runs, from now on; as a part of the last edit if that is named.
  EditId set_methods(const std::vector<std::pair<std::size_t, Method>>& methods, EditId part_of = 0);
  EditId set_method(const Method& method, std::size_t run = 0) { return set_methods({{run, method}}); }
  EditId add_method(const Method& method);  // one more run; not beyond kMostCompared besides the first
  EditId remove_method(std::size_t run);    // not the first
  void set_reference(ReferenceId reference);
  EditId add_body(const Body& body);
  // The last edit that was not taken back yet; the last one that was. `reference` is what holds then.
  void take_back(EditId edit, ReferenceId reference);
  void put_back(EditId edit, ReferenceId reference);
  void run_until(double time);  // as fast as it goes, then stopped; frames come on the way
  // Which curves to read off the runs from now on. Those that were not read before come from the start on: the
  // run waits while it is gone through once more.
  void record(const std::vector<Curve>& curves);

  // Numbers in rows, and impacts, that wait at the most, but for those of one step.
  static constexpr std::size_t kMostWaiting = 1'000'000;

  // What happened since the last call, a frame for each run; none if nothing did. Never of before the last load
  // or restart.
  [[nodiscard]] std::vector<std::shared_ptr<const Frame>> take_frames();
  // Returns when take_frames() has something to give, or after so long.
  void wait_for_frames(std::chrono::milliseconds longest);

 private:
  struct Session;  // what belongs to the thread
  struct Command {
    enum class When {
      kShown,  // where the runs are at the moment that is shown
      kAtOnce,
      kBegins  // all runs anew, whatever became of those before
    };
    std::function<void(Session&)> what;
    When when = When::kShown;
  };
  void post(std::function<void(Session&)> command, Command::When when = Command::When::kShown);
  // Nothing where the runs stand in the midst of a step.
  void post_to_runs(const std::function<void(Session&)>& command);
  // With what the runs were before, so that it can be taken back.
  EditId post_edit(const std::function<void(Session&, EditId)>& command, EditId part_of = 0);
  void post_restored(EditId edit, ReferenceId reference, bool back);
  // Interrupts the step under way; the command is given the token for the next runs.
  void post_begin(const std::function<void(Session&, std::stop_token)>& command);
  void work(const std::stop_token& stop, const Preset& first, const std::vector<Curve>& curves,
            std::stop_token interrupt);
  void work_once(const std::stop_token& stop, Session& session, std::vector<Command>& commands);
  void carry_out(Session& session, std::vector<Command>& commands);
  void publish(Session& session);
  void publish_failure(Session& session, const std::string& why);
  [[nodiscard]] bool too_much_waits() const;  // with the lock held

  std::mutex mutex_;
  std::condition_variable_any wake_;
  std::condition_variable published_;
  std::vector<Command> commands_;
  std::stop_source interrupt_;  // of the runs that were begun last
  std::vector<std::shared_ptr<Frame>> newest_;
  std::uint64_t newest_start_ = 0;  // of the frames: the value of starts_ then
  std::uint64_t starts_ = 1;        // loads and restarts so far, and the first start
  EditId edits_ = 0;
  std::jthread thread_;  // last: it uses all of the above
};

}  // namespace carom
