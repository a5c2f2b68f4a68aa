#pragma once

#include <filesystem>

namespace carom::test {

// A file or folder of the sources, named from their top: source("tests/fuzz/seeds"). Only one small file of the
// tests knows where that is, so that all work trees on a machine share the objects of the others.
[[nodiscard]] std::filesystem::path source(const std::filesystem::path& name);

// A preset that Carom ships, named from their folder: preset_file("bounces/bouncing-ball.json").
[[nodiscard]] inline std::filesystem::path preset_file(const std::filesystem::path& name) {
  return source("presets") / name;
}

}  // namespace carom::test
