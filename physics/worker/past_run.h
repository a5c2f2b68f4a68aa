#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <stop_token>
#include <vector>

#include "physics/record/frame.h"
#include "physics/record/replay.h"
#include "physics/record/sampler.h"
#include "physics/worker/live_run.h"

namespace carom {

// A run at moments of its past: a copy that is repeated from the latest key frame before them, so that each has
// the bytes that it had the first time. The run itself is untouched. It leaves key frames of its own behind, so
// that a step back is no long way. Steps throw StepInterrupted once `interrupt` is requested.
class PastRun {
 public:
  PastRun(const LiveRun& run, std::uint64_t id, std::stop_token interrupt);

  // Whether it is a copy of this run, with the same edits.
  [[nodiscard]] bool is_of(const LiveRun& run, std::uint64_t id) const {
    return id_ == id && setup_ == run.shared_setup();
  }
  // Takes up the key frames that the run has by now.
  void follow(const LiveRun& run) { key_frames_ = run.key_frames().all(); }

  // Stands at a known moment from which steps lead to the last one that is not after `time` (s): the latest one
  // that is left by a step, so that the contact forces are those of the step there.
  void stand_before(double time);
  // The same for the moment after so many steps.
  void stand_before_step(std::int64_t steps);
  // Whether a step leads to a moment that is not after `time`.
  [[nodiscard]] bool may_step(double time) const;
  void step();
  // Shows the moment to which a step of this length (s) leads, if it is not 0, or one at most a rounding later:
  // an edit at its time divides the step there. It stands where it is. The jumps are those of the last step, or
  // of the whole one that follows.
  void make_part(double length, bool with_jumps_ahead = false);

  // Shows the jumps of the step that follows where the last one has not met this impact (s): rounding says in
  // which of two steps one at their common end is.
  void look_ahead_for(double impact);

  // Once it stands anywhere.
  [[nodiscard]] const Simulation& simulation() const { return at_->simulation; }
  [[nodiscard]] const Simulation& shown() const { return part_ ? part_->simulation : at_->simulation; }
  [[nodiscard]] double next() const;  // s, end of the next step
  [[nodiscard]] std::shared_ptr<Frame> frame() const;

 private:
  struct Standing {
    Simulation simulation;
    std::optional<Sampler> sampler;  // for the error against the reference, if there is one
    double wall_time = 0.0;          // s, of all steps
  };

  template <class Leads, class Beyond>
  void stand(const Leads& leads, const Beyond& beyond);
  void stand_at(const KeyFrame& moment);
  void stand_at_start();
  void apply_due_edits();
  void look_ahead();
  void leave_key_frame(std::chrono::steady_clock::duration worked);

  std::shared_ptr<const RunSetup> setup_;
  std::uint64_t id_;
  ReferenceId reference_;
  std::stop_token interrupt_;
  std::vector<std::shared_ptr<const KeyFrame>> key_frames_;  // of the run
  std::vector<std::shared_ptr<const KeyFrame>> left_;        // on the way since one of these
  std::chrono::steady_clock::duration interval_{};           // of work between those left
  std::chrono::steady_clock::duration worked_{};             // since the last one
  std::optional<Standing> at_;
  std::optional<Standing> part_;                                               // of a step from there
  std::optional<std::vector<std::shared_ptr<const JumpMoment>>> jumps_ahead_;  // of the step from there
};

}  // namespace carom
