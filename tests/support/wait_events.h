#pragma once

#include <QTest>

#include "tests/support/wait.h"

namespace carom::test {

// Handles events until `fulfilled` is true; false if it is not within kLongestWait.
template <class Condition>
[[nodiscard]] bool wait_in_event_loop(const Condition& fulfilled) {
  return QTest::qWaitFor(fulfilled, static_cast<int>(std::chrono::milliseconds(kLongestWait).count()));
}

}  // namespace carom::test
