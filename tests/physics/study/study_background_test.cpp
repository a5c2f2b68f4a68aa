#include <cmath>
#include <gtest/gtest.h>
#include <map>
#include <stop_token>
#include <thread>

#include "physics/check/measure_run.h"
#include "physics/compare/reference.h"
#include "physics/math/cancelled.h"
#include "physics/preset/preset.h"
#include "physics/preset/preset_file.h"
#include "physics/scene/validate.h"
#include "physics/study/study.h"
#include "tests/support/scenes.h"
#include "tests/support/source_folder.h"
#include "tests/support/threads.h"
#include "tests/support/wait.h"

namespace carom {
namespace {

// A disc on a spring.
Preset spring_scene() {
  Preset s = test::preset_with({test::disc("disc", {1.0, 0.0}, Vec2::Zero())});
  s.scene.forces.springs.push_back({"", "disc", "", Vec2::Zero(), 25.0, 0.0, 0.0, SpringActs::kBoth});
  s.method.step = 0.05;
  s.duration = 3.0;
  return s;
}

StudyOptions quick() {
  StudyOptions o;
  o.integrators = {IntegratorId::kExplicitEuler, IntegratorId::kRk4};
  o.steps = {0.08, 0.04, 0.02, 0.01};
  o.repeats = 1;
  return o;
}

constexpr std::size_t kRowsOfQuick = 4;  // at each step

std::string csv_of(const StudyTable& table) {
  std::string out;
  for (const std::string& line : study_csv(table)) out += line + '\n';
  return out;
}

std::string without_times(StudyTable table) {
  for (StudyRow& row : table.rows) row.wall_time = row.wall_least = row.wall_most = 0.0;
  return csv_of(table);
}

// --- followed and stopped

TEST(Study, RowsThatComeOnTheWayAreTheTables) {
  const Preset s = read_preset(test::preset_file("numerical-methods/drag-projectile.json"));
  StudyOptions o = quick();
  o.repeats = 3;
  o.threads = 3;
  std::map<int, std::vector<StudyRow>> seen;
  StudyTable followed;
  StudyCallbacks watch;
  watch.row = [&](const StudyFacts& facts, const StudyRow& row) {
    seen[row.index].push_back(row);
    followed.facts = facts;
  };
  const StudyTable table = run_study(s, "drag-projectile", o, watch);
  ASSERT_EQ(seen.size(), table.rows.size());
  for (const auto& [index, rows] : seen) {
    ASSERT_EQ(rows.size(), 4U) << index;  // without a time, then after each repeat
    EXPECT_TRUE(std::isnan(rows[0].wall_time)) << index;
    EXPECT_EQ(rows[1].wall_least, rows[1].wall_most) << index;
    followed.rows.push_back(rows.back());
  }
  EXPECT_EQ(csv_of(followed), csv_of(table));
  EXPECT_EQ(without_times(run_study(s, "drag-projectile", o)), without_times(table));
}

// The system lists a thread for a moment after it has been joined.
void expect_no_more_threads_than(std::size_t before) {
  EXPECT_TRUE(test::wait_until([before] { return test::threads_of_this_process() <= before; }));
}

// Runs what would take hours, asks it to stop from another thread once it is under way, and expects it to end
// without a result.
template <class Work>
void expect_to_stop(const Work& work) {
  const std::size_t before = test::threads_of_this_process();
  {
    std::stop_source stop;
    const std::jthread asking([&stop] {
      EXPECT_TRUE(test::wait_for_work_of_other_threads());
      stop.request_stop();
    });
    EXPECT_THROW(work(stop.get_token()), Cancelled);
  }
  expect_no_more_threads_than(before);
}

constexpr double kAges = 1e11;  // s, simulated: 2e12 steps

TEST(Study, StopsWithinARun) {
  Preset s = spring_scene();
  const Method m = study_reference_method(setup_of(s));
  const Chaos chaos = follow_neighbours(setup_of(s), m, 3.0, 1);
  expect_to_stop([&](const std::stop_token& stop) { (void)follow_neighbours(setup_of(s), m, kAges, 2, stop); });
  expect_to_stop(
      [&](const std::stop_token& stop) { (void)make_reference(setup_of(s), chaos, kAges, kAges, stop); });
  Expectation late;
  late.reduction = Expectation::Reduction::kAt;
  late.observable = "x";
  late.bodies = {"disc"};
  late.time = kAges;
  expect_to_stop([&](const std::stop_token& stop) { (void)measure_run(s, {late}, stop); });
  StudyOptions o = quick();
  o.steps = {kLeastStep};
  o.threads = 3;
  expect_to_stop([&](const std::stop_token& stop) {
    StudyCallbacks watch;
    watch.stop = stop;
    (void)run_study(s, "spring", o, watch);
  });
}

TEST(Study, StopsBetweenRuns) {
  const Preset s = spring_scene();
  StudyOptions o = quick();
  o.threads = 2;
  for (const std::string_view last : {"neighbours", "reference", "accuracy", "times, alone"}) {
    std::stop_source stop;
    std::vector<std::string> stages;
    int times = 0;
    StudyCallbacks watch;
    watch.stop = stop.get_token();
    watch.progress = [&](std::string_view stage, int, int) {
      if (stages.empty() || stages.back() != stage) stages.emplace_back(stage);
      if (stage == last) stop.request_stop();
    };
    watch.row = [&](const StudyFacts&, const StudyRow& row) { times += std::isnan(row.wall_time) ? 0 : 1; };
    EXPECT_THROW((void)run_study(s, "spring", o, watch), Cancelled) << last;
    EXPECT_EQ(stages.back(), last);
    EXPECT_EQ(times, last == "times, alone" ? 1 : 0);
  }
}

// --- in the background

StudySoFar wait_for_its_end(const BackgroundStudy& study) {
  EXPECT_TRUE(test::wait_until([&] { return study.so_far().phase != StudySoFar::Phase::kRunning; }));
  return study.so_far();
}

TEST(Study, InTheBackgroundIsTheSame) {
  const BackgroundStudy study(spring_scene(), "spring", quick());
  const StudySoFar end = wait_for_its_end(study);
  EXPECT_EQ(end.phase, StudySoFar::Phase::kDone);
  EXPECT_EQ(end.refusal, "");
  EXPECT_EQ(without_times(end.table), without_times(run_study(spring_scene(), "spring", quick())));
  for (const StudyRow& row : end.table.rows) EXPECT_FALSE(std::isnan(row.wall_time)) << row.index;
}

TEST(Study, InTheBackgroundStopsAndKeepsWhatItHas) {
  StudyOptions o = quick();
  o.steps = {0.02, kLeastStep};
  o.threads = 2 * kRowsOfQuick;
  BackgroundStudy study(spring_scene(), "spring", o);
  EXPECT_TRUE(test::wait_until([&] { return study.so_far().table.rows.size() >= kRowsOfQuick; }));
  study.stop();
  const StudySoFar end = wait_for_its_end(study);
  EXPECT_EQ(end.phase, StudySoFar::Phase::kCancelled);
  ASSERT_EQ(end.table.rows.size(), kRowsOfQuick);
  for (const StudyRow& row : end.table.rows) EXPECT_EQ(row.method.step, 0.02);
}

TEST(Study, InTheBackgroundLeavesNoThreadBehind) {
  const std::size_t before = test::threads_of_this_process();
  StudyOptions o = quick();
  o.steps = {kLeastStep};
  {
    const BackgroundStudy study(spring_scene(), "spring", o);
    EXPECT_TRUE(test::wait_until([&] { return study.so_far().stage == "accuracy"; }));
    EXPECT_GT(test::threads_of_this_process(), before);
  }
  expect_no_more_threads_than(before);
}

TEST(Study, InTheBackgroundSaysWhyItCannotBe) {
  StudyOptions o = quick();
  o.integrators = {IntegratorId::kExactFlight};
  const BackgroundStudy study(spring_scene(), "spring", o);
  const StudySoFar end = wait_for_its_end(study);
  EXPECT_EQ(end.phase, StudySoFar::Phase::kRefused);
  EXPECT_NE(end.refusal.find("spring"), std::string::npos) << end.refusal;
}

}  // namespace
}  // namespace carom
