#include <gtest/gtest.h>
#include <string>

#include "physics/scene/hand.h"
#include "tests/app/lab/session_record_fixture.h"
#include "tests/support/wait_events.h"

// The hand that pulls a body while the runs play: recorded with them, and taken back as one step.
namespace carom {
namespace {

class SessionHandTest : public SessionRecordTest {
 protected:
  [[nodiscard]] LabRuns& runs() { return session_.runs(); }
  void play_to(double time) {
    session_.starts().set_playing(true);
    ASSERT_TRUE(test::wait_in_event_loop([&] { return runs().newest().front()->time >= time; }));
  }
  void pause() {
    session_.starts().set_playing(false);
    settle();
  }
  // Pulls "disc 1" in a circle for a while, from where it is, and throws it.
  void throw_disc(int pulls = 12) {
    const Frame& frame = *runs().frame();
    Body body;
    for (std::size_t i = 0; i < frame.bodies->size(); ++i) {
      if ((*frame.bodies)[i].name != "disc 1") continue;
      body = (*frame.bodies)[i];
      body.position = frame.state.position(static_cast<int>(i));
      body.angle = frame.state.q(2, static_cast<int>(i));
    }
    Hand hand = hand_on(body, body.position + Vec2(0.02, 0.03));
    for (int i = 0; i < pulls; ++i) {
      hand.place = Vec2(0.4 * std::cos(0.5 * i), 0.4 * std::sin(0.5 * i));
      session_.hand().pull(hand);
      const double from = runs().newest().front()->time;
      ASSERT_TRUE(test::wait_in_event_loop([&] { return runs().newest().front()->time > from + 0.01; }));
    }
    session_.hand().let_go();
  }
  [[nodiscard]] QString undo_text() { return session_.edits().undoText(); }
};

TEST_F(SessionHandTest, IsRecordedAndTakenBackInOneStep) {
  Preset preset = gas();
  preset.compare = {{.integrator = IntegratorId::kVelocityVerlet, .step = 0.004},
                    {.integrator = IntegratorId::kAdaptiveDormandPrince, .step = 0.005}};
  open(preset);
  play_to(0.1);
  throw_disc();
  EXPECT_TRUE(undo_text().startsWith("Throw disc 1 at 0.1")) << undo_text().toStdString();
  const double thrown = runs().newest().front()->time;
  play_to(thrown + 0.2);
  pause();
  const Shown with = shown();
  EXPECT_NE(with.runs[0].ledger.put_in_by_user, 0.0);
  EXPECT_FALSE(session_.modified()) << "it is of the run";
  EXPECT_EQ(session_.document().edits.size(), 0U);

  // Back and forth along the record, past the hand: the same digits.
  runs().go_to(0.5 * (0.1 + thrown));
  ASSERT_TRUE(test::wait_in_event_loop([&] { return runs().in_past() && runs().there(); }));
  ASSERT_TRUE(runs().frame()->hand);
  const State middle = runs().frame()->state;
  const Vec2 force = runs().frame()->hand->force;
  runs().go_to_start();
  ASSERT_TRUE(test::wait_in_event_loop([&] { return runs().there() && runs().frame()->time == 0.0; }));
  EXPECT_FALSE(runs().frame()->hand);
  runs().go_to(0.5 * (0.1 + thrown));
  ASSERT_TRUE(test::wait_in_event_loop([&] { return runs().there() && runs().frame()->time > 0.0; }));
  EXPECT_TRUE(test::same_bytes(runs().frame()->state, middle));
  EXPECT_EQ(runs().frame()->hand->force, force);
  runs().go_to_end();
  settle();
  expect_same(shown(), with);

  for (int round = 0; round < 2; ++round) {
    undo();
    const double end = shown().runs[0].time;
    EXPECT_NE(shown().runs[0].ledger.put_in_by_user, 0.0) << "the run after it is taken back first";
    undo();
    EXPECT_EQ(shown().runs[0].ledger.put_in_by_user, 0.0) << "never thrown";
    EXPECT_EQ(shown().runs[0].time, end);
    redo();
    redo();
    expect_same(shown(), with);
  }
  // The same again from the start, without it.
  undo();
  undo();
  const Shown without = shown();
  open(preset);
  run_to(without.runs[0].time);
  expect_same(shown(), without);
}

TEST_F(SessionHandTest, ARestartClearsItAndUndoBringsItBack) {
  play_to(0.1);
  throw_disc(5);
  pause();
  const Shown with = shown();
  session_.starts().restart();
  settle();
  run_to(0.3);
  EXPECT_EQ(runs().frame()->ledger.put_in_by_user, 0.0);
  EXPECT_TRUE(runs().frame()->setup->edits.empty());
  undo();
  expect_same(shown(), with);
}

TEST_F(SessionHandTest, UndoWhileItPullsEndsIt) {
  play_to(0.1);
  const auto pull = [this](double x) {
    Hand hand = hand_on(gas().scene.bodies[5], gas().scene.bodies[5].position);
    hand.place = {x, 0.0};
    session_.hand().pull(hand);
  };
  pull(0.2);
  ASSERT_TRUE(test::wait_in_event_loop([&] { return runs().newest().front()->hand.has_value(); }));
  session_.edits().undo();
  ASSERT_TRUE(test::wait_in_event_loop([&] { return !runs().newest().front()->hand; }));
  pull(0.3);
  EXPECT_TRUE(undo_text().startsWith("Run")) << "until the button is let go, no other throw begins";
  session_.hand().let_go();
  pause();
  redo();
  play_to(runs().newest().front()->time + 0.05);
  EXPECT_TRUE(test::wait_in_event_loop([&] { return !runs().newest().front()->hand; }))
      << "nobody holds it any more";
  pause();
}

TEST_F(SessionHandTest, ANewStartAtAMomentWithAHandHasNone) {
  play_to(0.1);
  Hand hand = hand_on(gas().scene.bodies[5], gas().scene.bodies[5].position);
  session_.hand().pull(hand);
  ASSERT_TRUE(test::wait_in_event_loop([&] { return runs().newest().front()->hand.has_value(); }));
  const double held = runs().newest().front()->time;
  ASSERT_TRUE(test::wait_in_event_loop([&] { return runs().newest().front()->time > held + 0.05; }));
  session_.hand().let_go();
  play_to(held + 0.2);
  pause();
  runs().go_to(held + 0.02);
  ASSERT_TRUE(test::wait_in_event_loop([&] { return runs().there() && runs().frame()->hand; }));
  Body moved = now("disc 2");
  moved.position.x() += 0.01;
  session_.edit({Replace<Body>{moved}}, "Move");
  settle();
  EXPECT_FALSE(runs().frame()->hand);
  EXPECT_FALSE(session_.document().scene.forces.hand);
  EXPECT_TRUE(session_.history().document().start.from.has_value());
}

TEST_F(SessionHandTest, ExactFlightBecomesRk4InTheSameStep) {
  Preset preset = gas();
  preset.method.integrator = IntegratorId::kExactFlight;
  open(preset);
  play_to(0.1);
  throw_disc(4);
  EXPECT_EQ(refused_, "");
  EXPECT_EQ(session_.document().method.integrator, IntegratorId::kRk4);
  pause();
  EXPECT_EQ(runs().frame()->method.integrator, IntegratorId::kRk4);
  EXPECT_NE(runs().frame()->ledger.put_in_by_user, 0.0);
  undo();
  EXPECT_EQ(session_.document().method.integrator, IntegratorId::kExactFlight);
  EXPECT_EQ(runs().frame()->method.integrator, IntegratorId::kExactFlight);
  EXPECT_EQ(runs().frame()->ledger.put_in_by_user, 0.0);
}

TEST_F(SessionHandTest, TheRecordAllowsNone) {
  play_to(0.3);
  pause();
  runs().go_to(0.1);
  ASSERT_TRUE(test::wait_in_event_loop([&] { return runs().there(); }));
  session_.starts().set_playing(true);
  session_.hand().pull(hand_on(gas().scene.bodies[5], gas().scene.bodies[5].position));
  EXPECT_EQ(refused_, "The record is played: G goes on from here.");
  session_.hand().let_go();
  EXPECT_TRUE(undo_text().startsWith("Run"));
}

}  // namespace
}  // namespace carom
