#pragma once

#include <chrono>
#include <limits>
#include <memory>
#include <optional>
#include <stop_token>
#include <vector>

#include "physics/record/frame.h"
#include "physics/record/replay.h"
#include "physics/record/sampler.h"
#include "physics/worker/stop_record.h"

namespace carom {

// One of several runs side by side: the simulation under its method, its recorded data, and its edits. It
// shares nothing with the others, so its results are those of the run alone.
class LiveRun {
 public:
  // At the start. Steps throw StepInterrupted once `interrupt` is requested; the run is then unusable.
  LiveRun(const RunSetup& setup, const std::vector<Curve>& curves, ReferenceId reference,
          std::stop_token interrupt = {});

  // A step and then the edits that are due; nothing if the run is lost.
  void step();
  [[nodiscard]] bool lost() const { return simulation_.lost().has_value(); }
  void edit(const RunEdit& edit);  // when it is due, or at once
  // Gives the run these edits instead. Where they differ in its past it goes back to the last key frame before
  // that; false, and nothing has changed, if there is none: then only a new run has them.
  bool take_edits(const std::vector<RunEdit>& edits);
  // Goes back to the last key frame before `time` (s) and gives the run these edits, which are the same up to
  // there. False, and nothing has changed, if there is none.
  bool go_back(double time, const std::vector<RunEdit>& edits);
  // Sets the curves to record from now on and the reference. For a curve or reference that was not followed
  // so far, the run is replayed (catch_up) before it continues.
  void record(const std::vector<Curve>& curves, ReferenceId reference);
  // From now on the requests to interrupt its steps come from here.
  void interrupt_on(const std::stop_token& interrupt);
  [[nodiscard]] const std::stop_token& interrupt() const { return interrupt_; }
  // Looks for these stops from the run's start on; nullptr: for none.
  void watch(const StopRecord::Stops& stops);
  // The first stop that was met in the last step.
  [[nodiscard]] const MetStop* met() const { return stops_ ? stops_->met() : nullptr; }
  // Replays for about this long.
  void catch_up(std::chrono::steady_clock::duration duration);
  [[nodiscard]] bool behind() const { return catch_up_.has_value() || looks_for_stops(); }

  // The changes since the last call, without the fields that only the owner knows: run, playing, speed.
  [[nodiscard]] std::shared_ptr<Frame> take_frame();

  [[nodiscard]] const Simulation& simulation() const { return simulation_; }
  [[nodiscard]] double time() const { return simulation_.time(); }
  // s, end of the next step; infinite for a lost run.
  [[nodiscard]] double next() const {
    return lost() ? std::numeric_limits<double>::infinity() : simulation_.time() + simulation_.next_step();
  }
  [[nodiscard]] const RunSetup& setup() const { return *setup_; }
  // Another object whenever it has other edits.
  [[nodiscard]] const std::shared_ptr<const RunSetup>& shared_setup() const { return setup_; }
  [[nodiscard]] const KeyFrames& key_frames() const { return key_frames_; }
  [[nodiscard]] ReferenceId reference() const { return reference_; }

 private:
  // Replay of the run, for curves that were not recorded from its start.
  struct CatchUp {
    Replay replay;
    Sampler sampler;
  };

  [[nodiscard]] Sampler begin_sampler(const Simulation& simulation, const std::vector<Curve>& curves,
                                      const std::vector<Curve>& later) const;
  [[nodiscard]] bool looks_for_stops() const { return stops_ && stops_->behind(); }
  void watch_anew(const StopRecord::Stops& stops);
  void give_edits();
  void apply_due_edits();
  void take_setup(const std::vector<RunEdit>& edits, const KeyFrame* back_to);
  void go_back_to(const KeyFrame& moment);

  std::stop_token interrupt_;
  std::shared_ptr<const RunSetup> setup_;
  Simulation simulation_;
  std::vector<Curve> curves_;
  ReferenceId reference_;
  Sampler sampler_;
  std::optional<CatchUp> catch_up_;
  std::optional<StopRecord> stops_;
  std::vector<Rows> rows_;  // rows not yet taken by the owner
  KeyFrames key_frames_;
  std::vector<ImpactRecord> impacts_;
  std::shared_ptr<const JumpMoment> last_jumps_;
  std::optional<double> back_to_;  // s, since the last frame
  double wall_time_ = 0.0;         // s, of all steps
};

}  // namespace carom
