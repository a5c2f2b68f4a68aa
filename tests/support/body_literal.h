#pragma once

#include "physics/model/index.h"

namespace carom::test {

// 2_b is the third body.
inline namespace literals {
[[nodiscard]] constexpr BodyIndex operator""_b(unsigned long long column) {
  return BodyIndex{static_cast<int>(column)};
}
}  // namespace literals

}  // namespace carom::test
