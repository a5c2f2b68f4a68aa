#include "physics/files/output_file.h"

#include <cerrno>
#include <cstdio>
#include <fcntl.h>
#include <fmt/format.h>
#include <random>
#include <system_error>
#include <unistd.h>
#include <utility>

#include "physics/scene/validate.h"

namespace carom {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kBuffer = 1 << 16;  // bytes
constexpr int kMostLinks = 40;            // as the kernel has it

std::string text_of(int error) { return std::generic_category().message(error); }

// 0, or errno.
int write_all(int file, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(file, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return written < 0 ? errno : ENOSPC;
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return 0;
}

// What the symbolic links of a name lead to, in a folder without links.
fs::path without_links(const std::string& name) {
  fs::path file = name;
  std::error_code error;
  for (int links = 0; fs::is_symlink(file, error); ++links) {
    if (links == kMostLinks) refuse_output(name, "its links lead nowhere", "a file");
    file = file.parent_path() / fs::read_symlink(file, error);
  }
  const fs::path last = file.filename();
  if (last.empty() || last == "." || last == "..")
    refuse_output(name, "this names a folder", "the name of a file");
  const fs::path parent = file.has_parent_path() ? file.parent_path() : ".";
  const fs::path folder = fs::canonical(parent, error);
  if (error || !fs::is_directory(folder, error))
    refuse_output(name,
                  fmt::format("the folder {} is not there{}", parent.string(),
                              error == std::errc::permission_denied ? ", or shut" : ""),
                  "a folder that is there");
  return folder / last;
}

void check_replaceable(const OutputPlace& place) {
  constexpr mode_t kAnyWrite = S_IWUSR | S_IWGRP | S_IWOTH;
  if ((place.facts.st_mode & kAnyWrite) == 0)
    refuse_output(place.name, "the file is marked read-only", "a file that may be changed");
  if (access(place.file.c_str(), W_OK) != 0)
    refuse_output(place.name, fmt::format("the file cannot be written ({})", text_of(errno)),
                  "a file with the right to write");
}

}  // namespace

FileId id_of(const struct stat& facts) { return {facts.st_dev, facts.st_ino}; }

OutputPlace output_place(const std::string& name) {
  using Kind = OutputPlace::Kind;
  OutputPlace place;
  place.name = name;
  place.file = name;
  if (name == "/dev/stdout") {
    place.kind = Kind::kStdout;
    (void)fstat(STDOUT_FILENO, &place.facts);
    return place;
  }
  const bool there = stat(name.c_str(), &place.facts) == 0;
  if (there && S_ISDIR(place.facts.st_mode)) refuse_output(name, "this is a folder", "the name of a file");
  if (there && !S_ISREG(place.facts.st_mode)) {
    place.kind = Kind::kSpecial;
    return place;
  }
  place.file = without_links(name);
  struct stat folder = {};
  (void)stat(place.file.parent_path().c_str(), &folder);
  place.folder = id_of(folder);
  place.kind = there ? Kind::kReplaced : Kind::kNew;
  if (there) check_replaceable(place);
  return place;
}

void refuse_output(const std::string& name, const std::string& why, const std::string& allowed) {
  throw SceneError(fmt::format("{}: {}; allowed: {}", name, why, allowed));
}

OutputFile::OutputFile(OutputPlace place) : place_(std::move(place)) {
  using Kind = OutputPlace::Kind;
  switch (place_.kind) {
    case Kind::kStdout:
      descriptor_ = fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, 0);
      break;
    case Kind::kSpecial:
      descriptor_ = open(place_.file.c_str(), O_WRONLY | O_CLOEXEC | O_NOCTTY);
      break;
    case Kind::kNew:
    case Kind::kReplaced: {
      std::random_device random;
      temporary_ = place_.file.parent_path() / fmt::format(".carom-{:08x}{:08x}.part", random(), random());
      const bool replaced = place_.kind == Kind::kReplaced;
      descriptor_ = open(temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, replaced ? 0600 : 0666);
      if (descriptor_ < 0) temporary_.clear();
      if (replaced && descriptor_ >= 0)
        (void)fchmod(descriptor_, place_.facts.st_mode & 0777);  // fails on file systems without modes
      break;
    }
  }
  if (descriptor_ < 0)
    refuse_output(name(), fmt::format("the file cannot be written ({})", text_of(errno)),
                  "a place with room and the right to write");
}

void OutputFile::drop() {
  if (descriptor_ >= 0) close(std::exchange(descriptor_, -1));
  if (!temporary_.empty()) unlink(temporary_.c_str());
  temporary_.clear();
}

void OutputFile::write(std::string_view bytes) {
  if (!failure_.empty()) return;
  buffer_ += bytes;
  if (buffer_.size() >= kBuffer) flush();
}

void OutputFile::line(std::string_view text) {
  write(text);
  write("\n");
}

void OutputFile::flush() {
  const int error = write_all(descriptor_, buffer_);
  buffer_.clear();
  if (error != 0) fail(error);
}

void OutputFile::fail(int error) {
  drop();  // frees the disk space
  failure_ =
      fmt::format("{}: the file could not be written ({}); allowed: a place with room and the right to write",
                  name(), text_of(error));
}

void OutputFile::finish() {
  if (failure_.empty() && descriptor_ >= 0) {
    flush();
    buffer_ = std::string();
    // Some file systems cannot sync.
    if (!temporary_.empty() && fsync(descriptor_) != 0 && errno != EINVAL && errno != ENOTSUP) fail(errno);
    // On a network file system a full disk may show only here.
    if (descriptor_ >= 0 && close(std::exchange(descriptor_, -1)) != 0) fail(errno);
  }
  if (!failure_.empty()) throw SceneError(failure_);
}

void OutputFile::commit() {
  finish();
  if (temporary_.empty()) return;
  if (std::rename(temporary_.c_str(), place_.file.c_str()) != 0) fail(errno);
  temporary_.clear();
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
