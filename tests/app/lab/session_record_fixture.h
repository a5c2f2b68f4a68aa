#pragma once

#include <gtest/gtest.h>
#include <string>
#include <utility>
#include <vector>

#include "physics/run/simulation.h"
#include "tests/app/lab/session_edit_fixture.h"
#include "tests/support/scenes.h"

namespace carom {

inline Preset gas() {
  std::vector<Body> bodies = test::room(1.0, 0.5);
  for (int i = 0; i < 5; ++i) {
    bodies.push_back(
        test::disc("disc " + std::to_string(i), {-0.8 + 0.4 * i, 0.1 * i}, {1.0 - 0.7 * i, 0.9 - 0.5 * i}));
  }
  Preset preset = test::preset_with(std::move(bodies), 0.95, 0.1);
  preset.scene.forces.gravity = {0.0, -9.81};
  preset.method = {.integrator = IntegratorId::kRk4, .step = 0.005};
  return preset;
}

// A run as it is shown, with its record.
struct Shown {
  std::string document;
  struct Run {
    double time;
    State state;
    Ledger ledger;
    std::size_t edits;
    std::vector<double> impacts;  // s
    std::vector<SeriesPoint<1>> curve;
  };
  std::vector<Run> runs;
};

inline void expect_same(const Shown& a, const Shown& b) {
  EXPECT_EQ(a.document, b.document);
  ASSERT_EQ(a.runs.size(), b.runs.size());
  for (std::size_t i = 0; i < a.runs.size(); ++i) {
    const Shown::Run& x = a.runs[i];
    const Shown::Run& y = b.runs[i];
    EXPECT_EQ(x.time, y.time) << i;
    EXPECT_TRUE(test::same_bytes(x.state, y.state)) << i;
    EXPECT_EQ(x.ledger.initial, y.ledger.initial) << i;
    EXPECT_EQ(x.ledger.turnover(), y.ledger.turnover()) << i;
    EXPECT_EQ(x.edits, y.edits) << i;
    EXPECT_EQ(x.impacts, y.impacts) << i;
    EXPECT_EQ(x.curve, y.curve) << i;
  }
}

// A session whose runs are compared with their whole records.
class SessionRecordTest : public SessionEditTest {
 protected:
  SessionRecordTest() {
    always_ = {kCurve};
    open(gas());
  }
  // Places a body elsewhere in two steps of one drag.
  void drag(const std::string& name, int number) {
    Body body = now(name);
    for (int i = 0; i < 2; ++i) {
      body.position.x() += 0.004;
      session_.edit({Replace<Body>{body}}, "Move " + QString::fromStdString(name), number);
    }
    settle();
    ASSERT_EQ(refused_, "");
    ASSERT_EQ(session_.runs().frame()->time, 0.0);
  }
  // Twice there and back, at the moment before at once.
  void expect_undo_and_redo(const Shown& before, const Shown& after) {
    for (int round = 0; round < 2; ++round) {
      session_.edits().undo();
      EXPECT_EQ(session_.runs().frame()->time, before.runs[0].time) << "shown at once";
      settle();
      expect_same(shown(), before);
      redo();
      expect_same(shown(), after);
    }
  }
  [[nodiscard]] Shown shown() const {
    Shown all{document(), {}};
    const auto& frames = session_.runs().frames();
    for (std::size_t i = 0; i < frames.size(); ++i) {
      const Recorder& recorder = *session_.runs().recorders()[i];
      Shown::Run run{
          frames[i]->time, frames[i]->state, frames[i]->ledger, frames[i]->setup->edits.size(), {}, {}};
      for (std::size_t k = 0; k < recorder.impacts().size(); ++k)
        run.impacts.push_back(recorder.impacts()[k].time);
      recorder.series(kCurve)->read(-1.0, 1e9, run.curve);
      all.runs.push_back(std::move(run));
    }
    EXPECT_FALSE(session_.runs().frame()->playing);
    return all;
  }

  const Curve kCurve{{find_observable("momentum_x"), {}}, {}};
};

}  // namespace carom
