#include <gtest/gtest.h>
#include <string>

#include "tests/app/lab/session_record_fixture.h"
#include "tests/support/wait_events.h"

// A run as a step of undo: entered when it begins to play, taken back to where it stood then.
namespace carom {
namespace {

class SessionRunStepsTest : public SessionRecordTest {
 protected:
  SessionRunStepsTest() { session_.runs().set_speed(4.0); }
  // Plays on to this time (s), and pauses there or a little later.
  void play_to(double time) {
    session_.starts().set_playing(true);
    ASSERT_TRUE(test::wait_in_event_loop([&] { return session_.runs().newest().front()->time >= time; }));
    session_.starts().set_playing(false);
    settle();
  }
  void give_mass(const std::string& name, double mass) {
    Body body = now(name);
    body.mass = mass;
    edit(Replace<Body>{body}, "Mass");
  }
  // Each step of undo leads to the state before, and each step of redo to the next, twice.
  void expect_back_and_forth(const std::vector<Shown>& states) {
    for (int round = 0; round < 2; ++round) {
      for (std::size_t i = states.size() - 1; i-- > 0;) {
        SCOPED_TRACE(i);
        undo();
        expect_same(shown(), states[i]);
      }
      for (std::size_t i = 1; i < states.size(); ++i) {
        SCOPED_TRACE(i);
        redo();
        expect_same(shown(), states[i]);
      }
    }
  }
  [[nodiscard]] QString undo_text() { return session_.edits().undoText(); }
};

TEST_F(SessionRunStepsTest, ARunIsTakenBackToWhereItBeganAndMadeAgainWhole) {
  const Shown before = shown();
  play_to(0.2);
  EXPECT_EQ(undo_text(), "Run from 0.000 s");
  EXPECT_FALSE(session_.modified());
  play_to(0.5);
  EXPECT_EQ(session_.edits().count(), 1) << "the same run";
  const Shown after = shown();
  ASSERT_GT(after.runs[0].impacts.size(), 2U);
  for (int round = 0; round < 3; ++round) {
    SCOPED_TRACE(round);
    session_.edits().undo();
    EXPECT_EQ(session_.runs().frame()->time, 0.0) << "shown at once";
    settle();
    expect_same(shown(), before);
    session_.edits().redo();
    EXPECT_EQ(session_.runs().frame()->time, after.runs[0].time) << "shown at once";
    settle();
    expect_same(shown(), after);
  }
}

TEST_F(SessionRunStepsTest, AnEditInARunIsTakenOutBeforeTheRun) {
  const Shown first = shown();
  play_to(0.3);
  const Shown at_edit = shown();
  give_mass("disc 1", 3.0);
  const Shown edited = shown();
  play_to(0.6);
  ASSERT_EQ(session_.edits().count(), 3);
  EXPECT_EQ(undo_text(), QString("Run from %1 s").arg(edited.runs[0].time, 0, 'f', 3));
  const Shown last = shown();
  for (int round = 0; round < 2; ++round) {
    SCOPED_TRACE(round);
    undo();
    expect_same(shown(), edited);
    undo();
    expect_same(shown(), at_edit);
    undo();
    expect_same(shown(), first);
    for (int i = 0; i < 3; ++i) redo();
    expect_same(shown(), last);
  }
}

// The second section of the design's list: restart, run, mass and run are taken back one by one.
TEST_F(SessionRunStepsTest, WithANewStartARestartAndComparedMethods) {
  Preset preset = gas();
  preset.compare = {{.integrator = IntegratorId::kExplicitEuler, .step = 0.003}};
  open(preset);
  std::vector<Shown> states = {shown()};
  play_to(0.3);
  states.push_back(shown());
  drag("disc 2", 1);
  states.push_back(shown());
  play_to(0.2);
  states.push_back(shown());
  session_.starts().restart();
  settle();
  states.push_back(shown());
  play_to(0.1);
  states.push_back(shown());
  ASSERT_EQ(session_.edits().count(), 5);
  expect_back_and_forth(states);
}

// Single steps are a run too: else an edit that is made again would find another run than it was made in.
TEST_F(SessionRunStepsTest, SingleStepsAreARun) {
  const auto steps = [this](int count) {
    for (int i = 0; i < count; ++i) session_.starts().step_by(1);
    settle();
  };
  std::vector<Shown> states = {shown()};
  const auto note = [&] { states.push_back(shown()); };
  steps(40);
  EXPECT_EQ(undo_text(), "Run from 0.000 s");
  note();
  drag("disc 2", 1);
  note();
  steps(30);
  note();
  give_mass("disc 1", 3.0);
  note();
  steps(20);
  note();
  ASSERT_EQ(session_.edits().count(), 5);
  expect_back_and_forth(states);
}

TEST_F(SessionRunStepsTest, AllIsTakenBackAndMadeAgainWithoutWaiting) {
  const Shown first = shown();
  play_to(0.2);
  give_mass("disc 1", 3.0);
  play_to(0.4);
  session_.starts().restart();
  settle();
  play_to(0.1);
  const Shown last = shown();
  const int count = session_.edits().count();
  for (int round = 0; round < 3; ++round) {
    session_.edits().setIndex(0);
    session_.edits().setIndex(count);
  }
  settle();
  expect_same(shown(), last);
  session_.edits().setIndex(0);
  settle();
  expect_same(shown(), first);
}

TEST_F(SessionRunStepsTest, ARunThatPlaysIsTakenBackAndStops) {
  session_.starts().set_playing(true);
  ASSERT_TRUE(test::wait_in_event_loop([&] { return session_.runs().frame()->time > 0.1; }));
  session_.edits().undo();
  settle();
  EXPECT_EQ(session_.runs().frame()->time, 0.0);
  redo();
  EXPECT_GT(session_.runs().frame()->time, 0.1);
  const Shown back = shown();
  open(gas());
  run_to(back.runs[0].time);
  expect_same(shown(), back);
}

TEST_F(SessionRunStepsTest, PlayingAgainFromTheEndIsARestartAndARun) {
  Preset preset = gas();
  preset.duration = 0.3;
  open(preset);
  play_to(0.3);
  const Shown ended = shown();
  play_to(0.1);
  EXPECT_EQ(session_.edits().count(), 3);
  undo();
  EXPECT_EQ(session_.runs().frame()->time, 0.0);
  EXPECT_EQ(undo_text(), "Restart");
  undo();
  expect_same(shown(), ended);
}

// It repeats what is recorded first, and is taken back to the moment that was shown.
TEST_F(SessionRunStepsTest, ARunFromAMomentOfTheRecord) {
  play_to(0.5);
  const Shown ended = shown();
  Plot plot;
  plot.y = {{"speed", {"disc 1"}}};
  session_.change_plots({plot});
  session_.runs().go_to(0.2);
  ASSERT_TRUE(test::wait_in_event_loop([&] { return session_.runs().there(); }));
  const double moment = session_.runs().shown_time();
  play_to(0.7);
  EXPECT_TRUE(undo_text().startsWith("Run from 0.5")) << undo_text().toStdString();
  session_.edits().undo();
  ASSERT_TRUE(test::wait_in_event_loop([&] { return session_.runs().in_past() && session_.runs().there(); }));
  EXPECT_EQ(session_.runs().shown_time(), moment);
  session_.runs().go_to_end();
  settle();
  Shown back = shown();
  back.document = ended.document;
  expect_same(back, ended);
}

TEST_F(SessionRunStepsTest, ARunThatBeganBeforeItsFirstFrameIsTakenBack) {
  const Preset preset = gas();
  session_.open(preset, preset.plots, {}, {}, {});
  ASSERT_TRUE(session_.runs().newest().empty());
  session_.starts().set_playing(true);
  session_.edits().undo();
  settle();
  EXPECT_EQ(session_.runs().frame()->time, 0.0);
  EXPECT_EQ(session_.edits().index(), 0);
}

}  // namespace
}  // namespace carom
