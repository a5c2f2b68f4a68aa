#include <gtest/gtest.h>
#include <memory>
#include <string>
#include <vector>

#include "physics/worker/run_group.h"
#include "tests/app/lab/session_record_fixture.h"

// Which run is the one before, and for how long its record is kept.
namespace carom {
namespace {

class SessionRunBeforeTest : public SessionRecordTest {
 protected:
  [[nodiscard]] const std::optional<RunBefore>& before() const { return session_.runs().before(); }
  [[nodiscard]] std::shared_ptr<Recorder> recorder() const { return session_.runs().recorders().front(); }
};

TEST_F(SessionRunBeforeTest, ThereIsNoneUntilARunIsLeft) {
  EXPECT_FALSE(before());
  Body body = now("disc 2");
  body.position.x() += 0.004;
  edit(Replace<Body>{body});
  EXPECT_FALSE(before()) << "nothing has run";
  run_to(0.5);
  EXPECT_FALSE(before());
  session_.starts().restart();
  settle();
  ASSERT_TRUE(before());
  open(gas());
  EXPECT_FALSE(before()) << "of another document";
}

TEST_F(SessionRunBeforeTest, ItIsTheRunThatTheLastNewStartLeft) {
  run_to(0.5);
  const auto first = recorder();
  session_.starts().restart();
  settle();
  ASSERT_TRUE(before());
  EXPECT_EQ(before()->recorder, first);
  EXPECT_EQ(before()->from, 0.0);
  EXPECT_EQ(first->time(), session_.runs().before()->recorder->time());
  // An edit at the start leaves no run.
  Body body = now("disc 2");
  body.position.x() += 0.004;
  edit(Replace<Body>{body});
  EXPECT_EQ(before()->recorder, first);
  run_to(0.3);
  const auto second = recorder();
  drag("disc 2", 1);
  EXPECT_EQ(before()->recorder, second);
  // Runs of the new start are compared with it, until that is edited.
  for (int round = 0; round < 2; ++round) {
    run_to(0.2);
    session_.starts().restart();
    settle();
    EXPECT_EQ(before()->recorder, second);
  }
  undo();
  undo();
  redo();
  redo();
  EXPECT_EQ(before()->recorder, second) << "a restart that is made again leaves it too";
  run_to(0.2);
  const auto third = recorder();
  Body heavier = now("disc 2");
  heavier.mass = 2.0 * heavier.mass.value_or(1.0);
  edit(Replace<Body>{heavier}, "Mass");
  ASSERT_EQ(refused_, "");
  session_.starts().restart();
  settle();
  EXPECT_EQ(before()->recorder, third) << "the start has another mass now";
}

TEST_F(SessionRunBeforeTest, BesideNoOtherStartItIsTheRunThatTheLastRestartLeft) {
  for (const double time : {0.5, 0.3}) {
    run_to(time);
    const auto run = recorder();
    session_.starts().restart();
    settle();
    EXPECT_EQ(before()->recorder, run);
  }
}

TEST_F(SessionRunBeforeTest, UndoAndRedoTellItAnew) {
  run_to(0.5);
  session_.starts().restart();
  settle();
  run_to(0.3);
  const auto first = before()->recorder;
  drag("disc 2", 1);
  const double left = before()->recorder->time();
  EXPECT_NEAR(left, 0.3, 0.006);
  for (int round = 0; round < 2; ++round) {
    undo();
    ASSERT_TRUE(before());
    EXPECT_EQ(before()->recorder, first);
    redo();
    ASSERT_TRUE(before());
    EXPECT_EQ(before()->recorder->time(), left);
  }
  undo();
  undo();
  EXPECT_FALSE(before()) << "the first run has none before it";
}

TEST_F(SessionRunBeforeTest, TheRestThatIsCutOffIsOneFromThereOn) {
  run_to(0.8);
  const auto whole = recorder();
  session_.runs().go_to(0.4);
  ASSERT_TRUE(test::wait_in_event_loop([&] { return session_.runs().there(); }));
  const double shown = session_.runs().shown_time();
  session_.go_on_from_here();
  settle();
  ASSERT_TRUE(before());
  EXPECT_EQ(before()->recorder, whole);
  EXPECT_EQ(before()->from, shown);
  EXPECT_NE(recorder(), whole) << "the run goes on with a record of its own";
  run_to(0.6);
  EXPECT_NEAR(whole->time(), 0.8, 0.006);
  undo();
  EXPECT_FALSE(before());
}

// The records of all runs that were left would be without bound.
TEST_F(SessionRunBeforeTest, NoMoreRecordsAreKeptThanOfWholeRuns) {
  std::vector<std::weak_ptr<Recorder>> records;
  for (int i = 0; i < RunGroup::kMostKept + 4; ++i) {
    run_to(0.1);
    records.push_back(recorder());
    session_.starts().restart();
    settle();
  }
  const auto kept =
      std::count_if(records.begin(), records.end(), [](const auto& each) { return !each.expired(); });
  EXPECT_LE(kept, RunGroup::kMostKept + 1);
  EXPECT_FALSE(records.back().expired());
  while (session_.edits().canUndo()) undo();
  EXPECT_FALSE(before());
}

}  // namespace
}  // namespace carom
