#pragma once

#include <cstdint>
#include <stop_token>
#include <string>
#include <vector>

#include "physics/world/simulation.h"

namespace carom {

// When two bodies met, a < b.
struct TimedImpact {
  double time = 0.0;  // s
  int a = 0;
  int b = 0;
};

// One run as a comparison needs it: the state at one moment, and all impacts until some time later.
struct RunSummary {
  State state;
  double energy = 0.0;  // J
  std::int64_t steps = 0;
  std::int64_t impact_count = 0;
  std::int64_t evaluations = 0;
  std::int64_t rejected_steps = 0;
  // In the order of time, also after the moment. None where contacts last: it hangs on the step whether a
  // landing is an impact or a contact takes it up, so that impacts of two runs are no partners there.
  std::vector<TimedImpact> impacts;
  double largest_kinetic = 0.0;  // J, at the ends of the steps
  double resting_since = -1.0;   // s; as in Notices
  double blew_up_at = -1.0;      // s: from here on the numbers mean nothing and the run was ended; < 0: never
  std::string status = "ok";
};

// A run whose kinetic energy passes this, or any number of it stops being finite, is ended: it has blown up.
[[nodiscard]] RunSummary run_and_summarize(const RunSetup& setup, const Method& method, double time,
                                           double until, double blown_up_above,
                                           const std::stop_token& stop = {});

// Indices of the bodies that anything can move.
[[nodiscard]] std::vector<int> moving_bodies(const std::vector<Body>& bodies);

}  // namespace carom
