#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "physics/collision/turning_pair.h"
#include "physics/world/simulation.h"

// When the next impact of two bodies on their tracks is, if there is one.
namespace carom {
namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
// Looks at a pair in one search, far more than a hard one needs. Where forces change much within a
// step the bound on how a path bends can be so large that a search would not end.
constexpr int kMostLooks = 20'000;
// At a pair that is held or rests, whose gap stays near zero: what is missed is resolved at the step's end.
constexpr int kMostLooksAtHeld = 200;

// What a look costs, in units of StepWork; an evaluation of a right-hand side costs half a unit.
constexpr std::int64_t kLookWork = 10;

// A pair whose looks are paid for from the step's budget; at its end so is the search. Where no corners turn
// the first kShort looks come from the run's reserve.
template <class Pair>
class Paid {
 public:
  Paid(const Pair& pair, const Tracks& tracks, bool corners, StepWork& work, SearchLimit& limit)
      : pair_(pair), tracks_(tracks), short_(corners ? 0 : kShort), work_(work), limit_(limit) {}
  [[nodiscard]] TurningSample operator()(double t) const {
    const std::int64_t flown = tracks_.flight_work();
    const TurningSample sample = pair_(t);
    const std::int64_t units = kLookWork + (tracks_.flight_work() - flown) / 2;
    if (short_ > 0) {
      --short_;
      work_.spend_reserve(units);
    } else {
      work_.spend(units);
    }
    if (work_.spent()) limit_.looks = 0;
    return sample;
  }
  [[nodiscard]] double separation(const Vec2& n, const TurningSample& at) const {
    return pair_.separation(n, at);
  }
  [[nodiscard]] bool clear(const TurningSample& from, const TurningSample& to, double width) const {
    return pair_.clear(from, to, width);
  }

 private:
  static constexpr int kShort = 16;
  const Pair& pair_;
  const Tracks& tracks_;
  mutable int short_;
  StepWork& work_;
  SearchLimit& limit_;
};

}  // namespace

double Simulation::pressing(int a, int b, const Contact& contact, double within) {
  const auto acceleration = [&](int i) -> Eigen::Vector3d {
    if (!model_->driven[i]) return tracks_.acceleration(i);
    const Vec2 driven = drive_acceleration(*bodies()[i].drive, tracks_.epoch() + within);
    return {driven.x(), driven.y(), 0.0};
  };
  const Eigen::Vector3d acceleration_a = acceleration(a);
  const Eigen::Vector3d acceleration_b = acceleration(b);
  if (!has_moving_corners(a, b)) return -contact.normal.dot((acceleration_b - acceleration_a).head<2>());

  // Where corners move, the point of contact wanders over the surfaces: the second difference of the gap, along
  // the flight from here on, knows it all. It is taken over as long as the gap's rounding allows.
  double bend = 0.0;
  for (const auto& [i, by] : {std::pair(a, acceleration_a), std::pair(b, acceleration_b)}) {
    bend += by.head<2>().norm();
    if (!immovable(i)) bend += turning_curvature(shapes().shapes, i, tracks_.settled(i)[5], by[2]);
  }
  if (bend == 0.0) return 0.0;
  const double wait = std::min(method_.step, std::sqrt(2e4 * touch_tolerance(a, b, within) / bend));
  const auto flown = [&](int i, const Eigen::Vector3d& by) -> Eigen::Vector3d {
    const auto& y = tracks_.settled(i);
    return y.head<3>() + wait * (y.segment<3>(3) + 0.5 * wait * by);
  };
  const double gap = contact_between(shapes(), a, flown(a, acceleration_a), b, flown(b, acceleration_b)).gap;
  const double speed = relative_velocity(side(a, contact, 1.0), side(b, contact, -1.0), contact.normal).normal;
  return -2.0 * (gap - contact.gap - speed * wait) / (wait * wait);
}

double Simulation::curvature(int a, int b, double of_centres) const {
  double sum = of_centres;
  for (const int i : {a, b}) {
    if (tracks_.turn(i) > 0.0) sum += tracks_.turn(i) * shapes().shapes.core_radius[i];
  }
  return sum;
}

double Simulation::pressed_in(int a, int b, double h) const {
  return curvature(a, b, tracks_.bend(a) + tracks_.bend(b)) * h + kRestSpeed;
}

// m: below this a gap is closed within rounding.
double Simulation::touch_tolerance(int a, int b, double end) const {
  const double time = std::max(std::abs(end), method_.step);
  const auto ya = tracks_.settled(a);
  const auto yb = tracks_.settled(b);
  double reach = ya.head<2>().lpNorm<1>() + yb.head<2>().lpNorm<1>() + shapes().size[a] + shapes().size[b];
  double speeds = ya.segment<2>(3).norm() + yb.segment<2>(3).norm();
  for (const int i : {a, b}) {
    if (shapes().is_disc(i)) continue;
    // The rounding of an angle moves a corner.
    reach += std::abs(tracks_.settled(i)[2]) * shapes().size[i];
    speeds += std::abs(tracks_.settled(i)[5]) * shapes().size[i];
  }
  return 16.0 * kEpsilon * (reach + speeds * time);
}

bool Simulation::rests(int a, int b) const { return holds(a, b) || deferred_.rests(a, b); }

// Two discs on parabolas of one acceleration go straight relative to each other: the next impact in closed
// form.
void Simulation::search_discs(int a, int b, double start, double end) {
  const Vec2 d = (tracks_.parabola(b, start) - tracks_.parabola(a, start)).head<2>();
  const Vec2 va = tracks_.parabola_velocity(a, start).head<2>();
  const Vec2 vb = tracks_.parabola_velocity(b, start).head<2>();
  const Vec2 u = vb - va;
  const double touch = shapes().shapes.rounding[a] + shapes().shapes.rounding[b];
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
    if (closing > closing_share() * (va.norm() + vb.norm())) {
      if (!waits(closing)) foresee(start, a, b);
    } else if (distance - touch < -tolerance) {
      deferred_.add(a, b, false);
    }
    return;
  }
  const Vec2 meeting = d + *after * u;
  if (!waits(-meeting.dot(u) / touch)) foresee(start + *after, a, b);
}

// Whether a pair that contacts hold moves so slowly that whatever touches in this step lasts.
bool Simulation::stays_held(int a, int b) const {
  if (!holds(a, b)) return false;
  const Vec2 u = tracks_.settled(b).segment<2>(3) - tracks_.settled(a).segment<2>(3);
  double speed = u.norm();
  double press = 0.0;
  for (const int i : {a, b}) {
    if (tracks_.settled(i)[5] != 0.0) speed += std::abs(tracks_.settled(i)[5]) * shapes().shapes.core_radius[i];
    press = std::max(press, lasting_.acceleration.col(i).head<2>().norm());
  }
  return speed <= press * step_length_;
}

// Foresees the next impact of a and b on their tracks, if there is one.
void Simulation::search(int a, int b) {
  if (a > b) std::swap(a, b);
  if (!shapes().can_meet(a, b) || stays_held(a, b)) return;
  if (work_.spent()) {
    note(&Notices::work_spent_since, time_);
    deferred_.add(a, b, false);
    return;
  }
  double start = std::max(tracks_.start(a), tracks_.start(b));
  const double end = std::min(tracks_.end(a), tracks_.end(b));
  if (!(start <= end)) return;
  const bool parabolic = tracks_.is_parabolic() && !model_->driven[a] && !model_->driven[b];
  if (parabolic && shapes().is_disc(a) && shapes().is_disc(b) &&
      tracks_.constant_acceleration(a).head<2>() == tracks_.constant_acceleration(b).head<2>()) {
    search_discs(a, b, start, end);
    return;
  }

  const auto pose = [&](int i, double t) -> Eigen::Vector3d {
    if (parabolic) return tracks_.parabola(i, t);
    return tracks_.at(i, t).head<3>();
  };
  const auto twist = [&](int i, double t) -> Twist {
    const Eigen::Vector3d v = parabolic ? Eigen::Vector3d(tracks_.parabola_velocity(i, t))
                                        : Eigen::Vector3d(tracks_.at(i, t).segment<3>(3));
    return {v.head<2>(), v[2]};
  };
  const double path_bend =
      parabolic ? (tracks_.constant_acceleration(b) - tracks_.constant_acceleration(a)).head<2>().norm()
                : tracks_.bend(a) + tracks_.bend(b);
  const double bend = curvature(a, b, path_bend);
  // A run that has blown up: its squares overflow, and no contact means anything any more.
  constexpr double kBlownUp = 1e100;  // m/s²
  if (!(bend < kBlownUp)) return;
  const TurningPair pair(
      shapes().shapes, a, [&](double t) { return pose(a, t); }, b, [&](double t) { return pose(b, t); },
      path_bend);
  const double tolerance = touch_tolerance(a, b, end);
  const bool resting = rests(a, b);
  const auto waits = [&](double closing) { return resting && closing <= pressed_in(a, b, method_.step); };
  TurningSample first = pair(start);
  if (first.gap <= tolerance) {
    const Twist ta = twist(a, start);
    const Twist tb = twist(b, start);
    const Approach meeting = approach_of(shapes(), a, pose(a, start), ta, b, pose(b, start), tb, tolerance);
    if (waits(-meeting.speed)) return;
    if (meeting.speed < -closing_share() * meeting.scale) {
      foresee(start, a, b);
      return;
    }
    if (bend == 0.0) {
      if (first.gap < -tolerance) deferred_.add(a, b, false);
      return;
    }
    // They part, and cannot be back before some time: search from the half of that on.
    const double began = start;
    const double until = apart_until(shapes().shapes, a, first.a, ta, b, first.b, tb, first.normal, bend);
    start += 0.5 * until;
    if (start >= end) return;
    const bool touching = first.gap >= -tolerance;
    first = pair(start);
    bool pressed = false;
    if (touching && has_moving_corners(a, b)) {
      // Whether they part or press shows as soon as the gap is more than its rounding.
      for (double wait = std::sqrt(tolerance / bend); first.gap <= 4.0 * tolerance && !pressed; wait *= 2.0) {
        if (start >= end) return;
        start = std::min(start + wait, end);
        first = pair(start);
        pressed = first.gap < -4.0 * tolerance;
      }
    } else if (first.gap <= tolerance) {
      pressed = pressing(a, b, meeting.contact, start) > 0.0;
    }
    if (first.gap <= tolerance) {
      if (touching && pressed) note_resting(tracks_.epoch() + began);
      deferred_.add(a, b, touching && pressed);
      return;
    }
  }
  const TurningSample last = pair(end);
  SearchLimit limit{.looks = resting ? kMostLooksAtHeld : kMostLooks};
  const auto time = first_contact(Paid(pair, tracks_, has_moving_corners(a, b), work_, limit), start, first,
                                  end, last, bend, tolerance, limit);
  if (limit.reached && !resting) note(&Notices::search_cut_since, tracks_.epoch() + start);
  if (time) {
    if (resting) {
      const Approach meeting = approach_of(shapes(), a, pose(a, *time), twist(a, *time), b, pose(b, *time),
                                           twist(b, *time), tolerance);
      if (waits(-meeting.speed)) return;
    }
    foresee(*time, a, b);
  }
}

}  // namespace carom
