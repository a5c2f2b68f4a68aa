#include "physics/files/output_place.h"

#include <cerrno>
#include <charconv>
#include <fcntl.h>
#include <fmt/format.h>
#include <system_error>
#include <unistd.h>

#include "physics/scene/validate.h"

namespace carom {
namespace {

namespace fs = std::filesystem;

constexpr int kMostLinks = 40;  // as in the kernel
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

// The open descriptor of this process that a file stands for, else -1.
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
    // An open file of another process is a link whose target is not a name.
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

}  // namespace carom
