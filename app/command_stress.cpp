#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <memory>

#include "app/commands.h"
#include "app/count_progress.h"
#include "app/run_files.h"
#include "app/text_table.h"
#include "physics/measure/parallel.h"
#include "physics/measure/stress_table.h"

namespace carom {
namespace {

void print_lines(const std::vector<StressLine>& lines) {
  static constexpr auto kColumns =
      std::to_array({Align::kLeft, Align::kLeft, Align::kLeft, Align::kRight, Align::kRight, Align::kRight,
                     Align::kRight, Align::kLeft, Align::kRight, Align::kLeft});
  std::vector<std::vector<std::string>> rows;
  for (const StressLine& l : lines) {
    rows.push_back(
        {l.case_id, l.figure, l.method, l.coarse, l.fine, l.change, l.limit, l.verdict, l.cpu_time, l.peers});
  }
  print_table(rows, kColumns);
}

}  // namespace

int stress_command(const StressOptions& options) {
  const std::vector<StressCase> cases = stress_cases(options.cases);
  // Opened first: minutes of work must not end at a file that cannot be written.
  std::unique_ptr<CsvFile> csv;
  if (!options.csv.empty()) csv = std::make_unique<CsvFile>(options.csv);
  StressSuite suite(cases, options.longer);
  {
    CountProgress progress(suite.runs());
    parallel_for(suite.runs(), 0, [&](int i) {
      suite.run(i);
      progress.one_more();
    });
  }
  const std::vector<StressRow> rows = suite.rows();
  if (csv != nullptr) {
    for (const std::string& line : stress_csv(rows)) csv->line(line);
    csv->finish();
  }
  print_lines(stress_lines(rows));
  const auto count = [&](StressVerdict verdict) {
    return std::count_if(rows.begin(), rows.end(), [&](const StressRow& r) { return r.verdict == verdict; });
  };
  const auto good = count(StressVerdict::kWithin);
  const auto short_of = count(StressVerdict::kBeyond);
  fmt::print("\n{} of {} figures of {} case{} are within their limits.\n", good, good + short_of, cases.size(),
             cases.size() == 1 ? "" : "s");
  return short_of == 0 ? kGood : kFellShort;
}

}  // namespace carom
