#include "app/run_report.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "physics/motion/integrators.h"

namespace carom {
namespace {

// Six significant digits, right aligned; never "-0".
std::string figure(double value) { return fmt::format("{:.6g}", value == 0.0 ? 0.0 : value); }

double kinetic(const Simulation& s, int i) {
  const double spin = s.state().v(2, i);
  return 0.5 * s.mass().mass[i] * s.state().velocity(i).squaredNorm() + 0.5 * s.mass().inertia[i] * spin * spin;
}

}  // namespace

std::string report_text(const Scene& scene, const Simulation& start, const Simulation& end) {
  const Method& m = end.method();
  std::string out =
      fmt::format("{}\n{}, {}, {}, h = {} s\n", scene.title, choice_of(kIntegrators, m.integrator).label,
                  choice_of(kImpacts, m.impacts).label, choice_of(kContacts, m.contacts).label, m.step);
  out += fmt::format("t = {} s after {} steps, {} impact{}\n\n", figure(end.time()), end.steps(),
                     end.impact_count(), end.impact_count() == 1 ? "" : "s");

  std::size_t name_width = 4;
  for (const Body& b : end.bodies()) {
    if (!b.fixed) name_width = std::max(name_width, std::min<std::size_t>(b.name.size(), 16));
  }
  out += fmt::format("{:<{}} {:>9} {:>22} {:>22} {:>11} {:>11} {:>11}\n", "body", name_width, "m / kg",
                     "v before / m/s", "v after / m/s", "spin / 1/s", "K before/J", "K after/J");
  int moving = 0;
  double mass = 0.0;
  for (int i = 0; i < end.state().size(); ++i) {
    if (end.shapes().fixed[i] != 0) continue;
    mass += end.mass().mass[i];
    if (++moving > kMostRows) continue;
    const auto velocity = [i](const Simulation& s) {
      return fmt::format("{:>10} {:>10}", figure(s.state().v(0, i)), figure(s.state().v(1, i)));
    };
    out += fmt::format("{:<{}.{}} {:>9} {:>22} {:>22} {:>11} {:>11} {:>11}\n", end.bodies()[i].name, name_width,
                       name_width, figure(end.mass().mass[i]), velocity(start), velocity(end),
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

  const Ledger ledger = end.ledger();
  out += "\nwhere the energy went / J\n";
  const auto entry = [&](const char* what, double value) {
    out += fmt::format("{:<34} {:>14}\n", what, figure(value));
  };
  entry("lost to restitution", ledger.lost_to_restitution);
  entry("lost to friction", ledger.lost_to_friction);
  entry("lost to drag", ledger.lost_to_drag);
  entry("overlap correction", ledger.overlap_correction);
  entry("numerical drift", ledger.numerical_drift(after.energy()));
  out += fmt::format("\nstatus: {}\n", end.notices().text());
  return out;
}

std::string report_json(const std::string& preset, const Simulation& end) {
  using Json = nlohmann::ordered_json;
  const auto pair = [](const Vec2& v) { return Json::array({v.x(), v.y()}); };
  const Method& m = end.method();
  const Totals totals = end.totals();
  const Ledger ledger = end.ledger();
  Json j;
  j["preset"] = preset;
  j["method"] = {{"integrator", choice_of(kIntegrators, m.integrator).name},
                 {"impacts", choice_of(kImpacts, m.impacts).name},
                 {"contacts", choice_of(kContacts, m.contacts).name},
                 {"step", m.step}};
  j["time"] = end.time();
  j["steps"] = end.steps();
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
  j["ledger"] = {{"initial", ledger.initial},
                 {"lost_to_restitution", ledger.lost_to_restitution},
                 {"lost_to_friction", ledger.lost_to_friction},
                 {"lost_to_drag", ledger.lost_to_drag},
                 {"overlap_correction", ledger.overlap_correction},
                 {"put_in_by_user", ledger.put_in_by_user},
                 {"numerical_drift", ledger.numerical_drift(totals.energy())},
                 {"momentum_to_walls", pair(ledger.momentum_to_walls)}};
  j["status"] = end.notices().text();
  return j.dump(2) + "\n";
}

}  // namespace carom
