#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

namespace carom {

// The largest file that is read, in bytes: far beyond any preset.
inline constexpr std::size_t kLargestFile = 256'000'000;

// The bytes of a regular file. Never waits for a pipe or a device. Throws SceneError, one line with the
// file's name, if it is not a regular file, too large or unreadable; `allowed` names what is expected: "a
// preset file".
[[nodiscard]] std::string file_text(const std::filesystem::path& file, const char* allowed);

}  // namespace carom
