#include "physics/experiment/worker.h"

#include <algorithm>
#include <chrono>
#include <limits>
#include <optional>
#include <utility>

#include "physics/experiment/run_log.h"

namespace carom {
namespace {

using Clock = std::chrono::steady_clock;

// Frames are published this often at the most; a window polls at 60 Hz.
constexpr std::chrono::milliseconds kFramePeriod{8};
// Behind by more than this, the pace gives up the time it could not keep, instead of racing after it later.
constexpr double kLargestLag = 0.1;  // s

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
}

}  // namespace

struct Worker::Lab {
  // Goes through the run once more, for curves that were not recorded from its start on.
  struct CatchUp {
    Replay replay;
    Sampler sampler;
  };

  Lab(const Scene& s, const std::vector<Curve>& c)
      : scene(s), log(std::make_shared<RunLog>(RunLog{s, {}})), simulation(s), curves(c) {
    begin();
  }

  void begin() {
    log = std::make_shared<RunLog>(RunLog{scene, {}});
    simulation = Simulation(scene);
    simulation.watch_impacts(true);
    bodies = std::make_shared<const std::vector<Body>>(simulation.bodies());
    forces = std::make_shared<const Forces>(scene.forces);
    ++run;
    playing = false;
    end = std::numeric_limits<double>::infinity();
    sampler = Sampler(curves);
    sampler.begin(simulation);
    catch_up.reset();
    rows.clear();
    impacts.clear();
    set_rate();
    changed = true;
  }
  void step() {
    simulation.step();
    sampler.after_step(simulation);
    impacts.insert(impacts.end(), simulation.last_impacts().begin(), simulation.last_impacts().end());
    changed = true;
  }
  void edit(const Edit& what) {
    RunLog longer = *log;  // frames hold the one before
    longer.edits.push_back(what);
    log = std::make_shared<RunLog>(std::move(longer));
    apply(what, simulation);
    bodies = std::make_shared<const std::vector<Body>>(simulation.bodies());
    sampler.after_edit(simulation);
    changed = true;
  }
  void record(const std::vector<Curve>& wanted) {
    curves = wanted;
    std::vector<Curve> missing;
    for (const Curve& curve : wanted) {
      const std::vector<Curve>& known = sampler.curves();
      if (std::find(known.begin(), known.end(), curve) == known.end()) missing.push_back(curve);
    }
    catch_up.reset();
    if (missing.empty()) {
      rows.push_back(sampler.take());
      sampler.set_curves(wanted);
    } else {
      catch_up.emplace(Replay(log->start), Sampler(missing, wanted));
      catch_up->sampler.begin(catch_up->replay.simulation());
    }
  }
  // Until the replay is where the run is, or for about so long. The run itself waits for it.
  void catch_up_for(Clock::duration duration) {
    if (!catch_up) return;
    const auto begin = Clock::now();
    Replay& replay = catch_up->replay;
    Sampler& past = catch_up->sampler;
    do {
      while (replay.edit(*log)) past.after_edit(replay.simulation());
      if (replay.simulation().steps() == simulation.steps()) {
        rows.push_back(sampler.take());
        rows.push_back(past.take());
        sampler = std::move(past);
        sampler.set_curves(curves);
        set_pace();
        set_rate();
        catch_up.reset();
        changed = true;
        return;
      }
      replay.step();
      past.after_step(replay.simulation());
    } while (Clock::now() - begin < duration);
    changed = true;
  }
  // The pace is counted anew from here.
  void set_pace() {
    pace_wall = Clock::now();
    pace_time = simulation.time();
  }

  // The realised speed is measured anew from here.
  void set_rate() {
    realised_speed = 0.0;
    rate_wall = Clock::now();
    rate_time = simulation.time();
  }

  Scene scene;                        // as it would be saved now
  std::shared_ptr<const RunLog> log;  // of the run since its start
  Simulation simulation;
  std::shared_ptr<const std::vector<Body>> bodies;
  std::shared_ptr<const Forces> forces;
  std::uint64_t run = 0;
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
  std::vector<Curve> curves;
  Sampler sampler{curves};
  std::optional<CatchUp> catch_up;
  std::vector<Rows> rows;  // that wait beside the samplers' own
  std::vector<ImpactRecord> impacts;
};

Worker::Worker(const Scene& scene, const std::vector<Curve>& curves)
    : scene_(scene),
      thread_([this, scene, curves](const std::stop_token& stop) { work(stop, scene, curves); }) {}

Worker::~Worker() {
  thread_.request_stop();
  wake_.notify_all();
}

void Worker::post(std::function<void(Lab&)> command) {
  {
    const std::lock_guard lock(mutex_);
    commands_.push_back(std::move(command));
  }
  wake_.notify_all();
}

void Worker::load(const Scene& scene, const std::vector<Curve>& curves) {
  {
    const std::lock_guard lock(mutex_);
    scene_ = scene;
    ++run_;
  }
  post([scene, curves](Lab& lab) {
    lab.scene = scene;
    lab.curves = curves;
    lab.begin();
  });
}

void Worker::restart() {
  {
    const std::lock_guard lock(mutex_);
    ++run_;
  }
  post([](Lab& lab) { lab.begin(); });
}

void Worker::set_playing(bool playing, double until) {
  post([playing, until](Lab& lab) {
    lab.playing = playing;
    lab.full_speed = false;
    const double next = lab.simulation.time() + lab.simulation.method().step;
    lab.end = until >= next ? until : std::numeric_limits<double>::infinity();
    lab.set_pace();
    lab.set_rate();
    lab.changed = true;
  });
}

void Worker::step_once() {
  post([](Lab& lab) {
    lab.playing = false;
    lab.step();
  });
}

void Worker::set_speed(double speed) {
  post([speed](Lab& lab) {
    lab.speed = speed;
    lab.set_pace();
    lab.set_rate();
  });
}

void Worker::set_method(const Method& method) {
  {
    const std::lock_guard lock(mutex_);
    scene_.method = method;
  }
  post([method](Lab& lab) {
    lab.scene.method = method;
    lab.edit({lab.simulation.steps(), method});
  });
}

void Worker::add_body(const Body& body) {
  {
    const std::lock_guard lock(mutex_);
    scene_.bodies.push_back(body);
  }
  post([body](Lab& lab) {
    lab.scene.bodies.push_back(body);
    lab.edit({lab.simulation.steps(), body});
  });
}

void Worker::run_until(double time) {
  post([time](Lab& lab) {
    lab.playing = true;
    lab.full_speed = true;
    lab.end = time;
    lab.set_rate();
  });
}

void Worker::record(const std::vector<Curve>& curves) {
  post([curves](Lab& lab) { lab.record(curves); });
}

Scene Worker::scene() const {
  const std::lock_guard lock(mutex_);
  return scene_;
}

std::shared_ptr<const Frame> Worker::take_frame() {
  const std::lock_guard lock(mutex_);
  if (newest_ != nullptr && newest_->run != run_) return nullptr;  // of before the last load or restart
  if (too_much_waits()) wake_.notify_all();
  return std::exchange(newest_, nullptr);
}

bool Worker::too_much_waits() const {
  if (newest_ == nullptr) return false;
  std::size_t numbers = newest_->impacts.size();
  for (const Rows& rows : newest_->rows) numbers += rows.size() + rows.values.size();
  return numbers > kMostWaiting;
}

void Worker::publish(Lab& lab) {
  auto frame = std::make_shared<Frame>();
  frame->run = lab.run;
  take_moment(lab.simulation, *frame);
  frame->bodies = lab.bodies;
  frame->forces = lab.forces;
  frame->playing = lab.playing;
  frame->realised_speed = lab.realised_speed;
  lab.rows.push_back(lab.sampler.take());
  if (lab.catch_up) lab.rows.push_back(lab.catch_up->sampler.take());
  frame->rows = std::exchange(lab.rows, {});
  frame->rows_known_until = lab.catch_up ? lab.catch_up->replay.simulation().time() : frame->time;
  frame->impacts = std::exchange(lab.impacts, {});
  frame->scales = lab.sampler.scales();
  frame->log = lab.log;
  lab.changed = false;

  std::shared_ptr<Frame> waiting;
  {
    const std::lock_guard lock(mutex_);
    waiting = std::exchange(newest_, nullptr);
  }
  if (waiting != nullptr && waiting->run == frame->run) {
    // Nobody took the frame before: its news go on with this one.
    std::swap(frame->rows, waiting->rows);
    for (Rows& rows : waiting->rows) append(std::move(rows), frame->rows);
    std::swap(frame->impacts, waiting->impacts);
    frame->impacts.insert(frame->impacts.end(), waiting->impacts.begin(), waiting->impacts.end());
  }
  const std::lock_guard lock(mutex_);
  newest_ = std::move(frame);
}

void Worker::work(const std::stop_token& stop, const Scene& first, const std::vector<Curve>& curves) {
  Lab lab(first, curves);  // not scene_, which calls may have changed already
  std::vector<std::function<void(Lab&)>> commands;
  while (!stop.stop_requested()) {
    if (lab.changed) publish(lab);
    {
      std::unique_lock lock(mutex_);
      const auto something_to_do = [&] { return !commands_.empty(); };
      if (too_much_waits()) {
        wake_.wait(lock, stop, [&] { return something_to_do() || !too_much_waits(); });
      } else if (lab.catch_up) {
        // goes on at once
      } else if (!lab.playing) {
        wake_.wait(lock, stop, something_to_do);
      } else if (!lab.full_speed) {
        // Until the next step is due.
        const double due = (lab.simulation.time() + lab.simulation.method().step - lab.pace_time) / lab.speed;
        const auto pause = std::min<Clock::duration>(
            kFramePeriod, std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(due)) -
                              (Clock::now() - lab.pace_wall));
        if (pause > Clock::duration::zero()) wake_.wait_for(lock, stop, pause, something_to_do);
      }
      std::swap(commands, commands_);
    }
    for (const auto& command : commands) command(lab);
    commands.clear();
    lab.catch_up_for(kFramePeriod);
    if (lab.catch_up || !lab.playing) continue;

    const auto begin = Clock::now();
    const double target = lab.full_speed
                              ? lab.end
                              : std::min(lab.end, lab.pace_time + seconds(begin - lab.pace_wall) * lab.speed);
    const double h = lab.simulation.method().step;
    while (lab.simulation.time() + (1.0 - 1e-9) * h <= target && Clock::now() - begin < kFramePeriod &&
           !stop.stop_requested()) {
      lab.step();
    }
    if (lab.simulation.time() + (1.0 - 1e-9) * h > lab.end) {
      lab.playing = false;
      lab.changed = true;
    } else if (!lab.full_speed && (target - lab.simulation.time()) / lab.speed > kLargestLag) {
      lab.set_pace();
    }
    if (const double wall = seconds(Clock::now() - lab.rate_wall); wall > 0.5) {
      lab.realised_speed = (lab.simulation.time() - lab.rate_time) / wall;
      lab.rate_wall = Clock::now();
      lab.rate_time = lab.simulation.time();
    }
  }
}

}  // namespace carom
