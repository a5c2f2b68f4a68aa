#include "widgets/scene/scene_tools.h"

#include <QLineF>
#include <algorithm>
#include <cmath>
#include <utility>

#include "physics/math/vectors.h"
#include "widgets/edit/driven.h"
#include "widgets/scene/drag_limits.h"
#include "widgets/scene/hit.h"
#include "widgets/scene/impact_marks.h"

namespace carom {
namespace {

constexpr int kNoteShown = 4000;  // ms

bool same(const Body& a, const Body& b) {
  return a.position == b.position && a.angle == b.angle && a.velocity == b.velocity && a.spin == b.spin &&
         half_extent(a.shape, 0.0) == half_extent(b.shape, 0.0);
}

}  // namespace

SceneTools::SceneTools(std::function<SceneSight()> sight, QObject* parent)
    : QObject(parent), sight_(std::move(sight)) {
  note_time_.setSingleShot(true);
  connect(&note_time_, &QTimer::timeout, this, &SceneTools::end_note);
}

QString SceneTools::own_edit(const SceneEdits& edits, const QString& name, int drag) {
  refusal_.clear();
  telling_ = true;
  emit edited(edits, name, drag);
  telling_ = false;
  return refusal_;
}

bool SceneTools::refuse(const QString& sentence) {
  if (telling_) refusal_ = sentence;
  return telling_;
}

void SceneTools::scene_edited() {
  if (telling_) return;
  row_ = {};
  awaited_part_.reset();
  typed_ahead_.clear();
  drop_typing();
  end_note();
}

void SceneTools::note(const Bubble& bubble, const std::optional<Grab>& of) {
  note_ = bubble;
  note_of_ = of;
  note_time_.start(kNoteShown);
  emit changed();
}

void SceneTools::end_note() {
  if (note_.value.isEmpty()) return;
  note_ = {};
  note_of_.reset();
  note_time_.stop();
  emit changed();
}

std::vector<Body> SceneTools::selected_now() const {
  const SceneSight sight = sight_();
  std::vector<Body> bodies;
  if (!sight.frame) return bodies;
  for (const int i : selected_indices()) {
    if (i < body_count(*sight.frame)) bodies.push_back(body_now(*sight.frame, i));
  }
  return bodies;
}

std::vector<Body> SceneTools::editable(const std::string& first, HandleKind kind) const {
  std::vector<Body> bodies;
  const std::shared_ptr<const Frame> frame = sight_().frame;
  if (!frame || !frame->scene) return bodies;
  for (const int i : selected_indices()) {
    if (i >= static_cast<int>(frame->scene->bodies.size())) continue;
    const Body& body = frame->scene->bodies[static_cast<std::size_t>(i)];
    if (kind == HandleKind::kVelocity && !has_own_velocity(body)) continue;
    if (kind == HandleKind::kSpin && has_infinite_mass(body)) continue;
    if (locked_.contains(body.name)) continue;
    bodies.push_back(moved_by_drive(body, frame->time));
    if (body.name == first) std::swap(bodies.front(), bodies.back());
  }
  return bodies;
}

void SceneTools::frame_changed() {
  const std::shared_ptr<const Frame> frame = sight_().frame;
  const std::shared_ptr<const std::vector<Body>> bodies = frame ? frame->bodies : nullptr;
  if (bodies != bodies_) {
    if (bodies && bodies_) rename_locked(*bodies_, *bodies);
    bodies_ = bodies;
    index_.clear();
    for (int i = 0; i < (frame ? body_count(*frame) : 0); ++i) {
      index_.emplace((*bodies)[static_cast<std::size_t>(i)].name, i);
    }
    const auto is_there = [this](const std::string& name) { return index_.contains(name); };
    stay_.keep_if(is_there);
    if (selection_.keep_if(is_there)) {
      emit selectionChanged(selection_.names());
    }
  }
  if (!frame) drop_draft();
  if (first_end_ && !first_end_->body.empty() && !index_.contains(first_end_->body)) first_end_.reset();
  if (part_ && (!frame || (frame->scene && !has_part(*frame->scene, *part_)))) choose(std::nullopt);
  // What is said of a value ends as the run goes on; a sentence on what can't be stays.
  if (!frame || (!frame->scene && note_of_)) end_note();
  const bool draws = frame && typing_ && typing_->drawing;
  const bool typed =
      frame && frame->scene && typing_ &&
      (typing_->target.body.empty() ? part_ || made_part_ : index_.contains(typing_->target.body));
  if (!typed && !draws) drop_typing();
  select_awaited();
  find_made_part();
  if (!frame) waiting_keys_.clear();
  if (!waiting_keys_.empty() && awaited_.empty() && frame->scene)
    QTimer::singleShot(0, this, &SceneTools::press_waiting_keys);
  const bool held = frame && frame->scene && grab_ && index_.contains(grab_->body);
  const bool gone = state_ == State::kPressed && grab_ && !index_.contains(grab_->body);
  if ((state_ == State::kDrag && !held) || gone) state_ = State::kMute;
  if (state_ == State::kEnd && !(part_ && frame && frame->scene)) state_ = State::kMute;
  find_kept_overlaps();
  if (state_ == State::kHand) holds() ? pull() : end_hand();
}

// --- tools

void SceneTools::set_tool(SceneTool tool, bool keep) {
  const bool kept = keep && tool != SceneTool::kSelect;
  if (tool == tool_ && kept == keep_tool_) return;
  keep_tool_ = kept;
  if (std::exchange(tool_, tool) != tool) {
    if (typing_ && typing_->drawing) drop_typing();
    drop_draft();
  }
  emit toolChanged(tool, kept);
  emit changed();
}

void SceneTools::drop_draft() {
  draft_.clear();
  first_end_.reset();
  emit changed();
}

void SceneTools::used_tool() {
  if (!keep_tool_) set_tool(SceneTool::kSelect, false);
}

// --- the drag

std::vector<Handle> SceneTools::handles(const SceneSight& sight) const {
  // With another tool in hand none takes the press.
  if (tool_ != SceneTool::kSelect || !sight.frame || !sight.frame->scene) return {};
  const std::vector<Body> bodies = selected_now();
  const bool turns = state_ == State::kDrag && grab_->kind == HandleKind::kTurn && bodies.size() == 1;
  const double turned = turns ? bodies.front().angle - start_.bodies.front().angle : 0.0;
  std::vector<Handle> handles = handles_of(
      bodies, sight.camera, sight.velocities ? std::optional(sight.arrow_seconds) : std::nullopt, turned);
  std::erase_if(handles, [&](const Handle& handle) { return locked_.contains(bodies[handle.body].name); });
  return handles;
}

std::optional<SceneTools::Grab> SceneTools::grab_at(const QPointF& at) const {
  const SceneSight sight = sight_();
  const ShapeTool* tool = shape_tool(tool_);
  if (!sight.frame || joint_tool(tool_) != nullptr || (tool != nullptr && tool->over_bodies)) {
    return std::nullopt;
  }
  if (const auto handle = handle_at(handles(sight), at)) {
    return Grab{handle->kind, selection_.names()[handle->body], handle->corner};
  }
  const std::vector<std::string> names = names_at(at);
  if (names.empty()) return std::nullopt;
  const auto selected = selected_among(names);
  const bool clicked = was_clicked(at) && selected != names.end();
  return Grab{HandleKind::kBody, clicked ? *selected : names.front()};
}

// Whether the last click that selected a body was there.
bool SceneTools::was_clicked(const QPointF& at) const {
  return clicked_ && QLineF(*clicked_, at).length() < kDragBegins;
}

std::vector<std::string>::const_iterator SceneTools::selected_among(
    const std::vector<std::string>& names) const {
  return std::find_if(names.begin(), names.end(),
                      [this](const std::string& name) { return selection_.contains(name); });
}

// Of the bodies there, the topmost first.
std::vector<std::string> SceneTools::names_at(const QPointF& at) const {
  const SceneSight sight = sight_();
  std::vector<std::string> names;
  for (const int i : bodies_at(*sight.frame, sight.camera, at)) {
    names.push_back((*sight.frame->bodies)[static_cast<std::size_t>(i)].name);
  }
  return names;
}

// The topmost body at the press; after a click on the same spot that selected one, the next one below that.
std::string SceneTools::clicked_body() {
  const std::vector<std::string> names = names_at(press_);
  const auto selected = selected_among(names);
  const bool next = was_clicked(press_) && selection_.names().size() == 1 && selected != names.end();
  clicked_ = press_;
  if (names.empty()) return grab_->body;
  if (next) clicked_through_ = selection_.names();
  return next && selected + 1 != names.end() ? *(selected + 1) : names.front();
}

DragPoint SceneTools::point(Qt::KeyboardModifiers keys) const {
  const Camera camera = sight_().camera;
  return {camera.to_world(mouse_), camera.scale, keys, swept_, snapping_};
}

void SceneTools::press(const QPointF& at, bool repeated) {
  row_ = {};
  end_note();
  press_ = mouse_ = at;
  const bool grabbed_before = std::exchange(press_grabs_, false);
  if (repeated && clicked_through_ && was_clicked(at)) set_selection(*clicked_through_);
  clicked_through_.reset();
  grab_ = grab_at(at);
  press_grabs_ = grab_.has_value();
  pressed_.reset();
  if (grab_ && plays()) pressed_ = body_now(*sight_().frame, index_.at(grab_->body));
  pressed_place_ = sight_().camera.to_world(at);
  swept_ = 0.0;
  end_ = end_under(at);
  over_ = true;
  // The second click of a double click closes a polygon; it would hit the body of the first.
  const bool used = repeated && tool_ != SceneTool::kSelect && !(grabbed_before && press_grabs_);
  if (repeated && !draft_.empty()) close_polygon();
  state_ = used ? State::kMute : State::kPressed;
  repeated_ = repeated;
  emit changed();
}

void SceneTools::move(const QPointF& at, Qt::KeyboardModifiers keys) {
  if (state_ == State::kPressed || state_ == State::kDrag) sweep(mouse_, at);
  mouse_ = at;
  keys_ = keys;
  if (state_ == State::kPressed && QLineF(press_, at).length() >= kDragBegins) begin();
  if (state_ == State::kDrag) drag_on();
  if (state_ == State::kEnd) drag_end_on();
  if (state_ != State::kNone && state_ != State::kPressed && state_ != State::kMute) emit changed();
}

void SceneTools::hover(const QPointF& at, Qt::KeyboardModifiers keys) {
  mouse_ = at;
  keys_ = keys;
  over_ = true;
  if (has_draft()) end_note();
  if (has_draft() || joint_tool(tool_) != nullptr) emit changed();
}

void SceneTools::leave() {
  over_ = false;
  if (has_draft() || joint_tool(tool_) != nullptr) emit changed();
}

void SceneTools::hold_keys(Qt::KeyboardModifiers keys) {
  if (state_ == State::kDrag || state_ == State::kEnd || state_ == State::kDraw) {
    move(mouse_, keys);
  } else if (has_draft()) {
    keys_ = keys;
    emit changed();
  }
}

void SceneTools::begin() {
  if (end_) {
    begin_end_drag();
  } else if (!grab_) {
    state_ = tool_ != SceneTool::kSelect ? State::kDraw : State::kBand;
    if (joint_tool(tool_) != nullptr) begin_link();
  } else {
    begin_drag();
  }
}

void SceneTools::begin_drag() {
  const SceneSight sight = sight_();
  state_ = State::kMute;
  if (pressed_ && plays()) return begin_hand();
  if (!sight.frame || !sight.frame->scene) return;
  if (!selection_.contains(grab_->body)) set_selection({grab_->body});
  if (locked_.contains(grab_->body)) return say_locked(grab_->body);
  start_ = start_of(*grab_, editable(grab_->body, grab_->kind));
  if (start_.bodies.empty() || start_.bodies.front().name != grab_->body) return;
  if (const auto locked = locked_among(start_.followers)) return say_locked(*locked);
  dragged_ = {.bodies = start_.bodies, .value = {}, .detail = {}, .name = {}};
  ghosts_.clear();
  const bool arrows = grab_->kind == HandleKind::kVelocity;
  const bool shown = grab_->kind != HandleKind::kSpin;  // what it was is seen in no outline
  for (const Body& body : shown ? selected_now() : std::vector<Body>()) {
    if (!arrows || has_own_velocity(body)) ghosts_.push_back({body, arrows});
  }
  for (const Body& body : shown ? start_.followers : std::vector<Body>()) ghosts_.push_back({body, arrows});
  emitted_ = refitted_ = false;
  ++drags_;
  state_ = State::kDrag;
  emit changed();
}

void SceneTools::sweep(const QPointF& from, const QPointF& to) {
  if (!grab_ || grab_->kind != HandleKind::kSpin || !index_.contains(grab_->body)) return;
  const SceneSight sight = sight_();
  const Vec2 centre = body_now(*sight.frame, index_.at(grab_->body)).position;
  const Vec2 a = sight.camera.to_world(from) - centre;
  const Vec2 b = sight.camera.to_world(to) - centre;
  swept_ += std::atan2(cross(a, b), a.dot(b));
}

void SceneTools::drag_on() {
  const DragPoint now = point(keys_);
  Dragged next = within_joints(start_, drag_to(start_, now), now);
  const bool moved =
      !std::equal(next.bodies.begin(), next.bodies.end(), dragged_.bodies.begin(), dragged_.bodies.end(), same);
  dragged_ = std::move(next);
  if (!moved) return;
  emitted_ = true;
  refitted_ |= dragged_.refits;
  const QString refusal = emit_change(dragged_, refitted_, drags_);
  if (refusal.isEmpty()) return;
  const Bubble why = refusal_bubble(refusal, mouse_, press_);
  dragged_.value = why.value;
  dragged_.detail = why.detail;
  dragged_.fault = true;
}

void SceneTools::release(const QPointF& at, Qt::KeyboardModifiers keys) {
  mouse_ = at;
  keys_ = keys;
  switch (std::exchange(state_, State::kNone)) {
    case State::kPressed:
      if (!repeated_ || !type_at(press_)) click(keys);
      break;
    case State::kBand:
      select_band(keys);
      break;
    case State::kDrag:
      end_drag();
      break;
    case State::kHand:
      end_hand();
      state_ = State::kNone;
      break;
    case State::kEnd:
      let_end_go();
      break;
    case State::kDraw:
      draw();
      break;
    default:
      break;
  }
  grab_.reset();
  end_.reset();
  find_kept_overlaps();
  emit changed();
}

std::optional<ImpactRecord> SceneTools::mark_under(const QPointF& at) const {
  const SceneSight sight = sight_();
  if (tool_ != SceneTool::kSelect || !sight.frame || sight.frame->playing) return std::nullopt;
  const std::optional<Grab> grab = grab_at(at);
  if (grab && grab->kind != HandleKind::kBody) return std::nullopt;
  return impact_at(sight.marks, sight.camera, at);
}

void SceneTools::click(Qt::KeyboardModifiers keys) {
  const bool shift = keys.testFlag(Qt::ShiftModifier);
  const std::optional<ImpactRecord> mark = shift ? std::nullopt : mark_under(press_);
  if (mark) return emit impactChosen(mark->time);
  if (const auto part = part_under(press_)) return choose(part);
  if (grab_ && grab_->kind == HandleKind::kBody) {
    Selection next = selection_;
    if (shift) {
      next.toggle(grab_->body);
    } else {
      next.set({clicked_body()});
    }
    set_selection(next.names());
  } else if (!grab_ && joint_tool(tool_) != nullptr) {
    set_end();
  } else if (!grab_ && shape_tool(tool_) != nullptr) {
    if (shape_tool(tool_)->by_corners) {
      set_corner();
    } else {
      add_usual();
    }
  } else if (!grab_ && !shift) {
    set_selection({});
  }
}

void SceneTools::pick(const QPointF& at) {
  const SceneSight sight = sight_();
  if (!sight.frame) return;
  const auto under = part_at(*sight.frame, sight.camera, at, sight.metres_per_newton);
  if (part_ && under == part_) return;
  if (const auto part = part_under(at)) return choose(part);
  if (handle_at(handles(sight), at)) return;  // of a selected body
  const int body = body_at(*sight.frame, sight.camera, at);
  if (body < 0) return set_selection({});
  const std::string& name = (*sight.frame->bodies)[static_cast<std::size_t>(body)].name;
  if (!selection_.contains(name)) set_selection({name});
}

void SceneTools::select_band(Qt::KeyboardModifiers keys) {
  const SceneSight sight = sight_();
  if (!sight.frame) return;
  const bool adds = keys.testFlag(Qt::ShiftModifier);
  const bool takes = keys.testFlag(Qt::ControlModifier);
  Selection next;
  if (adds || takes) next = selection_;
  for (const int i : bodies_in(*sight.frame, sight.camera, QRectF(press_, mouse_).normalized())) {
    const std::string& name = (*sight.frame->bodies)[static_cast<std::size_t>(i)].name;
    if (next.contains(name) == takes) next.toggle(name);
  }
  set_selection(next.names());
}

// --- what is shown

Qt::CursorShape SceneTools::cursor(const QPointF& at) const {
  if (state_ == State::kHand || (state_ == State::kDrag && grab_->kind == HandleKind::kBody))
    return Qt::ClosedHandCursor;
  if (state_ == State::kNone ? end_under(at) : end_) return Qt::PointingHandCursor;
  if (state_ == State::kNone && mark_under(at)) return Qt::PointingHandCursor;
  const std::optional<Grab> grab = state_ == State::kNone ? grab_at(at) : grab_;
  if (!grab) return tool_ != SceneTool::kSelect ? Qt::CrossCursor : Qt::ArrowCursor;
  switch (grab->kind) {
    case HandleKind::kBody:
      return Qt::OpenHandCursor;
    case HandleKind::kTurn:
    case HandleKind::kVelocity:
    case HandleKind::kSpin:
      return Qt::PointingHandCursor;
    default:
      return Qt::SizeAllCursor;
  }
}

Overlay SceneTools::overlay() const {
  const SceneSight sight = sight_();
  Overlay out;
  out.selected = selected_now();
  out.handles = out.grips = handles(sight);
  out.arrow_seconds = sight.arrow_seconds;
  show_locks(out);
  show_kept_overlaps(out);
  if (state_ == State::kDrag) {
    std::erase_if(out.handles, [this](const Handle& handle) {
      return handle.kind != grab_->kind || handle.corner != grab_->corner ||
             selection_.names()[handle.body] != grab_->body;
    });
    out.ghosts = ghosts_;
    if (grab_->kind == HandleKind::kVelocity)
      out.direction = direction_arc(dragged_.bodies[0], sight.camera, sight.arrow_seconds);
    out.bubble = {dragged_.value, dragged_.detail, mouse_, press_, dragged_.fault};
    out.guides = dragged_.guides;
    out.overlaps = dragged_.overlaps;
    out.blocked = dragged_.blocked;
    out.refused = dragged_.refused;
  } else if (state_ == State::kEnd) {
    show_moved_end(out);
  } else if (state_ == State::kBand) {
    out.band = QRectF(press_, mouse_).normalized();
  } else {
    if (!typing_) out.bubble = note_;
    show_part(out);
    show_drawing(out);
  }
  return out;
}

}  // namespace carom
