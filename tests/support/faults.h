#pragma once

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <string>
#include <sys/mount.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tests/support/effort.h"

// Faults of files: full disks, missing rights, kills at any moment.
namespace carom::test {

// A mounted disk of so many bytes, if the user may mount one.
class SmallDisk {
 public:
  SmallDisk(const std::filesystem::path& folder, int bytes) : folder_(folder) {
    std::filesystem::create_directories(folder);
    const std::string size = "size=" + std::to_string(bytes);
    mounted_ = mount("tmpfs", folder.c_str(), "tmpfs", 0, size.c_str()) == 0;
  }
  SmallDisk(const SmallDisk&) = delete;
  SmallDisk& operator=(const SmallDisk&) = delete;
  ~SmallDisk() {
    if (mounted_) umount2(folder_.c_str(), MNT_DETACH);
  }
  [[nodiscard]] bool mounted() const { return mounted_; }
  // Fills the disk up to `left` bytes.
  void fill(std::uintmax_t left = 0) const {
    const std::uintmax_t room = std::filesystem::space(folder_).available;
    if (room <= left) return;
    std::ofstream(folder_ / "fill", std::ios::binary) << std::string(room - left, '.');
  }
  void make_read_only() const { mount(nullptr, folder_.c_str(), nullptr, MS_REMOUNT | MS_RDONLY, nullptr); }

 private:
  std::filesystem::path folder_;
  bool mounted_ = false;
};

// Result of `act` in its own process, as a user without rights if this one is root; -1 if it crashed.
template <class Act>
int as_nobody(const Act& act) {
  constexpr uid_t kNobody = 65534;
  const pid_t child = fork();
  if (child == 0) {
    if (geteuid() == 0 && (setgid(kNobody) != 0 || setuid(kNobody) != 0)) _exit(99);
    _exit(act());
  }
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

// How often to kill a process: 300 times in the long tests.
inline int kills(int ordinary) { return by_effort(ordinary / 4, ordinary, 300); }

}  // namespace carom::test
