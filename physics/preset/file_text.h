#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

namespace carom {

// Bytes that a file may have to be read: far beyond any preset.
inline constexpr std::size_t kLargestFile = 256'000'000;

// The bytes of a regular file. Never waits for a pipe or a device. Throws SceneError, one line with the file's
// name, if it is something else, too large or can't be read; `allowed` says what may stand there: "a preset
// file".
[[nodiscard]] std::string file_text(const std::filesystem::path& file, const char* allowed);

}  // namespace carom
