#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <fmt/format.h>
#include <string>
#include <vector>

#include "physics/compare/chaos.h"
#include "physics/ledger/ledger_entries.h"
#include "physics/preset/preset.h"
#include "physics/preset/preset_file.h"
#include "physics/run/checkpoint.h"
#include "physics/run/run_state.h"
#include "physics/run/simulation.h"
#include "physics/scene/fingerprint.h"
#include "physics/scene/validate.h"

// Compares a run with one that was kept and continued: through a file to rounding, in memory to the last bit.
namespace carom::test {

// Through a file's text, exact to the last bit.
inline Preset saved_and_read(const Preset& document, const Simulation& simulation) {
  return parse_preset(write_preset(saved_preset(document, simulation)), "saved");
}

inline Simulation kept_and_restored(const Simulation& simulation) {
  return {simulation.compiled(), simulation.run_state()};
}

// All that a run reports and all that a file keeps of it: two runs with the same text are equal.
inline std::string all_of(const Preset& document, const Simulation& s) {
  std::string text = s.notices().text() + "\n";
  const auto bytes = [&](const auto& matrix) {
    text.append(reinterpret_cast<const char*>(matrix.data()), sizeof(double) * matrix.size());
  };
  bytes(s.state().q);
  bytes(s.state().v);
  bytes(s.state().quadratures);
  const Ledger ledger = s.ledger();
  text.append(reinterpret_cast<const char*>(&ledger), sizeof(ledger));
  try {
    text += write_preset(saved_preset(document, s));
  } catch (const SceneError& error) {
    text += error.what();  // it has blown up
  }
  return text;
}

// To `tolerance`, relative to 1 or to the larger of the values or to their scale.
inline bool near(double x, double y, double tolerance, double scale = 0.0) {
  return x == y || std::abs(x - y) <= tolerance * std::max({1.0, scale, std::abs(x), std::abs(y)});
}

// The first place or velocity that is not the same to `tolerance` in two runs of the same bodies; nothing if
// all are.
inline std::string difference_of_motions(const Simulation& a, const Simulation& b, double tolerance) {
  for (int i = 0; i < a.state().size(); ++i) {
    const std::string& name = a.bodies()[static_cast<std::size_t>(i)].name;
    for (int row = 0; row < 3; ++row) {
      if (!near(a.state().q(row, i), b.state().q(row, i), tolerance))
        return fmt::format("{}: place {} {} and {}", name, row, a.state().q(row, i), b.state().q(row, i));
      if (!near(a.state().v(row, i), b.state().v(row, i), tolerance))
        return fmt::format("{}: velocity {} {} and {}", name, row, a.state().v(row, i), b.state().v(row, i));
    }
  }
  return {};
}

// What a run reports that is not the same to `tolerance`; nothing if all is.
inline std::string difference(const Simulation& a, const Simulation& b, double tolerance) {
  if (a.lost().has_value() != b.lost().has_value()) return "one run is lost";
  if (a.bodies().size() != b.bodies().size()) return "bodies";
  if (a.joints().size() != b.joints().size()) return "joints";
  if (!near(a.time(), b.time(), tolerance)) return fmt::format("time {} and {}", a.time(), b.time());
  if (a.steps() != b.steps()) return fmt::format("steps {} and {}", a.steps(), b.steps());
  if (a.impact_count() != b.impact_count())
    return fmt::format("{} and {} impacts", a.impact_count(), b.impact_count());
  const std::string motions = difference_of_motions(a, b, tolerance);
  if (!motions.empty()) return motions;
  for (std::size_t i = 0; i < a.joints().size(); ++i) {
    const auto joint = JointIndex{static_cast<int>(i)};
    if (a.joints()[i].kind == JointKind::kString && a.is_taut(joint) != b.is_taut(joint))
      return fmt::format("string {} is taut in one run", i);
  }
  const Ledger la = a.ledger();
  const Ledger lb = b.ledger();
  for (const EnergyEntry& entry : kEnergyEntries) {
    if (!near(la.*entry.value, lb.*entry.value, tolerance, la.turnover()))
      return fmt::format("{} {} and {}", entry.key, la.*entry.value, lb.*entry.value);
  }
  for (const MomentumEntry& entry : kMomentumEntries) {
    for (int k = 0; k < 2; ++k) {
      if (!near((la.*entry.value)[k], (lb.*entry.value)[k], tolerance))
        return fmt::format("{} {} and {}", entry.key, (la.*entry.value)[k], (lb.*entry.value)[k]);
    }
    if (!near(la.*entry.angular, lb.*entry.angular, tolerance))
      return fmt::format("{} {} and {}", entry.angular_key, la.*entry.angular, lb.*entry.angular);
  }
  // Without the names of bodies, which files of earlier versions don't keep.
  if (a.notices().text() != b.notices().text())
    return fmt::format("'{}' and '{}'", a.notices().text(), b.notices().text());
  return {};
}

// How far a run that is continued from a file may be from the uninterrupted one: rounding; the adaptive method
// chooses its steps anew, each as wrong as its tolerance allows.
inline double resumed_tolerance(const Method& method) {
  const bool adaptive = method.integrator == IntegratorId::kAdaptiveDormandPrince;
  return adaptive && method.tolerance > 1e-9 ? 10.0 * method.tolerance : 1e-9;
}

// Whether a run of the adaptive method is as close to the same run under a hundredth of its tolerance as a
// resumed run must be to it: where forces change faster than its error estimate tells, it is not.
inline bool keeps_its_tolerance(const Simulation& whole, Preset preset) {
  const double tolerance = resumed_tolerance(preset.method);
  preset.method.tolerance *= 0.01;
  Simulation closer(setup_of(preset));
  closer.advance_to(whole.time());
  return difference_of_motions(whole, closer, tolerance).empty();
}

// What `resumed`, which started from `start` or from a file that was saved in such a run, does not share with
// `whole`; nothing if runs from places that differ by rounding differ likewise: then nothing follows from the
// start any more.
inline std::string unexplained(const Simulation& whole, const Simulation& resumed, const Preset& start) {
  const double tolerance = resumed_tolerance(start.method);
  const std::string what = difference(whole, resumed, tolerance);
  if (what.empty()) return {};
  for (const double displacement : {1e-12, 1e-15, -1e-15, 3e-16, -3e-16}) {
    for (const double change : {0.0, 1e-14, -1e-14}) {  // m/s and rad/s
      RunSetup setup = displaced(setup_of(start), displacement);
      for (Body& body : setup.scene.bodies) {
        if (has_infinite_mass(body)) continue;
        body.velocity += Vec2(change, -change);
        body.spin += change;
      }
      setup.saved->fingerprint = fingerprint(setup.scene, setup.saved->time);
      Simulation neighbour(setup);
      neighbour.advance_to(resumed.time());
      if (!difference(neighbour, resumed, tolerance).empty()) return {};
    }
  }
  return fmt::format("at {} s: {}", resumed.time(), what);
}

inline std::string events_of(const Simulation& s) {
  std::string text;
  for (const ImpactRecord& i : s.last_impacts()) {
    const double numbers[] = {i.time,
                              static_cast<double>(i.a),
                              static_cast<double>(i.b),
                              i.point.x(),
                              i.point.y(),
                              i.normal.x(),
                              i.normal.y(),
                              i.normal_impulse,
                              i.tangential_impulse,
                              i.closing_speed,
                              i.lost_to_restitution,
                              i.lost_to_friction,
                              i.lost_to_sticking};
    text.append(reinterpret_cast<const char*>(numbers), sizeof(numbers));
  }
  return text;
}

// The first place where two texts differ, with both texts there.
inline std::string parting(const std::string& a, const std::string& b) {
  if (a == b) return {};
  std::size_t at = 0;
  while (at < a.size() && at < b.size() && a[at] == b[at]) ++at;
  const std::size_t from = at > 60 ? at - 60 : 0;
  const auto printable = [&](const std::string& text) {
    std::string part = text.substr(from, 160);
    for (char& c : part) {
      if (c < 0x20 || c > 0x7e) c = '.';
    }
    return part;
  };
  return "at " + std::to_string(at) + ": '" + printable(a) + "' and '" + printable(b) + "'";
}

}  // namespace carom::test
