#include <chrono>
#include <gtest/gtest.h>
#include <thread>

#include "physics/preset/preset.h"
#include "physics/session/worker.h"
#include "tests/support/heap.h"
#include "tests/support/scenes.h"
#include "tests/support/wait.h"

// What stops a worker's runs: a loss, an error, and whoever asks for others.
namespace carom {
namespace {

using namespace std::chrono_literals;
using test::disc;

// The newest frame for which `fulfilled` holds; nullptr if none comes in a minute.
template <class Condition>
std::shared_ptr<const Frame> wait_for(Worker& worker, const Condition& fulfilled) {
  std::shared_ptr<const Frame> found;
  (void)test::wait_until([&] {
    for (const auto& frame : worker.take_frames()) {
      if (!found && fulfilled(*frame)) found = frame;
    }
    return found != nullptr;
  });
  return found;
}

Preset quiet() { return test::preset_with({disc("a", {0, 0}, {1, 0})}); }

TEST(WorkerStops, PausesWhereARunIsLost) {
  Preset s = quiet();
  Spring spring;
  spring.body = "a";
  spring.stiffness = 1e6;
  s.scene.forces.springs = {spring};
  s.method = {.integrator = IntegratorId::kRk4, .step = 0.005};
  Worker worker(s);
  worker.run_until(5.0);
  const auto lost = wait_for(worker, [](const Frame& f) { return f.lost.has_value(); });
  ASSERT_TRUE(lost);
  EXPECT_FALSE(lost->playing);
  EXPECT_TRUE(lost->state.q.allFinite());
  EXPECT_NE(lost->status.find("lost at t = "), std::string::npos);
  worker.set_playing(true);
  worker.step_once();
  worker.restart();
  const auto again = wait_for(worker, [](const Frame& f) { return f.steps == 0; });
  ASSERT_TRUE(again);
  EXPECT_FALSE(again->lost);
}

TEST(WorkerStops, SaysWhatAnErrorWas) {
  Preset s = quiet();
  s.scene.bodies[0].material = "unknown";  // no valid scene
  Worker worker(s);
  const auto failed = wait_for(worker, [](const Frame& f) { return f.lost.has_value(); });
  ASSERT_TRUE(failed);
  EXPECT_NE(failed->lost->find("unknown"), std::string::npos);
  EXPECT_FALSE(failed->playing);
  worker.set_playing(true);
  worker.add_body(disc("b", {1, 0}, {0, 0}));
  worker.load(quiet());
  worker.step_once();
  const auto after = wait_for(worker, [](const Frame& f) { return f.steps == 1; });
  ASSERT_TRUE(after);
  EXPECT_FALSE(after->lost);
}

// A step of seconds: another scene comes at once, and so does the end.
TEST(WorkerStops, LeavesAStepThatTakesLong) {
  const RunSetup heap = test::heap(100, 100, 1.0);
  Preset heavy;
  heavy.scene = heap.scene;
  heavy.method = heap.method;
  Worker worker(heavy);
  worker.set_playing(true);
  std::this_thread::sleep_for(100ms);
  worker.load(quiet());
  worker.step_once();
  EXPECT_TRUE(wait_for(worker, [](const Frame& f) { return f.steps == 1 && f.bodies->size() == 1; }));
  worker.load(heavy);
  worker.set_playing(true);
  std::this_thread::sleep_for(100ms);
}

}  // namespace
}  // namespace carom
