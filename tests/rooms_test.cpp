#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <regex>
#include <string>
#include <string_view>
#include <vector>

#include "tests/support/include_graph.h"
#include "tests/support/source_folder.h"

// The rooms of the code, and which of them may know which.
namespace carom {
namespace {

namespace fs = std::filesystem;

// The code's libraries and the folders in each: a file may include files of its own folder and of those that
// stand before it here.
struct Library {
  std::string_view name;
  std::vector<std::string_view> rooms;
};
const std::array<Library, 3> kLibraries = {
    {{"physics",
      {"math", "scene", "files", "model", "dynamics", "collision", "impact", "contact", "ledger", "step", "run",
       "observe", "compare", "record", "preset", "check", "study", "worker"}},
     {"widgets", {"theme", "base", "edit", "print", "scene", "plot", "compare", "run"}},
     {"app", {"export", "help", "library", "lab", "cli"}}}};

// The room's place in the order of all of them; -1: none, the file stands beside the rooms or isn't ours.
int place_of(const fs::path& file) {
  auto part = file.begin();
  int place = 0;
  for (const Library& library : kLibraries) {
    if (part->string() == library.name) {
      const std::string room = std::next(part)->string();
      const auto found = std::find(library.rooms.begin(), library.rooms.end(), room);
      return found == library.rooms.end() ? -1 : place + static_cast<int>(found - library.rooms.begin());
    }
    place += static_cast<int>(library.rooms.size());
  }
  return -1;
}

std::vector<fs::path> sources() {
  std::vector<fs::path> files;
  for (const Library& library : kLibraries) {
    for (const auto& entry : fs::recursive_directory_iterator(test::source(library.name))) {
      const std::string extension = entry.path().extension().string();
      if (extension == ".h" || extension == ".cpp")
        files.push_back(fs::relative(entry.path(), test::source("")));
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

TEST(Rooms, IncludeOnlyRoomsBeforeThem) {
  const test::IncludeGraph graph(test::source(""));
  int arrows = 0;
  for (const auto& [file, included] : graph.includes()) {
    if (*file.begin() == "tests") continue;
    const int place = place_of(file);
    EXPECT_TRUE(place >= 0 || file == "app/main.cpp") << file << " stands in none of the rooms";
    for (const fs::path& header : included) {
      const int other = place_of(header);
      if (place < 0 || other < 0) continue;
      ++arrows;
      EXPECT_LE(other, place) << file << " includes " << header;
    }
  }
  EXPECT_GT(arrows, 500);  // they were found at all
}

// A step knows bodies by their indices: nothing that it calls reads the scene, or a name in it.
TEST(Rooms, StepsKnowNoNames) {
  constexpr std::array<std::string_view, 5> kRooms = {"dynamics", "collision", "impact", "contact", "step"};
  const std::regex names(R"(\b(Scene|Body|std::string)\b)");
  int files = 0;
  for (const fs::path& file : sources()) {
    const std::string room = std::next(file.begin())->string();
    if (*file.begin() != "physics" || std::find(kRooms.begin(), kRooms.end(), room) == kRooms.end()) continue;
    if (file.stem() == "state") continue;  // there the bodies of a scene become motions, for other rooms too
    ++files;
    std::ifstream in(test::source(file));
    for (std::string line; std::getline(in, line);) {
      const std::string code = line.substr(0, line.find("//"));
      EXPECT_FALSE(std::regex_search(code, names)) << file << ": " << line;
    }
  }
  EXPECT_GT(files, 80);
}

// Windows and dialogs wait in the one event loop of the program: within it no other one runs.
TEST(Rooms, RunNoEventLoopWithinAnother) {
  constexpr std::array<std::string_view, 13> kLoops = {
      "exec()",     "processEvents",  "QEventLoop",           "getOpenFileName", "getSaveFileName",
      "getText(",   "getDouble(",     "getExistingDirectory", "getInt(",         "QMessageBox::question",
      "::warning(", "::information(", "::critical("};
  int programs = 0;
  for (const fs::path& file : sources()) {
    if (*file.begin() == "physics") continue;
    std::ifstream in(test::source(file));
    for (std::string line; std::getline(in, line);) {
      const bool program = line.find("QApplication::exec()") != std::string::npos;
      programs += program ? 1 : 0;
      for (const std::string_view loop : kLoops)
        EXPECT_TRUE(program || line.find(loop) == std::string::npos) << file << ": " << line;
    }
  }
  EXPECT_EQ(programs, 2);  // the lab's, and that of a picture of its window
}

// Who builds against the installed library needs Eigen alone.
TEST(Rooms, InstalledHeadersIncludeNoPrivateOnes) {
  const std::regex is_private(CAROM_PRIVATE_HEADERS);
  const std::regex include(R"(#include ["<](.*)[">])");
  int installed = 0;
  for (const fs::path& file : sources()) {
    if (*file.begin() != "physics" || file.extension() != ".h") continue;
    if (std::regex_search(file.string(), is_private)) continue;
    ++installed;
    std::ifstream in(test::source(file));
    std::smatch match;
    for (std::string line; std::getline(in, line);) {
      if (!std::regex_search(line, match, include)) continue;
      const std::string included = match[1];
      for (const char* library : {"nlohmann/", "fmt/", "muParser"}) {
        EXPECT_FALSE(included.starts_with(library)) << file << " includes " << included;
      }
      EXPECT_FALSE(std::regex_search(included, is_private)) << file << " includes " << included;
    }
  }
  EXPECT_GT(installed, 50);
}

}  // namespace
}  // namespace carom
