#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "physics/preset/preset.h"
#include "physics/scene/method.h"

// Options shared by several commands.
namespace carom {

// Options that override the file's own method.
struct MethodOptions {
  std::optional<IntegratorId> integrator;
  std::optional<ImpactsId> impacts;
  std::optional<ContactsId> contacts;
  std::optional<double> step;       // s
  std::optional<double> tolerance;  // m and m/s a step
};
// Adds one option for each part of a method. `method` must exist until the command line is parsed.
void add_method_options(CLI::App& command, MethodOptions& method);
// The scene of a preset with the chosen method, validated. Throws SceneError.
[[nodiscard]] Preset preset_with_method(const std::string& preset, const MethodOptions& method);

// Throws SceneError if the time (s), which `option` sets, is before the start of the preset's run. `name`: as
// the user called the preset.
void check_time(const std::string& name, const Preset& preset, const char* option, double time);

CLI::Option* add_preset_option(CLI::App& command, std::string& preset);
CLI::Option* add_time_option(CLI::App& command, const std::string& name, std::optional<double>& time,
                             const std::string& what);
CLI::Option* add_output_option(CLI::App& command, const std::string& name, std::string& file,
                               const std::string& what);
// The side of a picture in px.
void add_size_option(CLI::App& command, const std::string& name, int& size, const std::string& what);

template <class Table>
std::vector<std::string> names_of(const Table& table) {
  std::vector<std::string> names;
  for (const auto& choice : table) names.emplace_back(choice.name);
  return names;
}
// The id of a name in the table.
template <class Table>
auto id_of(const Table& table, const std::string& name) {
  const auto named = [&name](const auto& choice) { return choice.name == name; };
  return std::find_if(table.begin(), table.end(), named)->id;
}

}  // namespace carom
