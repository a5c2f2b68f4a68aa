#include "physics/record/replay.h"

#include <algorithm>

namespace carom {
namespace {

// Whether the last step was shorter than the others, to the time of an edit: only a run with this edit comes
// there.
bool ends_at_edit(const RunClock& clock, double step) { return clock.steps > 0 && clock.origin_step != step; }

}  // namespace

void KeyFrames::take(const Simulation& simulation, const Sampler& sampler, double wall_time) {
  const bool at_edit = simulation.due() != nullptr;
  if (!frames_.empty()) {
    if (!at_edit && simulation.steps() % interval_ != 0) return;
    const bool is_there = frames_.back()->state.clock.steps == simulation.steps();
    if (is_there && (frames_.back()->at_edit || !at_edit)) return;
    if (is_there) frames_.pop_back();
  }
  KeyFrame frame{simulation.compiled(), simulation.run_state(), sampler, wall_time, at_edit};
  // A replay from here may be on another thread than the run.
  frame.sampler.interrupt_on({});
  (void)frame.sampler.take();  // the rows so far belong to the run itself
  frames_.push_back(std::make_shared<const KeyFrame>(std::move(frame)));
  thin();
}

void KeyFrames::thin() {
  const auto at_edits = std::count_if(frames_.begin(), frames_.end(), [](const auto& f) { return f->at_edit; });
  if (static_cast<std::size_t>(at_edits) > kMostAtEdits)
    frames_.erase(std::find_if(frames_.begin(), frames_.end(), [](const auto& f) { return f->at_edit; }));
  const auto spaced = frames_.size() - std::min<std::size_t>(at_edits, kMostAtEdits);
  if (spaced <= kMost) return;
  interval_ *= 2;
  const auto is_between = [this](const auto& f) {
    return !f->at_edit && f->state.clock.steps % interval_ != 0;
  };
  frames_.erase(std::remove_if(frames_.begin() + 1, frames_.end(), is_between), frames_.end());
}

std::shared_ptr<const KeyFrame> KeyFrames::go_back(const std::vector<RunEdit>& edits, std::size_t same,
                                                   const std::vector<Curve>& curves, double time) {
  const auto can_go_on = [&](const KeyFrame& frame) {
    if (frame.state.clock.time >= time) return false;
    if (frame.state.edits_applied > same || !frame.sampler.can_read(curves)) return false;
    const double step = frame.state.method.step;
    if (same == edits.size()) return !ends_at_edit(frame.state.clock, step);
    const double time_of_next = edits[same].time;
    return !was_due_before(edits[same], frame.state.clock.time, step) &&
           (time_of_next == frame.state.clock.time || !ends_at_edit(frame.state.clock, step));
  };
  const auto found =
      std::find_if(frames_.rbegin(), frames_.rend(), [&](const auto& frame) { return can_go_on(*frame); });
  if (found == frames_.rend()) return nullptr;
  frames_.erase(found.base(), frames_.end());
  return frames_.back();
}

std::shared_ptr<const KeyFrame> latest_before(std::span<const std::shared_ptr<const KeyFrame>> frames,
                                              double time, const std::vector<Curve>& curves) {
  const auto found = std::find_if(frames.rbegin(), frames.rend(), [&](const auto& frame) {
    return frame->state.clock.time < time && frame->sampler.can_read(curves);
  });
  return found == frames.rend() ? nullptr : *found;
}

}  // namespace carom
