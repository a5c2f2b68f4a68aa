#pragma once

#include <string>
#include <vector>

#include "widgets/distribution.h"

namespace carom {

// Writes the bins of a histogram plot as a CSV file (RFC 4180), one line a bin: which distribution, from, to,
// count, share over the width and, beside a law, the count that it expects; all digits. `unit` is that of the
// values. Throws SceneError if the file cannot be written.
void export_bins(const std::vector<ShownBins>& shown, const std::string& unit, const std::string& file);

}  // namespace carom
