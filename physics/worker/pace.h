#pragma once

#include <algorithm>
#include <chrono>
#include <limits>
#include <optional>

namespace carom {

// How fast a playing run goes: simulated time against the wall clock, and the speed that is reached. Times of
// the run in s; `now` must not decrease from call to call.
class Pace {
 public:
  using Clock = std::chrono::steady_clock;

  explicit Pace(Clock::time_point now) : wall_(now), measured_wall_(now) {}

  // From here on, at the chosen speed.
  void begin(double time, Clock::time_point now) {
    wall_ = now;
    time_ = time;
  }
  // Measures the speed from here on.
  void begin_measurement(double time, Clock::time_point now) {
    reached_ = 0.0;
    measured_wall_ = now;
    measured_time_ = time;
  }
  void set_speed(double speed) { speed_ = speed; }  // simulated seconds per second, > 0
  // Whether it goes much slower than the chosen speed.
  [[nodiscard]] bool slow() const { return slow_; }
  // What a run at `time` is to go to, if `due` is due: no farther than `free`, from where on it goes slowly.
  // Nothing: it does so from here on. Where it becomes slow, or as fast again, it stays where it is for this
  // once.
  [[nodiscard]] double due_near_impacts(std::optional<double> free, double time, double due,
                                        Clock::time_point now) {
    if (slow_ == free.has_value()) {
      begin(time, now);
      slow_ = !free;
      return time;
    }
    if (!free || *free >= due) return due;
    begin(*free, now);
    return *free;
  }

  // The run's time that is due now.
  [[nodiscard]] double due(Clock::time_point now) const { return time_ + seconds(now - wall_) * speed(); }
  // How long until this time is due; negative if it was due before.
  [[nodiscard]] Clock::duration until(double time, Clock::time_point now) const {
    // Kept below a day, so that the conversion holds for an infinite time too.
    const std::chrono::duration<double> wait(std::min((time - time_) / speed(), kLongest));
    return std::chrono::duration_cast<Clock::duration>(wait) - (now - wall_);
  }
  // Gives up the lost time, instead of catching up later, if the run at `time` lags too far behind `target`.
  void give_up_lag(double time, double target, Clock::time_point now) {
    if ((target - time) / speed() > kLargestLag) begin(time, now);
  }

  void measure(double time, Clock::time_point now) {
    const double wall = seconds(now - measured_wall_);
    if (wall <= kMeasured) return;
    const double reached = (time - measured_time_) / wall;
    begin_measurement(time, now);
    reached_ = reached;
  }
  // Simulated seconds per second; 0 while it is not known yet.
  [[nodiscard]] double reached() const { return reached_; }

 private:
  static constexpr double kLargestLag = 0.1;   // s of the wall clock
  static constexpr double kMeasured = 0.5;     // s
  static constexpr double kLongest = 86400.0;  // s
  static constexpr double kSlowShare = 0.05;   // of the chosen speed

  static double seconds(Clock::duration d) { return std::chrono::duration<double>(d).count(); }

  [[nodiscard]] double speed() const { return slow_ ? kSlowShare * speed_ : speed_; }

  double speed_ = 1.0;
  bool slow_ = false;
  Clock::time_point wall_;
  double time_ = 0.0;
  Clock::time_point measured_wall_;
  double measured_time_ = 0.0;
  double reached_ = 0.0;
};

}  // namespace carom
