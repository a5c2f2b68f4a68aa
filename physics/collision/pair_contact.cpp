#include "physics/collision/pair_contact.h"

#include <algorithm>
#include <cassert>
#include <limits>
#include <optional>

#include "physics/collision/closest_features.h"
#include "physics/collision/feature_id.h"
#include "physics/collision/tips.h"
#include "physics/math/vectors.h"
#include "physics/model/pair_size.h"

namespace carom {
namespace {

// Two faces are parallel if the gaps at both ends differ by no more than this share of the size: a body that
// rests on another is tilted by what the solver of its contact forces leaves, up to 1e-10.
constexpr double kFlat = 1e-9;
// A stretch shorter than this share of the scale is a point.
constexpr double kShort = 16.0 * std::numeric_limits<double>::epsilon();
// Likewise where faces are preferred: what slides along a face passes corners that are flush with it.
constexpr double kTipOfFaces = 32.0 * std::numeric_limits<double>::epsilon();
// Between corners that are nearer than this share of the size, the direction from one to the other is noise.
constexpr double kBlunt = 1e-4;
// Relative to the size: where corners meet, edges that part two bodies equally well within this.
constexpr double kTie = 1e-8;

// Where two bodies touch or are nearest, relative to the position of body a in the frame in which they were
// compared.
struct Touch {
  Vec2 normal;
  double gap;
  Vec2 point;  // where the gap is
  bool flat;   // two parallel faces
  int count;
  std::array<ManifoldPoint, 2> points;
};

Vec2 tangent(const Vec2& normal) { return {-normal.y(), normal.x()}; }

// The point half-way between the surfaces, from a point of b's core.
Vec2 between(const Vec2& on_b, double rounding_b, double gap, const Vec2& normal) {
  return on_b - (rounding_b + 0.5 * gap) * normal;
}

// A face as a line over the tangent, from (low, at_low) to (high, at_high); heights are along the normal.
struct Face {
  double low;
  double high;
  double at_low;
  double at_high;

  [[nodiscard]] double height(double x) const {
    if (!(high > low) || at_high == at_low) return at_low;  // a half-plane's ends are infinite
    return at_low + (at_high - at_low) * ((x - low) / (high - low));
  }
};

Face face(const Vec2& low, const Vec2& high, const Vec2& normal) {
  const Vec2 along = tangent(normal);
  return {along.dot(low), along.dot(high), normal.dot(low), normal.dot(high)};
}

// Finds the stretch that two faces share. If it is no longer than rounding, it is one point; without one,
// `touch` keeps its point.
void clip(const Face& a, const Face& b, ConvexShapes::Roundings rounding, double scale, double size, int edge_a,
          int edge_b, Touch& touch) {
  const double low = std::max(a.low, b.low);
  const double high = std::min(a.high, b.high);
  const Vec2 along = tangent(touch.normal);
  if (!(high - low > kShort * scale)) {
    if (!(low - high <= kShort * scale)) return;
    const double x = 0.5 * (low + high);
    touch.point = between(x * along + b.height(x) * touch.normal, rounding.b, touch.gap, touch.normal);
    touch.points[0].point = touch.point;
    return;
  }
  touch.count = 0;
  for (const double x : {low, high}) {
    const double on_b = b.height(x);
    const double gap = on_b - a.height(x) - rounding.sum();
    const Vec2 point = between(x * along + on_b * touch.normal, rounding.b, gap, touch.normal);
    touch.points[touch.count++] = {point, gap, feature_id(x == low ? Ends::kLow : Ends::kHigh, edge_a, edge_b)};
  }
  touch.flat = std::abs(touch.points[1].gap - touch.points[0].gap) <= kFlat * size;
}

// The one of the two edges at a corner that faces `normal` most.
int facing_edge(const Vec2& normal, const Vec2& here, const Vec2& before, int k, int count) {
  if (normal.dot(before) > normal.dot(here)) return k == 0 ? count - 1 : k - 1;
  return k;
}

// A segment has two corners at each end: 0 and 1 on its first side, 2 and 3 on its second. Returns the corner
// at the same place as k on the facing side; `facing` >= 0 if that is the first.
int on_facing_side(int k, double facing) { return (facing >= 0.0) == (k < 2) ? k : 3 - k; }

int before(int k, int count) { return k == 0 ? count - 1 : k - 1; }
int after(int k, int count) { return k + 1 == count ? 0 : k + 1; }

// Finds the stretch that an edge of one core shares with the edge of the other that faces it most; without
// one, `touch` keeps its point.
void clip_at(const PairFrame& frame, const ClosestFeatures& closest, ConvexShapes::Roundings rounding,
             Touch& touch) {
  int edge_a = closest.vertex_a;
  int edge_b = closest.vertex_b;
  if (closest.edge_a < 0) {
    if (frame.edges_a == 4 && frame.a[1].vertex == frame.a[2].vertex)
      edge_a = on_facing_side(edge_a, closest.normal.dot(frame.a[0].normal));
    edge_a = facing_edge(closest.normal, frame.a[edge_a].normal, frame.a[before(edge_a, frame.edges_a)].normal,
                         edge_a, frame.edges_a);
  }
  if (closest.edge_b < 0) {
    if (frame.edges_b == 4 && frame.vertex[1] == frame.vertex[2])
      edge_b = on_facing_side(edge_b, -closest.normal.dot(frame.normal[0]));
    edge_b = facing_edge(-closest.normal, frame.normal[edge_b], frame.normal[before(edge_b, frame.edges_b)],
                         edge_b, frame.edges_b);
  }
  touch.points[0].id = feature_id(Ends::kOne, edge_a, edge_b);
  clip(face(frame.a[edge_a].vertex, frame.a[after(edge_a, frame.edges_a)].vertex, touch.normal),
       face(frame.vertex[after(edge_b, frame.edges_b)], frame.vertex[edge_b], touch.normal), rounding,
       frame.scale, frame.size, edge_a, edge_b, touch);
}

// With `prefer_faces`, two faces that share a stretch touch there with the normal of one of them, even if
// corners just beside it are nearest.
Touch touch_of_cores(const ConvexShapes& shapes, ShapeIndex a, const Pose& pose_a, ShapeIndex b,
                     const Pose& pose_b, bool prefer_faces) {
  const PairFrame frame(shapes, a, pose_a, b, pose_b);
  const ClosestFeatures closest = closest_features(frame, prefer_faces ? kTie : 0.0);
  const ConvexShapes::Roundings rounding = shapes.roundings(a, b);
  const bool sharp = shapes.rounding[a] + shapes.rounding[b] == 0.0;
  Touch touch{closest.normal, closest.separation - rounding.sum(), Vec2::Zero(), false, 1, {}};

  if (!prefer_faces && sharp && frame.edges_a >= 3 && frame.edges_b >= 3) {
    if (const auto tips = overlapping_tips(frame)) {
      const Vec2& on_a = frame.a[tips->vertex_a].vertex;
      const Vec2& on_b = frame.vertex[static_cast<std::size_t>(tips->vertex_b)];
      touch.normal = tips->normal;
      touch.gap = tips->normal.dot(on_b - on_a) - rounding.sum();
      touch.point = 0.5 * (on_a + on_b);
      touch.points[0] = {touch.point, touch.gap, feature_id(Ends::kVertices, tips->vertex_a, tips->vertex_b)};
      return touch;
    }
  }

  // The point of b's core; opposite a's vertex if that is nearest to an edge of b.
  Vec2 on_b = frame.vertex[closest.vertex_b];
  if (closest.edge_b >= 0) on_b = frame.a[closest.vertex_a].vertex + closest.separation * closest.normal;
  touch.point = between(on_b, rounding.b, touch.gap, touch.normal);
  touch.points[0] = {touch.point, touch.gap, feature_id(Ends::kVertices, closest.vertex_a, closest.vertex_b)};
  const bool corners = closest.edge_a < 0 && closest.edge_b < 0;
  const bool blunt = prefer_faces && closest.separation > 0.0 && closest.separation <= kBlunt * frame.size;
  // Faces that touch from end to end: which of their corners are nearest is rounding.
  const bool end_to_end = corners && closest.separation > 0.0 && closest.separation <= kTip * frame.scale;
  if (prefer_faces ? corners || blunt : end_to_end) {
    const ClosestFeatures edge = parting_edge(frame, kTie);
    Touch faces = touch;
    faces.normal = edge.normal;
    clip_at(frame, edge, rounding, faces);
    const bool share = faces.count == 2 && (prefer_faces || faces.flat);
    if (share && std::min(faces.points[0].gap, faces.points[1].gap) <= touch.gap + kTie * frame.size)
      return faces;
    if (blunt) {
      if (faces.count == 1) faces.gap = faces.points[0].gap = edge.separation - rounding.sum();
      touch = faces;
    }
  }
  if (!corners && !blunt) clip_at(frame, closest, rounding, touch);
  const double near = (prefer_faces ? kTipOfFaces : kTip) * frame.scale;
  const bool in_one_point =
      touch.count == 1 ||
      (!prefer_faces && (!touch.flat || (touch.points[1].point - touch.points[0].point).norm() <= near));
  if (!in_one_point) return touch;
  if (!sharp || std::abs(closest.separation - rounding.sum()) > near) return touch;
  const auto tips = tips_that_meet(shapes, a, b, frame, near);
  if (!tips) return touch;
  const auto normal = tip_normal(*tips, frame.relative.position);
  if (!normal) return touch;
  touch.normal = *normal;
  touch.point = touch.points[0].point = tips->point;
  touch.count = 1;
  touch.flat = false;
  return touch;
}

// A body over a half-plane: its gap, the normal out of the half-plane, and the lowest vertex.
struct Height {
  double gap;
  Vec2 normal;
  int lowest;
};

Height height_over(const ConvexShapes& shapes, ShapeIndex plane, const Pose& pose_plane, ShapeIndex body,
                   const Pose& pose_body) {
  const Corner& edge = *shapes.corners_of(plane);
  const Corner* corner = shapes.corners_of(body);
  const Vec2 n = pose_plane.turned(edge.normal);
  const Vec2 own = pose_body.turned_back(n);
  int lowest = 0;
  double least = own.dot(corner[0].vertex);
  for (int k = 1; k < shapes.corners[body]; ++k) {
    const double height = own.dot(corner[k].vertex);
    if (height < least) least = height, lowest = k;
  }
  const double centre = n.dot(pose_body.position - pose_plane.position) - edge.normal.dot(edge.vertex);
  return {centre + least - shapes.rounding[body], n, lowest};
}

// In the world's directions, relative to the half-plane's position; the normal points out of the half-plane.
Touch touch_of_half_plane(const ConvexShapes& shapes, ShapeIndex plane, const Pose& pose_plane, ShapeIndex body,
                          const Pose& pose_body) {
  const Height height = height_over(shapes, plane, pose_plane, body, pose_body);
  const Vec2& n = height.normal;
  const Corner* corner = shapes.corners_of(body);
  const int count = shapes.corners[body];
  const double rounding = shapes.rounding[body];
  const Vec2 d = pose_body.position - pose_plane.position;
  const auto on_core = [&](int k) -> Vec2 { return d + pose_body.turned(corner[k].vertex); };
  Touch touch{n, height.gap, between(on_core(height.lowest), rounding, height.gap, n), false, 1, {}};
  touch.points[0] = {touch.point, touch.gap, 0U};
  if (shapes.edges(body) == 0) return touch;
  const Vec2 down = -pose_body.turned_back(n);
  const int lowest = shapes.core[body] == Core::kSegment
                         ? on_facing_side(height.lowest, down.dot(corner[0].normal))
                         : height.lowest;
  const int e = facing_edge(down, corner[lowest].normal, corner[before(lowest, count)].normal, lowest, count);
  touch.points[0].id = feature_id(Ends::kOne, 0, e);
  const double infinite = std::numeric_limits<double>::infinity();
  const Corner& edge = *shapes.corners_of(plane);
  const double floor = edge.normal.dot(edge.vertex);
  const double scale = d.lpNorm<Eigen::Infinity>() + shapes.core_radius[body];
  clip({-infinite, infinite, floor, floor}, face(on_core(after(e, count)), on_core(e), n), {0.0, rounding},
       scale, pair_size(shapes.core_radius[body], scale), 0, e, touch);
  return touch;
}

// Nearest point of a rectangle's boundary to a point, in the rectangle's own frame, as signed distance and
// outward normal.
Gap nearest_on_rectangle(const Vec2& half, const Vec2& p) {
  const Vec2 outside = p - p.cwiseMax(-half).cwiseMin(half);
  const double distance = outside.norm();
  if (distance > 0.0) return {distance, outside / distance};
  const Vec2 depth = half - p.cwiseAbs();
  const int axis = depth.x() <= depth.y() ? 0 : 1;
  Vec2 normal = Vec2::Zero();
  normal[axis] = p[axis] < 0.0 ? -1.0 : 1.0;
  return {-depth[axis], normal};
}

// Gap from a core, which is no point, to a disc's centre, without roundings; in closed form for a disc on a
// box.
Gap gap_to_centre(const ConvexShapes& shapes, ShapeIndex core, const Pose& pose_core, ShapeIndex disc,
                  const Pose& pose_disc) {
  if (shapes.core[core] == Core::kBox) {
    const Vec2& half = shapes.corners_of(core)[2].vertex;
    const Vec2 d = pose_disc.position - pose_core.position;
    const Gap nearest = nearest_on_rectangle(half, pose_core.turned_back(d));
    return {nearest.gap, pose_core.turned(nearest.normal)};
  }
  const ClosestFeatures closest = closest_features(PairFrame(shapes, core, pose_core, disc, pose_disc));
  return {closest.separation, pose_core.turned(closest.normal)};
}

// For a disc and a body that is not a half-plane.
Contact disc_contact(const ConvexShapes& shapes, ShapeIndex a, const Pose& pose_a, ShapeIndex b,
                     const Pose& pose_b) {
  if (shapes.core[a] == Core::kPoint && shapes.core[b] == Core::kPoint)
    return contact_of_discs(shapes, a, pose_a.position, b, pose_b.position);
  // The body with a core is the frame of reference. From the disc's centre the contact point is back along the
  // normal, in the middle of gap or penetration.
  const ConvexShapes::Roundings rounding = shapes.roundings(a, b);
  if (shapes.core[b] == Core::kPoint) {
    const Gap to_b = gap_to_centre(shapes, a, pose_a, b, pose_b);
    const double gap = to_b.gap - rounding.sum();
    return {gap, to_b.normal, between(pose_b.position, rounding.b, gap, to_b.normal)};
  }
  const Gap to_a = gap_to_centre(shapes, b, pose_b, a, pose_a);
  const double gap = to_a.gap - rounding.sum();
  return {gap, -to_a.normal, between(pose_a.position, rounding.a, gap, to_a.normal)};
}

bool has_disc(const ConvexShapes& shapes, ShapeIndex a, ShapeIndex b) {
  return shapes.core[a] == Core::kPoint || shapes.core[b] == Core::kPoint;
}

bool has_half_plane(const ConvexShapes& shapes, ShapeIndex a, ShapeIndex b) {
  assert(shapes.core[a] != Core::kHalfPlane || shapes.core[b] != Core::kHalfPlane);
  return shapes.core[a] == Core::kHalfPlane || shapes.core[b] == Core::kHalfPlane;
}

// For any pair, in world coordinates.
Touch touch_between(const ConvexShapes& shapes, ShapeIndex a, const Pose& pose_a, ShapeIndex b,
                    const Pose& pose_b, bool prefer_faces) {
  if (has_half_plane(shapes, a, b)) {
    const bool plane_first = shapes.core[a] == Core::kHalfPlane;
    Touch touch = plane_first ? touch_of_half_plane(shapes, a, pose_a, b, pose_b)
                              : touch_of_half_plane(shapes, b, pose_b, a, pose_a);
    if (!plane_first) touch.normal = -touch.normal;
    const Vec2& origin = plane_first ? pose_a.position : pose_b.position;
    touch.point += origin;
    for (int k = 0; k < touch.count; ++k) touch.points[k].point += origin;
    return touch;
  }
  if (has_disc(shapes, a, b)) {
    const Contact c = disc_contact(shapes, a, pose_a, b, pose_b);
    return {c.normal, c.gap, c.point, false, 1, {{{c.point, c.gap, 0U}, {}}}};
  }
  Touch touch = touch_of_cores(shapes, a, pose_a, b, pose_b, prefer_faces);
  touch.normal = pose_a.turned(touch.normal);
  touch.point = pose_a.position + pose_a.turned(touch.point);
  for (int k = 0; k < touch.count; ++k) {
    touch.points[k].point = pose_a.position + pose_a.turned(touch.points[k].point);
  }
  return touch;
}

}  // namespace

Gap gap_between(const ConvexShapes& shapes, ShapeIndex a, const Pose& pose_a, ShapeIndex b,
                const Pose& pose_b) {
  if (has_half_plane(shapes, a, b)) {
    if (shapes.core[a] == Core::kHalfPlane) {
      const Height height = height_over(shapes, a, pose_a, b, pose_b);
      return {height.gap, height.normal};
    }
    const Height height = height_over(shapes, b, pose_b, a, pose_a);
    return {height.gap, -height.normal};
  }
  if (has_disc(shapes, a, b)) {
    const Contact c = disc_contact(shapes, a, pose_a, b, pose_b);
    return {c.gap, c.normal};
  }
  const PairFrame frame(shapes, a, pose_a, b, pose_b);
  const ClosestFeatures closest = closest_features(frame);
  const double gap = closest.separation - shapes.roundings(a, b).sum();
  const bool sharp = shapes.rounding[a] + shapes.rounding[b] == 0.0;
  // Corners may meet tip to tip.
  if (sharp && std::abs(gap) <= kTip * frame.scale)
    return {gap, pose_a.turned(touch_of_cores(shapes, a, pose_a, b, pose_b, false).normal)};
  return {gap, pose_a.turned(closest.normal)};
}

Contact contact_between(const ConvexShapes& shapes, ShapeIndex a, const Pose& pose_a, ShapeIndex b,
                        const Pose& pose_b) {
  if (has_disc(shapes, a, b) && !has_half_plane(shapes, a, b))
    return disc_contact(shapes, a, pose_a, b, pose_b);
  const Touch touch = touch_between(shapes, a, pose_a, b, pose_b, false);
  if (!touch.flat) return {touch.gap, touch.normal, touch.point};
  const Vec2 middle = 0.5 * (touch.points[0].point + touch.points[1].point);
  return {touch.gap, touch.normal, middle + (touch.point - middle).dot(touch.normal) * touch.normal};
}

Manifold manifold(const ConvexShapes& shapes, ShapeIndex a, const Pose& pose_a, ShapeIndex b,
                  const Pose& pose_b, double margin) {
  Manifold result;
  const double reach = shapes.radius[a] + shapes.radius[b] + margin;
  if ((pose_b.position - pose_a.position).squaredNorm() > reach * reach) return result;
  const Touch touch = touch_between(shapes, a, pose_a, b, pose_b, true);
  if (touch.gap > margin) return result;
  result.normal = touch.normal;
  for (int k = 0; k < touch.count; ++k) {
    if (touch.flat || touch.points[k].gap <= margin) result.points[result.count++] = touch.points[k];
  }
  return result;
}

Contact contact_between(const Geometry& g, BodyIndex a, const Pose& pose_a, BodyIndex b, const Pose& pose_b) {
  if (!g.has_parts(a) && !g.has_parts(b))
    return contact_between(g.shapes, g.first_part(a), pose_a, g.first_part(b), pose_b);
  Contact nearest;
  nearest.gap = std::numeric_limits<double>::infinity();
  g.each_parts(a, b, [&](ShapeIndex part_a, ShapeIndex part_b) {
    Contact contact = contact_between(g.shapes, part_a, g.part_pose(a, part_a, pose_a), part_b,
                                      g.part_pose(b, part_b, pose_b));
    if (!(contact.gap < nearest.gap)) return;
    nearest = contact;
    nearest.parts = {part_a, part_b};
  });
  return nearest;
}

Contact contact_between(const Geometry& g, BodyIndex a, const Eigen::Vector3d& qa, BodyIndex b,
                        const Eigen::Vector3d& qb) {
  return contact_between(g, a, g.pose(a, qa), b, g.pose(b, qb));
}

Contact contact_again(const Geometry& g, BodyIndex a, const Pose& pose_a, BodyIndex b, const Pose& pose_b,
                      const Contact& earlier) {
  if (!earlier.parts.known() || (!g.has_parts(a) && !g.has_parts(b)))
    return contact_between(g, a, pose_a, b, pose_b);
  const auto [part_a, part_b] = earlier.parts;
  Contact contact =
      contact_between(g.shapes, part_a, g.part_pose(a, part_a, pose_a), part_b, g.part_pose(b, part_b, pose_b));
  contact.parts = earlier.parts;
  return contact;
}

Manifold manifold(const Geometry& g, BodyIndex a, ShapeIndex part_a, const Pose& pose_a, BodyIndex b,
                  ShapeIndex part_b, const Pose& pose_b, double margin) {
  if (!g.has_parts(a) && !g.has_parts(b))
    return manifold(g.shapes, g.first_part(a), pose_a, g.first_part(b), pose_b, margin);
  Manifold m = manifold(g.shapes, part_a, g.part_pose(a, part_a, pose_a), part_b,
                        g.part_pose(b, part_b, pose_b), margin);
  const auto parts = static_cast<std::uint32_t>(g.number_of(a, part_a)) |
                     static_cast<std::uint32_t>(g.number_of(b, part_b)) << kPartBits;
  for (ManifoldPoint& point : m.points) point.id |= parts << kFeatureBits;
  m.parts = {part_a, part_b};
  return m;
}

ShapePair parts_at(const Geometry& g, BodyIndex a, BodyIndex b, std::uint32_t id) {
  const auto [of_a, of_b] = part_numbers(id);
  return {g.part_of(a, static_cast<int>(of_a)), g.part_of(b, static_cast<int>(of_b))};
}

Manifold manifold_of(const Geometry& g, BodyIndex a, const Pose& pose_a, BodyIndex b, const Pose& pose_b,
                     std::uint32_t id, double margin) {
  const auto [part_a, part_b] = parts_at(g, a, b, id);
  return manifold(g, a, part_a, pose_a, b, part_b, pose_b, margin);
}

}  // namespace carom
