#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "physics/dynamics/state.h"
#include "physics/scene/scene.h"

namespace carom {

// The speeds of all bodies that move freely, in their order, at the end of one step.
struct SpeedMoment {
  std::int64_t step = 0;
  double time = 0.0;          // s
  std::vector<float> speeds;  // m/s
};

// Which steps' ends are kept after so many steps: every so many, a power of two, so that there are at most
// kMostMoments of them, evenly over the whole run.
inline constexpr std::int64_t kMostMoments = 256;
[[nodiscard]] std::int64_t moment_stride(std::int64_t steps);
[[nodiscard]] inline bool is_moment(std::int64_t step) { return step % moment_stride(step) == 0; }

// How fast the bodies are now, and were at moments all over the run: bounded by kMostMoments times their
// number.
class SpeedRecord {
 public:
  void clear();
  // A moment that is known already is left out.
  void add(const SpeedMoment& moment);
  void set_now(const State& state, const std::vector<Body>& bodies);

  [[nodiscard]] const std::vector<double>& now() const { return now_; }        // m/s
  [[nodiscard]] const std::vector<double>& masses() const { return masses_; }  // kg, of the same bodies
  [[nodiscard]] std::span<const SpeedMoment> moments() const { return moments_; }
  // Another number whenever the moments are others.
  [[nodiscard]] std::uint64_t version() const { return version_; }
  // Of all moments from `from` to `to` (s), one after the other.
  [[nodiscard]] std::vector<double> between(double from, double to) const;

 private:
  std::vector<double> now_;
  std::vector<double> masses_;
  std::vector<SpeedMoment> moments_;
  std::uint64_t version_ = 0;
};

}  // namespace carom
