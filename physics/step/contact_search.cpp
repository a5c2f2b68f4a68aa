#include "physics/step/contact_search.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "physics/collision/turning_pair.h"
#include "physics/model/pair_size.h"
#include "physics/step/pair_motion.h"

namespace carom {
namespace {

// Gap evaluations in one search, far more than a hard one needs. Where forces change much within a step the
// curvature bound can be so large that a search would not end.
constexpr int kMostLooks = 20'000;
// For a resting pair, whose gap stays near zero: a missed contact is resolved at the step's end.
constexpr int kMostLooksAtRest = 200;

// Cost of a gap evaluation in units of StepWork; an evaluation of a right-hand side costs half a unit.
constexpr std::int64_t kLookWork = 10;

// How the paths of points of a body bend, seen from another body.
struct Bend {
  double bound;       // m/s²
  bool alike;         // all with this acceleration
  Vec2 acceleration;  // m/s²
};

Bend bend_of(const Trajectories& trajectories, BodyIndex a, BodyIndex b, double bound, bool alike) {
  const Eigen::Vector3d by = trajectories.constant_acceleration(b) - trajectories.constant_acceleration(a);
  return {bound, alike, by.head<2>()};
}

// A pair whose gap evaluations are charged to the step's budget; the search ends when that is spent. Without
// turning corners the first kShort evaluations are charged to the run's reserve.
template <class Pair>
class Paid {
 public:
  // `bends`: how the paths of all points of b, seen from a, bend.
  Paid(const Pair& pair, const Trajectories& trajectories, bool corners, const Bend& bends, StepWork& work,
       SearchLimit& limit)
      : pair_(pair),
        trajectories_(trajectories),
        short_(corners ? 0 : kShort),
        bends_(bends),
        work_(work),
        limit_(limit) {}
  [[nodiscard]] TurningSample operator()(double t) const {
    const std::int64_t flown = trajectories_.flight_work();
    TurningSample sample = pair_(t);
    const std::int64_t units = kLookWork + (trajectories_.flight_work() - flown) / 2;
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
  [[nodiscard]] bool clear_turning(const TurningSample& from, const TurningSample& to, double width,
                                   double tolerance) const {
    return pair_.clear_turning(from, to, width, tolerance);
  }
  [[nodiscard]] double curvature_along(const Vec2& n) const {
    return bends_.alike ? std::max(0.0, n.dot(bends_.acceleration)) : bends_.bound;
  }

 private:
  static constexpr int kShort = 16;
  const Pair& pair_;
  const Trajectories& trajectories_;
  mutable int short_;
  Bend bends_;
  StepWork& work_;
  SearchLimit& limit_;
};

// Poses and velocities of bodies on their trajectories.
struct Paths {
  Trajectories& trajectories;
  const Geometry& shapes;
  bool parabolic;

  [[nodiscard]] Eigen::Vector3d at(BodyIndex i, double t) const {
    if (parabolic) return trajectories.parabola(i, t);
    return trajectories.place(i, t);
  }
  [[nodiscard]] Pose pose(BodyIndex i, ShapeIndex part, double t) const {
    return shapes.part_pose(i, part, shapes.pose(i, at(i, t)));
  }
  [[nodiscard]] Twist twist(BodyIndex i, double t) const {
    const Eigen::Vector3d v = parabolic ? Eigen::Vector3d(trajectories.parabola_velocity(i, t))
                                        : Eigen::Vector3d(trajectories.at(i, t).segment<3>(3));
    return {v.head<2>(), v[2]};
  }
  // Of a part of body i at its pose, from that of the body.
  [[nodiscard]] Twist of_part(Twist twist, BodyIndex i, ShapeIndex part, const Pose& pose) const {
    if (shapes.has_parts(i)) twist.velocity += twist.spin * crossed(pose.turned(shapes.place[part]));
    return twist;
  }
  [[nodiscard]] Approach approach(BodyIndex a, BodyIndex b, const ShapePair& parts, double t,
                                  double tolerance) const {
    return approach_of(shapes, a, at(a, t), twist(a, t), b, at(b, t), twist(b, t), tolerance, parts);
  }
  [[nodiscard]] Approach fastest_approach(BodyIndex a, BodyIndex b, const ShapePair& parts, double t,
                                          double tolerance) const {
    return fastest_approach_of(shapes, a, at(a, t), twist(a, t), b, at(b, t), twist(b, t), tolerance, parts);
  }
};

// m/s²: how much more the relative path of the centres of two parts bends than that of their bodies, about
// which they go around.
double around_bodies(const World& world, BodyIndex a, BodyIndex b, const ShapePair& parts) {
  double bound = 0.0;
  for (const auto& [i, part] : {std::pair(a, parts.a), std::pair(b, parts.b)}) {
    if (world.shapes().has_parts(i))
      bound += world.trajectories.turn_bound(i) * world.shapes().place[part].norm();
  }
  return bound;
}

// Two discs on parabolas of the same acceleration move straight relative to each other: their next impact in
// closed form.
NextContact next_contact_of_discs(const World& world, const SearchRules& rules, BodyIndex a, BodyIndex b,
                                  double start, double end) {
  const Trajectories& trajectories = world.trajectories;
  const ConvexShapes& shapes = world.shapes().shapes;
  Vec2 place[2];
  Vec2 velocity[2];
  for (const int k : {0, 1}) {
    const BodyIndex i = k == 0 ? a : b;
    const auto from = trajectories.at_start(i);
    const Vec2 by = trajectories.constant_acceleration(i).head<2>();
    const double h = start - trajectories.start(i);  // of a fixed body any time, as it has no velocity
    place[k] = from.head<2>() + h * (from.segment<2>(3) + 0.5 * h * by);
    velocity[k] = from.segment<2>(3) + h * by;
  }
  const Vec2 d = place[1] - place[0];
  const auto& [va, vb] = velocity;
  const Vec2 u = vb - va;
  const auto [shape_a, shape_b] = world.shapes().first_parts(a, b);
  const double touch = shapes.rounding[shape_a] + shapes.rounding[shape_b];
  const bool apart = d.squaredNorm() > touch * touch;
  const auto after = first_disc_contact(d, u, touch);
  if (apart && (!after || start + *after > end)) return {};

  // A resting pair waits for the step's end, unless it closes faster than the forces alone make it.
  const auto waits = [&](double closing) {
    return rules.rests(a, b, world.shapes().first_parts(a, b)) &&
           closing <= pressed_in(world, a, b, world.method.step);
  };
  const double tolerance = touch_tolerance(world, a, b, end - start);
  const double distance = d.norm();
  if (distance - touch <= tolerance) {
    const double closing = distance > 0.0 ? -d.dot(u) / distance : -u.x();
    if (closing > rules.closing_share * (va.norm() + vb.norm())) {
      if (!waits(closing)) return {NextContact::kImpact, start};
    } else if (distance - touch < -tolerance) {
      return {NextContact::kPenetrating, start};
    }
    return {};
  }
  const Vec2 at_contact = d + *after * u;
  if (waits(-at_contact.dot(u) / touch)) return {};
  return {NextContact::kImpact, start + *after};
}

// Whether they touch, or nearly do: what comes to slide along a face that is flush with it is so from then on.
bool is_flush(const World& world, BodyIndex a, BodyIndex b, double gap) {
  return std::abs(gap) <= kTogether * pair_size(world.shapes(), a, b);
}

// Of corners that touch at `begin` and are inside by `time`, one may have left and another one have landed:
// moves `time` back to where they are apart, if there is such a time, with the sample there.
template <class Pair>
bool find_apart(const Pair& pair, double begin, double tolerance, double& time, TurningSample& there) {
  double half = time;
  TurningSample at = there;
  while (at.gap < -4.0 * tolerance) {
    half = 0.5 * (begin + half);
    at = pair(half);
  }
  if (!(at.gap > 4.0 * tolerance)) return false;
  time = half;
  there = at;
  return true;
}

// Whether corners that touch at `begin` separate or press shows once the gap exceeds its rounding: moves `time`
// there, with the sample, from `time` on. Nothing if that is not before `end`.
template <class Pair>
std::optional<bool> are_pressed(const Pair& pair, double begin, double end, double tolerance, double bound,
                                double& time, TurningSample& there) {
  bool pressed = false;
  for (double wait = std::sqrt(tolerance / bound); there.gap <= 4.0 * tolerance && !pressed; wait *= 2.0) {
    if (time >= end) return std::nullopt;
    time = std::min(time + wait, end);
    there = pair(time);
    pressed = there.gap < -4.0 * tolerance;
  }
  return pressed && !find_apart(pair, begin, tolerance, time, there);
}

}  // namespace

double closed_gap(const World& world, const RestingContacts* resting, BodyIndex a, BodyIndex b,
                  double rounding) {
  if (resting == nullptr || !resting->holds(std::min(a, b), std::max(a, b))) return rounding;
  return std::max(rounding, held_gap(world, a, b));
}

NextContact next_contact(World& world, const SearchRules& rules, BodyIndex a, BodyIndex b,
                         const ShapePair& parts) {
  Trajectories& trajectories = world.trajectories;
  const Geometry& shapes = world.shapes();
  const double begin = std::max({trajectories.start(a), trajectories.start(b), rules.from});
  const double end = std::min({trajectories.end(a), trajectories.end(b), rules.until});
  if (!(begin <= end)) return {};
  const bool parabolic =
      trajectories.is_parabolic() && !world.model->is_kinematic(a) && !world.model->is_kinematic(b);
  const bool bent = trajectories.is_bent(a) || trajectories.is_bent(b);
  if (parabolic && !bent && shapes.is_disc(a) && shapes.is_disc(b) &&
      trajectories.constant_acceleration(a).head<2>() == trajectories.constant_acceleration(b).head<2>()) {
    return next_contact_of_discs(world, rules, a, b, begin, end);
  }

  const double path_bound =
      parabolic && !bent
          ? (trajectories.constant_acceleration(b) - trajectories.constant_acceleration(a)).head<2>().norm()
          : trajectories.curvature_bound(a) + trajectories.curvature_bound(b);
  const double bound = curvature(world, a, b, path_bound);
  // A run that has blown up: squares overflow, and no contact means anything.
  constexpr double kBlownUp = 1e100;  // m/s²
  if (!(bound < kBlownUp)) return {};
  const Paths paths{trajectories, shapes, parabolic};
  const auto [part_a, part_b] = parts;
  const TurningPair pair(
      shapes.shapes, part_a, [&, part = part_a](double t) { return paths.pose(a, part, t); }, part_b,
      [&, part = part_b](double t) { return paths.pose(b, part, t); },
      path_bound + around_bodies(world, a, b, parts), trajectories.turn_bound(a), trajectories.turn_bound(b));
  const double tolerance = touch_tolerance(world, a, b, end - begin);
  const bool resting = rules.rests(a, b, parts);
  const auto waits = [&](double t) {
    return -paths.fastest_approach(a, b, parts, t, tolerance).speed <=
           pressed_in(world, a, b, world.method.step);
  };
  double start = begin;
  TurningSample first = pair(start);
  if (first.gap <= closed_gap(world, rules.resting, a, b, tolerance)) {
    const Twist twist_a = paths.twist(a, begin);
    const Twist twist_b = paths.twist(b, begin);
    const Eigen::Vector3d place_a = paths.at(a, begin);
    const Eigen::Vector3d place_b = paths.at(b, begin);
    if (resting && (waits(begin) || (rules.lands_first && rules.resting->awaits(a, b)))) return {};
    const Approach now = approach_of(shapes, a, place_a, twist_a, b, place_b, twist_b, tolerance, parts);
    if (now.speed < -rules.closing_share * now.scale) return {NextContact::kImpact, begin};
    if (bound == 0.0) {
      if (first.gap < -tolerance) return {NextContact::kPenetrating, begin};
      return {};
    }
    // They separate and cannot be back before some time: search from half of that on.
    start +=
        0.5 * apart_until(shapes.shapes, part_a, first.a, paths.of_part(twist_a, a, part_a, first.a), part_b,
                          first.b, paths.of_part(twist_b, b, part_b, first.b), first.normal, bound);
    if (start >= end) return {};
    const bool touching = first.gap >= -tolerance;
    first = pair(start);
    bool pressed = false;
    if (touching && world.has_moving_corners(a, b)) {
      const std::optional<bool> seen = are_pressed(pair, begin, end, tolerance, bound, start, first);
      if (!seen) return {};
      pressed = *seen;
    } else if (first.gap <= tolerance) {
      pressed = pressing(world, a, b, now.contact, start) > 0.0;
    }
    if (first.gap <= tolerance)
      return {touching && pressed ? NextContact::kPressed : NextContact::kPenetrating, begin};
  }
  const TurningSample last = pair(end);
  SearchLimit limit{.looks = resting ? kMostLooksAtRest : kMostLooks};
  const Bend bend = bend_of(trajectories, a, b, bound, parabolic && !bent && bound == path_bound);
  const Paid paid(pair, trajectories, world.has_moving_corners(a, b), bend, world.work, limit);
  const auto time = first_contact(paid, start, first, end, last, bound, tolerance, limit);
  if (limit.reached && !resting && !is_flush(world, a, b, last.gap))
    world.note(&Notices::search_cut_since, trajectories.epoch() + start, {a, b});
  if (!time) return {};
  if (resting && waits(*time)) return {};
  return {NextContact::kImpact, *time};
}

}  // namespace carom
