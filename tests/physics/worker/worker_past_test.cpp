#include <algorithm>
#include <gtest/gtest.h>
#include <random>

#include "physics/preset/preset.h"
#include "physics/worker/worker.h"
#include "tests/support/gas_in_a_room.h"
#include "tests/support/lags.h"
#include "tests/support/scenes.h"
#include "tests/support/wait.h"

// Moments of a worker's past are shown with the bytes that they had the first time, and its runs stay as they
// are.
namespace carom {
namespace {

using test::disc;

// Under three methods of different steps, one of them with a reference to follow.
Preset gas() {
  Preset s = test::gas_in_a_room(0.6, 0.3);
  s.method.step = 0.004;
  s.compare = {Method{.integrator = IntegratorId::kExplicitEuler, .step = 0.003},
               Method{.integrator = IntegratorId::kRk4,
                      .impacts = ImpactsId::kStepEnd,
                      .contacts = ContactsId::kLasting,
                      .step = 0.01}};
  return s;
}
const Body kBody = disc("new", {0.0, -0.3}, {1.0, 1.0}, 0.05);
const Method kOther{.integrator = IntegratorId::kVelocityVerlet, .step = 0.002};

// That pulls kBody to this place (m).
Hand hand_at(const Vec2& place) {
  return {.body = kBody.name, .place = place, .stiffness = 150.0, .damping = 15.0};
}

using Frames = std::vector<std::shared_ptr<const Frame>>;

bool same_moment(const Frame& a, const Frame& b) {
  const auto same_contact = [](const ContactForce& x, const ContactForce& y) {
    return x.normal_force == y.normal_force && x.tangential_force == y.tangential_force;
  };
  const auto same_hand = [](const HandState& x, const HandState& y) {
    return x.grip == y.grip && x.place == y.place && x.force == y.force;
  };
  return a.run == b.run && a.steps == b.steps && a.time == b.time && a.impact_count == b.impact_count &&
         a.evaluations == b.evaluations && a.method == b.method && test::same_bytes(a.state, b.state) &&
         a.totals.kinetic() == b.totals.kinetic() && a.bodies->size() == b.bodies->size() &&
         std::equal(a.contacts.begin(), a.contacts.end(), b.contacts.begin(), b.contacts.end(), same_contact) &&
         a.ledger.lost_to_restitution == b.ledger.lost_to_restitution &&
         a.hand.has_value() == b.hand.has_value() && (!a.hand || same_hand(*a.hand, *b.hand)) &&
         a.error.has_value() == b.error.has_value() && (!a.error || a.error->position == b.error->position);
}

class WorkerPast : public testing::Test {
 protected:
  [[nodiscard]] Frames newest_at(std::int64_t steps) {
    Frames frames;
    const bool there = test::wait_until([&] {
      const Frames news = worker_.take_frames();
      if (!news.empty()) frames = news;
      if (frames.empty() || frames.front()->steps != steps || frames.front()->playing) return false;
      return std::all_of(frames.begin(), frames.end(),
                         [&](const auto& frame) { return !test::lags(*frame, *frames.front()); });
    });
    EXPECT_TRUE(there);
    return frames;
  }
  void record_steps(int count) {
    for (int i = 0; i < count; ++i) {
      worker_.step_once();
      recorded_.push_back(newest_at(recorded_.back().front()->steps + 1));
    }
  }
  // Three tenths of a second, with a body that comes in, a hand that pulls it here, then there, a method that
  // changes meanwhile, and the hand that lets it go.
  void record_run() {
    worker_.set_reference(ReferenceId::kExactFlight);
    recorded_ = {start_beside_reference()};
    record_steps(30);
    worker_.edit_scene({Add<Body>{kBody}});
    recorded_.back() = newest_at_edit(1);
    record_steps(10);
    worker_.edit_scene({SetHand{hand_at({0.1, 0.2})}});
    recorded_.back() = newest_at_edit(2);
    record_steps(5);
    worker_.edit_scene({SetHand{hand_at({-0.2, 0.1})}});
    recorded_.back() = newest_at_edit(3);
    record_steps(10);
    worker_.set_method(kOther);
    recorded_.back() = newest_at_edit(4);
    record_steps(20);
    EXPECT_TRUE(recorded_.back().front()->hand.has_value());
    worker_.edit_scene({SetHand{}});
    recorded_.back() = newest_at_edit(5);
    EXPECT_FALSE(recorded_.back().front()->hand.has_value());
    record_steps(20);
  }
  [[nodiscard]] Frames start_beside_reference() {
    Frames frames;
    EXPECT_TRUE(test::wait_until([&] {
      const Frames news = worker_.take_frames();
      if (!news.empty()) frames = news;
      return !frames.empty() && std::all_of(frames.begin(), frames.end(),
                                            [](const auto& frame) { return frame->error.has_value(); });
    }));
    return frames;
  }
  [[nodiscard]] Frames newest_at_edit(std::size_t edits) {
    Frames frames;
    EXPECT_TRUE(test::wait_until([&] {
      const Frames news = worker_.take_frames();
      if (!news.empty()) frames = news;
      return !frames.empty() && frames.front()->setup->edits.size() == edits;
    }));
    return frames;
  }
  [[nodiscard]] Frames shown(const PastMoment& moment) {
    const std::uint64_t number = worker_.show(moment);
    Worker::Shown shown;
    EXPECT_TRUE(test::wait_until([&] {
      shown = worker_.take_shown();
      return shown.there && shown.number == number;
    }));
    return shown.frames;
  }
  static void expect_same(const Frames& a, const Frames& b) {
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i)
      EXPECT_TRUE(same_moment(*a[i], *b[i])) << "run " << i << " at " << b[i]->time << " s: " << a[i]->time;
  }

  Worker worker_{gas()};
  std::vector<Frames> recorded_;  // the start, and after each step of the first run
};

TEST_F(WorkerPast, EachMomentHasTheBytesThatItHad) {
  record_run();
  std::mt19937 random(7);
  for (int i = 0; i < 40; ++i) {
    const Frames& was = recorded_[random() % recorded_.size()];
    const Frames now = shown({was.front()->time});
    expect_same(now, was);
    ASSERT_NE(now.front()->scene, nullptr);
    EXPECT_EQ(now.front()->scene->bodies.size(), was.front()->bodies->size());
  }
  // Between two steps: the one before.
  for (const std::size_t step : {9, 8, 60, 59})
    expect_same(shown({recorded_[step].front()->time + 0.0019}), recorded_[step]);
}

TEST_F(WorkerPast, StepByStepToTheStartAndBack) {
  record_run();
  const double newest = recorded_.back().front()->time;
  for (std::size_t i = 1; i < recorded_.size(); ++i)
    expect_same(shown({newest, -static_cast<std::int64_t>(i)}), recorded_[recorded_.size() - 1 - i]);
  for (std::size_t i = 1; i < recorded_.size(); ++i)
    expect_same(shown({recorded_[i - 1].front()->time, 1}), recorded_[i]);
  expect_same(shown({0.0, -3}), recorded_.front());
  expect_same(shown({newest + 1.0}), recorded_.back());
  expect_same(shown({newest, 5}), recorded_.back());
}

TEST_F(WorkerPast, TheRunsStayWhereTheyAre) {
  record_run();
  (void)shown({0.05});
  EXPECT_TRUE(worker_.take_frames().empty()) << "nothing about them is new";
  worker_.step_once();
  const Frames with = newest_at(recorded_.back().front()->steps + 1);
  worker_.load(gas());
  recorded_.clear();
  record_run();
  worker_.step_once();
  const Frames without = newest_at(recorded_.back().front()->steps + 1);
  for (std::size_t i = 0; i < with.size(); ++i)
    EXPECT_TRUE(test::same_bytes(with[i]->state, without[i]->state)) << i;
}

TEST_F(WorkerPast, OnlyTheLastMomentAskedForMatters) {
  record_run();
  for (int i = 0; i < 200; ++i) (void)worker_.show({0.001 * i});
  expect_same(shown({recorded_[40].front()->time}), recorded_[40]);
  EXPECT_TRUE(worker_.take_shown().frames.empty());
}

TEST_F(WorkerPast, ALoadForgetsIt) {
  record_run();
  (void)worker_.show({0.1});
  worker_.load(gas());
  EXPECT_TRUE(worker_.take_shown().frames.empty());
  (void)newest_at(0);
  EXPECT_TRUE(worker_.take_shown().frames.empty());
}

// What was done later is not done again; one return brings all of it back.
TEST_F(WorkerPast, ACutGoesOnFromAnEarlierMoment) {
  record_run();
  const Frames& at = recorded_[20];
  const Worker::EditId edit = worker_.keep_runs();
  worker_.cut(edit, at.front()->time, {});
  expect_same(newest_at(20), at);
  worker_.run_until(recorded_[29].front()->time);
  expect_same(newest_at(29), recorded_[29]);
  worker_.run_until(0.2);
  const Frames on = newest_at(50);
  EXPECT_EQ(on.front()->bodies->size(), gas().scene.bodies.size()) << "the later body does not come in";
  EXPECT_TRUE(on.front()->setup->edits.empty());
  worker_.return_to(edit, {}, ReferenceId::kExactFlight);
  expect_same(newest_at(recorded_.back().front()->steps), recorded_.back());
}

TEST_F(WorkerPast, ACutKeepsTheEditsOfThePreset) {
  record_run();
  const Worker::EditId edit = worker_.keep_runs();
  worker_.cut(edit, recorded_[20].front()->time, {{0.15, 0, SceneEdits{Add<Body>{kBody}}}});
  worker_.run_until(0.2);
  // 50 steps, of which the edit divides one.
  EXPECT_EQ(newest_at(51).front()->bodies->size(), gas().scene.bodies.size() + 1);
}

// Within their steps too: there all runs go on, and there an edit that follows is made.
TEST_F(WorkerPast, ACutWithinAStepGoesOnFromThere) {
  record_run();
  const double time = recorded_[20].front()->time + 0.0017;
  for (const bool edited : {false, true}) {
    SCOPED_TRACE(edited);
    const std::size_t edits = edited ? 2 : 1;  // the first one divides the step
    const Worker::EditId edit = worker_.keep_runs();
    worker_.cut(edit, time, {});
    if (edited) worker_.edit_scene({Add<Body>{kBody}});
    Frames there;
    ASSERT_TRUE(test::wait_until([&] {
      const auto news = worker_.take_frames();
      if (!news.empty()) there = news;
      return !there.empty() && !there.front()->replay_until && there.front()->setup->edits.size() == edits;
    }));
    for (const auto& frame : there) {
      EXPECT_EQ(frame->time, time);
      EXPECT_EQ(frame->steps, frame->run == there.front()->run ? 21 : frame->steps);
      for (const RunEdit& each : frame->setup->edits) EXPECT_EQ(each.time, time);
      EXPECT_EQ(frame->bodies->size(), gas().scene.bodies.size() + edits - 1);
    }
    const Frames cut = shown({time - 0.001});
    for (std::size_t i = 0; i < cut.size(); ++i) {
      Simulation again(*there[i]->setup);
      again.advance_to(time);
      EXPECT_TRUE(test::same_bytes(again.state(), there[i]->state)) << i;
      EXPECT_LT(cut[i]->time, time) << i;
      EXPECT_EQ(cut[i]->bodies->size(), gas().scene.bodies.size()) << i;
    }
    worker_.run_until(recorded_[21].front()->time);
    EXPECT_NEAR(newest_at(22).front()->time, recorded_[21].front()->time, 1e-15)
        << "the steps go on as they were";
    worker_.return_to(edit, {}, ReferenceId::kExactFlight);
    expect_same(newest_at(recorded_.back().front()->steps), recorded_.back());
  }
}

// Rounding says in which of two steps it is that have their end in common: its moment shows it.
TEST_F(WorkerPast, AnImpactAtTheEndOfAStepIsShown) {
  int in_the_next = 0;
  for (const double further : {0.0, 0.01, 0.02, 0.03, 0.04, 0.05, 0.06, 0.07}) {
    Preset hit;
    hit.scene.bodies = {disc("a", {-2.07 + further, 0.0}, {2.0, 0.0}, 0.24),
                        disc("b", {-0.3, 0.0}, {0.0, 0.0}, 0.3)};
    hit.method = {.integrator = IntegratorId::kRk4, .step = 0.005};
    worker_.load(hit);
    worker_.run_until(0.7);
    std::vector<ImpactRecord> impacts;
    Frames newest;
    ASSERT_TRUE(test::wait_until([&] {
      const Frames news = worker_.take_frames();
      if (news.empty()) return false;
      newest = news;
      impacts.insert(impacts.end(), news.front()->impacts.begin(), news.front()->impacts.end());
      return !news.front()->playing && news.front()->time > 0.69;
    }));
    ASSERT_EQ(impacts.size(), 1U);
    const double time = impacts.front().time;
    const auto at = shown({.time = time - 1e-11, .impact = time}).front();
    EXPECT_NEAR(at->time, time, 1e-11);
    ASSERT_EQ(at->jumps.size(), 1U) << further;
    EXPECT_EQ(at->jumps.front()->time(), time);
    in_the_next += at->impact_count == 0;
  }
  EXPECT_GT(in_the_next, 0);
}

// A ball in free fall, h = 0.02 s: explicit Euler is g h t / 2 behind at the steps' ends, and moves straight on
// within a step.
TEST_F(WorkerPast, TheErrorIsThatOfTheMomentWithinAStep) {
  Preset fall;
  fall.scene.bodies = {disc("ball", {0.0, 0.0}, {2.0, 0.0}, 0.1)};
  fall.scene.forces.gravity = {0.0, -9.81};
  fall.method = {.integrator = IntegratorId::kRk4, .step = 0.02};
  fall.compare = {Method{.integrator = IntegratorId::kExplicitEuler, .step = 0.02}};
  worker_.load(fall);
  worker_.set_reference(ReferenceId::kExactFlight);
  recorded_ = {start_beside_reference()};
  record_steps(5);
  for (const double part : {0.004, 0.013, 0.0199}) {
    const Frames frames = shown({recorded_[3].front()->time, 0, part});
    ASSERT_EQ(frames.size(), 2U);
    const double time = 0.06 + part;
    EXPECT_NEAR(frames[0]->time, time, 1e-15);
    EXPECT_LE(frames[0]->error->position, 1e-14) << part;
    const double s = part / 0.02;
    EXPECT_NEAR(frames[1]->error->position, 0.5 * 9.81 * 0.02 * (0.06 + 0.02 * s * s), 1e-12) << part;
  }
}

}  // namespace
}  // namespace carom
