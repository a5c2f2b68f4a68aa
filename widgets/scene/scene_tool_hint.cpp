#include <array>
#include <variant>

#include "widgets/scene/scene_tools.h"

// What the mouse can do where it is, in a few words.
namespace carom {
namespace {

struct HandleHint {
  HandleKind kind;
  const char* text;
};
constexpr std::array<HandleHint, 14> kHandleHints = {{
    {HandleKind::kBody, "drag: move · Shift: one axis · right click: menu"},
    {HandleKind::kTurn, "drag: turn in 5° · Shift: 45° · double click: type it"},
    {HandleKind::kVelocity, "drag: velocity · Shift: keep its direction · double click: type it"},
    {HandleKind::kSpin, "drag: spin · Shift: whole turns a second · double click: type it"},
    {HandleKind::kRadius, "drag: radius · double click: type it"},
    {HandleKind::kRight, "drag: width · Shift: keep the proportions · double click: type it"},
    {HandleKind::kTop, "drag: height · Shift: keep the proportions · double click: type it"},
    {HandleKind::kLeft, "drag: width · Shift: keep the proportions · double click: type it"},
    {HandleKind::kBottom, "drag: height · Shift: keep the proportions · double click: type it"},
    {HandleKind::kTopRight, "drag: size · Shift: keep the proportions · double click: type it"},
    {HandleKind::kTopLeft, "drag: size · Shift: keep the proportions · double click: type it"},
    {HandleKind::kBottomLeft, "drag: size · Shift: keep the proportions · double click: type it"},
    {HandleKind::kBottomRight, "drag: size · Shift: keep the proportions · double click: type it"},
    {HandleKind::kCorner, "drag: corner · Shift: one axis · double click: type it"},
}};

}  // namespace

QString SceneTools::hint(const QPointF& at) const {
  QString text = hint_of_mouse(at);
  if (!snapping_ && !plays() && !text.isEmpty()) text.prepend(tr("no snapping (Q) · "));
  return text;
}

QString SceneTools::hint_of_mouse(const QPointF& at) const {
  const SceneSight sight = sight_();
  if (!over_ || !sight.frame) return {};
  const QString snapping = snapping_ ? tr("Ctrl: no snapping · ") : QString();
  if (state_ == State::kDrag) return snapping + tr("digits: type the value · Esc: back");
  if (state_ == State::kHand) return tr("let go: throw it");
  const bool force = part_ && std::holds_alternative<Id<AppliedForce>>(*part_);
  if (state_ == State::kEnd && force && end_ == kFoot)
    return tr("to where it acts · ") + snapping + tr("digits: type the place · Esc: back");
  if (state_ == State::kEnd)
    return force ? tr("Shift: one axis · ") + snapping + tr("digits: type the force · Esc: back")
                 : tr("to a body or a place · ") + snapping + tr("digits: type the length · Esc: back");
  if (state_ == State::kBand) return tr("Shift: add · Ctrl: take away · Esc: back");
  if (state_ == State::kDraw) return {};  // the tool's own words hold
  // With a tool in hand a body is taken hold of as ever, where the tool leaves it alone.
  const std::optional<Grab> grab = grab_at(at);
  if (tool_ != SceneTool::kSelect && !grab) return {};
  const std::optional<std::size_t> end = end_under(at);
  if (end && force && *end == kFoot && sight.frame->scene)
    return tr("drag: where the force acts · double click: type the force");
  if (end && sight.frame->scene)
    return force ? tr("drag: size and direction · Shift: one axis · double click: type it")
                 : tr("drag: to another body or place · double click: type the length");
  if (mark_under(at)) return tr("click: go to this impact");
  if (!grab && part_under(at)) return tr("click: select · right click: menu");
  if (!grab) return tr("drag: select bodies · right drag: pan · wheel: zoom");
  if (!sight.frame->scene) {
    const Body& body = (*sight.frame->bodies)[static_cast<std::size_t>(index_.at(grab->body))];
    if (has_infinite_mass(body) || !plays()) return tr("click: select · pause to move it");
    return tr("click: select · drag: pull it by the hand");
  }
  const Body& grabbed = (*sight.frame->bodies)[static_cast<std::size_t>(index_.at(grab->body))];
  if (std::holds_alternative<Wall>(grabbed.shape) && !side_of(grab->kind).isZero(0.0))
    return tr("drag: length · double click: type it");
  for (const HandleHint& each : kHandleHints) {
    if (each.kind == grab->kind) return tr(each.text);
  }
  return {};
}

}  // namespace carom
