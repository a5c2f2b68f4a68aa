#include "widgets/scene/polygon_draft.h"

#include <algorithm>
#include <utility>

namespace carom {
namespace {

// Counter-clockwise, by Andrew's monotone chain.
std::vector<Vec2> convex_hull(std::vector<Vec2> points) {
  std::sort(points.begin(), points.end(),
            [](const Vec2& a, const Vec2& b) { return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y(); });
  std::vector<Vec2> hull;
  for (int pass = 0; pass < 2; ++pass) {
    const std::size_t first = hull.size();
    for (const Vec2& point : points) {
      while (hull.size() >= first + 2 && cross(hull.back() - hull[hull.size() - 2], point - hull.back()) <= 0.0)
        hull.pop_back();
      hull.push_back(point);
    }
    hull.pop_back();  // begins the other chain
    std::reverse(points.begin(), points.end());
  }
  return hull;
}

}  // namespace

QString PolygonDraft::fault_at(const Vec2& corner) const {
  if (static_cast<int>(corners_.size()) >= kMostVertices)
    return QStringLiteral("at most %1 corners").arg(kMostVertices);
  std::vector<Vec2> all = corners_;
  all.push_back(corner);
  // Two corners, and those on a line, are still to become a polygon.
  if (tidied(all).size() < 3 || !fault_of(all, 0.0)) return {};
  return QStringLiteral("bodies are convex");
}

void PolygonDraft::set(const Vec2& corner) {
  if (static_cast<int>(corners_.size()) >= kMostVertices) return;
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
  std::vector<Vec2> all = corners_;
  if (refused_) all.push_back(*refused_);
  if (all.size() < 3) return std::nullopt;
  std::vector<Vec2> vertices = tidied(convex_hull(std::move(all)));
  if (fault_of(vertices, 0.0)) return std::nullopt;
  const Vec2 centre = moments_of(vertices, 0.0).centroid;
  for (Vec2& vertex : vertices) vertex -= centre;
  return Drawn{Polygon{vertices}, centre, 0.0, {}};
}

}  // namespace carom
