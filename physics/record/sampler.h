#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <stop_token>
#include <vector>

#include "physics/compare/reference_run.h"
#include "physics/dynamics/state.h"
#include "physics/observe/observables.h"
#include "physics/observe/quantity.h"
#include "physics/run/run_setup.h"
#include "physics/scene/scene.h"

namespace carom {

class Simulation;

// Speeds of all free bodies, in their order, at the end of one step.
struct SpeedMoment {
  std::int64_t step = 0;
  double time = 0.0;          // s
  std::vector<float> speeds;  // m/s
};

// Interval of the recorded steps after so many steps: a power of two, so that at most kMostMoments are kept,
// evenly over the whole run.
inline constexpr std::int64_t kMostMoments = 256;
[[nodiscard]] std::int64_t moment_stride(std::int64_t steps);
[[nodiscard]] inline bool is_moment(std::int64_t step) { return step % moment_stride(step) == 0; }

// Speeds of the bodies now and at moments over the whole run, at most kMostMoments times the number of
// bodies.
class SpeedRecord {
 public:
  void clear();
  // Ignores a moment that is already recorded.
  void add(const SpeedMoment& moment);
  void set_now(const State& state, const std::vector<Body>& bodies);
  void cut(double time);  // drops the moments from it on

  [[nodiscard]] const std::vector<double>& now() const { return now_; }        // m/s
  [[nodiscard]] const std::vector<double>& masses() const { return masses_; }  // kg, of the same bodies
  [[nodiscard]] std::span<const SpeedMoment> moments() const { return moments_; }
  // Changes whenever the moments change.
  [[nodiscard]] std::uint64_t version() const { return version_; }
  // The speeds of all moments from `from` to `to` (s), one moment after the other.
  [[nodiscard]] std::vector<double> between(double from, double to) const;

 private:
  std::vector<double> now_;
  std::vector<double> masses_;
  std::vector<SpeedMoment> moments_;
  std::uint64_t version_ = 0;
};

// Magnitudes of a run's quantities, by which a plot tells a value from rounding.
struct Scales {
  double energy = 0.0;    // J: the largest kinetic energy plus the magnitude of the potential energy
  double momentum = 0.0;  // N s: √(2 M K), an upper bound of the sum of all m|v|
  double impulse = 0.0;   // N s: the strongest impact
};

// Values of curves in the order of time. Two rows of one time are a jump.
struct Rows {
  std::shared_ptr<const std::vector<Curve>> curves;
  bool from_the_start = false;   // they begin at t = 0: earlier rows of these curves are to be dropped
  std::vector<double> times{};   // s
  std::vector<double> values{};  // row by row: y of each curve and, if it has one, x
  std::vector<SpeedMoment> moments{};
  // s: the run has gone back there, and all that was recorded then and later is to be dropped, of all curves.
  std::optional<double> back_to{};

  [[nodiscard]] std::size_t size() const { return times.size(); }
};

// Drops the values of all curves but these.
void keep_curves(Rows& rows, const std::vector<Curve>& wanted);

// Reads curves from a run: at its start, at the end of each step, and before and after each impact that the
// simulation records; and all speeds at some ends of steps. At an impact the ledger jumps by the impact's
// entry, and the work of smooth forces is that of the moment. The losses to resting contacts and the drift
// are taken as linear within the step.
class Sampler {
 public:
  // Reads `curves`; also prepares for `later`, which need the run from its start.
  explicit Sampler(std::vector<Curve> curves, const std::vector<Curve>& later = {});

  // Before begin(): runs the reference along with the run and provides the errors.
  void compare_with(ReferenceRun reference) { reference_run_ = std::move(reference); }

  void interrupt_on(const std::stop_token& stop) {
    if (reference_run_) reference_run_->interrupt_on(stop);
  }

  void begin(const Simulation& simulation);
  void after_step(const Simulation& simulation);
  void after_edit(const Simulation& simulation, const RunEdit& edit);

  // Goes on as a sampler of another run that stands where this one's last step ended: with these curves, and a
  // row of this moment before anything else.
  void go_on(const Simulation& simulation, std::vector<Curve> curves, const std::stop_token& interrupt);

  // Whether it has followed the run far enough to read these too from now on.
  [[nodiscard]] bool can_read(const std::vector<Curve>& curves) const;
  // Reads other curves from now on. Take waiting rows first.
  void set_curves(std::vector<Curve> curves);
  // The rows since the last call.
  [[nodiscard]] Rows take();
  [[nodiscard]] const std::vector<Curve>& curves() const { return *rows_.curves; }
  [[nodiscard]] const Scales& scales() const { return scales_; }
  // The reference of the run.
  [[nodiscard]] ReferenceId reference() const {
    return reference_run_ ? reference_run_->id() : ReferenceId::kNone;
  }
  // The error against the reference at the end of the last step.
  [[nodiscard]] std::optional<RunError> error() const {
    return reference_run_ ? std::optional(reference_run_->error()) : std::nullopt;
  }

 private:
  void look(const Simulation& simulation);  // between steps
  void append(const Reading& reading);
  void remember(const Reading& end);  // for the jumps of the next step
  void take_speeds(const Simulation& simulation);

  Rows rows_;
  ImpactTally tally_;
  std::optional<ReferenceRun> reference_run_;
  Scales scales_;
  double mass_ = 0.0;  // kg, of all free bodies
  // At the end of the last step.
  double time_ = 0.0;
  std::int64_t impacts_ = 0;
  Ledger ledger_;  // without the bodies' quadratures
  double energy_drift_ = 0.0;
  Vec2 momentum_drift_ = Vec2::Zero();
  double angular_momentum_drift_ = 0.0;
};

}  // namespace carom
