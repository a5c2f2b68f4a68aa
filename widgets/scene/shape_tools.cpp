#include "widgets/scene/shape_tools.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "widgets/scene/edit_names.h"
#include "widgets/scene/snap.h"

namespace carom {
namespace {

constexpr double kUsualSize = 0.2;   // m, of what a click draws
constexpr double kLeastSeen = 24.0;  // px, of its size
constexpr int kCornersOfKey = 6;

bool shift(const Stroke& stroke) { return stroke.to.keys.testFlag(Qt::ShiftModifier); }

// With one figure, rounded up or down.
double round_size(double size, bool up) {
  const double decade = std::pow(10.0, std::floor(std::log10(size)));
  const double count = size / decade;
  return snapped((up ? std::ceil(count) : std::floor(count)) * decade, decade);
}

// m: the usual size, or the nearest round one that can be seen and fits into the view.
double usual_size(const Stroke& stroke) {
  const double least = kLeastSeen / stroke.to.scale;
  if (kUsualSize < least) return round_size(least, true);
  return kUsualSize > stroke.side ? round_size(0.5 * stroke.side, false) : kUsualSize;
}

Vec2 start_of(const Stroke& stroke) { return drawn_place(stroke.from, stroke.to, stroke.grid); }

// About the place of the press.
Drawn disc_by_radius(const Stroke& stroke) {
  const double radius = drawn_length((stroke.to.at - stroke.from).norm(), stroke.to);
  return {Disc{radius}, start_of(stroke), 0.0, "r " + drawn_text(radius, stroke.to)};
}

Drawn box(const Stroke& stroke, const Vec2& size, const Vec2& centre) {
  return {Box{size.x(), size.y()}, centre, 0.0,
          drawn_text(size.x(), stroke.to) + " × " + drawn_text(size.y(), stroke.to)};
}

Drawn usual_box(const Stroke& stroke) {
  return box(stroke, Vec2::Constant(usual_size(stroke)), start_of(stroke));
}

// A corner of a box with level sides: on the level and upright edges of bodies near by, so that its sides lie
// on them, else as all places.
Vec2 corner_at(const Vec2& at, const Stroke& stroke) {
  Vec2 place = drawn_place(at, stroke.to, stroke.grid);
  if (!snaps(stroke.to)) return place;
  return on_level_edges(at, place, stroke.bodies, kSnapReach / stroke.to.scale);
}

Drawn box_by_corners(const Stroke& stroke) {
  constexpr double kRounding = 1e-12;  // m, of the difference of two places
  const Vec2 from = corner_at(stroke.from, stroke);
  const Vec2 across = corner_at(stroke.to.at, stroke) - from;
  Vec2 size(snapped(std::abs(across.x()), kRounding), snapped(std::abs(across.y()), kRounding));
  size = size.cwiseMax(drawn_length(0.0, stroke.to));
  if (shift(stroke)) size.setConstant(size.maxCoeff());
  const Vec2 half(std::copysign(0.5 * size.x(), across.x()), std::copysign(0.5 * size.y(), across.y()));
  return box(stroke, size, from + half);
}

Drawn hexagon(const Stroke& stroke) {
  const double size = usual_size(stroke);
  Polygon polygon;
  for (int k = 0; k < kCornersOfKey; ++k) {
    const double angle = 2.0 * std::numbers::pi * k / kCornersOfKey;
    polygon.vertices.emplace_back(0.5 * size * std::cos(angle), 0.5 * size * std::sin(angle));
  }
  return {polygon, start_of(stroke), 0.0, drawn_text(size, stroke.to)};
}

Drawn half_plane(const Stroke& stroke) {
  const Vec2 at = start_of(stroke);
  return {Wall{}, at, 0.0, place_text(at, stroke.to.scale)};
}

// From the press to the mouse, never of no length.
Drawn thin_wall(const Stroke& stroke) {
  const Vec2 from = start_of(stroke);
  Vec2 along = drawn_place(stroke.to.at, stroke.to, stroke.grid) - from;
  if (along.isZero(0.0)) along = drawn_length(0.0, stroke.to) * Vec2::UnitX();
  if (shift(stroke)) {
    const double turned = snapped(direction(stroke.to.at - from), kDirectionStep);
    along = drawn_length(along.norm(), stroke.to) * unit_vector(turned);
  }
  return {Wall{along.norm()}, from + 0.5 * along, std::atan2(along.y(), along.x()),
          line_text(along, stroke.to)};
}

constexpr std::array<ShapeTool, 4> kShapeTools = {{
    {.tool = SceneTool::kDisc, .noun = "disc", .over_bodies = false, .drag = disc_by_radius},
    {.tool = SceneTool::kBox, .noun = "box", .click = usual_box, .drag = box_by_corners},
    {.tool = SceneTool::kPolygon, .noun = "polygon", .by_corners = true, .click = hexagon},
    {.tool = SceneTool::kWall, .noun = "wall", .click = half_plane, .drag = thin_wall},
}};

}  // namespace

const ShapeTool* shape_tool(SceneTool tool) {
  const auto* found = std::find_if(kShapeTools.begin(), kShapeTools.end(),
                                   [tool](const ShapeTool& row) { return row.tool == tool; });
  return found == kShapeTools.end() ? nullptr : found;
}

QString line_text(const Vec2& line, const DragPoint& point) {
  const double turned = direction(line);
  const bool whole = std::abs(turned - std::round(turned)) < 1e-9;
  return drawn_text(line.norm(), point) + " at " + fixed_text(turned, whole ? 0 : 1) + QChar(0x00b0);
}

}  // namespace carom
