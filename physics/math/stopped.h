#pragma once

#include <stop_token>

namespace carom {

// Thrown by work that was asked to stop before it was done. It is no error, and nothing was computed.
struct Stopped {};

inline void throw_if_stopped(const std::stop_token& stop) {
  if (stop.stop_requested()) throw Stopped();
}

}  // namespace carom
