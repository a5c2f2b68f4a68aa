#pragma once

#include <string>
#include <vector>

#include "physics/dynamics/lost_motion.h"
#include "physics/scene/scene.h"

namespace carom {

// A run that can't continue: it stays at the end of its last good step.
struct LostRun {
  LossReason reason = LossReason::kTooLarge;
  BodyIndex body;     // the first one that failed
  double time = 0.0;  // s: when it failed, within the step that was given up

  // One line for people; `stands_at` in s is the end of the last good step.
  [[nodiscard]] std::string text(const std::vector<Body>& bodies, double stands_at) const;
};

}  // namespace carom
