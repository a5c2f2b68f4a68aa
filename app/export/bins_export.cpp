#include "app/export/bins_export.h"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/export/run_files.h"
#include "physics/files/output_file.h"

namespace carom {

std::vector<std::string> bins_table(const std::vector<ShownBins>& shown, const std::string& unit,
                                    char separator) {
  const auto has_law = [](const ShownBins& s) { return s.law.thermal_energy() > 0.0; };
  const bool laws = std::any_of(shown.begin(), shown.end(), has_law);
  std::vector<std::string> table;
  const auto add = [&](const std::vector<std::string>& fields) {
    table.push_back(fmt::format("{}", fmt::join(fields, std::string_view(&separator, 1))));
  };
  std::vector<std::string> header = {"distribution", "from [" + unit + "]", "to [" + unit + "]", "count [1]",
                                     "share over width [1/(" + unit + ")]"};
  if (laws) header.emplace_back("expected by Maxwell [1]");
  add(header);
  for (const ShownBins& s : shown) {
    const Histogram& h = s.bins;
    for (std::size_t k = 0; k < h.counts.size(); ++k) {
      std::vector<std::string> fields = {csv_field(s.name.toStdString(), separator),
                                         fmt::format("{}", h.from(k)), fmt::format("{}", h.from(k + 1)),
                                         fmt::format("{}", h.counts[k]), fmt::format("{}", h.density(k))};
      const double share = s.law.share_below(h.from(k + 1)) - s.law.share_below(h.from(k));
      if (laws) {
        fields.push_back(has_law(s) ? fmt::format("{}", share * static_cast<double>(h.total)) : std::string());
      }
      add(fields);
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
