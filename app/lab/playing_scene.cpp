#include "app/lab/playing_scene.h"

#include <algorithm>
#include <utility>
#include <variant>

#include "app/lab/document_change.h"

namespace carom {
namespace {

// The edits of the scene of this id that the run has had.
std::size_t count_made(const RunSetup& run, Worker::EditId id) {
  return static_cast<std::size_t>(std::count_if(run.edits.begin(), run.edits.end(), [id](const RunEdit& edit) {
    return edit.id == id && std::holds_alternative<SceneEdits>(edit.what);
  }));
}

// Whether the two are of one run with the same edits, but for hands.
bool same_but_hands(const RunSetup& a, const RunSetup& b) {
  const auto next = [](auto edit, auto end) { return std::find_if_not(edit, end, moves_hand); };
  auto x = next(a.edits.begin(), a.edits.end());
  auto y = next(b.edits.begin(), b.edits.end());
  while (x != a.edits.end() && y != b.edits.end() && is_same(*x, *y)) {
    x = next(x + 1, a.edits.end());
    y = next(y + 1, b.edits.end());
  }
  return x == a.edits.end() && y == b.edits.end();
}

void take_motion(const Frame& frame, Scene& scene) {
  const std::size_t count = std::min(scene.bodies.size(), static_cast<std::size_t>(frame.state.size()));
  for (std::size_t i = 0; i < count; ++i) {
    Body& body = scene.bodies[i];
    if (has_infinite_mass(body)) continue;
    const auto index = static_cast<int>(i);
    body.position = frame.state.position(index);
    body.angle = frame.state.q(2, index);
    body.velocity = frame.state.velocity(index);
    body.spin = frame.state.v(2, index);
  }
}

// The lengths that joints have in the run, where they don't state them.
void take_lengths(const Frame& frame, Scene& scene) {
  const std::size_t count = std::min(scene.joints.size(), frame.joints.size());
  for (std::size_t i = 0; i < count; ++i) {
    Joint& joint = scene.joints[i];
    const bool has_length = joint.kind == JointKind::kRod || joint.kind == JointKind::kString;
    if (has_length && !joint.length && joint.kind == frame.joints[i].kind)
      joint.length = frame.joints[i].length;
  }
}

}  // namespace

void PlayingScene::expect(Worker::EditId edit, const SceneEdits& edits) {
  const auto waiting =
      std::count_if(expected_.begin(), expected_.end(), [edit](const Expected& e) { return e.edit == edit; });
  const std::size_t made = setup_ == nullptr ? 0 : count_made(*setup_, edit);
  expected_.push_back({edit, made + static_cast<std::size_t>(waiting), edits});
  parts_.reset();
}

void PlayingScene::forget_expected() {
  if (expected_.empty()) return;
  expected_.clear();
  parts_.reset();
}

std::shared_ptr<const Scene> PlayingScene::parts(const std::shared_ptr<const Frame>& frame) {
  const bool same = parts_ != nullptr && frame->bodies == bodies_ &&
                    (frame->setup == setup_ || same_but_hands(*frame->setup, *setup_));
  if (same) {
    setup_ = frame->setup;
  } else {
    build(*frame);
  }
  return parts_;
}

std::shared_ptr<const Scene> PlayingScene::at(const std::shared_ptr<const Frame>& frame) {
  const std::shared_ptr<const Scene> now = parts(frame);
  if (frame == frame_) return moment_;
  auto moment = std::make_shared<Scene>(*now);
  take_motion(*frame, *moment);
  frame_ = frame;
  moment_ = moment;
  return moment_;
}

void PlayingScene::build(const Frame& frame) {
  std::erase_if(expected_, [&](const Expected& e) { return count_made(*frame.setup, e.edit) > e.earlier; });
  auto scene = std::make_shared<Scene>(*scene_at_start(frame.setup->scene));
  scene->generators.clear();
  for (const RunEdit& edit : frame.setup->edits) {
    const auto* edits = std::get_if<SceneEdits>(&edit.what);
    if (edits != nullptr && is_due(edit, frame.time, frame.method.step)) apply_edits(*scene, *edits);
  }
  // The run's own list, which has what else was done to the bodies.
  scene->bodies = *frame.bodies;
  for (std::size_t i = 0; i < scene->bodies.size(); ++i) {
    Id<Body>& id = scene->bodies[i].id;
    if (id.number == 0) id.number = kFirstGenerated + static_cast<std::uint32_t>(i);
  }
  take_lengths(frame, *scene);
  take_motion(frame, *scene);
  for (const Expected& e : expected_) apply_edits(*scene, with_motion_of(scene->bodies, e.edits));
  setup_ = frame.setup;
  bodies_ = frame.bodies;
  parts_ = scene;
  frame_.reset();  // its moment had other parts
}

}  // namespace carom
