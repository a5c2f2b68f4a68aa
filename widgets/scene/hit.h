#pragma once

#include <QPointF>
#include <QRectF>
#include <vector>

#include "physics/record/frame.h"
#include "widgets/scene/camera.h"

namespace carom {

// How many bodies of the frame have a state.
[[nodiscard]] int body_count(const Frame& frame);
// Body `index` where it is now, and as it moves now.
[[nodiscard]] Body body_now(const Frame& frame, int index);

// The bodies at a point of the screen, the topmost first.
[[nodiscard]] std::vector<int> bodies_at(const Frame& frame, const Camera& camera, const QPointF& at);
// The topmost one; -1 if there is none.
[[nodiscard]] int body_at(const Frame& frame, const Camera& camera, const QPointF& at);
// All bodies that a rectangle of the screen touches. A half-plane, which fills the ground, only if it holds its
// point.
[[nodiscard]] std::vector<int> bodies_in(const Frame& frame, const Camera& camera, const QRectF& rect);

}  // namespace carom
