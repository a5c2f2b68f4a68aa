#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "physics/preset/preset.h"
#include "physics/scene/scene_error.h"

// Preset files: JSON, SI units, "format": "carom-preset", "version": 1. Unknown and duplicate keys are
// errors, except in the free object `extra`, which is kept as it is.
namespace carom {

inline constexpr int kPresetVersion = 1;

// Reads and validates. Throws SceneError whose one line begins with `origin` (a file's name).
[[nodiscard]] Preset parse_preset(std::string_view text, const std::string& origin);
[[nodiscard]] Preset read_preset(const std::filesystem::path& file);

// The text of a preset file; parse_preset() of it gives the same preset, to the last bit of every number.
[[nodiscard]] std::string write_preset(const Preset& preset);

// Writes `file` whole or not at all (see OutputFile). Throws SceneError if that fails, or if read_preset()
// would refuse the new file; the old file stays.
void save_preset(const Preset& preset, const std::filesystem::path& file);

}  // namespace carom
