#include "widgets/scene/overlap.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <string>
#include <type_traits>
#include <unordered_set>
#include <utility>
#include <variant>

#include "physics/collision/pair_contact.h"
#include "physics/model/geometry.h"
#include "widgets/edit/reshaping.h"
#include "widgets/scene/drag.h"

namespace carom {
namespace {

constexpr double kTouching = 1e-10;  // of the bodies' sizes: less of an overlap is rounding
constexpr double kWritten = 1e-4;    // of the bodies' sizes: less may be that of numbers in a file
constexpr double kSettled = 1e-14;   // of the size: a shorter step of the search is none
constexpr double kNear = 4.0;        // times the size: the farthest way out
constexpr int kSteps = 40;           // of the search from one guess
constexpr int kDirections = 16;      // of guesses around the bodies
constexpr int kHalvings = 60;

// The edited bodies, then their neighbours, as collision detection sees them.
struct Crowd {
  std::vector<Body> bodies;
  std::size_t edited = 0;
  Geometry geometry;
  std::vector<Pose> poses;
};

Crowd crowd_of(std::span<const Body> bodies, const Surroundings& neighbours) {
  Crowd crowd;
  crowd.bodies.assign(bodies.begin(), bodies.end());
  crowd.edited = bodies.size();
  crowd.bodies.insert(crowd.bodies.end(), neighbours.bodies.begin(), neighbours.bodies.end());
  std::unordered_set<std::string> names;
  for (const Body& body : crowd.bodies) names.insert(body.name);
  std::vector<Joint> joints;
  std::copy_if(neighbours.joints.begin(), neighbours.joints.end(), std::back_inserter(joints),
               [&](const Joint& joint) { return names.contains(joint.body) && names.contains(joint.to); });
  crowd.geometry = geometry(crowd.bodies, joints);
  for (BodyIndex i{0}; i < static_cast<int>(crowd.bodies.size()); ++i) {
    const Body& body = crowd.bodies[i];
    crowd.poses.push_back(crowd.geometry.pose(i, {body.position.x(), body.position.y(), body.angle}));
  }
  return crowd;
}

struct Pair {
  BodyIndex a;
  BodyIndex b;
  double size;  // m
};

// Nothing if they are farther apart than `reach`, or can't collide.
std::optional<Pair> pair_of(const Crowd& crowd, std::size_t i, std::size_t k, double reach) {
  const BodyIndex a{static_cast<int>(i)};
  const BodyIndex b{static_cast<int>(k)};
  const Eigen::VectorXd& reaches = crowd.geometry.reach;
  const double apart = (crowd.poses[i].position - crowd.poses[k].position).norm();
  if (apart > reaches[a] + reaches[b] + reach || !crowd.geometry.can_collide(a, b)) return std::nullopt;
  if (!std::isfinite(reaches[a]) && !std::isfinite(reaches[b])) return std::nullopt;  // two half-planes
  const auto finite = [&](BodyIndex n) { return std::isfinite(reaches[n]) ? reaches[n] : 0.0; };
  return Pair{a, b, finite(a) + finite(b)};
}

// What may come nearer than `reach`, of an edited body and a neighbour or, `within`, another edited one.
std::vector<Pair> pairs_of(const Crowd& crowd, double reach, bool within) {
  std::vector<Pair> pairs;
  for (std::size_t i = 0; i < crowd.edited; ++i) {
    for (std::size_t k = within ? i + 1 : crowd.edited; k < crowd.bodies.size(); ++k) {
      if (const auto pair = pair_of(crowd, i, k, reach)) pairs.push_back(*pair);
    }
  }
  return pairs;
}

Contact gap_of(const Crowd& crowd, const Pair& pair, const Vec2& moved) {
  Pose pose = crowd.poses[static_cast<std::size_t>(pair.a)];
  pose.position += moved;
  return contact_between(crowd.geometry, pair.a, pose, pair.b, crowd.poses[static_cast<std::size_t>(pair.b)]);
}

// Translations t with out·t >= least.
struct HalfPlane {
  Vec2 out = Vec2::Zero();
  double least = 0.0;  // m
};

// The shortest t that all of them allow, one more of them at a time: if the shortest of the first ones breaks
// the next, that of all lies on its edge.
std::optional<Vec2> shortest(std::span<const HalfPlane> limits, double slack) {
  Vec2 best = Vec2::Zero();
  for (std::size_t i = 0; i < limits.size(); ++i) {
    const HalfPlane& limit = limits[i];
    if (limit.out.dot(best) >= limit.least - slack) continue;
    const Vec2 along = crossed(limit.out);
    double low = -std::numeric_limits<double>::infinity();
    double high = std::numeric_limits<double>::infinity();
    for (const HalfPlane& other : limits.first(i)) {
      const double slope = other.out.dot(along);
      const double missing = other.least - limit.least * other.out.dot(limit.out);
      if (std::abs(slope) < 1e-12) {
        if (missing > slack) return std::nullopt;
      } else if (slope > 0.0) {
        low = std::max(low, missing / slope);
      } else {
        high = std::min(high, missing / slope);
      }
    }
    if (low > high + slack) return std::nullopt;
    best = limit.least * limit.out + std::clamp(0.0, std::min(low, high), high) * along;
  }
  return best;
}

// The way out that a first guess leads to. Two bodies are clear of each other if any direction parts them: from
// where they are, each pair keeps its best one, and the shortest translation that respects all is the next
// guess. It is never longer than the last one that was clear.
std::optional<Vec2> way_out(const Crowd& crowd, std::span<const Pair> pairs, Vec2 moved, double size) {
  std::vector<HalfPlane> limits(pairs.size());
  for (int step = 0; step < kSteps; ++step) {
    std::transform(pairs.begin(), pairs.end(), limits.begin(), [&](const Pair& pair) {
      const Contact gap = gap_of(crowd, pair, moved);
      return HalfPlane{-gap.normal, -gap.normal.dot(moved) - gap.gap};
    });
    const std::optional<Vec2> next = shortest(limits, kSettled * size);
    if (!next) return std::nullopt;
    const bool settled = (*next - moved).norm() <= kSettled * size;
    moved = *next;
    if (settled) break;
  }
  const bool clear = std::all_of(pairs.begin(), pairs.end(), [&](const Pair& pair) {
    return gap_of(crowd, pair, moved).gap >= -kTouching * pair.size;
  });
  return clear ? std::optional(moved) : std::nullopt;
}

// m: of the largest edited body, or of what a half-plane meets.
double size_of(const Crowd& crowd) {
  double size = 0.0;
  double beside = 0.0;
  for (std::size_t i = 0; i < crowd.bodies.size(); ++i) {
    const double radius = crowd.geometry.reach[static_cast<Eigen::Index>(i)];
    if (!std::isfinite(radius)) continue;
    double& largest = i < crowd.edited ? size : beside;
    largest = std::max(largest, radius);
  }
  return size > 0.0 ? size : beside;
}

double between(double from, double to, double share) { return from + share * (to - from); }

template <class Form>
Form between(const Form& from, const Form& to, double share) {
  if (const auto* disc = std::get_if<Disc>(&to)) {
    return Disc{between(std::get<Disc>(from).radius, disc->radius, share)};
  }
  if (const auto* box = std::get_if<Box>(&to)) {
    const Box& first = std::get<Box>(from);
    return Box{between(first.width, box->width, share), between(first.height, box->height, share)};
  }
  if (const auto* wall = std::get_if<Wall>(&to)) {
    return wall->length ? Wall{between(*std::get<Wall>(from).length, *wall->length, share)} : *wall;
  }
  if constexpr (std::is_same_v<Form, Shape>) {
    if (const auto* last = std::get_if<Compound>(&to)) {
      Compound compound = *last;
      for (std::size_t k = 0; k < compound.shapes.size(); ++k) {
        const PlacedShape& first = std::get<Compound>(from).shapes[k];
        PlacedShape& placed = compound.shapes[k];
        placed.shape = between(first.shape, placed.shape, share);
        placed.position = first.position + share * (placed.position - first.position);
      }
      return compound;
    }
  }
  Polygon polygon = std::get<Polygon>(to);
  const Polygon& first = std::get<Polygon>(from);
  for (std::size_t k = 0; k < polygon.vertices.size(); ++k) {
    polygon.vertices[k] = first.vertices[k] + share * (polygon.vertices[k] - first.vertices[k]);
  }
  polygon.rounding = between(first.rounding, polygon.rounding, share);
  return polygon;
}

std::vector<Body> between(std::span<const Body> from, std::span<const Body> to, double share) {
  std::vector<Body> bodies;
  for (std::size_t k = 0; k < from.size(); ++k) {
    bodies.push_back(resized(from[k], between(from[k].shape, to[k].shape, share)));
    bodies.back().position += share * (to[k].position - from[k].position);
  }
  return bodies;
}

std::vector<Overlap> overlapping(const Crowd& crowd, const std::vector<Pair>& pairs, double least) {
  std::vector<Overlap> overlaps;
  for (const Pair& pair : pairs) {
    const Contact contact = gap_of(crowd, pair, Vec2::Zero());
    if (!(-contact.gap > least * pair.size)) continue;
    overlaps.push_back({crowd.bodies[static_cast<std::size_t>(pair.a)],
                        crowd.bodies[static_cast<std::size_t>(pair.b)], -contact.gap, contact.point});
  }
  return overlaps;
}

// All that may meet, found from left to right; in the order of index pairs.
std::vector<Pair> near_pairs(const Crowd& crowd) {
  std::vector<std::size_t> order(crowd.bodies.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto reach = [&](std::size_t i) { return crowd.geometry.reach[static_cast<Eigen::Index>(i)]; };
  const auto left = [&](std::size_t i) { return crowd.poses[i].position.x() - reach(i); };
  std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t k) { return left(i) < left(k); });
  std::vector<Pair> pairs;
  for (std::size_t n = 0; n < order.size(); ++n) {
    const std::size_t i = order[n];
    const double right = crowd.poses[i].position.x() + reach(i);
    for (std::size_t m = n + 1; m < order.size() && left(order[m]) <= right; ++m) {
      if (const auto pair = pair_of(crowd, std::min(i, order[m]), std::max(i, order[m]), 0.0))
        pairs.push_back(*pair);
    }
  }
  std::sort(pairs.begin(), pairs.end(),
            [](const Pair& p, const Pair& q) { return std::pair(p.a, p.b) < std::pair(q.a, q.b); });
  return pairs;
}

}  // namespace

std::vector<Overlap> overlaps_among(std::span<const Body> bodies, const std::vector<Joint>& joints) {
  const Crowd crowd = crowd_of(bodies, {{}, joints});
  return overlapping(crowd, near_pairs(crowd), kWritten);
}

std::vector<Overlap> overlaps_of(std::span<const Body> bodies, const Surroundings& neighbours,
                                 bool with_each_other) {
  const Crowd crowd = crowd_of(bodies, neighbours);
  std::vector<Overlap> overlaps = overlapping(crowd, pairs_of(crowd, 0.0, with_each_other), kTouching);
  std::stable_sort(overlaps.begin(), overlaps.end(),
                   [](const Overlap& a, const Overlap& b) { return a.depth > b.depth; });
  return overlaps;
}

std::optional<std::vector<Body>> moved_out(std::span<const Body> bodies, const Surroundings& neighbours) {
  const Crowd crowd = crowd_of(bodies, neighbours);
  const double size = size_of(crowd);
  const double reach = kNear * size;
  const std::vector<Pair> pairs = pairs_of(crowd, reach, false);
  std::optional<Vec2> best;
  const auto attempt = [&](const Vec2& guess) {
    const std::optional<Vec2> moved = way_out(crowd, pairs, guess, size);
    if (moved && moved->norm() <= reach && (!best || moved->norm() < best->norm())) best = moved;
  };
  attempt(Vec2::Zero());
  for (const double distance : {0.25, 0.5, 1.0, 2.0, kNear}) {
    if (best && best->norm() <= distance * size) break;
    for (int k = 0; k < kDirections; ++k) {
      attempt(distance * size * direction_at(2.0 * std::numbers::pi * k / kDirections));
    }
  }
  if (!best) return std::nullopt;
  std::vector<Body> moved(bodies.begin(), bodies.end());
  for (Body& body : moved) body.position += *best;
  return moved;
}

std::vector<Body> grown_to_touch(std::span<const Body> before, std::span<const Body> after,
                                 const Surroundings& neighbours) {
  struct Clear {
    Pair pair;
    double least;  // m, of the gap
  };
  const Crowd first = crowd_of(before, neighbours);
  std::vector<Clear> pairs;
  for (const Pair& pair : pairs_of(crowd_of(after, neighbours), 0.0, true)) {
    const double gap = gap_of(first, pair, Vec2::Zero()).gap;
    if (gap >= -kTouching * pair.size) pairs.push_back({pair, std::min(gap, 0.0) - kSettled * pair.size});
  }
  const auto clear = [&](double share) {
    const Crowd crowd = crowd_of(between(before, after, share), neighbours);
    return std::all_of(pairs.begin(), pairs.end(), [&](const Clear& each) {
      return gap_of(crowd, each.pair, Vec2::Zero()).gap >= each.least;
    });
  };
  if (clear(1.0)) return {after.begin(), after.end()};
  double low = 0.0;
  double high = 1.0;
  for (int k = 0; k < kHalvings; ++k) {
    const double middle = 0.5 * (low + high);
    (clear(middle) ? low : high) = middle;
  }
  return between(before, after, low);
}

Body in_touch(const Body& body, const Body& other) {
  const Crowd crowd = crowd_of({&body, 1}, {{other}, {}});
  const Eigen::VectorXd& reach = crowd.geometry.reach;
  if (!std::isfinite(reach[0])) return body;
  const bool half_plane = !std::isfinite(reach[1]);
  const Vec2 apart = body.position - other.position;
  Vec2 line = half_plane ? turned_by(other.angle, Vec2::UnitY()) : apart.normalized();
  if (line.isZero(0.0)) line = Vec2::UnitX();
  // m along the line, between the centres: overlapping and clear.
  double low = 0.0;
  double high = reach[0] + (half_plane ? 0.0 : reach[1]);
  const auto moved = [&](double distance) { return Vec2((distance - line.dot(apart)) * line); };
  for (int k = 0; k < kHalvings; ++k) {
    const double middle = 0.5 * (low + high);
    (gap_of(crowd, {BodyIndex{0}, BodyIndex{1}, high}, moved(middle)).gap < 0.0 ? low : high) = middle;
  }
  Body out = body;
  out.position += moved(high);
  return out;
}

}  // namespace carom
