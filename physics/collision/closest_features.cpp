#include "physics/collision/closest_features.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "physics/math/vectors.h"
#include "physics/model/pair_size.h"

namespace carom {
namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
constexpr double kRounding = 8.0 * kEpsilon;  // of a separation, relative to the frame's scale
// Cosine of the angle between the normals of two edges that are no corner but two faces.
constexpr double kFaces = 0.999;
// Tips that have gone into each other, by more than this of the size, and edges part them equally well
// within the second, of the scale.
constexpr double kDeep = 1e-7;
constexpr double kTied = 1e-11;

// An edge of the sum: it starts at b's vertex j minus a's vertex i and is an edge of b or of -a. Without
// initialisers here and in Sum: add_up() sets what is read, and a pair's search would spend its time on them.
// NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init)
struct SumEdge {
  Vec2 start;
  Vec2 normal;  // outward
  double length;
  int i;
  int j;
  bool of_b;

  // Position of the origin along the edge, from its start.
  [[nodiscard]] double along() const { return normal.y() * start.x() - normal.x() * start.y(); }
  [[nodiscard]] double separation() const { return -normal.dot(start); }
};

ClosestFeatures at_edge(const SumEdge& e) {
  return {e.separation(), -e.normal, e.of_b ? -1 : e.i, e.of_b ? e.j : -1, e.i, e.j};
}

// The edges of the Minkowski sum in order, and the one that the origin is farthest beyond.
// NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init)
struct Sum {
  std::array<SumEdge, 2 * kMostVertices> edge;
  int count;
  int farthest;
  double separation;
};

void add_up(const PairFrame& frame, double tie, Sum& sum) {
  // Start with b's first edge and the vertex of -a that is farthest out along its normal.
  int i = 0;
  int j = 0;
  if (frame.edges_b > 0) {
    double least = std::numeric_limits<double>::infinity();
    for (int k = 0; k < frame.edges_a; ++k) {
      const double reach = frame.normal[0].dot(frame.a[k].vertex);
      if (reach < least) least = reach, i = k;
    }
    // A segment has two corners there: take the one whose edge comes next.
    if (frame.edges_a > 0) {
      const int end = i == 0 ? frame.edges_a - 1 : i - 1;
      if (frame.a[end].length == 0.0) i = end;
      if (frame.a[i].length == 0.0 && cross(frame.normal[0], -frame.a[i].normal) < 0.0) {
        i = i + 1 == frame.edges_a ? 0 : i + 1;
      }
    }
  }
  int count = 0;
  int left_a = frame.edges_a;
  int left_b = frame.edges_b;
  double best_a = -std::numeric_limits<double>::infinity();
  double best_b = best_a;
  int nearest_a = -1;
  int nearest_b = -1;
  do {
    const bool of_b = left_b > 0 && (left_a == 0 || cross(frame.normal[j], -frame.a[i].normal) >= 0.0);
    SumEdge& e = sum.edge[count];
    e.start = frame.vertex[j] - frame.a[i].vertex;
    e.i = i;
    e.j = j;
    e.of_b = of_b;
    if (of_b) {
      e.normal = frame.normal[j];
      e.length = frame.b[j].length;
      if (e.separation() > best_b) best_b = e.separation(), nearest_b = count;
      --left_b;
      j = j + 1 == frame.edges_b ? 0 : j + 1;
    } else {
      e.normal = -frame.a[i].normal;
      e.length = frame.a[i].length;
      if (e.separation() > best_a) best_a = e.separation(), nearest_a = count;
      --left_a;
      i = i + 1 == frame.edges_a ? 0 : i + 1;
    }
    ++count;
  } while (left_a + left_b > 0);
  bool prefer_a = nearest_a >= 0 && best_a >= best_b - kRounding * frame.scale;
  if (!prefer_a && nearest_a >= 0 && nearest_b >= 0 && std::abs(best_b) <= tie * frame.size &&
      best_a >= best_b - tie * frame.size)
    prefer_a = sum.edge[nearest_a].normal.dot(sum.edge[nearest_b].normal) < kFaces;
  sum.count = count;
  sum.farthest = prefer_a ? nearest_a : nearest_b;
  sum.separation = std::max(best_a, best_b);
  if (sum.farthest < 0) {
    // Poses with NaN are infinitely far from each other.
    sum.farthest = 0;
    sum.separation = std::numeric_limits<double>::infinity();
  }
}

ClosestFeatures at_farthest(const Sum& sum) {
  ClosestFeatures result = at_edge(sum.edge[sum.farthest]);
  result.separation = sum.separation;
  return result;
}

}  // namespace

PairFrame::PairFrame(const ConvexShapes& shapes, ShapeIndex i, const Pose& pose_a, ShapeIndex j,
                     const Pose& pose_b)
    : a(shapes.corners_of(i)), b(shapes.corners_of(j)), edges_a(shapes.edges(i)), edges_b(shapes.edges(j)) {
  relative = {pose_a.turned_back(pose_b.position - pose_a.position),
              pose_a.cos * pose_b.cos + pose_a.sin * pose_b.sin,
              pose_a.cos * pose_b.sin - pose_a.sin * pose_b.cos};
  scale = relative.position.lpNorm<Eigen::Infinity>() + shapes.core_radius[i] + shapes.core_radius[j];
  size = std::min(scale, 2.0 * pair_size(shapes.core_radius[i], shapes.core_radius[j]));
  for (int k = 0; k < shapes.corners[j]; ++k) {
    vertex[k] = relative.position + relative.turned(b[k].vertex);
    normal[k] = relative.turned(b[k].normal);
  }
}

ClosestFeatures parting_edge(const PairFrame& frame, double tie) {
  Sum sum;
  add_up(frame, tie, sum);
  return at_farthest(sum);
}

std::optional<OverlappingTips> overlapping_tips(const PairFrame& frame) {
  Sum sum;
  add_up(frame, 0.0, sum);
  if (!(sum.separation < -kDeep * frame.size)) return std::nullopt;
  Vec2 all = Vec2::Zero();
  for (int k = 0; k < sum.count; ++k) {
    if (sum.edge[k].separation() >= sum.separation - kTied * frame.scale) all += sum.edge[k].normal;
  }
  // One direction only, or opposite ones.
  const Vec2& nearest = sum.edge[sum.farthest].normal;
  if (all.squaredNorm() < kTied || std::abs(cross(all.normalized(), nearest)) < kTied) return std::nullopt;
  const Vec2 out = all.normalized();
  const SumEdge* tip = std::max_element(
      sum.edge.data(), sum.edge.data() + sum.count,
      [&](const SumEdge& one, const SumEdge& other) { return out.dot(one.start) < out.dot(other.start); });
  if (std::abs(cross(out, tip->start)) > kTied * frame.scale) return std::nullopt;
  return OverlappingTips{-out, tip->i, tip->j};
}

ClosestFeatures closest_features(const PairFrame& frame, double tie) {
  Sum sum;
  add_up(frame, tie, sum);
  ClosestFeatures result = at_farthest(sum);
  if (sum.separation <= 0.0) return result;

  // The origin is outside: from the edge that it is farthest beyond, walk to the nearest feature.
  const auto at_start_of = [&](const SumEdge& e) {
    const double distance = e.start.norm();
    // Touching vertices have no direction: keep the edge's normal.
    if (distance <= kRounding * frame.scale) return result;
    return ClosestFeatures{distance, e.start / distance, -1, -1, e.i, e.j};
  };
  const std::array<SumEdge, 2 * kMostVertices>& edge = sum.edge;
  const int count = sum.count;
  int k = sum.farthest;
  const double along = edge[k].along();
  if (along < 0.0) {
    for (int steps = 0; steps < count; ++steps) {
      const int before = k == 0 ? count - 1 : k - 1;
      const double there = edge[before].along();
      if (there >= edge[before].length) return at_start_of(edge[k]);
      k = before;
      if (there >= 0.0) return at_edge(edge[k]);
    }
  } else if (along > edge[k].length) {
    for (int steps = 0; steps < count; ++steps) {
      k = k + 1 == count ? 0 : k + 1;
      const double there = edge[k].along();
      if (there <= 0.0) return at_start_of(edge[k]);
      if (there <= edge[k].length) return at_edge(edge[k]);
    }
  }
  return result;
}

}  // namespace carom
