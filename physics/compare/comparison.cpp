#include "physics/compare/comparison.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <vector>

#include "physics/compare/impact_matcher.h"
#include "physics/math/cancelled.h"
#include "physics/math/least_squares.h"
#include "physics/run/run_setup.h"

namespace carom {
namespace {

double finite_or_infinite(double distance) {
  return std::isfinite(distance) ? distance : std::numeric_limits<double>::infinity();
}
double apart(const Vec2& a, const Vec2& b) { return finite_or_infinite((a - b).norm()); }

constexpr std::size_t kLeastPoints = 3;
constexpr double kStraight = 0.05;  // of ln(error): largest distance from a straight line
constexpr double kLeastShare = 0.5;

}  // namespace

Comparison compare_states(const State& run, double run_energy, const State& reference, double reference_energy,
                          std::span<const MovingBody> moving, std::span<const std::uint8_t> awaiting) {
  Comparison c;
  for (const auto& [i, radius] : moving) {
    c.position_error = std::fmax(c.position_error, apart(run.position(i), reference.position(i)));
    const double turned = run.q.col(i)[2] - reference.q.col(i)[2];
    c.angle_error = std::fmax(c.angle_error, finite_or_infinite(radius * std::abs(turned)));
    if (!awaiting.empty() && awaiting[static_cast<std::size_t>(i)] != 0) {
      ++c.left_out;
      continue;
    }
    c.velocity_error = std::fmax(c.velocity_error, apart(run.velocity(i), reference.velocity(i)));
    const double spin = run.v.col(i)[2] - reference.v.col(i)[2];
    c.spin_error = std::fmax(c.spin_error, finite_or_infinite(radius * std::abs(spin)));
  }
  if (c.left_out == 0) c.energy_error = std::abs(run_energy - reference_energy);
  return c;
}

Comparison compare(const RunSummary& run, const RunSummary& reference, std::span<const MovingBody> moving,
                   double time) {
  Comparison c;
  if (run.blew_up_at >= 0.0 && run.blew_up_at < time) {
    c.unmatched = run.impact_count + reference.impact_count;
    c.left_out = static_cast<std::int64_t>(moving.size());
    return c;
  }

  using From = ImpactMatcher::From;
  ImpactMatcher matcher(ImpactMatcher::Partners::kInOrder);
  std::vector<std::uint8_t> awaiting(static_cast<std::size_t>(run.state.size()), 0);
  const auto each = [](const RunSummary& of, From from, const auto& take) {
    for (const TimedImpact& i : of.impacts) take(i, from);
  };
  const auto take_early = [&](const TimedImpact& i, From from) {
    if (i.time <= time) matcher.add(from, i.a, i.b, i.time);
  };
  const auto take_late = [&](const TimedImpact& i, From from) {
    if (i.time <= time || !matcher.take_partner(from, i.a, i.b, i.time)) return;
    awaiting[static_cast<std::size_t>(i.a)] = 1;
    awaiting[static_cast<std::size_t>(i.b)] = 1;
  };
  each(run, From::kRun, take_early);
  each(reference, From::kReference, take_early);
  each(run, From::kRun, take_late);
  each(reference, From::kReference, take_late);
  matcher.give_all_up();

  c = compare_states(run.state, run.energy, reference.state, reference.energy, moving, awaiting);
  c.matched = matcher.matched();
  c.unmatched = matcher.unmatched();
  if (c.matched > 0) c.impact_time_error = matcher.largest_difference();
  return c;
}

RunSummary run_and_summarize(const RunSetup& setup, const Method& method, double time, double until,
                             double blown_up_above, const std::stop_token& stop) {
  RunSetup with_method = setup;
  with_method.method = method;
  Simulation s(with_method);
  RunSummary run;
  run.largest_kinetic = s.totals().kinetic();
  const bool lasts = contacts_last(method, s.needs());
  // The same steps as Simulation::advance_to() takes, with a check after each: a run that blows up would
  // continue with millions of impacts a step.
  const auto advance = [&](double to) {
    while (true) {
      const double h = s.next_step(to);
      if (h == 0.0) return;
      throw_if_cancelled(stop);
      s.step(h);
      if (s.lost()) {
        run.blew_up_at = s.time();
        return;
      }
      if (!lasts) {
        for (const ImpactRecord& i : s.last_impacts()) run.impacts.push_back({i.time, i.a, i.b});
      }
      const double kinetic = s.totals().kinetic();
      run.largest_kinetic = std::fmax(run.largest_kinetic, kinetic);
      if (!(kinetic <= blown_up_above)) {
        run.blew_up_at = s.time();
        return;
      }
    }
  };
  advance(time);
  run.state = s.state();
  run.energy = s.totals().energy();
  run.steps = s.steps();
  run.impact_count = s.impact_count();
  run.evaluations = s.evaluations();
  run.rejected_steps = s.rejected_steps();
  run.status = s.notices_text();
  if (run.blew_up_at < 0.0) advance(until);
  run.resting_since = s.notices().resting_since;
  if (run.blew_up_at >= 0.0 && run.blew_up_at < time) {
    run.status = fmt::format("blew up: ended at t = {:.6g} s", run.blew_up_at);
  }
  return run;
}

std::vector<MovingBody> moving_bodies(const std::vector<Body>& bodies) {
  std::vector<MovingBody> moving;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (!has_infinite_mass(bodies[i])) moving.push_back({static_cast<int>(i), turning_radius(bodies[i])});
  }
  return moving;
}

OrderFit fit_order(std::span<const ErrorAtStep> errors, double floor, double largest) {
  OrderFit fit;
  std::vector<Vec2> points;  // of ln(step) and ln(error)
  bool any = false;
  bool exact = true;
  for (const ErrorAtStep& e : errors) {
    if (std::isnan(e.error)) continue;
    any = true;
    exact = exact && e.error <= kExactBelowFloor * floor;
    if (e.error > kFittedAboveFloor * floor && e.error < largest) {
      points.emplace_back(std::log(e.step), std::log(e.error));
    }
  }
  if (any && exact) {
    fit.kind = OrderFit::Kind::kExact;
    return fit;
  }
  std::sort(points.begin(), points.end(), [](const Vec2& p, const Vec2& q) { return p.x() < q.x(); });
  const auto same_step = std::adjacent_find(points.begin(), points.end(),
                                            [](const Vec2& p, const Vec2& q) { return p.x() == q.x(); });
  if (points.size() < kLeastPoints || same_step != points.end()) return fit;

  // The finest steps always count: only coarse steps are left out.
  std::span<const Vec2> best = points;
  const auto needed = std::max(
      kLeastPoints, static_cast<std::size_t>(std::ceil(kLeastShare * static_cast<double>(points.size()))));
  for (std::size_t count = points.size(); count >= needed; --count) {
    const auto finest = std::span<const Vec2>(points).first(count);
    if (fit_line(finest).farthest > kStraight) continue;
    best = finest;
    break;
  }
  const Line line = fit_line(best);
  fit.kind = OrderFit::Kind::kOrder;
  fit.order = std::abs(line.slope) < 5e-3 ? 0.0 : line.slope;  // not "-0.00" where nothing changes
  fit.uncertainty = line.uncertainty;
  fit.from = std::exp(best.front().x());
  fit.to = std::exp(best.back().x());
  fit.points = static_cast<int>(best.size());
  return fit;
}

std::string text_of(const OrderFit& fit) {
  switch (fit.kind) {
    case OrderFit::Kind::kExact:
      return "exact here";
    case OrderFit::Kind::kNone:
      return "no order";
    case OrderFit::Kind::kOrder:
      break;
  }
  return fmt::format("{:.2f} ± {:.2f}", fit.order, fit.uncertainty);
}

}  // namespace carom
