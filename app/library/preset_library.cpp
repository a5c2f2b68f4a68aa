#include "app/library/preset_library.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <map>
#include <system_error>
#include <tuple>

#include "physics/preset/preset_file.h"
#include "physics/scene/validate.h"

namespace carom {
namespace {

namespace fs = std::filesystem;

// Suffixes of files that describe presets but are no presets.
constexpr std::string_view kSchemaEnd = ".schema.json";

// Folders in the order of a course; others follow by name.
constexpr auto kTopics = std::to_array<std::pair<const char*, const char*>>({
    {"first-collisions", "First collisions"},
    {"chains-and-cradles", "Chains and cradles"},
    {"bounces", "Bounces"},
    {"several-shapes", "Bodies of several shapes"},
    {"springs-and-pistons", "Springs and pistons"},
    {"billiards", "Billiards"},
    {"gases", "Gases"},
    {"friction", "Friction and rolling"},
    {"piles", "Piles"},
    {"numerical-methods", "Numerical methods"},
});

std::pair<std::size_t, std::string> rank_and_title(const std::string& folder) {
  for (std::size_t i = 0; i < kTopics.size(); ++i) {
    if (folder == kTopics[i].first) return {i, kTopics[i].second};
  }
  std::string title = folder;
  std::replace(title.begin(), title.end(), '-', ' ');
  if (!title.empty()) title[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(title[0])));
  return {kTopics.size(), title};
}

// The order within a topic, from the simple to the general, where it is not alphabetical.
constexpr auto kFirst = std::to_array<const char*>(
    {"head-on-equal", "head-on", "glancing", "newtons-cradle", "bouncing-ball", "explosion", "ball-in-a-box"});

std::size_t rank_of_name(const std::string& name) {
  return static_cast<std::size_t>(std::find(kFirst.begin(), kFirst.end(), name) - kFirst.begin());
}

// Depth of folders that are searched, and number of files.
constexpr int kDeepestFolder = 8;
constexpr std::size_t kMostFiles = 10'000;

// The preset files of a folder and its subfolders; unreadable ones are left out and reported in `faults`.
// Symbolic links to folders are not followed.
void collect(const fs::path& folder, int depth, std::vector<fs::path>& files,
             std::vector<std::string>& faults) {
  std::error_code error;
  fs::directory_iterator entry(folder, error);
  const auto fault = [&](const fs::path& place, const std::string& what) {
    faults.push_back(fmt::format("{}: {}; left out", shortened(place.string(), kMostOfFileName), what));
  };
  for (; !error && entry != fs::directory_iterator(); entry.increment(error)) {
    const fs::path& path = entry->path();
    std::error_code unknown;
    const fs::file_status status = entry->symlink_status(unknown);
    if (fs::is_directory(status)) {
      if (depth < kDeepestFolder) collect(path, depth + 1, files, faults);
      continue;
    }
    if (path.extension() != ".json" || path.filename().string().ends_with(kSchemaEnd)) continue;
    if (!fs::is_regular_file(path, unknown)) {
      fault(path, "this is no regular file");
    } else if (files.size() == kMostFiles) {
      fault(path, fmt::format("there are more than {} files", kMostFiles));
      return;
    } else {
      files.push_back(path);
    }
  }
  if (error) fault(folder, fmt::format("the folder cannot be read ({})", error.message()));
}

}  // namespace

fs::path preset_folder() {
  if (const char* named = std::getenv("CAROM_PRESETS"); named != nullptr && *named != '\0') return named;
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  if (!error) {
    fs::path installed = program.parent_path().parent_path() / "share" / "carom" / "presets";
    if (fs::is_directory(installed, error)) return installed;
  }
  return CAROM_SOURCE_PRESETS;
}

std::vector<LibraryEntry> preset_library(std::vector<std::string>* skipped) {
  std::vector<fs::path> files;
  std::vector<std::string> faults;
  collect(preset_folder(), 0, files, faults);
  if (skipped != nullptr) *skipped = std::move(faults);
  std::vector<std::tuple<std::size_t, std::size_t, LibraryEntry>> found;
  for (const fs::path& file : files) {
    const auto [rank, title] = rank_and_title(file.parent_path().filename().string());
    const std::string name = file.stem().string();
    found.emplace_back(rank, rank_of_name(name), LibraryEntry{name, title, file});
  }
  std::sort(found.begin(), found.end(), [](const auto& x, const auto& y) {
    const auto& [rank_x, order_x, entry_x] = x;
    const auto& [rank_y, order_y, entry_y] = y;
    return std::tie(rank_x, entry_x.topic, order_x, entry_x.name, entry_x.file) <
           std::tie(rank_y, entry_y.topic, order_y, entry_y.name, entry_y.file);
  });
  std::vector<LibraryEntry> library;
  for (auto& [rank, order, entry] : found) library.push_back(std::move(entry));
  return library;
}

fs::path find_preset(const std::string& file_or_name) {
  std::error_code error;
  const auto looks_like_file = file_or_name.find('/') != std::string::npos || file_or_name.ends_with(".json");
  if (looks_like_file) return file_or_name;  // read_preset() reports the error
  std::vector<std::string> names;
  std::vector<std::string> skipped;
  for (const LibraryEntry& entry : preset_library(&skipped)) {
    if (entry.name == file_or_name) return entry.file;
    names.push_back(entry.name);
  }
  if (fs::exists(file_or_name, error)) return file_or_name;
  throw SceneError(fmt::format("{}: no such file or experiment; allowed: a preset file, or one of {}{}",
                               shortened(file_or_name, kMostOfFileName),
                               shortened(fmt::format("{}", fmt::join(names, ", ")), 800),
                               skipped.empty() ? "" : " (" + shortened(skipped.front(), 120) + ")"));
}

}  // namespace carom
