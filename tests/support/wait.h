#pragma once

#include <chrono>
#include <thread>

namespace carom::test {

// Asks again and again until `fulfilled` or a minute has passed, which is a failure of the test, not its
// measure.
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
