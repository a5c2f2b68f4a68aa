#include "app/cli/commands.h"
#include "app/cli/standard_output.h"
#include "app/lab/preset_library.h"
#include "physics/preset/preset_file.h"
#include "physics/preset/schema.h"
#include "physics/scene/validate.h"

namespace carom {

int validate_command(const ValidateOptions& options) {
  if (options.schema == !options.presets.empty())
    throw SceneError("validate: one thing to do is needed; allowed: FILE|NAME..., or --schema");
  if (options.schema) {
    print_out("{}\n", preset_schema().dump(2));
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

}  // namespace carom
