#include <array>
#include <fmt/format.h>
#include <memory>

#include "app/cli/commands.h"
#include "app/cli/count_progress.h"
#include "app/cli/options.h"
#include "app/cli/standard_output.h"
#include "app/cli/text_table.h"
#include "physics/files/output_file.h"
#include "physics/math/parallel.h"
#include "physics/scene/validate.h"
#include "physics/stress/stress_table.h"

namespace carom {
namespace {

struct StressOptions {
  std::vector<std::string> cases;  // ids of physics/stress/stress.h; empty: all
  bool longer = false;             // the long runs of cases that have one
  std::string csv;                 // file for the rows, with all digits
  std::string page;                // file for the help's page of figures, Markdown
};

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

int stress(const StressOptions& options) {
  const std::vector<StressCase> cases = stress_cases(options.cases);
  // Opened first, so that minutes of work are not lost to a file that cannot be written.
  OutputSet outputs;
  OutputFile* csv = outputs.open(options.csv);
  OutputFile* page = outputs.open(options.page);
  StressSuite suite(cases, options.longer);
  {
    CountProgress progress(suite.runs());
    parallel_for(suite.runs(), 0, [&](int i) {
      suite.run(i);
      progress.one_more();
    });
  }
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
  print_out("\n{}\n", count_text(count));
  if (!failures.empty()) throw SceneError(failures);
  return count.within == count.bounded ? kGood : kFellShort;
}

}  // namespace

Command add_stress_command(CLI::App& program, Arguments /*arguments*/) {
  const auto options = std::make_shared<StressOptions>();
  CLI::App& command = *program.add_subcommand(
      "stress", "the hard cases: what each shows beside its limit, at a step and a quarter");
  command.add_option("case", options->cases, "ids of cases (default: all)")->type_name("CASE");
  command.add_flag("--long", options->longer, "1e6 impacts of the gas instead of 1e5");
  add_output_option(command, "--csv", options->csv, "write the table with all digits");
  add_output_option(command, "--page", options->page, "write the help's page of figures, Markdown");
  return {&command, [options] { return stress(*options); }};
}

}  // namespace carom
