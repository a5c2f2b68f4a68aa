#include "app/export/run_report.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "physics/dynamics/integrators/integrators.h"
#include "physics/ledger/ledger_entries.h"
#include "physics/preset/preset.h"
#include "physics/scene/plain_text.h"

namespace carom {
namespace {

// Six significant digits, right aligned; never "-0".
std::string figure(double value) { return fmt::format("{:.6g}", value == 0.0 ? 0.0 : value); }

double kinetic(const Simulation& s, int i) {
  const double spin = s.state().v(2, i);
  return 0.5 * s.mass().mass[i] * s.state().velocity(i).squaredNorm() + 0.5 * s.mass().inertia[i] * spin * spin;
}

// 1 step, 2 steps.
std::string counted(std::int64_t count, const char* what) {
  return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

// Method, options and cost.
std::string method_text(const Simulation& s) {
  const Method& m = s.method();
  const IntegratorChoice& integrator = choice_of(kIntegrators, m.integrator);
  const std::string size = integrator.adaptive     ? fmt::format("tolerance {}", m.tolerance)
                           : integrator.order == 0 ? fmt::format("results every {} s", m.step)
                                                   : fmt::format("h = {} s", m.step);
  return fmt::format("{}, {}, {}, {}\n{}, {} of a body's acceleration, {}\n", integrator.label,
                     choice_of(kImpacts, m.impacts).label, choice_of(kContacts, m.contacts).label, size,
                     integrator.order > 0 ? fmt::format("order {}", integrator.order) : "exact",
                     counted(s.evaluations(), "evaluation"), counted(s.rejected_steps(), "rejected step"));
}

std::string ledger_text(const Ledger& ledger, const Totals& now) {
  std::string out = "\nwhere the energy went / J\n";
  const auto energy = [&](std::string_view what, double value) {
    out += fmt::format("{:<34} {:>14}\n", what, figure(value));
  };
  for (const EnergyEntry& entry : kEnergyEntries) energy(entry.name, ledger.*entry.value);
  energy("numerical drift", ledger.numerical_drift(now.energy()));

  out += fmt::format("\n{:<34} {:>14} {:>14} {:>18}\n", "where the momentum went / N s", "x", "y",
                     "angular / kg m²/s");
  const auto momentum = [&](std::string_view what, const Vec2& value, double angular) {
    out += fmt::format("{:<34} {:>14} {:>14} {:>18}\n", what, figure(value.x()), figure(value.y()),
                       figure(angular));
  };
  for (const MomentumEntry& entry : kMomentumEntries)
    momentum(entry.name, ledger.*entry.value, ledger.*entry.angular);
  momentum("numerical drift", ledger.momentum_drift(now.momentum),
           ledger.angular_momentum_drift(now.angular_momentum));
  return out;
}

}  // namespace

std::string report_text(const Preset& preset, const Simulation& start, const Simulation& end,
                        const std::optional<std::string>& stopped) {
  std::string out = fmt::format("{}\n{}", printable(preset.title), method_text(end));
  out += fmt::format("t = {} s after {}, {}\n", figure(end.time()), counted(end.steps(), "step"),
                     counted(end.impact_count(), "impact"));
  if (stopped) out += stopped->empty() ? "none of its stops came\n" : "stopped " + printable(*stopped) + "\n";
  out += '\n';

  std::size_t name_width = 4;
  for (const Body& b : end.bodies()) {
    if (!has_infinite_mass(b))
      name_width = std::max(name_width, std::min<std::size_t>(characters(printable(b.name)), 16));
  }
  out += fmt::format("{:<{}} {:>9} {:>22} {:>22} {:>11} {:>11} {:>11}\n", "body", name_width, "m / kg",
                     "v before / m/s", "v after / m/s", "spin / 1/s", "K before/J", "K after/J");
  int moving = 0;
  double mass = 0.0;
  for (int i = 0; i < end.state().size(); ++i) {
    if (has_infinite_mass(end.bodies()[i])) continue;
    mass += end.mass().mass[i];
    if (++moving > kMostRows) continue;
    const auto velocity = [i](const Simulation& s) {
      return fmt::format("{:>10} {:>10}", figure(s.state().v(0, i)), figure(s.state().v(1, i)));
    };
    out += fmt::format("{:<{}.{}} {:>9} {:>22} {:>22} {:>11} {:>11} {:>11}\n", printable(end.bodies()[i].name),
                       name_width, name_width, figure(end.mass().mass[i]), velocity(start), velocity(end),
                       figure(end.state().v(2, i)), figure(kinetic(start, i)), figure(kinetic(end, i)));
  }
  if (moving > kMostRows) out += fmt::format("... and {} more\n", moving - kMostRows);
  const Totals before = start.totals();
  const Totals after = end.totals();
  out += fmt::format("{:<{}} {:>9} {:>22} {:>22} {:>11} {:>11} {:>11}\n\n", "sum", name_width, figure(mass), "",
                     "", "", figure(before.kinetic()), figure(after.kinetic()));

  const auto row = [&](const char* what, double from, double to) {
    out += fmt::format("{:<34} {:>14} {:>14}\n", what, figure(from), figure(to));
  };
  out += fmt::format("{:<34} {:>14} {:>14}\n", "", "before", "after");
  row("kinetic energy / J", before.kinetic(), after.kinetic());
  row("  of rotation / J", before.rotational, after.rotational);
  row("potential energy / J", before.potential, after.potential);
  row("total energy / J", before.energy(), after.energy());
  row("momentum x / N s", before.momentum.x(), after.momentum.x());
  row("momentum y / N s", before.momentum.y(), after.momentum.y());
  row("angular momentum / kg m²/s", before.angular_momentum, after.angular_momentum);

  out += ledger_text(end.ledger(), after);
  out += fmt::format("\nstatus: {}\n", end.status());
  return out;
}

std::string report_json(const std::string& preset, const Simulation& end,
                        const std::optional<std::string>& stopped) {
  using Json = nlohmann::ordered_json;
  const auto pair = [](const Vec2& v) { return Json::array({v.x(), v.y()}); };
  const Method& m = end.method();
  const Totals totals = end.totals();
  const Ledger ledger = end.ledger();
  Json j;
  j["preset"] = preset;  // may not be UTF-8
  j["method"] = {{"integrator", choice_of(kIntegrators, m.integrator).name},
                 {"impacts", choice_of(kImpacts, m.impacts).name},
                 {"contacts", choice_of(kContacts, m.contacts).name}};
  if (choice_of(kIntegrators, m.integrator).adaptive) {
    j["method"]["tolerance"] = m.tolerance;
  } else {
    j["method"]["step"] = m.step;
  }
  j["order"] = choice_of(kIntegrators, m.integrator).order;
  j["time"] = end.time();
  if (stopped) j["stopped"] = stopped->empty() ? Json() : Json(*stopped);
  j["steps"] = end.steps();
  j["rejected_steps"] = end.rejected_steps();
  j["evaluations"] = end.evaluations();
  j["impacts"] = end.impact_count();
  j["bodies"] = Json::array();
  for (int i = 0; i < end.state().size(); ++i) {
    j["bodies"].push_back({{"name", end.bodies()[i].name},
                           {"position", pair(end.state().position(i))},
                           {"angle", end.state().q(2, i)},
                           {"velocity", pair(end.state().velocity(i))},
                           {"spin", end.state().v(2, i)}});
  }
  j["kinetic_energy"] = totals.kinetic();
  j["rotational_energy"] = totals.rotational;
  j["potential_energy"] = totals.potential;
  j["total_energy"] = totals.energy();
  j["momentum"] = pair(totals.momentum);
  j["angular_momentum"] = totals.angular_momentum;
  Json& quadratures = j["ledger"];
  for (const EnergyEntry& entry : kEnergyEntries) quadratures[std::string(entry.key)] = ledger.*entry.value;
  quadratures["numerical_drift"] = ledger.numerical_drift(totals.energy());
  Json& given = quadratures["momentum"];
  for (const MomentumEntry& entry : kMomentumEntries)
    given[std::string(entry.report_key)] = pair(ledger.*entry.value);
  given["numerical_drift"] = pair(ledger.momentum_drift(totals.momentum));
  Json& angular = quadratures["angular_momentum"];
  for (const MomentumEntry& entry : kMomentumEntries)
    angular[std::string(entry.report_key)] = ledger.*entry.angular;
  angular["numerical_drift"] = ledger.angular_momentum_drift(totals.angular_momentum);
  j["status"] = end.status();
  return j.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace carom
