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
#include "physics/scene/scene.h"
#include "physics/world/edit.h"
#include "physics/world/simulation.h"

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

// How large a run's quantities are: against these a plot tells a value from rounding.
struct Scales {
  double energy = 0.0;    // J: the most of kinetic energy and size of the potential one
  double momentum = 0.0;  // N s: √(2 M K), which the sum of all sizes m|v| never exceeds
  double impulse = 0.0;   // N s: the strongest impact
};

// What curves did, moment by moment in the order of time. Two rows of one time are an upright jump.
struct Rows {
  std::shared_ptr<const std::vector<Curve>> curves;
  bool from_the_start = false;  // they begin at t = 0: what is known of these curves is to be forgotten
  std::vector<double> times;    // s
  std::vector<double> values;   // row by row: of each curve y and, if it has one, x
  std::vector<SpeedMoment> moments{};

  [[nodiscard]] std::size_t size() const { return times.size(); }
};

// Reads curves off a run: at its start, at the end of each step, and before and after each impact that the
// simulation watches; and all speeds at some of the steps' ends. There the ledger jumps by what the impact
// changed; the work of smooth forces is that of the moment, what contacts that last take, and the drift, is
// taken for linear within the step.
class Sampler {
 public:
  // Reads `curves`, and is ready for `later` too, of which it must know the run from its start on.
  explicit Sampler(std::vector<Curve> curves, const std::vector<Curve>& later = {});

  // Before begin(): goes along with the run from its start on, and gives its errors.
  void compare_with(ReferenceRun reference) { reference_run_ = std::move(reference); }

  void interrupt_on(const std::stop_token& stop) {
    if (reference_run_) reference_run_->interrupt_on(stop);
  }

  void begin(const Simulation& simulation);
  void after_step(const Simulation& simulation);
  void after_edit(const Simulation& simulation, const Edit& edit);

  // Whether it knows enough of the run so far to read these too from now on.
  [[nodiscard]] bool can_read(const std::vector<Curve>& curves) const;
  // From now on reads others. Rows that wait must be taken before.
  void set_curves(std::vector<Curve> curves);
  // The rows since the last call.
  [[nodiscard]] Rows take();
  [[nodiscard]] const std::vector<Curve>& curves() const { return *rows_.curves; }
  [[nodiscard]] const Scales& scales() const { return scales_; }
  // What the run is compared with.
  [[nodiscard]] ReferenceId reference() const {
    return reference_run_ ? reference_run_->id() : ReferenceId::kNone;
  }
  // Of a run that is compared, at its last step's end.
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
  double mass_ = 0.0;  // kg, of all that moves freely
  // At the end of the last step.
  double time_ = 0.0;
  std::int64_t impacts_ = 0;
  Ledger ledger_;  // without the bodies' quadratures
  double energy_drift_ = 0.0;
  Vec2 momentum_drift_ = Vec2::Zero();
};

}  // namespace carom
