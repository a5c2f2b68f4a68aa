#include "physics/world/worker.h"

#include <algorithm>
#include <chrono>
#include <gtest/gtest.h>
#include <thread>

#include "physics/measure/recorder.h"
#include "physics/preset/preset.h"
#include "physics/world/thinning.h"
#include "tests/physics/scenes.h"

namespace carom {
namespace {

using namespace std::chrono_literals;
using test::disc;
using test::room;

Scene small_gas() {
  std::vector<Body> bodies = room(1.0, 0.5);
  for (int i = 0; i < 4; ++i) {
    bodies.push_back(disc("disc " + std::string(1, static_cast<char>('a' + i)), {-0.6 + 0.4 * i, 0.1 * i},
                          {1.0 - 0.7 * i, 0.3 + 0.4 * i}));
  }
  Scene s = test::scene(std::move(bodies), 0.95, 0.1);
  s.forces.gravity = {0.0, -9.81};
  return s;
}

// Collects frames, checks that nothing is lost or out of order, and waits for what a test asks for.
class Watcher {
 public:
  explicit Watcher(Worker& worker) : worker_(worker) {}

  template <class Condition>
  bool wait(const Condition& condition) {
    const auto end = std::chrono::steady_clock::now() + 20s;
    while (std::chrono::steady_clock::now() < end) {
      if (const auto frame = worker_.take_frame()) {
        take(*frame);
        if (condition(*frame)) return true;
      }
      std::this_thread::sleep_for(1ms);
    }
    return false;
  }

  std::vector<Sample> samples;
  std::vector<ImpactRecord> impacts;
  Frame last;

 private:
  void take(const Frame& frame) {
    if (frame.run != last.run) {
      EXPECT_GT(frame.run, last.run);
      samples.clear();
      impacts.clear();
      ASSERT_FALSE(frame.samples.empty());
      EXPECT_EQ(frame.samples.front().time, 0.0);
    }
    for (const Sample& s : frame.samples) {
      if (!samples.empty()) {
        EXPECT_GE(s.time, samples.back().time);
      }
      samples.push_back(s);
    }
    impacts.insert(impacts.end(), frame.impacts.begin(), frame.impacts.end());
    EXPECT_EQ(static_cast<std::int64_t>(impacts.size()), frame.impact_count);
    // One sample at the start, one a step, and two for each impact that is watched.
    const auto at_impacts = static_cast<std::int64_t>(samples.size()) - 1 - frame.steps;
    EXPECT_GE(at_impacts, 2 * std::min<std::int64_t>(frame.impact_count, 1));
    EXPECT_LE(at_impacts, 2 * frame.impact_count);
    EXPECT_EQ(at_impacts % 2, 0);
    EXPECT_EQ(frame.bodies->size(), static_cast<std::size_t>(frame.state.size()));
    last = frame;
  }
  Worker& worker_;
};

TEST(Worker, RunUntilGivesTheBytesOfAPlainRun) {
  const Scene s = small_gas();
  Worker worker(s);
  Watcher watcher(worker);
  worker.run_until(20.0);
  ASSERT_TRUE(watcher.wait([](const Frame& f) { return !f.playing && f.steps > 0; }));
  Simulation plain(s);
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
  std::this_thread::sleep_for(200ms);  // many frames are published meanwhile
  ASSERT_TRUE(watcher.wait([](const Frame& f) { return !f.playing && f.steps > 0; }));
  for (std::size_t i = 1; i < watcher.impacts.size(); ++i) {
    ASSERT_GE(watcher.impacts[i].time, watcher.impacts[i - 1].time);
  }
}

// A window that is asleep must not fill the memory.
TEST(Worker, FramesThatWaitAreBounded) {
  Scene s;
  s.bodies = {disc("a", {0.0, 0.0}, {1.0, 0.0})};
  s.method.step = 1e-6;
  bool thinned = false;
  for (auto asleep = 100ms; !thinned && !HasFailure() && asleep < 30s; asleep *= 2) {
    Worker worker(s);
    worker.run_until(1e6);
    std::this_thread::sleep_for(asleep);
    std::shared_ptr<const Frame> frame;
    while (frame == nullptr || frame->steps == 0) frame = worker.take_frame();
    EXPECT_LE(frame->samples.size(), kMostSamples);
    EXPECT_EQ(frame->samples.front().time, 0.0);
    EXPECT_EQ(frame->samples.back().time, frame->time);
    EXPECT_EQ(frame->complete, static_cast<std::int64_t>(frame->samples.size()) == 1 + frame->steps);
    Recorder recorder;
    recorder.add(*frame);
    EXPECT_EQ(recorder.complete(), frame->complete);
    thinned = !frame->complete;
  }
  EXPECT_TRUE(thinned);
}

TEST(Worker, PlaysPausesStepsAndRestarts) {
  Worker worker(small_gas());
  Watcher watcher(worker);
  ASSERT_TRUE(watcher.wait([](const Frame& f) { return f.steps == 0; }));
  worker.step_once();
  ASSERT_TRUE(watcher.wait([](const Frame& f) { return f.steps == 1 && !f.playing; }));
  worker.set_speed(2.0);
  const auto begin = std::chrono::steady_clock::now();
  worker.set_playing(true);
  ASSERT_TRUE(watcher.wait([](const Frame& f) { return f.time > 0.4; }));
  EXPECT_GT(std::chrono::steady_clock::now() - begin, 150ms);
  worker.set_playing(false);
  ASSERT_TRUE(watcher.wait([](const Frame& f) { return !f.playing; }));
  const std::int64_t steps = watcher.last.steps;
  std::this_thread::sleep_for(50ms);
  EXPECT_EQ(worker.take_frame(), nullptr);
  worker.step_once();
  ASSERT_TRUE(watcher.wait([&](const Frame& f) { return f.steps == steps + 1; }));
  worker.restart();
  ASSERT_TRUE(watcher.wait([](const Frame& f) { return f.steps == 0 && f.time == 0.0; }));
  EXPECT_EQ(watcher.last.run, 2U);
  EXPECT_FALSE(watcher.last.playing);
}

TEST(Worker, ChangesTheMethodAndTakesBodies) {
  const Scene s = small_gas();
  Worker worker(s);
  Watcher watcher(worker);
  const Method method{IntegratorId::kSemiImplicitEuler, ImpactsId::kStepEnd, ContactsId::kImpulse, 0.01};
  worker.set_method(method);
  const Body body = disc("new", {0.0, -0.5}, {1.0, 1.0}, 0.05);
  worker.add_body(body);
  worker.run_until(2.0);
  ASSERT_TRUE(watcher.wait([](const Frame& f) { return !f.playing && f.steps > 0; }));
  Simulation plain(s);
  plain.set_method(method);
  plain.add_body(body);
  plain.advance_to(2.0);
  EXPECT_TRUE(test::same_bytes(watcher.last.state, plain.state()));
  EXPECT_EQ(worker.scene().method, method);
  EXPECT_EQ(worker.scene().bodies.back().name, "new");
  worker.restart();
  ASSERT_TRUE(watcher.wait([](const Frame& f) { return f.steps == 0; }));
  EXPECT_EQ(watcher.last.state.size(), 9);
}

// The measured pace belongs to the time since playing began: not to a pause, nor to the run before.
TEST(Worker, RealisedSpeedIsOfThisRun) {
  Worker worker(small_gas());
  Watcher watcher(worker);
  worker.set_speed(20.0);
  worker.set_playing(true);
  ASSERT_TRUE(watcher.wait([](const Frame& f) { return f.realised_speed > 0.0; }));
  worker.set_playing(false);
  worker.set_speed(1.0);
  std::this_thread::sleep_for(600ms);
  worker.restart();
  worker.set_playing(true);
  ASSERT_TRUE(watcher.wait([](const Frame& f) {
    if (f.run == 2 && f.realised_speed != 0.0) {
      EXPECT_GT(f.realised_speed, 0.5);
      EXPECT_LT(f.realised_speed, 1.5);
    }
    return f.run == 2 && f.time > 0.7;
  }));
  EXPECT_GT(watcher.last.realised_speed, 0.0);
}

TEST(Worker, IsDestroyedWhilePlaying) {
  for (int i = 0; i < 20; ++i) {
    Worker worker(small_gas());
    worker.set_playing(true);
    if (i % 2 == 0) worker.run_until(1e6);
    if (i % 3 == 0) std::this_thread::sleep_for(5ms);
  }
}

TEST(Worker, TakesACrowdOfCommands) {
  Worker worker(small_gas());
  Watcher watcher(worker);
  worker.set_playing(true);
  for (int i = 0; i < 200; ++i) {
    if (i % 5 == 0) worker.load(small_gas());
    if (i % 7 == 0) worker.restart();
    worker.set_playing(i % 3 != 0);
    worker.step_once();
    (void)worker.scene();
  }
  worker.restart();
  worker.run_until(1.0);
  ASSERT_TRUE(watcher.wait([](const Frame& f) { return !f.playing && f.time > 0.9; }));
  EXPECT_EQ(watcher.last.steps, 200);
}

TEST(Recorder, IsBoundedKeepsSpikesAndSaysSo) {
  Recorder recorder;
  Frame frame;
  frame.run = 1;
  frame.samples.resize(kMostSamples / 4);
  frame.impacts.resize(kMostImpacts / 4);
  double time = 0.0;
  for (int i = 0; i < 12; ++i) {
    for (Sample& s : frame.samples) s.time = time++;
    // One sample and one impact stand out, in the first frame only.
    frame.samples[1234].totals.translational = i == 0 ? 7.0 : 0.0;
    frame.impacts[4321].normal_impulse = i == 0 ? 3.0 : 0.0;
    recorder.add(frame);
    EXPECT_LE(recorder.samples().size(), kMostSamples);
    EXPECT_LE(recorder.impacts().size(), kMostImpacts);
    EXPECT_EQ(recorder.samples().back().time, time - 1.0);
    EXPECT_EQ(recorder.complete(), i < 4);
  }
  EXPECT_GE(recorder.samples().size(), kMostSamples / 2);
  EXPECT_EQ(recorder.samples().front().time, 0.0);
  double largest = 0.0;
  for (std::size_t i = 1; i < recorder.samples().size(); ++i) {
    ASSERT_GT(recorder.samples()[i].time, recorder.samples()[i - 1].time);
    largest = std::max(largest, recorder.samples()[i].totals.kinetic());
  }
  EXPECT_EQ(largest, 7.0);
  EXPECT_EQ(std::count_if(recorder.impacts().begin(), recorder.impacts().end(),
                          [](const ImpactRecord& r) { return r.normal_impulse == 3.0; }),
            1);
  frame.impacts.resize(10);
  frame.run = 2;
  frame.samples.resize(3);
  recorder.add(frame);
  EXPECT_EQ(recorder.samples().size(), 3U);
  EXPECT_EQ(recorder.impacts().size(), 10U);
  EXPECT_TRUE(recorder.complete());
}

}  // namespace
}  // namespace carom
