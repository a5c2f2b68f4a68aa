#include "app/bins_export.h"

#include <algorithm>
#include <fmt/format.h>

#include "app/run_files.h"

namespace carom {

void export_bins(const std::vector<ShownBins>& shown, const std::string& unit, const std::string& file) {
  TextFile out(file);
  const auto has_law = [](const ShownBins& s) { return s.law.thermal_energy() > 0.0; };
  const bool laws = std::any_of(shown.begin(), shown.end(), has_law);
  out.line(fmt::format("distribution,from [{0}],to [{0}],count [1],share over width [1/({0})]{1}", unit,
                       laws ? ",expected by Maxwell [1]" : ""));
  for (const ShownBins& s : shown) {
    const Histogram& h = s.bins;
    for (std::size_t k = 0; k < h.counts.size(); ++k) {
      std::string line = fmt::format("{},{},{},{},{}", csv_field(s.name.toStdString()), h.from(k),
                                     h.from(k + 1), h.counts[k], h.density(k));
      if (has_law(s)) {
        const double share = s.law.share_below(h.from(k + 1)) - s.law.share_below(h.from(k));
        line += fmt::format(",{}", share * static_cast<double>(h.total));
      } else if (laws) {
        line += ',';
      }
      out.line(line);
    }
  }
  out.finish();
}

}  // namespace carom
