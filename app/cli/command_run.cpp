#include <chrono>
#include <fmt/format.h>
#include <unistd.h>

#include "app/cli/commands.h"
#include "app/cli/standard_output.h"
#include "app/export/run_files.h"
#include "app/export/run_report.h"
#include "app/lab/preset_library.h"
#include "physics/files/output_set.h"
#include "physics/preset/preset.h"
#include "physics/preset/preset_file.h"
#include "physics/preset/saved_preset.h"
#include "physics/scene/facts.h"
#include "physics/world/run_state.h"

namespace carom {
namespace {

// A line on a terminal that says how far a long run is; nothing in a pipe.
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

}  // namespace

Preset preset_with_method(const std::string& name, const MethodOptions& method) {
  Preset preset = read_preset(find_preset(name));
  preset.method.integrator = method.integrator.value_or(preset.method.integrator);
  preset.method.impacts = method.impacts.value_or(preset.method.impacts);
  preset.method.contacts = method.contacts.value_or(preset.method.contacts);
  const auto put = [](const char* option, const std::optional<double>& value, double least, double largest,
                      const char* unit, double& to) {
    if (!value) return;
    if (!(*value >= least && *value <= largest)) {
      throw SceneError(fmt::format("{}: {} is not allowed; allowed: from {} to {} {}", option, *value, least,
                                   largest, unit));
    }
    to = *value;
  };
  put("--step", method.step, kLeastStep, kLargestStep, "s", preset.method.step);
  put("--tolerance", method.tolerance, kLeastTolerance, kLargestTolerance, "m and m/s",
      preset.method.tolerance);
  if (const auto reason = why_not(preset.scene, preset.method.integrator))
    throw SceneError("--integrator: " + *reason);
  return preset;
}

int run_command(const RunOptions& options) {
  const Preset preset = preset_with_method(options.preset, options.method);
  const Simulation start(setup_of(preset));
  Simulation simulation = start;

  const std::vector<Quantity> columns = run_columns(simulation.bodies());
  // Opened first: hours of work must not end at a file that cannot be written.
  OutputSet outputs({find_preset(options.preset)});
  OutputFile* csv = outputs.open(options.csv);
  OutputFile* events = outputs.open(options.events);
  OutputFile* save = outputs.open(options.save);
  if (csv != nullptr) {
    csv->line(csv_header(columns, simulation.bodies()));
    csv->line(csv_line(columns, simulation));
  }
  if (events != nullptr) events->line(events_csv_header());
  const double end = options.until.value_or(preset.duration);
  {
    Progress progress(end);
    simulation.advance_to(end, [&] {
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
      save->give_up(error.what());  // the other files are good
    }
  }
  const std::string failures = outputs.commit();
  write_out(options.json ? report_json(find_preset(options.preset).stem().string(), simulation)
                         : report_text(preset, start, simulation));
  if (const auto& lost = simulation.lost()) {
    const std::string text = lost->text(simulation.bodies(), simulation.time());
    throw RunLostError(failures.empty() ? text : text + "; " + failures);
  }
  if (!failures.empty()) throw SceneError(failures);
  return kGood;
}

}  // namespace carom
