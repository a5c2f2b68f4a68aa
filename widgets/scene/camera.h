#pragma once

#include <QMarginsF>
#include <QPointF>
#include <QSizeF>

#include "physics/preset/preset.h"
#include "physics/scene/scene.h"

namespace carom {

// An upright rectangle of the world, in m; empty until something was added.
struct WorldRect {
  Vec2 lower = Vec2::Constant(1.0);
  Vec2 upper = Vec2::Constant(-1.0);

  [[nodiscard]] bool empty() const { return (upper.array() < lower.array()).any(); }
  // Extends the rectangle by the disc of `radius` about `point`.
  void include(const Vec2& point, const Vec2& half_extent);
  [[nodiscard]] bool meets(const Vec2& point, double radius) const;
};

// Maps the world to a viewport: the world's point at its centre, and a scale. Screen points are in logical
// pixels from the upper left, y down.
struct Camera {
  // px/m; limits from a planetary system in a thumbnail to a hair's breadth on the whole screen.
  static constexpr double kLeastScale = 1e-9;
  static constexpr double kLargestScale = 1e9;

  Vec2 center = Vec2::Zero();   // m
  double scale = 100.0;         // px/m
  QSizeF viewport{640.0, 400};  // px

  [[nodiscard]] QPointF to_screen(const Vec2& point) const;
  [[nodiscard]] Vec2 to_world(const QPointF& point) const;
  [[nodiscard]] WorldRect visible() const;

  // Multiplies the scale and keeps the world's point under `at` fixed.
  void zoom_at(const QPointF& at, double factor);
  // Moves the world by `delta` px on the screen.
  void pan(const QPointF& delta);
  void show(const View& view);
  // Fits `rect` within the margins (px).
  void fit(const WorldRect& rect, const QMarginsF& margins);
};

}  // namespace carom
