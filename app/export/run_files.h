#pragma once

#include <span>
#include <string>
#include <vector>

#include "physics/observe/quantity.h"
#include "physics/run/simulation.h"

namespace carom {

// The CSV files of a run, by the rules of physics/files/csv.h. For the clipboard the separator is a tab.
//
// The columns of a run beside its time: sums of the scene, then x, y, angle, velocity and spin of each body
// that is not fixed, for up to kMostPaths of them (with more, the file would be some 100 MB; then only the
// sums are written), then the ledger.
inline constexpr int kMostPaths = 50;
[[nodiscard]] std::vector<Quantity> run_columns(const std::vector<Body>& bodies);

[[nodiscard]] std::string csv_header(const std::vector<Quantity>& columns, const std::vector<Body>& bodies,
                                     char separator = ',');
[[nodiscard]] std::string csv_line(double time, std::span<const double> values, char separator = ',');
// The row of the present state.
[[nodiscard]] std::string csv_line(const std::vector<Quantity>& columns, const Simulation& simulation);

[[nodiscard]] std::string events_csv_header(char separator = ',');
[[nodiscard]] std::string events_csv_line(const Simulation& simulation, const ImpactRecord& impact,
                                          char separator = ',');

}  // namespace carom
