#include <utility>

#include "widgets/scene/scene_view.h"
#include "widgets/scene/value_bubble.h"

// The bubble of a scene, and the value that is typed in it.
namespace carom {

bool SceneView::on_bubble(const QPointF& at) const {
  const Bubble& bubble = picture_.overlay.bubble;
  return tools_->can_type_noted() && !bubble.value.isEmpty() &&
         rect_of(bubble, font(), picture_.camera.viewport).contains(at);
}

void SceneView::show_typing(const QString& first) {
  const auto typed = tools_->typed();
  if (!typed) return;
  typing_->show_value({typed->name, typed->subject, typed->unit, typed->text, typed->bubble.detail});
  place_typing();
  typing_->begin(first);
}

void SceneView::place_typing() {
  const auto typed = tools_->typed();
  if (!typed) return;
  Bubble bubble = typed->bubble;
  bubble.clear_of = around_bubble();
  typing_->move(place_of(bubble, QSizeF(typing_->size()), picture_.camera.viewport).topLeft().toPoint());
}

// Chips and their like lie over the picture, and so over a bubble.
Obstacles SceneView::around_bubble() const {
  Obstacles around = obstacles_of(picture_.overlay, picture_.camera);
  for (const QWidget* child : findChildren<QWidget*>(Qt::FindDirectChildrenOnly)) {
    const bool lies_over = child != canvas_ && child != typing_ && child->isVisible() && !child->isWindow();
    if (lies_over) around.texts.emplace_back(child->geometry());
  }
  return around;
}

void SceneView::say(const QString& text) {
  if (accessibleDescription() != text) setAccessibleDescription(text);
}

void SceneView::say_bubble() {
  const Bubble& bubble = picture_.overlay.bubble;
  const QString text = bubble.detail.isEmpty() ? bubble.value : bubble.value + ", " + bubble.detail;
  if (std::exchange(said_bubble_, text) != text && !text.isEmpty()) say(text);
}

}  // namespace carom
