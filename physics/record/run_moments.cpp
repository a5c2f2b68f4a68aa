#include "physics/record/run_moments.h"

#include <algorithm>
#include <memory>

#include "physics/record/replay.h"

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

namespace {

// One run on its way through the moments.
class Walk {
 public:
  Walk(const RunLog& log, double span)
      : log_(log),
        replay_(log.start),
        forces_(std::make_shared<const Forces>(log.start.scene.forces)),
        span_(span) {}

  bool go_to(double time, Frame& frame, const std::function<bool(double)>& go_on) {
    const Simulation& simulation = replay_.simulation();
    bool cancelled = false;
    replay_.go_through(
        log_, [](const Edit&) {},
        [&](const Simulation& s) {
          // As Simulation::advance_to() divides the time.
          if (s.lost() || time - s.time() <= (1.0 - 1e-9) * s.method().step) return false;
          cancelled = !go_on(s.time());
          return !cancelled;
        },
        [&](const Simulation& s) { keep_recent(impacts_, s.last_impacts(), s.time(), span_); });
    if (cancelled) return false;
    frame.impacts = impacts_;
    const double left = time - simulation.time();
    if (simulation.lost() || left <= 1e-9 * simulation.method().step) {
      take(simulation, frame);
      return true;
    }
    Simulation between = simulation;
    between.step(left);
    keep_recent(frame.impacts, between.last_impacts(), between.time(), span_);
    take(between, frame);
    return true;
  }

 private:
  void take(const Simulation& simulation, Frame& frame) {
    if (!bodies_ || bodies_->size() != simulation.bodies().size())
      bodies_ = std::make_shared<const std::vector<Body>>(simulation.bodies());
    frame.run = 1;
    frame.bodies = bodies_;
    frame.forces = forces_;
    take_moment(simulation, frame);
  }

  const RunLog& log_;
  Replay replay_;
  std::shared_ptr<const Forces> forces_;
  std::shared_ptr<const std::vector<Body>> bodies_;
  std::vector<ImpactRecord> impacts_;
  double span_;
};

}  // namespace

bool visit_moments(std::span<const RunLog> runs, std::span<const double> times, double span,
                   const std::function<bool(std::span<const Frame>)>& show,
                   const std::function<bool(double time)>& go_on) {
  std::vector<Walk> walks;
  for (const RunLog& log : runs) walks.emplace_back(log, span);
  std::vector<Frame> frames(runs.size());
  for (const double time : times) {
    for (std::size_t i = 0; i < walks.size(); ++i) {
      if (!walks[i].go_to(time, frames[i], go_on)) return false;
    }
    if (!show(frames)) return false;
  }
  return true;
}

}  // namespace carom
