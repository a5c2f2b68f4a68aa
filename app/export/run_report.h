#pragma once

#include <optional>
#include <string>
#include <vector>

#include "physics/preset/preset.h"
#include "physics/run/simulation.h"

namespace carom {

// The report of a run, as text: method and its cost, table of the bodies before and after, energies, momenta,
// ledger of energy and momentum, status. Lists at most the first kMostRows bodies; the sums include all.
// `stopped` is the sentence of the stop that ended it, empty if it had stops and none came, nothing if it had
// none.
inline constexpr int kMostRows = 20;
[[nodiscard]] std::string report_text(const Preset& preset, const Simulation& start, const Simulation& end,
                                      const std::optional<std::string>& stopped);

// The same as one JSON object: preset, method {integrator, impacts, contacts, step or tolerance}, order (0:
// exact), time, stopped (the sentence or null, if it had stops), steps, rejected_steps, evaluations, impacts,
// bodies [{name, position, angle, velocity, spin}], kinetic_energy, potential_energy, momentum,
// angular_momentum, ledger {..., momentum {...}}, status.
[[nodiscard]] std::string report_json(const std::string& preset, const Simulation& end,
                                      const std::optional<std::string>& stopped);

}  // namespace carom
