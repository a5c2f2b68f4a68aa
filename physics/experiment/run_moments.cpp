#include "physics/experiment/run_moments.h"

#include <algorithm>
#include <memory>

namespace carom {

void keep_recent(std::vector<ImpactRecord>& impacts, std::span<const ImpactRecord> fresh, double now,
                 double span) {
  std::erase_if(impacts, [&](const ImpactRecord& i) { return i.time > now || now - i.time >= span; });
  const std::size_t added = std::min(fresh.size(), kMostRecent);
  if (impacts.size() + added > kMostRecent) {
    const std::size_t surplus = impacts.size() + added - kMostRecent;
    impacts.erase(impacts.begin(), impacts.begin() + static_cast<std::ptrdiff_t>(surplus));
  }
  impacts.insert(impacts.end(), fresh.end() - static_cast<std::ptrdiff_t>(added), fresh.end());
}

bool visit_moments(const RunLog& log, std::span<const double> times, double span,
                   const std::function<bool(const Frame&)>& show,
                   const std::function<bool(double time)>& go_on) {
  Replay replay(log.start);
  Frame frame;
  frame.run = 1;
  frame.forces = std::make_shared<const Forces>(log.start.forces);
  std::vector<ImpactRecord> impacts;
  const auto take = [&](const Simulation& simulation) {
    if (!frame.bodies || frame.bodies->size() != simulation.bodies().size())
      frame.bodies = std::make_shared<const std::vector<Body>>(simulation.bodies());
    take_moment(simulation, frame);
    return show(frame);
  };
  for (const double time : times) {
    const Simulation& simulation = replay.simulation();
    while (true) {
      while (replay.edit(log)) {
      }
      // As Simulation::advance_to() divides the time.
      if (time - simulation.time() <= (1.0 - 1e-9) * simulation.method().step) break;
      if (!go_on(simulation.time())) return false;
      replay.step();
      keep_recent(impacts, simulation.last_impacts(), simulation.time(), span);
    }
    frame.impacts = impacts;
    const double left = time - simulation.time();
    if (left <= 1e-9 * simulation.method().step) {
      if (!take(simulation)) return false;
      continue;
    }
    Simulation between = simulation;
    between.step(left);
    keep_recent(frame.impacts, between.last_impacts(), between.time(), span);
    if (!take(between)) return false;
  }
  return true;
}

}  // namespace carom
