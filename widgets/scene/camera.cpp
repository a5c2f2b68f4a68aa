#include "widgets/scene/camera.h"

#include <algorithm>

#include "physics/preset/preset.h"

namespace carom {

void WorldRect::include(const Vec2& point, const Vec2& half_extent) {
  const Vec2 low = point - half_extent;
  const Vec2 high = point + half_extent;
  lower = empty() ? low : Vec2(lower.cwiseMin(low));
  upper = empty() ? high : Vec2(upper.cwiseMax(high));
}

bool WorldRect::meets(const Vec2& point, double radius) const {
  return (point.array() + radius >= lower.array()).all() && (point.array() - radius <= upper.array()).all();
}

QPointF Camera::to_screen(const Vec2& point) const {
  return {viewport.width() / 2 + (point.x() - center.x()) * scale,
          viewport.height() / 2 - (point.y() - center.y()) * scale};
}

Vec2 Camera::to_world(const QPointF& point) const {
  return {center.x() + (point.x() - viewport.width() / 2) / scale,
          center.y() - (point.y() - viewport.height() / 2) / scale};
}

WorldRect Camera::visible() const {
  const Vec2 half = Vec2(viewport.width(), viewport.height()) / (2 * scale);
  return {center - half, center + half};
}

void Camera::zoom_at(const QPointF& at, double factor) {
  const Vec2 held = to_world(at);
  scale = std::clamp(scale * factor, kLeastScale, kLargestScale);
  center += held - to_world(at);
}

void Camera::pan(const QPointF& delta) { center -= Vec2(delta.x(), -delta.y()) / scale; }

void Camera::show(const View& view) {
  center = view.center;
  const double height = view.height.value_or(0.625 * view.width);
  scale = std::clamp(std::min(viewport.width() / view.width, viewport.height() / height), kLeastScale,
                     kLargestScale);
}

void Camera::fit(const WorldRect& rect, const QMarginsF& margins) {
  if (rect.empty()) return;
  const Vec2 size = rect.upper - rect.lower;
  const double width = std::max(1.0, viewport.width() - margins.left() - margins.right());
  const double height = std::max(1.0, viewport.height() - margins.top() - margins.bottom());
  scale = std::clamp(std::min(width / size.x(), height / size.y()), kLeastScale, kLargestScale);
  center = (rect.lower + rect.upper) / 2;
  pan(QPointF((margins.left() - margins.right()) / 2, (margins.top() - margins.bottom()) / 2));
}

}  // namespace carom
