#pragma once

#include <filesystem>
#include <sys/types.h>

namespace carom {

// A new file in a folder, open for writing. It has no name until it replaces another file, so it disappears
// however the process ends. If the file system has no such files, or very many are made at once, it has a
// name of its own (.carom-XXXXXXXXXXXX.part). It is then removed with this object, unless it was renamed, and
// after remove_temporaries_on_signals() also when a signal ends the process. One thread at a time may use an
// object; different objects are independent.
class TemporaryFile {
 public:
  // The new file has `mode` less the process's umask. Throws std::system_error.
  TemporaryFile(const std::filesystem::path& folder, mode_t mode);
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile();

  [[nodiscard]] int descriptor() const { return descriptor_; }
  // Returns 0 or errno. Nothing may be written after sync().
  [[nodiscard]] int sync();
  // Returns 0 or errno. Without `replace`, EEXIST if the file exists by now and the file system can tell.
  [[nodiscard]] int rename_to(const std::filesystem::path& file, bool replace);

  struct Entry;

 private:
  // Calls make(path) with names until it returns something other than EEXIST, and adds the file that it made
  // to the list.
  template <class Make>
  int take_name(const Make& make);
  int give_name();
  int close_it();

  std::filesystem::path folder_;
  Entry* entry_ = nullptr;  // in the list of all temporary files, while it has a name of its own
  int descriptor_ = -1;
  bool nameless_ = false;
};

// A folder that is removed, if it is empty by then, on the same occasions; keep() prevents it.
class TemporaryFolder {
 public:
  // Creates it. Throws std::system_error.
  explicit TemporaryFolder(const std::filesystem::path& folder);
  TemporaryFolder(TemporaryFolder&& other) noexcept;
  TemporaryFolder& operator=(TemporaryFolder&&) = delete;
  ~TemporaryFolder();
  void keep();

 private:
  TemporaryFile::Entry* entry_;
};

// From now on a signal that ends the process (an interrupt, a request to end, a hang-up, a crash) removes all
// temporary files first; the exit status still shows the signal. Signals that are ignored or handled already
// stay so. For programs; a user of the library may have handlers of their own.
void remove_temporaries_on_signals();

}  // namespace carom
