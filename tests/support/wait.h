#pragma once

#include <chrono>
#include <thread>

namespace carom::test {

// The limit is for failing tests only and measures nothing: it is far more than a slow machine needs.
inline constexpr std::chrono::minutes kLongestWait{5};

// Polls `fulfilled` until it is true; false if it is not within kLongestWait.
template <class Condition>
[[nodiscard]] bool wait_until(const Condition& fulfilled) {
  const auto end = std::chrono::steady_clock::now() + kLongestWait;
  do {
    if (fulfilled()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  } while (std::chrono::steady_clock::now() < end);
  return false;
}

}  // namespace carom::test
