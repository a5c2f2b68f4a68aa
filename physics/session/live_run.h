#pragma once

#include <chrono>
#include <limits>
#include <memory>
#include <optional>
#include <stop_token>
#include <variant>
#include <vector>

#include "physics/record/frame.h"
#include "physics/record/replay.h"
#include "physics/record/sampler.h"

namespace carom {

// One run of those that go side by side: the simulation under its method, what is recorded of it, and its log.
// It shares nothing with the others, so that its bytes are those of the run alone.
class LiveRun {
 public:
  // Stands at the start.
  // Its steps throw StepInterrupted once `interrupt` asks for it; then it can only be thrown away.
  LiveRun(const RunSetup& start, const std::vector<Curve>& curves, ReferenceId reference,
          std::stop_token interrupt = {});

  // Of a run that is lost does nothing.
  void step();
  [[nodiscard]] bool lost() const { return simulation_.lost().has_value(); }
  void edit(const std::variant<Method, Body>& what);  // likewise
  // What to read off the run from now on, and what to compare it with. Where that was not known before, the run
  // is to be gone through once more (catch_up) before it goes on.
  void record(const std::vector<Curve>& curves, ReferenceId reference);
  // For about so long.
  void catch_up(std::chrono::steady_clock::duration duration);
  [[nodiscard]] bool behind() const { return catch_up_.has_value(); }

  // What happened since the last call, without what only the owner of the lanes knows: run, playing, speed.
  [[nodiscard]] std::shared_ptr<Frame> take_frame();

  [[nodiscard]] const Simulation& simulation() const { return simulation_; }
  [[nodiscard]] double time() const { return simulation_.time(); }
  // s, of the next step's end; a lost run has none.
  [[nodiscard]] double next() const {
    return lost() ? std::numeric_limits<double>::infinity() : simulation_.time() + simulation_.method().step;
  }
  [[nodiscard]] const RunLog& log() const { return *log_; }

 private:
  // Goes through the run once more, for curves that were not recorded from its start on.
  struct CatchUp {
    Replay replay;
    Sampler sampler;
  };

  [[nodiscard]] Sampler begin_sampler(const Simulation& simulation, const std::vector<Curve>& curves,
                                      const std::vector<Curve>& later) const;

  std::stop_token interrupt_;
  std::shared_ptr<const RunLog> log_;
  Simulation simulation_;
  std::shared_ptr<const std::vector<Body>> bodies_;
  std::shared_ptr<const Forces> forces_;
  std::vector<Curve> curves_;
  ReferenceId reference_;
  Sampler sampler_;
  std::optional<CatchUp> catch_up_;
  std::vector<Rows> rows_;  // that wait beside the samplers' own
  KeyFrames key_frames_;
  std::vector<ImpactRecord> impacts_;
  double wall_time_ = 0.0;  // s, of all steps
};

}  // namespace carom
