#include "widgets/scene/level.h"

#include <algorithm>
#include <cmath>
#include <variant>
#include <vector>

namespace carom {
namespace {

constexpr int kCrowd = 40;       // bodies
constexpr double kAlike = 1e-6;  // of the reach: coordinates that differ by less are one

bool has_corners(const Shape& shape) {
  const auto* polygon = std::get_if<Polygon>(&shape);
  return std::holds_alternative<Box>(shape) || std::holds_alternative<Wall>(shape) ||
         (polygon != nullptr && polygon->rounding == 0.0);
}

// Of bodies in view: their centres, then their corners.
std::vector<Level> levels_of(std::span<const Body> others, const WorldRect& seen) {
  std::vector<Level> levels;
  int bodies = 0;
  for (const Body& body : others) {
    if (is_half_plane(body.shape)) continue;
    if (!seen.empty() && !seen.meets(body.position, bounding_radius(body.shape))) continue;
    if (++bodies > kCrowd) return {};
    levels.push_back({body.position, body.name, false});
    if (!has_corners(body.shape)) continue;
    for (const Vec2& corner : outline_of(body.shape).vertices)
      levels.push_back({body.position + turned_by(body.angle, corner), body.name, true});
  }
  std::stable_partition(levels.begin(), levels.end(), [](const Level& level) { return !level.corner; });
  return levels;
}

}  // namespace

std::optional<Level> level_with(const Vec2& place, Eigen::Index axis, std::span<const Body> others,
                                const WorldRect& seen, double reach) {
  std::optional<Level> best;
  double off = reach;
  for (const Level& level : levels_of(others, seen)) {
    const double distance = std::abs(level.at[axis] - place[axis]);
    if (distance > off + kAlike * reach) continue;
    const bool alike = best && distance >= off - kAlike * reach;
    if (alike && (level.at - place).norm() >= (best->at - place).norm()) continue;
    best = level;
    off = distance;
  }
  return off <= reach ? best : std::nullopt;
}

std::string level_text(const Vec2& place, Eigen::Index axis, const Level& level) {
  const std::string of = level.corner ? "a corner of " + level.of : level.of;
  if (axis == 1) return "level with " + of;
  return (place.y() >= level.at.y() ? "over " : "under ") + of;
}

}  // namespace carom
