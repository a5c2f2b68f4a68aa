#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "physics/dynamics/integrators/integrators.h"
#include "physics/scene/plain_text.h"
#include "physics/study/study_table.h"

namespace carom {
namespace {

std::string error(double value) { return std::isnan(value) ? "-" : fmt::format("{:.2e}", value); }

// A time in a suitable unit.
std::string duration(double seconds) {
  if (std::isnan(seconds)) return "-";
  if (seconds < 1e-3) return fmt::format("{:.3g} µs", seconds * 1e6);
  if (seconds < 1.0) return fmt::format("{:.3g} ms", seconds * 1e3);
  return fmt::format("{:.3g} s", seconds);
}

// Right-aligned by visible width: µ and ± have two bytes.
std::string right(const std::string& text, std::size_t width) {
  const auto seen = static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; }));
  return std::string(seen < width ? width - seen : 0, ' ') + text;
}

std::string range_text(const StudyGroup& g) {
  const OrderFit& fit = g.verdict();
  if (fit.kind == OrderFit::Kind::kExact) return ", no order: every error is rounding";
  if (fit.kind == OrderFit::Kind::kNone)
    return ": fewer than three errors are above rounding and small enough to fit";
  const bool adaptive = error_parameter(g.rows.front().method) == ErrorParameter::kTolerance;
  return fmt::format(" in {}, fitted on {} from {:.3g} to {:.3g} {}, {} points",
                     g.is_of_angle() ? "angle (positions are exact)" : "position",
                     adaptive ? "tolerances" : "steps", fit.from, fit.to, adaptive ? "m" : "s", fit.points);
}

std::string group_text(const StudyGroup& g) {
  const auto& integrator = choice_of(kIntegrators, g.integrator);
  std::string out = fmt::format("{}, {}: {}{}{}\n", integrator.label, choice_of(kImpacts, g.impacts).label,
                                g.verdict().kind == OrderFit::Kind::kOrder ? "order " : "",
                                text_of(g.verdict()), range_text(g));
  const bool adaptive = error_parameter(g.rows.front().method) == ErrorParameter::kTolerance;
  out += fmt::format(
      "{:>10} {:>11} {:>13} {:>10} {:>10} {:>10} {:>14} {:>10} {:>21} {:>11} {:>9} {:>8} {:>7}\n",
      adaptive ? "toler. / m" : "step / s", "position/m", "velocity/m/s", "angle/m", "spin/m/s", "energy/J",
      "impact times/s", "wall time", "least to most", "evaluations", "rejected", "impacts", "no pair");
  for (const StudyRow& r : g.rows) {
    const auto step = r.step_or_tolerance();
    const std::string spread =
        std::isnan(r.wall_least) ? "-" : fmt::format("{} to {}", duration(r.wall_least), duration(r.wall_most));
    out += fmt::format("{:>10} {:>11} {:>13} {:>10} {:>10} {:>10} {:>14} {} {} {:>11} {:>9} {:>8} {:>7}{}\n",
                       step ? fmt::format("{:.4g}", *step) : "-", error(r.position_error),
                       error(r.velocity_error), error(r.angle_error), error(r.spin_error),
                       error(r.energy_error), error(r.impact_time_error), right(duration(r.wall_time), 10),
                       right(spread, 21), r.evaluations, r.rejected_steps, r.impacts, r.unmatched,
                       r.status == "ok" ? "" : "  " + r.status);
    if (r.left_out > 0 && r.status == "ok") {
      out.pop_back();
      out += fmt::format("  {} bod{} left out, within an impact's window\n", r.left_out,
                         r.left_out == 1 ? "y" : "ies");
    }
  }
  return out + '\n';
}

std::string orders_text(const std::vector<StudyGroup>& groups) {
  std::string out = fmt::format("{:<32}", "order in position");
  for (const auto& impacts : kImpacts) out += right(std::string(impacts.label), 28);
  out += '\n';
  for (const IntegratorChoice& integrator : kIntegrators) {
    std::string line = fmt::format("{:<32}", integrator.label);
    bool any = false;
    for (const auto& impacts : kImpacts) {
      const auto g = std::find_if(groups.begin(), groups.end(), [&](const StudyGroup& one) {
        return one.integrator == integrator.id && one.impacts == impacts.id;
      });
      any = any || g != groups.end();
      line += right(g == groups.end() ? "" : text_of(g->verdict()) + (g->is_of_angle() ? " in angle" : ""), 28);
    }
    if (any) out += line + '\n';
  }
  return out;
}

}  // namespace

std::string compared_text(const StudyFacts& f) {
  std::string out = fmt::format("compared at t = {:.6g} s", f.time);
  if (f.time < f.duration) out += fmt::format(" of {:.6g} s", f.duration);
  if (!f.remarks.empty()) out += "; " + f.remarks;
  return out;
}

std::string reference_text(const StudyFacts& f) {
  std::string out =
      fmt::format("reference: {}; its own error about {:.1e} m, {:.1e} m/s, {:.1e} J, of angles {:.1e} m",
                  f.reference, f.reference_position_error, f.reference_velocity_error, f.reference_energy_error,
                  f.reference_angle_error);
  if (!f.stated.empty()) out += "; " + f.stated;
  return out;
}

std::string horizon_text(const StudyFacts& f) {
  const std::string rounding =
      fmt::format("neighbours part by a factor of {:.3g} until then, so rounding grows to {:.1e} m", f.growth,
                  f.rounding_floor());
  if (f.exponent > 0.0) {
    return fmt::format(
        "CHAOTIC: neighbours part as e^(t · {:.3g}/s); rounding begins to show at t = {:.3g} s, the "
        "horizon beyond which no comparison means anything; {}",
        f.exponent, f.horizon, rounding);
  }
  if (std::isfinite(f.horizon)) {
    return fmt::format(
        "neighbours part at once at t = {:.3g} s (impacts change their order): no comparison means "
        "anything beyond; {}",
        f.horizon, rounding);
  }
  return "not chaotic: " + rounding;
}

std::string study_text(const StudyTable& table) {
  const StudyFacts& f = table.facts;
  std::string out =
      fmt::format("{}\n{}\n{}\n{}\n", printable(f.title), compared_text(f), reference_text(f), horizon_text(f));
  out += fmt::format(
      "errors: the largest over the moving bodies' centres, and over their angles times how far they reach "
      "from "
      "them; times: median of {} run{} to the compared time\n\n",
      f.repeats, f.repeats == 1 ? "" : "s");
  const std::vector<StudyGroup> groups = groups_of(table);
  for (const StudyGroup& g : groups) out += group_text(g);
  return out + orders_text(groups);
}

}  // namespace carom
