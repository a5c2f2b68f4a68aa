#pragma once

#include <compare>
#include <filesystem>
#include <string>
#include <sys/stat.h>

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
    kStream,    // an open descriptor of this process, as /dev/stdout is
  };
  Kind kind = Kind::kNew;
  std::string name;            // as the user wrote it
  std::filesystem::path file;  // absolute and without links, but for what is special
  FileId folder;               // that holds it; of kNew and kReplaced
  struct stat facts = {};      // of what is there already; not of kNew
  int descriptor = -1;         // of kStream
};

// Throws SceneError where no file of this name can be written: its folder is not there or may not be changed,
// it is a folder itself, it is marked read-only (no right to write; for root: nobody has one), links lead
// nowhere. Nothing is changed or opened for long.
[[nodiscard]] OutputPlace output_place(const std::string& name);

// Throws SceneError: "name: why; allowed: allowed".
[[noreturn]] void refuse_output(const std::string& name, const std::string& why, const std::string& allowed);

}  // namespace carom
