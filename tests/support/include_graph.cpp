#include "tests/support/include_graph.h"

#include <algorithm>
#include <fstream>
#include <string_view>

namespace carom::test {
namespace {

using Path = IncludeGraph::Path;

bool is_code(const Path& file) { return file.extension() == ".h" || file.extension() == ".cpp"; }

// The folder of code that a file belongs to: physics/run for those of physics/run and of
// tests/physics/run. Empty for what all tests share.
Path room_of(const Path& file) {
  const Path folder = file.parent_path();
  if (*folder.begin() != "tests") return folder;
  const Path room = folder.lexically_relative("tests");
  return *room.begin() == "physics" || *room.begin() == "widgets" || *room.begin() == "app" ? room : Path();
}

bool is_test(const Path& file) {
  return *file.begin() == "tests" && file.filename().string().ends_with("_test.cpp");
}

}  // namespace

IncludeGraph::IncludeGraph(const Path& top) {
  constexpr std::string_view kInclude = "#include \"";
  for (const char* const library : {"physics", "widgets", "app", "tests"}) {
    for (const auto& entry : std::filesystem::recursive_directory_iterator(top / library)) {
      if (!is_code(entry.path())) continue;
      std::set<Path>& included = includes_[std::filesystem::relative(entry.path(), top)];
      std::ifstream in(entry.path());
      for (std::string line; std::getline(in, line);) {
        if (line.starts_with(kInclude))
          included.insert(line.substr(kInclude.size(), line.rfind('"') - kInclude.size()));
      }
    }
  }
}

std::set<Path> IncludeGraph::affected(const std::set<Path>& changed) const {
  std::set<Path> all;
  for (std::set<Path> news = changed; !news.empty();) {
    all.insert(news.begin(), news.end());
    std::set<Path> next;
    for (const auto& [file, included] : includes_) {
      if (all.contains(file)) continue;
      for (const Path& header : included) {
        if (news.contains(header)) next.insert(file);
      }
    }
    news = std::move(next);
  }
  return all;
}

std::set<Path> IncludeGraph::tests(const std::set<Path>& changed) const {
  std::set<Path> rooms;   // of code, that changed
  std::set<Path> shared;  // by tests, that changed
  for (const Path& file : changed) {
    if (is_code(file) && !room_of(file).empty()) {
      rooms.insert(room_of(file));
    } else {
      shared.insert(is_code(file) ? file : "tests/support/source_folder.h");
    }
  }
  std::set<Path> affected_rooms = rooms;
  for (const auto& [file, included] : includes_) {
    const bool uses = std::any_of(included.begin(), included.end(),
                                  [&](const Path& header) { return rooms.contains(room_of(header)); });
    if (uses && *file.begin() == "tests") shared.insert(file);
    if (uses && *file.begin() != "tests") affected_rooms.insert(room_of(file));
  }
  std::set<Path> tests;
  for (const Path& file : affected(shared)) {
    if (is_test(file)) tests.insert(file);
  }
  for (const auto& [file, included] : includes_) {
    if (is_test(file) && affected_rooms.contains(room_of(file))) tests.insert(file);
  }
  if (!changed.empty()) tests.insert("tests/rooms_test.cpp");
  return tests;
}

}  // namespace carom::test
