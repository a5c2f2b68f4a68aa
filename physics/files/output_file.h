#pragma once

#include <compare>
#include <deque>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <sys/stat.h>
#include <utility>
#include <vector>

namespace carom {

// Tells files apart whatever their names are: device and inode.
struct FileId {
  dev_t device = 0;
  ino_t inode = 0;
  friend auto operator<=>(const FileId&, const FileId&) = default;
};
[[nodiscard]] FileId id_of(const struct stat& facts);

// Where the bytes of an output go, found by following its name through symbolic links.
struct OutputPlace {
  enum class Kind {
    kNew,       // a file that is not there yet
    kReplaced,  // a file that is there
    kSpecial,   // a device, a pipe or a terminal
    kStdout,    // this process's own, /dev/stdout
  };
  Kind kind = Kind::kNew;
  std::string name;            // as the user wrote it
  std::filesystem::path file;  // absolute and without links, but for what is special
  FileId folder;               // that holds it; of kNew and kReplaced
  struct stat facts = {};      // of what is there already; not of kNew
};

// Throws SceneError where no file of this name can be written: its folder is not there, it is a folder itself,
// it is marked read-only (no right to write; for root: nobody has one), links lead nowhere.
[[nodiscard]] OutputPlace output_place(const std::string& name);

// Throws SceneError: "name: why; allowed: allowed".
[[noreturn]] void refuse_output(const std::string& name, const std::string& why, const std::string& allowed);

// A file that is written whole or not at all. The bytes go to a temporary file in the same folder
// (.carom-X.part), which commit() puts in the place of the old one, with its mode; symbolic links stay and what
// they lead to is replaced. Devices, pipes, terminals and stdout are written through. A process that is killed
// leaves the old file, and its temporary one.
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
  ~OutputFile() { drop(); }  // without commit() the old file stays, or there is none

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
  void flush();
  void fail(int error);
  // Closes what is open and removes the temporary file.
  void drop();

  OutputPlace place_;
  std::filesystem::path temporary_;  // empty if there is none (any more)
  int descriptor_ = -1;
  std::string buffer_;
  std::string failure_;
};

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
