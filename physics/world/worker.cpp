#include "physics/world/worker.h"

#include <algorithm>
#include <chrono>
#include <limits>
#include <utility>

#include "physics/world/thinning.h"

namespace carom {
namespace {

using Clock = std::chrono::steady_clock;

// Frames are published this often at the most; a window polls at 60 Hz.
constexpr std::chrono::milliseconds kFramePeriod{8};
// Behind by more than this, the pace gives up the time it could not keep, instead of racing after it later.
constexpr double kLargestLag = 0.1;  // s

double seconds(Clock::duration d) { return std::chrono::duration<double>(d).count(); }

}  // namespace

struct Worker::Lab {
  explicit Lab(const Scene& s) : scene(s), simulation(s) { begin(); }

  void begin() {
    simulation = Simulation(scene);
    simulation.watch_impacts(true);
    bodies = std::make_shared<const std::vector<Body>>(simulation.bodies());
    forces = std::make_shared<const Forces>(scene.forces);
    ++run;
    playing = false;
    end = std::numeric_limits<double>::infinity();
    samples = {sample_of(simulation)};
    impacts.clear();
    set_rate();
    changed = true;
  }
  void step() {
    simulation.step();
    append_samples(simulation, samples);
    impacts.insert(impacts.end(), simulation.last_impacts().begin(), simulation.last_impacts().end());
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

  Scene scene;
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
  std::vector<Sample> samples;
  std::vector<ImpactRecord> impacts;
};

Worker::Worker(const Scene& scene)
    : scene_(scene), thread_([this, scene](const std::stop_token& stop) { work(stop, scene); }) {}

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

void Worker::load(const Scene& scene) {
  {
    const std::lock_guard lock(mutex_);
    scene_ = scene;
    ++run_;
  }
  post([scene](Lab& lab) {
    lab.scene = scene;
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
    lab.simulation.set_method(method);
    lab.changed = true;
  });
}

void Worker::add_body(const Body& body) {
  {
    const std::lock_guard lock(mutex_);
    scene_.bodies.push_back(body);
  }
  post([body](Lab& lab) {
    lab.scene.bodies.push_back(body);
    lab.simulation.add_body(body);
    lab.bodies = std::make_shared<const std::vector<Body>>(lab.simulation.bodies());
    lab.changed = true;
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

Scene Worker::scene() const {
  const std::lock_guard lock(mutex_);
  return scene_;
}

std::shared_ptr<const Frame> Worker::take_frame() {
  const std::lock_guard lock(mutex_);
  if (newest_ != nullptr && newest_->run != run_) return nullptr;  // of before the last load or restart
  return std::exchange(newest_, nullptr);
}

void Worker::publish(Lab& lab) {
  auto frame = std::make_shared<Frame>();
  frame->run = lab.run;
  take_moment(lab.simulation, *frame);
  frame->bodies = lab.bodies;
  frame->forces = lab.forces;
  frame->playing = lab.playing;
  frame->realised_speed = lab.realised_speed;
  frame->samples = std::exchange(lab.samples, {});
  frame->impacts = std::exchange(lab.impacts, {});
  lab.changed = false;

  std::shared_ptr<Frame> waiting;
  {
    const std::lock_guard lock(mutex_);
    waiting = std::exchange(newest_, nullptr);
  }
  if (waiting != nullptr && waiting->run == frame->run) {
    // Nobody took the frame before: its news go on with this one, in a memory with bounds.
    std::swap(frame->samples, waiting->samples);
    frame->samples.insert(frame->samples.end(), waiting->samples.begin(), waiting->samples.end());
    std::swap(frame->impacts, waiting->impacts);
    frame->impacts.insert(frame->impacts.end(), waiting->impacts.begin(), waiting->impacts.end());
    const bool whole = thin(frame->samples) && waiting->complete;
    frame->complete = thin(frame->impacts) && whole;
  }
  const std::lock_guard lock(mutex_);
  newest_ = std::move(frame);
}

void Worker::work(const std::stop_token& stop, const Scene& first) {
  Lab lab(first);  // not scene_, which calls may have changed already
  std::vector<std::function<void(Lab&)>> commands;
  while (!stop.stop_requested()) {
    if (lab.changed) publish(lab);
    {
      std::unique_lock lock(mutex_);
      const auto something_to_do = [&] { return !commands_.empty(); };
      if (!lab.playing) {
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
    if (!lab.playing) continue;

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
