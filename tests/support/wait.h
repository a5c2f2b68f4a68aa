#pragma once

#include <chrono>
#include <thread>

namespace carom::test {

// Polls `fulfilled` until it is true or a minute has passed; that limit is for failing tests, not a measure.
template <class Condition>
[[nodiscard]] bool wait_until(const Condition& fulfilled) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(60);
  while (std::chrono::steady_clock::now() < end) {
    if (fulfilled()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return false;
}

}  // namespace carom::test
