#include "physics/worker/worker.h"

#include <algorithm>
#include <chrono>
#include <gtest/gtest.h>

#include "physics/preset/preset.h"
#include "physics/record/recorder.h"
#include "tests/support/body_literal.h"
#include "tests/support/scenes.h"
#include "tests/support/threads.h"
#include "tests/support/wait.h"

namespace carom {
namespace {

using namespace test::literals;

using test::disc;
using test::room;

Preset small_gas() {
  std::vector<Body> bodies = room(1.0, 0.5);
  for (int i = 0; i < 4; ++i) {
    bodies.push_back(disc("disc " + std::string(1, static_cast<char>('a' + i)), {-0.6 + 0.4 * i, 0.1 * i},
                          {1.0 - 0.7 * i, 0.3 + 0.4 * i}));
  }
  Preset s = test::preset_with(std::move(bodies), 0.95, 0.1);
  s.scene.forces.gravity = {0.0, -9.81};
  return s;
}

Curve energy() { return {{find_observable("kinetic_energy"), {}}, std::nullopt}; }
Curve path() { return {{find_observable("y"), {4_b}}, Quantity{find_observable("x"), {4_b}}}; }

// Of a worker's only run.
std::shared_ptr<const Frame> take_frame(Worker& worker) {
  const auto frames = worker.take_frames();
  return frames.empty() ? nullptr : frames.front();
}

// Collects frames, checks that nothing is lost or out of order, and waits for what a test asks for.
class Watcher {
 public:
  explicit Watcher(Worker& worker) : worker_(worker) {}

  template <class Condition>
  bool wait(const Condition& condition) {
    return test::wait_until([&] {
      const auto frame = take_frame(worker_);
      if (frame) take(*frame);
      return frame && condition(*frame);
    });
  }

  std::vector<double> times;  // of the rows of the first curve
  std::vector<ImpactRecord> impacts;
  Frame last;

 private:
  void take(const Frame& frame) {
    if (frame.run != last.run) {
      EXPECT_GT(frame.run, last.run);
      times.clear();
      impacts.clear();
      ASSERT_FALSE(frame.rows.empty());
      EXPECT_TRUE(frame.rows.front().from_the_start);
      EXPECT_EQ(frame.rows.front().times.front(), 0.0);
    }
    for (const Rows& rows : frame.rows) {
      EXPECT_EQ(rows.values.size(), rows.size() * rows.curves->size());
      times.insert(times.end(), rows.times.begin(), rows.times.end());
    }
    EXPECT_TRUE(std::is_sorted(times.begin(), times.end()));
    EXPECT_EQ(times.back(), frame.time);
    impacts.insert(impacts.end(), frame.impacts.begin(), frame.impacts.end());
    EXPECT_EQ(static_cast<std::int64_t>(impacts.size()), frame.impact_count);
    // One row at the start, one a step, one for each edit, and two for each impact that is watched.
    const auto at_impacts = static_cast<std::int64_t>(times.size()) - 1 - frame.steps;
    EXPECT_GE(at_impacts, 2 * std::min<std::int64_t>(frame.impact_count, 1));
    EXPECT_LE(at_impacts, 2 * frame.impact_count + edits);
    if (edits == 0) {
      EXPECT_EQ(at_impacts % 2, 0);
    }
    EXPECT_EQ(frame.bodies->size(), static_cast<std::size_t>(frame.state.size()));
    EXPECT_EQ(frame.rows_known_until, frame.time);
    last = frame;
  }

 public:
  std::int64_t edits = 0;

 private:
  Worker& worker_;
};

TEST(Worker, RunUntilGivesTheBytesOfAPlainRun) {
  const Preset s = small_gas();
  Worker worker(s, {energy()});
  Watcher watcher(worker);
  worker.run_until(20.0);
  ASSERT_TRUE(watcher.wait([](const Frame& f) { return !f.playing && f.steps > 0; }));
  Simulation plain(setup_of(s));
  plain.advance_to(20.0);
  EXPECT_EQ(watcher.last.steps, plain.steps());
  EXPECT_EQ(watcher.last.time, plain.time());
  EXPECT_TRUE(test::same_bytes(watcher.last.state, plain.state()));
  EXPECT_EQ(watcher.last.impact_count, plain.impact_count());
}

TEST(Worker, NewsOfFramesThatNobodyTookGoOn) {
  Worker worker(small_gas());
  Watcher watcher(worker);
  worker.run_until(100.0);
  ASSERT_TRUE(test::wait_until_other_threads_sleep());  // it has published many frames, and ended
  ASSERT_TRUE(watcher.wait([](const Frame& f) { return !f.playing && f.steps > 0; }));
  for (std::size_t i = 1; i < watcher.impacts.size(); ++i) {
    ASSERT_GE(watcher.impacts[i].time, watcher.impacts[i - 1].time);
  }
}

// A window that is asleep must not fill the memory: the run waits for it, and nothing is lost.
TEST(Worker, WaitsWhereNobodyTakesItsFrames) {
  Preset s;
  s.scene.bodies = {disc("a", {0.0, 0.0}, {1.0, 0.0})};
  s.method.step = 1e-6;
  Worker worker(s, {energy()});
  worker.run_until(1.5);
  std::int64_t rows = 0;
  std::size_t largest = 0;
  bool ended = false;
  const auto take = [&] {
    const auto frame = take_frame(worker);
    if (frame == nullptr) return;
    std::size_t waited = frame->impacts.size();
    for (const Rows& r : frame->rows) {
      rows += static_cast<std::int64_t>(r.size());
      waited += r.size() + r.values.size();
    }
    largest = std::max(largest, waited);
    EXPECT_EQ(rows, 1 + frame->steps);
    ended = frame->steps > 0 && !frame->playing;
  };
  // It sleeps with as many rows as may wait, or at the end.
  EXPECT_TRUE(test::wait_until([&] {
    EXPECT_TRUE(test::wait_until_other_threads_sleep());
    take();
    return ended || largest > Worker::kMostWaiting;
  }));
  EXPECT_FALSE(ended);
  EXPECT_GT(largest, Worker::kMostWaiting);
  EXPECT_TRUE(test::wait_until([&] {
    take();
    return ended;
  }));
  EXPECT_EQ(rows, 1'500'001);
  // The frame that passed the bound, and no more.
  EXPECT_LT(largest, 2 * Worker::kMostWaiting);
}

// The run is never ahead of the clock, at which a slow machine may make it late.
TEST(Worker, PlaysPausesStepsAndRestarts) {
  const Preset s = small_gas();
  Worker worker(s);
  Watcher watcher(worker);
  ASSERT_TRUE(watcher.wait([](const Frame& f) { return f.steps == 0; }));
  worker.step_once();
  ASSERT_TRUE(watcher.wait([](const Frame& f) { return f.steps == 1 && !f.playing; }));
  worker.set_speed(2.0);
  const auto begin = std::chrono::steady_clock::now();
  worker.set_playing(true);
  ASSERT_TRUE(watcher.wait([&](const Frame& f) {
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - begin;
    EXPECT_LE(f.time, s.method.step + 2.0 * passed.count() + 1e-6);
    return f.time > 0.4;
  }));
  worker.set_playing(false);
  ASSERT_TRUE(watcher.wait([](const Frame& f) { return !f.playing; }));
  const std::int64_t steps = watcher.last.steps;
  // If it still played, it would step before each of these answers.
  worker.set_speed(1e9);
  for (int i = 0; i < 10; ++i) {
    worker.set_reference(ReferenceId::kNone);
    ASSERT_TRUE(watcher.wait([&](const Frame&) { return true; }));
    EXPECT_EQ(watcher.last.steps, steps);
  }
  worker.step_once();
  ASSERT_TRUE(watcher.wait([&](const Frame& f) { return f.steps == steps + 1; }));
  worker.restart(s);
  ASSERT_TRUE(watcher.wait([](const Frame& f) { return f.steps == 0 && f.time == 0.0; }));
  EXPECT_EQ(watcher.last.run, 2U);
  EXPECT_FALSE(watcher.last.playing);
}

// At the speed of the start this would take longer than anything here is waited for.
TEST(Worker, PlaysAtTheSpeedThatIsSet) {
  const double far = 2.0 * std::chrono::duration<double>(test::kLongestWait).count();
  Preset s = test::preset_with({disc("a", {0.0, 0.0}, {1.0, 0.0})});
  Worker worker(s);
  Watcher watcher(worker);
  worker.set_playing(true);
  ASSERT_TRUE(watcher.wait([](const Frame& f) { return f.playing; }));
  worker.set_speed(1e6);
  EXPECT_TRUE(watcher.wait([far](const Frame& f) { return f.time > far; }));
}

// The preset with the bodies that the run has got on its way.
Preset with_added(Preset preset, const Frame& frame) {
  preset.edits = frame.setup->edits;
  std::erase_if(preset.edits, [](const RunEdit& edit) { return std::holds_alternative<Method>(edit.what); });
  return preset;
}

TEST(Worker, ChangesTheMethodAndTakesBodies) {
  const Preset s = small_gas();
  Worker worker(s);
  Watcher watcher(worker);
  const Method method{IntegratorId::kSemiImplicitEuler, ImpactsId::kStepEnd, ContactsId::kImpulse, 0.01};
  worker.set_method(method);
  const Body body = disc("new", {0.0, -0.5}, {1.0, 1.0}, 0.05);
  worker.edit_scene({Add<Body>{body}});
  watcher.edits = 2;
  worker.run_until(2.0);
  ASSERT_TRUE(watcher.wait([](const Frame& f) { return !f.playing && f.steps > 0; }));
  Simulation plain(setup_of(s));
  plain.set_method(method);
  plain.apply({Add<Body>{body}});
  plain.advance_to(2.0);
  EXPECT_TRUE(test::same_bytes(watcher.last.state, plain.state()));
  EXPECT_EQ(watcher.last.method, method);
  EXPECT_EQ(watcher.last.bodies->back().name, "new");
  watcher.edits = 1;  // the body comes in again
  worker.restart(with_added(s, watcher.last));
  ASSERT_TRUE(watcher.wait([](const Frame& f) { return f.steps == 0; }));
  EXPECT_EQ(watcher.last.state.size(), 9);
}

// A restart goes back to the bodies of the start; those that were added come in again at their time, also where
// another one was added before them since.
TEST(Worker, BodiesComeInAgainAtTheirTimeAfterARestart) {
  Worker worker(small_gas());
  Watcher watcher(worker);
  watcher.edits = 2;
  const auto run_to = [&](double time) {
    worker.run_until(time);
    return watcher.wait([time](const Frame& f) { return !f.playing && f.time > time - 0.01; });
  };
  const auto names = [&] {
    std::vector<std::string> all;
    for (const Body& body : *watcher.last.bodies) all.push_back(body.name);
    return std::vector<std::string>(all.begin() + 8, all.end());
  };
  ASSERT_TRUE(run_to(0.4));
  worker.edit_scene({Add<Body>{disc("late", {0.0, 0.4}, {0.0, 0.0}, 0.05)}});
  ASSERT_TRUE(run_to(0.6));
  const State first = watcher.last.state;
  EXPECT_EQ(names(), std::vector<std::string>{"late"});
  const Preset late = with_added(small_gas(), watcher.last);
  worker.restart(late);
  ASSERT_TRUE(watcher.wait([](const Frame& f) { return f.steps == 0; }));
  EXPECT_EQ(watcher.last.state.size(), 8);
  ASSERT_TRUE(run_to(0.6));
  EXPECT_TRUE(test::same_bytes(watcher.last.state, first));
  worker.restart(late);
  ASSERT_TRUE(run_to(0.2));
  EXPECT_TRUE(names().empty());
  worker.edit_scene({Add<Body>{disc("early", {0.3, 0.4}, {0.0, 0.0}, 0.05)}});
  ASSERT_TRUE(run_to(0.3));
  EXPECT_EQ(names(), std::vector<std::string>{"early"});
  ASSERT_TRUE(run_to(0.6));
  EXPECT_EQ(names(), (std::vector<std::string>{"early", "late"}));
}

// A step that lasts longer than the lag that a slow machine is forgiven: it comes when it is due.
TEST(Worker, PlaysStepsThatLast) {
  Preset s = small_gas();
  s.method.step = 0.2;
  Worker worker(s);
  Watcher watcher(worker);
  worker.set_playing(true);
  EXPECT_TRUE(watcher.wait([](const Frame& f) { return f.steps >= 3; }));
}

// The measured speed belongs to the time since playing began: not to a pause, nor to the run before. These
// are many steps at once and much of a run, so that either would be seen on any machine.
TEST(Worker, RealisedSpeedIsOfThisRun) {
  constexpr double kTooFast = 4.0;  // at speed 1
  Worker worker(small_gas());
  Watcher watcher(worker);
  worker.run_until(100.0);
  ASSERT_TRUE(watcher.wait([](const Frame& f) { return f.time > 99.9 && !f.playing; }));
  worker.set_playing(true);
  ASSERT_TRUE(watcher.wait([](const Frame& f) { return f.playing && f.realised_speed > 0.0; }));
  EXPECT_LT(watcher.last.realised_speed, kTooFast);
  worker.set_playing(false);
  ASSERT_TRUE(watcher.wait([](const Frame& f) { return !f.playing; }));
  EXPECT_EQ(watcher.last.realised_speed, 0.0);
  const std::int64_t steps = watcher.last.steps;
  for (int i = 0; i < 2000; ++i) worker.step_once();  // 10 s of the run
  ASSERT_TRUE(watcher.wait([&](const Frame& f) { return f.steps == steps + 2000; }));
  EXPECT_EQ(watcher.last.realised_speed, 0.0);
  worker.set_playing(true);
  ASSERT_TRUE(watcher.wait([](const Frame& f) { return f.realised_speed != 0.0; }));
  EXPECT_GT(watcher.last.realised_speed, 0.0);
  EXPECT_LT(watcher.last.realised_speed, kTooFast);
  worker.restart(small_gas());
  worker.set_playing(true);
  ASSERT_TRUE(watcher.wait([](const Frame& f) { return f.run == 2 && f.realised_speed != 0.0; }));
  EXPECT_GT(watcher.last.realised_speed, 0.0);
  EXPECT_LT(watcher.last.realised_speed, kTooFast);
}

TEST(Worker, IsDestroyedWhilePlaying) {
  for (int i = 0; i < 20; ++i) {
    Worker worker(small_gas());
    worker.set_playing(true);
    if (i % 2 == 0) worker.run_until(1e6);
    if (i % 3 == 0) {
      EXPECT_TRUE(test::wait_until([&] {
        const auto frame = take_frame(worker);
        return frame != nullptr && frame->steps > 0;
      }));
    }
  }
}

TEST(Worker, TakesManyCommandsAtOnce) {
  Worker worker(small_gas());
  Watcher watcher(worker);
  worker.set_playing(true);
  for (int i = 0; i < 200; ++i) {
    if (i % 5 == 0) worker.load(small_gas());
    if (i % 7 == 0) worker.restart(small_gas());
    worker.set_playing(i % 3 != 0);
    worker.step_once();
  }
  worker.restart(small_gas());
  worker.run_until(1.0);
  ASSERT_TRUE(watcher.wait([](const Frame& f) { return !f.playing && f.time > 0.9; }));
  EXPECT_EQ(watcher.last.steps, 200);
}

// Plays a run with edits, asks for more curves in its midst, and looks at what was recorded when it stands.
TEST(Worker, CurvesThatAreAskedForLateComeFromTheStartOn) {
  const std::vector<Curve> all = {
      energy(), path(), {{find_observable("impacts_between"), {4_b, 5_b}}, std::nullopt}};
  const Method method{IntegratorId::kVelocityVerlet, ImpactsId::kStepEnd, ContactsId::kImpulse, 0.002};
  const Body body = disc("new", {0.0, -0.5}, {1.0, 1.0}, 0.05);
  Recorder early;
  Recorder late;
  const auto run = [&](Recorder& recorder, bool at_once) {
    Worker worker(small_gas(), at_once ? all : std::vector<Curve>{energy()});
    // A frame between two commands may be shown too: it stands as well, but not at the end of the run.
    const auto wait_for_end = [&](double end) {
      EXPECT_TRUE(test::wait_until([&] {
        const auto frame = take_frame(worker);
        if (frame != nullptr) recorder.add(*frame);
        return frame != nullptr && !frame->playing && frame->time > end - 1e-3 &&
               frame->rows_known_until == frame->time;
      })) << "it did not end at "
          << end << " s";
    };
    worker.run_until(3.0);
    wait_for_end(3.0);
    worker.edit_scene({Add<Body>{body}});
    worker.set_method(method);
    worker.run_until(5.0);
    if (!at_once) worker.record(all);
    wait_for_end(5.0);
    worker.run_until(6.0);
    wait_for_end(6.0);
  };
  run(early, true);
  run(late, false);
  for (const Curve& curve : {all[0], all[2]}) {
    ASSERT_NE(late.series(curve), nullptr);
    std::vector<SeriesPoint<1>> expected;
    std::vector<SeriesPoint<1>> got;
    early.series(curve)->read(0.0, 10.0, expected);
    late.series(curve)->read(0.0, 10.0, got);
    EXPECT_EQ(got.size(), expected.size());
    EXPECT_TRUE(got == expected);
    EXPECT_GT(got.size(), 600U + 1500U);
  }
  std::vector<SeriesPoint<2>> expected;
  std::vector<SeriesPoint<2>> got;
  early.path(path())->read(0.0, 10.0, expected);
  late.path(path())->read(0.0, 10.0, got);
  EXPECT_TRUE(got == expected);
  EXPECT_EQ(late.impacts().size(), early.impacts().size());
}

// A curve that went away and comes back is whole; what is no longer wanted is forgotten.
TEST(Worker, CurvesComeAndGo) {
  Worker worker(small_gas(), {energy()});
  Recorder recorder;
  const auto run_to = [&](double time) {
    worker.run_until(time);
    ASSERT_TRUE(test::wait_until([&] {
      if (const auto frame = take_frame(worker)) recorder.add(*frame);
      return recorder.time() >= time - 1e-9;
    }));
  };
  run_to(1.0);
  worker.record({path()});
  recorder.keep({path()});
  EXPECT_EQ(recorder.series(energy()), nullptr);
  run_to(2.0);
  worker.record({path(), energy()});
  recorder.keep({path(), energy()});
  run_to(3.0);
  ASSERT_NE(recorder.series(energy()), nullptr);
  std::vector<SeriesPoint<1>> read;
  recorder.series(energy())->read(0.0, 10.0, read);
  EXPECT_EQ(read.front().at, 0.0);
  EXPECT_GE(read.size(), 600U);
  EXPECT_EQ(recorder.series(energy())->count(), recorder.path(path())->count());
}

TEST(Recorder, KeepsTheNewestImpactsAndTheHighestOfAll) {
  Recorder recorder;
  Frame frame;
  frame.run = 1;
  frame.impacts.resize(Recorder::kMostImpacts / 4);
  double time = 0.0;
  for (int i = 0; i < 12; ++i) {
    for (ImpactRecord& impact : frame.impacts) impact.time = time++;
    // One impact stands out, in the first frame only.
    frame.impacts[4321].normal_impulse = i == 0 ? 3.0 : 1.0;
    recorder.add(frame);
    EXPECT_LE(recorder.impacts().size(), Recorder::kMostImpacts);
    EXPECT_EQ(recorder.impacts().back().time, time - 1.0);
  }
  EXPECT_EQ(recorder.impacts()[0].time, 8.0 * static_cast<double>(frame.impacts.size()));
  EXPECT_EQ(recorder.impulses().count(), 12 * static_cast<std::int64_t>(frame.impacts.size()));
  std::vector<SeriesPoint<1>> read;
  recorder.impulses().read(0.0, time, read);
  EXPECT_TRUE(std::any_of(read.begin(), read.end(), [](const auto& p) { return p.value[0] == 3.0; }));
  frame.impacts.resize(10);
  frame.run = 2;
  recorder.add(frame);
  EXPECT_EQ(recorder.impacts().size(), 10U);
  EXPECT_EQ(recorder.impulses().count(), 10);
}

}  // namespace
}  // namespace carom
