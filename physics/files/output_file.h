#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "physics/files/output_place.h"
#include "physics/files/temporary_file.h"

namespace carom {

// A file that is written whole or not at all. The bytes go to a temporary file in the same folder, which
// commit() puts in the place of the old one, with its mode and, where that is possible, its owner; symbolic
// links stay and what they lead to is replaced. Devices, pipes and terminals are written through. A pipe must
// have a reader within 5 s.
//
//   OutputFile file("run.csv");  // throws SceneError where it cannot be written
//   file.line("time [s]");
//   file.commit();               // throws SceneError where not all of it could be
//
// A write that fails is remembered until then, so that a run goes on to its results.
class OutputFile {
 public:
  explicit OutputFile(const std::string& name) : OutputFile(output_place(name)) {}
  explicit OutputFile(OutputPlace place);
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;
  ~OutputFile();  // without commit(): the old file, or none

  [[nodiscard]] const std::string& name() const { return place_.name; }
  void write(std::string_view bytes);
  void line(std::string_view text);
  // There is nothing good to write: the old file stays, and commit() throws `why`.
  void give_up(const std::string& why) {
    if (failure_.empty()) failure_ = why;
  }
  [[nodiscard]] bool failed() const { return !failure_.empty(); }
  // Everything is on the disk, but not yet in its place; nothing more may be written. Throws as commit() does.
  void finish();
  void commit();

 private:
  void open_through();
  void flush();
  void fail(int error);

  OutputPlace place_;
  std::unique_ptr<TemporaryFile> temporary_;
  int through_ = -1;  // descriptor of what is written through
  bool finished_ = false;
  bool unread_ = false;  // nobody reads stdout: nothing more is written, and nobody is told
  std::string buffer_;
  std::string failure_;
};

}  // namespace carom
