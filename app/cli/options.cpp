#include "app/cli/options.h"

#include <algorithm>
#include <cstdlib>
#include <fmt/format.h>

#include "app/library/preset_library.h"
#include "physics/dynamics/integrators/integrators.h"
#include "physics/preset/preset_file.h"
#include "physics/scene/facts.h"
#include "physics/scene/plain_text.h"
#include "physics/scene/validate.h"
#include "physics/step/run_clock.h"

namespace carom {
namespace {

// Check of a time option.
const CLI::Validator kTime(
    [](const std::string& text) -> std::string {
      char* end = nullptr;
      const double value = std::strtod(text.c_str(), &end);
      const bool good = end != text.c_str() && *end == '\0' && value >= 0.0 && value <= 1e9;
      return good ? "" : shortened(text) + " is not allowed; allowed: a time from 0 to 1e9 s";
    },
    "T", "time");

const CLI::Validator kOutput([](const std::string& text)
                                 -> std::string { return text.empty() ? "the name of a file is needed" : ""; },
                             "F", "output");

template <class Table, class Id>
void add_choice(CLI::App& command, const std::string& option, const Table& table, std::optional<Id>& to,
                const std::string& what) {
  const auto take = [&table, &to](const std::string& name) { to = id_of(table, name); };
  command.add_option_function<std::string>(option, take, what)
      ->type_name("ID")
      ->check(CLI::IsMember(names_of(table)));
}

}  // namespace

void add_method_options(CLI::App& command, MethodOptions& method) {
  add_choice(command, "--integrator", kIntegrators, method.integrator, "how free motion is advanced");
  add_choice(command, "--impacts", kImpacts, method.impacts, "when impacts are resolved");
  add_choice(command, "--contacts", kContacts, method.contacts, "how lasting contacts are treated");
  command.add_option("--step", method.step, "length of a step, s")->type_name("H");
  command.add_option("--tolerance", method.tolerance, "of the adaptive integrator, m and m/s a step")
      ->type_name("TOL");
}

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

void check_time(const std::string& name, const Preset& preset, const char* option, double time) {
  const double start = start_time(preset.saved);
  if (time >= start - kSameMoment * preset.method.step) return;  // less is rounding
  throw SceneError(
      fmt::format("{}: the run is already at t = {} s; allowed: {} from {} on", name, start, option, start));
}

CLI::Option* add_preset_option(CLI::App& command, std::string& preset) {
  return command.add_option("preset", preset, "a preset file or the name of an experiment")
      ->type_name("FILE|NAME");
}

CLI::Option* add_time_option(CLI::App& command, const std::string& name, std::optional<double>& time,
                             const std::string& what) {
  return command.add_option(name, time, what)->check(kTime)->type_name("T");
}

CLI::Option* add_output_option(CLI::App& command, const std::string& name, std::string& file,
                               const std::string& what) {
  return command.add_option(name, file, what)->check(kOutput)->type_name("F");
}

void add_size_option(CLI::App& command, const std::string& name, int& size, const std::string& what) {
  command.add_option(name, size, what)->check(CLI::Range(200, 8000))->type_name(name == "--width" ? "W" : "H");
}

}  // namespace carom
