#include "physics/compare/comparison.h"

#include <cmath>
#include <vector>

#include "physics/compare/impact_matcher.h"

namespace carom {
namespace {

double apart(const Vec2& a, const Vec2& b) {
  const double distance = (a - b).norm();
  return std::isfinite(distance) ? distance : std::numeric_limits<double>::infinity();
}

}  // namespace

Comparison compare_states(const State& run, double run_energy, const State& reference, double reference_energy,
                          std::span<const int> moving, std::span<const std::uint8_t> awaiting) {
  Comparison c;
  for (const int i : moving) {
    if (!awaiting.empty() && awaiting[static_cast<std::size_t>(i)] != 0) {
      ++c.left_out;
      continue;
    }
    c.position_error = std::fmax(c.position_error, apart(run.position(i), reference.position(i)));
    c.velocity_error = std::fmax(c.velocity_error, apart(run.velocity(i), reference.velocity(i)));
  }
  if (c.left_out == 0) c.energy_error = std::abs(run_energy - reference_energy);
  return c;
}

Comparison compare(const RunSummary& run, const RunSummary& reference, std::span<const int> moving,
                   double time) {
  Comparison c;
  if (run.blew_up_at >= 0.0 && run.blew_up_at < time) {
    c.unmatched = static_cast<int>(run.impact_count + reference.impact_count);
    c.left_out = static_cast<int>(moving.size());
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
  c.matched = static_cast<int>(matcher.matched());
  c.unmatched = static_cast<int>(matcher.unmatched());
  if (c.matched > 0) c.impact_time_error = matcher.largest_difference();
  return c;
}

}  // namespace carom
