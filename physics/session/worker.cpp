#include "physics/session/worker.h"

#include <algorithm>
#include <chrono>
#include <limits>
#include <new>
#include <utility>

#include "physics/preset/preset.h"
#include "physics/session/lane.h"

namespace carom {
namespace {

using Clock = std::chrono::steady_clock;

// Frames are published this often at the most; a window polls at 60 Hz.
constexpr std::chrono::milliseconds kFramePeriod{8};
// Behind by more than this, the pace gives up the time it could not keep, instead of racing after it later.
constexpr double kLargestLag = 0.1;  // s
constexpr double kRounding = 1e-9;   // of a step

double seconds(Clock::duration d) { return std::chrono::duration<double>(d).count(); }

// Rows of the same curves that follow one another become one table.
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

struct Worker::Lab {
  // A run, and how many of the bodies that were put in it has been given.
  struct Run {
    Lane lane;
    std::uint64_t id;
    std::size_t given = 0;
  };
  struct PutIn {
    double time;  // s, of the first run
    Body body;
  };

  void begin(std::stop_token token) {
    interrupt = std::move(token);
    ++starts;
    stands = false;
    playing = false;
    end = std::numeric_limits<double>::infinity();
    start = preset;
    start.scene.bodies.resize(start.scene.bodies.size() - put_in.size());
    runs.clear();
    last.clear();
    add_run(preset.method);
    for (const Method& method : preset.compare) add_run(method);
    set_rate();
    changed = true;
  }
  // The scene as it would be saved now. Bodies that runs which stand could not take come in when they did
  // stand.
  void take_scene(const Preset& now) {
    const double time = runs.empty() ? 0.0 : first().time();
    for (std::size_t i = preset.scene.bodies.size(); i < now.scene.bodies.size(); ++i)
      (void)put_in_at(time, now.scene.bodies[i]);
    preset = now;
  }
  // At its place in the order of times.
  std::size_t put_in_at(double time, const Body& body) {
    const auto at = std::upper_bound(put_in.begin(), put_in.end(), time,
                                     [](double t, const PutIn& other) { return t < other.time; });
    return static_cast<std::size_t>(put_in.insert(at, {time, body}) - put_in.begin());
  }
  void add_run(const Method& method) {
    Preset alone = start;
    alone.method = method;
    alone.compare.clear();
    runs.push_back({Lane(setup_of(alone), curves, reference, interrupt), ++ids});
    give_bodies(runs.back());
    changed = true;
  }
  [[nodiscard]] Lane& first() { return runs.front().lane; }
  // Bodies that were put in before a restart may be still to come.
  void put(const Body& body) {
    preset.scene.bodies.push_back(body);
    const std::size_t place = put_in_at(first().time(), body);
    for (Run& run : runs) {
      if (place < run.given) {  // it is ahead, and has been given one of later
        run.lane.edit(body);
        ++run.given;
      } else {
        give_bodies(run);
      }
    }
    changed = true;
  }
  // Bodies come in at the first step's end that is not before they came into the first run.
  void give_bodies(Run& run) {
    while (run.given < put_in.size() &&
           put_in[run.given].time <= run.lane.time() + kRounding * run.lane.simulation().method().step) {
      run.lane.edit(put_in[run.given++].body);
    }
  }
  // Steps the runs that are not lost, that which is farthest behind first, until all of them are at `time`:
  // within a step of it. False if it was `deadline` before.
  template <class Stop>
  bool go_to(double time, Clock::time_point deadline, const Stop& stop) {
    while (true) {
      Run& run = *std::min_element(runs.begin(), runs.end(),
                                   [](const Run& a, const Run& b) { return a.lane.next() < b.lane.next(); });
      if (run.lane.next() > time + kRounding * run.lane.simulation().method().step) return true;
      if (Clock::now() >= deadline || stop()) return false;
      step(run);
      if (run.lane.lost()) return false;
      give_bodies(run);
    }
  }
  void step(Run& run) {
    run.lane.step();
    changed = true;
    if (run.lane.lost()) playing = false;
  }
  [[nodiscard]] bool some_lag() {
    const double time = first().time();
    return std::any_of(runs.begin(), runs.end(), [time](const Run& run) {
      return run.lane.next() <= time + kRounding * run.lane.simulation().method().step;
    });
  }
  [[nodiscard]] bool some_behind() const {
    return std::any_of(runs.begin(), runs.end(), [](const Run& run) { return run.lane.behind(); });
  }
  void record() {
    for (Run& run : runs) run.lane.record(curves, reference);
    changed = true;
  }
  // For about so long; the runs themselves wait for it.
  void catch_up(Clock::duration duration) {
    const auto run = std::find_if(runs.begin(), runs.end(), [](const Run& r) { return r.lane.behind(); });
    if (run == runs.end()) return;
    run->lane.catch_up(duration);
    changed = true;
    set_pace();
    set_rate();
  }
  // The pace is counted anew from here.
  void set_pace() {
    pace_wall = Clock::now();
    pace_time = first().time();
  }
  // The realised speed is measured anew from here.
  void set_rate() {
    realised_speed = 0.0;
    rate_wall = Clock::now();
    rate_time = first().time();
  }

  std::stop_token interrupt;
  bool stands = false;  // the runs were left in the midst of a step: nothing can be done with them
  Preset preset;        // as it would be saved now
  Preset start;         // at t = 0 of these runs
  std::vector<Curve> curves;
  ReferenceId reference = ReferenceId::kNone;
  std::vector<Run> runs;
  std::vector<std::shared_ptr<const Frame>> last;  // published
  std::vector<PutIn> put_in;
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
    : preset_(preset),
      thread_([this, preset, curves, interrupt = interrupt_.get_token()](const std::stop_token& stop) {
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

void Worker::post(std::function<void(Lab&)> command) {
  {
    const std::lock_guard lock(mutex_);
    commands_.push_back({std::move(command), false});
  }
  wake_.notify_all();
}

void Worker::post_begin(const std::function<void(Lab&, std::stop_token)>& command) {
  {
    const std::lock_guard lock(mutex_);
    ++starts_;
    interrupt_.request_stop();
    interrupt_ = std::stop_source();
    commands_.push_back({[command, token = interrupt_.get_token()](Lab& lab) { command(lab, token); }, true});
  }
  wake_.notify_all();
}

void Worker::load(const Preset& preset, const std::vector<Curve>& curves, ReferenceId reference) {
  {
    const std::lock_guard lock(mutex_);
    preset_ = preset;
  }
  post_begin([preset, curves, reference](Lab& lab, std::stop_token interrupt) {
    lab.preset = preset;
    lab.put_in.clear();
    lab.curves = curves;
    lab.reference = reference;
    lab.begin(std::move(interrupt));
  });
}

void Worker::restart() {
  post_begin([preset = preset()](Lab& lab, std::stop_token interrupt) {
    lab.take_scene(preset);
    lab.begin(std::move(interrupt));
  });
}

void Worker::restart(const Method& method, const std::vector<Method>& compare, const std::vector<Curve>& curves,
                     ReferenceId reference) {
  {
    const std::lock_guard lock(mutex_);
    preset_.method = method;
    preset_.compare = compare;
  }
  post_begin([preset = preset(), curves, reference](Lab& lab, std::stop_token interrupt) {
    lab.take_scene(preset);
    lab.curves = curves;
    lab.reference = reference;
    lab.begin(std::move(interrupt));
  });
}

void Worker::set_playing(bool playing, double until) {
  post([playing, until](Lab& lab) {
    lab.playing = playing && !lab.first().lost();
    lab.full_speed = false;
    const double rounding = kRounding * lab.first().simulation().method().step;
    lab.end = until >= lab.first().next() - rounding ? until : std::numeric_limits<double>::infinity();
    lab.set_pace();
    lab.set_rate();
    lab.changed = true;
  });
}

void Worker::step_once() {
  post([](Lab& lab) {
    lab.playing = false;
    lab.step(lab.runs.front());  // the others follow
  });
}

void Worker::set_speed(double speed) {
  post([speed](Lab& lab) {
    lab.speed = speed;
    lab.set_pace();
    lab.set_rate();
  });
}

void Worker::set_method(const Method& method, std::size_t run) {
  const auto set = [method, run](Preset& preset) {
    if (run == 0) preset.method = method;
    if (run > 0 && run <= preset.compare.size()) preset.compare[run - 1] = method;
  };
  {
    const std::lock_guard lock(mutex_);
    set(preset_);
  }
  post([method, run, set](Lab& lab) {
    set(lab.preset);
    if (run >= lab.runs.size()) return;
    lab.runs[run].lane.edit(method);
    lab.changed = true;
  });
}

void Worker::add_method(const Method& method) {
  {
    const std::lock_guard lock(mutex_);
    if (preset_.compare.size() >= kMostCompared) return;
    preset_.compare.push_back(method);
  }
  post([method](Lab& lab) {
    lab.preset.compare.push_back(method);
    lab.add_run(method);
  });
}

void Worker::remove_method(std::size_t run) {
  const auto remove = [run](Preset& preset) {
    if (run > 0 && run <= preset.compare.size())
      preset.compare.erase(preset.compare.begin() + static_cast<std::ptrdiff_t>(run) - 1);
  };
  {
    const std::lock_guard lock(mutex_);
    remove(preset_);
  }
  post([run, remove](Lab& lab) {
    remove(lab.preset);
    if (run == 0 || run >= lab.runs.size()) return;
    lab.runs.erase(lab.runs.begin() + static_cast<std::ptrdiff_t>(run));
    lab.changed = true;
  });
}

void Worker::set_reference(ReferenceId reference) {
  post([reference](Lab& lab) {
    lab.reference = reference;
    lab.record();
  });
}

void Worker::add_body(const Body& body) {
  {
    const std::lock_guard lock(mutex_);
    preset_.scene.bodies.push_back(body);
  }
  post([body](Lab& lab) { lab.put(body); });
}

void Worker::run_until(double time) {
  post([time](Lab& lab) {
    lab.playing = !lab.first().lost();
    lab.changed = true;
    lab.full_speed = true;
    lab.end = time;
    lab.set_rate();
  });
}

void Worker::record(const std::vector<Curve>& curves) {
  post([curves](Lab& lab) {
    lab.curves = curves;
    lab.record();
  });
}

Preset Worker::preset() const {
  const std::lock_guard lock(mutex_);
  return preset_;
}

std::vector<std::shared_ptr<const Frame>> Worker::take_frames() {
  const std::lock_guard lock(mutex_);
  if (newest_start_ != starts_) return {};  // of before the last load or restart
  if (too_much_waits()) wake_.notify_all();
  const auto taken = std::exchange(newest_, {});
  return {taken.begin(), taken.end()};
}

bool Worker::too_much_waits() const {
  std::size_t numbers = 0;
  for (const std::shared_ptr<Frame>& frame : newest_) {
    numbers += frame->impacts.size();
    for (const Rows& rows : frame->rows) numbers += rows.size() + rows.values.size();
  }
  return numbers > kMostWaiting;
}

void Worker::publish(Lab& lab) {
  std::vector<std::shared_ptr<Frame>> frames;
  for (Lab::Run& run : lab.runs) {
    const std::shared_ptr<Frame> frame = run.lane.take_frame();
    frame->run = run.id;
    frame->playing = lab.playing;
    frame->realised_speed = lab.realised_speed;
    frames.push_back(frame);
  }
  lab.changed = false;

  std::vector<std::shared_ptr<Frame>> waiting;
  {
    const std::lock_guard lock(mutex_);
    waiting = std::exchange(newest_, {});
  }
  // Where nobody took the frames before, their news go on with these.
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
  lab.last.assign(frames.begin(), frames.end());
  const std::lock_guard lock(mutex_);
  newest_ = std::move(frames);
  newest_start_ = lab.starts;
}

// Says in the frames of all runs, as they were published last, why they stand.
void Worker::publish_failure(Lab& lab, const std::string& why) {
  std::vector<std::shared_ptr<Frame>> frames;
  for (const std::shared_ptr<const Frame>& last : lab.last) {
    auto frame = std::make_shared<Frame>(*last);
    frame->rows.clear();
    frame->impacts.clear();
    frames.push_back(std::move(frame));
  }
  if (frames.empty()) {
    // Not even a first frame came about.
    frames.push_back(std::make_shared<Frame>());
    frames.front()->run = ++lab.ids;
    frames.front()->bodies = std::make_shared<const std::vector<Body>>();
    frames.front()->forces = std::make_shared<const Forces>();
    frames.front()->log = std::make_shared<const RunLog>(RunLog{setup_of(lab.preset), {}});
  }
  for (const std::shared_ptr<Frame>& frame : frames) {
    frame->playing = false;
    frame->realised_speed = 0.0;
    frame->status = why;
    frame->lost = why;
  }
  const std::lock_guard lock(mutex_);
  newest_ = std::move(frames);
  newest_start_ = lab.starts;
}

// Of runs that stand, only what begins all anew.
void Worker::carry_out(Lab& lab, std::vector<Command>& commands) {
  while (!commands.empty()) {
    const Command command = std::move(commands.front());
    commands.erase(commands.begin());
    if (!lab.stands || command.begins) command.what(lab);
  }
}

void Worker::work(const std::stop_token& stop, const Preset& first, const std::vector<Curve>& curves,
                  std::stop_token interrupt) {
  Lab lab;
  lab.preset = first;  // not scene_, which calls may have changed already
  lab.curves = curves;
  std::vector<Command> commands = {{[&interrupt](Lab& l) { l.begin(std::move(interrupt)); }, true}};
  const auto fails = [&](const std::string& why) {
    lab.stands = true;
    lab.playing = false;
    lab.changed = false;
    try {
      publish_failure(lab, why);
    } catch (const std::exception&) {
      lab.last.clear();
      lab.runs.clear();  // room for one small frame
      publish_failure(lab, why);
    }
  };
  while (!stop.stop_requested()) {
    try {
      work_once(stop, lab, commands);
    } catch (const StepInterrupted&) {
      // A load or a restart comes next, or the end.
      lab.stands = true;
      lab.playing = false;
      lab.changed = false;
    } catch (const std::bad_alloc&) {
      fails("stopped: there is not enough memory to go on; restart, or open a smaller scene");
    } catch (const std::exception& error) {
      fails(std::string("stopped by an error of the program: ") + error.what());
    }
  }
}

void Worker::work_once(const std::stop_token& stop, Lab& lab, std::vector<Command>& commands) {
  carry_out(lab, commands);
  if (lab.changed) publish(lab);
  {
    std::unique_lock lock(mutex_);
    const auto something_to_do = [&] { return !commands_.empty(); };
    if (lab.stands) {
      wake_.wait(lock, stop, something_to_do);
    } else if (too_much_waits()) {
      wake_.wait(lock, stop, [&] { return something_to_do() || !too_much_waits(); });
    } else if (lab.some_behind() || lab.some_lag()) {
      // goes on at once
    } else if (!lab.playing) {
      wake_.wait(lock, stop, something_to_do);
    } else if (!lab.full_speed) {
      // Until the next step is due.
      const double due = (lab.first().next() - lab.pace_time) / lab.speed;
      const auto pause = std::min<Clock::duration>(
          kFramePeriod, std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(due)) -
                            (Clock::now() - lab.pace_wall));
      if (pause > Clock::duration::zero()) wake_.wait_for(lock, stop, pause, something_to_do);
    }
    std::swap(commands, commands_);
  }
  carry_out(lab, commands);
  if (lab.stands) return;

  if (lab.some_behind()) {
    lab.catch_up(kFramePeriod);
    return;
  }
  const auto begin = Clock::now();
  const auto stops = [&stop] { return stop.stop_requested(); };
  if (!lab.playing) {
    (void)lab.go_to(lab.first().time(), begin + kFramePeriod, stops);  // those that lag
    return;
  }
  const double target =
      lab.full_speed ? lab.end : std::min(lab.end, lab.pace_time + seconds(begin - lab.pace_wall) * lab.speed);
  const bool there = lab.go_to(target, begin + kFramePeriod, stops);
  const double time = lab.first().time();
  if (there && target >= lab.end) {
    lab.playing = false;
    lab.changed = true;
  } else if (!there && !lab.full_speed && (target - time) / lab.speed > kLargestLag) {
    lab.set_pace();
  }
  if (const double wall = seconds(Clock::now() - lab.rate_wall); wall > 0.5) {
    lab.realised_speed = (time - lab.rate_time) / wall;
    lab.rate_wall = Clock::now();
    lab.rate_time = time;
  }
}

}  // namespace carom
