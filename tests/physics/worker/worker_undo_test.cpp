#include <chrono>
#include <gtest/gtest.h>

#include "physics/preset/preset.h"
#include "physics/record/recorder.h"
#include "physics/worker/worker.h"
#include "tests/support/gas_in_a_room.h"
#include "tests/support/lags.h"
#include "tests/support/scenes.h"
#include "tests/support/wait.h"

// What was done to a worker's runs is taken back and put back: they are then what they were, byte for byte.
namespace carom {
namespace {

using test::disc;

Preset gas() {
  Preset s = test::gas_in_a_room(0.95, 0.1);
  s.compare = {Method{.integrator = IntegratorId::kExplicitEuler, .step = 0.003}};
  return s;
}
const Method kVerlet{.integrator = IntegratorId::kVelocityVerlet, .step = 0.002};
const Method kCoarse{.integrator = IntegratorId::kExplicitEuler, .step = 0.01};
const Body kBody = disc("new", {0.0, -0.5}, {1.0, 1.0}, 0.05);

// A run as it is at one moment.
struct Moment {
  std::int64_t steps;
  State state;
  std::vector<RunEdit> edits;
  std::vector<double> times;  // of the rows of the recorded curve
};
bool operator==(const Moment& a, const Moment& b) {
  const auto same = [](const RunEdit& x, const RunEdit& y) {
    return x.id == y.id && x.time == y.time && x.what.index() == y.what.index();
  };
  return a.steps == b.steps && test::same_bytes(a.state, b.state) && a.times == b.times &&
         std::equal(a.edits.begin(), a.edits.end(), b.edits.begin(), b.edits.end(), same);
}

class WorkerUndo : public testing::Test {
 protected:
  // Until a frame comes for which `fulfilled` holds, of runs that stand side by side.
  template <class Condition>
  [[nodiscard]] bool wait(const Condition& fulfilled) {
    return test::wait_until([&] {
      const auto news = worker_.take_frames();
      if (news.empty()) return false;
      std::vector<Recorder> recorders(news.size());
      for (std::size_t i = 0; i < news.size(); ++i) {
        for (std::size_t j = 0; j < frames_.size(); ++j) {
          if (frames_[j]->run == news[i]->run) recorders[i] = recorders_[j];
        }
        recorders[i].add(*news[i]);
      }
      frames_ = news;
      recorders_ = std::move(recorders);
      for (const auto& frame : frames_) {
        if (test::lags(*frame, *frames_[0])) return false;
      }
      return !frames_[0]->replay_until && fulfilled();
    });
  }
  void run_to(double time) {
    worker_.run_until(time);
    ASSERT_TRUE(wait([&] { return !frames_[0]->playing && frames_[0]->time > time - 0.0049; }));
  }
  [[nodiscard]] bool wait_for_edits(std::size_t run, std::size_t count) {
    return wait([=, this] { return frames_.size() > run && frames_[run]->setup->edits.size() == count; });
  }
  [[nodiscard]] Moment moment(std::size_t run) const {
    Moment now{frames_[run]->steps, frames_[run]->state, frames_[run]->setup->edits, {}};
    std::vector<SeriesPoint<1>> points;
    recorders_[run].series(kCurve)->read(-1.0, 1e9, points);
    for (const auto& point : points) now.times.push_back(point.at);
    return now;
  }

  const Curve kCurve{{find_observable("kinetic_energy"), {}}, std::nullopt};
  Worker worker_{gas(), {kCurve}};
  std::vector<std::shared_ptr<const Frame>> frames_;
  std::vector<Recorder> recorders_;
};

TEST_F(WorkerUndo, AMethodIsTakenBackAndPutBack) {
  run_to(1.0);
  const Moment never = moment(0);
  run_to(0.0);
  worker_.restart(gas());
  run_to(0.5);
  const Worker::EditId edit = worker_.set_method(kVerlet);
  run_to(1.0);
  const Moment with = moment(0);
  ASSERT_EQ(with.edits.size(), 1U);
  const std::uint64_t other = frames_[1]->run;
  worker_.undo_or_redo(edit, gas(), ReferenceId::kNone);
  ASSERT_TRUE(wait_for_edits(0, 0));
  EXPECT_EQ(moment(0), never);
  EXPECT_EQ(frames_[1]->run, other) << "it goes on as it is";
  worker_.undo_or_redo(edit, gas(), ReferenceId::kNone);
  ASSERT_TRUE(wait_for_edits(0, 1));
  EXPECT_EQ(moment(0), with);
}

// What looks ahead of the run is not stopped with the run that was left.
TEST_F(WorkerUndo, RunsThatComeBackPlayOnSlowlyNearImpacts) {
  worker_.slow_near_impacts(true);
  worker_.set_speed(100.0);
  worker_.set_playing(true);
  ASSERT_TRUE(wait([&] { return frames_[0]->time > 0.5; }));
  const Worker::EditId kept = worker_.keep_runs();
  worker_.restart(gas());
  ASSERT_TRUE(wait([&] { return frames_[0]->time == 0.0; }));
  worker_.return_to(kept, {kCurve}, ReferenceId::kNone);
  ASSERT_TRUE(wait([&] { return frames_[0]->time > 0.5; }));
  const double back = frames_[0]->time;
  worker_.set_playing(true);
  EXPECT_TRUE(wait([&] { return frames_[0]->time > back + 5.0; }));
}

TEST_F(WorkerUndo, ABodyIsTakenBackFromAllRunsAndPutBack) {
  run_to(1.0);
  const std::vector<Moment> never = {moment(0), moment(1)};
  worker_.restart(gas());
  run_to(0.4);
  const Worker::EditId edit = worker_.edit_scene({Add<Body>{kBody}});
  run_to(1.0);
  const std::vector<Moment> with = {moment(0), moment(1)};
  worker_.undo_or_redo(edit, gas(), ReferenceId::kNone);
  ASSERT_TRUE(wait_for_edits(1, 0));
  EXPECT_EQ(moment(0), never[0]);
  EXPECT_EQ(moment(1), never[1]);
  worker_.undo_or_redo(edit, gas(), ReferenceId::kNone);
  ASSERT_TRUE(wait_for_edits(1, 1));
  EXPECT_EQ(moment(0), with[0]);
  EXPECT_EQ(moment(1), with[1]);
}

// A body that comes in on the way has another mass in the start that followed the edit.
TEST_F(WorkerUndo, AnEditOfABodyThatComesInIsTakenBackAfterANewStart) {
  const auto with = [](double mass) {
    Preset preset = gas();
    Body late = kBody;
    late.id.number = 100;
    late.mass = mass;
    preset.edits = {{0.3, 0, SceneEdits{Add<Body>{late}}}};
    return preset;
  };
  const auto has_mass = [this](double mass) { return added_body(frames_[0]->setup->edits.at(0)).mass == mass; };
  worker_.load(with(1.0), {kCurve});
  run_to(1.0);
  const Moment light = moment(0);
  worker_.restart(with(1.0));
  run_to(0.5);
  const Worker::EditId edit = worker_.edit_scene({Replace<Body>{added_body(with(5.0).edits[0])}});
  worker_.restart(with(5.0));
  run_to(1.0);
  const Moment heavy = moment(0);
  ASSERT_TRUE(has_mass(5.0));
  worker_.undo_or_redo(edit, with(1.0), ReferenceId::kNone);
  ASSERT_TRUE(wait([&] { return has_mass(1.0); }));
  EXPECT_EQ(moment(0), light);
  worker_.undo_or_redo(edit, with(5.0), ReferenceId::kNone);
  ASSERT_TRUE(wait([&] { return has_mass(5.0); }));
  EXPECT_EQ(moment(0), heavy);
}

// More edits than key frames at edits are kept: the first is taken back from a key frame before it. Key frames,
// curves and impacts of what was taken back are gone.
TEST_F(WorkerUndo, TheFirstOfManyIsTakenBackFromAKeyFrame) {
  run_to(6.0);
  const Moment never = moment(0);
  const std::size_t impacts = recorders_[0].impacts().size();
  worker_.restart(gas());
  run_to(3.0);
  std::vector<Worker::EditId> edits;
  for (std::size_t k = 0; k <= KeyFrames::kMostAtEdits; ++k) {
    Method method = gas().method;
    method.step = k % 2 == 0 ? 0.004 : 0.003;
    edits.push_back(worker_.set_method(method));
    run_to(3.0 + 0.1 * static_cast<double>(k + 1));
  }
  run_to(6.0);
  const Moment with = moment(0);
  const std::uint64_t run = frames_[0]->run;
  for (std::size_t k = edits.size(); k-- > 0;) worker_.undo_or_redo(edits[k], gas(), ReferenceId::kNone);
  ASSERT_TRUE(wait_for_edits(0, 0));
  run_to(6.0);
  EXPECT_EQ(moment(0), never);
  EXPECT_EQ(frames_[0]->run, run) << "the run goes back, and is no new one";
  EXPECT_EQ(recorders_[0].impacts().size(), impacts);
  for (const Worker::EditId edit : edits) worker_.undo_or_redo(edit, gas(), ReferenceId::kNone);
  ASSERT_TRUE(wait_for_edits(0, edits.size()));
  run_to(6.0);
  EXPECT_EQ(moment(0), with);
}

// A replay that is ended stays where it is, and plays on from there.
TEST_F(WorkerUndo, AReplayCanBeEnded) {
  run_to(0.5);
  const Worker::EditId edit = worker_.set_method(kVerlet);
  run_to(1.0);
  // A busy machine may have replayed all of it before the end is asked for.
  for (int attempt = 0; attempt < 50; ++attempt) {
    worker_.undo_or_redo(edit, gas(), ReferenceId::kNone);
    worker_.end_replay();
    ASSERT_TRUE(wait_for_edits(0, 0));
    if (frames_[0]->time < 0.99) break;
    worker_.undo_or_redo(edit, gas(), ReferenceId::kNone);
    ASSERT_TRUE(wait_for_edits(0, 1));
  }
  EXPECT_GE(frames_[0]->time, 0.5 - 1e-9);
  EXPECT_LT(frames_[0]->time, 0.99);
  EXPECT_FALSE(frames_[0]->playing);
  EXPECT_EQ(moment(0).times.back(), frames_[0]->time);
  run_to(1.0);
  const Moment after = moment(0);
  worker_.restart(gas());
  run_to(1.0);
  EXPECT_EQ(after, moment(0));
}

// The second is asked for while the first is under way.
TEST_F(WorkerUndo, SeveralAreTakenBackInARow) {
  run_to(1.0);
  const Moment never = moment(0);
  worker_.restart(gas());
  run_to(0.4);
  const Worker::EditId body = worker_.edit_scene({Add<Body>{kBody}});
  run_to(0.6);
  const Worker::EditId method = worker_.set_method(kVerlet);
  run_to(1.0);
  const Moment with = moment(0);
  worker_.undo_or_redo(method, gas(), ReferenceId::kNone);
  worker_.undo_or_redo(body, gas(), ReferenceId::kNone);
  ASSERT_TRUE(wait_for_edits(0, 0));
  EXPECT_EQ(moment(0), never);
  worker_.undo_or_redo(body, gas(), ReferenceId::kNone);
  worker_.undo_or_redo(method, gas(), ReferenceId::kNone);
  ASSERT_TRUE(wait_for_edits(0, 2));
  EXPECT_EQ(moment(0), with);
}

TEST_F(WorkerUndo, AMethodOfAComparedRunLeavesTheFirstAlone) {
  run_to(1.0);
  const Moment never = moment(1);
  worker_.restart(gas());
  run_to(0.5);
  const Worker::EditId edit = worker_.set_method(kCoarse, 1);
  run_to(1.0);
  const Moment with = moment(1);
  const std::uint64_t first = frames_[0]->run;
  worker_.undo_or_redo(edit, gas(), ReferenceId::kNone);
  // "From now on" is the moment that is shown, however far back the run is on its way.
  const Worker::EditId again = worker_.set_method(kCoarse, 1);
  ASSERT_TRUE(wait_for_edits(1, 1));
  EXPECT_GE(frames_[1]->setup->edits[0].time, 0.99);
  worker_.undo_or_redo(again, gas(), ReferenceId::kNone);
  ASSERT_TRUE(wait_for_edits(1, 0));
  EXPECT_EQ(moment(1), never);
  EXPECT_EQ(frames_[0]->run, first);
}

TEST_F(WorkerUndo, ARunComesAndGoesWithItsPast) {
  run_to(0.5);
  worker_.set_method(kCoarse, 1);
  run_to(1.0);
  const Moment with = moment(1);
  const Worker::EditId gone = worker_.remove_method(1);
  ASSERT_TRUE(wait([&] { return frames_.size() == 1; }));
  worker_.undo_or_redo(gone, gas(), ReferenceId::kNone);
  ASSERT_TRUE(wait([&] { return frames_.size() == 2; }));
  EXPECT_EQ(moment(1), with);
  const Worker::EditId more = worker_.add_method(kVerlet);
  ASSERT_TRUE(wait([&] { return frames_.size() == 3; }));
  const std::uint64_t run = frames_[1]->run;
  worker_.undo_or_redo(more, gas(), ReferenceId::kNone);
  ASSERT_TRUE(wait([&] { return frames_.size() == 2; }));
  EXPECT_EQ(frames_[1]->run, run);
  worker_.undo_or_redo(more, gas(), ReferenceId::kNone);
  ASSERT_TRUE(wait([&] { return frames_.size() == 3; }));
  EXPECT_EQ(frames_[2]->method, kVerlet);
}

// A restart begins with the methods in force: that is where they are taken back, and bodies at their time.
TEST_F(WorkerUndo, WhatWasDoneBeforeARestartIsTakenBackFromTheStart) {
  run_to(0.8);
  const Moment never = moment(0);
  worker_.restart(gas());
  run_to(0.2);
  const Worker::EditId method = worker_.set_method(kVerlet);
  const Worker::EditId body = worker_.edit_scene({Add<Body>{kBody}});
  ASSERT_TRUE(wait_for_edits(0, 2));
  Preset with_method = gas();
  with_method.method = kVerlet;
  Preset with_both = with_method;
  with_both.edits = {frames_[0]->setup->edits.back()};
  worker_.restart(with_both);
  run_to(0.8);
  const Moment with = moment(0);
  EXPECT_EQ(with.edits.size(), 1U);
  EXPECT_EQ(frames_[0]->setup->method, kVerlet);
  worker_.undo_or_redo(body, with_method, ReferenceId::kNone);
  worker_.undo_or_redo(method, gas(), ReferenceId::kNone);
  ASSERT_TRUE(wait([&] { return frames_[0]->setup->method != kVerlet; }));
  EXPECT_EQ(moment(0), never);
  worker_.undo_or_redo(method, with_method, ReferenceId::kNone);
  worker_.undo_or_redo(body, with_both, ReferenceId::kNone);
  ASSERT_TRUE(wait_for_edits(0, 1));
  EXPECT_EQ(moment(0), with);
}

TEST_F(WorkerUndo, ARunThatPlaysGoesOn) {
  worker_.set_speed(2.0);
  worker_.set_playing(true);
  ASSERT_TRUE(wait([&] { return frames_[0]->time > 0.2; }));
  const Worker::EditId edit = worker_.set_method(kVerlet);
  ASSERT_TRUE(wait_for_edits(0, 1));
  const double time = frames_[0]->time;
  worker_.undo_or_redo(edit, gas(), ReferenceId::kNone);
  ASSERT_TRUE(wait_for_edits(0, 0));
  EXPECT_GT(frames_[0]->time, time - 0.005);
  EXPECT_TRUE(frames_[0]->playing);
  ASSERT_TRUE(wait([&] { return frames_[0]->time > time + 0.1; }));
}

TEST_F(WorkerUndo, ARestartWithOtherMethodsIsTakenBack) {
  run_to(0.5);
  const Moment never = moment(0);
  Preset other = gas();
  other.method = kVerlet;
  other.compare = {kCoarse, kVerlet};
  const Worker::EditId edit = worker_.restart(other, {kCurve}, ReferenceId::kNone);
  run_to(0.5);
  ASSERT_EQ(frames_.size(), 3U);
  worker_.undo_or_redo(edit, gas(), ReferenceId::kNone);
  ASSERT_TRUE(wait([&] { return frames_.size() == 2; }));
  EXPECT_EQ(moment(0), never);
}

// Also with what nobody had taken of the runs when an edit left them.
TEST_F(WorkerUndo, RunsThatAnEditLeftGoOnWhereTheyWere) {
  run_to(0.5);
  const std::uint64_t run = frames_[0]->run;
  const std::int64_t steps = frames_[0]->steps;
  const auto frames = frames_;
  const auto recorders = recorders_;
  worker_.step_once();
  worker_.wait_for_frames(std::chrono::seconds(20));
  Preset other = gas();
  other.scene.bodies.back().velocity = {0.0, 0.0};
  const Worker::EditId edit = worker_.keep_runs();
  worker_.start_from(other, {kCurve}, ReferenceId::kNone);
  run_to(0.3);
  ASSERT_NE(frames_[0]->run, run);
  frames_ = frames;
  recorders_ = recorders;
  worker_.return_to(edit, {kCurve}, ReferenceId::kNone);
  ASSERT_TRUE(wait([&] { return frames_[0]->run == run; }));
  EXPECT_EQ(frames_[0]->steps, steps + 1);
  EXPECT_FALSE(frames_[0]->playing);
  run_to(1.0);
  const std::vector<Moment> after = {moment(0), moment(1)};
  worker_.restart(gas());
  run_to(1.0);
  EXPECT_EQ(after[0], moment(0));
  EXPECT_EQ(after[1], moment(1));
}

// Those that earlier edits left are replayed, with the edits that they had.
TEST_F(WorkerUndo, RunsThatAreKeptNoMoreAreReplayed) {
  run_to(0.5);
  worker_.set_method(kVerlet);
  run_to(1.0);
  const std::vector<Moment> left = {moment(0), moment(1)};
  const Worker::EditId edit = worker_.keep_runs();
  worker_.start_from(gas(), {kCurve}, ReferenceId::kNone);
  run_to(0.1);
  for (int i = 0; i < RunGroup::kMostKept; ++i) {
    worker_.keep_runs();
    worker_.start_from(gas(), {kCurve}, ReferenceId::kNone);
  }
  run_to(0.1);
  const auto is_there = [&] { return wait_for_edits(0, 1); };
  worker_.return_to(edit, {kCurve}, ReferenceId::kNone);
  ASSERT_TRUE(is_there());
  EXPECT_FALSE(frames_[0]->playing);
  EXPECT_EQ(moment(0), left[0]);
  EXPECT_EQ(moment(1), left[1]);
  // Left again, in the middle of a replay: the moment that it was on the way to is the one to return to.
  for (int i = 0; i <= RunGroup::kMostKept; ++i) {
    worker_.keep_runs(i == 0 ? edit : 0);
    worker_.start_from(gas(), {kCurve}, ReferenceId::kNone);
  }
  worker_.return_to(edit, {kCurve}, ReferenceId::kNone);
  worker_.keep_runs(edit);
  worker_.start_from(gas(), {kCurve}, ReferenceId::kNone);
  worker_.return_to(edit, {kCurve}, ReferenceId::kNone);
  ASSERT_TRUE(is_there());
  EXPECT_EQ(moment(0), left[0]);
  EXPECT_EQ(moment(1), left[1]);
}

}  // namespace
}  // namespace carom
