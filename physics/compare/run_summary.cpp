#include "physics/compare/run_summary.h"

#include <cmath>
#include <fmt/format.h>

#include "physics/math/cancelled.h"
#include "physics/world/run_setup.h"

namespace carom {

RunSummary run_and_summarize(const RunSetup& setup, const Method& method, double time, double until,
                             double blown_up_above, const std::stop_token& stop) {
  RunSetup with_method = setup;
  with_method.method = method;
  Simulation s(with_method);
  RunSummary run;
  run.largest_kinetic = s.totals().kinetic();
  const bool lasts = contacts_last(method, s.needs());
  // Steps as Simulation::advance_to() takes them, with a look at each: a run that blows up would go on with
  // millions of impacts a step.
  const auto advance = [&](double to) {
    const double h = method.step;
    for (double left = to - s.time(); left > 1e-9 * h; left = to - s.time()) {
      throw_if_cancelled(stop);
      s.step(left > (1.0 - 1e-9) * h ? h : left);
      if (s.lost()) {
        run.blew_up_at = s.time();
        return;
      }
      if (!lasts) {
        for (const ImpactRecord& i : s.last_impacts()) run.impacts.push_back({i.time, i.a, i.b});
      }
      const double kinetic = s.totals().kinetic();
      run.largest_kinetic = std::fmax(run.largest_kinetic, kinetic);
      if (!(kinetic <= blown_up_above)) {
        run.blew_up_at = s.time();
        return;
      }
    }
  };
  advance(time);
  run.state = s.state();
  run.energy = s.totals().energy();
  run.steps = s.steps();
  run.impact_count = s.impact_count();
  run.evaluations = s.evaluations();
  run.rejected_steps = s.rejected_steps();
  run.status = s.notices().text();
  if (run.blew_up_at < 0.0) advance(until);
  run.resting_since = s.notices().resting_since;
  if (run.blew_up_at >= 0.0 && run.blew_up_at < time) {
    run.status = fmt::format("blew up: ended at t = {:.6g} s", run.blew_up_at);
  }
  return run;
}

std::vector<int> moving_bodies(const std::vector<Body>& bodies) {
  std::vector<int> moving;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (!has_infinite_mass(bodies[i])) moving.push_back(static_cast<int>(i));
  }
  return moving;
}

}  // namespace carom
