#include "physics/files/output_file.h"

#include <cerrno>
#include <charconv>
#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <system_error>
#include <unistd.h>
#include <utility>

#include "physics/scene/validate.h"

namespace carom {
namespace {

constexpr std::size_t kBuffer = 1 << 16;  // bytes
constexpr mode_t kNewFile = 0666;
constexpr mode_t kOwnFile = 0600;
constexpr int kReaderWait = 5000;  // ms
constexpr int kReaderLook = 10;    // ms between two attempts

// Copies owner and mode of the replaced file. If its group cannot be kept, the new group gets only the
// others' rights.
void copy_owner_and_mode(int file, const struct stat& old) {
  mode_t mode = old.st_mode & (S_IRWXU | S_IRWXG | S_IRWXO);
  const bool owner = fchown(file, old.st_uid, old.st_gid) == 0;
  if (owner) {
    mode = old.st_mode & 07777;
  } else if (fchown(file, static_cast<uid_t>(-1), old.st_gid) != 0) {
    mode = (mode & ~static_cast<mode_t>(S_IRWXG)) | ((mode & S_IRWXO) << 3);
  }
  (void)fchmod(file, mode);  // fails on file systems without modes
}

// 0, or errno.
int write_all(int file, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(file, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0 && errno == EAGAIN) {
      pollfd ready = {file, POLLOUT, 0};
      poll(&ready, 1, -1);
      continue;
    }
    if (written <= 0) return written < 0 ? errno : ENOSPC;
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return 0;
}

namespace fs = std::filesystem;

constexpr int kMostLinks = 40;  // as the kernel has it
constexpr const char* kRightToWrite = "a place with the right to write";

std::string text_of(int error) { return std::generic_category().message(error); }

// The folder that a name is looked up in, without links.
fs::path folder_of(const fs::path& file, const std::string& name) {
  std::error_code error;
  const fs::path parent = file.parent_path();
  fs::path folder = fs::canonical(parent.empty() ? "." : parent, error);
  if (error || !fs::is_directory(folder, error))
    refuse_output(name,
                  fmt::format("the folder {} is not there{}", parent.empty() ? "." : parent.string(),
                              error == std::errc::permission_denied ? ", or shut" : ""),
                  "a folder that is there");
  return folder;
}

// The number of an open descriptor of this process that a file stands for, else -1.
int descriptor_of(const fs::path& folder, const std::string& file) {
  if (folder != fmt::format("/proc/{}/fd", getpid())) return -1;
  int number = -1;
  const auto [end, error] = std::from_chars(file.data(), file.data() + file.size(), number);
  return error == std::errc() && end == file.data() + file.size() ? number : -1;
}

bool is_mount(const fs::path& file) {
#ifdef STATX_ATTR_MOUNT_ROOT
  struct statx facts = {};
  return statx(AT_FDCWD, file.c_str(), AT_SYMLINK_NOFOLLOW, STATX_TYPE, &facts) == 0 &&
         (facts.stx_attributes & STATX_ATTR_MOUNT_ROOT) != 0;
#else
  (void)file;
  return false;
#endif
}

void check_replaceable(const OutputPlace& place, const struct stat& folder) {
  constexpr mode_t kAnyWrite = S_IWUSR | S_IWGRP | S_IWOTH;
  if ((place.facts.st_mode & kAnyWrite) == 0)
    refuse_output(place.name, "the file is marked read-only", "a file that may be changed");
  const int file = open(place.file.c_str(), O_WRONLY | O_CLOEXEC | O_NOCTTY | O_NOFOLLOW);
  if (file < 0)
    refuse_output(place.name, fmt::format("the file cannot be written ({})", text_of(errno)),
                  "a file with the right to write");
  close(file);
  const uid_t user = geteuid();
  const bool others = user != 0 && user != place.facts.st_uid && user != folder.st_uid;
  if ((folder.st_mode & S_ISVTX) != 0 && others)
    refuse_output(place.name, "the file is another user's", "a file of one's own in this folder");
  if (is_mount(place.file))
    refuse_output(place.name, "the file is a mount, which cannot be replaced", "another file");
}

}  // namespace

FileId id_of(const struct stat& facts) { return {facts.st_dev, facts.st_ino}; }

OutputPlace output_place(const std::string& name) {
  OutputPlace place;
  place.name = name;
  place.file = name;
  struct stat folder_facts = {};
  for (int links = 0;; ++links) {
    const std::string last = place.file.filename().string();
    if (last.empty() || last == "." || last == "..")
      refuse_output(name, "this names a folder", "the name of a file");
    const fs::path folder = folder_of(place.file, name);
    place.descriptor = descriptor_of(folder, last);
    if (place.descriptor >= 0) {
      place.kind = OutputPlace::Kind::kStream;
      const int flags = fcntl(place.descriptor, F_GETFL);
      if (flags < 0 || (flags & O_ACCMODE) == O_RDONLY || fstat(place.descriptor, &place.facts) != 0)
        refuse_output(name, "nothing can be written there", kRightToWrite);
      return place;
    }
    place.file = folder / last;
    if (stat(folder.c_str(), &folder_facts) != 0)
      refuse_output(name, fmt::format("its folder cannot be read ({})", text_of(errno)), kRightToWrite);
    place.folder = id_of(folder_facts);
    if (lstat(place.file.c_str(), &place.facts) != 0) {
      if (errno != ENOENT)
        refuse_output(name, fmt::format("the file cannot be written ({})", text_of(errno)), kRightToWrite);
      place.kind = OutputPlace::Kind::kNew;
      return place;
    }
    if (!S_ISLNK(place.facts.st_mode)) break;
    std::error_code error;
    const fs::path target = fs::read_symlink(place.file, error);
    if (error || links == kMostLinks) refuse_output(name, "its links lead nowhere", "a file");
    // What another process has open is reached through a link that leads to no name.
    if (folder.string().starts_with("/proc/")) {
      if (stat(place.file.c_str(), &place.facts) != 0)
        refuse_output(name, fmt::format("nothing can be written there ({})", text_of(errno)), kRightToWrite);
      place.kind = OutputPlace::Kind::kSpecial;
      return place;
    }
    place.file = folder / target;
  }
  if (S_ISDIR(place.facts.st_mode)) refuse_output(name, "this is a folder", "the name of a file");
  place.kind = S_ISREG(place.facts.st_mode) ? OutputPlace::Kind::kReplaced : OutputPlace::Kind::kSpecial;
  if (place.kind == OutputPlace::Kind::kReplaced) check_replaceable(place, folder_facts);
  return place;
}

void refuse_output(const std::string& name, const std::string& why, const std::string& allowed) {
  throw SceneError(fmt::format("{}: {}; allowed: {}", name, why, allowed));
}

OutputFile::OutputFile(OutputPlace place) : place_(std::move(place)) {
  using Kind = OutputPlace::Kind;
  if (place_.kind == Kind::kSpecial || place_.kind == Kind::kStream) {
    open_through();
    return;
  }
  const bool replaced = place_.kind == Kind::kReplaced;
  try {
    temporary_ = std::make_unique<TemporaryFile>(place_.file.parent_path(), replaced ? kOwnFile : kNewFile);
  } catch (const std::system_error& error) {
    refuse_output(name(), fmt::format("the file cannot be written ({})", error.code().message()),
                  "a place with room and the right to write");
  }
  if (replaced) copy_owner_and_mode(temporary_->descriptor(), place_.facts);
}

OutputFile::~OutputFile() {
  if (through_ >= 0) close(through_);
}

void OutputFile::open_through() {
  if (place_.kind == OutputPlace::Kind::kStream) {
    through_ = fcntl(place_.descriptor, F_DUPFD_CLOEXEC, 0);
  } else {
    const auto try_to = [&] {
      through_ = open(place_.file.c_str(), O_WRONLY | O_CLOEXEC | O_NOCTTY | O_NONBLOCK);
      return through_ >= 0 || errno != ENXIO || !S_ISFIFO(place_.facts.st_mode);
    };
    bool done = try_to();
    for (int waited = 0; !done && waited < kReaderWait; waited += kReaderLook) {
      poll(nullptr, 0, kReaderLook);
      done = try_to();
    }
    if (!done) refuse_output(name(), "nobody reads this pipe", "a file, or a pipe with a reader");
    if (through_ >= 0) fcntl(through_, F_SETFL, fcntl(through_, F_GETFL) & ~O_NONBLOCK);
  }
  if (through_ < 0)
    refuse_output(name(), fmt::format("nothing can be written there ({})", text_of(errno)),
                  "a place with the right to write");
}

void OutputFile::write(std::string_view bytes) {
  if (!failure_.empty() || unread_) return;
  buffer_ += bytes;
  if (buffer_.size() >= kBuffer) flush();
}

void OutputFile::line(std::string_view text) {
  write(text);
  write("\n");
}

void OutputFile::flush() {
  const int file = temporary_ ? temporary_->descriptor() : through_;
  const int error = write_all(file, buffer_);
  buffer_.clear();
  if (error != 0) fail(error);
}

void OutputFile::fail(int error) {
  buffer_.clear();
  temporary_.reset();  // frees the disk space
  if (error == EPIPE && place_.kind == OutputPlace::Kind::kStream && place_.descriptor == STDOUT_FILENO) {
    unread_ = true;
    return;
  }
  failure_ =
      fmt::format("{}: the file could not be written ({}); allowed: a place with room and the right to write",
                  name(), text_of(error));
}

void OutputFile::finish() {
  if (finished_) return;
  finished_ = true;
  if (failure_.empty() && !unread_) flush();
  buffer_ = std::string();
  if (failure_.empty() && temporary_) {
    if (const int error = temporary_->sync(); error != 0) fail(error);
  }
  if (failure_.empty() && through_ >= 0) {
    // Files without a disk behind them return EINVAL.
    if (fsync(through_) != 0 && (errno == EIO || errno == ENOSPC || errno == EDQUOT)) fail(errno);
    if (close(std::exchange(through_, -1)) != 0 && failure_.empty()) fail(errno);
  }
  if (!failure_.empty()) throw SceneError(failure_);
}

void OutputFile::commit() {
  finish();
  if (!temporary_) return;
  if (const int error = temporary_->rename_to(place_.file, place_.kind == OutputPlace::Kind::kReplaced);
      error != 0)
    fail(error);
  temporary_.reset();
  if (!failure_.empty()) throw SceneError(failure_);
}

OutputSet::OutputSet(const std::vector<std::filesystem::path>& inputs) {
  for (const std::filesystem::path& name : inputs) {
    struct stat facts = {};
    if (stat(name.c_str(), &facts) == 0 && !S_ISCHR(facts.st_mode))
      inputs_.emplace(id_of(facts), name.string());
  }
}

OutputPlace OutputSet::reserve(const std::string& name) {
  using Kind = OutputPlace::Kind;
  OutputPlace place = output_place(name);
  const bool there = place.kind != Kind::kNew;
  if (there && S_ISCHR(place.facts.st_mode)) return place;
  const FileId id = id_of(place.facts);
  if (const auto input = inputs_.find(id); there && input != inputs_.end())
    refuse_output(name, fmt::format("this is the file that is read, {}", input->second), "another file");
  for (const int stream : {STDOUT_FILENO, STDERR_FILENO}) {
    struct stat facts = {};
    if (place.kind == Kind::kReplaced && fstat(stream, &facts) == 0 && id_of(facts) == id)
      refuse_output(name, stream == STDOUT_FILENO ? "stdout goes to this file" : "stderr goes to this file",
                    "another file");
  }
  const auto refuse_twice = [&](const std::string& other) {
    refuse_output(name, fmt::format("the output {} goes to this file too", other), "a file for each");
  };
  if (there) {
    const auto [other, first] = outputs_.emplace(id, name);
    if (!first) refuse_twice(other->second);
  } else {
    const auto [other, first] =
        new_outputs_.emplace(std::pair(place.folder, place.file.filename().string()), name);
    if (!first) refuse_twice(other->second);
  }
  return place;
}

OutputFile* OutputSet::open(const std::string& name) {
  return name.empty() ? nullptr : &files_.emplace_back(reserve(name));
}

std::string OutputSet::commit() {
  std::string failures;
  for (OutputFile& file : files_) {
    try {
      file.commit();
    } catch (const SceneError& error) {
      failures += (failures.empty() ? "" : "; ") + std::string(error.what());
    }
  }
  return failures;
}

}  // namespace carom
