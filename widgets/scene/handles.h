#pragma once

#include <QPointF>
#include <QPolygonF>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "physics/scene/scene.h"
#include "widgets/scene/camera.h"

namespace carom {

// What a drag takes hold of: a body itself, or one of the handles around it.
enum class HandleKind {
  kBody,
  kTurn,
  kVelocity,
  kSpin,
  kRadius,
  kRight,
  kTop,
  kLeft,
  kBottom,
  kTopRight,
  kTopLeft,
  kBottomLeft,
  kBottomRight,
  kCorner  // of a polygon
};

struct Handle {
  HandleKind kind = HandleKind::kBody;
  std::size_t body = 0;         // among those that have handles
  QPointF at;                   // px
  std::optional<QPointF> foot;  // px: the other end of the line that ties it to its body
  // Of a spin: degrees counter-clockwise from the right.
  struct Arc {
    double tail = 0.0;   // where it begins
    double sweep = 0.0;  // from there to the grip
    QPolygonF way{};     // px, along the outline
  };
  std::optional<Arc> arc{};
  std::size_t corner = 0;  // of a polygon, among its vertices
};

// How far handles stand from a body's centre at least, and how near the mouse must be, in px.
inline constexpr double kLeastHandleDistance = 24.0;
inline constexpr double kHandleReach = 10.0;

// Degrees of the arc that shows a spin of 1 rad/s, and of the longest one.
inline constexpr double kArcOfSpin = 15.0;
inline constexpr double kLongestArc = 330.0;

// The handles around these bodies, which stand and move as stated: of each that moves freely the tip of its
// velocity if `arrow_seconds` (m of arrow per m/s) is given; of a single one also the grip
// of its spin, a knob to turn it, and those of its size. The knob stands above the body, or below; while the
// body is turned it goes along, by the angle (rad) of this turn.
[[nodiscard]] std::vector<Handle> handles_of(std::span<const Body> bodies, const Camera& camera,
                                             std::optional<double> arrow_seconds, double turned = 0.0);
// The nearest one that the mouse reaches.
[[nodiscard]] std::optional<Handle> handle_at(std::span<const Handle> handles, const QPointF& at);

// The direction of a box's side or corner, or of a thin wall's end, from its centre, in its own axes, as 1, -1
// or 0 along each; zero for other kinds.
[[nodiscard]] Vec2 side_of(HandleKind kind);

}  // namespace carom
