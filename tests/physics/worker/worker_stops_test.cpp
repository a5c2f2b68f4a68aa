#include <gtest/gtest.h>
#include <thread>

#include "physics/preset/preset.h"
#include "physics/worker/worker.h"
#include "tests/support/heap.h"
#include "tests/support/scenes.h"
#include "tests/support/threads.h"
#include "tests/support/wait.h"

// What stops a worker's runs: a loss, an error, and whoever asks for others.
namespace carom {
namespace {

using test::disc;

// The newest frame for which `fulfilled` holds; nullptr if none comes.
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
  worker.restart(s);
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
  worker.edit_scene({Add<Body>{disc("b", {1, 0}, {0, 0})}});
  worker.load(quiet());
  worker.step_once();
  const auto after = wait_for(worker, [](const Frame& f) { return f.steps == 1; });
  ASSERT_TRUE(after);
  EXPECT_FALSE(after->lost);
}

// A step of a second: another scene comes at once, and so does the end. Both cost the processor next to nothing
// beside the step; its time counts here, and not that on the wall.
TEST(WorkerStops, LeavesAStepThatTakesLong) {
  const RunSetup heap = test::heap(20, 20, 1.0);
  Preset heavy;
  heavy.scene = heap.scene;
  heavy.method = heap.method;
  double before = test::work_of_other_threads();
  std::jthread([&] { Simulation(heap).step(); }).join();
  const double whole = test::work_of_other_threads() - before;

  {
    Worker worker(heavy);
    const auto begin_step = [&] {
      ASSERT_TRUE(wait_for(worker, [](const Frame& f) { return f.steps == 0 && f.bodies->size() > 1; }));
      worker.set_playing(true);
      ASSERT_TRUE(test::wait_for_work_of_other_threads());
      before = test::work_of_other_threads();
    };
    ASSERT_NO_FATAL_FAILURE(begin_step());
    worker.load(quiet());
    worker.step_once();
    EXPECT_TRUE(wait_for(worker, [](const Frame& f) { return f.steps == 1 && f.bodies->size() == 1; }));
    EXPECT_LT(test::work_of_other_threads() - before, 0.3 * whole);
    worker.load(heavy);
    ASSERT_NO_FATAL_FAILURE(begin_step());
  }
  EXPECT_LT(test::work_of_other_threads() - before, 0.3 * whole);
}

}  // namespace
}  // namespace carom
