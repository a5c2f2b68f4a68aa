#include <algorithm>
#include <string>
#include <unordered_set>
#include <utility>

#include "widgets/scene/drag_limits.h"
#include "widgets/scene/edit_names.h"
#include "widgets/scene/grid.h"
#include "widgets/scene/hit.h"
#include "widgets/scene/scene_tools.h"

// What surrounds an edit of the scene's tools, and what is left of it.
namespace carom {

DragStart SceneTools::start_of(const Grab& grab, std::vector<Body> bodies) const {
  const SceneSight sight = sight_();
  DragStart start{.kind = grab.kind,
                  .bodies = std::move(bodies),
                  .others = {},
                  .press = sight.camera.to_world(press_),
                  .arrow_seconds = sight.arrow_seconds,
                  .grid = sight.grid ? grid_spacing(sight.camera) : 0.0,
                  .keeps = keeps_,
                  .corner = grab.corner,
                  .forces = sight.frame->scene->forces,
                  .seen = sight.camera.visible()};
  Surroundings beside{{}, sight.frame->scene->joints};
  std::unordered_set<std::string> edited;
  for (const Body& body : start.bodies) edited.insert(body.name);
  for (int i = 0; i < body_count(*sight.frame); ++i) {
    Body body = body_now(*sight.frame, i);
    if (!edited.contains(body.name)) beside.bodies.push_back(std::move(body));
  }
  set_beside(start, std::move(beside));
  return start;
}

std::vector<Overlap> SceneTools::overlaps_of_new(const Body& body) const {
  const SceneSight sight = sight_();
  if (!sight.frame) return {};
  Surroundings beside;
  const Vec2 half = half_extent(body.shape, body.angle);
  const carom::State& state = sight.frame->state;
  for (int i = 0; i < body_count(*sight.frame); ++i) {
    const Vec2 apart = (state.position(i) - body.position).cwiseAbs();
    const Shape& other = (*sight.frame->bodies)[static_cast<std::size_t>(i)].shape;
    if ((apart.array() > (half + half_extent(other, state.q(2, i))).array()).any()) continue;
    beside.bodies.push_back(body_now(*sight.frame, i));
  }
  return overlaps_of({&body, 1}, beside);
}

// As of a body that is dragged; but a new one stays where it is drawn.
void SceneTools::show_overlaps_of_new(const Body& body, Overlay& out) const {
  out.overlaps = overlaps_of_new(body);
  if (out.overlaps.empty() || out.bubble.fault || out.bubble.value.isEmpty()) return;
  out.bubble.value = overlap_text(out.overlaps[0], point({}));
  out.bubble.detail = tr("It may stay so: play parts them.");
  out.bubble.fault = true;
}

bool SceneTools::can_touch() const { return selection_.names().size() == 2; }

void SceneTools::say_two_touch() {
  const QPointF at = sight_().camera.to_screen(selected_now().front().position);
  note({QStringLiteral("select two bodies"), QStringLiteral("K puts them in touch"), at, at, true});
}

void SceneTools::put_in_touch() {
  const std::vector<Body> bodies = selected_now();
  if (bodies.size() != 2) return;
  if (locked_.contains(bodies[0].name)) return say_locked(bodies[0].name);
  row_ = {};
  row_.start = start_of({HandleKind::kBody, {}}, {editable({}, HandleKind::kBody).front()});
  if (const auto locked = locked_among(row_.start.followers)) return say_locked(*locked);
  row_.drag = ++drags_;
  const Body moved = in_touch(row_.start.bodies[0], bodies[1]);
  const QString other = QString::fromStdString(bodies[1].name);
  change_by_key({.bodies = {moved},
                 .value = place_text(moved.position, sight_().camera.scale),
                 .detail = "touches " + other,
                 .name = "Put " + QString::fromStdString(moved.name) + " in touch with " + other});
  row_ = {};
}

bool SceneTools::can_align() const {
  return state_ == State::kNone && editable({}, HandleKind::kBody).size() >= 2;
}

void SceneTools::align(Alignment alignment) {
  if (!can_align()) return;
  row_ = {};
  DragStart start = start_of({HandleKind::kBody, {}}, editable({}, HandleKind::kBody));
  // What is joined to one of them does not follow: each goes its own way.
  start.others.insert(start.others.end(), start.followers.begin(), start.followers.end());
  start.followers.clear();
  Dragged wanted;
  wanted.bodies = aligned(start.bodies, alignment);
  wanted.name = name_of(alignment, start.bodies);
  const Dragged left = within_joints(start, std::move(wanted), point(Qt::ControlModifier));
  const QString refusal = emit_change(left, left.refits, ++drags_);
  if (!refusal.isEmpty()) return note(refusal_bubble(refusal, mouse_, press_));
  say_overlap(left.bodies, {start.others, start.joints});
}

// The deepest one of the bodies with each other and with their neighbours.
void SceneTools::say_overlap(const std::vector<Body>& bodies, const Surroundings& beside) {
  std::optional<Overlap> deepest;
  Surroundings rest = beside;
  for (const Body& body : bodies) {
    const std::vector<Overlap> overlaps = overlaps_of({&body, 1}, rest);
    if (!overlaps.empty() && (!deepest || overlaps[0].depth > deepest->depth)) deepest = overlaps[0];
    rest.bodies.push_back(body);
  }
  if (!deepest) return end_note();
  const QPointF at = sight_().camera.to_screen(deepest->body.position);
  note({overlap_text(*deepest, point({})), QStringLiteral("They stay so; play parts them."), at, at, true});
}

// Those that a drag changes are known to it.
void SceneTools::find_kept_overlaps() {
  const std::shared_ptr<const Frame> frame = sight_().frame;
  if (state_ == State::kDrag || std::exchange(kept_in_, frame) == frame) return;
  kept_.clear();
  if (!frame || !frame->scene || frame->steps > 0) return;
  std::vector<Body> bodies;
  for (int i = 0; i < body_count(*frame); ++i) bodies.push_back(body_now(*frame, i));
  kept_ = overlaps_among(bodies, frame->scene->joints);
  // More signs would hide the scene, as those of a pile whose method lets each contact overlap a little.
  constexpr std::ptrdiff_t kMostSigns = 12;
  if (std::ssize(kept_) <= kMostSigns) return;
  std::partial_sort(kept_.begin(), kept_.begin() + kMostSigns, kept_.end(),
                    [](const Overlap& a, const Overlap& b) { return a.depth > b.depth; });
  kept_.resize(kMostSigns);
}

void SceneTools::show_kept_overlaps(Overlay& out) const {
  const auto changes = [this](const Body& body) {
    const auto is_it = [&](const Body& other) { return other.name == body.name; };
    return std::any_of(dragged_.bodies.begin(), dragged_.bodies.end(), is_it);
  };
  for (const Overlap& overlap : kept_) {
    if (state_ == State::kDrag && (changes(overlap.body) || changes(overlap.other))) continue;
    out.signs.push_back(overlap.at);
  }
}

void SceneTools::change_by_key(Dragged wanted) {
  const Camera camera = sight_().camera;
  const DragPoint keyed{.at = Vec2::Zero(), .scale = camera.scale, .keys = {}};
  row_.start.press = row_.start.bodies[0].position;
  const std::optional<Dragged> left =
      without_overlaps(row_.start, within_joints(row_.start, std::move(wanted), keyed), keyed);
  // At the upper right of the body.
  const Body body = left ? left->bodies[0] : row_.start.bodies[0];
  const Vec2 half = half_extent(body.shape, body.angle);
  const QPointF centre = camera.to_screen(body.position);
  const QPointF corner = half.allFinite() ? camera.to_screen(body.position + half) : centre;
  if (!left) return note({QStringLiteral("no room there"), {}, corner, centre, true});
  const auto count = static_cast<std::ptrdiff_t>(row_.start.bodies.size());
  row_.start.bodies.assign(left->bodies.begin(), left->bodies.begin() + count);
  if (left->bodies.begin() + count != left->bodies.end()) {
    row_.start.followers.assign(left->bodies.begin() + count, left->bodies.end());
  }
  const QString refusal = emit_change(*left, false, row_.drag);
  if (!refusal.isEmpty()) {
    row_ = {};
    return note(refusal_bubble(refusal, corner, centre));
  }
  note({left->value, left->detail, corner, centre, left->fault},
       Grab{row_.start.kind, row_.start.bodies[0].name});
}

// Overlaps are solved in the step of undo that the drag is.
void SceneTools::end_drag() {
  if (!dragged_.refused.empty()) {
    if (emitted_) emit dragCancelled(drags_);
    return note({dragged_.value, {}, mouse_, press_, true});
  }
  const std::optional<Dragged> left = without_overlaps(start_, dragged_, point(keys_));
  if (!left) {
    if (emitted_) emit dragCancelled(drags_);
    return note({QStringLiteral("no room there"), {}, mouse_, press_, true});
  }
  const QString refusal = left->fault != dragged_.fault ? emit_change(*left, refitted_, drags_) : QString();
  if (!refusal.isEmpty()) return note(refusal_bubble(refusal, mouse_, press_));
  note({left->value, left->detail, mouse_, press_, left->fault},
       Grab{start_.kind, start_.bodies[0].name, start_.corner});
}

QString SceneTools::emit_change(const Dragged& change, bool joints, int drag) {
  return own_edit(edits_as_seen(change, joints), change.name, drag);
}

}  // namespace carom
