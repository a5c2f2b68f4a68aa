#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "physics/worker/run_group.h"
#include "tests/app/lab/session_record_fixture.h"
#include "tests/support/wait_events.h"

// Undo of an edit that made a moment of a run the new start returns to that moment of that run, whole.
namespace carom {
namespace {

using SessionNewStartTest = SessionRecordTest;

TEST_F(SessionNewStartTest, UndoReturnsToTheMomentOfTheRun) {
  run_to(0.8);
  const Shown before = shown();
  ASSERT_GT(before.runs[0].impacts.size(), 3U);
  ASSERT_EQ(before.runs[0].curve.back().at, before.runs[0].time);
  drag("disc 2", 1);
  const Shown after = shown();
  run_to(0.3);
  expect_undo_and_redo(before, after);
  // The run that was returned to goes on as if nothing had been.
  undo();
  run_to(1.5);
  const Shown on = shown();
  open(gas());
  run_to(1.5);
  expect_same(shown(), on);
}

// More than are kept whole: the first ones are replayed.
TEST_F(SessionNewStartTest, SeveralAreUndoneOneByOneEachToItsOwnMoment) {
  constexpr std::size_t kCount = std::size_t{RunGroup::kMostKept} + 2;
  std::vector<Shown> before;
  std::vector<Shown> after;
  for (std::size_t i = 0; i < kCount; ++i) {
    run_to(0.3 + 0.1 * static_cast<double>(i));
    before.push_back(shown());
    drag("disc " + std::to_string(i), static_cast<int>(i) + 1);
    after.push_back(shown());
  }
  ASSERT_EQ(session_.edits().count(), static_cast<int>(kCount));
  for (int round = 0; round < 2; ++round) {
    for (std::size_t i = kCount; i-- > 0;) {
      SCOPED_TRACE(i);
      session_.edits().undo();
      EXPECT_EQ(session_.runs().frame()->time, before[i].runs[0].time) << "shown at once";
      settle();
      expect_same(shown(), before[i]);
    }
    for (std::size_t i = 0; i < kCount; ++i) {
      SCOPED_TRACE(i);
      redo();
      expect_same(shown(), after[i]);
    }
  }
}

TEST_F(SessionNewStartTest, SeveralAreUndoneWithoutWaiting) {
  constexpr std::size_t kCount = std::size_t{RunGroup::kMostKept} + 2;
  std::vector<Shown> before;
  for (std::size_t i = 0; i < kCount; ++i) {
    run_to(0.3 + 0.1 * static_cast<double>(i));
    before.push_back(shown());
    drag("disc " + std::to_string(i), static_cast<int>(i) + 1);
  }
  for (int round = 0; round < 3; ++round) {
    for (std::size_t i = 0; i < kCount; ++i) session_.edits().undo();
    if (round == 0) {
      settle();
      expect_same(shown(), before.front());
    }
    for (std::size_t i = 0; i < kCount; ++i) session_.edits().redo();
  }
  for (std::size_t i = kCount; i-- > 0;) {
    SCOPED_TRACE(i);
    undo();
    expect_same(shown(), before[i]);
  }
}

// An edit in the run before it, which holds in the start too, is taken back and made again as ever.
TEST_F(SessionNewStartTest, WithComparedMethodsAndAnEditInTheRun) {
  Preset preset = gas();
  preset.compare = {{.integrator = IntegratorId::kExplicitEuler, .step = 0.003},
                    {.integrator = IntegratorId::kVelocityVerlet, .step = 0.004}};
  open(preset);
  run_to(0.8);
  const Shown never = shown();
  open(preset);
  run_to(0.4);
  Body heavy = now("disc 1");
  heavy.mass = 3.0;
  edit(Replace<Body>{heavy}, "Mass");
  run_to(0.8);
  const Shown before = shown();
  ASSERT_EQ(before.runs.size(), 3U);
  ASSERT_EQ(before.runs[2].edits, 1U);
  drag("disc 2", 1);
  const Shown after = shown();
  run_to(0.2);
  for (int round = 0; round < 2; ++round) {
    undo();
    expect_same(shown(), before);
    undo();
    expect_same(shown(), never);
    redo();
    expect_same(shown(), before);
    redo();
    expect_same(shown(), after);
  }
}

// The body goes with its plots; both come back.
TEST_F(SessionNewStartTest, TheRecordOfADeletedBodyComesBack) {
  Preset preset = gas();
  Plot plot;
  plot.y = {{"speed", {"disc 4"}}};
  preset.plots = {plot};
  open(preset);
  run_to(0.5);
  const Shown before = shown();
  edit(Remove<Body>{now("disc 4").id}, "Delete");
  ASSERT_TRUE(session_.document().plots.empty());
  undo();
  expect_same(shown(), before);
  redo();
  EXPECT_EQ(session_.history().bodies().size(), preset.scene.bodies.size() - 1);
  session_.runs().set_playing(true);
  ASSERT_TRUE(test::wait_in_event_loop([&] { return session_.runs().frame()->time > 0.05; }));
  undo();
  expect_same(shown(), before);
}

TEST_F(SessionNewStartTest, ACancelledDragLeavesTheRunAsItWas) {
  run_to(0.5);
  const Shown before = shown();
  drag("disc 3", 4);
  session_.cancel(4);
  settle();
  expect_same(shown(), before);
  EXPECT_FALSE(session_.edits().canUndo());
  EXPECT_FALSE(session_.edits().canRedo());
}

// A drag whose first change is about what the body is, and the next about where.
TEST_F(SessionNewStartTest, ADragThatEndsInANewStartIsOneStep) {
  run_to(0.5);
  const Shown before = shown();
  Body body = now("disc 3");
  body.mass = 2.0;
  session_.edit({Replace<Body>{body}}, "Size", 4);
  body.position.x() += 0.004;
  session_.edit({Replace<Body>{body}}, "Size", 4);
  settle();
  ASSERT_EQ(session_.edits().count(), 1);
  const Shown after = shown();
  ASSERT_EQ(after.runs[0].time, 0.0);
  for (int round = 0; round < 2; ++round) {
    undo();
    expect_same(shown(), before);
    redo();
    expect_same(shown(), after);
  }
}

}  // namespace
}  // namespace carom
