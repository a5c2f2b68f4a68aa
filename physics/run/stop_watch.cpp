#include "physics/run/stop_watch.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "physics/ledger/totals.h"
#include "physics/math/roots.h"
#include "physics/step/coming_to_rest.h"
#include "physics/step/pair_motion.h"

namespace carom {
namespace {

// m/s: a bound of the speed of any point of a body that forces move.
double fastest(const Simulation& run) {
  double most = 0.0;
  for (int i = 0; i < run.state().size(); ++i) {
    if (!(run.mass().inverse_mass[i] > 0.0)) continue;
    const double reach = run.mass().inverse_inertia[i] > 0.0 ? run.shapes().reach[i] : 0.0;
    most = std::max(most, run.state().velocity(i).norm() + reach * std::abs(run.state().v.col(i)[2]));
  }
  return most;
}

// Nothing rests where nothing can move.
bool at_rest(const Simulation& run) {
  return (run.mass().inverse_mass.array() > 0.0).any() && fastest(run) <= kRestSpeed;
}

// If nobody adds anything.
bool stays_at_rest(Simulation run) {
  run.set_edits({});
  const double end = run.time() + StopWatch::kRestLasts;
  while (!run.lost() && at_rest(run)) {
    const double h = run.next_step(end);
    if (h == 0.0) return true;
    run.step(h);
  }
  return false;
}

// Of q and v.
int row_of(StopQuantity quantity) {
  return quantity == StopQuantity::kX ? 0 : quantity == StopQuantity::kY ? 1 : 2;
}

// J or the unit of the body's quantity.
double value_of(const Stop& stop, BodyIndex body, const State& state, const MassProperties& mass) {
  if (stop.kind == StopKind::kKineticEnergy) return kinetic_energy(state, mass);
  if (stop.quantity != StopQuantity::kSpeed) return state.q.col(body)[row_of(stop.quantity)];
  return state.velocity(body).norm();
}

// Of what turns smoothly: the square of a speed, with its sign.
double smooth(const Stop& stop, double value) {
  const bool speed = stop.kind == StopKind::kPassing && stop.quantity == StopQuantity::kSpeed;
  return speed ? value * std::abs(value) : value;
}

// W: by the forces.
double power(const State& state, const MassProperties& mass, const Eigen::Matrix3Xd& accelerations) {
  double power = 0.0;
  for (int i = 0; i < state.size(); ++i) {
    if (!(mass.inverse_mass[i] > 0.0)) continue;
    const auto v = state.v.col(i);
    const auto a = accelerations.col(i);
    power += mass.mass[i] * v.head<2>().dot(a.head<2>()) + mass.inertia[i] * v[2] * a[2];
  }
  return power;
}

// Of the smooth value, a second.
double rate_of(const Stop& stop, BodyIndex body, const Simulation& run, const State& state, double time) {
  if (stop.kind == StopKind::kKineticEnergy) return power(state, run.mass(), run.accelerations(state, time));
  if (stop.quantity != StopQuantity::kSpeed) return state.v.col(body)[row_of(stop.quantity)];
  return 2.0 * state.velocity(body).dot(run.accelerations(state, time, body).col(body).head<2>());
}

double bound_of(const Stop& stop) { return stop.kind == StopKind::kPassing ? stop.value : stop.below; }

bool passes(const Stop& stop) {
  return stop.kind == StopKind::kPassing || stop.kind == StopKind::kKineticEnergy;
}

// 1 where it comes from below and rises, -1 where it falls from above, if it may pass that way; else 0.
double sign_of(const Stop& stop, double value) {
  const bool may_rise = stop.kind == StopKind::kPassing && stop.way != PassingWay::kDownwards;
  const bool may_fall = stop.kind == StopKind::kKineticEnergy || stop.way != PassingWay::kUpwards;
  if (value < bound_of(stop)) return may_rise ? 1.0 : 0.0;
  return value > bound_of(stop) && may_fall ? -1.0 : 0.0;
}

}  // namespace

StopWatch::StopWatch(const std::vector<Stop>& stops) {
  for (const Stop& stop : stops) watched_.push_back({.stop = stop});
}

StopWatch::StopWatch(const std::vector<Stop>& stops, Simulation& run) : StopWatch(stops) {
  if (std::any_of(stops.begin(), stops.end(), passes)) run.watch_impacts(true);
}

void StopWatch::find_bodies(const Simulation& run) {
  if (model_ == run.model()) return;
  model_ = run.model();
  const auto index = [&run](const std::string& name) {
    if (name.empty()) return kNoBody;
    const auto found = std::find_if(run.bodies().begin(), run.bodies().end(),
                                    [&name](const Body& body) { return body.name == name; });
    return found == run.bodies().end() ? kNoBody : BodyIndex{static_cast<int>(found - run.bodies().begin())};
  };
  for (Watched& each : watched_) {
    each.body = index(each.stop.body);
    each.with = index(each.stop.with);
  }
}

// s: the step ends where the clock comes to a stop.
double StopWatch::clipped(const Simulation& run, double h) const {
  for (const Watched& each : watched_) {
    if (each.stop.kind != StopKind::kTime) continue;
    const double left = step_towards(each.stop.time, run.time(), run.method().step);
    if (left > 0.0) h = std::min(h, left);
  }
  return h;
}

void StopWatch::begin(const Simulation& run, double h) {
  find_bodies(run);
  start_ = run.time();
  length_ = h;
  looks_.assign(watched_.size(), {});
  for (std::size_t i = 0; i < watched_.size(); ++i) {
    if (is_there(watched_[i])) looks_[i] = look(watched_[i], run, run.state(), 0.0);
  }
  rests_ = at_rest(run);
  again_.begins(run, h);
}

std::optional<std::size_t> StopWatch::step(Simulation& run, double h) {
  if (watched_.empty()) {
    run.step(h);
    return std::nullopt;
  }
  begin(run, clipped(run, h));
  run.step(length_);
  if (run.lost()) return std::nullopt;
  const std::vector<Coming> coming = coming_in(run);
  if (!coming.empty() && lies_within(coming.front())) {
    run = step_to(coming.front()).second;
    again_.forget();
  }
  for (Watched& each : watched_) count_impacts(each, run);
  return coming.empty() ? std::nullopt : std::optional(coming.front().stop);
}

void StopWatch::begins(const Simulation& run) {
  if (!watched_.empty()) begin(run, run.next_step());
}

std::vector<MetStop> StopWatch::moments(const Simulation& run) {
  std::vector<MetStop> met;
  if (watched_.empty() || run.lost()) return met;
  for (const Coming& each : coming_in(run)) {
    MetStop stop{.stop = each.stop, .time = run.time(), .step_start = start_};
    if (lies_within(each)) {
      const auto [length, there] = step_to(each);
      stop.time = there.time();
      if (length < length_) stop.part = length;
    }
    met.push_back(stop);
  }
  for (Watched& each : watched_) count_impacts(each, run);
  return met;
}

void StopWatch::go_back(double time) {
  again_.forget();
  for (Watched& each : watched_) std::erase_if(each.impacts, [time](double impact) { return impact > time; });
}

std::vector<StopWatch::Coming> StopWatch::coming_in(const Simulation& run) {
  std::vector<Coming> coming;
  for (std::size_t i = 0; i < watched_.size(); ++i) add_coming(i, run, coming);
  std::stable_sort(coming.begin(), coming.end(),
                   [](const Coming& a, const Coming& b) { return a.after < b.after; });
  return coming;
}

void StopWatch::add_coming(std::size_t index, const Simulation& run, std::vector<Coming>& coming) {
  const Stop& stop = watched_[index].stop;
  switch (stop.kind) {
    case StopKind::kTime: {
      const double same = kSameMoment * run.method().step;
      if (stop.time > start_ + same && stop.time <= run.time() + same)
        coming.push_back({.stop = index, .after = std::min(stop.time - start_, length_)});
      return;
    }
    case StopKind::kImpact:
    case StopKind::kEveryImpact:
      return add_impacts(index, run, coming);
    case StopKind::kPassing:
    case StopKind::kKineticEnergy:
      return add_passings(index, run, coming);
    case StopKind::kRest:
      if (const std::optional<double> after = rest_in(run)) coming.push_back({.stop = index, .after = *after});
  }
}

bool StopWatch::is_of(const Watched& watched, const ImpactRecord& impact, const MassProperties& mass) {
  const Stop& stop = watched.stop;
  const auto between = [&](int one, BodyIndex other) {
    return (stop.body.empty() || one == watched.body) && (stop.with.empty() || other == watched.with) &&
           (!stop.with_wall || !(mass.inverse_mass[other] > 0.0));
  };
  return between(impact.a, impact.b) || between(impact.b, impact.a);
}

std::int64_t StopWatch::impacts_of(const Watched& watched, const Simulation& run) {
  return std::count_if(run.last_impacts().begin(), run.last_impacts().end(),
                       [&](const ImpactRecord& impact) { return is_of(watched, impact, run.mass()); });
}

void StopWatch::count_impacts(Watched& watched, const Simulation& run) {
  if (watched.stop.kind != StopKind::kImpact) return;
  for (const ImpactRecord& impact : run.last_impacts()) {
    const bool more = std::ssize(watched.impacts) < watched.stop.number;
    if (more && is_of(watched, impact, run.mass())) watched.impacts.push_back(impact.time);
  }
}

void StopWatch::add_impacts(std::size_t index, const Simulation& run, std::vector<Coming>& coming) const {
  const Watched& watched = watched_[index];
  const bool every = watched.stop.kind == StopKind::kEveryImpact;
  const std::int64_t left = watched.stop.number - std::ssize(watched.impacts);
  std::int64_t impacts = 0;
  for (const ImpactRecord& impact : run.last_impacts()) {
    if (!is_of(watched, impact, run.mass())) continue;
    ++impacts;
    if (!every && impacts != left) continue;
    const double just_after = std::nextafter(impact.time, std::numeric_limits<double>::infinity());
    coming.push_back({.stop = index, .after = just_after - start_, .impacts = impacts});
  }
}

StopWatch::Look StopWatch::look(const Watched& watched, const Simulation& run, const State& state,
                                double after) const {
  return {after, value_of(watched.stop, watched.body, state, run.mass()),
          rate_of(watched.stop, watched.body, run, state, start_ + after)};
}

StopWatch::Look StopWatch::look_at(const Watched& watched, double after) {
  const Simulation part = again_.made(after);
  return look(watched, part, part.state(), after);
}

void StopWatch::add_passings(std::size_t index, const Simulation& run, std::vector<Coming>& coming) {
  const Watched& watched = watched_[index];
  if (!is_there(watched)) return;
  std::vector<Look> looks{looks_[index]};
  const auto add = [&](const State& state, double after) {
    const Look next{after, value_of(watched.stop, watched.body, state, run.mass())};
    if (const auto turn = turn_between(watched, looks.back(), next, run, state)) looks.push_back(*turn);
    looks.push_back(next);
  };
  for (const Jump& jump : run.last_jumps()) {
    add(jump.before, jump.time - start_);
    looks.push_back(look(watched, run, jump.after, jump.time - start_));
  }
  add(run.state(), length_);
  for (std::size_t i = 1; i < looks.size(); ++i) {
    const double sign = sign_of(watched.stop, looks[i - 1].value);
    if (sign * (looks[i].value - bound_of(watched.stop)) < 0.0 || sign == 0.0) continue;
    coming.push_back({.stop = index, .after = moment_between(watched, looks[i - 1], looks[i]), .sign = sign});
  }
}

// Where the value turns back, if its tangents lead beyond its bound.
std::optional<StopWatch::Look> StopWatch::turn_between(const Watched& watched, const Look& a, const Look& b,
                                                       const Simulation& run, const State& state) {
  const double towards = a.value < bound_of(watched.stop) ? 1.0 : -1.0;
  const double span = b.after - a.after;
  const auto beyond = [&](double value, double change) {
    return towards * (smooth(watched.stop, value) + change - smooth(watched.stop, bound_of(watched.stop)));
  };
  const bool may_turn =
      towards * a.rate > 0.0 && beyond(b.value, 0.0) < 0.0 && beyond(a.value, a.rate * span) > 0.0;
  if (!may_turn) return std::nullopt;
  const double then = rate_of(watched.stop, watched.body, run, state, start_ + b.after);
  if (!(towards * then < 0.0 && beyond(b.value, -then * span) > 0.0)) return std::nullopt;
  const auto rate = [&](double after) { return towards * look_at(watched, after).rate; };
  return look_at(watched, bracketed_root(rate, a.after, towards * a.rate, b.after, towards * then));
}

// s after the step's start: when the value comes to its bound, which lies between two looks.
double StopWatch::moment_between(const Watched& watched, const Look& a, const Look& b) {
  const double bound = bound_of(watched.stop);
  const double sign = a.value < bound ? 1.0 : -1.0;
  const auto beyond = [&](double after) { return sign * (look_at(watched, after).value - bound); };
  if (b.value == bound || b.after <= a.after) return b.after;
  return bracketed_root(beyond, b.after, sign * (b.value - bound), a.after, sign * (a.value - bound));
}

std::optional<double> StopWatch::rest_in(const Simulation& run) {
  if (rests_ || !at_rest(run) || !stays_at_rest(run)) return std::nullopt;
  const double slower = kRestSpeed - fastest(run);
  if (!(slower > 0.0)) return length_;
  return bracketed_root([&](double after) { return kRestSpeed - fastest(again_.made(after)); }, length_, slower,
                        0.0, kRestSpeed - fastest(again_.made(0.0)));
}

bool StopWatch::has_come(const Coming& coming, const Simulation& run) const {
  const Watched& watched = watched_[coming.stop];
  if (passes(watched.stop)) {
    const double value = value_of(watched.stop, watched.body, run.state(), run.mass());
    return coming.sign * (value - bound_of(watched.stop)) >= 0.0;
  }
  return watched.stop.kind == StopKind::kRest ? at_rest(run) : impacts_of(watched, run) >= coming.impacts;
}

// A little later where rounding, or the forces of contacts in a shorter step, leave it just before.
std::pair<double, Simulation> StopWatch::step_to(const Coming& coming) {
  const double rounding = std::numeric_limits<double>::epsilon() * std::max(start_, length_);
  for (double later = 0.0;; later = std::max(2.0 * later, rounding)) {
    const double after = std::min(coming.after + later, length_);
    Simulation part = again_.made(after);
    if (after == length_ || has_come(coming, part)) return {after, std::move(part)};
  }
}

}  // namespace carom
