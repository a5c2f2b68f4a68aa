#include <algorithm>
#include <cmath>

#include "widgets/scene/force_tool.h"
#include "widgets/scene/scene_view.h"

// The scales of a scene's arrows.
namespace carom {
namespace {

constexpr double kLongestHeld = 0.5;  // of the view's shorter side, for an arrow whose scale is held

}  // namespace

// The scale that an edit found stays, unless arrows grow out of the view.
void SceneView::release_arrows() {
  if (!held_arrows_ || tools_->dragging()) return;
  if (peaks_.speed * held_arrows_->seconds > kLongestHeld * home_side_) held_arrows_.reset();
}

// So that what is drawn keeps its length: the first force too, which sets the scale.
void SceneView::hold_arrows(const SceneEdits& edits) {
  if (!held_arrows_) held_arrows_ = usual_arrows();
  const auto* added = edits.empty() ? nullptr : std::get_if<Add<AppliedForce>>(&edits.front());
  if (added == nullptr || shows_forces()) return;
  if (const auto body = body_at_end(*frame_, {added->part.body, Vec2::Zero()})) {
    held_arrows_->metres_per_newton = usual_metres_per_newton(*frame_, *body, picture_.camera.scale);
  }
}

bool SceneView::shows_forces() const { return peaks_.force > 0.0 || peaks_.contact_force > 0.0; }

ArrowScale SceneView::usual_arrows() const {
  ArrowScale scale = held_arrows_.value_or(arrow_scale(peaks_, home_side_));
  if (run_seconds_) scale.seconds = *run_seconds_;
  return scale;
}

ArrowScale SceneView::arrows() const { return usual_arrows() * times_; }

// One scale for all of a run: that of its energy, or of a fall through the view where it begins at rest. What
// is at rest without gravity has none yet.
void SceneView::hold_speeds(const Peaks& before) {
  if (run_seconds_ || !frame_->playing) return;
  Peaks expected = peaks_;
  if (!held_arrows_ && before.speed == 0.0 && (frame_->steps > 0 || peaks_.speed == 0.0)) {
    const double gravity = frame_->forces ? frame_->forces->gravity.norm() : 0.0;
    if (gravity == 0.0) return;
    expected.speed = std::max(expected.speed, std::sqrt(2.0 * gravity * home_side_));
  }
  run_seconds_ = held_arrows_.value_or(arrow_scale(expected, home_side_)).seconds;
}

std::optional<ScaleKind> SceneView::scale_under(const QPointF& at) const {
  if (tools_->tool() != SceneTool::kSelect) return std::nullopt;
  return arrow_scale_at(scale_row(picture_.drawing, picture_.camera, font()), at);
}

bool SceneView::change_scale(const QPointF& at, bool halve) {
  const auto scale = scale_under(at);
  if (!scale) return false;
  (*scale == ScaleKind::kVelocity ? times_.velocity : times_.force) *= halve ? 0.5 : 2.0;
  refresh();
  return true;
}

}  // namespace carom
