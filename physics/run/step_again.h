#pragma once

#include <optional>

#include "physics/run/simulation.h"

namespace carom {

// The step under way of a run, to be made again with other lengths. The run is one that nothing but its steps
// and the edits of its setup change.
class StepAgain {
 public:
  // Call before each step, of h s; the edits that are due were applied.
  void begins(const Simulation& run, double h);
  // The run, had the step lasted `length` s; 0: as it began.
  [[nodiscard]] Simulation made(double length);
  // After the run was replaced by another one.
  void forget() { copy_.reset(); }

 private:
  // Many enough to make copies cheap, few enough to repeat.
  static constexpr int kStepsBetweenCopies = 64;

  std::optional<Simulation> copy_;   // some whole steps ago
  std::optional<Simulation> start_;  // of the step, once it was needed
  int steps_ = 0;                    // since the copy
  bool whole_ = true;                // the step is of the length that it has without anybody's asking
};

}  // namespace carom
