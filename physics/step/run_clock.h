#pragma once

#include <cmath>
#include <cstdint>

namespace carom {

// Moments of a run that are closer than this, in steps, are one.
inline constexpr double kSameMoment = 1e-9;

// s: how long the step from `time` towards `end` lasts in a run with steps of h > 0; 0 at the end.
[[nodiscard]] inline double step_towards(double end, double time, double h) {
  const double left = end - time;
  if (left <= kSameMoment * h) return 0.0;
  return left > (1.0 - kSameMoment) * h ? h : left;
}

// How many whole steps of h > 0 there are in a span (s), rounded down, also of a negative one.
[[nodiscard]] inline double whole_steps(double span, double h) { return std::floor(span / h + kSameMoment); }

// The time of a run, in s. Whole steps keep time = origin + k h, without summing.
struct RunClock {
  double time = 0.0;         // at the end of the last step
  double step_end = 0.0;     // of the step under way
  double origin = 0.0;       // time = origin + steps_since_origin * origin_step
  double origin_step = 0.0;  // the length of each step since the origin
  std::int64_t steps_since_origin = 0;
  std::int64_t steps = 0;
  double divided_end = 0.0;  // of the step that an edit has divided; in the past: none is

  void start(double at) { time = step_end = origin = at; }
  void begin_step(double h) {
    if (h != origin_step) {
      origin = time;
      origin_step = h;
      steps_since_origin = 0;
    }
    ++steps_since_origin;
    step_end = origin + static_cast<double>(steps_since_origin) * h;
  }
  void end_step() {
    time = step_end;
    ++steps;
  }
};

}  // namespace carom
