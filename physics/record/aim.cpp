#include "physics/record/aim.h"

#include <condition_variable>
#include <mutex>
#include <stop_token>
#include <thread>
#include <utility>

#include "physics/run/simulation.h"
#include "physics/step/step_work.h"

namespace carom {

namespace {

using Clock = std::chrono::steady_clock;

// Requests a stop at a moment, if it still exists then: a single step may take longer than all that is left.
class Deadline {
 public:
  explicit Deadline(Clock::time_point at)
      : thread_([this, at](const std::stop_token& ended) {
          std::mutex mutex;
          std::unique_lock lock(mutex);
          std::condition_variable_any wait;
          wait.wait_until(lock, ended, at, [] { return false; });
          if (!ended.stop_requested()) passed_.request_stop();
        }) {}
  [[nodiscard]] std::stop_token passed() const { return passed_.get_token(); }

 private:
  std::stop_source passed_;
  std::jthread thread_;
};

std::optional<Aim> found_until(const RunSetup& start, double ahead, const std::stop_token& deadline) {
  Simulation run(start);
  const Simulation begin = run;
  run.interrupt_on(deadline);
  const double step = run.method().step;
  while (run.last_impacts().empty()) {
    if (run.lost() || run.time() - begin.time() >= ahead || deadline.stop_requested()) return std::nullopt;
    run.step();
  }
  const ImpactRecord first = run.last_impacts().front();
  const double time = first.time - begin.time();
  if (!(time > step)) return std::nullopt;

  Aim aim{.time = time, .paths = {}, .meeting = {}};
  Simulation again = begin;
  again.interrupt_on(deadline);
  const std::vector<Body>& bodies = again.bodies();
  std::vector<std::size_t> moving;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (!bodies[i].fixed) moving.push_back(i);
  }
  aim.paths.resize(moving.size());
  const auto keep = [&] {
    for (std::size_t k = 0; k < moving.size(); ++k) {
      aim.paths[k].emplace_back(again.state().position(static_cast<int>(moving[k])));
    }
  };
  keep();
  again.advance_to(first.time, keep);
  for (const BodyIndex i : {first.a, first.b}) {
    Body body = bodies[static_cast<std::size_t>(i)];
    body.position = again.state().position(i);
    body.angle = again.state().q.col(i)[2];
    aim.meeting.push_back(std::move(body));
  }
  return aim;
}

}  // namespace

std::optional<Aim> aim_of(const RunSetup& start, double ahead, Clock::duration budget) {
  RunSetup plain = start;
  plain.edits.clear();
  if (budget <= budget.zero() || all_bodies(plain.scene).size() > kMostAimed) return std::nullopt;
  const Deadline deadline(Clock::now() + budget);
  try {
    return found_until(plain, ahead, deadline.passed());
  } catch (const StepInterrupted&) {
    return std::nullopt;
  }
}

}  // namespace carom
