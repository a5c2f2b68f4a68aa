#include "app/export/bins_export.h"

#include <algorithm>
#include <fmt/format.h>
#include <limits>

#include "physics/files/csv.h"
#include "physics/files/output_file.h"

namespace carom {

std::vector<std::string> bins_table(const std::vector<ShownBins>& shown, const std::string& unit,
                                    char separator) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  const auto has_law = [](const ShownBins& s) { return s.law.thermal_energy() > 0.0; };
  const bool laws = std::any_of(shown.begin(), shown.end(), has_law);
  CsvLine header(separator);
  header.add("distribution").add(csv_heading("from", unit)).add(csv_heading("to", unit));
  header.add(csv_heading("count", "1")).add(csv_heading("share over width", "1/(" + unit + ")"));
  if (laws) header.add(csv_heading("expected by Maxwell", "1"));
  std::vector<std::string> table = {header.text()};
  for (const ShownBins& s : shown) {
    const Histogram& h = s.bins;
    for (std::size_t k = 0; k < h.counts.size(); ++k) {
      CsvLine line(separator);
      line.add(s.name.toStdString()).add(h.from(k)).add(h.from(k + 1));
      line.add_field(fmt::format("{}", h.counts[k])).add(h.density(k));
      const double share = s.law.share_below(h.from(k + 1)) - s.law.share_below(h.from(k));
      if (laws) line.add(has_law(s) ? share * static_cast<double>(h.total) : kNone);
      table.push_back(line.text());
    }
  }
  return table;
}

void export_bins(const std::vector<ShownBins>& shown, const std::string& unit, const std::string& file) {
  OutputFile out(file);
  for (const std::string& line : bins_table(shown, unit, ',')) out.line(line);
  out.commit();
}

}  // namespace carom
