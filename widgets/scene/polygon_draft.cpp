#include "widgets/scene/polygon_draft.h"

#include <utility>

#include "physics/scene/polygon.h"

namespace carom {

QString PolygonDraft::fault_at(const Vec2& corner) const {
  if (static_cast<int>(corners_.size()) >= kMostPolygonPoints)
    return QStringLiteral("at most %1 corners").arg(kMostPolygonPoints);
  return crosses(corners_, corner) ? QStringLiteral("edges cross") : QString();
}

QString PolygonDraft::fault_of_closing() const {
  return crosses(std::span(corners_).subspan(1), corners_.front()) ? QStringLiteral("edges cross") : QString();
}

void PolygonDraft::set(const Vec2& corner) {
  if (static_cast<int>(corners_.size()) >= kMostPolygonPoints) return;
  if (!corners_.empty() && corner == corners_.back()) return;
  refused_.reset();
  if (fault_at(corner).isEmpty()) {
    corners_.push_back(corner);
  } else {
    refused_ = corner;
  }
}

void PolygonDraft::take_back() {
  if (!std::exchange(refused_, std::nullopt) && !corners_.empty()) corners_.pop_back();
}

void PolygonDraft::clear() {
  corners_.clear();
  refused_.reset();
}

std::optional<Drawn> PolygonDraft::closed() const {
  std::vector<Vec2> vertices = tidied(corners_);
  if (refused_ || fault_of(vertices, 0.0)) {
    vertices = corners_;
    if (refused_) vertices.push_back(*refused_);
    if (vertices.size() < 3) return std::nullopt;
    vertices = tidied(convex_hull(std::move(vertices)));
  }
  if (fault_of(vertices, 0.0)) return std::nullopt;
  const Vec2 centre = moments_of(vertices, 0.0).centroid;
  for (Vec2& vertex : vertices) vertex -= centre;
  return Drawn{Polygon{vertices}, centre, 0.0, {}};
}

QString PolygonDraft::fault_of_closed() const {
  if (tidied(corners_).size() < 3) return QStringLiteral("a polygon needs three corners");
  return QStringLiteral("at most %1 corners without a dent").arg(kMostVertices);
}

}  // namespace carom
