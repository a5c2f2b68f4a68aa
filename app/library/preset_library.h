#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "physics/scene/scene.h"

namespace carom {

// The experiment that opens by default.
inline constexpr const char* kDefaultExperiment = "drag-projectile";

struct LibraryEntry {
  std::string name;   // of the file without .json: what `carom run NAME` takes
  std::string topic;  // name of its folder, as shown
  std::filesystem::path file;
};

// The folder of the built-in experiments: $CAROM_PRESETS, else the one installed beside the program, else the
// source's.
[[nodiscard]] std::filesystem::path preset_folder();

// The built-in experiments by topic, in the order of a course. Unreadable folders and files that are not
// regular are left out, each with a line in `skipped`.
[[nodiscard]] std::vector<LibraryEntry> preset_library(std::vector<std::string>* skipped = nullptr);

// The file that FILE|NAME means: an existing file, or a built-in experiment. Throws SceneError with the known
// names.
[[nodiscard]] std::filesystem::path find_preset(const std::string& file_or_name);

}  // namespace carom
