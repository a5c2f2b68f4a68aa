#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <memory>

#include "app/cli/commands.h"
#include "app/cli/count_progress.h"
#include "app/cli/options.h"
#include "app/cli/standard_output.h"
#include "app/cli/text_table.h"
#include "app/library/preset_library.h"
#include "physics/check/check.h"
#include "physics/files/csv.h"
#include "physics/files/output_file.h"
#include "physics/math/parallel.h"
#include "physics/model/needs.h"
#include "physics/preset/preset.h"
#include "physics/preset/preset_file.h"
#include "physics/scene/facts.h"
#include "physics/scene/validate.h"

namespace carom {
namespace {

struct CheckOptions {
  std::vector<std::string> presets;  // empty: all built-in experiments
  MethodOptions method;
  int finer = 1;    // divides every step, also where an expectation sets it
  std::string csv;  // file for the table, with all digits
};

struct CheckedPreset {
  std::filesystem::path file;
  std::string name;
  Preset preset;
  ExpectationCheck check;
};

// One row of the table, as text.
struct Row {
  std::string preset;
  std::string expectation;
  std::string measured;
  std::string expected;
  std::string error;
  std::string tolerance;
  std::string verdict;
};

// Length in bytes of an expectation's text in the table; the CSV file has it in full.
constexpr std::size_t kMostWords = 76;

// Eleven digits resolve a tolerance of 1e-10; exact numbers stay short.
std::string figure(double value) { return fmt::format("{:.11g}", value == 0.0 ? 0.0 : value); }

std::string rough(double value) { return value == 0.0 ? "0" : fmt::format("{:.1e}", value); }

const char* verdict_of(const Outcome& o) {
  if (o.good) return "good";
  if (!o.known) return "NOT KNOWN";
  return std::isnan(o.measured) ? "NEVER CAME" : "FELL SHORT";
}

Row table_row(const std::string& name, const Preset& preset, const Expectation& e, const Outcome& o) {
  const bool came = !std::isnan(o.measured);
  const std::string unit = o.unit.empty() || o.unit == "1" ? "" : " " + o.unit;
  return {name,
          text_of(e, preset),
          came ? figure(o.measured) : "-",
          figure(e.value) + unit,
          came ? rough(o.error) : "-",
          rough(e.tolerance),
          verdict_of(o)};
}

void print_rows(const std::vector<Row>& rows) {
  static constexpr auto kColumns = std::to_array(
      {Align::kLeft, Align::kLeft, Align::kRight, Align::kLeft, Align::kRight, Align::kRight, Align::kLeft});
  std::vector<std::vector<std::string>> cells;
  for (const Row& r : rows) {
    cells.push_back({r.preset, shortened(r.expectation, kMostWords), r.measured, r.expected, r.error,
                     r.tolerance, r.verdict});
  }
  print_table(cells, kColumns);
}

// A preset under the requested method.
Preset read_checked(const std::filesystem::path& file, const CheckOptions& options) {
  constexpr std::string_view kStep = "/method/step";
  Preset preset = preset_with_method(file.string(), options.method);
  const auto divide = [&](double& step) { step = std::max(step / options.finer, kLeastStep); };
  divide(preset.method.step);
  for (Expectation& e : preset.expect) {
    for (Setting& setting : e.settings) {
      if (setting.place == kStep) divide(setting.value);
    }
    if (e.over && e.over->place == kStep) {
      for (double& step : e.over->values) divide(step);
    }
  }
  return preset;
}

std::vector<CheckedPreset> read_presets(const CheckOptions& options) {
  std::vector<std::filesystem::path> files;
  for (const std::string& name : options.presets) files.push_back(find_preset(name));
  if (options.presets.empty()) {
    for (const LibraryEntry& entry : preset_library()) files.push_back(entry.file);
  }
  std::vector<CheckedPreset> presets;
  for (const std::filesystem::path& file : files) {
    const bool asked_for = !options.presets.empty();
    const auto integrator = options.method.integrator;
    if (!asked_for && integrator && why_not(read_preset(file).scene, *integrator)) continue;
    Preset preset = read_checked(file, options);
    try {
      ExpectationCheck check(preset);
      presets.push_back({file, file.stem().string(), std::move(preset), std::move(check)});
    } catch (const SceneError& error) {
      throw SceneError(fmt::format("{}: {}", file.string(), error.what()));
    }
  }
  return presets;
}

// Runs all presets, on all cores.
void run_all(std::vector<CheckedPreset>& presets) {
  struct Job {
    CheckedPreset* preset;
    int run;
  };
  std::vector<Job> jobs;
  for (CheckedPreset& p : presets) {
    for (int run = 0; run < p.check.runs(); ++run) jobs.push_back({&p, run});
  }
  CountProgress progress(static_cast<int>(jobs.size()));
  parallel_for(static_cast<int>(jobs.size()), 0, [&](int i) {
    jobs[static_cast<std::size_t>(i)].preset->check.run(jobs[static_cast<std::size_t>(i)].run);
    progress.one_more();
  });
}

int check(const CheckOptions& options) {
  std::vector<CheckedPreset> presets = read_presets(options);
  std::vector<std::filesystem::path> files;
  for (const CheckedPreset& p : presets) files.push_back(p.file);
  OutputSet outputs(files);
  OutputFile* csv = outputs.open(options.csv);
  if (csv != nullptr) csv->line("preset,expectation,measured,expected,error,tolerance,verdict");
  run_all(presets);

  std::vector<Row> rows = {{"preset", "expectation", "measured", "expected", "error", "tolerance", "verdict"}};
  int all = 0;
  int good = 0;
  bool known = true;
  for (const CheckedPreset& p : presets) {
    const std::vector<Outcome> outcomes = p.check.outcomes();
    for (std::size_t i = 0; i < outcomes.size(); ++i) {
      const Expectation& e = p.preset.expect[i];
      const Outcome& o = outcomes[i];
      ++all;
      good += o.good ? 1 : 0;
      known = known && o.known;
      rows.push_back(table_row(p.name, p.preset, e, o));
      if (csv != nullptr) {
        CsvLine line;
        line.add(p.name).add(rows.back().expectation);
        for (const double value : {o.measured, e.value, o.error, e.tolerance})
          line.add_field(csv_number(value));
        csv->line(line.add(o.good ? "good" : "fell short").text());
      }
    }
  }
  const std::string failures = outputs.commit();
  print_rows(rows);
  print_out("\n{} of {} expectations of {} preset{} are met.\n", good, all, presets.size(),
            presets.size() == 1 ? "" : "s");
  if (!known)
    print_out("NOT KNOWN: there are no contact forces under impulses only; choose contacts that last.\n");
  if (!failures.empty()) throw SceneError(failures);
  return good == all ? kGood : kFellShort;
}

}  // namespace

Command add_check_command(CLI::App& program, Arguments /*arguments*/) {
  const auto options = std::make_shared<CheckOptions>();
  CLI::App& command =
      *program.add_subcommand("check", "what experiments show beside what theory expects of them");
  command
      .add_option("preset", options->presets, "preset files or names of experiments (default: all built-in)")
      ->type_name("FILE|NAME");
  add_method_options(command, options->method);
  command.add_option("--finer", options->finer, "divide every step by N, 1 to 1000")
      ->check(CLI::Range(1, 1000))
      ->type_name("N");
  add_output_option(command, "--csv", options->csv, "write the table with all digits");
  return {&command, [options] { return check(*options); }};
}

}  // namespace carom
