#pragma once

#include <cstdlib>
#include <string_view>

namespace carom::test {

// How much to try: CAROM_EFFORT in the environment is `quick` for tests/quick, `long` for tests/long, else
// ordinary.
template <class T>
[[nodiscard]] T by_effort(T quick, T ordinary, T most) {
  const char* const effort = std::getenv("CAROM_EFFORT");
  if (effort == nullptr) return ordinary;
  return std::string_view(effort) == "long" ? most : std::string_view(effort) == "quick" ? quick : ordinary;
}

[[nodiscard]] inline bool long_tests() { return by_effort(false, false, true); }

}  // namespace carom::test
