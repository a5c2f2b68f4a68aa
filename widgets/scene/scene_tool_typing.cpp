#include <algorithm>
#include <array>
#include <utility>

#include "widgets/base/method_names.h"
#include "widgets/edit/quantity.h"
#include "widgets/edit/units.h"
#include "widgets/scene/drag_limits.h"
#include "widgets/scene/hit.h"
#include "widgets/scene/scene_tools.h"
#include "widgets/scene/typed_drawing.h"
#include "widgets/scene/typed_value.h"

// Values that are typed at the mouse, instead of a drag or during one.
namespace carom {
namespace {

QString first_unit(std::string_view si) { return text_of(units_of(si).front().name); }

// Tools whose joint, spring or force has a length or a size.
constexpr auto kLinksWithValue =
    std::to_array({SceneTool::kRod, SceneTool::kString, SceneTool::kSpring, SceneTool::kForce});

struct HandlePlace {
  HandleKind kind;
  const char* words;
};
constexpr auto kHandlePlaces = std::to_array<HandlePlace>({
    {HandleKind::kRight, "right"},
    {HandleKind::kTop, "top"},
    {HandleKind::kLeft, "left"},
    {HandleKind::kBottom, "bottom"},
    {HandleKind::kTopRight, "top right"},
    {HandleKind::kTopLeft, "top left"},
    {HandleKind::kBottomLeft, "bottom left"},
    {HandleKind::kBottomRight, "bottom right"},
});

// Which one of several it is, as the body would be seen unturned.
QString place_text(const Handle& handle) {
  if (handle.kind == HandleKind::kCorner) return QStringLiteral(", corner %1").arg(handle.corner + 1);
  const auto found = std::find_if(kHandlePlaces.begin(), kHandlePlaces.end(),
                                  [&](const HandlePlace& each) { return each.kind == handle.kind; });
  return found == kHandlePlaces.end() ? QString() : QStringLiteral(", at its %1").arg(found->words);
}

bool has_values(const TypedThing* thing) { return thing != nullptr && !thing->values().empty(); }

}  // namespace

bool SceneTools::types_in_drag(int key, Qt::KeyboardModifiers keys) const {
  const ShapeTool* tool = shape_tool(tool_);
  const bool draws =
      state_ == State::kDraw && ((tool != nullptr && !tool->by_corners) || draws_link_with_value());
  const bool follows = !typed_ahead_.isEmpty();
  if (state_ != State::kDrag && state_ != State::kEnd && !draws && !follows) return false;
  if (keys.testFlag(Qt::ControlModifier) || keys.testFlag(Qt::AltModifier)) return false;
  const bool digit = key >= Qt::Key_0 && key <= Qt::Key_9;
  return digit || key == Qt::Key_Minus || key == Qt::Key_Period || key == Qt::Key_Comma;
}

bool SceneTools::draws_link_with_value() const {
  const std::shared_ptr<const Frame> frame = sight_().frame;
  return frame && frame->scene &&
         std::find(kLinksWithValue.begin(), kLinksWithValue.end(), tool_) != kLinksWithValue.end();
}

// Into the value that stands beside the mouse after a drag, and not after keys, which may go on. The other keys
// of a drag are steps of time here.
bool SceneTools::types_noted(int key, Qt::KeyboardModifiers keys) const {
  const bool begins = (key >= Qt::Key_0 && key <= Qt::Key_9) || key == Qt::Key_Minus;
  return begins && keys == Qt::NoModifier && state_ == State::kNone && can_type_noted() && row_.drag != drags_;
}

std::optional<SceneTools::Typed> SceneTools::typed() const {
  if (!typing_) return std::nullopt;
  const TypedValue value = typing_->thing->values()[typing_->index];
  return Typed{value.name, typing_->thing->subject(), first_unit(value.range.unit),
               field_text(value.value, value.range.unit), typing_->bubble};
}

void SceneTools::begin_typing(Typing typing, const QString& first) {
  if (!has_values(typing.thing.get())) return;
  end_note();
  row_ = {};
  typing_ = std::make_shared<Typing>(std::move(typing));
  emit typingBegan(first);
  emit changed();
}

// What the mouse holds stays where it is, until the button is let go.
void SceneTools::type_in_drag(const QString& first) {
  if (!typed_ahead_.isEmpty()) return void(typed_ahead_ += first);
  if (state_ == State::kDraw) return draws_link_with_value() ? type_in_link(first) : type_in_drawing(first);
  const bool end = state_ == State::kEnd;
  Typing typing;
  typing.bubble = {{}, end ? moved_end_.detail : dragged_.detail, mouse_, press_, false};
  typing.drag = drags_;
  typing.changed = emitted_;
  typing.in_drag = true;
  if (end) {
    typing.target = {HandleKind::kBody, {}};
    typing.thing = typed_end(end_drag_, joint_sight(mouse_).mouse);
    if (emitted_) typing.last = Typing::Last{moved_end_.edits, moved_end_.name};
  } else {
    typing.target = *grab_;
    typing.thing = typed_body(start_, dragged_.bodies[0], sight_().camera.scale);
    if (emitted_) typing.last = Typing::Last{edits_as_seen(dragged_, refitted_), dragged_.name};
  }
  // An end that lies on the other one has no length to type: its drag goes on.
  if (!has_values(typing.thing.get())) return;
  state_ = State::kMute;
  begin_typing(std::move(typing), first);
}

// What is drawn is made as it is now, and its length or force is typed.
void SceneTools::type_in_link(const QString& first) {
  end_link();
  state_ = State::kMute;
  if (!note_of_) return;
  if (awaited_part_) {
    typed_ahead_ = first;
  } else {
    type_value_of(*note_of_, note_, first);
  }
}

void SceneTools::type_in_drawing(const QString& first) {
  state_ = State::kMute;
  const ShapeTool& tool = *shape_tool(tool_);
  const Stroke drawn = stroke();
  Typing typing;
  typing.bubble = {{}, {}, mouse_, press_, false};
  typing.drawing = std::make_shared<TypedDrawing>(QString::fromUtf8(tool.noun), tool.drag(drawn), drawn.from);
  typing.thing = typing.drawing;
  begin_typing(std::move(typing), first);
}

// At rest; `where` says where the bubble stands.
void SceneTools::type_value_of(const Grab& target, const Bubble& where, const QString& first) {
  const SceneSight sight = sight_();
  if (!sight.frame || !sight.frame->scene) return;
  Typing typing;
  typing.target = target;
  typing.bubble = {{}, {}, where.mouse, where.from, false};
  if (target.body.empty()) {
    const std::optional<PartId>& part = part_ ? part_ : made_part_;
    if (!part || !has_part(*sight.frame->scene, *part)) return;
    typing.thing = typed_part(*sight.frame->scene, *part);
  } else {
    if (!selection_.contains(target.body)) set_selection({target.body});
    if (locked_.contains(target.body)) return say_locked(target.body);
    DragStart start = start_of(target, editable(target.body, target.kind));
    if (start.bodies.empty() || start.bodies.front().name != target.body) return;
    if (const auto locked = locked_among(start.followers)) return say_locked(*locked);
    const Body now = start.bodies.front();
    typing.thing = typed_body(std::move(start), now, sight.camera.scale);
  }
  typing.drag = ++drags_;
  begin_typing(std::move(typing), first);
}

std::vector<SceneTools::ToldHandle> SceneTools::told_handles() const {
  const SceneSight sight = sight_();
  std::vector<ToldHandle> told;
  for (const Handle& handle : handles(sight)) {
    const Grab grab{handle.kind, selection_.names()[handle.body], handle.corner};
    const std::vector<Body> bodies = editable(grab.body, grab.kind);
    if (bodies.empty()) return {};
    const auto thing = typed_body(start_of(grab, bodies), bodies.front(), sight.camera.scale);
    QStringList names;
    QStringList values;
    for (const TypedValue& value : thing->values()) {
      names << (names.isEmpty() ? value.name : value.name.toLower());
      values << quantity_text(value.value, value.range.unit);
    }
    told.push_back(
        {handle.at, names.join(" and ") + " of " + thing->subject() + place_text(handle), values.join(", ")});
  }
  return told;
}

std::optional<std::size_t> SceneTools::handle_under(const QPointF& at) const {
  const std::vector<Handle> all = handles(sight_());
  const std::optional<Handle> taken = handle_at(all, at);
  if (!taken) return std::nullopt;
  const auto same = std::find_if(all.begin(), all.end(), [&](const Handle& each) {
    return each.kind == taken->kind && each.body == taken->body && each.corner == taken->corner;
  });
  return static_cast<std::size_t>(same - all.begin());
}

void SceneTools::type_handle(std::size_t index) {
  if (state_ != State::kNone) return;
  end_typing();
  const std::vector<Handle> all = handles(sight_());
  if (index >= all.size()) return;
  const Handle& handle = all[index];
  const Bubble where{{}, {}, handle.at, handle.at, false};
  type_value_of({handle.kind, selection_.names()[handle.body], handle.corner}, where);
}

// What a double click means where a drag could begin.
bool SceneTools::type_at(const QPointF& at) {
  if (tool_ != SceneTool::kSelect && !grab_) return false;
  const Bubble where{{}, {}, at, at, false};
  if (end_ || (part_ && part_under(at) == part_)) {
    type_value_of({HandleKind::kBody, {}}, where);
  } else if (grab_) {
    type_value_of(*grab_, where);
  }
  return typing_ != nullptr;
}

bool SceneTools::type_noted(const QString& first) {
  if (!note_of_ || !(note_of_->body.empty() || index_.contains(note_of_->body))) return false;
  const Grab target = *note_of_;
  type_value_of(target, note_, first);
  return typing_ != nullptr;
}

QString SceneTools::take_typed(const QString& text, bool yields) {
  const std::shared_ptr<Typing> typing = typing_;
  if (typing == nullptr) return {};
  const TypedValue value = typing->thing->values()[typing->index];
  const TypedValues typed =
      typed_values(text, value.name, value.range, {value.value}, {typing->thing->formula_names()});
  if (!typed.fault.isEmpty()) return typed.fault;
  const TypedEdit edit = typing->thing->set(typing->index, typed.values[0], yields);
  if (!edit.fault.isEmpty()) return edit.fault;
  if (typing->drawing != nullptr) {
    typing->tried.reset();
    emit changed();
    return {};
  }
  QString refusal = own_edit(edit.edits, edit.name, typing->drag);
  if (!refusal.isEmpty()) return refusal;
  typing->changed = typing->taken = true;
  typing->previewed = false;
  typing->last = Typing::Last{edit.edits, edit.name};
  typing->bubble.value = edit.value;
  typing->bubble.detail = edit.detail;
  return {};
}

void SceneTools::preview_typed(const QString& text) {
  const std::shared_ptr<Typing> typing = typing_;
  if (typing == nullptr) return;
  typing->bubble.detail.clear();
  const TypedValue value = typing->thing->values()[typing->index];
  const TypedValues typed =
      typed_values(text, value.name, value.range, {value.value}, {typing->thing->formula_names()});
  if (!typed.fault.isEmpty()) return;
  typing->bubble.detail = value_of_typed(text, value.range, {value.value}, {typing->thing->formula_names()});
  const std::shared_ptr<TypedThing> tried = typing->thing->clone();
  const TypedEdit edit = tried->set(typing->index, typed.values[0], false);
  if (!edit.fault.isEmpty()) return;
  if (typing->drawing != nullptr) {
    typing->tried = std::static_pointer_cast<TypedDrawing>(tried);
  } else if (own_edit(edit.edits, edit.name, typing->drag).isEmpty()) {
    typing->changed = typing->previewed = true;
    if (!typing->bubble.detail.isEmpty() && !edit.detail.isEmpty()) typing->bubble.detail += " · ";
    typing->bubble.detail += edit.detail;
  }
  emit changed();
}

void SceneTools::take_preview_back(Typing& typing) {
  if (!std::exchange(typing.previewed, false)) return;
  if (typing.last) {
    const bool end = typing.in_drag && typing.target.body.empty();
    const SceneEdits& last = typing.last->edits;
    own_edit(end ? end_drag_->with_others_back(last) : last, typing.last->name, typing.drag);
  } else {
    emit dragCancelled(typing.drag);
  }
}

void SceneTools::type_next(bool forward) {
  if (typing_ == nullptr) return;
  const std::size_t count = typing_->thing->values().size();
  typing_->index = (typing_->index + (forward ? 1 : count - 1)) % count;
  emit typingBegan({});
}

void SceneTools::drop_typing() {
  if (std::exchange(typing_, nullptr) != nullptr) emit typingEnded();
}

void SceneTools::end_typing() {
  const std::shared_ptr<Typing> typing = std::exchange(typing_, nullptr);
  if (typing == nullptr) return;
  emit typingEnded();
  take_preview_back(*typing);
  if (typing->drawing != nullptr) {
    add(typing->drawing->drawn());
  } else if (typing->taken) {
    note(typing->bubble, typing->target);
  } else if (typing->in_drag) {
    typing->target.body.empty() ? let_end_go() : end_drag();
  }
  emit changed();
}

void SceneTools::cancel_typing() {
  const std::shared_ptr<Typing> typing = std::exchange(typing_, nullptr);
  if (typing == nullptr) return;
  emit typingEnded();
  if (typing->changed) emit dragCancelled(typing->drag);
  emit changed();
}

}  // namespace carom
