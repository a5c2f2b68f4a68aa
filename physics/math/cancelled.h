#pragma once

#include <stop_token>

namespace carom {

// Thrown by work that was asked to stop before it finished. It is not an error; there is no result.
struct Cancelled {};

inline void throw_if_cancelled(const std::stop_token& stop) {
  if (stop.stop_requested()) throw Cancelled();
}

}  // namespace carom
