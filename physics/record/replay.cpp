#include "physics/record/replay.h"

#include <algorithm>

namespace carom {

void KeyFrames::take(const Simulation& simulation, const Sampler& sampler) {
  if (simulation.steps() % interval_ != 0) return;
  KeyFrame frame{simulation.model(), simulation.run_state(), sampler};
  // A replay from here is on another thread than the run.
  frame.sampler.interrupt_on({});
  (void)frame.sampler.take();  // the rows so far belong to the run itself
  frames_.push_back(std::make_shared<const KeyFrame>(std::move(frame)));
  if (frames_.size() <= kMost) return;
  interval_ *= 2;
  std::erase_if(frames_, [this](const auto& f) { return f->state.clock.steps % interval_ != 0; });
}

std::shared_ptr<const KeyFrame> latest_before(std::span<const std::shared_ptr<const KeyFrame>> frames,
                                              double time, const std::vector<Curve>& curves) {
  const auto found = std::find_if(frames.rbegin(), frames.rend(), [&](const auto& frame) {
    return frame->state.clock.time < time && frame->sampler.can_read(curves);
  });
  return found == frames.rend() ? nullptr : *found;
}

}  // namespace carom
