#include <chrono>
#include <cmath>
#include <gtest/gtest.h>
#include <thread>

#include "physics/preset/preset.h"
#include "physics/record/recorder.h"
#include "physics/worker/worker.h"
#include "tests/support/body_literal.h"
#include "tests/support/lags.h"
#include "tests/support/scenes.h"
#include "tests/support/wait.h"

namespace carom {
namespace {

using namespace test::literals;

using namespace std::chrono_literals;
using test::disc;
using test::room;

Curve curve(const char* observable, std::initializer_list<int> bodies = {}) {
  return {{find_observable(observable), {bodies.begin(), bodies.end()}}, std::nullopt};
}

Method method(IntegratorId integrator, ImpactsId impacts, double step) {
  Method m;
  m.integrator = integrator;
  m.impacts = impacts;
  m.step = step;
  return m;
}

// Drag and springs between walls: every method has an error of its own.
Preset crowd() {
  std::vector<Body> bodies = room(1.0, 0.5);
  for (int i = 0; i < 5; ++i) {
    bodies.push_back(
        disc("disc " + std::to_string(i), {-0.6 + 0.3 * i, 0.1 * i - 0.2}, {1.0 - 0.7 * i, 0.3 * i}));
  }
  Preset s = test::preset_with(std::move(bodies), 0.95, 0.1);
  s.scene.forces.gravity = {0.0, -9.81};
  s.scene.forces.linear_drag = 0.1;
  s.method = method(IntegratorId::kRk4, ImpactsId::kLocated, 0.004);
  return s;
}

// x(t) = cos 5t.
Preset oscillator(const Method& m) {
  Preset s = test::preset_with({disc("disc", {1.0, 0.0}, Vec2::Zero())});
  s.scene.forces.springs.push_back({"", "disc", "", Vec2::Zero(), 25.0, 0.0, 0.0, SpringActs::kBoth});
  s.scene.bodies[0].mass = 1.0;
  s.method = m;
  return s;
}

// What a window would hold of the runs of a worker.
struct Window {
  explicit Window(Worker& w) : worker(w) {}

  template <class Condition>
  bool wait(const Condition& condition) {
    return test::wait_until([&] {
      const auto news = worker.take_frames();
      if (news.empty()) return false;
      frames = news;
      recorders.resize(frames.size());
      for (std::size_t i = 0; i < frames.size(); ++i) recorders[i].add(*frames[i]);
      return condition();
    });
  }
  bool wait_until_all_stand() {
    return wait([this] {
      for (const auto& frame : frames) {
        if (test::lags(*frame, *frames[0]) || frame->playing || frame->rows_known_until < frame->time)
          return false;
      }
      return frames[0]->steps > 0;
    });
  }

  Worker& worker;
  std::vector<std::shared_ptr<const Frame>> frames;
  std::vector<Recorder> recorders;
};

std::vector<SeriesPoint<1>> points(const Recorder& recorder, const Curve& c) {
  std::vector<SeriesPoint<1>> all;
  if (const Series<1>* series = recorder.series(c)) series->read(-1.0, 1e9, all);
  return all;
}

// --- side by side

TEST(ComparedRuns, EachHasTheBytesThatItHasAlone) {
  const std::vector<Method> methods = {
      method(IntegratorId::kRk4, ImpactsId::kLocated, 0.004),
      method(IntegratorId::kExplicitEuler, ImpactsId::kStepEnd, 0.01),
      method(IntegratorId::kAdaptiveDormandPrince, ImpactsId::kLocated, 0.003),
      method(IntegratorId::kVelocityVerlet, ImpactsId::kStepEnd, 0.0007),
  };
  const std::vector<Curve> curves = {curve("kinetic_energy"), curve("y", {5}), curve("impacts")};
  Preset s = crowd();
  s.compare = {methods[1], methods[2]};
  Worker worker(s, curves);
  worker.run_until(1.0);
  worker.add_method(methods[3]);  // in the midst of it
  worker.run_until(4.0);
  Window window(worker);
  ASSERT_TRUE(window.wait([&] {
    return window.frames.size() == 4 && !window.frames[0]->playing && window.frames[3]->time > 3.99;
  }));
  for (std::size_t i = 0; i < methods.size(); ++i) {
    Preset alone = crowd();
    alone.method = methods[i];
    Worker single(alone, curves);
    single.run_until(4.0);
    Window other(single);
    ASSERT_TRUE(other.wait([&] { return !other.frames[0]->playing && other.frames[0]->steps > 0; }));
    EXPECT_EQ(window.frames[i]->steps, other.frames[0]->steps) << i;
    EXPECT_TRUE(test::same_bytes(window.frames[i]->state, other.frames[0]->state)) << i;
    EXPECT_EQ(window.frames[i]->impact_count, other.frames[0]->impact_count) << i;
    for (const Curve& c : curves) {
      EXPECT_EQ(points(window.recorders[i], c), points(other.recorders[0], c)) << i;
    }
  }
}

TEST(ComparedRuns, TakeBodiesAndMethodsAndGo) {
  Preset s = crowd();
  s.compare = {method(IntegratorId::kExplicitEuler, ImpactsId::kLocated, 0.01)};
  Worker worker(s);
  worker.run_until(0.5);
  Window window(worker);
  ASSERT_TRUE(window.wait_until_all_stand());
  worker.edit_scene({Add<Body>{disc("new", {0.0, 0.3}, Vec2::Zero())}});
  worker.set_method(method(IntegratorId::kExplicitEuler, ImpactsId::kLocated, 0.002), 1);
  worker.add_method(method(IntegratorId::kVelocityVerlet, ImpactsId::kLocated, 0.03));
  worker.run_until(1.0);
  ASSERT_TRUE(window.wait([&] { return window.frames.size() == 3 && window.frames[2]->time > 0.95; }));
  for (const auto& frame : window.frames) {
    EXPECT_EQ(frame->bodies->back().name, "new");
    EXPECT_EQ(frame->state.size(), static_cast<int>(frame->bodies->size()));
  }
  // It came at its time, where a step ends.
  Simulation again(*window.frames[2]->setup);
  for (int i = 0; i < 17; ++i) again.step();
  EXPECT_DOUBLE_EQ(again.time(), 0.5);
  EXPECT_EQ(again.bodies().size(), crowd().scene.bodies.size());
  ASSERT_NE(again.due(), nullptr);
  EXPECT_TRUE(std::holds_alternative<SceneEdits>(again.due()->what));
  EXPECT_EQ(window.frames[1]->method.step, 0.002);
  worker.remove_method(1);
  ASSERT_TRUE(window.wait([&] { return window.frames.size() == 2; }));
  EXPECT_EQ(window.frames[1]->method.integrator, IntegratorId::kVelocityVerlet);
  s.compare = {window.frames[1]->method};
  worker.restart(s);
  ASSERT_TRUE(window.wait([&] { return window.frames[0]->steps == 0; }));
  EXPECT_EQ(window.frames.size(), 2U);
  for (std::size_t i = 0; i < 2 * kMostCompared; ++i) worker.add_method(s.method);
  ASSERT_TRUE(window.wait([&] { return window.frames.size() == 1 + kMostCompared; }));
}

TEST(ComparedRuns, FollowASingleStepOfTheFirst) {
  Preset s = crowd();
  s.compare = {method(IntegratorId::kRk4, ImpactsId::kLocated, 0.001)};
  Worker worker(s);
  worker.step_once();
  Window window(worker);
  ASSERT_TRUE(window.wait([&] { return window.frames[0]->steps == 1 && window.frames[1]->steps == 4; }));
}

// --- against a reference

// The error that is told is the distance from the closed form, to the reference's own uncertainty.
TEST(ComparedRuns, ShowTheErrorAgainstAClosedForm) {
  const Curve error = curve("position_error");
  const Curve x = curve("x", {0});
  const Preset s = oscillator(method(IntegratorId::kExplicitEuler, ImpactsId::kLocated, 0.01));
  Worker worker(s);
  worker.load(s, {error, x}, ReferenceId::kRefined);
  worker.run_until(3.0);
  Window window(worker);
  ASSERT_TRUE(window.wait_until_all_stand());
  const auto errors = points(window.recorders[0], error);
  const auto places = points(window.recorders[0], x);
  ASSERT_EQ(errors.size(), 301U);
  ASSERT_EQ(places.size(), errors.size());
  const RunError& end = *window.frames[0]->error;
  EXPECT_LT(end.uncertainty, 1e-8);
  EXPECT_GT(end.uncertainty, 1e-14);
  double largest = 0.0;
  for (std::size_t i = 0; i < errors.size(); ++i) {
    const double exact = std::cos(5.0 * errors[i].at);
    EXPECT_NEAR(errors[i].value[0], std::abs(places[i].value[0] - exact), 1e-10) << i;
    largest = std::max(largest, errors[i].value[0]);
  }
  EXPECT_GT(largest, 0.1);
  EXPECT_EQ(end.position, errors.back().value[0]);
  EXPECT_EQ(end.largest_position, largest);
  const double energy = 12.5;
  EXPECT_NEAR(end.energy, window.frames[0]->totals.energy() - energy, 1e-9);
}

// The same of an angle, which counts at the outline.
TEST(ComparedRuns, TellTheErrorOfAnAngle) {
  Preset s = test::preset_with({disc("wheel", {0.0, 0.0}, Vec2::Zero(), 0.5, 2.0)});
  s.scene.forces.applied.push_back({"wheel", Vec2::Zero(), 0.5, 0.0, 0.0, std::nullopt});
  s.method = method(IntegratorId::kExplicitEuler, ImpactsId::kLocated, 0.01);
  Worker worker(s);
  const Curve angle = curve("angle_error");
  const Curve spin = curve("body_spin_error", {0});
  worker.load(s, {angle, spin}, ReferenceId::kRefined);
  worker.run_until(3.0);
  Window window(worker);
  ASSERT_TRUE(window.wait_until_all_stand());
  const RunError& end = *window.frames[0]->error;
  // α = 2 rad/s²: the angle is α h t/2 behind.
  EXPECT_NEAR(end.angle, 0.5 * 2.0 * 0.01 * 3.0 / 2.0, 1e-11);
  EXPECT_EQ(end.largest_angle, end.angle);
  EXPECT_EQ(end.position, 0.0);
  EXPECT_LT(end.spin, 1e-12);
  EXPECT_EQ(points(window.recorders[0], angle).back().value[0], end.angle);
  EXPECT_EQ(points(window.recorders[0], spin).back().value[0], end.spin);
}

// An impact at the step's end comes late; until it has come in both runs the body is left out.
TEST(ComparedRuns, MatchImpacts) {
  Preset s = test::preset_with({disc("wall", {1.05, 0.0}, Vec2::Zero()), disc("disc", {0.0, 0.0}, {1.0, 0.0})});
  s.scene.bodies[0].fixed = true;
  s.scene.bodies[0].mass.reset();
  const double reach =
      1.05 - std::get<Disc>(s.scene.bodies[0].shape).radius - std::get<Disc>(s.scene.bodies[1].shape).radius;
  s.method = method(IntegratorId::kRk4, ImpactsId::kStepEnd, 0.3);
  const double hit = reach;  // s, at 1 m/s
  const double late = 0.3 * std::ceil(hit / 0.3) - hit;
  ASSERT_GT(late, 0.01);
  Worker worker(s);
  worker.load(s, {curve("velocity_error"), curve("position_error")}, usual_reference(setup_of(s)));
  worker.run_until(3.0);
  Window window(worker);
  ASSERT_TRUE(window.wait_until_all_stand());
  const RunError& end = *window.frames[0]->error;
  EXPECT_EQ(end.matched, 1);
  EXPECT_EQ(end.unmatched, 0);
  EXPECT_NEAR(end.impact_time, late, 1e-14);
  // Late by that much, it is too far by the way there and back; the overlap is pushed apart a little.
  EXPECT_GT(end.largest_position, 1.0 * late);
  EXPECT_LT(end.largest_position, 2.0 * late + 1e-12);
  for (const SeriesPoint<1>& p : points(window.recorders[0], curve("velocity_error"))) {
    EXPECT_LT(p.value[0], 1e-12) << p.at;
  }
}

TEST(ComparedRuns, GiveAnImpactUpThatNeverComes) {
  ImpactMatcher matcher(ImpactMatcher::Partners::kNearest);
  matcher.add(ImpactMatcher::From::kRun, 0_b, 1_b, 1.0);
  matcher.add(ImpactMatcher::From::kReference, 0_b, 2_b, 1.1);
  std::vector<std::uint8_t> awaiting(3);
  matcher.mark(awaiting);
  EXPECT_EQ(awaiting, (std::vector<std::uint8_t>{1, 1, 1}));
  matcher.add(ImpactMatcher::From::kReference, 0_b, 1_b, 1.25);
  matcher.mark(awaiting);
  EXPECT_EQ(awaiting, (std::vector<std::uint8_t>{1, 0, 1}));
  matcher.give_up(1.2);
  EXPECT_FALSE(matcher.awaits_any());
  EXPECT_EQ(matcher.matched(), 1);
  EXPECT_EQ(matcher.unmatched(), 1);
  EXPECT_EQ(matcher.largest_difference(), 0.25);
}

// Of bounces that follow one another ever faster the nearest ones belong together; what waits before them is
// given up.
TEST(ComparedRuns, MatchTheNearestImpacts) {
  ImpactMatcher matcher(ImpactMatcher::Partners::kNearest);
  for (const double time : {1.0, 1.1, 1.2, 2.0}) matcher.add(ImpactMatcher::From::kReference, 0_b, 1_b, time);
  matcher.add(ImpactMatcher::From::kRun, 0_b, 1_b, 1.21);
  EXPECT_EQ(matcher.matched(), 1);
  EXPECT_EQ(matcher.unmatched(), 2);
  EXPECT_NEAR(matcher.largest_difference(), 0.01, 1e-15);
  EXPECT_TRUE(matcher.awaits_any()) << "2.0";
}

// Step by step at rest, as impacts at the step's end hold a ball, and the reference bounces on: errors are
// known again.
TEST(ComparedRuns, KnowErrorsAgainAtRest) {
  Preset s =
      test::preset_with({disc("ball", {0.0, 0.6}, Vec2::Zero()), disc("floor", {0.0, 0.0}, Vec2::Zero())}, 0.5);
  s.scene.bodies[1].fixed = true;
  s.scene.bodies[1].mass.reset();
  s.scene.forces.gravity = {0.0, -9.81};
  s.method = method(IntegratorId::kRk4, ImpactsId::kStepEnd, 0.005);
  Worker worker(s);
  worker.load(s, {}, ReferenceId::kExactFlight);
  worker.run_until(4.0);
  Window window(worker);
  ASSERT_TRUE(window.wait_until_all_stand());
  const RunError& end = *window.frames[0]->error;
  EXPECT_FALSE(std::isnan(end.position));
  EXPECT_LT(end.position, 0.01);
  EXPECT_LT(end.impact_time, 0.05);
}

// Asked for once more while the run is still gone through again, the reference comes all the same.
TEST(ComparedRuns, AskedTwiceTheReferenceComes) {
  const Curve error = curve("position_error");
  Worker worker(crowd(), {error});
  worker.run_until(10.0);
  Window window(worker);
  ASSERT_TRUE(window.wait_until_all_stand());
  worker.set_reference(ReferenceId::kRefined);
  ASSERT_TRUE(window.wait([&] { return window.frames[0]->rows_known_until < window.frames[0]->time; }));
  worker.set_reference(ReferenceId::kRefined);
  worker.record({error});
  ASSERT_TRUE(window.wait([&] { return window.frames[0]->error.has_value(); }));
  const auto all = points(window.recorders[0], error);
  ASSERT_FALSE(all.empty());
  EXPECT_GT(all.back().at, 9.9);
  EXPECT_LT(all.front().at, 0.1);
}

// A body that is there from the start is there from the start in a run that is added later, too.
TEST(ComparedRuns, BodiesOfTheStartAreThereAtOnce) {
  Worker worker(crowd());
  worker.edit_scene({Add<Body>{disc("new", {0.0, 0.3}, Vec2::Zero())}});
  worker.add_method(crowd().method);
  worker.run_until(0.2);
  Window window(worker);
  ASSERT_TRUE(window.wait([&] { return window.frames.size() == 2 && window.frames[1]->time > 0.195; }));
  EXPECT_TRUE(test::same_bytes(window.frames[0]->state, window.frames[1]->state));
}

// Explicit Euler on a spring too stiff for its step: the run stands at its last good step, also under another
// method, and the runs beside it go on.
TEST(ComparedRuns, ALostRunStopsAndTheOthersContinue) {
  for (const ImpactsId impacts : {ImpactsId::kLocated, ImpactsId::kStepEnd}) {
    Preset s =
        test::preset_with({disc("disc", {1.0, 0.0}, Vec2::Zero()), disc("other", {5.0, 0.0}, Vec2::Zero())});
    s.scene.forces.springs.push_back({"", "disc", "", Vec2::Zero(), 1e4, 0.0, 0.0, SpringActs::kBoth});
    s.scene.bodies[0].mass = 1.0;
    s.method = method(IntegratorId::kRk4, impacts, 0.001);
    s.compare = {method(IntegratorId::kExplicitEuler, impacts, 0.01)};
    Worker worker(s);
    worker.run_until(10.0);
    Window window(worker);
    ASSERT_TRUE(window.wait([&] {
      return window.frames.size() == 2 && window.frames[1]->lost.has_value() && !window.frames[0]->playing;
    }));
    EXPECT_FALSE(window.frames[0]->lost);
    EXPECT_LT(window.frames[0]->time, 10.0);
    EXPECT_TRUE(window.frames[1]->state.q.allFinite());
    const double stands_at = window.frames[1]->time;
    worker.set_method(method(IntegratorId::kAdaptiveDormandPrince, impacts, 0.5), 1);
    worker.run_until(10.0);
    ASSERT_TRUE(window.wait([&] { return window.frames[0]->time > 9.99; }));
    EXPECT_EQ(window.frames[1]->time, stands_at);
    // From the start it goes by its new method.
    s.compare = {method(IntegratorId::kAdaptiveDormandPrince, impacts, 0.5)};
    worker.restart(s);
    worker.run_until(10.0);
    ASSERT_TRUE(window.wait([&] { return window.frames.size() == 2 && window.frames[1]->time > 9.4; }));
    EXPECT_FALSE(window.frames[1]->lost);
  }
}

// Where neighbours part exponentially the reference says that it is lost.
TEST(ComparedRuns, KnowHowFarTheReferenceIsToBeTrusted) {
  Preset s = crowd();
  s.scene.forces = {};
  s.scene.materials.clear();
  s.scene.materials.push_back({.name = "default", .restitution = 1.0});
  s.method = method(IntegratorId::kRk4, ImpactsId::kLocated, 0.01);
  ASSERT_EQ(usual_reference(setup_of(s)), ReferenceId::kExactFlight);
  Worker worker(s);
  worker.load(s, {}, ReferenceId::kExactFlight);
  Window window(worker);
  worker.run_until(0.2);
  ASSERT_TRUE(window.wait_until_all_stand());
  EXPECT_LT(window.frames[0]->error->uncertainty, 1e-12);
  worker.run_until(60.0);
  ASSERT_TRUE(window.wait([&] { return !window.frames[0]->playing && window.frames[0]->time > 59.0; }));
  EXPECT_GT(window.frames[0]->error->uncertainty, 0.01);
}

// A reference that is asked for late goes along from the start on.
TEST(ComparedRuns, AskedForLateErrorsAreTheSame) {
  const Curve error = curve("position_error");
  const Curve energy = curve("kinetic_energy");
  Preset s = crowd();
  s.compare = {method(IntegratorId::kExplicitEuler, ImpactsId::kStepEnd, 0.01)};
  Worker early(s);
  early.load(s, {error, energy}, ReferenceId::kRefined);
  early.run_until(1.0);
  Worker late(s, {energy});
  late.run_until(0.4);
  late.set_reference(ReferenceId::kRefined);
  late.record({error, energy});
  late.run_until(1.0);
  Window a(early);
  Window b(late);
  const auto done = [](const Window& w) {
    return !w.frames[0]->playing && w.frames[0]->time > 0.99 && w.frames[1]->time > 0.985 && w.frames[0]->error;
  };
  ASSERT_TRUE(a.wait([&] { return done(a); }));
  ASSERT_TRUE(b.wait([&] { return done(b); }));
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(points(a.recorders[i], error), points(b.recorders[i], error)) << i;
    EXPECT_EQ(points(a.recorders[i], energy), points(b.recorders[i], energy)) << i;
    EXPECT_GT(a.frames[i]->error->largest_position, i == 0 ? 1e-15 : 1e-4);
    EXPECT_EQ(a.frames[i]->error->largest_position, b.frames[i]->error->largest_position) << i;
  }
  late.set_reference(ReferenceId::kNone);
  ASSERT_TRUE(b.wait([&] { return !b.frames[0]->error; }));
}

TEST(ComparedRuns, ReferencesAreTheBestThatTheSceneAllows) {
  Preset s = oscillator(method(IntegratorId::kRk4, ImpactsId::kStepEnd, 0.01));
  EXPECT_EQ(usual_reference(setup_of(s)), ReferenceId::kRefined);
  EXPECT_TRUE(why_not(setup_of(s), ReferenceId::kExactFlight));
  EXPECT_FALSE(why_not(setup_of(s), ReferenceId::kRefined));
  const Method fine = live_reference_method(setup_of(s), s.method, ReferenceId::kRefined);
  EXPECT_EQ(fine.integrator, IntegratorId::kAdaptiveDormandPrince);
  EXPECT_EQ(fine.impacts, ImpactsId::kLocated);
  EXPECT_EQ(fine.tolerance, kFineTolerance);
  s.scene.forces.springs.clear();
  EXPECT_EQ(usual_reference(setup_of(s)), ReferenceId::kExactFlight);
  EXPECT_EQ(live_reference_method(setup_of(s), s.method, ReferenceId::kExactFlight).integrator,
            IntegratorId::kExactFlight);
}

}  // namespace
}  // namespace carom
