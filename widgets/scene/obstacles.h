#pragma once

#include <QLineF>
#include <QPainterPath>
#include <QRectF>
#include <span>
#include <vector>

#include "widgets/scene/handles.h"

namespace carom {

// What texts and bubbles over the scene should not lie on, in px.
struct Obstacles {
  struct Disc {
    QPointF centre;
    double radius = 0.0;
  };
  std::vector<QLineF> lines;
  std::vector<Disc> discs;
  std::vector<QRectF> rects;
  std::vector<QPainterPath> areas;
  std::vector<QRectF> texts;  // each counts as several of the others: it can't be read around something

  // How many of them lie under the rectangle.
  [[nodiscard]] int covered_by(const QRectF& rect) const;
};

// The handles, with the lines that tie them to their bodies.
void add_handles(std::span<const Handle> handles, Obstacles& obstacles);

// The rectangle, or the nearest place for it that covers nothing and lies within the view, first towards
// `first` (a unit vector, or zero); where there is none near by, the first of those that cover least.
[[nodiscard]] QRectF clear_place(const QRectF& rect, const Obstacles& obstacles, const QRectF& view,
                                 const QPointF& first);

}  // namespace carom
