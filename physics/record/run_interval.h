#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "physics/model/compiled_scene.h"
#include "physics/record/replay.h"

namespace carom {

// A run at two moments, and what happened between them. Constant once made.
struct RunInterval {
  double from = 0.0;                              // s
  double to = 0.0;                                // s
  std::shared_ptr<const CompiledScene> compiled;  // at its end
  std::vector<Joint> joints;                      // at its end, with the welds of bodies that stuck
  State before;
  State after;
  std::vector<bool> touched;  // by body: in an impact, or in a contact that lasts
  bool edited = false;        // the scene
};

// Repeats a run from the latest of its key frames before `from` up to `to` (s, not before it), which the run
// has reached. A time between two steps is reached by one shorter step of a copy. Before each step `go_on` is
// asked; if it returns false there is no result.
[[nodiscard]] std::optional<RunInterval> run_interval(
    const RunSetup& setup, std::span<const std::shared_ptr<const KeyFrame>> key_frames, double from, double to,
    const std::function<bool()>& go_on);

}  // namespace carom
