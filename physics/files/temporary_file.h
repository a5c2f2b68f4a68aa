#pragma once

#include <filesystem>
#include <sys/types.h>

namespace carom {

// A new file in a folder, open for writing: without a name, so that no end of the process leaves it behind, but
// in the moment in which it replaces another. Where the file system has no such files, or very many are made at
// once, it has a name of its own (.carom-XXXXXXXXXXXX.part). It goes with this
// object, unless it was renamed, and where remove_temporaries_on_signals() was called also where a signal ends
// the process. One thread at a time may use an object; different objects know nothing of each other.
class TemporaryFile {
 public:
  // `mode` is of the new file, less what the process's umask takes. Throws std::system_error.
  TemporaryFile(const std::filesystem::path& folder, mode_t mode);
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile();

  [[nodiscard]] int descriptor() const { return descriptor_; }
  // 0, or errno. Nothing is written after sync().
  [[nodiscard]] int sync();
  // Without `replace` EEXIST where the file is there by now, if the file system can tell.
  [[nodiscard]] int rename_to(const std::filesystem::path& file, bool replace);

  struct Entry;

 private:
  // Calls make(path) with names until it returns something other than EEXIST, and enters the one that it made
  // into the list.
  template <class Make>
  int take_name(const Make& make);
  int give_name();
  int close_it();

  std::filesystem::path folder_;
  Entry* entry_ = nullptr;  // in the list of all temporary files, while it has a name of its own
  int descriptor_ = -1;
  bool nameless_ = false;
};

// A folder that goes, if it is empty then, on the same ends; keep() takes that back.
class TemporaryFolder {
 public:
  // Makes it. Throws std::system_error.
  explicit TemporaryFolder(const std::filesystem::path& folder);
  TemporaryFolder(TemporaryFolder&& other) noexcept;
  TemporaryFolder& operator=(TemporaryFolder&&) = delete;
  ~TemporaryFolder();
  void keep();

 private:
  TemporaryFile::Entry* entry_;
};

// From now on a signal that ends the process (an interrupt, a request to end, a hang-up, a crash) removes all
// temporary files first; the exit status tells the signal as before. Signals that are ignored or handled
// already stay so. For programs; a library's user may have handlers of his own.
void remove_temporaries_on_signals();

}  // namespace carom
