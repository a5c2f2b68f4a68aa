#pragma once

#include <QPointF>
#include <QRectF>

#include "physics/scene/scene.h"
#include "widgets/scene/camera.h"

class QPainter;

namespace carom {

struct Theme;

// The angle of an arrow that is being pulled, from the horizontal.
struct DirectionArc {
  QPointF foot;          // px
  double length = 0.0;   // px, of the arrow
  double degrees = 0.0;  // counter-clockwise, from -180 to 180; 0: nothing is drawn
};

// Of a body's velocity, at `seconds` m of arrow per m/s.
[[nodiscard]] DirectionArc direction_arc(const Body& body, const Camera& camera, double seconds);
// px: about the number beside the arc; empty if there is none.
[[nodiscard]] QRectF text_place(const DirectionArc& arc);
void paint_direction(QPainter& painter, const DirectionArc& arc, const Theme& theme);

}  // namespace carom
