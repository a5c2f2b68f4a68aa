#include "physics/session/worker.h"

#include <algorithm>
#include <chrono>
#include <iterator>
#include <limits>
#include <map>
#include <new>
#include <optional>
#include <utility>

#include "physics/preset/preset.h"
#include "physics/session/live_run.h"

namespace carom {
namespace {

using Clock = std::chrono::steady_clock;

// Shortest time between frames; a window polls at 60 Hz.
constexpr std::chrono::milliseconds kFramePeriod{8};
// Beyond this lag the pace gives up the lost time, instead of catching up later.
constexpr double kLargestLag = 0.1;  // s
constexpr double kRounding = 1e-9;   // of a step

double seconds(Clock::duration d) { return std::chrono::duration<double>(d).count(); }

// Consecutive rows of the same curves become one table.
void append(Rows rows, std::vector<Rows>& all) {
  if (all.empty() || all.back().curves != rows.curves || rows.from_the_start) {
    all.push_back(std::move(rows));
    return;
  }
  Rows& to = all.back();
  to.times.insert(to.times.end(), rows.times.begin(), rows.times.end());
  to.values.insert(to.values.end(), rows.values.begin(), rows.values.end());
  to.moments.insert(to.moments.end(), rows.moments.begin(), rows.moments.end());
}

}  // namespace

struct Worker::Session {
  // A pending edit of a run.
  struct Coming {
    static constexpr std::int64_t kByTime = -1;

    EditId edit = 0;
    // After so many steps; by time: at the end of the first step not before `time`.
    std::int64_t step = kByTime;
    double time = 0.0;  // s
    std::variant<Method, Body> what;
  };
  struct Run {
    LiveRun live;
    std::uint64_t id;
    std::vector<EditId> edits;   // of its log
    std::vector<Coming> coming;  // in the order of time
  };
  struct PutIn {
    EditId edit;
    double time;  // s, of the first run
    Body body;
  };
  // The complete edits of one run, and of all runs, however far they have come.
  struct RunPlan {
    Method start;
    std::vector<Coming> edits;
  };
  struct Plan {
    std::uint64_t starts = 0;
    std::vector<Method> methods;
    std::vector<PutIn> put_in;
    std::vector<RunPlan> runs;
  };
  struct Past {
    Plan before, after;
  };

  void begin(std::stop_token token) {
    interrupt = std::move(token);
    ++starts;
    stands = false;
    playing = false;
    again.reset();
    end = std::numeric_limits<double>::infinity();
    runs.clear();
    last.clear();
    for (RunPlan& run : from_the_start()) begin_run(std::move(run));
    set_rate();
    changed = true;
  }
  // With the present methods; added bodies come in again at their time.
  [[nodiscard]] std::vector<RunPlan> from_the_start() const {
    std::vector<RunPlan> plans;
    for (const Method& method : methods) {
      plans.push_back({method, {}});
      for (const PutIn& each : put_in)
        plans.back().edits.push_back({each.edit, Coming::kByTime, each.time, each.body});
    }
    return plans;
  }
  void begin_run(RunPlan plan) {
    Preset alone = start;
    alone.method = plan.start;
    runs.push_back({LiveRun(setup_of(alone), curves, reference, interrupt), ++ids, {}, std::move(plan.edits)});
    give(runs.back());
    changed = true;
  }
  void add_run(const Method& method) {
    methods.push_back(method);
    if (stands) return;
    RunPlan plan = from_the_start().back();
    begin_run(std::move(plan));
  }
  void remove_run(std::size_t run) {
    if (run == 0 || run >= methods.size()) return;
    methods.erase(methods.begin() + static_cast<std::ptrdiff_t>(run));
    if (stands) return;
    runs.erase(runs.begin() + static_cast<std::ptrdiff_t>(run));
    changed = true;
  }
  void set_method(std::size_t run, const Method& method, EditId edit) {
    if (run >= methods.size()) return;
    methods[run] = method;
    if (stands) return;
    // A run that is behind gets it when it has caught up.
    const bool behind = runs[run].live.next() <= shown() + kRounding * methods[run].step;
    if (behind) {
      add_coming(runs[run], {edit, Coming::kByTime, shown(), method});
    } else {
      give(runs[run], edit, method);
    }
    changed = true;
  }
  // Bodies added before a restart may still be pending.
  void put(const Body& body, EditId edit) {
    const double time = runs.empty() ? 0.0 : shown();
    put_in.insert(std::upper_bound(put_in.begin(), put_in.end(), time,
                                   [](double t, const PutIn& other) { return t < other.time; }),
                  {edit, time, body});
    if (stands) return;
    for (Run& run : runs) {
      add_coming(run, {edit, Coming::kByTime, time, body});
      give(run);
    }
    changed = true;
  }
  static void add_coming(Run& run, const Coming& one) {
    run.coming.insert(std::upper_bound(run.coming.begin(), run.coming.end(), one.time,
                                       [](double t, const Coming& other) { return t < other.time; }),
                      one);
  }
  // Applies the edits that are due. Methods by time: at the run's step when the first run is at that time.
  static void give(Run& run) {
    while (!run.coming.empty()) {
      const Coming next = run.coming.front();
      const Simulation& now = run.live.simulation();
      const bool is_method = std::holds_alternative<Method>(next.what);
      const double rounding = kRounding * now.method().step;
      const bool due = next.step != Coming::kByTime ? next.step <= now.steps()
                       : is_method                  ? next.time + rounding < run.live.next()
                                                    : next.time <= now.time() + rounding;
      if (!due) return;
      run.coming.erase(run.coming.begin());
      give(run, next.edit, next.what);
    }
  }
  static void give(Run& run, EditId edit, const std::variant<Method, Body>& what) {
    run.live.edit(what);
    if (run.live.log().edits.size() > run.edits.size()) run.edits.push_back(edit);
  }

  [[nodiscard]] static RunPlan plan_of(const Run& run) {
    RunPlan plan{run.live.log().start.method, {}};
    for (std::size_t i = 0; i < run.edits.size(); ++i) {
      const Edit& edit = run.live.log().edits[i];
      plan.edits.push_back({run.edits[i], edit.step, edit.time, edit.what});
    }
    plan.edits.insert(plan.edits.end(), run.coming.begin(), run.coming.end());
    return plan;
  }
  // True if the run has had exactly these edits, so that it is the same bit by bit.
  [[nodiscard]] static bool is(const Run& run, const RunPlan& plan) {
    const std::vector<Coming>& all = plan.edits;
    const auto same = [](EditId edit, const Coming& coming) { return edit == coming.edit; };
    const auto same_coming = [](const Coming& a, const Coming& b) { return a.edit == b.edit; };
    const auto done = static_cast<std::ptrdiff_t>(std::min(run.edits.size(), all.size()));
    return run.live.log().start.method == plan.start &&
           std::equal(run.edits.begin(), run.edits.end(), all.begin(), all.begin() + done, same) &&
           std::equal(run.coming.begin(), run.coming.end(), all.begin() + done, all.end(), same_coming);
  }
  [[nodiscard]] Plan plan() const {
    Plan all{starts, methods, put_in, {}};
    for (const Run& run : runs) all.runs.push_back(plan_of(run));
    return all;
  }
  // Unchanged runs continue as they are; interrupted runs change at the next restart.
  void restore(const Plan& plan) {
    methods = plan.methods;
    put_in = plan.put_in;
    if (stands) return;
    const double time = shown();
    std::vector<Run> old = std::exchange(runs, {});
    for (RunPlan& each : plan.starts == starts ? std::vector<RunPlan>(plan.runs) : from_the_start()) {
      const auto same = std::find_if(old.begin(), old.end(), [&](const Run& run) { return is(run, each); });
      if (same == old.end()) {
        begin_run(std::move(each));
      } else {
        runs.push_back(std::move(*same));
        old.erase(same);
      }
    }
    if (first().time() < time) again = time;
    changed = true;
  }
  // s, of the first run: its time, or the time to which it is being replayed.
  [[nodiscard]] double shown() const { return again.value_or(runs.front().live.time()); }

  [[nodiscard]] LiveRun& first() { return runs.front().live; }
  // Steps the runs, the one farthest behind first, until all that are not lost are within a step of `time`.
  // False if `deadline` came first.
  template <class Stop>
  bool go_to(double time, Clock::time_point deadline, const Stop& stop) {
    while (true) {
      Run& run = *std::min_element(runs.begin(), runs.end(),
                                   [](const Run& a, const Run& b) { return a.live.next() < b.live.next(); });
      if (run.live.next() > time + kRounding * run.live.simulation().method().step) return true;
      if (Clock::now() >= deadline || stop()) return false;
      step(run);
      if (run.live.lost()) return false;
      give(run);
    }
  }
  void load(const Preset& preset, const std::vector<Curve>& what) {
    start = preset;
    methods = {preset.method};
    methods.insert(methods.end(), preset.compare.begin(), preset.compare.end());
    put_in.clear();
    past.clear();
    curves = what;
  }
  // Until the next begin(): the runs were interrupted in the middle of a step.
  void stand() {
    stands = true;
    playing = false;
    changed = false;
    again.reset();
  }
  void step(Run& run) {
    run.live.step();
    changed = true;
    if (run.live.lost()) playing = false;
  }
  [[nodiscard]] bool some_lag() {
    const double time = first().time();
    return std::any_of(runs.begin(), runs.end(), [time](const Run& run) {
      return run.live.next() <= time + kRounding * run.live.simulation().method().step;
    });
  }
  [[nodiscard]] bool some_behind() const {
    return std::any_of(runs.begin(), runs.end(), [](const Run& run) { return run.live.behind(); });
  }
  void record() {
    if (stands) return;
    for (Run& run : runs) run.live.record(curves, reference);
    changed = true;
  }
  // For about this long; the runs themselves wait.
  void catch_up(Clock::duration duration) {
    const auto run = std::find_if(runs.begin(), runs.end(), [](const Run& r) { return r.live.behind(); });
    if (run == runs.end()) return;
    run->live.catch_up(duration);
    changed = true;
    set_pace();
    set_rate();
  }
  // Restarts the pace from here.
  void set_pace() {
    pace_wall = Clock::now();
    pace_time = first().time();
  }
  // Restarts the measurement of the realised speed from here.
  void set_rate() {
    realised_speed = 0.0;
    rate_wall = Clock::now();
    rate_time = first().time();
  }

  std::stop_token interrupt;
  bool stands = false;          // the runs were interrupted in the middle of a step and are unusable
  Preset start;                 // as loaded
  std::vector<Method> methods;  // in force, of all runs
  std::vector<Curve> curves;
  ReferenceId reference = ReferenceId::kNone;
  std::vector<Run> runs;
  std::vector<std::shared_ptr<const Frame>> last;  // published
  std::vector<PutIn> put_in;                       // in the order of time
  std::map<EditId, Past> past;
  std::optional<double> again;  // s: time to which a restarted first run is replayed
  std::uint64_t starts = 0;
  std::uint64_t ids = 0;
  bool playing = false;
  bool changed = true;
  double speed = 1.0;
  double end = 0.0;  // s; a playing run stops here
  bool full_speed = false;
  Clock::time_point pace_wall = Clock::now();
  double pace_time = 0.0;
  Clock::time_point rate_wall = Clock::now();
  double rate_time = 0.0;
  double realised_speed = 0.0;
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
    if (!session.stands) command(session);
  });
}

Worker::EditId Worker::post_edit(const std::function<void(Session&, EditId)>& command, EditId part_of) {
  const EditId edit = part_of != 0 ? part_of : ++edits_;
  post([=](Session& session) {
    if (part_of == 0) session.past[edit].before = session.plan();
    command(session, edit);
  });
  return edit;
}

void Worker::post_restored(EditId edit, ReferenceId reference, bool back) {
  post(
      [=](Session& session) {
        const auto past = session.past.find(edit);
        if (past == session.past.end()) return;
        if (back) past->second.after = session.plan();
        const bool other = std::exchange(session.reference, reference) != reference;
        session.restore(back ? past->second.before : past->second.after);
        if (other) session.record();
      },
      Command::When::kAtOnce);
}

void Worker::post_begin(const std::function<void(Session&, std::stop_token)>& command) {
  {
    const std::lock_guard lock(mutex_);
    ++starts_;
    interrupt_.request_stop();
    interrupt_ = std::stop_source();
    commands_.push_back(
        {[command, token = interrupt_.get_token()](Session& session) { command(session, token); },
         Command::When::kBegins});
  }
  wake_.notify_all();
}

void Worker::load(const Preset& preset, const std::vector<Curve>& curves, ReferenceId reference) {
  post_begin([preset, curves, reference](Session& session, std::stop_token interrupt) {
    session.load(preset, curves);
    session.reference = reference;
    session.begin(std::move(interrupt));
  });
}

void Worker::restart() {
  post_begin([](Session& session, std::stop_token interrupt) { session.begin(std::move(interrupt)); });
}

Worker::EditId Worker::restart(const Method& method, const std::vector<Method>& compare,
                               const std::vector<Curve>& curves, ReferenceId reference) {
  const EditId edit = ++edits_;
  post_begin([=](Session& session, std::stop_token interrupt) {
    session.past[edit].before = session.plan();
    session.methods = {method};
    session.methods.insert(session.methods.end(), compare.begin(), compare.end());
    session.curves = curves;
    session.reference = reference;
    session.begin(std::move(interrupt));
  });
  return edit;
}

void Worker::set_playing(bool playing, double until) {
  post_to_runs([playing, until](Session& session) {
    session.playing = playing && !session.first().lost();
    session.full_speed = false;
    const double rounding = kRounding * session.first().simulation().method().step;
    session.end = until >= session.first().next() - rounding ? until : std::numeric_limits<double>::infinity();
    session.set_pace();
    session.set_rate();
    session.changed = true;
  });
}

void Worker::step_once() {
  post_to_runs([](Session& session) {
    session.playing = false;
    session.step(session.runs.front());  // the others follow
  });
}

void Worker::set_speed(double speed) {
  post([speed](Session& session) {
    session.speed = speed;
    if (session.stands) return;
    session.set_pace();
    session.set_rate();
  });
}

Worker::EditId Worker::set_methods(const std::vector<std::pair<std::size_t, Method>>& methods, EditId part_of) {
  const auto set = [methods](Session& session, EditId edit) {
    for (const auto& [run, method] : methods) session.set_method(run, method, edit);
  };
  return post_edit(set, part_of);
}

Worker::EditId Worker::add_method(const Method& method) {
  return post_edit([method](Session& session, EditId) {
    if (session.methods.size() <= kMostCompared) session.add_run(method);
  });
}

Worker::EditId Worker::remove_method(std::size_t run) {
  return post_edit([run](Session& session, EditId) { session.remove_run(run); });
}

void Worker::set_reference(ReferenceId reference) {
  post([reference](Session& session) {
    session.reference = reference;
    session.record();
  });
}

Worker::EditId Worker::add_body(const Body& body) {
  return post_edit([body](Session& session, EditId edit) { session.put(body, edit); });
}

void Worker::take_back(EditId edit, ReferenceId reference) { post_restored(edit, reference, true); }

void Worker::put_back(EditId edit, ReferenceId reference) { post_restored(edit, reference, false); }

void Worker::run_until(double time) {
  post_to_runs([time](Session& session) {
    session.playing = !session.first().lost();
    session.changed = true;
    session.full_speed = true;
    session.end = time;
    session.set_rate();
  });
}

void Worker::record(const std::vector<Curve>& curves) {
  post([curves](Session& session) {
    session.curves = curves;
    session.record();
  });
}

std::vector<std::shared_ptr<const Frame>> Worker::take_frames() {
  const std::lock_guard lock(mutex_);
  if (newest_start_ != starts_) return {};  // from before the last load or restart
  if (too_much_waits()) wake_.notify_all();
  const auto taken = std::exchange(newest_, {});
  return {taken.begin(), taken.end()};
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
  std::vector<std::shared_ptr<Frame>> frames;
  for (Session::Run& run : session.runs) {
    const std::shared_ptr<Frame> frame = run.live.take_frame();
    frame->run = run.id;
    frame->playing = session.playing;
    frame->realised_speed = session.realised_speed;
    frame->again = session.again;
    frames.push_back(frame);
  }
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
    if (same == frames.end()) continue;
    Frame& frame = **same;
    std::swap(frame.rows, before->rows);
    for (Rows& rows : before->rows) append(std::move(rows), frame.rows);
    std::swap(frame.impacts, before->impacts);
    frame.impacts.insert(frame.impacts.end(), before->impacts.begin(), before->impacts.end());
  }
  session.last.assign(frames.begin(), frames.end());
  const std::lock_guard lock(mutex_);
  newest_ = std::move(frames);
  newest_start_ = session.starts;
  published_.notify_all();
}

// Reports in the last published frames of all runs why they stopped.
void Worker::publish_failure(Session& session, const std::string& why) {
  std::vector<std::shared_ptr<Frame>> frames;
  for (const std::shared_ptr<const Frame>& last : session.last) {
    auto frame = std::make_shared<Frame>(*last);
    frame->rows.clear();
    frame->impacts.clear();
    frames.push_back(std::move(frame));
  }
  if (frames.empty()) {
    // There was not even a first frame.
    frames.push_back(std::make_shared<Frame>());
    frames.front()->run = ++session.ids;
    frames.front()->bodies = std::make_shared<const std::vector<Body>>();
    frames.front()->forces = std::make_shared<const Forces>();
    frames.front()->log = std::make_shared<const RunLog>(RunLog{setup_of(session.start), {}});
  }
  for (const std::shared_ptr<Frame>& frame : frames) {
    frame->playing = false;
    frame->realised_speed = 0.0;
    frame->status = why;
    frame->lost = why;
  }
  const std::lock_guard lock(mutex_);
  newest_ = std::move(frames);
  newest_start_ = session.starts;
  published_.notify_all();
}

// During a replay only commands that undo more edits, or start all again, are carried out.
void Worker::carry_out(Session& session, std::vector<Command>& commands) {
  if (std::any_of(commands.begin(), commands.end(),
                  [](const Command& each) { return each.when == Command::When::kBegins; }))
    session.again.reset();
  while (!commands.empty() && !(session.again && commands.front().when == Command::When::kShown)) {
    const Command command = std::move(commands.front());
    commands.erase(commands.begin());
    command.what(session);
  }
}

void Worker::work(const std::stop_token& stop, const Preset& first, const std::vector<Curve>& curves,
                  std::stop_token interrupt) {
  Session session;
  session.load(first, curves);
  std::vector<Command> commands = {
      {[&interrupt](Session& l) { l.begin(std::move(interrupt)); }, Command::When::kBegins}};
  const auto fails = [&](const std::string& why) {
    session.stand();
    try {
      publish_failure(session, why);
    } catch (const std::exception&) {
      session.last.clear();
      session.runs.clear();  // room for one small frame
      publish_failure(session, why);
    }
  };
  while (!stop.stop_requested()) {
    try {
      work_once(stop, session, commands);
    } catch (const StepInterrupted&) {
      session.stand();  // a load, a restart or the end comes next
    } catch (const std::bad_alloc&) {
      fails("stopped: there is not enough memory to go on; restart, or open a smaller scene");
    } catch (const std::exception& error) {
      fails(std::string("stopped by an error of the program: ") + error.what());
    }
  }
}

void Worker::work_once(const std::stop_token& stop, Session& session, std::vector<Command>& commands) {
  carry_out(session, commands);
  if (session.changed) publish(session);
  {
    std::unique_lock lock(mutex_);
    const auto something_to_do = [&] { return !commands_.empty(); };
    if (session.stands) {
      wake_.wait(lock, stop, something_to_do);
    } else if (too_much_waits()) {
      wake_.wait(lock, stop, [&] { return something_to_do() || !too_much_waits(); });
    } else if (session.again || session.some_behind() || session.some_lag()) {
      // continues at once
    } else if (!session.playing) {
      wake_.wait(lock, stop, something_to_do);
    } else if (!session.full_speed) {
      // Wait until the next step is due.
      const double due = (session.first().next() - session.pace_time) / session.speed;
      const auto pause = std::min<Clock::duration>(
          kFramePeriod, std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(due)) -
                            (Clock::now() - session.pace_wall));
      if (pause > Clock::duration::zero()) wake_.wait_for(lock, stop, pause, something_to_do);
    }
    std::move(commands_.begin(), commands_.end(), std::back_inserter(commands));
    commands_.clear();
  }
  carry_out(session, commands);
  if (session.stands) return;

  if (session.some_behind()) {
    session.catch_up(kFramePeriod);
    return;
  }
  const auto begin = Clock::now();
  const auto stops = [&stop] { return stop.stop_requested(); };
  if (session.again) {
    session.changed = true;
    if (!session.go_to(*session.again, begin + kFramePeriod, stops)) return;
    session.again.reset();
    session.set_pace();
    session.set_rate();
    return;
  }
  if (!session.playing) {
    (void)session.go_to(session.first().time(), begin + kFramePeriod, stops);  // those that lag
    return;
  }
  const double target =
      session.full_speed
          ? session.end
          : std::min(session.end, session.pace_time + seconds(begin - session.pace_wall) * session.speed);
  const bool there = session.go_to(target, begin + kFramePeriod, stops);
  const double time = session.first().time();
  if (there && target >= session.end) {
    session.playing = false;
    session.changed = true;
  } else if (!there && !session.full_speed && (target - time) / session.speed > kLargestLag) {
    session.set_pace();
  }
  if (const double wall = seconds(Clock::now() - session.rate_wall); wall > 0.5) {
    session.realised_speed = (time - session.rate_time) / wall;
    session.rate_wall = Clock::now();
    session.rate_time = time;
  }
}

}  // namespace carom
