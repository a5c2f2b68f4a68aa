#pragma once

#include <cstddef>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>
#include <unistd.h>

#include "tests/support/wait.h"

// What the other threads of this process do, as the system tells it.
namespace carom::test {

inline std::size_t threads_of_this_process() {
  // A sanitizer starts a thread of its own with the first one: let that be over.
  static const bool first = (std::jthread([] {}).join(), true);
  (void)first;
  std::size_t count = 0;
  for (const auto& entry : std::filesystem::directory_iterator("/proc/self/task")) {
    count += entry.exists() ? 1 : 0;
  }
  return count;
}

// s: processor time of all threads but the calling one.
inline double work_of_other_threads() {
  const auto seconds = [](clockid_t clock) {
    timespec time{};
    clock_gettime(clock, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
  };
  return seconds(CLOCK_PROCESS_CPUTIME_ID) - seconds(CLOCK_THREAD_CPUTIME_ID);
}

// Waits until the other threads have worked on for some time of the processor, however long that takes.
[[nodiscard]] inline bool wait_for_work_of_other_threads() {
  constexpr double kWork = 0.02;  // s
  const double before = work_of_other_threads();
  return wait_until([before] { return work_of_other_threads() - before > kWork; });
}

inline bool other_threads_sleep() {
  for (const auto& entry : std::filesystem::directory_iterator("/proc/self/task")) {
    const std::string thread = entry.path().filename().string();
    if (thread == std::to_string(gettid())) continue;
    std::ifstream file(entry.path() / "stat");
    std::string stat;
    std::getline(file, stat);
    // The state follows the name, which is in brackets.
    const std::size_t name_end = stat.rfind(')');
    if (name_end != std::string::npos && stat.compare(name_end, 3, ") S") != 0) return false;
  }
  return true;
}

// Waits until all other threads wait for something, and not just for a moment.
[[nodiscard]] inline bool wait_until_other_threads_sleep() {
  int looks = 0;
  return wait_until([&looks] {
    looks = other_threads_sleep() ? looks + 1 : 0;
    return looks == 10;
  });
}

}  // namespace carom::test
