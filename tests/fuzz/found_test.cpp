#include <array>
#include <filesystem>
#include <gtest/gtest.h>
#include <string_view>

#include "tests/fuzz/targets.h"
#include "tests/support/preset_files.h"
#include "tests/support/source_folder.h"

namespace carom::fuzz {
namespace {

namespace fs = std::filesystem;

struct Target {
  std::string_view name;
  void (*attempt)(std::string_view bytes);
};

// All targets of targets.h.
constexpr auto kTargets =
    std::to_array<Target>({{"preset", try_preset}, {"simulation", try_simulation}, {"edits", try_edits}});

// Runs the fuzzers' finds again, which have been fixed.
TEST(FuzzersFinds, BreakNothing) {
  int tried = 0;
  for (const Target& target : kTargets) {
    const fs::path folder = test::source("tests/fuzz/found") / target.name;
    if (!fs::exists(folder)) continue;
    for (const auto& entry : fs::directory_iterator(folder)) {
      SCOPED_TRACE(entry.path().string());
      EXPECT_NO_THROW(target.attempt(test::content(entry.path())));
      ++tried;
    }
  }
  EXPECT_GE(tried, 2);
}

}  // namespace
}  // namespace carom::fuzz
