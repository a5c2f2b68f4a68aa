#pragma once

#include <QElapsedTimer>

#include "physics/record/frame.h"
#include "widgets/scene/camera.h"

namespace carom {

// A camera that goes with the bodies that move, and when to offer it: once all of them have been outside the
// view for a second as the run plays. The second is one of the clock on the wall.
class Follow {
 public:
  void observe(const Frame& frame, const Camera& camera);
  [[nodiscard]] bool offered() const { return offered_ && !on_; }

  void begin() { on_ = true; }
  void end();
  [[nodiscard]] bool on() const { return on_; }
  // Puts the bodies that move into the middle, and shows more where they spread beyond the margins (px).
  static void show_moving(const Frame& frame, Camera& camera, const QMarginsF& margins);

 private:
  QElapsedTimer lost_;  // runs while the bodies are outside
  bool offered_ = false;
  bool on_ = false;
};

}  // namespace carom
