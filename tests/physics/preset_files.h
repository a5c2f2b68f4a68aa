#pragma once

#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <sstream>
#include <string>

namespace carom::test {

inline std::string content(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  return text.str();
}

// A folder of its own for a test, gone afterwards.
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
