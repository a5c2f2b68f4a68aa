#pragma once

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <sstream>
#include <string>
#include <vector>

#include "tests/support/source_folder.h"

namespace carom::test {

inline std::string content(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  return text.str();
}

// All presets that Carom ships, in the order of their paths.
inline std::vector<std::filesystem::path> preset_files() {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(test::source("presets"))) {
    if (entry.path().extension() == ".json") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

// Name of a test with a preset as its parameter: letters and digits only.
inline std::string preset_test_name(const testing::TestParamInfo<std::filesystem::path>& file) {
  std::string name = file.param.stem().string();
  std::erase(name, '-');
  return name;
}

// A temporary folder for a test.
class PresetFiles : public testing::Test {
 protected:
  PresetFiles()
      : folder_(std::filesystem::path(testing::TempDir()) /
                (std::string("carom-") + testing::UnitTest::GetInstance()->current_test_info()->name())) {
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
  }
  ~PresetFiles() override { std::filesystem::remove_all(folder_); }
  std::filesystem::path folder_;
};

}  // namespace carom::test
