#pragma once

#include <deque>
#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "physics/files/output_file.h"

namespace carom {

// All files that one command writes. They are opened before its work, so that hours of it do not end at a
// file that cannot be written. No output may replace an input or another output, by whatever name: relative,
// absolute, through symbolic links or hard links. Devices, such as /dev/null, may be named twice.
class OutputSet {
 public:
  explicit OutputSet(const std::vector<std::filesystem::path>& inputs = {});
  OutputSet(const OutputSet&) = delete;
  OutputSet& operator=(const OutputSet&) = delete;

  // Adds the name to this set. Throws SceneError if it is taken or cannot be written.
  OutputPlace reserve(const std::string& name);
  // Reserves and opens a file, which lives as long as the set; nullptr if the name is empty.
  [[nodiscard]] OutputFile* open(const std::string& name);
  // Puts every file in its place that could be written. Returns one line about those that could not, else an
  // empty text.
  [[nodiscard]] std::string commit();

 private:
  // Names as the user wrote them, of existing files and of new ones (folder and name).
  std::map<FileId, std::string> inputs_;
  std::map<FileId, std::string> outputs_;
  std::map<std::pair<FileId, std::string>, std::string> new_outputs_;
  std::deque<OutputFile> files_;
};

}  // namespace carom
