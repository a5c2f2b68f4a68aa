#pragma once

#include <compare>
#include <filesystem>
#include <string>
#include <sys/stat.h>

namespace carom {

// Identifies a file, whatever its name: device and inode.
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
    kStream,    // an open descriptor of this process, such as /dev/stdout
  };
  Kind kind = Kind::kNew;
  std::string name;            // as the user wrote it
  std::filesystem::path file;  // absolute and without links, except for kSpecial
  FileId folder;               // of the file; for kNew and kReplaced
  struct stat facts = {};      // of the existing file; not for kNew
  int descriptor = -1;         // for kStream
};

// Throws SceneError if no file of this name can be written: its folder is missing or may not be changed, it
// is a folder itself, it is read-only (no right to write; for root: nobody has one), or its links lead
// nowhere. Changes nothing and leaves nothing open.
[[nodiscard]] OutputPlace output_place(const std::string& name);

// Throws SceneError: "name: why; allowed: allowed".
[[noreturn]] void refuse_output(const std::string& name, const std::string& why, const std::string& allowed);

}  // namespace carom
