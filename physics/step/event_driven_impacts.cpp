#include "physics/step/event_driven_impacts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

#include "physics/collision/pair_contact.h"
#include "physics/dynamics/integrators/integrators.h"
#include "physics/ledger/step_limits.h"
#include "physics/model/pair_size.h"
#include "physics/step/apply_impact.h"
#include "physics/step/coming_to_rest.h"
#include "physics/step/contact_patch.h"
#include "physics/step/internal_edges.h"
#include "physics/step/pair_motion.h"

namespace carom {
namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
constexpr double kNever = std::numeric_limits<double>::infinity();
// Inelastic collapse: a pair with 0 < e < 1 separates slower than this share of its own speed, and the time
// since the previous impact is less than doubles can distinguish.
constexpr double kCollapseShare = 1e-12;
// Impacts at one time, to the last bit, after which closing speeds below that share are rounding: a body too
// light to change the speeds of two others would bounce between them for ever.
constexpr int kMostAtOnce = 10'000;
// After more than kImpactsBeforeGuard + kImpactsBeforeGuardPerBody * N impacts in one step, the guard against
// inelastic collapse acts: a pair with e < 1 rests until the step's end if it rebounds slower than its forces
// can press it together in a step. A settling pile would otherwise need millions of impacts a step.
constexpr int kImpactsBeforeGuard = 100;
constexpr int kImpactsBeforeGuardPerBody = 4;
// Parts into which new supports divide a step; what lands or comes to rest in the last part waits for the next
// step; where few bodies move, a part costs little, and boxes rattle from corner to corner. What is left of a
// step after these goes on as where impacts are not located (ContactFinder::begin_part).
constexpr int kMostParts = 8;
constexpr int kMostPartsOfFew = 128;
// Of a step: impacts leave no shorter rest as a part of its own. Contacts would close or open gaps of rounding
// within it, at any speed.
constexpr double kLeastPart = 1e-6;
// Limits for each later step of a run that has once reached kMostImpactsPerStep or kMostImpactsAtOnce (a
// piston crushing an elastic disc, say), so that it still advances.
constexpr int kMostImpactsOnceCapped = 20'000;
constexpr int kMostImpactsAtOnceCapped = 1'000;
// Of a step: two times of one landing, found in two ways, differ by less.
constexpr double kSameTime = 1e-6;
// Trajectories that end in one step, beside some for each body, before they become twice as long: bodies that
// fly or turn very fast for the size of the scene would end millions.
constexpr int kMostTrajectoryEnds = 1'000;
constexpr int kMostTrajectoryEndsPerBody = 20;
// Cost of an impact that is none, because a third body continues the surface.
constexpr std::int64_t kInternalEdge = 20;
// Largest number of epochs in one step.
constexpr double kMostEpochs = 1024.0;

// Where two parts meet, at the start of the trajectories: what a disc meets has one point, else the middle of
// the face or the end that approaches.
Contact meeting_point(const World& world, BodyIndex a, BodyIndex b, const ShapePair& parts) {
  const Geometry& shapes = world.shapes();
  if (!shapes.is_disc(a) && !shapes.is_disc(b))
    return world.approach(a, b, touch_tolerance(world, a, b), parts).contact;
  Contact earlier;
  earlier.parts = parts;
  return contact_again(shapes, a, pose_at_start(world, a), b, pose_at_start(world, b), earlier);
}

}  // namespace

bool EventDrivenImpacts::trajectories_run_on(const World& world, const RestingContacts* resting) {
  const IntegratorChoice& choice = choice_of(kIntegrators, world.method.integrator);
  return resting == nullptr && (choice.order == 0 || choice.adaptive);
}

void EventDrivenImpacts::reset(int bodies) {
  stamp_.assign(bodies, 0);
  running_ = false;
  end_of_step_.clear();
}

double EventDrivenImpacts::closing_share() const {
  return at_once_ >= kMostAtOnce ? kCollapseShare : 16.0 * kEpsilon;
}

void EventDrivenImpacts::step(World& world, RestingContacts* resting, double h) {
  Trajectories& trajectories = world.trajectories;
  const bool run_on = trajectories_run_on(world, resting);
  Step step{world, resting, h, run_on ? kNever : h, world.sums.impact_count};
  trajectory_ends_ = 0;
  at_once_work_ = 0;
  disturbed_.reset();
  if (!run_on || !running_) {
    if (!run_on) trajectories.begin(world.clock.time);
    choose_cells(world, step.horizon);
    epoch_length_ = std::max(epoch_length_, std::exp2(std::ceil(std::log2(h / kMostEpochs))));
    if (!run_on) end_of_step_.clear();
    last_impact_ = -1.0;
    stretch_ = 1.0;
    rebuild_all(step);
    if (resting == nullptr) search_all(step);
    running_ = true;
  }
  // Where trajectories continue across steps, the epoch advances by leaps that don't depend on h. Times stay
  // small, and with them the rounding of each impact's time, which would add up over millions of bounces.
  while (run_on && world.clock.step_end - trajectories.epoch() > epoch_length_) {
    process_until(step, epoch_length_);
    trajectories.shift_epoch(epoch_length_);
    queue_.shift(epoch_length_);
    last_impact_ -= epoch_length_;
  }
  if (resting != nullptr) {
    const double left = process_with_supports(step);
    for (const IslandIndex k : trajectories.islands()) trajectories.advance_to(k, left);
    resolving_.swap(end_of_step_);
    end_of_step_.clear();
    std::vector<BodyPair> pairs = resting->finder().supported();
    for (const WaitingPair& d : resolving_.all()) pairs.emplace_back(d.a, d.b);
    resting->rebound_at_end(world, pairs);
    world.publish(left);
    return;
  }
  const double target = run_on ? world.clock.step_end - trajectories.epoch() : h;
  process_until(step, target);
  resolve_end_of_step(step, target);
}

// Pairs that rest or penetrate at the step's end are resolved then, in the order of index pairs: not in that of
// the search, which depends on all that happened before.
void EventDrivenImpacts::resolve_end_of_step(const Step& step, double target) {
  World& world = step.world;
  Trajectories& trajectories = world.trajectories;
  const bool run_on = step.horizon == kNever;
  resolving_.swap(end_of_step_);
  resolving_.sort();
  end_of_step_.clear();
  const std::vector<WaitingPair>& pairs = resolving_.all();
  resolving_islands_.clear();
  if (run_on) {
    // The islands of these pairs, without duplicates, in the order of the pairs.
    is_resolving_.assign(trajectories.islands().size(), 0);
    for (const WaitingPair& d : pairs) {
      for (const BodyIndex i : {d.a, d.b}) {
        const IslandIndex island = trajectories.island_of(i);
        if (island == kNoIsland || is_resolving_[island] != 0) continue;
        is_resolving_[island] = 1;
        resolving_islands_.push_back(island);
      }
    }
    for (const IslandIndex island : resolving_islands_) trajectories.advance_to(island, target);
  } else {
    for (const IslandIndex k : trajectories.islands()) trajectories.advance_to(k, target);
  }
  world.publish(target);
  if (pairs.empty()) return;
  world.check_motions();
  if (resolve_penetrations(world, pairs, penetrations_, step.h) == ImpactEffect::kJoined) {
    world.publish(target);
    running_ = false;
    return;
  }
  for (const WaitingPair& d : pairs) {
    for (const BodyIndex i : {d.a, d.b}) world.state.set_motion(i, trajectories.at(i, target));
  }
  if (run_on) rebuild_and_search(step, resolving_islands_);
}

// A step with resting contacts. A body that comes to rest on a support is supported from that moment on, and
// one that runs off a face no more: the step is divided there, into up to kMostParts or kMostPartsOfFew parts,
// and what is left of it into as few as contacts can be trusted in. Returns the length in s of the last part,
// from the epoch on.
double EventDrivenImpacts::process_with_supports(Step& step) {
  World& world = step.world;
  Trajectories& trajectories = world.trajectories;
  RestingContacts& resting = *step.resting;
  const int most = moves_few(world) ? kMostPartsOfFew : kMostParts;
  const auto may_divide = [most](int part) { return part < most; };
  for (int part = 1;; ++part) {
    const double left = step.h;
    step.may_divide = may_divide(part);
    std::optional<LandingTime> landing;
    const auto find_landing = [&] {
      if (step.may_divide) landing = resting.first_landing(world, resting.supported());
    };
    find_landing();
    if (landing && resting.end_part(world, landing->time)) {
      rebuild_all(step);
      find_landing();
    }
    const double supported = resting.supported();
    if (landing && !(landing->time < supported && may_end_at(step, landing->time))) landing.reset();
    if (landing && landing->time == 0.0) {
      resting.land(world, *landing);
      world.publish(0.0);
      begin_part(step, may_divide(part + 1), true);
      continue;
    }
    step.lands_first = landing.has_value();
    search_all(step);
    step.lands_first = false;
    const std::optional<double> stops =
        process_until(step, landing ? landing->time : supported, landing.has_value());
    if (stops) landing.reset();
    const double passed = stops ? *stops : landing ? landing->time : supported;
    resting.record_forces(world, passed, passed / supported);
    if (!(passed < left)) return left;
    for (const IslandIndex k : trajectories.islands()) trajectories.advance_to(k, passed);
    if (landing) resting.land(world, *landing);
    world.publish(passed);
    step.h = step.horizon = left - passed;
    begin_part(step, may_divide(part + 1), stops || landing);
  }
}

bool EventDrivenImpacts::may_end_at(const Step& step, double time) {
  return step.resting != nullptr && step.may_divide && step.h - time > kLeastPart * step.world.method.step;
}

// Supports what is left of the step.
void EventDrivenImpacts::begin_part(const Step& step, bool may_divide, bool hit) {
  World& world = step.world;
  world.trajectories.begin(world.clock.step_end - step.h);
  step.resting->support(world, step.h, may_divide, hit);
  choose_cells(world, step.h);
  end_of_step_.clear();
  last_impact_ = -1.0;
  disturbed_.reset();
  rebuild_all(step);
}

std::optional<double> EventDrivenImpacts::process_until(const Step& step, double target, bool awaits_landing) {
  World& world = step.world;
  Trajectories& trajectories = world.trajectories;
  const std::int64_t before_guard =
      kImpactsBeforeGuard + kImpactsBeforeGuardPerBody * static_cast<std::int64_t>(world.bodies());
  const int most_trajectory_ends = kMostTrajectoryEnds + kMostTrajectoryEndsPerBody * world.bodies();
  moment_.clear();
  disturbed_.reset();
  while (!moment_.empty() || (!queue_.empty() && queue_.next().time <= target)) {
    if (moment_.empty()) {
      if (is_stale(queue_.next())) {
        queue_.pop();
        continue;
      }
      if (queue_.next().time > end_of_disturbed(step)) return disturbed_;
      find_moment(step);
    }
    const Event next = moment_.back();
    moment_.pop_back();
    if (is_stale(next)) continue;
    // All of a moment comes before the supports that it disturbs.
    if (disturbed_) disturbed_ = std::max(*disturbed_, next.time);
    if (next.time > target) {
      queue_.push(next);
      continue;
    }
    world.work.pass(5);
    // It is scheduled here too, and only rounding could say which comes first.
    if (awaits_landing && target - next.time <= kSameTime * step.h && step.resting->awaits(next.a, next.b))
      continue;
    if (next.b < 0) {
      const IslandIndex island = trajectories.island_of(next.a);
      world.sums.ledger.lost_to_dampers += trajectories.advance_to_end(island);
      // A string that goes taut or slack, or a spring that acts from now on, disturbs contacts as impacts do.
      // The adaptive integrator's own steps end trajectories, too.
      if (!choice_of(kIntegrators, world.method.integrator).adaptive) {
        for (const BodyIndex i : trajectories.members(island)) note_disturbed(step, i, i, next.time);
      }
      if (++trajectory_ends_ % most_trajectory_ends == 0) stretch_ *= 2.0;
      rebuild(step, island);
      search_island(step, island);
      continue;
    }
    if (world.work.spent()) {
      world.note(&Notices::work_spent_since, trajectories.epoch() + next.time, {next.a, next.b});
      end_of_step_.add(next.a, next.b, false);
      continue;
    }
    const bool capped = world.work.impacts_capped();
    const int most_at_once = capped                                     ? kMostImpactsAtOnceCapped
                             : world.has_moving_corners(next.a, next.b) ? kMostCornersAtOnce
                                                                        : kMostImpactsAtOnce;
    const bool at_once = next.time == last_impact_ && at_once_ >= most_at_once;
    const std::int64_t impacts = world.sums.impact_count - step.impacts_begin;
    if (at_once || impacts >= (capped ? kMostImpactsOnceCapped : kMostImpactsPerStep)) {
      world.work.cap_impacts();
      world.note(&Notices::impacts_capped_since, trajectories.epoch() + next.time, {next.a, next.b});
      end_of_step_.add(next.a, next.b, false);
      continue;
    }
    const bool guarded = impacts >= before_guard;
    if (guarded && step.resting != nullptr && moves_few(world)) step.resting->calm();
    if (resolve(step, next.a, next.b, next.time, guarded)) return next.time;
  }
  return disturbed_;
}

bool EventDrivenImpacts::resolve(const Step& step, BodyIndex a, BodyIndex b, double time, bool guarded) {
  World& world = step.world;
  Trajectories& trajectories = world.trajectories;
  std::optional<ShapePair> parts = world.shapes().first_parts(a, b);
  if (may_be_continued(world, a, b)) parts = parts_that_meet(step, a, b, time);
  if (!parts) {
    // Once past the edge they touch along the normal of the common surface; where they overlap, they are past
    // it once they have moved as far as they overlap.
    const Motion of_a = trajectories.at(a, time);
    const Motion of_b = trajectories.at(b, time);
    const double overlap = -contact_between(world.shapes(), a, of_a.head<3>(), b, of_b.head<3>()).gap;
    const double past = std::max(4.0 * kFlush * pair_size(world.shapes(), a, b), overlap);
    const Vec2 u = of_b.segment<2>(3) - of_a.segment<2>(3);
    const double least = 64.0 * kEpsilon * (std::abs(time) + step.h);
    world.work.spend(kInternalEdge);
    search(step, search_rules(step, time + std::clamp(past / u.norm(), least, step.h)), a, b);
    return false;
  }
  if (!guarded && may_be_several(world, a, b)) {
    if (const std::optional<bool> divides = resolve_at_once(step, a, b, time)) return *divides;
  }
  for (const BodyIndex i : {a, b}) {
    if (trajectories.island_of(i) != kNoIsland && trajectories.start(i) != time)
      trajectories.advance_to(trajectories.island_of(i), time);
  }
  const Contact contact = meeting_point(world, a, b, *parts);
  const PressedPair pressed = pressed_pair(world, a, b, contact);
  return resolve_alone(step, pressed.a, pressed.b, pressed.contact, time, guarded);
}

// Whether impacts of other pairs, or of other shapes of this one, may come at one moment with that of a and b.
bool EventDrivenImpacts::may_be_several(const World& world, BodyIndex a, BodyIndex b) const {
  const Geometry& shapes = world.shapes();
  return !moment_.empty() || shapes.has_parts(a) || shapes.has_parts(b) || takes_touches(world) ||
         is_of_clay(world.material({}, a, b));
}

bool EventDrivenImpacts::resolve_alone(const Step& step, BodyIndex a, BodyIndex b, const Contact& contact,
                                       double time, bool guarded) {
  World& world = step.world;
  SurfaceLaw law = world.material(contact, a, b);
  const bool rests = comes_to_rest(step, a, b, contact);
  if (rests) law.restitution = 0.0;
  const ImpactEffect effect = apply_impact(world, a, b, contact, law, time);
  if (effect == ImpactEffect::kJoined) {
    note_disturbed(step, a, b, time);
    last_impact_ = time;
    rebuild_all(step);
    search_all(step);
    return false;
  }
  bool divides = classify_rebound(step, a, b, contact, rests, time, guarded);
  note_disturbed(step, a, b, time);
  // Where few move, all that closes then stops at once, and not by turns whose number rounding decides.
  if (disturbed_ && moves_few(world) && !(law.restitution > 0.0)) divides = true;
  count_at_once(world, a, b, time);
  const IslandIndex island_a = world.trajectories.island_of(a);
  const IslandIndex island_b = world.trajectories.island_of(b);
  if (island_a != kNoIsland && island_b != kNoIsland && island_a != island_b) {
    rebuild_and_search(step, std::array{island_a, island_b});
  } else {
    rebuild_and_search(step, std::array{std::max(island_a, island_b)});
  }
  return divides;
}

// Whether forces press these bodies together again within a step after the impact, so that contact forces hold
// them from now on: what is left of their bounces is lost at once.
bool EventDrivenImpacts::comes_to_rest(const Step& step, BodyIndex a, BodyIndex b,
                                       const Contact& contact) const {
  World& world = step.world;
  const double restitution = world.material(contact, a, b).restitution;
  if (step.resting == nullptr || !step.may_divide || !(restitution < 1.0)) return false;
  const double closing = -world
                              .fastest_approach(a, b, touch_tolerance(world, a, b),
                                                world.shapes().parts_or_first(contact.parts, a, b))
                              .speed;
  return restitution * closing <
         step.resting->rest_speed(world, a, b, contact.point, contact.normal, restitution);
}

// The contact forces on what is hit were found for its motion before: they hold until now.
void EventDrivenImpacts::note_disturbed(const Step& step, BodyIndex a, BodyIndex b, double time) {
  if (may_end_at(step, time) && step.resting->is_disturbed(step.world, a, b)) disturbed_ = time;
}

void EventDrivenImpacts::count_at_once(World& world, BodyIndex a, BodyIndex b, double time) {
  at_once_ = time == last_impact_ ? at_once_ + 1 : 0;
  if (at_once_ == kMostAtOnce) world.note(&Notices::collapsed_since, world.trajectories.epoch() + time, {a, b});
  last_impact_ = time;
}

bool EventDrivenImpacts::classify_rebound(const Step& step, BodyIndex a, BodyIndex b, const Contact& contact,
                                          bool rests, double time, bool guarded) {
  World& world = step.world;
  const SurfaceLaw& material = world.material(contact, a, b);
  if (!(material.restitution < 1.0)) return false;
  const double rebound = world.parting_speed(a, b, contact);
  const double press = pressing(world, a, b, contact, time);
  const double now = world.trajectories.epoch() + time;
  double rest = kRestSpeed;
  if (world.method.integrator == IntegratorId::kExplicitEuler)
    rest = std::max(rest, last_rebound_of_euler(material.restitution) * press * step.h);
  if (step.resting != nullptr)
    rest = std::max(rest,
                    step.resting->rest_speed(world, a, b, contact.point, contact.normal, material.restitution));
  if (press > 0.0 && rebound < rest) {
    // The time that the omitted bounces would last, where their sum is known.
    const bool exact = choice_of(kIntegrators, world.method.integrator).exact_under_gravity;
    const double left = exact ? 2.0 * rebound / (press * (1.0 - material.restitution)) : 0.0;
    if (step.resting == nullptr) world.note(&Notices::resting_since, now + left, {a, b});
    end_of_step_.add(a, b, true);
    return may_end_at(step, time);
  }
  if (guarded && rebound < pressed_in(world, a, b, step.h)) {
    if (step.resting == nullptr) world.note(&Notices::resting_since, now, {a, b});
    end_of_step_.add(a, b, true);
  } else if (material.restitution > 0.0 && !rests &&
             rebound < kCollapseShare * (world.trajectories.at_start(a).segment<2>(3).norm() +
                                         world.trajectories.at_start(b).segment<2>(3).norm()) &&
             time - last_impact_ <= 64.0 * kEpsilon * (std::abs(time) + step.h)) {
    world.note(&Notices::collapsed_since, now, {a, b});
  }
  return false;
}

std::optional<ScheduleState> EventDrivenImpacts::ahead(const World& world) const {
  if (!running_ || !trajectories_run_on(world, nullptr)) return std::nullopt;
  ScheduleState ahead;
  ahead.grid = grid_.order();
  for (const Event& event : queue_.all()) {
    if (!is_stale(event)) ahead.events.push_back({event.time, event.a, event.b});
  }
  std::sort(ahead.events.begin(), ahead.events.end(), [](const auto& x, const auto& y) {
    return std::tie(x.time, x.a, x.b) < std::tie(y.time, y.a, y.b);
  });
  ahead.reach = reach_;
  ahead.stretch = stretch_;
  ahead.epoch_length = epoch_length_;
  ahead.last_impact = last_impact_;
  return ahead;
}

void EventDrivenImpacts::restore(int bodies, int at_once, std::span<const WaitingPair> waiting,
                                 const std::optional<ScheduleState>& ahead) {
  reset(bodies);
  at_once_ = at_once;
  for (const auto& [a, b, resting] : waiting) end_of_step_.add(a, b, resting);
  if (!ahead) return;
  reach_ = ahead->reach;
  stretch_ = ahead->stretch;
  epoch_length_ = ahead->epoch_length;
  last_impact_ = ahead->last_impact;
  grid_.restore(ahead->grid);
  // The stamps of all islands are still 0.
  for (const auto& [time, a, b] : ahead->events) queue_.push({time, a, b, 0, 0});
  running_ = true;
}

}  // namespace carom
