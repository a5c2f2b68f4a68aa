#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "physics/collision/broad_phase.h"
#include "physics/collision/pair_contact.h"
#include "physics/step/event_driven_impacts.h"
#include "physics/step/internal_edges.h"
#include "physics/step/pair_motion.h"

// The schedule of impacts: trajectories in cells, and the search of each one's neighbours.
namespace carom {
namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
constexpr double kNever = std::numeric_limits<double>::infinity();
// Up to this many bodies a trajectory that no step ends may cross the whole scene: every pair is searched
// anyway.
constexpr int kFewBodies = 12;
// Searches after an impact that cost nothing.
constexpr std::int64_t kFewNeighbours = 16;
// Times the tolerance for what touches: as one end of a face lands the other one is so near.
constexpr double kEndOfFace = 16.0;

}  // namespace

// Cells about as large as a body and its trajectory.
void EventDrivenImpacts::choose_cells(const World& world, double horizon) {
  double size = 0.0;
  double path = 0.0;
  double fastest = 0.0;
  int moving = 0;
  Bounds all{Eigen::Array2d::Constant(kNever), Eigen::Array2d::Constant(-kNever)};
  const int n = world.bodies();
  for (BodyIndex i{0}; i < n; ++i) {
    const Eigen::Array2d x = world.trajectories.at_start(i).head<2>().array();
    const Eigen::Array2d extent = world.shapes().extent.col(i).array();
    if (!extent.allFinite()) continue;
    all.low = all.low.min(x - extent);
    all.high = all.high.max(x + extent);
    if (world.infinite_mass(i)) continue;
    ++moving;
    size += 2.0 * extent.maxCoeff();
    const double speed = world.trajectories.at_start(i).segment<2>(3).norm();
    path += speed;
    fastest = std::max(fastest, speed);
  }
  const bool finite = (all.high >= all.low).all();  // there are bodies other than half-planes
  const double across = finite ? (all.high - all.low).matrix().norm() : 1.0;
  if (moving == 0) moving = 1;
  size /= moving;
  if (size == 0.0) size = across;
  double cell = 1.5 * size;
  if (horizon < kNever) {
    cell = size + path / moving * horizon;
  } else {
    // In a thin gas longer trajectories save more than larger cells cost.
    cell = std::clamp(1.1 * std::sqrt((all.high - all.low).prod() / moving), size, 4.0 * size);
  }
  const double crossing = fastest > 0.0 ? std::clamp(across / fastest, 1e-6, 1e6) : 1.0;
  epoch_length_ = std::exp2(std::ceil(std::log2(crossing)));
  reach_ = moving <= kFewBodies ? 4.0 * across : 0.6 * cell;
  grid_.reset(n, cell);
}

void EventDrivenImpacts::rebuild_all(const Step& step) {
  World& world = step.world;
  const int n = world.bodies();
  queue_.clear();
  for (BodyIndex i{0}; i < n; ++i) {
    if (world.trajectories.island_of(i) != kNoIsland) continue;
    const Eigen::Array2d x = world.trajectories.at_start(i).head<2>().array();
    grid_.put(i, {x - world.shapes().extent.col(i).array(), x + world.shapes().extent.col(i).array()});
  }
  for (const IslandIndex k : world.trajectories.islands()) rebuild(step, k);
}

void EventDrivenImpacts::search_all(const Step& step) {
  World& world = step.world;
  const int n = world.bodies();
  // Each pair once: from its movable body with the higher index, or from its only movable body.
  const SearchRules rules = search_rules(step);
  std::size_t left = BroadPhase::most_pairs(world.model->bodies());
  for (BodyIndex i{0}; i < n && left > 0; ++i) {
    if (world.infinite_mass(i)) continue;
    grid_.each_near(i, [&](BodyIndex other) {
      if (left == 0 || !(other < i || world.infinite_mass(other))) return;
      search(step, rules, i, other);
      if (--left == 0) world.note(&Notices::pairs_cut_since, world.clock.time);
    });
  }
}

void EventDrivenImpacts::rebuild(const Step& step, IslandIndex island) {
  Trajectories& trajectories = step.world.trajectories;
  const Geometry& shapes = step.world.shapes();
  trajectories.rebuild(island, step.horizon, stretch_ * reach_, stretch_ * Trajectories::kUsualTurn);
  trajectories.bound_curvature(island);
  const BodyIndex first = trajectories.members(island).front();
  const double begin = trajectories.start(first);
  const double end = trajectories.end(first);
  for (const BodyIndex i : trajectories.members(island)) {
    ++stamp_[i];
    const Eigen::Array2d from = trajectories.at_start(i).head<2>().array();
    const Eigen::Array2d to = trajectories.at_end(i).head<2>().array();
    const double left = end - begin;
    const Eigen::Array2d margin = shapes.extent.col(i).array() +
                                  trajectories.curvature_bound(i) * left * left / 8.0 +
                                  32.0 * kEpsilon * (from.abs() + to.abs());
    grid_.put(i, {from.min(to) - margin, from.max(to) + margin});
  }
  if (end < step.horizon) queue_.push({end, first, kNoBody, stamp_[first], 0});
}

void EventDrivenImpacts::rebuild_and_search(const Step& step, std::span<const IslandIndex> islands) {
  for (const IslandIndex island : islands) rebuild(step, island);
  for (const IslandIndex island : islands) search_island(step, island);
}

void EventDrivenImpacts::search_island(const Step& step, IslandIndex island) {
  World& world = step.world;
  const SearchRules rules = search_rules(step);
  std::int64_t neighbours = 0;
  for (const BodyIndex i : world.trajectories.members(island)) {
    grid_.each_near(i, [&](BodyIndex other) {
      if (world.infinite_mass(i) && world.infinite_mass(other)) return;
      ++neighbours;
      search(step, rules, i, other);
    });
  }
  // An impact of a few bodies is free: the number of impacts has its own limit.
  world.work.spend(std::max<std::int64_t>(0, neighbours - kFewNeighbours));
}

// Until the step is divided, from `from` on (s after the epoch).
SearchRules EventDrivenImpacts::search_rules(const Step& step, double from) const {
  return {end_of_step_, step.resting, closing_share(), from, end_of_disturbed(step), step.lands_first};
}

// Schedules the next impact of a and b on their trajectories, if there is one.
void EventDrivenImpacts::search(const Step& step, const SearchRules& rules, BodyIndex a, BodyIndex b) {
  World& world = step.world;
  if (a > b) std::swap(a, b);
  if (!world.can_collide(a, b)) return;
  if (step.resting != nullptr && step.resting->finder().needs_no_search(world, a, b)) return;
  if (world.work.spent()) {
    world.note(&Notices::work_spent_since, world.clock.time, {a, b});
    end_of_step_.add(a, b, false);
    return;
  }
  const Geometry& shapes = world.shapes();
  if (!shapes.has_parts(a) && !shapes.has_parts(b)) {
    const NextContact next = next_contact(world, rules, a, b, shapes.first_parts(a, b));
    if (next.kind != NextContact::kNone) schedule(step, a, b, next);
    return;
  }
  shapes.each_parts(a, b, [&](ShapeIndex part_a, ShapeIndex part_b) {
    schedule(step, a, b, next_contact(world, rules, a, b, {part_a, part_b}));
  });
}

void EventDrivenImpacts::schedule(const Step& step, BodyIndex a, BodyIndex b, const NextContact& next) {
  World& world = step.world;
  switch (next.kind) {
    case NextContact::kNone:
      break;
    case NextContact::kImpact:
      queue_.push({next.time, a, b, stamp_[a], stamp_[b]});
      break;
    case NextContact::kPressed:
      if (step.resting == nullptr) {
        world.note(&Notices::resting_since, world.trajectories.epoch() + next.time, {a, b});
      } else if (next.time == last_impact_ && moves_few(world) && may_end_at(step, next.time)) {
        // Hits have left them so: forces are to support them from now on.
        disturbed_ = next.time;
        break;
      }
      [[fallthrough]];
    case NextContact::kPenetrating:
      end_of_step_.add(a, b, next.kind == NextContact::kPressed);
      break;
  }
}

// The parts of a and b that touch at this time, of several those that approach fastest; nothing where others
// continue the surface, so that they do not touch there.
std::optional<ShapePair> EventDrivenImpacts::parts_that_meet(const Step& step, BodyIndex a, BodyIndex b,
                                                             double time) {
  World& world = step.world;
  Trajectories& trajectories = world.trajectories;
  const Geometry& shapes = world.shapes();
  near_.clear();
  grid_.each_near(world.infinite_mass(a) ? b : a, [&](BodyIndex other) {
    if (other != a && other != b) near_.push_back(other);
  });
  const auto motion = [&](BodyIndex i) {
    return trajectories.at(i, std::clamp(time, trajectories.start(i), trajectories.end(i)));
  };
  const auto pose = [&](BodyIndex i) { return shapes.pose(i, motion(i).head<3>()); };
  // Whether they do, though the nearest point of two faces that meet may be where another part continues one of
  // them.
  const auto is_bare = [&](const Contact& contact, const ShapePair& parts, double tolerance) {
    if (!on_internal_edge(world, a, b, contact, near_, pose)) return true;
    const double margin = std::max(contact.gap, 0.0) + kEndOfFace * tolerance;
    const Manifold ends = manifold(shapes, a, parts.a, pose(a), b, parts.b, pose(b), margin);
    return ends.count == 2 && std::abs(cross(ends.normal, contact.normal)) <= kTogether &&
           exposed_points(world, a, b, ends, near_, pose, [](const Contact&) {}).count > 0;
  };
  const bool single = !shapes.has_parts(a) && !shapes.has_parts(b);
  if (single && near_.empty()) return shapes.first_parts(a, b);
  const Motion of_a = motion(a);
  const Motion of_b = motion(b);
  const Twist twist_a{of_a.segment<2>(3), of_a[5]};
  const Twist twist_b{of_b.segment<2>(3), of_b[5]};
  const auto approach = [&](const ShapePair& parts, double tolerance) {
    return approach_of(shapes, a, of_a.head<3>(), twist_a, b, of_b.head<3>(), twist_b, tolerance, parts);
  };
  if (single) {
    const ShapePair parts = shapes.first_parts(a, b);
    const double tolerance = touch_tolerance(world, a, b);
    return is_bare(approach(parts, tolerance).contact, parts, tolerance) ? std::optional(parts) : std::nullopt;
  }
  // No less than that of the search, which has found them here.
  const double flight = std::min(trajectories.end(a), trajectories.end(b)) -
                        std::max(trajectories.start(a), trajectories.start(b));
  const double tolerance = touch_tolerance(world, a, b, flight);
  const SearchRules rules{end_of_step_, step.resting, 0.0, 0.0, kNever, false};
  std::optional<ShapePair> meet;
  double fastest = kNever;
  shapes.each_parts(a, b, [&](ShapeIndex part_a, ShapeIndex part_b) {
    const ShapePair parts{part_a, part_b};
    const Approach at = approach(parts, tolerance);
    if (at.contact.gap > closed_gap(world, step.resting, a, b, tolerance) || !(at.speed < fastest)) return;
    const bool rests = a < b ? rules.rests(a, b, parts) : rules.rests(b, a, {part_b, part_a});
    if (rests && -at.speed <= pressed_in(world, a, b, step.h)) return;
    if (!is_bare(at.contact, parts, tolerance)) return;
    fastest = at.speed;
    meet = parts;
  });
  return meet;
}

}  // namespace carom
