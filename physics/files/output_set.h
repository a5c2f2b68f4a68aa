#pragma once

#include <deque>
#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "physics/files/output_file.h"

namespace carom {

// All files that one command writes, to be opened before its work, so that hours of it don't end at a file that
// cannot be written, and no output takes the place of an input or of another output, by whatever name:
// relative, absolute, through symbolic links or hard links. Devices, such as /dev/null, may be named twice.
class OutputSet {
 public:
  explicit OutputSet(const std::vector<std::filesystem::path>& inputs = {});
  OutputSet(const OutputSet&) = delete;
  OutputSet& operator=(const OutputSet&) = delete;

  // Takes the name as one of this set's. Throws SceneError.
  OutputPlace reserve(const std::string& name);
  // Reserves and opens; without a name there is none. It lives as long as the set.
  [[nodiscard]] OutputFile* open(const std::string& name);
  // Puts every file in its place that could be written. The answer is one line about those that could not, else
  // empty.
  [[nodiscard]] std::string commit();

 private:
  // Names as the user wrote them, of what is there and of what is not there yet.
  std::map<FileId, std::string> inputs_;
  std::map<FileId, std::string> outputs_;
  std::map<std::pair<FileId, std::string>, std::string> new_outputs_;
  std::deque<OutputFile> files_;
};

}  // namespace carom
