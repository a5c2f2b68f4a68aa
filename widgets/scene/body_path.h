#pragma once

#include <QPainterPath>
#include <span>

#include "physics/scene/scene.h"
#include "widgets/scene/camera.h"

namespace carom {

// The outline of a body on the screen; of a half-plane the part of its surface that can be seen.
[[nodiscard]] QPainterPath body_path(const Body& body, const Camera& camera);

// Of a polygon grown by its rounding (m), the vertices in the world: an arc about each vertex, joined by the
// edges.
[[nodiscard]] QPainterPath polygon_path(std::span<const Vec2> vertices, double rounding, const Camera& camera);

}  // namespace carom
