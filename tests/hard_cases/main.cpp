#include <algorithm>
#include <array>
#include <cstdio>
#include <exception>
#include <fmt/format.h>
#include <string>
#include <vector>

#include "physics/files/output_file.h"
#include "physics/math/parallel.h"
#include "physics/scene/plain_text.h"
#include "physics/scene/validate.h"
#include "tests/hard_cases/stress.h"
#include "tests/hard_cases/stress_table.h"

// Runs the hard cases and prints each figure beside its limit: see README.md.
namespace carom {
namespace {

struct StressOptions {
  std::vector<std::string> cases;  // ids of stress.h; empty: all
  bool longer = false;             // the long runs of cases that have one
  std::string csv;                 // file for the rows, with all digits
  std::string page;                // file for the page of figures, Markdown
};

StressOptions options_of(const std::vector<std::string>& arguments) {
  StressOptions options;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const std::string& word = arguments[i];
    if (word == "--long") {
      options.longer = true;
    } else if ((word == "--csv" || word == "--page") && i + 1 < arguments.size()) {
      (word == "--csv" ? options.csv : options.page) = arguments[++i];
    } else if (word.starts_with("-")) {
      throw SceneError(shortened(word) + " is not allowed; allowed: [CASE ...] [--long] [--csv F] [--page F]");
    } else {
      options.cases.push_back(word);
    }
  }
  return options;
}

void print_lines(const std::vector<StressLine>& lines) {
  constexpr auto kColumns =
      std::to_array({&StressLine::case_id, &StressLine::figure, &StressLine::method, &StressLine::coarse,
                     &StressLine::fine, &StressLine::change, &StressLine::limit, &StressLine::verdict,
                     &StressLine::cpu_time, &StressLine::peers});
  std::array<std::size_t, kColumns.size()> widths{};
  for (const StressLine& line : lines) {
    for (std::size_t c = 0; c < kColumns.size(); ++c)
      widths[c] = std::max(widths[c], characters(line.*kColumns[c]));
  }
  for (const StressLine& line : lines) {
    std::string text;
    for (std::size_t c = 0; c < kColumns.size(); ++c) {
      const std::string& cell = line.*kColumns[c];
      text += cell + std::string(widths[c] - characters(cell) + 2, ' ');
    }
    text.erase(text.find_last_not_of(' ') + 1);
    fmt::print("{}\n", text);
  }
}

bool all_are_within(const StressOptions& options) {
  const std::vector<StressCase> cases = stress_cases(options.cases);
  // Opened first, so that minutes of work are not lost to a file that cannot be written.
  OutputSet outputs;
  OutputFile* csv = outputs.open(options.csv);
  OutputFile* page = outputs.open(options.page);
  StressSuite suite(cases, options.longer);
  parallel_for(suite.runs(), 0, [&](int i) { suite.run(i); });
  const std::vector<StressRow> rows = suite.rows();
  const auto write = [](OutputFile* file, const std::vector<std::string>& lines) {
    if (file == nullptr) return;
    for (const std::string& line : lines) file->line(line);
  };
  write(csv, stress_csv(rows));
  write(page, stress_page(cases, rows));
  const std::string failures = outputs.commit();
  print_lines(stress_lines(rows));
  const StressCount count = count_of(rows);
  fmt::print("\n{}\n", count_text(count));
  if (!failures.empty()) throw SceneError(failures);
  return count.within == count.bounded;
}

}  // namespace
}  // namespace carom

int main(int argc, char** argv) {
  try {
    return carom::all_are_within(carom::options_of({argv + 1, argv + argc})) ? 0 : 1;
  } catch (const std::exception& error) {
    fmt::print(stderr, "carom_stress: {}\n", error.what());
    return 2;
  }
}
