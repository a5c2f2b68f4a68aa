#include "physics/scene/hand.h"
#include "widgets/scene/scene_tools.h"

// While a run plays, the mouse is a hand that pulls bodies by a spring.
namespace carom {
namespace {

constexpr qint64 kBetweenPulls = 25;  // ms

}  // namespace

void SceneTools::begin_hand() {
  if (locked_.contains(grab_->body)) return say_locked(grab_->body);
  if (has_infinite_mass(*pressed_)) {
    return note({pressed_->fixed ? tr("fixed; pause to move it") : tr("driven; pause to move it"),
                 {},
                 mouse_,
                 press_,
                 true});
  }
  hand_ = hand_on(*pressed_, pressed_place_, sight_().frame->method.step);
  state_ = State::kHand;
  since_pull_.invalidate();
  refusal_.clear();
  telling_ = true;
  pull();
  telling_ = false;
  if (refusal_.isEmpty()) return;
  end_hand();
  note(refusal_bubble(refusal_, mouse_, press_));
}

bool SceneTools::holds() const {
  const auto body = index_.find(grab_->body);
  return plays() && body != index_.end() &&
         !has_infinite_mass((*bodies_)[static_cast<std::size_t>(body->second)]);
}

// With each picture, but not more often than the eye sees.
void SceneTools::pull() {
  const Vec2 place = sight_().camera.to_world(mouse_);
  if (since_pull_.isValid() && (place == hand_->place || since_pull_.elapsed() < kBetweenPulls)) return;
  since_pull_.start();
  hand_->place = place;
  emit pulled(*hand_);
}

void SceneTools::end_hand() {
  state_ = State::kMute;
  hand_.reset();
  emit letGo();
}

}  // namespace carom
