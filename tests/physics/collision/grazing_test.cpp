#include <functional>
#include <gtest/gtest.h>

#include "physics/dynamics/integrators/integrators.h"
#include "physics/run/run_setup.h"
#include "physics/scene/validate.h"
#include "tests/support/scenes.h"

// Passes that just touch and just miss, several impacts at once, bodies that touch at t = 0, and tiny and huge
// discs: under every integrator, with impacts at their own time.
namespace carom {
namespace {

using test::disc;
using test::setup_with;
using test::wall;

void each_integrator(RunSetup s, const std::function<void(Simulation&, const std::string&)>& look) {
  for (const IntegratorChoice& choice : kIntegrators) {
    s.method.integrator = choice.id;
    s.method.impacts = ImpactsId::kLocated;
    ASSERT_NO_THROW(validate(s.scene));
    Simulation run(s);
    look(run, std::string(choice.name));
  }
}

TEST(Grazing, DiscsPassStraight) {
  for (const double unit : {1e-6, 1.0, 1e6}) {
    for (const double offset : {-1e-9, 1e-9}) {
      const double sum = 0.4 * unit;
      RunSetup s =
          setup_with({disc("still", {0.0, 0.0}, {0.0, 0.0}, 0.1 * unit),
                      disc("passing", {-1.0 * unit, sum * (1.0 + offset)}, {2.0 * unit, 0.0}, 0.3 * unit)});
      each_integrator(s, [&](Simulation& run, const std::string& name) {
        run.advance_to(1.0);
        EXPECT_EQ(run.impact_count(), offset < 0.0 ? 1 : 0) << name << unit << offset;
      });
    }
  }
}

// The same while both fall: relative to each other they still go straight.
TEST(Grazing, DiscsPassWhileTheyFall) {
  for (const double offset : {-1e-9, 1e-9}) {
    RunSetup s = setup_with({disc("still", {0.0, 0.0}, {0.0, 0.0}, 0.1),
                             disc("passing", {-1.0, 0.4 * (1.0 + offset)}, {2.0, 0.0}, 0.3)});
    s.scene.forces.gravity = {0.0, -9.81};
    each_integrator(s, [&](Simulation& run, const std::string& name) {
      run.advance_to(1.0);
      EXPECT_EQ(run.impact_count(), offset < 0.0 ? 1 : 0) << name << offset;
    });
  }
}

// A disc thrown up under a ceiling: where an integrator's own path has its highest point is measured first,
// without the ceiling.
TEST(Grazing, ParabolaUnderACeiling) {
  for (const double up : {3.0, 3.0000001, 2.37}) {
    RunSetup s = setup_with({disc("thrown", {0.0, 0.0}, {0.7, up}, 0.25)});
    s.scene.forces.gravity = {0.0, -9.81};
    s.method.step = 1.0 / 64.0;
    for (const IntegratorChoice& choice : kIntegrators) {
      s.method.integrator = choice.id;
      // On the true parabola, and on that of every method that is exact under gravity.
      if (!choice.exact_under_gravity) continue;
      const double top = 0.5 * up * up / 9.81 + 0.25;
      for (const double offset : {-1e-9, 1e-9}) {
        RunSetup under = s;
        under.scene.bodies.push_back(wall("ceiling", {0.0, top * (1.0 + offset) + 0.5}, 4.0, 1.0));
        Simulation run(under);
        run.advance_to(0.6);
        EXPECT_EQ(run.impact_count(), offset < 0.0 ? 1 : 0) << choice.name << up << offset;
      }
    }
  }
}

// Past the corner of a box.
TEST(Grazing, DiscPassesACorner) {
  for (const double angle : {0.3, 0.7853981633974483}) {
    for (const double offset : {-1e-9, 1e-9}) {
      // The box's highest point.
      const Vec2 corner(0.5 * std::cos(angle) - 0.5 * std::sin(angle),
                        0.5 * std::sin(angle) + 0.5 * std::cos(angle));
      RunSetup s = setup_with({wall("box", {0.0, 0.0}, 1.0, 1.0, angle),
                               disc("passing", {-2.0, corner.y() + 0.2 * (1.0 + offset)}, {5.0, 0.0}, 0.2)});
      each_integrator(s, [&](Simulation& run, const std::string& name) {
        run.advance_to(1.0);
        EXPECT_EQ(run.impact_count(), offset < 0.0 ? 1 : 0) << name << angle << offset;
      });
    }
  }
}

TEST(Impacts, SeveralInOneStep) {
  // 0.2 m to move in, at 10 m/s in steps of 0.1 s: five impacts a step.
  RunSetup s = setup_with({wall("left", {-1.0, 0.0}, 1.0, 1.0), wall("right", {0.4, 0.0}, 1.0, 1.0),
                           disc("d", {-0.3, 0.0}, {10.0, 0.0}, 0.1)});
  s.method.step = 0.1;
  each_integrator(s, [&](Simulation& run, const std::string& name) {
    std::size_t most = 0;
    run.advance_to(1.0, [&] { most = std::max(most, run.last_impacts().size()); });
    EXPECT_GE(most, 4U) << name;
    // The first after 0.01 s, then one each 0.02 s.
    EXPECT_EQ(run.impact_count(), 50) << name;
    for (std::size_t k = 1; k < run.last_impacts().size(); ++k)
      EXPECT_NEAR(run.last_impacts()[k].time - run.last_impacts()[k - 1].time, 0.02, 1e-14) << name;
  });
}

TEST(Impacts, SeveralAtOneTime) {
  // Two pairs far apart, and one disc that reaches two others at once.
  const double y = 0.15;
  const double x = std::sqrt(0.04 - y * y);
  RunSetup s = setup_with({disc("a1", {-0.6, 5.0}, {1.0, 0.0}), disc("a2", {0.6, 5.0}, {-1.0, 0.0}),
                           disc("b1", {-0.6, 9.0}, {1.0, 0.0}), disc("b2", {0.6, 9.0}, {-1.0, 0.0}),
                           disc("cue", {-x - 0.5, 0.0}, {1.0, 0.0}), disc("upper", {0.0, y}, {0.0, 0.0}),
                           disc("lower", {0.0, -y}, {0.0, 0.0})});
  s.method.step = 0.2;
  each_integrator(s, [&](Simulation& run, const std::string& name) {
    std::vector<ImpactRecord> log;
    run.advance_to(0.8, [&] { log.insert(log.end(), run.last_impacts().begin(), run.last_impacts().end()); });
    ASSERT_GE(log.size(), 4U) << name;
    EXPECT_NEAR(log[0].time, 0.5, 1e-15) << name;
    int at_half = 0;
    bool a = false;
    bool b = false;
    bool upper = false;
    for (const ImpactRecord& r : log) {
      if (std::abs(r.time - 0.4) < 1e-14) (r.a == 0 ? a : b) = true;
      at_half += std::abs(r.time - 0.5) < 1e-14 ? 1 : 0;
      upper = upper || r.b == 5;
    }
    EXPECT_GE(at_half, 2) << name;
    EXPECT_TRUE(upper) << name;
    EXPECT_EQ(run.state().velocity(0).x(), -1.0) << name;
    EXPECT_EQ(run.state().velocity(2).x(), -1.0) << name;
    EXPECT_NEAR(run.totals().momentum.x(), 1.0, 1e-14) << name;
    EXPECT_NEAR(run.totals().kinetic() / run.ledger().initial, 1.0, 1e-14) << name;
  });
}

TEST(TouchingAtStart, ApproachingPartingResting) {
  for (const double unit : {1e-6, 1.0, 1e6}) {
    for (const double speed : {1.0, -1.0, 0.0}) {
      RunSetup s = setup_with({disc("still", {0.0, 0.0}, {0.0, 0.0}, 0.1 * unit),
                               disc("touching", {0.3 * unit, 0.0}, {-speed * unit, 0.0}, 0.2 * unit)},
                              0.5);
      each_integrator(s, [&](Simulation& run, const std::string& name) {
        run.advance_to(0.5);
        EXPECT_EQ(run.impact_count(), speed > 0.0 ? 1 : 0) << name << unit << speed;
        const double u = run.state().velocity(1).x() - run.state().velocity(0).x();
        EXPECT_NEAR(u, (speed > 0.0 ? 0.5 : -speed) * unit, 1e-14 * unit) << name << unit << speed;
        EXPECT_EQ(run.notices().text(), "ok") << name << unit << speed;
      });
    }
  }
}

TEST(TouchingAtStart, RestsOnAFloorAndRollsAlongIt) {
  for (const double speed : {0.0, 1.0}) {
    RunSetup s =
        setup_with({wall("floor", {0.0, -0.5}, 40.0, 1.0), disc("d", {0.0, 0.1}, {speed, 0.0})}, 0.5, 0.3);
    s.scene.bodies[1].spin = -speed / 0.1;  // it rolls: no slip at the contact
    s.scene.forces.gravity = {0.0, -9.81};
    // In each step gravity presses the disc in by up to g h², and the arm of friction is that much shorter.
    const double pressed = 9.81 * s.method.step * s.method.step;
    each_integrator(s, [&](Simulation& run, const std::string& name) {
      run.advance_to(2.0);
      EXPECT_NEAR(run.state().position(1).x(), 2.0 * speed, pressed / 0.1 * speed) << name << speed;
      EXPECT_NEAR(run.state().position(1).y(), 0.1, pressed) << name << speed;
      EXPECT_NEAR(run.state().v(2, 1), -speed / 0.1, pressed / 0.1 * 10.0 * speed) << name << speed;
    });
  }
}

// Along a floor without anything that presses, and along it at e = 1 under gravity: it never sinks in.
TEST(TouchingAtStart, SlidesAlongAFloor) {
  for (const double gravity : {0.0, -9.81}) {
    for (const double restitution : {0.0, 0.5, 1.0}) {
      RunSetup s =
          setup_with({wall("floor", {0.0, -0.5}, 40.0, 1.0), disc("d", {0.0, 0.1}, {3.0, 0.0})}, restitution);
      s.scene.forces.gravity = {0.0, gravity};
      each_integrator(s, [&](Simulation& run, const std::string& name) {
        double lowest = 1.0;
        run.advance_to(1.0, [&] { lowest = std::min(lowest, run.state().position(1).y()); });
        EXPECT_GT(lowest, 0.1 - 1e-3) << name << gravity << restitution;
        EXPECT_NEAR(run.state().position(1).x(), 3.0, 1e-9) << name << gravity << restitution;
        if (gravity == 0.0) {
          EXPECT_EQ(run.impact_count(), 0) << name << restitution;
        }
      });
    }
  }
}

TEST(Sizes, TinyAndHugeDiscsMeetAsOthersDo) {
  for (const double unit : {1e-6, 1e-3, 1e3, 1e6}) {
    RunSetup s = setup_with({disc("a", {-1.0 * unit, 0.05 * unit}, {1.0 * unit, 0.0}, 0.1 * unit, 2.0),
                             disc("b", {1.0 * unit, 0.0}, {-1.0 * unit, 0.3 * unit}, 0.4 * unit, 3.0),
                             wall("w", {0.0, 2.0 * unit}, 8.0 * unit, 1.0 * unit, 0.1)});
    RunSetup one = s;
    one.scene.bodies = {disc("a", {-1.0, 0.05}, {1.0, 0.0}, 0.1, 2.0),
                        disc("b", {1.0, 0.0}, {-1.0, 0.3}, 0.4, 3.0), wall("w", {0.0, 2.0}, 8.0, 1.0, 0.1)};
    for (const IntegratorChoice& choice : kIntegrators) {
      s.method.integrator = one.method.integrator = choice.id;
      s.method.tolerance = 1e-9 * unit;
      Simulation scaled(s);
      Simulation plain(one);
      scaled.advance_to(4.0);
      plain.advance_to(4.0);
      EXPECT_GT(plain.impact_count(), 1) << choice.name;
      EXPECT_EQ(scaled.impact_count(), plain.impact_count()) << choice.name << unit;
      for (const int i : {0, 1}) {
        EXPECT_LT((scaled.state().position(i) / unit - plain.state().position(i)).norm(), 1e-12)
            << choice.name << unit;
      }
    }
  }
}

}  // namespace
}  // namespace carom
