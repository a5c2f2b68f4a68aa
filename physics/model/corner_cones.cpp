#include "physics/model/corner_cones.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "physics/math/vectors.h"

namespace carom {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;
// Relative to the sizes, and to the distance from the origin: surfaces so near a corner meet it.
constexpr double kMeets = 1e-8;
constexpr double kFar = 1e-12;
// rad: faces that differ by less are flush.
constexpr double kFlush = 1e-7;

// The directions that a part fills at a point of its surface, counter-clockwise.
struct Filled {
  double from = 0.0;  // rad
  double turn = 0.0;  // rad, up to there
};

double angle_of(const Vec2& direction) { return std::atan2(direction.y(), direction.x()); }

// rad, in [0, 2π): counter-clockwise from one direction to another; what is all but a whole turn is none.
double turn_to(double from, double to) {
  double turn = std::fmod(to - from, kTurn);
  if (turn < 0.0) turn += kTurn;
  return turn > kTurn - kFlush ? 0.0 : turn;
}

bool has_corners(const ConvexShapes& shapes, ShapeIndex part) {
  return (shapes.core[part] == Core::kBox || shapes.core[part] == Core::kPolygon) &&
         shapes.rounding[part] == 0.0;
}

// What a part fills at a point (m); nothing where its surface does not go through it.
std::optional<Filled> filled_at(const ConvexShapes& shapes, ShapeIndex part, const Pose& pose,
                                const Vec2& point, double tolerance) {
  const Vec2 p = pose.turned_back(Vec2(point - pose.position));
  const Corner* corner = shapes.corners_of(part);
  const int count = shapes.corners[part];
  const bool half_plane = shapes.core[part] == Core::kHalfPlane;
  if (!half_plane && !has_corners(shapes, part)) return std::nullopt;
  std::optional<Filled> filled;
  for (int k = 0; k < count; ++k) {
    const double height = corner[k].normal.dot(p - corner[k].vertex);
    if (height > tolerance) return std::nullopt;
    if (height < -tolerance) continue;
    const double from = angle_of(pose.turned(crossed(corner[k].normal)));
    const double half = std::numbers::pi;
    if (!filled) {
      filled = Filled{from, half};
      continue;
    }
    // Where two edges meet: from the one that starts here to the one that ends here.
    const bool starts = (corner[k].vertex - p).norm() <= tolerance;
    filled = starts ? Filled{from, turn_to(from, filled->from + half)}
                    : Filled{filled->from, turn_to(filled->from, from + half)};
  }
  return filled;
}

struct PlacedPart {
  BodyIndex body;
  ShapeIndex part;
  Pose pose;
};

// What own and other fill together, if they meet or overlap.
bool join(Filled& own, const Filled& other) {
  const double after = turn_to(own.from, other.from);
  const double before = turn_to(other.from, own.from);
  if (after <= own.turn + kFlush) {
    own.turn = std::max(own.turn, after + other.turn);
  } else if (before <= other.turn + kFlush) {
    own = {other.from, std::max(other.turn, before + own.turn)};
  } else {
    return false;
  }
  return true;
}

// The cone of a corner that fills `own`, among others at its place.
CornerCone cone_of(const Filled& own, std::vector<Filled> others) {
  Filled whole = own;
  for (bool any = true; any;) {
    const auto left =
        std::remove_if(others.begin(), others.end(), [&](const Filled& f) { return join(whole, f); });
    any = left != others.end();
    others.erase(left, others.end());
  }
  const auto end = [](const Filled& f) { return f.from + f.turn; };
  // rad: that is free beside it, up to the next others.
  double after = kTurn - whole.turn;
  double before = after;
  for (const Filled& other : others) {
    after = std::min(after, turn_to(end(whole), other.from));
    before = std::min(before, turn_to(end(other), whole.from));
  }
  const auto inwards = [](double angle) { return Vec2(-crossed(direction_at(angle))); };
  CornerCone cone{Vec2(-inwards(end(whole))), inwards(whole.from), false};
  if (std::max(after, before) > std::numbers::pi + kFlush) return cone;
  cone.reentrant = true;
  const auto same = [](double one, double other) {
    return std::min(turn_to(one, other), turn_to(other, one)) <= kFlush;
  };
  if (!same(end(whole), end(own))) cone.last.setZero();
  if (!same(whole.from, own.from)) cone.next.setZero();
  return cone;
}

// Those of a part's corners at which some of these others are.
void add_cones_of(const PlacedPart& own, const std::vector<PlacedPart>& near, ConvexShapes& shapes) {
  for (int k = 0; k < shapes.corners[own.part]; ++k) {
    const Corner* corner = shapes.corners_of(own.part);
    const Vec2 point = own.pose.position + own.pose.turned(corner[k].vertex);
    std::vector<Filled> others;
    for (const PlacedPart& other : near) {
      const double size = std::min(shapes.radius[own.part], shapes.radius[other.part]);
      const double tolerance = kMeets * size + kFar * point.lpNorm<1>();
      if (const auto filled = filled_at(shapes, other.part, other.pose, point, tolerance))
        others.push_back(*filled);
    }
    if (others.empty()) continue;
    const int last = k == 0 ? shapes.corners[own.part] - 1 : k - 1;
    const double from = angle_of(own.pose.turned(crossed(corner[k].normal)));
    const double to = angle_of(own.pose.turned(Vec2(-crossed(corner[last].normal))));
    CornerCone cone = cone_of({from, turn_to(from, to)}, std::move(others));
    cone.last = own.pose.turned_back(cone.last);
    cone.next = own.pose.turned_back(cone.next);
    if (shapes.cone_of.empty()) shapes.cone_of.assign(shapes.corner.size(), -1);
    shapes.cone_of[static_cast<std::size_t>(shapes.first[own.part] + k)] =
        static_cast<int>(shapes.cones.size());
    shapes.cones.push_back(cone);
  }
}

}  // namespace

void find_corner_cones(const std::vector<Body>& bodies, Geometry& g) {
  ConvexShapes& shapes = g.shapes;
  std::vector<PlacedPart> staying;  // of bodies that do not move, or as drives make them
  std::vector<PlacedPart> near;
  const auto placed = [&](BodyIndex i, const auto& visit) {
    const Body& body = bodies[static_cast<std::size_t>(i)];
    const Vec2 along = direction_at(body.angle);
    const Pose pose{body.position, along.x(), along.y()};
    g.each_part(i, [&](ShapeIndex part) { visit(PlacedPart{i, part, g.part_pose(i, part, pose)}); });
  };
  const auto drive = [&](BodyIndex i) -> const auto& { return bodies[static_cast<std::size_t>(i)].drive; };
  const auto stays = [&](BodyIndex i) { return bodies[static_cast<std::size_t>(i)].fixed || drive(i); };
  const auto add_cones = [&](const PlacedPart& own) {
    if (!has_corners(shapes, own.part)) return;
    near.clear();
    const auto add_near = [&](const PlacedPart& other) {
      const bool together = own.body == other.body || drive(own.body) == drive(other.body);
      if (other.part == own.part || !together || g.group[own.body] != g.group[other.body]) return;
      const double reach = shapes.radius[other.part] + shapes.radius[own.part];
      const double allowed = (1.0 + kMeets) * reach + kFar * own.pose.position.lpNorm<1>();
      if ((own.pose.position - other.pose.position).squaredNorm() <= allowed * allowed) near.push_back(other);
    };
    if (stays(own.body)) {
      std::for_each(staying.begin(), staying.end(), add_near);
    } else {
      placed(own.body, add_near);
    }
    if (!near.empty()) add_cones_of(own, near, shapes);
  };
  const BodyIndex end{static_cast<int>(bodies.size())};
  for (BodyIndex i{0}; i < end; ++i) {
    if (stays(i)) placed(i, [&](const PlacedPart& part) { staying.push_back(part); });
  }
  for (BodyIndex i{0}; i < end; ++i) {
    if (stays(i) || g.has_parts(i)) placed(i, add_cones);
  }
}

}  // namespace carom
