#include "physics/worker/worker.h"

#include <algorithm>
#include <chrono>
#include <iterator>
#include <limits>
#include <new>
#include <optional>
#include <utility>

#include "physics/preset/preset.h"
#include "physics/run/scene_now.h"
#include "physics/worker/impact_scout.h"
#include "physics/worker/pace.h"
#include "physics/worker/run_group.h"

namespace carom {
namespace {

using Clock = Pace::Clock;

// Shortest time between frames; a window polls at 60 Hz.
constexpr std::chrono::milliseconds kFramePeriod{8};
// A replay that lasts no longer shows its end alone.
constexpr std::chrono::milliseconds kShortReplay{60};

}  // namespace

struct Worker::Work {
  void stand_still() {
    playing = false;
    end = std::numeric_limits<double>::infinity();
    halt.reset();
    begin_measurement();
  }
  void begin_pace() { pace.begin(runs.first().time(), Clock::now()); }
  void begin_measurement() { pace.begin_measurement(runs.first().time(), Clock::now()); }
  void halt_if_paced() {
    if (!playing || full_speed || runs.replay_until()) return;
    playing = false;
    halt_at(*runs.first().met());
  }
  void halt_at(const MetStop& met) {
    changed = true;
    halt = Halt{++halts, met};
  }
  void interrupt() {
    runs.interrupt();
    playing = changed = false;
  }

  RunGroup runs;
  Pace pace{Clock::now()};
  bool playing = false;
  bool full_speed = false;
  bool slows_near_impacts = false;
  ImpactScout scout;
  double end = 0.0;      // s; a playing run stops here
  bool changed = false;  // how it plays, since the last frames
  std::optional<Halt> halt;
  std::uint64_t halts = 0;  // so far
  Clock::time_point replay_began{};
  std::uint64_t show = 0;                                // the number of the moment that is sought
  std::optional<Clock::time_point> shown_nothing_since;  // while a moment of the past is sought
  std::vector<std::shared_ptr<const Frame>> last;        // published
};

Worker::Worker(const Preset& preset, const std::vector<Curve>& curves)
    : thread_([this, preset, curves, interrupt = interrupt_.get_token()](const std::stop_token& stop) {
        work(stop, preset, curves, interrupt);
      }) {}

Worker::~Worker() {
  {
    const std::lock_guard lock(mutex_);
    interrupt_.request_stop();
  }
  thread_.request_stop();
  wake_.notify_all();
}

void Worker::post(std::function<void(Work&)> command, Command::When when) {
  {
    const std::lock_guard lock(mutex_);
    commands_.push_back({std::move(command), when});
  }
  wake_.notify_all();
}

void Worker::post_to_runs(const std::function<void(Work&)>& command) {
  post([command](Work& work) {
    if (!work.runs.interrupted()) command(work);
  });
}

Worker::EditId Worker::post_edit(const std::function<void(RunGroup&, EditId)>& command, EditId part_of) {
  const EditId edit = part_of != 0 ? part_of : ++edits_;
  post([=](Work& work) {
    if (part_of == 0) work.runs.remember(edit);
    command(work.runs, edit);
  });
  return edit;
}

void Worker::post_begin(const std::function<void(Work&, const std::stop_token&)>& command) {
  {
    const std::lock_guard lock(mutex_);
    ++starts_;
    interrupt_.request_stop();
    interrupt_ = std::stop_source();
    commands_.push_back({[command, token = interrupt_.get_token()](Work& work) {
                           work.last.clear();
                           work.scout.forget();
                           command(work, token);
                           work.stand_still();
                         },
                         Command::When::kBegins});
  }
  wake_.notify_all();
}

void Worker::load(const Preset& preset, const std::vector<Curve>& curves, ReferenceId reference) {
  post_begin([=](Work& work, const std::stop_token& token) {
    work.runs.load(preset, curves, reference);
    work.runs.forget_edits();
    work.runs.begin(token);
  });
}

void Worker::restart(const Preset& start) {
  post_begin([start](Work& work, const std::stop_token& token) {
    work.runs.start_from(start);
    work.runs.begin(token);
  });
}

void Worker::start_from(const Preset& start, const std::vector<Curve>& curves, ReferenceId reference) {
  post_begin([=](Work& work, const std::stop_token& token) {
    work.runs.load(start, curves, reference);
    work.runs.begin(token);
  });
}

Worker::EditId Worker::restart(const Preset& start, const std::vector<Curve>& curves, ReferenceId reference) {
  const EditId edit = ++edits_;
  post_begin([=](Work& work, const std::stop_token& token) {
    work.runs.remember(edit);
    work.runs.load(start, curves, reference);
    work.runs.begin(token);
  });
  return edit;
}

Worker::EditId Worker::keep_runs(EditId again, bool taken_back) {
  const EditId edit = again != 0 ? again : ++edits_;
  post(
      [=, this](Work& work) {
        RunGroup::Frames untaken;
        {
          const std::lock_guard lock(mutex_);
          untaken = std::exchange(newest_, {});
        }
        work.runs.keep_runs(edit, std::move(untaken), taken_back);
        work.playing = work.changed = false;
      },
      Command::When::kAtOnce);
  return edit;
}

void Worker::return_to(EditId edit, const std::vector<Curve>& curves, ReferenceId reference) {
  post_begin([=, this](Work& work, const std::stop_token& token) {
    work.replay_began = Clock::now();
    RunGroup::Frames untaken = work.runs.return_to(edit, curves, reference, token);
    const std::lock_guard lock(mutex_);
    newest_ = std::move(untaken);  // the next frames take them up
  });
}

void Worker::cut(EditId edit, double time, const std::vector<RunEdit>& later) {
  post_begin([=, this](Work& work, const std::stop_token& token) {
    work.replay_began = Clock::now();
    RunGroup::Frames untaken = work.runs.cut(edit, time, later, token);
    const std::lock_guard lock(mutex_);
    newest_ = std::move(untaken);  // the next frames take them up
  });
}

std::uint64_t Worker::show(const PastMoment& moment) {
  const std::uint64_t number = ++shows_;
  post(
      [=](Work& work) {
        work.runs.seek_past(moment);
        work.show = number;
        if (!work.shown_nothing_since) work.shown_nothing_since = Clock::now();
      },
      Command::When::kAtOnce);
  return number;
}

void Worker::set_playing(bool playing, double until) {
  post_to_runs([playing, until](Work& work) {
    work.playing = playing && !work.runs.first().lost();
    work.full_speed = false;
    work.halt.reset();
    work.end = work.runs.reaches(until) ? std::numeric_limits<double>::infinity() : until;
    work.begin_pace();
    work.begin_measurement();
    work.changed = true;
  });
}

void Worker::step_once() {
  post_to_runs([](Work& work) {
    work.playing = false;
    work.halt.reset();
    work.runs.step_first();  // the others follow
    if (const MetStop* met = work.runs.first().met()) work.halt_at(*met);
  });
}

void Worker::set_speed(double speed) {
  post([speed](Work& work) {
    work.pace.set_speed(speed);
    if (work.runs.interrupted()) return;
    work.begin_pace();
    work.begin_measurement();
  });
}

void Worker::slow_near_impacts(bool slow) {
  post([slow](Work& work) {
    work.slows_near_impacts = slow;
    work.scout.forget();
  });
}

Worker::EditId Worker::set_methods(const std::vector<std::pair<std::size_t, Method>>& methods, EditId part_of) {
  const auto set = [methods](RunGroup& runs, EditId edit) {
    for (const auto& [run, method] : methods) runs.set_method(run, method, edit);
  };
  return post_edit(set, part_of);
}

Worker::EditId Worker::add_method(const Method& method) {
  return post_edit([method](RunGroup& runs, EditId) { runs.add_run(method); });
}

Worker::EditId Worker::remove_method(std::size_t run) {
  return post_edit([run](RunGroup& runs, EditId) { runs.remove_run(run); });
}

Worker::EditId Worker::edit_scene(const SceneEdits& edits, EditId part_of) {
  return post_edit([edits](RunGroup& runs, EditId edit) { runs.edit_scene(edits, edit); }, part_of);
}

void Worker::undo_or_redo(EditId edit, const Preset& start, ReferenceId reference) {
  post(
      [=](Work& work) {
        if (!work.runs.replay_until()) work.replay_began = Clock::now();
        work.runs.undo_or_redo(edit, start, reference);
      },
      Command::When::kAtOnce);
}

void Worker::end_replay() {
  post(
      [](Work& work) {
        work.runs.end_replay();
        work.playing = false;
        work.changed = true;
      },
      Command::When::kAtOnce);
}

void Worker::run_until(double time) {
  post_to_runs([time](Work& work) {
    work.playing = !work.runs.first().lost();
    work.changed = true;
    work.full_speed = true;
    work.halt.reset();
    work.end = time;
    work.begin_measurement();
  });
}

void Worker::set_reference(ReferenceId reference) {
  post([reference](Work& work) { work.runs.compare_with(reference); });
}

void Worker::watch_stops(const std::vector<Stop>& stops) {
  post([stops](Work& work) { work.runs.watch_stops(stops); });
}

void Worker::record(const std::vector<Curve>& curves) {
  post([curves](Work& work) { work.runs.record(curves); });
}

std::vector<std::shared_ptr<const Frame>> Worker::take_frames() {
  const std::lock_guard lock(mutex_);
  if (newest_start_ != starts_) return {};  // from before the last load or restart
  if (too_much_waits()) wake_.notify_all();
  const auto taken = std::exchange(newest_, {});
  return {taken.begin(), taken.end()};
}

Worker::Shown Worker::take_shown() {
  const std::lock_guard lock(mutex_);
  if (shown_start_ != starts_) return {};
  return std::exchange(shown_, {});
}

void Worker::wait_for_frames(std::chrono::milliseconds longest) {
  std::unique_lock lock(mutex_);
  published_.wait_for(lock, longest, [this] { return !newest_.empty() && newest_start_ == starts_; });
}

bool Worker::too_much_waits() const {
  std::size_t numbers = 0;
  for (const std::shared_ptr<Frame>& frame : newest_) {
    numbers += frame->impacts.size();
    for (const Rows& rows : frame->rows) numbers += rows.size() + rows.values.size();
  }
  return numbers > kMostWaiting;
}

void Worker::publish(Work& work) {
  std::vector<std::shared_ptr<Frame>> frames = work.runs.take_frames();
  for (const std::shared_ptr<Frame>& frame : frames) {
    frame->playing = work.playing;
    frame->realised_speed = work.pace.reached();
    frame->slow = work.playing && work.pace.slow();
  }
  if (!work.playing && !work.runs.replay_until())
    frames.front()->scene = std::make_shared<const Scene>(scene_now(work.runs.first().simulation()));
  frames.front()->halt = work.halt;
  work.changed = false;

  std::vector<std::shared_ptr<Frame>> waiting;
  {
    const std::lock_guard lock(mutex_);
    waiting = std::exchange(newest_, {});
  }
  // Frames that nobody took are merged into these.
  for (const std::shared_ptr<Frame>& before : waiting) {
    const auto same = std::find_if(frames.begin(), frames.end(),
                                   [&](const auto& frame) { return frame->run == before->run; });
    if (same != frames.end()) take_up(*before, **same);
  }
  work.last.assign(frames.begin(), frames.end());
  hand_over(work, std::move(frames));
}

void Worker::hand_over(const Work& work, std::vector<std::shared_ptr<Frame>> frames) {
  const std::lock_guard lock(mutex_);
  newest_ = std::move(frames);
  newest_start_ = work.runs.starts();
  published_.notify_all();
}

// Reports in the last published frames of all runs why they stopped.
void Worker::publish_failure(Work& work, const std::string& why) {
  std::vector<std::shared_ptr<Frame>> frames;
  for (const std::shared_ptr<const Frame>& last : work.last) {
    auto frame = std::make_shared<Frame>(*last);
    frame->rows.clear();
    frame->impacts.clear();
    frame->back_to.reset();
    frames.push_back(std::move(frame));
  }
  if (frames.empty()) frames.push_back(work.runs.empty_frame());
  for (const std::shared_ptr<Frame>& frame : frames) {
    frame->playing = false;
    frame->realised_speed = 0.0;
    frame->status = why;
    frame->lost = why;
  }
  hand_over(work, std::move(frames));
}

// During a replay only commands that undo or redo more edits are carried out, and all before a new start.
void Worker::carry_out(Work& work, std::vector<Command>& commands) {
  const auto begins = [&commands] {
    return std::any_of(commands.begin(), commands.end(),
                       [](const Command& each) { return each.when == Command::When::kBegins; });
  };
  while (!commands.empty() &&
         !(work.runs.replay_until() && commands.front().when == Command::When::kDisplayed && !begins())) {
    const Command command = std::move(commands.front());
    commands.erase(commands.begin());
    command.what(work);
  }
}

void Worker::work(const std::stop_token& stop, const Preset& first, const std::vector<Curve>& curves,
                  std::stop_token interrupt) {
  Work work;
  work.runs.load(first, curves, ReferenceId::kNone);
  std::vector<Command> commands = {{[&interrupt](Work& begun) {
                                      begun.runs.begin(std::move(interrupt));
                                      begun.stand_still();
                                    },
                                    Command::When::kBegins}};
  const auto fails = [&](const std::string& why) {
    work.interrupt();
    try {
      publish_failure(work, why);
    } catch (const std::exception&) {
      work.last.clear();
      work.runs.clear_runs();  // room for one small frame
      publish_failure(work, why);
    }
  };
  while (!stop.stop_requested()) {
    try {
      carry_out(work, commands);
      if (is_worth_a_frame(work)) publish(work);
      wait_for_work(stop, work, commands);
      carry_out(work, commands);
      if (work.runs.past().seeks()) {
        advance_past(work);
      } else if (!work.runs.interrupted()) {
        advance(stop, work);
      }
    } catch (const StepInterrupted&) {
      work.scout.forget();
      work.interrupt();  // a load, a restart or the end comes next
    } catch (const std::bad_alloc&) {
      fails("stopped: there is not enough memory to go on; restart, or open a smaller scene");
    } catch (const std::exception& error) {
      fails(std::string("stopped by an error of the program: ") + error.what());
    }
  }
}

bool Worker::is_worth_a_frame(const Work& work) {
  if (work.runs.replay_until() && Clock::now() - work.replay_began < kShortReplay) return false;
  return work.changed || work.runs.changed();
}

// Until there are commands, or the runs have something to do; takes the commands.
void Worker::wait_for_work(const std::stop_token& stop, const Work& work, std::vector<Command>& commands) {
  const RunGroup& runs = work.runs;
  std::unique_lock lock(mutex_);
  const auto commanded = [&] { return !commands_.empty(); };
  const bool full = !runs.interrupted() && too_much_waits() && !runs.past().seeks();
  const bool at_once = !runs.interrupted() && !full &&
                       (runs.past().seeks() || runs.replay_until() || runs.some_behind() || runs.lags());
  if (full) {
    wake_.wait(lock, stop, [&] { return commanded() || !too_much_waits(); });
  } else if (!at_once && !work.playing) {
    wake_.wait(lock, stop, commanded);
  } else if (!at_once && !work.full_speed) {
    const auto pause =
        std::min<Clock::duration>(kFramePeriod, work.pace.until(runs.first().next(), Clock::now()));
    if (pause > Clock::duration::zero()) wake_.wait_for(lock, stop, pause, commanded);
  }
  std::move(commands_.begin(), commands_.end(), std::back_inserter(commands));
  commands_.clear();
}

// One frame's work on the way to a moment of the past. Where that is long, the way is shown.
void Worker::advance_past(Work& work) {
  PastRuns& past = work.runs.past();
  const Clock::time_point end = Clock::now() + kFramePeriod;
  try {
    while (past.step() && Clock::now() < end) {
    }
  } catch (const StepInterrupted&) {
    return past.clear();  // the runs themselves were not interrupted
  }
  if (past.seeks() && Clock::now() - *work.shown_nothing_since < kPicturePeriod) return;
  work.shown_nothing_since.reset();
  if (past.seeks()) work.shown_nothing_since = Clock::now();
  const RunGroup::Frames frames = past.frames();
  const std::lock_guard lock(mutex_);
  shown_ = {{frames.begin(), frames.end()}, work.show, !past.seeks()};
  shown_start_ = work.runs.starts();
  published_.notify_all();
}

// What is due now, if that is `due` at the present pace: no more than the moment from which on it plays slowly.
double Worker::slower_near_impacts(Work& work, double due, std::chrono::steady_clock::time_point now) {
  const LiveRun& run = work.runs.first();
  const double time = run.time();
  const auto known = work.slows_near_impacts ? work.scout.look(run, due, now + kFramePeriod / 2) : std::nullopt;
  const std::optional<double> free =
      known ? free_until(*known, time, due, run.simulation().method().step) : due;
  const bool was_slow = work.pace.slow();
  const double target = work.pace.due_near_impacts(free, time, due, now);
  if (work.pace.slow() != was_slow) work.begin_measurement();
  return target;
}

// One frame's work: recording what is recorded late, a replay, runs that lag, or playing.
void Worker::advance(const std::stop_token& stop, Work& work) {
  RunGroup& runs = work.runs;
  if (runs.catch_up(kFramePeriod)) {
    work.begin_pace();
    work.begin_measurement();
    return;
  }
  const auto now = Clock::now();
  const auto advance_to = [&](double time) {
    const RunGroup::Advance result =
        runs.advance_to(time, now + kFramePeriod, [&stop] { return stop.stop_requested(); });
    if (result == RunGroup::Advance::kRunLost) work.playing = false;
    if (result == RunGroup::Advance::kStopMet) work.halt_if_paced();
    return result == RunGroup::Advance::kReached;
  };
  if (const auto replay_until = runs.replay_until()) {
    work.changed = true;
    if (!advance_to(*replay_until) || !runs.end_reached_replay()) return;
    work.begin_pace();
    work.begin_measurement();
    return;
  }
  if (!work.playing) {
    advance_to(runs.first().time());  // those that lag
    return;
  }
  const double due = work.full_speed ? work.end : slower_near_impacts(work, work.pace.due(now), now);
  const double target = std::min(work.end, due);
  const bool there = advance_to(target);
  if (work.halt) return;
  const double time = runs.first().time();
  if (there && target >= work.end) {
    work.playing = false;
    work.changed = true;
  } else if (!there && !work.full_speed) {
    work.pace.give_up_lag(time, target, Clock::now());
  }
  work.pace.measure(time, Clock::now());
}

}  // namespace carom
