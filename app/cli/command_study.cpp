#include <QApplication>
#include <QFileInfo>
#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fmt/format.h>
#include <memory>
#include <unistd.h>

#include "app/cli/commands.h"
#include "app/cli/no_screen.h"
#include "app/cli/options.h"
#include "app/cli/standard_output.h"
#include "app/library/preset_library.h"
#include "physics/dynamics/integrators/integrators.h"
#include "physics/files/output_file.h"
#include "physics/preset/preset.h"
#include "physics/preset/preset_file.h"
#include "physics/scene/plain_text.h"
#include "physics/scene/validate.h"
#include "physics/step/run_clock.h"
#include "physics/study/study.h"
#include "physics/study/study_table.h"
#include "widgets/compare/study_plot.h"
#include "widgets/print/picture_file.h"

namespace carom {
namespace {

// Lists are separated by commas and checked item by item.
struct StudyCommandOptions {
  std::string preset;
  StudyOptions study;
  std::vector<std::string> integrators;
  std::vector<std::string> impacts;
  std::vector<std::string> steps;
  std::vector<std::string> tolerances;
  std::string csv;   // file for the rows
  std::string plot;  // .svg, .pdf or .png
};

std::vector<double> numbers(const char* option, const std::vector<std::string>& texts, double least,
                            double most, const char* unit) {
  std::vector<double> values;
  for (const std::string& text : texts) {
    char* end = nullptr;
    const double value = std::strtod(text.c_str(), &end);
    if (end == text.c_str() || *end != '\0' || !(value >= least && value <= most)) {
      throw SceneError(fmt::format("{}: {} is not allowed; allowed: from {} to {} {}", option, shortened(text),
                                   least, most, unit));
    }
    if (std::find(values.begin(), values.end(), value) != values.end()) {
      throw SceneError(fmt::format("{}: {} comes twice; allowed: each once", option, shortened(text)));
    }
    values.push_back(value);
  }
  return values;
}

// Parses the options. Throws SceneError.
StudyOptions study_options(const StudyCommandOptions& o) {
  StudyOptions study = o.study;
  for (const std::string& name : o.integrators) study.integrators.push_back(id_of(kIntegrators, name));
  for (const std::string& name : o.impacts) study.impacts.push_back(id_of(kImpacts, name));
  study.steps = numbers("--steps", o.steps, kLeastStep, kLargestStep, "s");
  study.tolerances = numbers("--tolerances", o.tolerances, kLeastTolerance, kLargestTolerance, "m");
  return study;
}

// Of the compared time.
void check_until(const std::string& name, const Preset& preset, double until) {
  check_time(name, preset, "--until", until);
  const double start = start_time(preset.saved);
  if (until > start + kSameMoment * preset.method.step) return;
  throw SceneError(fmt::format(
      "--until: {} is not allowed; allowed: a time above {}, there is nothing to compare at the start", until,
      start));
}

// A progress line on a terminal; nothing in a pipe.
class StudyProgressLine {
 public:
  void show(std::string_view stage, int done, int of) {
    if (!terminal_) return;
    const auto now = std::chrono::steady_clock::now();
    if (stage == stage_ && now - last_ < std::chrono::milliseconds(100)) return;
    last_ = now;
    stage_ = stage;
    if (of > 1) {
      write_err(fmt::format("\r\033[K{}: {} of {}", stage, done, of));
    } else {
      write_err(fmt::format("\r\033[K{} ...", stage));
    }
    shown_ = true;
  }
  ~StudyProgressLine() {
    if (shown_) write_err("\r\033[K");
  }

 private:
  bool terminal_ = isatty(STDERR_FILENO) != 0;
  bool shown_ = false;
  std::string stage_;
  std::chrono::steady_clock::time_point last_;
};

int run_study_command(Arguments arguments, const StudyCommandOptions& options) {
  const StudyOptions study = study_options(options);
  const QString plot = QString::fromStdString(options.plot);
  if (!options.plot.empty() && !is_picture_name(plot)) {
    throw SceneError(fmt::format("{}: not a kind of picture; allowed: .png, .svg, .pdf", options.plot));
  }
  const std::filesystem::path file = find_preset(options.preset);
  const Preset preset = read_preset(file);
  check_until(options.preset, preset, study.until.value_or(preset.duration));
  (void)plan_methods(preset, study);
  // Opened first, so that hours of work are not lost to a file that cannot be written.
  OutputSet outputs({file});
  OutputFile* csv = outputs.open(options.csv);
  OutputFile* picture = outputs.open(options.plot);
  StudyTable table;
  {
    StudyProgressLine line;
    StudyCallbacks callbacks;
    callbacks.progress = [&line](std::string_view stage, int done, int of) { line.show(stage, done, of); };
    table = run_study(preset, file.stem().string(), study, callbacks);
  }
  if (csv != nullptr) {
    for (const std::string& line : study_csv(table)) csv->line(line);
  }
  if (picture != nullptr) {
    use_no_screen();
    const QApplication application(arguments.argc, arguments.argv);
    try {
      write_study_picture(*picture, table, light_theme());
    } catch (const SceneError& error) {
      picture->give_up(error.what());  // the figures are valid
    }
  }
  const std::string failures = outputs.commit();
  write_out(study_text(table));
  if (!failures.empty()) throw SceneError(failures);
  return kGood;
}

}  // namespace

Command add_study_command(CLI::App& program, Arguments arguments) {
  const auto options = std::make_shared<StudyCommandOptions>();
  CLI::App& command =
      *program.add_subcommand("study", "one experiment under every method: speed against error");
  const auto add_list = [&](const std::string& name, std::vector<std::string>& to, const std::string& what) {
    return command.add_option(name, to, what)->delimiter(',')->type_name("A,B,...")->allow_extra_args(false);
  };
  add_preset_option(command, options->preset)->required();
  add_list("--integrators", options->integrators, "integrators to compare (default: all that the scene allows)")
      ->check(CLI::IsMember(names_of(kIntegrators)));
  add_list("--impacts", options->impacts, "choices of impacts to compare (default: all)")
      ->check(CLI::IsMember(names_of(kImpacts)));
  add_list("--steps", options->steps, "steps, s (default: 10, from 16 times the preset's own down, each half)");
  add_list("--tolerances", options->tolerances, "of the adaptive integrator, m (default: 1e-3 to 1e-12)");
  add_time_option(command, "--until", options->study.until,
                  "the compared time, s (default: near the preset's end)");
  command.add_option("--repeats", options->study.repeats, "timed runs of each row, 1 to 1000 (default: 5)")
      ->check(CLI::Range(1, 1000))
      ->type_name("N");
  command.add_option("--threads", options->study.threads, "for all but the timing (default: one a core)")
      ->check(CLI::Range(1, 1024))
      ->type_name("N");
  add_output_option(command, "--csv", options->csv, "write a line for each row");
  add_output_option(command, "--plot", options->plot, "draw error against time and step, .svg, .pdf or .png");
  return {&command, [options, arguments] { return run_study_command(arguments, *options); }};
}

}  // namespace carom
