#pragma once

#include <filesystem>
#include <sys/types.h>

namespace carom {

// A new file beside those of a folder, under a name of its own (.carom-XXXXXXXXXXXX.part), open for writing. It
// goes with this object, unless it was renamed, and where remove_temporaries_on_signals() was called also where
// a signal ends the process. One thread at a time may use an object; different objects know nothing of each
// other.
class TemporaryFile {
 public:
  // `mode` is of the new file, less what the process's umask takes. Throws std::system_error.
  TemporaryFile(const std::filesystem::path& folder, mode_t mode);
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile();

  [[nodiscard]] int descriptor() const { return descriptor_; }  // -1 once it is closed
  // 0, or errno.
  [[nodiscard]] int sync_and_close();
  [[nodiscard]] int rename_to(const std::filesystem::path& file);

  struct Entry;

 private:
  Entry* entry_;  // in the list of all temporary files; none once it is renamed
  int descriptor_ = -1;
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
