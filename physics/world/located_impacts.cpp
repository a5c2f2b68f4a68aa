#include <algorithm>
#include <cmath>
#include <limits>

#include "physics/collision/time_of_impact.h"
#include "physics/motion/integrators.h"
#include "physics/world/simulation.h"

// Impacts at their own time: the event queue of a simulation.
namespace carom {
namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
constexpr double kNever = std::numeric_limits<double>::infinity();
// Up to this many bodies a track that no step ends may cross the whole scene: every pair is looked at anyway.
constexpr int kFewBodies = 12;
// A run that has reached kMostImpactsPerStep once (a piston crushing an elastic disc, say) gets no more than
// this in each later step, so that it still goes on.
constexpr int kMostImpactsOnceCapped = 100'000;

}  // namespace

void Simulation::step_with_located_impacts(double h) {
  const IntegratorChoice& choice = choice_of(kIntegrators, method_.integrator);
  const bool steps = choice.order > 0 && !choice.adaptive;
  if (steps || !running_) {
    if (steps) tracks_.begin(time_);
    choose_cells(steps ? h : kNever);
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
  const double target = steps ? h : step_end_ - tracks_.epoch();
  process_until(target, horizon, h);

  // What rests or overlaps is held by impacts at the step's end.
  due_.swap(deferred_);
  deferred_.clear();
  if (steps) {
    for (int k = 0; k < tracks_.islands(); ++k) tracks_.settle(k, h);
  } else {
    for (const Deferred& d : due_) {
      for (const int i : {d.a, d.b}) {
        if (tracks_.island_of(i) >= 0) tracks_.settle(tracks_.island_of(i), target);
      }
    }
  }
  publish(target);
  if (due_.empty()) return;
  resolve_at_end(due_, h);
  for (const Deferred& d : due_) {
    for (const int i : {d.a, d.b}) {
      state_.set_motion(i, tracks_.at(i, target));
      if (!steps && tracks_.island_of(i) >= 0) lay(tracks_.island_of(i), horizon);
    }
  }
  if (steps) return;
  for (const Deferred& d : due_) {
    for (const int i : {d.a, d.b}) {
      if (tracks_.island_of(i) >= 0) search_island(tracks_.island_of(i));
    }
  }
}

// Cells about as large as what a body and its track cover.
void Simulation::choose_cells(double horizon) {
  double size = 0.0;
  double path = 0.0;
  int moving = 0;
  Bounds all{Eigen::Array2d::Constant(kNever), Eigen::Array2d::Constant(-kNever)};
  const int n = static_cast<int>(bodies_.size());
  for (int i = 0; i < n; ++i) {
    const Eigen::Array2d x = tracks_.settled(i).head<2>().array();
    const Eigen::Array2d extent = shapes_.extent.col(i).array();
    all.low = all.low.min(x - extent);
    all.high = all.high.max(x + extent);
    if (immovable(i)) continue;
    ++moving;
    size += 2.0 * extent.maxCoeff();
    path += tracks_.settled(i).segment<2>(3).norm();
  }
  const double across = n == 0 ? 1.0 : (all.high - all.low).matrix().norm();
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
  deferred_.clear();
  last_impact_ = -1.0;
  for (int i = 0; i < static_cast<int>(bodies_.size()); ++i) {
    if (tracks_.island_of(i) >= 0) continue;
    const Eigen::Array2d x = tracks_.settled(i).head<2>().array();
    grid_.put(i, {x - shapes_.extent.col(i).array(), x + shapes_.extent.col(i).array()});
  }
  for (int k = 0; k < tracks_.islands(); ++k) lay(k, horizon);
  // Each pair once: from its movable body of the higher index, or from the only movable one.
  for (int i = 0; i < static_cast<int>(bodies_.size()); ++i) {
    if (immovable(i)) continue;
    grid_.each_near(i, [&](int other) {
      if (other < i || immovable(other)) search(i, other);
    });
  }
}

// Lays an island's track anew and puts the bounds of its path into the grid.
void Simulation::lay(int island, double horizon) {
  tracks_.lay(island, horizon, reach_);
  tracks_.bound_bend(island);
  const int first = tracks_.members(island).front();
  const double begin = tracks_.start(first);
  const double end = tracks_.end(first);
  for (const int i : tracks_.members(island)) {
    ++stamp_[i];
    const Eigen::Array2d from = tracks_.settled(i).head<2>().array();
    const Eigen::Array2d to = tracks_.at_end(i).head<2>().array();
    const double left = end - begin;
    const Eigen::Array2d margin = shapes_.extent.col(i).array() + tracks_.bend(i) * left * left / 8.0 +
                                  32.0 * kEpsilon * (from.abs() + to.abs());
    grid_.put(i, {from.min(to) - margin, from.max(to) + margin});
  }
  if (end < horizon) queue_.push({end, first, -1, stamp_[first], 0});
}

void Simulation::search_island(int island) {
  for (const int i : tracks_.members(island)) {
    grid_.each_near(i, [&](int other) {
      if (!immovable(i) || !immovable(other)) search(i, other);
    });
  }
}

bool Simulation::is_stale(const Event& event) const {
  return stamp_[event.a] != event.stamp_a || (event.b >= 0 && stamp_[event.b] != event.stamp_b);
}

void Simulation::foresee(double time, int a, int b) { queue_.push({time, a, b, stamp_[a], stamp_[b]}); }

void Simulation::process_until(double target, double horizon, double h) {
  const std::int64_t crowd =
      kCrowdedImpacts + kCrowdedImpactsPerBody * static_cast<std::int64_t>(bodies_.size());
  const std::int64_t before = impacts_before_step_;
  while (!queue_.empty() && queue_.next().time <= target) {
    const Event next = queue_.next();
    queue_.pop();
    queue_.sweep([&](const Event& event) { return is_stale(event); });
    if (is_stale(next)) continue;
    if (next.b < 0) {
      const int island = tracks_.island_of(next.a);
      ledger_.lost_to_dampers += tracks_.settle_at_end(island);
      lay(island, horizon);
      search_island(island);
      continue;
    }
    const int most = notices_.impacts_capped_since < 0.0 ? kMostImpactsPerStep : kMostImpactsOnceCapped;
    if (impact_count_ - before >= most) {
      if (notices_.impacts_capped_since < 0.0) notices_.impacts_capped_since = tracks_.epoch() + next.time;
      defer(next.a, next.b, false);
      continue;
    }
    meet(next.a, next.b, next.time, horizon, impact_count_ - before >= crowd, h);
  }
}

// The impact of a foreseen pair.
void Simulation::meet(int a, int b, double time, double horizon, bool crowd, double h) {
  for (const int i : {a, b}) {
    if (tracks_.island_of(i) >= 0 && tracks_.start(i) != time) tracks_.settle(tracks_.island_of(i), time);
  }
  const Contact contact =
      contact_between(shapes_, a, tracks_.settled(a).head<3>(), b, tracks_.settled(b).head<3>());
  const Material& material = material_between(a, b);
  collide(a, b, contact, material, time);

  if (material.restitution < 1.0) {
    const double rebound =
        relative_velocity(side(a, contact, 1.0), side(b, contact, -1.0), contact.normal).normal;
    const double press = pressing(a, b, contact.normal, time);
    double rest = kRestSpeed;
    if (method_.integrator == IntegratorId::kExplicitEuler) {
      const double e = material.restitution;
      rest = std::max(rest, std::min(kRestRebound * e / (1.0 - e), kMostRestRebound) * press * h);
    }
    if (press > 0.0 && rebound < rest) {
      // Where the bounces that are left out can be summed up they would last that long.
      const bool exact = choice_of(kIntegrators, method_.integrator).exact_under_gravity;
      const double left = exact ? 2.0 * rebound / (press * (1.0 - material.restitution)) : 0.0;
      if (notices_.resting_since < 0.0) notices_.resting_since = tracks_.epoch() + time + left;
      defer(a, b, true);
    } else if (crowd && rebound < pressed_in(a, b, h)) {
      if (notices_.resting_since < 0.0) notices_.resting_since = tracks_.epoch() + time;
      defer(a, b, true);
    } else if (rebound < kCollapseShare * (tracks_.settled(a).segment<2>(3).norm() +
                                           tracks_.settled(b).segment<2>(3).norm()) &&
               time - last_impact_ <= 64.0 * kEpsilon * (std::abs(time) + h)) {
      if (notices_.collapsed_since < 0.0) notices_.collapsed_since = tracks_.epoch() + time;
    }
  }
  last_impact_ = time;

  const int island_a = tracks_.island_of(a);
  const int island_b = tracks_.island_of(b);
  if (island_a >= 0) lay(island_a, horizon);
  if (island_b >= 0 && island_b != island_a) lay(island_b, horizon);
  if (island_a >= 0) search_island(island_a);
  if (island_b >= 0 && island_b != island_a) search_island(island_b);
}

double Simulation::pressing(int a, int b, const Vec2& normal, double within) {
  const auto acceleration = [&](int i) -> Vec2 {
    if (driven_[i]) return drive_acceleration(*bodies_[i].drive, tracks_.epoch() + within);
    return tracks_.acceleration(i);
  };
  return -normal.dot(acceleration(b) - acceleration(a));
}

double Simulation::pressed_in(int a, int b, double h) const {
  return (tracks_.bend(a) + tracks_.bend(b)) * h + kRestSpeed;
}

// m: below this a gap is closed within rounding.
double Simulation::touch_tolerance(int a, int b, double end) const {
  const double time = std::max(std::abs(end), method_.step);
  const auto ya = tracks_.settled(a);
  const auto yb = tracks_.settled(b);
  const double reach = ya.head<2>().lpNorm<1>() + yb.head<2>().lpNorm<1>() + shapes_.extent.col(a).sum() +
                       shapes_.extent.col(b).sum();
  return 16.0 * kEpsilon * (reach + (ya.segment<2>(3).norm() + yb.segment<2>(3).norm()) * time);
}

void Simulation::defer(int a, int b, bool resting) {
  for (Deferred& d : deferred_) {
    if (d.a == a && d.b == b) {
      d.resting = d.resting || resting;
      return;
    }
  }
  deferred_.push_back({a, b, resting});
}

bool Simulation::rests(int a, int b) const {
  return !deferred_.empty() && std::any_of(deferred_.begin(), deferred_.end(), [&](const Deferred& d) {
    return d.a == a && d.b == b && d.resting;
  });
}

// Two discs on parabolas of one acceleration go straight relative to each other: the next impact in closed
// form.
void Simulation::search_discs(int a, int b, double start, double end) {
  const Vec2 d = (tracks_.parabola(b, start) - tracks_.parabola(a, start)).head<2>();
  const Vec2 va = tracks_.parabola_velocity(a, start).head<2>();
  const Vec2 vb = tracks_.parabola_velocity(b, start).head<2>();
  const Vec2 u = vb - va;
  const double touch = shapes_.rounding[a] + shapes_.rounding[b];
  const bool approach = d.dot(u) < 0.0;
  const bool apart = d.squaredNorm() > touch * touch;
  if (apart && !approach) return;
  const auto after = first_disc_contact(d, u, touch);
  if (apart && (!after || start + *after > end)) return;

  // A resting pair waits for the step's end, unless something drives it together.
  const auto waits = [&](double closing) { return rests(a, b) && closing <= pressed_in(a, b, method_.step); };
  const double tolerance = touch_tolerance(a, b, end);
  const double distance = d.norm();
  if (distance - touch <= tolerance) {
    const double closing = distance > 0.0 ? -d.dot(u) / distance : -u.x();
    if (closing > 16.0 * kEpsilon * (va.norm() + vb.norm())) {
      if (!waits(closing)) foresee(start, a, b);
    } else if (distance - touch < -tolerance) {
      defer(a, b, false);
    }
    return;
  }
  const Vec2 meeting = d + *after * u;
  if (!waits(-meeting.dot(u) / touch)) foresee(start + *after, a, b);
}

// Foresees the next impact of a and b on their tracks, if there is one.
void Simulation::search(int a, int b) {
  if (a > b) std::swap(a, b);
  if (tracks_.are_pinned(a, b)) return;
  double start = std::max(tracks_.start(a), tracks_.start(b));
  const double end = std::min(tracks_.end(a), tracks_.end(b));
  if (!(start <= end)) return;
  const bool parabolic = tracks_.is_parabolic() && !driven_[a] && !driven_[b];
  if (parabolic && shapes_.half.col(a).isZero(0.0) && shapes_.half.col(b).isZero(0.0) &&
      tracks_.constant_acceleration(a).head<2>() == tracks_.constant_acceleration(b).head<2>()) {
    search_discs(a, b, start, end);
    return;
  }

  const auto pose = [&](int i, double t) -> Eigen::Vector3d {
    if (parabolic) return tracks_.parabola(i, t);
    return tracks_.at(i, t).head<3>();
  };
  const auto velocity = [&](int i, double t) -> Vec2 {
    if (parabolic) return tracks_.parabola_velocity(i, t).head<2>();
    return tracks_.at(i, t).segment<2>(3);
  };
  const auto sample = [&](double t) {
    const Eigen::Vector3d qa = pose(a, t);
    const Eigen::Vector3d qb = pose(b, t);
    const Contact c = contact_between(shapes_, a, qa, b, qb);
    return GapSample{c.gap, c.normal, (qb - qa).head<2>()};
  };
  const double tolerance = touch_tolerance(a, b, end);
  const bool resting = rests(a, b);
  const auto waits = [&](double closing) { return resting && closing <= pressed_in(a, b, method_.step); };
  const double bend =
      parabolic ? (tracks_.constant_acceleration(b) - tracks_.constant_acceleration(a)).head<2>().norm()
                : tracks_.bend(a) + tracks_.bend(b);
  GapSample first = sample(start);
  if (first.gap <= tolerance) {
    const Vec2 va = velocity(a, start);
    const Vec2 vb = velocity(b, start);
    const double u = first.normal.dot(vb - va);
    if (waits(-u)) return;
    if (u < -16.0 * kEpsilon * (va.norm() + vb.norm())) {
      foresee(start, a, b);
      return;
    }
    if (bend == 0.0) {
      if (first.gap < -tolerance) defer(a, b, false);
      return;
    }
    // They part at speed u and cannot be back before 2u/bend: search from the half of that on.
    const double began = start;
    start += std::max(u, 0.0) / bend;
    if (start >= end) return;
    const bool touching = first.gap >= -tolerance;
    first = sample(start);
    if (first.gap <= tolerance) {
      const bool pressed = pressing(a, b, first.normal, start) > 0.0;
      if (touching && pressed && notices_.resting_since < 0.0) notices_.resting_since = tracks_.epoch() + began;
      defer(a, b, touching && pressed);
      return;
    }
  }
  const GapSample last = sample(end);
  if (const auto time = first_contact(sample, start, first, end, last, bend, tolerance)) {
    if (resting) {
      const Vec2 u = velocity(b, *time) - velocity(a, *time);
      if (waits(-sample(*time).normal.dot(u))) return;
    }
    foresee(*time, a, b);
  }
}

}  // namespace carom
