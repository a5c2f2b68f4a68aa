#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "physics/files/output_place.h"
#include "physics/files/temporary_file.h"

namespace carom {

// A file that is written whole or not at all. The bytes go to a temporary file in the same folder; commit()
// puts it in place of the old one, with the old mode and, if possible, the old owner. Symbolic links stay;
// their target is replaced. Devices, pipes and terminals are written directly. A pipe must have a reader
// within 5 s.
//
//   OutputFile file("run.csv");  // throws SceneError if it cannot be written
//   file.line("time [s]");
//   file.commit();               // throws SceneError if a write failed
//
// A failed write is reported only by commit(), so that a run still reaches its results.
class OutputFile {
 public:
  explicit OutputFile(const std::string& name) : OutputFile(output_place(name)) {}
  explicit OutputFile(OutputPlace place);
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;
  ~OutputFile();  // without commit() the old file stays, or there is none

  [[nodiscard]] const std::string& name() const { return place_.name; }
  void write(std::string_view bytes);
  void line(std::string_view text);
  // The content is not usable: the old file stays, and commit() throws `why`.
  void give_up(const std::string& why) {
    if (failure_.empty()) failure_ = why;
  }
  [[nodiscard]] bool failed() const { return !failure_.empty(); }
  // Writes everything to the disk, but not yet in its place; nothing more may be written. Throws like
  // commit().
  void finish();
  void commit();

 private:
  void open_through();
  void flush();
  void fail(int error);

  OutputPlace place_;
  std::unique_ptr<TemporaryFile> temporary_;
  int through_ = -1;  // descriptor of a device, pipe or terminal
  bool finished_ = false;
  bool unread_ = false;  // stdout has no reader: nothing more is written, without an error
  std::string buffer_;
  std::string failure_;
};

}  // namespace carom
