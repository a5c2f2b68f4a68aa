#include <QLineF>
#include <algorithm>
#include <span>
#include <utility>

#include "physics/scene/drive.h"
#include "widgets/scene/drag_limits.h"
#include "widgets/scene/grid.h"
#include "widgets/scene/new_body.h"
#include "widgets/scene/scene_tools.h"
#include "widgets/scene/typed_drawing.h"

// The scene's tools that draw new bodies.
namespace carom {

Stroke SceneTools::stroke() const {
  const SceneSight sight = sight_();
  const Camera& camera = sight.camera;
  std::vector<Body> bodies;
  if (sight.frame && sight.frame->scene) bodies = sight.frame->scene->bodies;
  for (Body& body : bodies) body = moved_by_drive(std::move(body), sight.frame->time);
  return {.from = camera.to_world(press_),
          .to = point(keys_),
          .grid = sight.grid ? grid_spacing(camera) : 0.0,
          .side = std::min(camera.viewport.width(), camera.viewport.height()) / camera.scale,
          .bodies = std::move(bodies)};
}

Body SceneTools::body_of(const Drawn& drawn) const {
  const auto bodies = bodies_ ? std::span<const Body>(*bodies_) : std::span<const Body>();
  return new_body(bodies, drawn.shape, drawn.position, drawn.angle);
}

void SceneTools::add(const Drawn& drawn) {
  const Body body = body_of(drawn);
  const std::vector<Overlap> overlaps = overlaps_of_new(body);
  const QString noun = QString::fromUtf8(shape_tool(tool_)->noun);
  const QString refusal =
      own_edit({Add<Body>{body}}, "Add " + noun + " " + QString::fromStdString(body.name), ++drags_);
  if (!refusal.isEmpty()) return note(refusal_bubble(refusal, mouse_, press_));
  note({drawn.value, overlaps.empty() ? QString() : overlap_text(overlaps[0], point({})), mouse_, press_},
       Grab{HandleKind::kRadius, body.name});
  used_tool();
}

// The usual body, or one of random size.
void SceneTools::add_usual() {
  const ShapeTool& tool = *shape_tool(tool_);
  const Stroke at = stroke();
  if (tool.click != nullptr) return add(tool.click(at));
  const Vec2 place = drawn_place(at.from, at.to, at.grid);
  emit spawnRequested(place.x(), place.y());
  used_tool();
}

QPointF SceneTools::middle_of_view() const {
  const QSizeF view = sight_().camera.viewport;
  return {0.5 * view.width(), 0.5 * view.height()};
}

// px: where a click of the tool draws what overlaps no body, as near to the middle of the view as steps of the
// grid allow; the middle itself if there is no such place in sight.
QPointF SceneTools::free_place() {
  constexpr double kLargestOfRandom = 1.5;  // of the model's radius
  const ShapeTool& tool = *shape_tool(tool_);
  const Camera camera = sight_().camera;
  const QPointF middle = middle_of_view();
  const double step = grid_spacing(camera) * camera.scale;
  const int across = static_cast<int>(middle.x() / step);
  const int upwards = static_cast<int>(middle.y() / step);
  std::vector<QPoint> places;  // in steps from the middle
  for (int i = across; i >= -across; --i) {
    for (int k = -upwards; k <= upwards; ++k) places.emplace_back(i, k);
  }
  std::stable_sort(places.begin(), places.end(), [](const QPoint& a, const QPoint& b) {
    return QPoint::dotProduct(a, a) < QPoint::dotProduct(b, b);
  });
  const Body* model = bodies_ ? model_disc(*bodies_) : nullptr;
  const double radius = model != nullptr ? kLargestOfRandom * std::get<Disc>(model->shape).radius : 0.0;
  const auto is_free = [&](const QPoint& place) {
    press_ = mouse_ = middle + step * QPointF(place);
    const Stroke at = stroke();
    const Drawn drawn = tool.click != nullptr
                            ? tool.click(at)
                            : Drawn{Disc{radius}, drawn_place(at.from, at.to, at.grid), 0.0, {}};
    return overlaps_of_new(body_of(drawn)).empty();
  };
  const auto found = std::find_if(places.begin(), places.end(), is_free);
  return found == places.end() ? middle : middle + step * QPointF(*found);
}

void SceneTools::draw_at(SceneTool tool, const QPointF& at) {
  set_tool(tool, false);
  press_ = mouse_ = at;
  keys_ = {};
  add_usual();
}

void SceneTools::draw() {
  if (joint_tool(tool_) != nullptr) return end_link();
  const ShapeTool* tool = shape_tool(tool_);
  if (tool == nullptr) return;  // laid down during the drag
  if (tool->by_corners) return set_corner();
  add(tool->drag(stroke()));
}

// --- corner by corner

bool SceneTools::closes_polygon() const {
  if (!draft_.can_close()) return false;
  return QLineF(sight_().camera.to_screen(draft_.corners().front()), mouse_).length() <= kHandleReach;
}

Vec2 SceneTools::next_corner() const {
  if (closes_polygon()) return draft_.corners().front();
  const Stroke now = stroke();
  return drawn_place(now.to.at, now.to, now.grid);
}

void SceneTools::set_corner() {
  if (closes_polygon()) return close_polygon();
  draft_.set(next_corner());
}

void SceneTools::close_polygon() {
  const std::optional<Drawn> drawn = draft_.closed();
  if (!drawn) return note({draft_.fault_of_closed(), {}, mouse_, press_, true});
  draft_.clear();
  add(*drawn);
}

void SceneTools::show_corners(Overlay& out) const {
  out.corners = {draft_.corners(), draft_.refused(), std::nullopt, false};
  if (!over_) return;
  const Vec2 next = next_corner();
  const QString fault = closes_polygon() ? draft_.fault_of_closing() : draft_.fault_at(next);
  out.corners.next = next;
  out.corners.fault = !fault.isEmpty();
  if (!out.bubble.value.isEmpty() || draft_.empty()) return;
  const Vec2& last = draft_.corners().back();
  out.bubble = {line_text(next - last, point(keys_)), {}, mouse_, sight_().camera.to_screen(last)};
  if (fault.isEmpty()) {
    PolygonDraft closed = draft_;
    if (!closes_polygon()) closed.set(next);
    const std::optional<Drawn> drawn = closed.closed();
    if (drawn) show_overlaps_of_new(body_of(*drawn), out);
    return;
  }
  out.bubble.value = fault;
  out.bubble.fault = true;
  if (draft_.refused() || closes_polygon()) out.bubble.detail = QStringLiteral("Enter draws around it too");
}

void SceneTools::show_drawing(Overlay& out) const {
  if (joint_tool(tool_) != nullptr) return show_joining(out);
  const ShapeTool* tool = shape_tool(tool_);
  if (tool == nullptr) return;
  const bool held = state_ == State::kPressed || state_ == State::kDraw;
  if (typing_ && typing_->drawing) {
    out.drawn = body_of((typing_->tried ? typing_->tried : typing_->drawing)->drawn());
    show_overlaps_of_new(*out.drawn, out);
  } else if (tool->by_corners) {
    if (held || !draft_.empty()) show_corners(out);
  } else if (state_ == State::kDraw) {
    const Drawn drawn = tool->drag(stroke());
    out.drawn = body_of(drawn);
    out.bubble = {drawn.value, {}, mouse_, press_};
    show_overlaps_of_new(*out.drawn, out);
  }
}

}  // namespace carom
