#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

#include "physics/preset/preset.h"
#include "physics/record/recorder.h"
#include "physics/worker/worker.h"
#include "tests/support/scenes.h"
#include "tests/support/wait.h"

// A worker's first run halts where it meets a stop, and goes on as if there were none.
namespace carom {
namespace {

using test::disc;
using test::wall;

constexpr double kG = 9.81;

// A ball of radius 0.1 m, 1 m above a floor from which it comes back with 0.8 of its speed.
Preset dropped(const std::vector<std::string>& sentences, const Method& method,
               std::vector<Method> compare = {}) {
  Preset preset;
  preset.scene =
      test::setup_with({wall("floor", {0.0, -0.5}, 10.0, 1.0), disc("ball", {0.0, 1.1}, {0.0, 0.0})}, 0.8)
          .scene;
  preset.scene.forces.gravity = {0.0, -kG};
  preset.method = method;
  preset.compare = std::move(compare);
  for (const std::string& sentence : sentences) preset.stops.push_back(stop_of("stop", sentence));
  return preset;
}

const Method kRk4{.step = 0.01};

class Watched {
 public:
  explicit Watched(const Preset& preset) : worker_(preset) { worker_.set_speed(100.0); }

  // Plays until the run stands still with a halt, or at 3 s.
  std::optional<Halt> play() {
    const std::uint64_t before = newest_.empty() || !newest_.front()->halt ? 0 : newest_.front()->halt->number;
    worker_.set_playing(true, kEnd);
    EXPECT_TRUE(wait_for([&] {
      const Frame& now = *newest_.front();
      const bool halts = now.halt && now.halt->number > before;
      return !now.playing && (halts || now.time + now.method.step > kEnd);
    }));
    return newest_.front()->halt;
  }
  template <class Condition>
  bool wait_for(const Condition& fulfilled) {
    return test::wait_until([&] {
      const auto news = worker_.take_frames();
      if (!news.empty()) {
        newest_ = news;
        recorder_.add(*news.front());
      }
      return !newest_.empty() && fulfilled();
    });
  }
  std::vector<std::shared_ptr<const Frame>> shown(const MetStop& met) {
    const std::uint64_t number = worker_.show({.time = met.step_start, .part = met.part});
    Worker::Shown shown;
    EXPECT_TRUE(test::wait_until([&] {
      shown = worker_.take_shown();
      return shown.there && shown.number == number;
    }));
    return shown.frames;
  }
  [[nodiscard]] Worker& worker() { return worker_; }
  [[nodiscard]] const Frame& newest() const { return *newest_.front(); }
  [[nodiscard]] const Recorder& recorder() const { return recorder_; }

  static constexpr double kEnd = 3.0;  // s

 private:
  Worker worker_;
  std::vector<std::shared_ptr<const Frame>> newest_;
  Recorder recorder_;
};

const double kFall = std::sqrt(2.0 / kG);  // s, to the floor

TEST(WorkerHalts, AtTheBounceToTheLastDigits) {
  for (const IntegratorId integrator :
       {IntegratorId::kRk4, IntegratorId::kVelocityVerlet, IntegratorId::kExactFlight}) {
    Watched run(dropped({"at the 2nd impact of ball with a wall"}, {.integrator = integrator, .step = 0.01}));
    const std::optional<Halt> halt = run.play();
    ASSERT_TRUE(halt);
    const double second = kFall * (1.0 + 2.0 * 0.8);
    EXPECT_NEAR(halt->at.time, second, 1e-9);
    const auto at = run.shown(halt->at);
    EXPECT_EQ(at.front()->time, halt->at.time);
    EXPECT_EQ(at.front()->impact_count, 2);
    EXPECT_NEAR(at.front()->state.q(1, 1), 0.1, 1e-9);
    EXPECT_NEAR(at.front()->state.v(1, 1), 0.64 * kG * kFall, 1e-9) << "just after it";
    EXPECT_NE(at.front()->scene, nullptr) << "for edits";
    EXPECT_LT(run.newest().time, second + 0.011) << "the run itself stands at the end of the step";
    EXPECT_FALSE(run.play()) << "it plays on to the end";
    EXPECT_GT(run.newest().time, 2.98);
  }
}

TEST(WorkerHalts, TheRunHasTheDigitsOfOneWithoutStops) {
  const std::vector<std::string> all = {"at every impact", "when ball passes y = 0.5 m", "at 1.2345 s",
                                        "when K falls below 1 J"};
  for (const ImpactsId impacts : {ImpactsId::kLocated, ImpactsId::kStepEnd}) {
    const Method method{.impacts = impacts, .step = 0.01};
    Watched run(dropped(all, method));
    int halts = 0;
    while (run.play()) ++halts;
    EXPECT_GT(halts, 8);
    Simulation without(setup_of(dropped({}, method)));
    while (without.steps() < run.newest().steps) without.step();
    EXPECT_TRUE(test::same_bytes(run.newest().state, without.state()));
    EXPECT_EQ(run.newest().impact_count, without.impact_count());
    EXPECT_TRUE(std::is_sorted(run.recorder().met().begin(), run.recorder().met().end(),
                               [](const MetStop& a, const MetStop& b) { return a.time < b.time; }));
  }
}

TEST(WorkerHalts, AStopAndAnImpactInOneStep) {
  // The ball passes the height just above the floor on its way down and up, within one step of 0.1 s.
  Watched run(dropped({"at every impact", "when ball passes y = 0.11 m"}, {.step = 0.1}));
  const std::optional<Halt> halt = run.play();
  ASSERT_TRUE(halt);
  ASSERT_GE(run.recorder().met().size(), 3U);
  const std::vector<MetStop> met(run.recorder().met().begin(), run.recorder().met().begin() + 3);
  const double down = std::sqrt(2.0 * 0.99 / kG);
  EXPECT_NEAR(met[0].time, down, 1e-9);
  EXPECT_EQ(met[0].stop, 1U);
  EXPECT_EQ(halt->at.time, met[0].time) << "the first one";
  EXPECT_NEAR(met[1].time, kFall, 1e-9);
  EXPECT_EQ(met[1].stop, 0U);
  const double back = 0.8 * kG * kFall;
  EXPECT_NEAR(met[2].time, kFall + (back - std::sqrt(back * back - 2.0 * kG * 0.01)) / kG, 1e-9);
  EXPECT_EQ(run.shown(met[0]).front()->impact_count, 0);
  EXPECT_NEAR(run.shown(met[0]).front()->state.q(1, 1), 0.11, 1e-9);
  EXPECT_EQ(run.shown(met[1]).front()->impact_count, 1);
  EXPECT_NEAR(run.shown(met[2]).front()->state.q(1, 1), 0.11, 1e-9);
}

TEST(WorkerHalts, ComparedRunsStandAtTheSameMoment) {
  Watched run(
      dropped({"at the 1st impact"}, kRk4, {{.integrator = IntegratorId::kExplicitEuler, .step = 0.007}}));
  const std::optional<Halt> halt = run.play();
  ASSERT_TRUE(halt);
  const auto at = run.shown(halt->at);
  ASSERT_EQ(at.size(), 2U);
  EXPECT_NEAR(at[1]->time, kFall, 1e-9);
  EXPECT_EQ(at[1]->impact_count, 0) << "Euler falls later";
}

TEST(WorkerHalts, StopsThatComeLaterAreMetFromTheStartOn) {
  Watched run(dropped({}, kRk4));
  run.worker().run_until(2.0);
  ASSERT_TRUE(run.wait_for([&] { return !run.newest().playing && run.newest().time > 1.98; }));
  run.worker().watch_stops({stop_of("", "at the 2nd impact"), stop_of("", "at 2.5 s")});
  ASSERT_TRUE(run.wait_for([&] { return run.recorder().met().size() == 1; }));
  EXPECT_NEAR(run.recorder().met().front().time, kFall * 2.6, 1e-9);
  const std::optional<Halt> halt = run.play();
  ASSERT_TRUE(halt);
  EXPECT_EQ(halt->at.stop, 1U);
  EXPECT_NEAR(halt->at.time, 2.5, 1e-12);
  run.worker().watch_stops({});
  ASSERT_TRUE(run.wait_for([&] { return run.recorder().met().empty(); }));
}

TEST(WorkerHalts, AnUndoneEditIsMetNoMore) {
  Watched run(dropped({"at every impact"}, kRk4));
  run.worker().run_until(0.6);
  ASSERT_TRUE(run.wait_for([&] { return !run.newest().playing && run.newest().time > 0.58; }));
  const auto edit = run.worker().edit_scene({SetForces{}});  // without gravity it rises for ever
  run.worker().run_until(2.0);
  ASSERT_TRUE(run.wait_for([&] { return !run.newest().playing && run.newest().time > 1.98; }));
  EXPECT_EQ(run.recorder().met().size(), 1U);
  run.worker().undo_or_redo(edit, dropped({"at every impact"}, kRk4), ReferenceId::kNone);
  ASSERT_TRUE(run.wait_for([&] { return !run.newest().replay_until && run.recorder().met().size() > 2; }));
  EXPECT_NEAR(run.recorder().met()[1].time, kFall * 2.6, 1e-9);
  EXPECT_EQ(static_cast<std::int64_t>(run.recorder().met().size()), run.newest().impact_count);
}

TEST(WorkerHalts, AtFullSpeedItGoesThrough) {
  Watched run(dropped({"at every impact"}, kRk4));
  run.worker().run_until(2.0);
  ASSERT_TRUE(run.wait_for([&] { return !run.newest().playing && run.newest().time > 1.98; }));
  EXPECT_FALSE(run.newest().halt);
  EXPECT_EQ(static_cast<std::int64_t>(run.recorder().met().size()), run.newest().impact_count);
}

}  // namespace
}  // namespace carom
