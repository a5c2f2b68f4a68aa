#include "widgets/scene/obstacles.h"

#include <QPointF>
#include <algorithm>
#include <array>

namespace carom {
namespace {

constexpr double kAround = 8.0;  // px, of a handle from its middle
constexpr double kStep = 8.0;    // px, from one place that is tried to the next
constexpr int kSteps = 25;
constexpr int kOfText = 8;  // how many others a text counts for

bool crosses(const QLineF& line, const QRectF& rect) {
  if (rect.contains(line.p1()) || rect.contains(line.p2())) return true;
  const std::array<QLineF, 2> diagonals = {QLineF(rect.topLeft(), rect.bottomRight()),
                                           QLineF(rect.topRight(), rect.bottomLeft())};
  return std::any_of(diagonals.begin(), diagonals.end(), [&](const QLineF& diagonal) {
    return line.intersects(diagonal, nullptr) == QLineF::BoundedIntersection;
  });
}

QRectF within(QRectF rect, const QRectF& view) {
  rect.moveLeft(std::max(view.left(), std::min(rect.left(), view.right() - rect.width())));
  rect.moveTop(std::max(view.top(), std::min(rect.top(), view.bottom() - rect.height())));
  return rect;
}

}  // namespace

int Obstacles::covered_by(const QRectF& rect) const {
  const auto lines_under =
      std::count_if(lines.begin(), lines.end(), [&](const QLineF& line) { return crosses(line, rect); });
  const auto discs_under = std::count_if(discs.begin(), discs.end(), [&](const Disc& disc) {
    const QPointF nearest(std::clamp(disc.centre.x(), rect.left(), rect.right()),
                          std::clamp(disc.centre.y(), rect.top(), rect.bottom()));
    return QLineF(disc.centre, nearest).length() < disc.radius;
  });
  const auto among = [&rect](const std::vector<QRectF>& all) {
    return std::count_if(all.begin(), all.end(), [&](const QRectF& each) { return each.intersects(rect); });
  };
  const auto areas_under = std::count_if(areas.begin(), areas.end(), [&](const QPainterPath& area) {
    return area.controlPointRect().intersects(rect) && area.intersects(rect);
  });
  return static_cast<int>(lines_under + discs_under + among(rects) + areas_under + kOfText * among(texts));
}

void add_handles(std::span<const Handle> handles, Obstacles& obstacles) {
  for (const Handle& handle : handles) {
    obstacles.rects.emplace_back(handle.at - QPointF(kAround, kAround), QSizeF(2 * kAround, 2 * kAround));
    if (handle.foot) obstacles.lines.emplace_back(*handle.foot, handle.at);
  }
}

QRectF clear_place(const QRectF& rect, const Obstacles& obstacles, const QRectF& view, const QPointF& first) {
  const std::array<QPointF, 9> sides = {first,
                                        QPointF(0, -1),
                                        QPointF(0, 1),
                                        QPointF(1, 0),
                                        QPointF(-1, 0),
                                        QPointF(0.7, -0.7),
                                        QPointF(-0.7, -0.7),
                                        QPointF(0.7, 0.7),
                                        QPointF(-0.7, 0.7)};
  QRectF best = within(rect, view);
  int least = obstacles.covered_by(best);
  for (int step = 1; step <= kSteps && least > 0; ++step) {
    for (const QPointF& side : sides) {
      const QRectF place = within(rect.translated(step * kStep * side), view);
      const int covered = obstacles.covered_by(place);
      if (covered >= least) continue;
      least = covered;
      best = place;
    }
  }
  return best;
}

}  // namespace carom
