#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "physics/dynamics/integrators/integrators.h"
#include "physics/world/simulation.h"

// Impacts at their own time: the event queue of a simulation.
namespace carom {
namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
constexpr double kNever = std::numeric_limits<double>::infinity();
// Up to this many bodies a track that no step ends may cross the whole scene: every pair is looked at anyway.
constexpr int kFewBodies = 12;
// A run that has reached kMostImpactsPerStep or kMostImpactsAtOnce once (a piston crushing an elastic disc,
// say) gets no more than these in each later step, so that it still goes on.
constexpr int kMostImpactsOnceCapped = 20'000;
constexpr int kMostImpactsAtOnceCapped = 1'000;
// Of a step: two times of one landing, found in two ways, differ by less.
constexpr double kSameTime = 1e-9;
// Tracks that end in one step, beside some of each body, before they become twice as long: what flies or turns
// far faster than the scene is large would end millions.
constexpr int kMostTrackEnds = 1'000;
constexpr int kMostTrackEndsPerBody = 20;
// Searches after an impact that come for free.
constexpr std::int64_t kFewNeighbours = 16;
// Epochs in one step, at the most.
constexpr double kMostEpochs = 1024.0;

}  // namespace

void Simulation::step_with_located_impacts(double h) {
  const IntegratorChoice& choice = choice_of(kIntegrators, method_.integrator);
  const bool steps = lasts_ || (choice.order > 0 && !choice.adaptive);
  track_ends_ = 0;
  if (steps || !running_) {
    if (steps) tracks_.begin(time_);
    choose_cells(steps ? h : kNever);
    epoch_length_ = std::max(epoch_length_, std::exp2(std::ceil(std::log2(h / kMostEpochs))));
    deferred_.clear();
    last_impact_ = -1.0;
    stretch_ = 1.0;
    lay_all(steps ? h : kNever);
    running_ = true;
  }
  const double horizon = steps ? h : kNever;
  // Where tracks run on, the epoch follows in leaps that don't depend on h: times stay small, and with them the
  // rounding of each impact's time, which would add up over millions of bounces.
  while (!steps && step_end_ - tracks_.epoch() > epoch_length_) {
    process_until(epoch_length_, horizon, h);
    tracks_.shift_epoch(epoch_length_);
    queue_.shift(epoch_length_);
    last_impact_ -= epoch_length_;
  }
  double left = h;
  if (lasts_) {
    left = process_holding(h);
  } else {
    process_until(steps ? h : step_end_ - tracks_.epoch(), horizon, h);
  }
  const double target = steps ? left : step_end_ - tracks_.epoch();

  // What rests or overlaps is held by impacts at the step's end.
  due_.swap(deferred_);
  deferred_.clear();
  const std::vector<WaitingPair>& due = due_.all();
  if (steps) {
    for (int k = 0; k < tracks_.islands(); ++k) tracks_.settle(k, left);
  } else {
    find_due_islands(due);
    for (const int island : due_islands_) tracks_.settle(island, target);
  }
  if (lasts_) {
    for (const WaitingPair& d : due) lasting_.holds.emplace_back(d.a, d.b);
    rebound_at_end(lasting_.holds);
  }
  publish(target);
  if (lasts_ || due.empty()) return;
  check_motions();
  resolve_at_end(due, h);
  if (std::any_of(due.begin(), due.end(), [&](const WaitingPair& d) { return !shapes().can_meet(d.a, d.b); })) {
    // Bodies have stuck together: islands are others.
    publish(target);
    running_ = false;
    return;
  }
  for (const WaitingPair& d : due) {
    for (const int i : {d.a, d.b}) state_.set_motion(i, tracks_.at(i, target));
  }
  if (!steps) go_on(due_islands_, horizon);
}

// The islands of these pairs, each once, in the order in which they come.
void Simulation::find_due_islands(const std::vector<WaitingPair>& due) {
  due_islands_.clear();
  is_due_.assign(static_cast<std::size_t>(tracks_.islands()), false);
  for (const WaitingPair& d : due) {
    for (const int i : {d.a, d.b}) {
      const int island = tracks_.island_of(i);
      if (island < 0 || is_due_[static_cast<std::size_t>(island)]) continue;
      is_due_[static_cast<std::size_t>(island)] = true;
      due_islands_.push_back(island);
    }
  }
}

// A step with contacts that last. What touches down within it is held from that moment on: there the step is
// divided, up to kMostHolds times. The length in s of its last part, from the epoch on.
double Simulation::process_holding(double h) {
  double left = h;
  for (int parts = 1;; ++parts) {
    touched_down_ = -1.0;
    may_divide_ = parts < kMostHolds;
    Landing landing;
    const double until = may_divide_ ? first_landing(left, landing) : left;
    process_until(until, left, left, until < left ? &landing : nullptr);
    const bool lands = touched_down_ < 0.0 && until < left;
    if (lands) touched_down_ = until;
    const double passed = touched_down_ >= 0.0 ? touched_down_ : left;
    book_contact_forces(passed, passed / left);
    if (touched_down_ < 0.0) return left;
    for (int k = 0; k < tracks_.islands(); ++k) tracks_.settle(k, passed);
    if (lands) land(landing, passed);
    publish(passed);
    left -= passed;
    tracks_.begin(step_end_ - left);
    hold_contacts(left);
    choose_cells(left);
    deferred_.clear();
    last_impact_ = -1.0;
    lay_all(left);
  }
}

// Cells about as large as what a body and its track cover.
void Simulation::choose_cells(double horizon) {
  double size = 0.0;
  double path = 0.0;
  int moving = 0;
  Bounds all{Eigen::Array2d::Constant(kNever), Eigen::Array2d::Constant(-kNever)};
  const int n = static_cast<int>(bodies().size());
  for (int i = 0; i < n; ++i) {
    const Eigen::Array2d x = tracks_.settled(i).head<2>().array();
    const Eigen::Array2d extent = shapes().extent.col(i).array();
    if (!extent.allFinite()) continue;
    all.low = all.low.min(x - extent);
    all.high = all.high.max(x + extent);
    if (immovable(i)) continue;
    ++moving;
    size += 2.0 * extent.maxCoeff();
    path += tracks_.settled(i).segment<2>(3).norm();
  }
  const bool finite = (all.high >= all.low).all();  // something but half-planes is there
  const double across = finite ? (all.high - all.low).matrix().norm() : 1.0;
  if (moving == 0) moving = 1;
  size /= moving;
  if (size == 0.0) size = across;
  double cell = 1.5 * size;
  if (horizon < kNever) {
    cell = size + path / moving * horizon;
  } else {
    // In a thin gas longer tracks save more than larger cells cost.
    cell = std::clamp(1.1 * std::sqrt((all.high - all.low).prod() / moving), size, 4.0 * size);
  }
  const double crossing = path > 0.0 ? std::clamp(across * moving / path, 1e-6, 1e6) : 1.0;
  epoch_length_ = std::exp2(std::ceil(std::log2(crossing)));
  reach_ = moving <= kFewBodies ? 4.0 * across : 0.6 * cell;
  grid_.reset(n, cell);
}

void Simulation::lay_all(double horizon) {
  queue_.clear();
  for (int i = 0; i < static_cast<int>(bodies().size()); ++i) {
    if (tracks_.island_of(i) >= 0) continue;
    const Eigen::Array2d x = tracks_.settled(i).head<2>().array();
    grid_.put(i, {x - shapes().extent.col(i).array(), x + shapes().extent.col(i).array()});
  }
  for (int k = 0; k < tracks_.islands(); ++k) lay(k, horizon);
  // Each pair once: from its movable body of the higher index, or from the only movable one.
  std::size_t left = BroadPhase::most_pairs(bodies().size());
  for (int i = 0; i < static_cast<int>(bodies().size()) && left > 0; ++i) {
    if (immovable(i)) continue;
    grid_.each_near(i, [&](int other) {
      if (left == 0 || !(other < i || immovable(other))) return;
      search(i, other);
      if (--left == 0) note(&Notices::pairs_cut_since, time_);
    });
  }
}

// Lays an island's track anew and puts the bounds of its path into the grid.
void Simulation::lay(int island, double horizon) {
  tracks_.lay(island, horizon, stretch_ * reach_, stretch_ * Tracks::kUsualTurn);
  tracks_.bound_bend(island);
  const int first = tracks_.members(island).front();
  const double begin = tracks_.start(first);
  const double end = tracks_.end(first);
  for (const int i : tracks_.members(island)) {
    ++stamp_[i];
    const Eigen::Array2d from = tracks_.settled(i).head<2>().array();
    const Eigen::Array2d to = tracks_.at_end(i).head<2>().array();
    const double left = end - begin;
    const Eigen::Array2d margin = shapes().extent.col(i).array() + tracks_.bend(i) * left * left / 8.0 +
                                  32.0 * kEpsilon * (from.abs() + to.abs());
    grid_.put(i, {from.min(to) - margin, from.max(to) + margin});
  }
  if (end < horizon) queue_.push({end, first, -1, stamp_[first], 0});
}

void Simulation::search_island(int island) {
  std::int64_t neighbours = 0;
  for (const int i : tracks_.members(island)) {
    grid_.each_near(i, [&](int other) {
      if (immovable(i) && immovable(other)) return;
      ++neighbours;
      search(i, other);
    });
  }
  // An impact of a few bodies costs nothing of it: their number has a limit of its own.
  work_.spend(std::max<std::int64_t>(0, neighbours - kFewNeighbours));
}

bool Simulation::is_stale(const Event& event) const {
  return stamp_[event.a] != event.stamp_a || (event.b >= 0 && stamp_[event.b] != event.stamp_b);
}

void Simulation::foresee(double time, int a, int b) { queue_.push({time, a, b, stamp_[a], stamp_[b]}); }

void Simulation::process_until(double target, double horizon, double h, const Landing* awaited) {
  const std::int64_t crowd =
      kCrowdedImpacts + kCrowdedImpactsPerBody * static_cast<std::int64_t>(bodies().size());
  const std::int64_t before = impacts_before_step_;
  const int most_track_ends = kMostTrackEnds + kMostTrackEndsPerBody * static_cast<int>(bodies().size());
  while (!queue_.empty() && queue_.next().time <= target) {
    const Event next = queue_.next();
    queue_.pop();
    queue_.sweep([&](const Event& event) { return is_stale(event); });
    if (is_stale(next)) continue;
    work_.pass(5);
    // Foreseen here too, and only rounding could say which comes first.
    if (awaited != nullptr && awaited->a == std::min(next.a, next.b) &&
        awaited->b == std::max(next.a, next.b) && target - next.time <= kSameTime * h) {
      continue;
    }
    if (next.b < 0) {
      const int island = tracks_.island_of(next.a);
      ledger_.lost_to_dampers += tracks_.settle_at_end(island);
      if (++track_ends_ % most_track_ends == 0) stretch_ *= 2.0;
      lay(island, horizon);
      search_island(island);
      continue;
    }
    const bool capped = notices_.impacts_capped_since >= 0.0;
    const int most_at_once = capped                               ? kMostImpactsAtOnceCapped
                             : has_moving_corners(next.a, next.b) ? kMostCornersAtOnce
                                                                  : kMostImpactsAtOnce;
    const bool at_once = next.time == last_impact_ && at_once_ >= most_at_once;
    if (work_.spent()) {
      note(&Notices::work_spent_since, tracks_.epoch() + next.time);
      deferred_.add(next.a, next.b, false);
      continue;
    }
    if (at_once || impact_count_ - before >= (capped ? kMostImpactsOnceCapped : kMostImpactsPerStep)) {
      if (notices_.impacts_capped_since < 0.0) notices_.impacts_capped_since = tracks_.epoch() + next.time;
      deferred_.add(next.a, next.b, false);
      continue;
    }
    meet(next.a, next.b, next.time, horizon, impact_count_ - before >= crowd, h);
    if (touched_down_ >= 0.0) return;
  }
}

// The impact of a foreseen pair.
void Simulation::meet(int a, int b, double time, double horizon, bool crowd, double h) {
  if (!crowd && model_->scene.several_impacts == SeveralImpactsId::kSimultaneous &&
      meet_all(a, b, time, horizon, crowd, h))
    return;
  for (const int i : {a, b}) {
    if (tracks_.island_of(i) >= 0 && tracks_.start(i) != time) tracks_.settle(tracks_.island_of(i), time);
  }
  const Contact contact = approach(a, b, touch_tolerance(a, b, time)).contact;
  const Material& material = material_between(a, b);
  collide(a, b, contact, material, time);
  if (!shapes().can_meet(a, b)) {
    // They have stuck together: islands are others, and all of them start now.
    last_impact_ = time;
    lay_all(horizon);
    return;
  }
  judge(a, b, contact, material, time, crowd, h);
  at_once_ = time == last_impact_ ? at_once_ + 1 : 0;
  if (at_once_ == kMostAtOnce && notices_.collapsed_since < 0.0)
    notices_.collapsed_since = tracks_.epoch() + time;
  last_impact_ = time;
  const int island_a = tracks_.island_of(a);
  const int island_b = tracks_.island_of(b);
  if (island_a >= 0 && island_b >= 0 && island_a != island_b) {
    go_on(std::array{island_a, island_b}, horizon);
  } else {
    go_on(std::array{std::max(island_a, island_b)}, horizon);
  }
}

void Simulation::judge(int a, int b, const Contact& contact, const Material& material, double time, bool crowd,
                       double h) {
  if (!(material.restitution < 1.0)) return;
  const double rebound =
      relative_velocity(side(a, contact, 1.0), side(b, contact, -1.0), contact.normal).normal;
  const double press = pressing(a, b, contact, time);
  double rest = kRestSpeed;
  if (method_.integrator == IntegratorId::kExplicitEuler) {
    const double e = material.restitution;
    rest = std::max(rest, std::min(kRestRebound * e / (1.0 - e), kMostRestRebound) * press * h);
  }
  if (lasts_) rest = std::max(rest, rest_speed(a, b, contact.normal, material.restitution));
  if (press > 0.0 && rebound < rest) {
    if (lasts_ && may_divide_ && time < h) touched_down_ = time;
    // Where the bounces that are left out can be summed up they would last that long.
    const bool exact = choice_of(kIntegrators, method_.integrator).exact_under_gravity;
    const double left = exact ? 2.0 * rebound / (press * (1.0 - material.restitution)) : 0.0;
    note_resting(tracks_.epoch() + time + left);
    deferred_.add(a, b, true);
  } else if (crowd && rebound < pressed_in(a, b, h)) {
    note_resting(tracks_.epoch() + time);
    deferred_.add(a, b, true);
  } else if (rebound < kCollapseShare * (tracks_.settled(a).segment<2>(3).norm() +
                                         tracks_.settled(b).segment<2>(3).norm()) &&
             time - last_impact_ <= 64.0 * kEpsilon * (std::abs(time) + h)) {
    if (notices_.collapsed_since < 0.0) notices_.collapsed_since = tracks_.epoch() + time;
  }
}

void Simulation::go_on(std::span<const int> islands, double horizon) {
  for (const int island : islands) lay(island, horizon);
  for (const int island : islands) search_island(island);
}

}  // namespace carom
