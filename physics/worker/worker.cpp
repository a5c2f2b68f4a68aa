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

struct Worker::Session {
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
    changed = true;
    halt = Halt{++halts, *runs.first().met()};
  }
  void interrupt() {
    runs.interrupt();
    playing = changed = false;
  }

  RunGroup runs;
  Pace pace{Clock::now()};
  bool playing = false;
  bool full_speed = false;
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

void Worker::post(std::function<void(Session&)> command, Command::When when) {
  {
    const std::lock_guard lock(mutex_);
    commands_.push_back({std::move(command), when});
  }
  wake_.notify_all();
}

void Worker::post_to_runs(const std::function<void(Session&)>& command) {
  post([command](Session& session) {
    if (!session.runs.interrupted()) command(session);
  });
}

Worker::EditId Worker::post_edit(const std::function<void(RunGroup&, EditId)>& command, EditId part_of) {
  const EditId edit = part_of != 0 ? part_of : ++edits_;
  post([=](Session& session) {
    if (part_of == 0) session.runs.remember(edit);
    command(session.runs, edit);
  });
  return edit;
}

void Worker::post_begin(const std::function<void(Session&, const std::stop_token&)>& command) {
  {
    const std::lock_guard lock(mutex_);
    ++starts_;
    interrupt_.request_stop();
    interrupt_ = std::stop_source();
    commands_.push_back({[command, token = interrupt_.get_token()](Session& session) {
                           session.last.clear();
                           command(session, token);
                           session.stand_still();
                         },
                         Command::When::kBegins});
  }
  wake_.notify_all();
}

void Worker::load(const Preset& preset, const std::vector<Curve>& curves, ReferenceId reference) {
  post_begin([=](Session& session, const std::stop_token& token) {
    session.runs.load(preset, curves, reference);
    session.runs.forget_edits();
    session.runs.begin(token);
  });
}

void Worker::restart(const Preset& start) {
  post_begin([start](Session& session, const std::stop_token& token) {
    session.runs.start_from(start);
    session.runs.begin(token);
  });
}

void Worker::start_from(const Preset& start, const std::vector<Curve>& curves, ReferenceId reference) {
  post_begin([=](Session& session, const std::stop_token& token) {
    session.runs.load(start, curves, reference);
    session.runs.begin(token);
  });
}

Worker::EditId Worker::restart(const Preset& start, const std::vector<Curve>& curves, ReferenceId reference) {
  const EditId edit = ++edits_;
  post_begin([=](Session& session, const std::stop_token& token) {
    session.runs.remember(edit);
    session.runs.load(start, curves, reference);
    session.runs.begin(token);
  });
  return edit;
}

Worker::EditId Worker::keep_runs(EditId again, bool taken_back) {
  const EditId edit = again != 0 ? again : ++edits_;
  post(
      [=, this](Session& session) {
        RunGroup::Frames untaken;
        {
          const std::lock_guard lock(mutex_);
          untaken = std::exchange(newest_, {});
        }
        session.runs.keep_runs(edit, std::move(untaken), taken_back);
        session.playing = session.changed = false;
      },
      Command::When::kAtOnce);
  return edit;
}

void Worker::return_to(EditId edit, const std::vector<Curve>& curves, ReferenceId reference) {
  post_begin([=, this](Session& session, const std::stop_token& token) {
    session.replay_began = Clock::now();
    RunGroup::Frames untaken = session.runs.return_to(edit, curves, reference, token);
    const std::lock_guard lock(mutex_);
    newest_ = std::move(untaken);  // the next frames take them up
  });
}

void Worker::cut(EditId edit, double time, const std::vector<RunEdit>& later) {
  post_begin([=, this](Session& session, const std::stop_token& token) {
    session.replay_began = Clock::now();
    RunGroup::Frames untaken = session.runs.cut(edit, time, later, token);
    const std::lock_guard lock(mutex_);
    newest_ = std::move(untaken);  // the next frames take them up
  });
}

std::uint64_t Worker::show(const PastMoment& moment) {
  const std::uint64_t number = ++shows_;
  post(
      [=](Session& session) {
        session.runs.seek_past(moment);
        session.show = number;
        if (!session.shown_nothing_since) session.shown_nothing_since = Clock::now();
      },
      Command::When::kAtOnce);
  return number;
}

void Worker::set_playing(bool playing, double until) {
  post_to_runs([playing, until](Session& session) {
    session.playing = playing && !session.runs.first().lost();
    session.full_speed = false;
    session.halt.reset();
    session.end = session.runs.reaches(until) ? std::numeric_limits<double>::infinity() : until;
    session.begin_pace();
    session.begin_measurement();
    session.changed = true;
  });
}

void Worker::step_once() {
  post_to_runs([](Session& session) {
    session.playing = false;
    session.halt.reset();
    session.runs.step_first();  // the others follow
  });
}

void Worker::set_speed(double speed) {
  post([speed](Session& session) {
    session.pace.set_speed(speed);
    if (session.runs.interrupted()) return;
    session.begin_pace();
    session.begin_measurement();
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
      [=](Session& session) {
        if (!session.runs.replay_until()) session.replay_began = Clock::now();
        session.runs.undo_or_redo(edit, start, reference);
      },
      Command::When::kAtOnce);
}

void Worker::end_replay() {
  post(
      [](Session& session) {
        session.runs.end_replay();
        session.playing = false;
        session.changed = true;
      },
      Command::When::kAtOnce);
}

void Worker::run_until(double time) {
  post_to_runs([time](Session& session) {
    session.playing = !session.runs.first().lost();
    session.changed = true;
    session.full_speed = true;
    session.halt.reset();
    session.end = time;
    session.begin_measurement();
  });
}

void Worker::set_reference(ReferenceId reference) {
  post([reference](Session& session) { session.runs.compare_with(reference); });
}

void Worker::watch_stops(const std::vector<Stop>& stops) {
  post([stops](Session& session) { session.runs.watch_stops(stops); });
}

void Worker::record(const std::vector<Curve>& curves) {
  post([curves](Session& session) { session.runs.record(curves); });
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

void Worker::publish(Session& session) {
  std::vector<std::shared_ptr<Frame>> frames = session.runs.take_frames();
  for (const std::shared_ptr<Frame>& frame : frames) {
    frame->playing = session.playing;
    frame->realised_speed = session.pace.reached();
  }
  if (!session.playing && !session.runs.replay_until())
    frames.front()->scene = std::make_shared<const Scene>(scene_now(session.runs.first().simulation()));
  frames.front()->halt = session.halt;
  session.changed = false;

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
  session.last.assign(frames.begin(), frames.end());
  hand_over(session, std::move(frames));
}

void Worker::hand_over(const Session& session, std::vector<std::shared_ptr<Frame>> frames) {
  const std::lock_guard lock(mutex_);
  newest_ = std::move(frames);
  newest_start_ = session.runs.starts();
  published_.notify_all();
}

// Reports in the last published frames of all runs why they stopped.
void Worker::publish_failure(Session& session, const std::string& why) {
  std::vector<std::shared_ptr<Frame>> frames;
  for (const std::shared_ptr<const Frame>& last : session.last) {
    auto frame = std::make_shared<Frame>(*last);
    frame->rows.clear();
    frame->impacts.clear();
    frame->back_to.reset();
    frames.push_back(std::move(frame));
  }
  if (frames.empty()) frames.push_back(session.runs.empty_frame());
  for (const std::shared_ptr<Frame>& frame : frames) {
    frame->playing = false;
    frame->realised_speed = 0.0;
    frame->status = why;
    frame->lost = why;
  }
  hand_over(session, std::move(frames));
}

// During a replay only commands that undo or redo more edits are carried out, and all before a new start.
void Worker::carry_out(Session& session, std::vector<Command>& commands) {
  const auto begins = [&commands] {
    return std::any_of(commands.begin(), commands.end(),
                       [](const Command& each) { return each.when == Command::When::kBegins; });
  };
  while (!commands.empty() &&
         !(session.runs.replay_until() && commands.front().when == Command::When::kDisplayed && !begins())) {
    const Command command = std::move(commands.front());
    commands.erase(commands.begin());
    command.what(session);
  }
}

void Worker::work(const std::stop_token& stop, const Preset& first, const std::vector<Curve>& curves,
                  std::stop_token interrupt) {
  Session session;
  session.runs.load(first, curves, ReferenceId::kNone);
  std::vector<Command> commands = {{[&interrupt](Session& begun) {
                                      begun.runs.begin(std::move(interrupt));
                                      begun.stand_still();
                                    },
                                    Command::When::kBegins}};
  const auto fails = [&](const std::string& why) {
    session.interrupt();
    try {
      publish_failure(session, why);
    } catch (const std::exception&) {
      session.last.clear();
      session.runs.clear_runs();  // room for one small frame
      publish_failure(session, why);
    }
  };
  while (!stop.stop_requested()) {
    try {
      carry_out(session, commands);
      if (is_worth_a_frame(session)) publish(session);
      wait_for_work(stop, session, commands);
      carry_out(session, commands);
      if (session.runs.past().seeks()) {
        advance_past(session);
      } else if (!session.runs.interrupted()) {
        advance(stop, session);
      }
    } catch (const StepInterrupted&) {
      session.interrupt();  // a load, a restart or the end comes next
    } catch (const std::bad_alloc&) {
      fails("stopped: there is not enough memory to go on; restart, or open a smaller scene");
    } catch (const std::exception& error) {
      fails(std::string("stopped by an error of the program: ") + error.what());
    }
  }
}

bool Worker::is_worth_a_frame(const Session& session) {
  if (session.runs.replay_until() && Clock::now() - session.replay_began < kShortReplay) return false;
  return session.changed || session.runs.changed();
}

// Until there are commands, or the runs have something to do; takes the commands.
void Worker::wait_for_work(const std::stop_token& stop, const Session& session,
                           std::vector<Command>& commands) {
  const RunGroup& runs = session.runs;
  std::unique_lock lock(mutex_);
  const auto commanded = [&] { return !commands_.empty(); };
  const bool full = !runs.interrupted() && too_much_waits() && !runs.past().seeks();
  const bool at_once = !runs.interrupted() && !full &&
                       (runs.past().seeks() || runs.replay_until() || runs.some_behind() || runs.lags());
  if (full) {
    wake_.wait(lock, stop, [&] { return commanded() || !too_much_waits(); });
  } else if (!at_once && !session.playing) {
    wake_.wait(lock, stop, commanded);
  } else if (!at_once && !session.full_speed) {
    const auto pause =
        std::min<Clock::duration>(kFramePeriod, session.pace.until(runs.first().next(), Clock::now()));
    if (pause > Clock::duration::zero()) wake_.wait_for(lock, stop, pause, commanded);
  }
  std::move(commands_.begin(), commands_.end(), std::back_inserter(commands));
  commands_.clear();
}

// One frame's work on the way to a moment of the past. Where that is long, the way is shown.
void Worker::advance_past(Session& session) {
  Past& past = session.runs.past();
  const Clock::time_point end = Clock::now() + kFramePeriod;
  try {
    while (past.step() && Clock::now() < end) {
    }
  } catch (const StepInterrupted&) {
    return past.clear();  // the runs themselves were not interrupted
  }
  if (past.seeks() && Clock::now() - *session.shown_nothing_since < kPicturePeriod) return;
  session.shown_nothing_since.reset();
  if (past.seeks()) session.shown_nothing_since = Clock::now();
  const RunGroup::Frames frames = past.frames();
  const std::lock_guard lock(mutex_);
  shown_ = {{frames.begin(), frames.end()}, session.show, !past.seeks()};
  shown_start_ = session.runs.starts();
  published_.notify_all();
}

// One frame's work: recording what is recorded late, a replay, runs that lag, or playing.
void Worker::advance(const std::stop_token& stop, Session& session) {
  RunGroup& runs = session.runs;
  if (runs.catch_up(kFramePeriod)) {
    session.begin_pace();
    session.begin_measurement();
    return;
  }
  const auto now = Clock::now();
  const auto advance_to = [&](double time) {
    const RunGroup::Advance result =
        runs.advance_to(time, now + kFramePeriod, [&stop] { return stop.stop_requested(); });
    if (result == RunGroup::Advance::kRunLost) session.playing = false;
    if (result == RunGroup::Advance::kStopMet) session.halt_if_paced();
    return result == RunGroup::Advance::kReached;
  };
  if (const auto replay_until = runs.replay_until()) {
    session.changed = true;
    if (!advance_to(*replay_until)) return;
    runs.end_replay();
    session.begin_pace();
    session.begin_measurement();
    return;
  }
  if (!session.playing) {
    advance_to(runs.first().time());  // those that lag
    return;
  }
  const double due = session.full_speed ? session.end : session.pace.due(now);
  const double target = std::min(session.end, due);
  const bool there = advance_to(target);
  if (session.halt) return;
  const double time = runs.first().time();
  if (there && target >= session.end) {
    session.playing = false;
    session.changed = true;
  } else if (!there && !session.full_speed) {
    session.pace.give_up_lag(time, target, Clock::now());
  }
  session.pace.measure(time, Clock::now());
}

}  // namespace carom
