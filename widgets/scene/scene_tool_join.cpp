#include "widgets/scene/grid.h"
#include "widgets/scene/hit.h"
#include "widgets/scene/scene_tools.h"

// The scene's tools that draw joints, springs and forces, and the choice of one of them.
namespace carom {

JointSight SceneTools::joint_sight(const QPointF& at) const {
  const SceneSight sight = sight_();
  return {.frame = sight.frame,
          .camera = sight.camera,
          .mouse = {.at = sight.camera.to_world(at),
                    .scale = sight.camera.scale,
                    .keys = keys_,
                    .snapping = snapping_},
          .grid = sight.grid ? grid_spacing(sight.camera) : 0.0,
          .metres_per_newton = sight.forces_shown ? sight.metres_per_newton : 0.0,
          .arrow_seconds = sight.arrow_seconds};
}

// Both ends, once there is a first one.
std::optional<LinkEnds> SceneTools::drawn_ends() const {
  const JointTool& tool = *joint_tool(tool_);
  const JointSight sight = joint_sight(mouse_);
  if (tool.one_click) return ends_at_mouse(sight);
  if (!first_end_) return std::nullopt;
  return LinkEnds{*first_end_, tool.to_mouse ? LinkEnd{{}, sight.mouse.at} : end_at_mouse(tool, sight)};
}

// At the press of a drag.
void SceneTools::begin_link() {
  const JointTool& tool = *joint_tool(tool_);
  if (sight_().frame && !first_end_ && !tool.one_click) first_end_ = end_at_mouse(tool, joint_sight(press_));
  // A drive replaces its body as that stands in the paused scene.
  const bool on_body = first_end_ && !first_end_->body.empty();
  if (tool_ == SceneTool::kDrive && on_body && plays()) emit pauseRequested();
}

// At the end of a drag.
void SceneTools::end_link() {
  set_end();
  first_end_.reset();
}

// At a click.
void SceneTools::set_end() {
  if (!sight_().frame) return;
  if (const std::optional<LinkEnds> ends = drawn_ends()) return join(*ends);
  begin_link();
  // What no second end could make good is said at once.
  const bool on_body = joint_tool(tool_)->to_mouse || tool_ == SceneTool::kWeld;
  if (!on_body || !first_end_->body.empty()) return;
  const LinkEnd nowhere = *std::exchange(first_end_, std::nullopt);
  join({nowhere, nowhere});
}

void SceneTools::join(const LinkEnds& ends) {
  const JointTool& tool = *joint_tool(tool_);
  if (tool_ == SceneTool::kDrive && locked_.contains(ends[0].body)) return say_locked(ends[0].body);
  const Joined joined = tool.join(tool, joint_sight(mouse_), ends);
  if (!joined.fault.isEmpty()) return note({joined.fault, {}, mouse_, press_, true});
  first_end_.reset();
  await_part(joined.edits);
  const bool takes_value = awaited_part_ && draws_link_with_value();
  const QString refusal = own_edit(joined.edits, joined.name, ++drags_);
  if (!refusal.isEmpty()) {
    awaited_part_.reset();
    return note(refusal_bubble(refusal, mouse_, press_));
  }
  note({joined.value, joined.detail, mouse_, press_},
       takes_value ? std::optional(Grab{HandleKind::kBody, {}}) : std::nullopt);
  used_tool();
}

// The part that these edits make takes what is typed, once it is shown.
void SceneTools::await_part(const SceneEdits& edits) {
  awaited_part_.reset();
  made_part_.reset();
  const std::shared_ptr<const Scene> scene = sight_().frame->scene;
  if (!scene) return;  // a run plays: it pauses for the edit
  for (const SceneEdit& edit : edits) {
    if (std::holds_alternative<Add<Joint>>(edit)) awaited_part_ = newest_like(*scene, Id<Joint>{});
    if (std::holds_alternative<Add<Spring>>(edit)) awaited_part_ = newest_like(*scene, Id<Spring>{});
    if (std::holds_alternative<Add<AppliedForce>>(edit))
      awaited_part_ = newest_like(*scene, Id<AppliedForce>{});
  }
}

void SceneTools::find_made_part() {
  const std::shared_ptr<const Frame> frame = sight_().frame;
  if (!awaited_part_ || !frame || !frame->scene) return;
  const PartId newest = newest_like(*frame->scene, *awaited_part_);
  if (number_of(newest) <= number_of(*awaited_part_)) return;
  awaited_part_.reset();
  made_part_ = newest;
  const QString typed = std::exchange(typed_ahead_, {});
  if (!typed.isEmpty()) type_value_of({HandleKind::kBody, {}}, note_, typed);
}

// The selected bodies, or one of them and the plane.
void SceneTools::join_selected() {
  if (!sight_().frame) return;
  if (first_end_) return set_end();
  const JointTool& tool = *joint_tool(tool_);
  if (const auto ends = ends_of(tool, joint_sight(mouse_), selection_.names())) return join(*ends);
  note({tool.to_mouse ? QStringLiteral("select one body first")
                      : QStringLiteral("select one or two bodies first"),
        {},
        mouse_,
        press_,
        true});
}

void SceneTools::show_joining(Overlay& out) const {
  const JointSight sight = joint_sight(mouse_);
  if (!sight.frame || !(over_ || state_ == State::kDraw)) return;
  const JointTool& tool = *joint_tool(tool_);
  const std::optional<LinkEnds> ends = drawn_ends();
  const LinkEnds shown = ends.value_or(LinkEnds{end_at_mouse(tool, sight), LinkEnd{}});
  for (const LinkEnd& end : shown) {
    if (const auto body = body_at_end(*sight.frame, end)) out.lit.push_back(*body);
  }
  if (!ends || (tool.one_click && out.lit.empty())) return;
  const Joined joined = tool.join(tool, sight, *ends);
  const bool same = shown[0].body == shown[1].body && !shown[0].body.empty();
  const bool fault = !joined.fault.isEmpty() && !same;  // the mouse has not left the first body
  out.links.push_back({.from = joined.from, .to = joined.to, .arrow = tool.to_mouse, .fault = fault});
  if (!out.bubble.value.isEmpty() || same) return;
  const QPointF from = sight.camera.to_screen(joined.from);
  out.bubble = {fault ? joined.fault : joined.value, joined.detail, mouse_, from, fault};
}

// --- the chosen one

void SceneTools::choose(const std::optional<PartId>& part) {
  awaited_part_.reset();
  made_part_.reset();
  typed_ahead_.clear();
  if (part == part_) return;
  if (part) set_selection({});
  part_ = part;
  end_note();
  emit partChosen();
  emit changed();
}

std::optional<PartId> SceneTools::part_under(const QPointF& at) const {
  const SceneSight sight = sight_();
  if (tool_ != SceneTool::kSelect || !sight.frame) return std::nullopt;
  const std::optional<PartId> part = part_at(*sight.frame, sight.camera, at, sight.metres_per_newton);
  if (!part) return std::nullopt;
  const std::optional<Grab> grab = grab_at(at);
  if (!grab) return part;
  if (grab->kind != HandleKind::kBody) return std::nullopt;
  // What lies on bodies only, a pin or a weld, goes before them; once chosen, it lets a click through.
  const auto line = line_of(*sight.frame, *part, sight.metres_per_newton);
  const bool dot = line && line->from == line->to;
  return dot && part != part_ ? part : std::nullopt;
}

std::optional<std::size_t> SceneTools::end_under(const QPointF& at) const {
  const SceneSight sight = sight_();
  if (tool_ != SceneTool::kSelect || !part_ || !sight.frame) return std::nullopt;
  return end_of_part_at(*sight.frame, sight.camera, *part_, at, sight.metres_per_newton);
}

void SceneTools::begin_end_drag() {
  state_ = State::kMute;
  const SceneSight sight = sight_();
  if (!part_ || !sight.frame || !sight.frame->scene) return;
  JointSight began = joint_sight(press_);
  began.metres_per_newton = sight.metres_per_newton;
  end_drag_ = std::make_shared<EndDrag>(began, *part_, *end_);
  emitted_ = false;
  ++drags_;
  state_ = State::kEnd;
}

void SceneTools::drag_end_on() {
  moved_end_ = end_drag_->to(joint_sight(mouse_).mouse);
  // As long as nothing is changed, nothing has to go back.
  if (!emitted_ && !moved_end_.fault.isEmpty()) return;
  emitted_ = true;
  const QString refusal = own_edit(moved_end_.edits, moved_end_.name, drags_);
  if (moved_end_.fault.isEmpty()) moved_end_.fault = refusal;
}

void SceneTools::let_end_go() {
  if (moved_end_.fault.isEmpty())
    return note({moved_end_.value, moved_end_.detail, mouse_, press_}, Grab{HandleKind::kBody, {}});
  if (emitted_) emit dragCancelled(drags_);
  note(refusal_bubble(moved_end_.fault, mouse_, press_));
}

void SceneTools::show_moved_end(Overlay& out) const {
  const bool fault = !moved_end_.fault.isEmpty();
  const bool arrow = end_drag_->line().arrow;
  const SceneSight sight = sight_();
  const bool tip = arrow && end_drag_->end() != kFoot;
  const int body = tip ? -1 : body_at(*sight.frame, sight.camera, mouse_);
  if (body >= 0) out.lit.push_back(body_now(*sight.frame, body));
  out.links.push_back({.from = end_drag_->line().from, .to = end_drag_->line().to, .was = true});
  out.links.push_back({.from = moved_end_.from, .to = moved_end_.to, .arrow = arrow, .fault = fault});
  out.bubble = {fault ? moved_end_.fault : moved_end_.value, moved_end_.detail, mouse_, press_, fault};
}

void SceneTools::show_part(Overlay& out) const {
  const SceneSight sight = sight_();
  if (!part_ || !sight.frame) return;
  if (const auto line = line_of(*sight.frame, *part_, sight.metres_per_newton)) {
    out.links.push_back({.from = line->from, .to = line->to, .arrow = line->arrow, .chosen = true});
  }
}

}  // namespace carom
