#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "physics/preset/preset.h"
#include "physics/scene/scene_error.h"

// Preset files: JSON, SI units, "format": "carom-preset", "version": 1. Unknown and duplicate keys are errors,
// but for the free object `extra`, which is kept as it is.
namespace carom {

inline constexpr int kPresetVersion = 1;

// Reads and validates. Throws SceneError whose one line begins with `origin` (a file's name).
[[nodiscard]] Preset parse_preset(std::string_view text, const std::string& origin);
[[nodiscard]] Preset read_preset(const std::filesystem::path& file);

// The text of a preset file; parse_preset(write_preset(s)) gives the same scene, to the last bit of every
// number.
[[nodiscard]] std::string write_preset(const Preset& preset);

// `file` is the old one or the new one, never half of it (see OutputFile). Throws SceneError if that fails, or
// where read_preset() would refuse what it wrote; the old file stays.
void save_preset(const Preset& preset, const std::filesystem::path& file);

}  // namespace carom
