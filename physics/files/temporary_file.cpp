#include "physics/files/temporary_file.h"

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <fcntl.h>
#include <poll.h>
#include <random>
#include <string>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>
#include <utility>

namespace carom {

struct TemporaryFile::Entry {
  std::string path;
  bool folder = false;
  Entry* older = nullptr;
  Entry* newer = nullptr;
};

namespace {

using Entry = TemporaryFile::Entry;

// One list per process, as signals are; the newest first. All signals are blocked while it changes, so that
// the handler, in whatever thread it runs, never waits for its own thread.
std::atomic_flag list_in_use = ATOMIC_FLAG_INIT;
Entry* newest = nullptr;

void take_list() {
  while (list_in_use.test_and_set(std::memory_order_acquire)) poll(nullptr, 0, 1);
}

class ListLock {
 public:
  ListLock() {
    sigset_t all{};
    sigfillset(&all);
    pthread_sigmask(SIG_BLOCK, &all, &before_);
    take_list();
  }
  ListLock(const ListLock&) = delete;
  ListLock& operator=(const ListLock&) = delete;
  ~ListLock() {
    list_in_use.clear(std::memory_order_release);
    pthread_sigmask(SIG_SETMASK, &before_, nullptr);
  }

 private:
  sigset_t before_{};
};

void add(Entry* entry) {
  entry->older = newest;
  if (newest != nullptr) newest->newer = entry;
  newest = entry;
}

void drop(Entry* entry) {
  if (entry->newer != nullptr) entry->newer->older = entry->older;
  if (entry->older != nullptr) entry->older->newer = entry->newer;
  if (newest == entry) newest = entry->older;
  delete entry;
}

void remove(const Entry& entry) {
  if (entry.folder) {
    rmdir(entry.path.c_str());
  } else {
    unlink(entry.path.c_str());
  }
}

// Removes an entry from the list, with `and_remove` also what it names.
void forget(Entry*& entry, bool and_remove) {
  if (entry == nullptr) return;
  const ListLock lock;
  if (and_remove) remove(*entry);
  drop(std::exchange(entry, nullptr));
}

// Makes only async-signal-safe calls. The list stays locked: the process ends.
extern "C" void remove_all_and_end(int signal) {
  take_list();
  for (const Entry* entry = newest; entry != nullptr; entry = entry->older) remove(*entry);
  raise(signal);  // its default action, once the handler returns
}

std::string random_name() {
  static constexpr char kLetters[] = "abcdefghijklmnopqrstuvwxyz0123456789";
  std::random_device random;
  std::uniform_int_distribution<std::size_t> letter(0, sizeof(kLetters) - 2);
  std::string name = ".carom-";
  for (int i = 0; i < 12; ++i) name += kLetters[letter(random)];
  return name + ".part";
}

// The most open files without a name. Each takes one of the process's descriptors (often 1024); beyond this
// they get names, and are closed, as soon as they are complete.
constexpr int kMostNameless = 100;
std::atomic<int> nameless_open = 0;

std::string open_file(int descriptor) { return "/proc/self/fd/" + std::to_string(descriptor); }

}  // namespace

template <class Make>
int TemporaryFile::take_name(const Make& make) {
  entry_ = new Entry;
  int error = EEXIST;
  constexpr int kTries = 100;
  for (int i = 0; i < kTries && error == EEXIST; ++i) {
    entry_->path = (folder_ / random_name()).string();
    const ListLock lock;
    error = make(entry_->path.c_str()) ? 0 : errno;
    if (error == 0) add(entry_);
  }
  if (error != 0) delete std::exchange(entry_, nullptr);
  return error;
}

TemporaryFile::TemporaryFile(const std::filesystem::path& folder, mode_t mode)
    : folder_(std::filesystem::absolute(folder)) {
  descriptor_ = open(folder_.c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, mode);
  // It can get a name later only through the list of open files.
  if (descriptor_ >= 0 && access(open_file(descriptor_).c_str(), F_OK) != 0)
    close(std::exchange(descriptor_, -1));
  if (descriptor_ >= 0) {
    nameless_ = true;
    ++nameless_open;
    return;
  }
  const int error = take_name([&](const char* path) {
    descriptor_ = open(path, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC | O_NOFOLLOW, mode);
    return descriptor_ >= 0;
  });
  if (error != 0) throw std::system_error(error, std::generic_category());
}

TemporaryFile::~TemporaryFile() {
  if (descriptor_ >= 0) close_it();
  forget(entry_, true);
}

// 0, or errno.
int TemporaryFile::close_it() {
  if (nameless_) --nameless_open;
  nameless_ = false;
  return close(std::exchange(descriptor_, -1)) == 0 ? 0 : errno;
}

// Names a file that has no name yet. Returns 0 or errno.
int TemporaryFile::give_name() {
  const std::string source = open_file(descriptor_);
  return take_name([&](const char* path) {
    return linkat(AT_FDCWD, source.c_str(), AT_FDCWD, path, AT_SYMLINK_FOLLOW) == 0;
  });
}

int TemporaryFile::sync() {
  int synced = fsync(descriptor_) == 0 ? 0 : errno;
  if (synced == EINVAL || synced == ENOSYS || synced == ENOTSUP) synced = 0;  // this file system cannot sync
  if (synced == 0 && entry_ == nullptr && nameless_open > kMostNameless) synced = give_name();
  if (entry_ == nullptr) return synced;
  // On a network file system a full disk may show only here.
  const int closed = close_it();
  return synced != 0 ? synced : closed;
}

int TemporaryFile::rename_to(const std::filesystem::path& file, bool replace) {
  if (entry_ == nullptr && !replace) {
    const std::string source = open_file(descriptor_);
    return linkat(AT_FDCWD, source.c_str(), AT_FDCWD, file.c_str(), AT_SYMLINK_FOLLOW) == 0 ? 0 : errno;
  }
  if (entry_ == nullptr) {
    if (const int error = give_name(); error != 0) return error;
  }
  const char* const from = entry_->path.c_str();
  if (!replace) {
    if (renameat2(AT_FDCWD, from, AT_FDCWD, file.c_str(), RENAME_NOREPLACE) == 0) {
      forget(entry_, false);
      return 0;
    }
    // A file system without this option replaces the file.
    if (errno != EINVAL && errno != ENOSYS) return errno;
  }
  if (std::rename(from, file.c_str()) != 0) return errno;
  forget(entry_, false);
  return 0;
}

TemporaryFolder::TemporaryFolder(const std::filesystem::path& folder) : entry_(new Entry) {
  entry_->path = std::filesystem::absolute(folder).string();
  entry_->folder = true;
  int error = 0;
  {
    const ListLock lock;
    if (mkdir(entry_->path.c_str(), 0777) != 0) error = errno;
    if (error == 0) add(entry_);
  }
  if (error == 0) return;
  delete entry_;
  throw std::system_error(error, std::generic_category());
}

TemporaryFolder::TemporaryFolder(TemporaryFolder&& other) noexcept
    : entry_(std::exchange(other.entry_, nullptr)) {}

TemporaryFolder::~TemporaryFolder() { forget(entry_, true); }

void TemporaryFolder::keep() { forget(entry_, false); }

void remove_temporaries_on_signals() {
  for (const int signal :
       {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGXCPU, SIGABRT, SIGSEGV, SIGBUS, SIGFPE, SIGILL}) {
    struct sigaction action = {};
    if (sigaction(signal, nullptr, &action) != 0 || action.sa_handler != SIG_DFL) continue;
    action = {};
    action.sa_handler = remove_all_and_end;
    action.sa_flags = SA_RESETHAND | SA_ONSTACK;
    sigfillset(&action.sa_mask);
    sigaction(signal, &action, nullptr);
  }
}

}  // namespace carom
