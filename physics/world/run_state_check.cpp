#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

#include "physics/dynamics/integrators/method_fields.h"
#include "physics/model/geometry.h"
#include "physics/model/needs.h"
#include "physics/scene/range_check.h"
#include "physics/scene/validate.h"
#include "physics/world/run_state.h"

// Checks that a state fits a simulation: indices are in range, and time advances.
namespace carom {
namespace {

// Epochs of trajectories that continue across steps: powers of two in this range.
constexpr double kShortestEpoch = 0x1p-20;  // s
constexpr double kLongestEpoch = 0x1p20;    // s

[[noreturn]] void refuse(const std::string& place, const std::string& why) {
  throw SceneError(fmt::format("/state/{}: {}; allowed: what a run of this scene leaves there", place, why));
}

void check_least(const std::string& place, double value, double least) {
  if (!(value >= least)) refuse(place, fmt::format("{} is below {}", value, least));
}

void check_body(const std::string& place, const std::vector<Body>& bodies, int body) {
  if (body < 0 || body >= static_cast<int>(bodies.size()))
    refuse(place, fmt::format("there is no body {}", body));
}

// Bodies a < b, at least one of which moves.
void check_pair(const std::string& place, const std::vector<Body>& bodies, int a, int b) {
  check_body(place, bodies, a);
  check_body(place, bodies, b);
  if (a >= b) refuse(place, fmt::format("body {} is not before body {}", a, b));
  if (has_infinite_mass(bodies[static_cast<std::size_t>(a)]) &&
      has_infinite_mass(bodies[static_cast<std::size_t>(b)]))
    refuse(place, fmt::format("nothing moves bodies {} and {}", a, b));
}

// Motions outside the range of a preset are meaningless.
void check_motions(const std::string& place, const Eigen::Matrix3Xd& m, double most) {
  if (m.size() > 0 && !(m.cwiseAbs().maxCoeff() <= most))
    refuse(place, fmt::format("a number beyond ±{}", most));
}

void check_clock(const RunState& s) {
  check_least("steps_since_origin", static_cast<double>(s.clock.steps_since_origin), 0.0);
  check_least("steps", static_cast<double>(s.clock.steps), 0.0);
  check_least("impacts", static_cast<double>(s.sums.impact_count), 0.0);
  check_least("at_once", s.at_once, 0.0);
  check_least("origin_step", s.clock.origin_step, 0.0);
  if (s.clock.time != s.clock.origin + static_cast<double>(s.clock.steps_since_origin) * s.clock.origin_step)
    refuse("steps_since_origin", fmt::format("these steps don't end at the time, {} s", s.clock.time));
  check_least("tracks/evaluations", static_cast<double>(s.trajectories.evaluations), 0.0);
  check_least("tracks/rejected_steps", static_cast<double>(s.trajectories.rejected_steps), 0.0);
  if (!(s.trajectories.epoch <= s.clock.time))
    refuse("tracks/epoch", fmt::format("{} is after the time", s.trajectories.epoch));
}

void check_counts(const std::vector<Body>& bodies, std::int64_t impacts, const ImpactCounts& s) {
  check_least("impact_counts/walls", static_cast<double>(s.walls), 0.0);
  check_least("impact_counts/mutual", static_cast<double>(s.mutual), 0.0);
  if (s.counted > impacts || s.counted != s.walls + s.mutual)
    refuse("impact_counts/counted", fmt::format("{} of {} impacts", s.counted, impacts));
  if (s.pairs.size() > ImpactCounts::kMostPairs)
    refuse("impact_counts/pairs", fmt::format("{} are more than {}", s.pairs.size(), ImpactCounts::kMostPairs));
  for (std::size_t i = 0; i < s.pairs.size(); ++i) {
    const std::string at = fmt::format("impact_counts/pairs/{}", i);
    const auto& [a, b, count] = s.pairs[i];
    check_body(at, bodies, a);
    check_body(at, bodies, b);
    if (a >= b) refuse(at, fmt::format("body {} is not before body {}", a, b));
    if (s.find(a, b) != &s.pairs[i]) refuse(at, "a pair for the second time");
  }
}

void check_forces(const Scene& scene, const TrajectoryState& s) {
  for (std::size_t i = 0; i < scene.forces.applied.size(); ++i) {
    const int phase = s.phase[i];
    if (phase < 0 || phase > 3 || (phase == 1 && !(scene.forces.applied[i].rise > 0.0)))
      refuse(fmt::format("tracks/phase/{}", i), fmt::format("{} is no phase of this force", phase));
  }
  for (std::size_t i = 0; i < scene.forces.springs.size(); ++i) {
    if (s.engaged[i] > 1 || (s.engaged[i] == 0 && scene.forces.springs[i].acts == SpringActs::kBoth))
      refuse(fmt::format("tracks/engaged/{}", i), fmt::format("{} of this spring", s.engaged[i]));
  }
  for (std::size_t i = 0; i < scene.joints.size(); ++i) {
    if (s.taut[i] > 1 || (s.taut[i] == 0 && scene.joints[i].kind != JointKind::kString))
      refuse(fmt::format("tracks/taut/{}", i), fmt::format("{} of this link", s.taut[i]));
  }
}

void check_contacts(const std::vector<Body>& bodies, const ContactMemory& s) {
  for (std::size_t i = 0; i < s.forces.size(); ++i) {
    const std::string at = fmt::format("contacts/forces/{}", i);
    const ContactForce& f = s.forces[i];
    check_pair(at, bodies, f.a, f.b);
    if (i > 0 && std::pair(f.a, f.b) < std::pair(s.forces[i - 1].a, s.forces[i - 1].b))
      refuse(at, "the pairs are not in rising order");
  }
  if (s.support.size() != s.forces.size())
    refuse("contacts", fmt::format("{} have supports and {} have forces", s.support.size(), s.forces.size()));
  for (const int i : s.pushed) {
    check_body("contacts/pushed", bodies, i);
    if (has_infinite_mass(bodies[static_cast<std::size_t>(i)]))
      refuse("contacts/pushed", fmt::format("nothing moves body {}", i));
  }
}

void check_ahead(const std::vector<Body>& bodies, const Geometry& shapes, const Trajectories& trajectories,
                 const RunState& s) {
  const ScheduleState& ahead = *s.ahead;
  // Relative to the mean size of the moving bodies: far shorter trajectories would be endlessly many.
  double size = 0.0;
  int moving = 0;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (has_infinite_mass(bodies[i])) continue;
    size += shapes.extent.col(static_cast<Eigen::Index>(i)).maxCoeff();
    ++moving;
  }
  check_least("ahead/reach", ahead.reach, std::max(0.5 * size / std::max(moving, 1), 1e-9));
  int exponent = 0;
  if (!(ahead.epoch_length >= kShortestEpoch && ahead.epoch_length <= kLongestEpoch) ||
      std::frexp(ahead.epoch_length, &exponent) != 0.5) {
    refuse("ahead/epoch_length", fmt::format("{} is no such length", ahead.epoch_length));
  }
  constexpr double kMostStretch = 0x1p60;
  if (!(ahead.stretch >= 1.0 && ahead.stretch <= kMostStretch) || std::frexp(ahead.stretch, &exponent) != 0.5)
    refuse("ahead/stretch", fmt::format("{} is no power of two from 1 on", ahead.stretch));
  if (!(s.clock.time - s.trajectories.epoch <= ahead.epoch_length))
    refuse("tracks/epoch", fmt::format("{} is too long before the time", s.trajectories.epoch));
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    check_least(fmt::format("ahead/bend/{}", i), ahead.trajectories.curvature_bound[i], 0.0);
    check_least(fmt::format("ahead/turn/{}", i), ahead.trajectories.turn_bound[i], 0.0);
  }
  for (std::size_t i = 0; i < ahead.events.size(); ++i) {
    const std::string at = fmt::format("ahead/events/{}", i);
    const ScheduleState::Scheduled& e = ahead.events[i];
    check_least(at, e.time, 0.0);
    if (e.b >= 0) {
      check_pair(at, bodies, e.a, e.b);
      if (!shapes.can_collide(e.a, e.b)) refuse(at, fmt::format("bodies {} and {} can't meet", e.a, e.b));
    } else {
      check_body(at, bodies, e.a);
      if (trajectories.island_of(e.a) < 0) refuse(at, fmt::format("nothing moves body {}", e.a));
    }
  }
  for (std::size_t i = 0; i < ahead.waiting.size(); ++i) {
    const std::string at = fmt::format("ahead/waiting/{}", i);
    const ScheduleState::Waiting& w = ahead.waiting[i];
    check_pair(at, bodies, w.a, w.b);
    if (!shapes.can_collide(w.a, w.b)) refuse(at, fmt::format("bodies {} and {} can't meet", w.a, w.b));
  }
  for (const Bounds& b : ahead.grid.bounds) {
    if (!(b.low <= b.high).all()) refuse("ahead/grid/bounds", "bounds that hold nothing");
  }
  CellGrid grid;
  if (!grid.restore(static_cast<int>(bodies.size()), ahead.grid))
    refuse("ahead/grid", "these cells don't hold these bounds");
}

}  // namespace

void check_state(const Scene& scene, double start_time, const RunState& state) {
  check_fields("/state/method", state.method);
  check_integrator("/state/method", scene, state.method);
  if (state.clock.time != start_time) refuse("time", fmt::format("the state is of t = {} s", state.clock.time));
  const std::vector<Body> bodies = all_bodies(scene);
  check_clock(state);
  check_counts(bodies, state.sums.impact_count, state.sums.impact_counts);
  constexpr double kMostAhead = 1e15;         // m and m/s: a trajectory may lead far away before it is cut
  constexpr double kMostAcceleration = 1e30;  // m/s²
  check_motions("positions", state.motions.q, kLargestNumber);
  check_motions("velocities", state.motions.v, kLargestNumber);
  check_motions("tracks/settled", state.trajectories.at_start.topRows<3>(), kLargestNumber);
  check_motions("tracks/settled", state.trajectories.at_start.middleRows<3>(3), kLargestNumber);
  check_motions("tracks/constant", state.trajectories.constant, kMostAcceleration);
  check_motions("tracks/contact", state.trajectories.contact, kMostAcceleration);
  if (state.ahead) {
    check_motions("ahead/at_end", state.ahead->trajectories.at_end.topRows<3>(), kMostAhead);
    check_motions("ahead/at_end", state.ahead->trajectories.at_end.middleRows<3>(3), kMostAhead);
  }
  check_forces(scene, state.trajectories);
  check_contacts(bodies, state.contacts);
  const auto model = compile(scene, needs_of(scene), start_time);
  const Trajectories trajectories(model, state.method);
  if (const auto fault =
          trajectories.fault_of(state.trajectories, state.ahead ? &state.ahead->trajectories : nullptr)) {
    const auto colon = fault->find(": ");
    refuse(fault->substr(0, colon), fault->substr(colon + 2));
  }
  if (state.ahead) check_ahead(bodies, model->shapes, trajectories, state);
}

}  // namespace carom
