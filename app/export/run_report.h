#pragma once

#include <string>
#include <vector>

#include "physics/preset/preset.h"
#include "physics/run/simulation.h"

namespace carom {

// The report of a run, as text: method and its cost, table of the bodies before and after, energies, momenta,
// ledger of energy and momentum, status. Lists at most the first kMostRows bodies; the sums include all.
inline constexpr int kMostRows = 20;
[[nodiscard]] std::string report_text(const Preset& preset, const Simulation& start, const Simulation& end);

// The same as one JSON object: preset, method {integrator, impacts, contacts, step or tolerance}, order (0:
// exact), time, steps, rejected_steps, evaluations, impacts, bodies [{name, position, angle, velocity, spin}],
// kinetic_energy, potential_energy, momentum, angular_momentum, ledger {..., momentum {...}}, status.
[[nodiscard]] std::string report_json(const std::string& preset, const Simulation& end);

}  // namespace carom
