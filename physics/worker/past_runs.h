#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <stop_token>
#include <vector>

#include "physics/record/frame.h"
#include "physics/worker/past_run.h"

namespace carom {

// A moment in the past of several runs, told by the first one: the last end of a step that is not after `time`,
// and then so many steps later, or earlier if `steps` is negative, but not outside the run. The others stand
// where they would if the runs had been stopped there. With `part`, it is the moment to which a step of this
// length leads from there, and the others come to it by a shorter step too. With `impact`, the time of an
// impact of the first run in the step that follows `time`, it is the moment just before it, which has the jumps
// of that step; where the impact is at the step's end, it is the end. `steps` lead from that moment, then.
struct PastMoment {
  double time = 0.0;  // s
  std::int64_t steps = 0;
  double part = 0.0;               // s
  std::optional<double> impact{};  // s

  bool operator==(const PastMoment&) const = default;
};

// Copies of runs side by side on their way to a moment of their past.
class PastRuns {
 public:
  struct Original {
    const LiveRun& run;
    std::uint64_t id;
  };

  // Goes to this moment of these runs, from wherever the copies stand. There is at least one run.
  void seek(const PastMoment& moment, std::span<const Original> runs, const std::stop_token& interrupt);
  [[nodiscard]] bool seeks() const { return sought_.has_value(); }
  // Makes one step; false once the moment is reached.
  bool step();
  void clear() {
    runs_.clear();
    sought_.reset();
  }
  // The copies as they stand, without the fields that only the owner knows: playing and speed. The first one
  // has its scene for edits when the moment is reached.
  [[nodiscard]] std::vector<std::shared_ptr<Frame>> frames() const;

 private:
  struct Sought {
    double time = 0.0;                    // s, for all runs to reach
    std::optional<std::int64_t> steps{};  // for the first run alone to reach before that
    std::int64_t by = 0;                  // steps of the first run, once it is at the time
    std::int64_t newest = 0;              // steps of the run itself
    double part = 0.0;                    // s, of the first run after that
    std::optional<double> impact{};       // s, in the first run's next step
    std::optional<double> at_end{};       // s, of an impact at the end of that step
    bool others_follow = false;           // the time is that of the first run's moment
  };

  void go_to_step(std::int64_t steps);
  bool step_first();
  void go_to_impact();
  void follow_first();
  void make_parts();

  std::vector<PastRun> runs_;
  std::optional<Sought> sought_;
};

}  // namespace carom
