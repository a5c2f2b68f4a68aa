#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

#include "physics/collision/pair_contact.h"
#include "physics/math/sort_unique.h"
#include "physics/model/pair_size.h"
#include "physics/step/event_driven_impacts.h"
#include "physics/step/internal_edges.h"
#include "physics/step/pair_motion.h"

// Impacts of several pairs at one time.
namespace carom {
namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
// Times the rounding of a gap and of a time: impacts that are nearer in time are at one time. Bodies that have
// slid for many steps have gathered the rounding of each.
constexpr double kRoundings = 1024.0;
// Work of the law for several contacts in a step, of a problem with n unknowns n³, and impacts of one moment:
// what piles up goes on pair by pair then, with no symmetry left to keep.
constexpr std::int64_t kMostWork = 300'000;
constexpr std::size_t kMostOfMoment = 256;
// Of a step: the rounding of a gap puts a slow impact off by no more.
constexpr double kMostOff = 2e-10;

// The islands of these bodies, in rising order.
std::vector<IslandIndex> islands_of(const Trajectories& trajectories, const std::vector<BodyIndex>& bodies) {
  std::vector<IslandIndex> islands;
  for (const BodyIndex i : bodies) {
    const IslandIndex island = trajectories.island_of(i);
    if (island == kNoIsland || std::find(islands.begin(), islands.end(), island) != islands.end()) continue;
    islands.push_back(island);
  }
  std::sort(islands.begin(), islands.end());
  return islands;
}

// s: what rounding puts the moments of impacts at this time apart, with slow impacts by `off` s.
double apart(double time, double h, double off) { return kRoundings * (kEpsilon * (std::abs(time) + h) + off); }

// The motion of a body at this time, or as near to it as its trajectory is known.
Motion motion_at(Trajectories& trajectories, BodyIndex body, double time) {
  return trajectories.at(body, std::clamp(time, trajectories.start(body), trajectories.end(body)));
}

}  // namespace

// Puts the contacts of two bodies at `time` on the list, if they touch; near_ are the bodies near one of them.
// Whether they do.
bool EventDrivenImpacts::find_touches(const Step& step, BodyIndex a, BodyIndex b, double time) {
  World& world = step.world;
  Trajectories& trajectories = world.trajectories;
  const Geometry& shapes = world.shapes();
  if (a > b) std::swap(a, b);
  if (!world.can_collide(a, b)) return false;
  const Motion of_a = motion_at(trajectories, a, time);
  const Motion of_b = motion_at(trajectories, b, time);
  const Eigen::Vector3d qa = of_a.head<3>();
  const Eigen::Vector3d qb = of_b.head<3>();
  const double tolerance = closed_gap(world, step.resting, a, b, kRoundings * touch_tolerance(world, a, b));
  if (!may_be_continued(world, a, b)) {
    const Contact contact = contact_between(shapes, a, qa, b, qb);
    if (contact.gap <= tolerance) cluster_.add(a, b, contact);
    return contact.gap <= tolerance;
  }
  const auto pose = [&](BodyIndex i) { return shapes.pose(i, motion_at(trajectories, i, time).head<3>()); };
  // What is flush lands together.
  const double margin = tolerance + kTogether * pair_size(shapes, a, b);
  found_.clear();
  bool touch = false;
  each_manifold(shapes, a, shapes.pose(a, qa), b, shapes.pose(b, qb), margin, [&](const Manifold& ends) {
    int count = 0;
    for (int k = 0; k < ends.count; ++k) {
      const Contact contact = ends.contact(k);
      if (contact.gap > margin || on_internal_edge(world, a, b, contact, near_, pose)) continue;
      ++count;
      touch = touch || contact.gap <= tolerance;
      found_.push_back(contact);
    }
    // One point may be where tips meet.
    if (count == 0) return;
    const Contact last = found_.back();
    if (count == 2 && (found_[found_.size() - 2].point - last.point).norm() > margin) return;
    const Contact tips =
        approach_of(shapes, a, qa, {of_a.segment<2>(3), of_a[5]}, b, qb, {of_b.segment<2>(3), of_b[5]},
                    tolerance, shapes.parts_or_first(last.parts, a, b))
            .contact;
    if ((tips.point - last.point).norm() > margin || on_internal_edge(world, a, b, tips, near_, pose)) return;
    if (count == 2) found_.pop_back();
    found_.back() = tips;
  });
  if (!touch) return false;
  for (const Contact& contact : found_) cluster_.add(a, b, contact);
  return true;
}

// Outwards from the pair, over bodies that move and what is joined to them.
void EventDrivenImpacts::find_touching(const Step& step, BodyIndex a, BodyIndex b, double time) {
  const World& world = step.world;
  cluster_.clear();
  reached_.assign({a, b});
  for (std::size_t k = 0; k < reached_.size(); ++k) {
    const BodyIndex body = reached_[k];
    if (world.infinite_mass(body)) continue;
    if (world.trajectories.is_jointed(body)) {
      for (const BodyIndex member : world.trajectories.members(world.trajectories.island_of(body))) {
        if (std::find(reached_.begin(), reached_.end(), member) == reached_.end()) reached_.push_back(member);
      }
    }
    near_.clear();
    grid_.each_near(body, [&](BodyIndex other) { near_.push_back(other); });
    for (const BodyIndex other : near_) {
      const auto known = std::find(reached_.begin(), reached_.end(), other);
      // Pairs of which the other one has been looked at are there already.
      if (known < reached_.begin() + static_cast<std::ptrdiff_t>(k) && !world.infinite_mass(other)) continue;
      if (find_touches(step, body, other, time) && known == reached_.end()) reached_.push_back(other);
    }
  }
}

void EventDrivenImpacts::find_moment(const Step& step) {
  const Event next = queue_.next();
  queue_.pop();
  queue_.sweep([&](const Event& event) { return is_stale(event); });
  moment_.clear();
  moment_.push_back(next);
  if (next.b < 0) return;
  const double most = next.time + apart(next.time, step.h, kMostOff * step.h);
  const bool at_end = most > step.horizon;
  if (!at_end && (queue_.empty() || queue_.next().time > most)) return;
  const double until = end_of_moment(step, next, next.time);
  later_.clear();
  while (!queue_.empty() && queue_.next().time <= most && queue_.next().b >= 0) {
    const Event event = queue_.next();
    queue_.pop();
    if (is_stale(event)) continue;
    const bool belongs = event.time <= until || event.time <= end_of_moment(step, event, next.time);
    (belongs ? moment_ : later_).push_back(event);
  }
  for (const Event& event : later_) queue_.push(event);
  if (at_end && until > step.horizon) add_unscheduled(step, next);
  std::sort(moment_.begin() + 1, moment_.end(),
            [](const Event& x, const Event& y) { return std::tie(x.a, x.b) > std::tie(y.a, y.b); });
  std::rotate(moment_.begin(), moment_.begin() + 1, moment_.end());
}

void EventDrivenImpacts::add_unscheduled(const Step& step, const Event& first) {
  World& world = step.world;
  find_touching(step, first.a, first.b, first.time);
  cluster_.keep_closing([&](BodyIndex i) { return motion_at(world.trajectories, i, first.time); });
  for (const ImpactCluster::Touch& touch : cluster_.touches()) {
    const bool is_known = std::any_of(moment_.begin(), moment_.end(), [&](const Event& event) {
      return std::minmax(event.a, event.b) == std::minmax(touch.a, touch.b);
    });
    const bool rests =
        step.resting != nullptr && step.resting->finder().needs_no_search(world, touch.a, touch.b);
    if (!is_known && !rests)
      moment_.push_back({first.time, touch.a, touch.b, stamp_[touch.a], stamp_[touch.b]});
  }
}

// s after the epoch: until when impacts are at one moment with one at `time`, as far as rounding puts this one
// off.
double EventDrivenImpacts::end_of_moment(const Step& step, const Event& impact, double time) {
  const World& world = step.world;
  const auto velocity = [&](BodyIndex i) { return world.trajectories.at_start(i).segment<2>(3); };
  const double speed = (velocity(impact.b) - velocity(impact.a)).norm();
  const double off = std::min(touch_tolerance(world, impact.a, impact.b) / speed, kMostOff * step.h);
  return time + apart(time, step.h, off);
}

double EventDrivenImpacts::end_of_disturbed(const Step& step) const {
  return disturbed_ ? *disturbed_ + apart(*disturbed_, step.h, kMostOff * step.h)
                    : std::numeric_limits<double>::infinity();
}

void EventDrivenImpacts::find_closing(const Step& step, BodyIndex a, BodyIndex b, double time) {
  World& world = step.world;
  cluster_.clear();
  if (at_once_work_ > kMostWork) return;
  find_due(step, a, b, time);
  if (cluster_.touches().empty()) return;
  cluster_.keep_closing(world, a, b, [&](BodyIndex i) { return motion_at(world.trajectories, i, time); });
  if (cluster_.only_one_left() != nullptr) return;
  if (!cluster_.has_several(world) || cluster_.touches().size() > 2 * kMostTogether) {
    cluster_.clear();
  } else if (!cluster_.has_law(world)) {
    world.note(&Notices::order_decided_since, world.trajectories.epoch() + time, {a, b});
    cluster_.clear();
  }
}

// Impacts without restitution and friction set each other off without end, halving what is left: each is a
// projection of the velocities, in the metric of the masses, onto those that keep its pair apart. One after the
// other they lead to the projection onto those that keep all pairs apart (J. von Neumann, Functional Operators
// II, 1950), which is what they do at once. Fills cluster_ with the touches of this kind that are connected
// with the pair; false if there are no several, or too many.
bool EventDrivenImpacts::find_of_clay(const Step& step, BodyIndex a, BodyIndex b, double time) {
  World& world = step.world;
  const auto of_clay = [&world](const Contact& contact, BodyIndex c, BodyIndex d) {
    return is_of_clay(world.material(contact, c, d));
  };
  if (at_once_work_ > kMostWork || !of_clay({}, a, b)) return false;
  find_touching(step, a, b, time);
  cluster_.keep_connected_of(world, a, b, of_clay);
  return cluster_.touches().size() <= kMostTogether && cluster_.has_several(world);
}

void EventDrivenImpacts::find_due(const Step& step, BodyIndex a, BodyIndex b, double time) {
  World& world = step.world;
  due_.clear();
  if (moment_.size() > kMostOfMoment) return;
  for (const Event& event : moment_) {
    if (!is_stale(event)) due_.emplace_back(std::min(event.a, event.b), std::max(event.a, event.b));
  }
  // Shapes of one body may land together, each with its own surface.
  const bool have_parts = world.shapes().has_parts(a) || world.shapes().has_parts(b);
  if (due_.empty() && !have_parts) return;
  due_.emplace_back(std::min(a, b), std::max(a, b));
  keep_connected(world, a, b, due_);
  if ((due_.size() < 2 && !have_parts) || due_.size() > kMostTogether) return;
  sort_unique(due_);
  for (const auto& [c, d] : due_) {
    near_.clear();
    if (may_be_continued(world, c, d))
      grid_.each_near(world.infinite_mass(c) ? d : c, [&](BodyIndex other) { near_.push_back(other); });
    find_touches(step, c, d, time);
  }
}

std::optional<bool> EventDrivenImpacts::resolve_at_once(const Step& step, BodyIndex a, BodyIndex b,
                                                        double time) {
  World& world = step.world;
  Trajectories& trajectories = world.trajectories;
  const bool all = takes_touches(world);
  if (all) {
    find_touching(step, a, b, time);
    if (!cluster_.has_law(world)) {
      if (cluster_.has_several(world))
        world.note(&Notices::order_decided_since, world.trajectories.epoch() + time, {a, b});
      cluster_.clear();
    }
  } else if (!find_of_clay(step, a, b, time)) {
    find_closing(step, a, b, time);
  }
  const ImpactCluster::Touch* only = cluster_.only_one_left();
  if (cluster_.touches().size() < 2 && only == nullptr) return std::nullopt;
  if (!all) at_once_work_ += cluster_.work(world);
  const std::vector<IslandIndex> islands = islands_of(trajectories, cluster_.find_bodies());
  for (const IslandIndex island : islands) {
    if (trajectories.start(trajectories.members(island).front()) != time) trajectories.advance_to(island, time);
  }
  if (only != nullptr) {
    rebuild_and_search(step, islands);
    return resolve_alone(step, only->a, only->b, only->contact, time, false);
  }
  for (ImpactCluster::Touch& touch : cluster_.touches())
    touch.rests = !all && comes_to_rest(step, touch.a, touch.b, touch.contact);
  if (!cluster_.resolve(world, time, all ? ClusterRestitution::kSmallest : ClusterRestitution::kOwn)) {
    rebuild_and_search(step, islands);
    if (const ImpactCluster::Touch* alone = cluster_.acts_alone())
      return resolve_alone(step, alone->a, alone->b, alone->contact, time, false);
    return std::nullopt;
  }
  bool divides = false;
  for (std::size_t k = 0; k < cluster_.touches().size(); ++k) {
    const auto& [i, j, contact, rests] = cluster_.touches()[k];
    if (!(cluster_.impacts()[k].normal > 0.0)) continue;
    divides |= classify_rebound(step, i, j, contact, rests, time, false);
    note_disturbed(step, i, j, time);
  }
  count_at_once(world, a, b, time);
  rebuild_and_search(step, islands);
  return divides;
}

}  // namespace carom
