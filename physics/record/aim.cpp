#include "physics/record/aim.h"

#include <algorithm>
#include <utility>

#include "physics/run/simulation.h"

namespace carom {

std::optional<Aim> aim_of(const RunSetup& start, double ahead, std::chrono::steady_clock::duration budget) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point latest = Clock::now() + budget;
  RunSetup plain = start;
  plain.edits.clear();
  if (all_bodies(plain.scene).size() > kMostAimed) return std::nullopt;
  Simulation run(plain);
  const Simulation begin = run;
  const double step = run.method().step;
  while (run.last_impacts().empty()) {
    if (run.lost() || run.time() - begin.time() >= ahead || Clock::now() > latest) return std::nullopt;
    run.step();
  }
  const ImpactRecord first = run.last_impacts().front();
  const double time = first.time - begin.time();
  if (!(time > step)) return std::nullopt;

  Aim aim{.time = time, .paths = {}, .meeting = {}};
  Simulation again = begin;
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
  for (const int i : {first.a, first.b}) {
    Body body = bodies[static_cast<std::size_t>(i)];
    body.position = again.state().position(i);
    body.angle = again.state().q(2, i);
    aim.meeting.push_back(std::move(body));
  }
  return aim;
}

}  // namespace carom
