#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "physics/scene/scene.h"

namespace carom {

// The experiment that opens where nothing else is asked for.
inline constexpr const char* kDefaultExperiment = "drag-projectile";

struct LibraryEntry {
  std::string name;   // of the file without .json: what `carom run NAME` takes
  std::string topic;  // of its folder, for people
  std::filesystem::path file;
};

// The folder of the built-in experiments: $CAROM_PRESETS, else the one installed beside the program, else the
// source's.
[[nodiscard]] std::filesystem::path preset_folder();

// The built-in experiments by topic, in the order in which a course takes them. Folders that can't be read and
// what is no regular file are left out, each with a line in `skipped`.
[[nodiscard]] std::vector<LibraryEntry> preset_library(std::vector<std::string>* skipped = nullptr);

// The file that FILE|NAME means: an existing file, or a built-in experiment. Throws SceneError with the known
// names.
[[nodiscard]] std::filesystem::path find_preset(const std::string& file_or_name);

}  // namespace carom
