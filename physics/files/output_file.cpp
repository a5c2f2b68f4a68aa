#include "physics/files/output_file.h"

#include <cerrno>
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
void take_over(int file, const struct stat& old) {
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

}  // namespace

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
  if (replaced) take_over(temporary_->descriptor(), place_.facts);
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
    refuse_output(name(),
                  fmt::format("nothing can be written there ({})", std::generic_category().message(errno)),
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
                  name(), std::generic_category().message(error));
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

}  // namespace carom
