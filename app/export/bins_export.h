#pragma once

#include <string>
#include <vector>

#include "widgets/plot/distribution.h"

namespace carom {

// The bins of a histogram plot as a table, a header and one line a bin: the distribution, from, to, count,
// share per width and, with a law, the expected count; all digits. `unit` is the unit of the values.
[[nodiscard]] std::vector<std::string> bins_table(const std::vector<ShownBins>& shown, const std::string& unit,
                                                  char separator);

// The same as a CSV file (RFC 4180). Throws SceneError if the file cannot be written.
void export_bins(const std::vector<ShownBins>& shown, const std::string& unit, const std::string& file);

}  // namespace carom
