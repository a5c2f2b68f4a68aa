#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace carom::test {

// Which file of physics, widgets, app and tests includes which. All paths are relative to the top of the
// sources.
class IncludeGraph {
 public:
  using Path = std::filesystem::path;

  // Reads every .h and .cpp under `top`. Throws std::filesystem::filesystem_error if a folder is missing.
  explicit IncludeGraph(const Path& top);

  // Each file with the files of the sources that it names in its includes.
  [[nodiscard]] const std::map<Path, std::set<Path>>& includes() const { return includes_; }

  // The given files and all that include them, directly or through others.
  [[nodiscard]] std::set<Path> affected(const std::set<Path>& changed) const;

  // The tests to run after a change: of each folder that has a changed file, of each folder that includes one
  // of such a folder, and those that include one themselves; of what tests share, those that use it. What is no
  // code (presets, help, golden files) counts as changed for all tests that read files of the sources.
  // rooms_test reads them all.
  [[nodiscard]] std::set<Path> tests(const std::set<Path>& changed) const;

 private:
  std::map<Path, std::set<Path>> includes_;
};

}  // namespace carom::test
