#include <CLI/CLI.hpp>
#include <memory>

#include "app/cli/commands.h"
#include "app/cli/standard_output.h"
#include "app/library/preset_library.h"
#include "physics/preset/key_table.h"
#include "physics/preset/preset_file.h"
#include "physics/preset/preset_json.h"
#include "physics/scene/validate.h"

namespace carom {
namespace {

struct ValidateOptions {
  std::vector<std::string> presets;
  bool schema = false;
  bool keys = false;
};

int validate(const ValidateOptions& options) {
  if (int{options.schema} + int{options.keys} + int{!options.presets.empty()} != 1)
    throw SceneError("validate: one input is needed; allowed: FILE|NAME..., --schema or --keys");
  if (options.schema) {
    print_out("{}\n", preset_schema().dump(2));
    return kGood;
  }
  if (options.keys) {
    for (const auto& [title, rows] : key_sections()) print_out("## {}\n\n{}\n", title, markdown_of(rows));
    return kGood;
  }
  int code = kGood;
  for (const std::string& preset : options.presets) {
    try {
      (void)read_preset(find_preset(preset));
      print_out("{}: good\n", shortened(preset, kMostOfFileName));
    } catch (const SceneError& error) {
      print_error(error.what());
      code = kBadInput;
    }
  }
  return code;
}

}  // namespace

Command add_validate_command(CLI::App& program, Arguments /*arguments*/) {
  const auto options = std::make_shared<ValidateOptions>();
  CLI::App& command = *program.add_subcommand("validate", "whether preset files are good, or what is wrong");
  command.add_option("preset", options->presets, "preset files or names of experiments")
      ->type_name("FILE|NAME");
  command.add_flag("--schema", options->schema, "print the JSON Schema of preset files");
  command.add_flag("--keys", options->keys, "print all keys of a scene, with units, ranges and defaults");
  return {&command, [options] { return validate(*options); }};
}

}  // namespace carom
