#pragma once

#include <optional>
#include <span>
#include <string>

#include "physics/scene/scene.h"
#include "widgets/scene/camera.h"

namespace carom {

// A centre or corner of another body that a place shares a coordinate with.
struct Level {
  Vec2 at = Vec2::Zero();  // m
  std::string of;          // the body
  bool corner = false;
};

// The one whose coordinate, 0 for x and 1 for y, is nearest to that of `place` and within `reach` m; of
// several, that of the nearest body. Corners are those of boxes, thin walls and sharp polygons. Only what is in
// view counts, all if `seen` is empty; in a crowd nothing does, as something would always be level.
[[nodiscard]] std::optional<Level> level_with(const Vec2& place, Eigen::Index axis,
                                              std::span<const Body> others, const WorldRect& seen,
                                              double reach);

// "level with heavy", "over a corner of ramp": what a place that shares this coordinate is.
[[nodiscard]] std::string level_text(const Vec2& place, Eigen::Index axis, const Level& level);

}  // namespace carom
