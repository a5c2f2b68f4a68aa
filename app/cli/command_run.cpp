#include <chrono>
#include <fmt/format.h>
#include <memory>
#include <unistd.h>

#include "app/cli/commands.h"
#include "app/cli/options.h"
#include "app/cli/standard_output.h"
#include "app/export/run_files.h"
#include "app/export/run_report.h"
#include "app/library/preset_library.h"
#include "physics/files/output_file.h"
#include "physics/preset/preset.h"
#include "physics/preset/preset_file.h"
#include "physics/run/simulation.h"
#include "physics/run/stop_watch.h"
#include "physics/scene/stop.h"
#include "physics/scene/value_checks.h"

namespace carom {
namespace {

struct RunOptions {
  std::string preset;
  MethodOptions method;
  std::optional<double> until;     // s; without it the preset's duration
  std::vector<std::string> stops;  // sentences, beside the preset's own stops
  bool json = false;
  std::string csv;     // file for the run's sums and paths, step by step
  std::string events;  // file for its impacts
  std::string save;    // preset file for the state at the end
};

// A progress line on a terminal for a long run; nothing in a pipe.
class Progress {
 public:
  explicit Progress(double end) : end_(end), terminal_(isatty(STDERR_FILENO) != 0) {}
  void show(double time) {
    if (!terminal_) return;
    const auto now = std::chrono::steady_clock::now();
    if (now - last_ < std::chrono::milliseconds(200)) return;
    last_ = now;
    write_err(fmt::format("\rt = {:.3f} of {:.3f} s ", time, end_));
    shown_ = true;
  }
  ~Progress() {
    if (shown_) write_err("\r\033[K");
  }

 private:
  double end_;
  bool terminal_;
  bool shown_ = false;
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

// Adds the stops of the command line.
Preset preset_with_stops(const RunOptions& options) {
  Preset preset = preset_with_method(options.preset, options.method);
  const std::vector<Body> all = all_bodies(preset);
  NamedBodies bodies;
  for (const Body& body : all) bodies.emplace(body.name, &body);
  for (const std::string& sentence : options.stops) {
    preset.stops.push_back(stop_of("--stop", sentence));
    check_stop("--stop", preset.stops.back(), bodies);
  }
  return preset;
}

int run(const RunOptions& options) {
  const Preset preset = preset_with_stops(options);
  const Simulation start(setup_of(preset));
  const double end = options.until.value_or(preset.duration);
  check_time(options.preset, preset, "--until", end);
  Simulation simulation = start;

  const std::vector<Quantity> columns = run_columns(simulation.bodies());
  // Opened first, so that hours of work are not lost to a file that cannot be written.
  OutputSet outputs({find_preset(options.preset)});
  OutputFile* csv = outputs.open(options.csv);
  OutputFile* events = outputs.open(options.events);
  OutputFile* save = outputs.open(options.save);
  if (csv != nullptr) {
    csv->line(csv_header(columns, simulation.bodies()));
    csv->line(csv_line(columns, simulation));
  }
  if (events != nullptr) events->line(events_csv_header());
  std::optional<std::size_t> stop;
  {
    Progress progress(end);
    StopWatch watch(preset.stops, simulation);
    stop = watch.advance_to(simulation, end, [&] {
      if (csv != nullptr) csv->line(csv_line(columns, simulation));
      if (events != nullptr) {
        for (const ImpactRecord& impact : simulation.last_impacts())
          events->line(events_csv_line(simulation, impact));
      }
      progress.show(simulation.time());
    });
  }
  if (save != nullptr) {
    try {
      const std::string text = write_preset(saved_preset(preset, simulation));
      (void)parse_preset(text, save->name());
      save->write(text);
    } catch (const SceneError& error) {
      save->give_up(error.what());  // the other files are valid
    }
  }
  const std::string failures = outputs.commit();
  std::optional<std::string> stopped;
  if (!preset.stops.empty()) stopped = stop ? sentence_of(preset.stops[*stop]) : "";
  write_out(options.json ? report_json(find_preset(options.preset).stem().string(), simulation, stopped)
                         : report_text(preset, start, simulation, stopped));
  if (const auto& lost = simulation.lost()) {
    const std::string text = lost->text(simulation.bodies(), simulation.time());
    throw RunLostError(failures.empty() ? text : text + "; " + failures);
  }
  if (!failures.empty()) throw SceneError(failures);
  return kGood;
}

}  // namespace

Command add_run_command(CLI::App& program, Arguments /*arguments*/) {
  const auto options = std::make_shared<RunOptions>();
  CLI::App& command = *program.add_subcommand("run", "run an experiment and print what was before and after");
  add_preset_option(command, options->preset)->required();
  add_time_option(command, "--until", options->until, "end of the run, s (default: the preset's duration)");
  command
      .add_option(
          "--stop", options->stops,
          "where the run ends before, as \"at the 3rd impact\" or \"when A passes x = 0.4 m\"; several may "
          "be given")
      ->type_name("SENTENCE")
      ->allow_extra_args(false);
  add_method_options(command, options->method);
  command.add_flag("--json", options->json, "print one JSON object instead of tables");
  add_output_option(command, "--csv", options->csv, "write sums and paths of every step");
  add_output_option(command, "--events", options->events, "write every impact");
  add_output_option(command, "--save", options->save,
                    "write the run as it stands at the end, as a preset that goes on from there");
  return {&command, [options] { return run(*options); }};
}

int run_preset(const std::string& preset) {
  RunOptions options;
  options.preset = preset;
  return run(options);
}

}  // namespace carom
