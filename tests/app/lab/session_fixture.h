#pragma once

#include <algorithm>
#include <gtest/gtest.h>
#include <vector>

#include "app/lab/session.h"
#include "physics/observe/quantity.h"
#include "tests/support/lags.h"
#include "tests/support/wait_events.h"

namespace carom {

// A session without a window.
class SessionFixture : public testing::Test {
 protected:
  // Waits until all that was asked for before is done, and all runs have reached the shown time. A curve that
  // is asked for now comes after all that. It is another one than at the last time, and forgotten before.
  void settle() {
    const Curve curve{{find_observable(settled_++ % 2 == 0 ? "kinetic_energy" : "total_energy"), {}}, {}};
    session_.runs().record(always_);
    std::vector<Curve> curves = always_;
    curves.push_back(curve);
    session_.runs().record(curves);
    ASSERT_TRUE(test::wait_in_event_loop([&] { return settled(curve); }));
  }
  [[nodiscard]] const Method& method(std::size_t run) const {
    return run == 0 ? session_.document().method : session_.document().compare[run - 1];
  }
  void run_to(double time) {
    session_.runs().run_until(time);
    settle();
  }
  void undo() {
    session_.edits().undo();
    settle();
  }
  void redo() {
    session_.edits().redo();
    settle();
  }

  Session session_;
  std::vector<Curve> always_;  // recorded all the time

 private:
  [[nodiscard]] bool settled(const Curve& curve) {
    const LabRuns& runs = session_.runs();
    if (runs.frames().size() != 1 + session_.document().compare.size() || runs.replayed()) return false;
    for (std::size_t i = 0; i < runs.frames().size(); ++i) {
      const Frame& frame = *runs.frames()[i];
      if (frame.method != method(i) || test::lags(frame, *runs.frame())) return false;
      if (runs.recorders()[i]->series(curve) == nullptr || frame.rows_known_until < frame.time ||
          frame.bodies->size() > session_.history().bodies().size())
        return false;
    }
    return !runs.frame()->playing && runs.frame()->scene != nullptr;
  }

  int settled_ = 0;
};

}  // namespace carom
