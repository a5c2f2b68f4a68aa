#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <stop_token>
#include <utility>
#include <vector>

#include "physics/record/frame.h"
#include "physics/record/replay.h"
#include "physics/run/stop_watch.h"

namespace carom {

// The moments at which a run meets stops, from its start on: the run itself goes on as it would without them.
// Where it has made steps before, these are repeated to find the moments in them (catch_up()).
class StopRecord {
 public:
  using Stops = std::shared_ptr<const std::vector<Stop>>;

  // Of the run of this setup. Steps of its repetition throw StepInterrupted once `interrupt` is requested.
  StopRecord(Stops stops, const RunSetup& setup, const Simulation& run, const std::stop_token& interrupt);

  [[nodiscard]] const Stops& stops() const { return stops_; }
  // Call before and after each step.
  void before_step(const Simulation& run);
  void after_step(const Simulation& run);
  // The first stop of the last step; none while it is behind.
  [[nodiscard]] const MetStop* met() const { return last_.empty() ? nullptr : &last_.front(); }
  // After the run was given other edits, in its future.
  void take_edits(const std::vector<RunEdit>& edits);
  // After it went back to this moment (s), if it is not behind.
  void go_back(double time);
  [[nodiscard]] bool behind() const { return replay_.has_value(); }
  // Repeats the run for about this long.
  void catch_up(const Simulation& run, std::chrono::steady_clock::duration duration);
  // Puts what was met since the last call into the frame.
  void take(Frame& frame);

 private:
  Stops stops_;
  StopWatch watch_;
  std::vector<MetStop> last_;   // in the last step
  std::vector<MetStop> fresh_;  // not yet taken
  std::optional<Replay> replay_;
};

}  // namespace carom
