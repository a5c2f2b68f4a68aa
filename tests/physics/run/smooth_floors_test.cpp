#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "physics/dynamics/integrators/integrators.h"
#include "physics/run/simulation.h"
#include "tests/support/draws.h"
#include "tests/support/scenes.h"

// Flush bodies make one smooth surface: the edges between them do not catch what moves over them, and a true
// step does.
namespace carom {
namespace {

constexpr double kG = 9.81;

// A row of fixed boxes whose tops are at y = 0, of these widths; `last_up` in m raises the last one.
std::vector<Body> floor_of(const std::vector<double>& widths, double last_up = 0.0) {
  std::vector<Body> bodies;
  double x = -0.5 * widths.front();
  for (std::size_t i = 0; i < widths.size(); ++i) {
    const double up = i + 1 == widths.size() ? last_up : 0.0;
    bodies.push_back(
        test::wall("floor-" + std::to_string(i), {x + 0.5 * widths[i], -0.5 + up}, widths[i], 1.0));
    x += widths[i];
  }
  return bodies;
}

Body mover(bool box, double speed) {
  Body b = test::disc("mover", {0.0, 0.25}, {speed, 0.0}, 0.25);
  if (box) {
    b.shape = Box{0.5, 0.5};
  } else {
    b.spin = -speed / 0.25;
  }
  return b;
}

RunSetup over(std::vector<Body> bodies, const Body& body, double friction) {
  bodies.push_back(body);
  RunSetup s = test::setup_with(std::move(bodies), 0.0, friction);
  s.scene.forces.gravity = {0.0, -kG};
  return s;
}

TEST(SmoothFloors, ASlidingBoxAndARollingDiscKeepTheirSpeed) {
  for (const bool box : {true, false}) {
    for (const auto& impacts : kImpacts) {
      for (const double h : {0.01, 0.005, 0.0025}) {
        RunSetup s = over(floor_of({2.0, 2.0, 1.0, 1.0, 2.0}), mover(box, 1.0), box ? 0.0 : 0.5);
        s.method = {IntegratorId::kRk4, impacts.id, ContactsId::kLasting, h};
        Simulation run(s);
        run.advance_to(6.0);
        const auto last = static_cast<Eigen::Index>(run.bodies().size()) - 1;
        EXPECT_NEAR(run.state().v(0, last), 1.0, 2e-7)
            << (box ? "box, " : "disc, ") << impacts.name << ", " << h;
        EXPECT_NEAR(run.state().q(1, last), 0.25, 1e-9);
        EXPECT_NEAR(run.state().v(2, last), box ? 0.0 : -4.0, 1e-6);
        EXPECT_EQ(run.notices().text(), "ok");
      }
    }
  }
}

// A box that flies a rounding error too low over them is not turned round.
TEST(SmoothFloors, ABoxFliesAlong) {
  for (const double low : {0.0, 1e-15, 1e-13, 1e-10}) {
    for (const auto& impacts : kImpacts) {
      Body box = mover(true, 1.0);
      box.position.y() -= low;
      RunSetup s = over(floor_of({2.0, 2.0, 2.0}), box, 0.0);
      s.scene.forces.gravity.setZero();
      s.scene.materials[0].restitution = 1.0;
      s.method = {IntegratorId::kRk4, impacts.id, ContactsId::kImpulse, 0.01};
      Simulation run(s);
      run.advance_to(3.0);
      EXPECT_EQ(run.impact_count(), 0) << low << ", " << impacts.name;
      EXPECT_NEAR(run.state().v(0, 3), 1.0, 1e-14);
      EXPECT_NEAR(run.state().v(2, 3), 0.0, 1e-14);
    }
  }
}

// What is higher than rounding is a step, and stops a box; e = 1 turns it round.
TEST(SmoothFloors, AStepIsHit) {
  for (const auto& impacts : kImpacts) {
    RunSetup s = over(floor_of({2.0, 2.0, 2.0}, 0.1), mover(true, 1.0), 0.0);
    s.scene.forces.gravity.setZero();
    s.scene.materials[0].restitution = 1.0;
    s.method = {IntegratorId::kRk4, impacts.id, ContactsId::kImpulse, 0.01};
    Simulation run(s);
    run.advance_to(5.0);
    EXPECT_LT(run.state().v(0, 3), 0.9) << impacts.name;
    EXPECT_GT(run.impact_count(), 0);
  }
}

// Random floors, speeds and angles of the whole scene.
TEST(SmoothFloors, RandomOnesDoNotCatch) {
  test::Draws draw(5);
  for (int k = 0; k < 60; ++k) {
    std::vector<double> widths;
    for (int i = 0; i < 6; ++i) widths.push_back(draw.between(0.6, 2.0));
    const bool box = draw.chance(0.5);
    const double speed = draw.between(0.2, 1.5);
    const double turned = draw.angle();
    RunSetup s = over(floor_of(widths), mover(box, speed), box ? 0.0 : 0.5);
    for (Body& b : s.scene.bodies) {
      b.position = turned_by(turned, b.position);
      b.velocity = turned_by(turned, b.velocity);
      b.angle = turned;
    }
    s.scene.forces.gravity = turned_by(turned, s.scene.forces.gravity);
    s.method = {IntegratorId::kRk4, draw.chance(0.5) ? ImpactsId::kLocated : ImpactsId::kStepEnd,
                ContactsId::kLasting, draw.between(0.002, 0.01)};
    Simulation run(s);
    run.advance_to(2.0 / speed);
    const Vec2 v = turned_by(-turned, run.state().velocity(6));
    EXPECT_NEAR(v.x(), speed, 1e-6) << k << (box ? ", box" : ", disc");
    EXPECT_NEAR(v.y(), 0.0, 1e-6) << k;
  }
}

// A flat box moves on by up to 0.4 of its length in a step, over boxes narrower than itself: what held a
// corner in the step before is far behind it, or another of them holds it now.
TEST(SmoothFloors, AFastBoxStaysFlatOnNarrowOnes) {
  test::Draws draw(7);
  for (int k = 0; k < 40; ++k) {
    const double h = draw.between(0.005, 0.02);
    const double speed = draw.between(0.1, 0.4) * 0.5 / h;
    std::vector<double> widths{1.0};
    for (int i = 0; i < 8; ++i) widths.push_back(draw.between(0.2, 0.9));
    widths.push_back(10.0);
    Body box = mover(true, speed);
    box.shape = Box{0.5, 0.2};
    box.position.y() = 0.1;
    RunSetup s = over(floor_of(widths), box, 0.0);
    s.scene.materials[0].restitution = draw.between(0.0, 0.9);
    s.method = {IntegratorId::kRk4, ImpactsId::kLocated, ContactsId::kLasting, h};
    Simulation run(s);
    const Eigen::Index last = run.state().size() - 1;
    for (int step = 0; step < 30; ++step) {
      run.step();
      ASSERT_LT(std::abs(run.state().q(2, last)), 1e-5)
          << k << ", " << speed << " m/s, h = " << h << ", " << run.time();
    }
    EXPECT_NEAR(run.state().v(0, last), speed, 1e-5) << k;
  }
}

// With friction a flat landing may start to turn: how much depends on how far its contact reaches, over all
// flush boxes together.
TEST(SmoothFloors, ABoxLandsOnSeveralAsOnOne) {
  test::Draws draw(11);
  for (int k = 0; k < 100; ++k) {
    std::vector<double> widths{1.0};
    for (int i = 0; i < 12; ++i) widths.push_back(draw.between(0.15, 0.8));
    Body box = mover(true, 0.0);
    box.shape = Box{0.5, draw.between(0.2, 0.6)};
    box.position = {draw.between(0.3, 1.3), 0.5 * std::get<Box>(box.shape).height + draw.between(0.1, 0.3)};
    box.velocity = {draw.between(-2.0, 2.0), draw.between(-2.0, 0.0)};
    const double turned = draw.chance(0.5) ? 0.0 : draw.angle();
    const double restitution = draw.chance(0.3) ? 0.0 : draw.between(0.1, 1.0);
    const double friction = draw.between(0.0, 0.8);
    const double h = draw.between(0.002, 0.02);
    const auto landed_on = [&](std::vector<Body> floor) {
      RunSetup s = over(std::move(floor), box, friction);
      s.scene.materials[0].restitution = restitution;
      for (Body& b : s.scene.bodies) {
        b.position = turned_by(turned, b.position);
        b.velocity = turned_by(turned, b.velocity);
        b.angle = turned;
      }
      s.scene.forces.gravity = turned_by(turned, s.scene.forces.gravity);
      s.method = {IntegratorId::kRk4, ImpactsId::kLocated, ContactsId::kLasting, h};
      Simulation run(s);
      while (run.impact_count() == 0 && run.time() < 1.0) run.step();
      const Eigen::Index last = run.state().size() - 1;
      return std::pair(Eigen::Vector3d(run.state().v.col(last)), run.time());
    };
    std::vector<Body> tiles = floor_of(widths);
    const auto [on_tiles, time] = landed_on(tiles);
    Body whole = tiles.front();
    whole.shape = Box{20.0, 1.0};
    const auto [on_one, time_on_one] = landed_on({whole});
    EXPECT_EQ(time, time_on_one);
    // What is left of a turn without restitution ends in the forces of contacts, each of which may still close
    // a gap of its own.
    EXPECT_LT((on_tiles - on_one).norm(), restitution > 0.0 ? 1e-9 : 1e-2)
        << k << ": e = " << restitution << ", mu = " << friction << ", h = " << h;
  }
}

// A box whose centre is never without support reaches over a gap: its leading corner passes the corner of the
// next table, which is as high as the first, and does not hit it.
TEST(SmoothFloors, ABoxSlidesOnOverAGap) {
  struct Case {
    double angle, size, gap, restitution, friction;
  };
  for (const Case& c :
       {Case{0.0, 1.0, 0.05, 0.0, 0.0}, Case{0.3, 1.0, 0.15, 0.5, 0.0}, Case{-0.7, 1e3, 0.05, 0.0, 0.0},
        Case{0.0, 1e-3, 1e-4, 1.0, 0.0}, Case{1.2, 1.0, 0.15, 0.0, 0.1}, Case{0.0, 1.0, 0.03, 0.0, 0.05}}) {
    for (const auto& integrator : kIntegrators) {
      for (const auto& impacts : kImpacts) {
        const auto turned = [&](double x, double y) { return Vec2(c.size * turned_by(c.angle, Vec2(x, y))); };
        const double root = std::sqrt(c.size);
        const double until = 0.35 * root;
        const auto table = [&](const std::string& name, double x, double width) {
          return test::wall(name, turned(x, -0.25), c.size * width, 0.5 * c.size, c.angle);
        };
        Body box = test::box("box", turned(-0.25, 0.05), turned(1.6, 0.0) / root, 0.4 * c.size, 0.1 * c.size);
        box.angle = c.angle;
        RunSetup s = test::setup_with({table("first", -2.0, 4.0), table("next", c.gap + 1.5, 3.0), box},
                                      c.restitution, c.friction);
        s.scene.forces.gravity = turned(0.0, -kG) / c.size;
        s.method = {integrator.id, impacts.id, ContactsId::kLasting, root / 60.0};
        Simulation run(s);
        run.advance_to(until);
        const double t = 0.35;
        const Vec2 there = turned(-0.25 + 1.6 * t - 0.5 * c.friction * kG * t * t, 0.05);
        const double off = (run.state().q.col(2).head<2>() - there).norm() / c.size;
        // Of the Eulers, of order 1, friction takes that much off.
        EXPECT_LT(off, c.friction > 0.0 && integrator.order == 1 ? 0.003 : 1e-6)
            << integrator.name << ", " << impacts.name << ", gap " << c.gap << ", size " << c.size;
        EXPECT_NEAR(run.state().v(2, 2) * root, 0.0, 1e-6);
        EXPECT_EQ(run.notices().text(), "ok") << integrator.name << ", gap " << c.gap;
      }
    }
  }
}

// A corner that has passed a seam by less than the tolerance for corners that meet is still on the floor.
TEST(SmoothFloors, ACornerJustBesideASeamStaysUp) {
  for (const double beside : {1e-9, 1e-6, 2e-5, 4e-5, 1e-4}) {
    for (const double speed : {-0.3, 0.3}) {
      Body box = mover(true, speed);
      box.shape = Box{0.4, 0.2};
      // The corner behind passes x = 0.5 in the second step, that far from its end.
      box.position = {0.5 + (speed > 0.0 ? 0.2 - beside : beside - 0.2) - 0.01 * speed, 0.1};
      RunSetup s = over(floor_of({1.0, 1.0, 1.0}), box, 0.0);
      s.method = {IntegratorId::kRk4, ImpactsId::kLocated, ContactsId::kLasting, 0.01};
      Simulation run(s);
      const Eigen::Index last = run.state().size() - 1;
      for (int step = 0; step < 4; ++step) {
        run.step();
        EXPECT_NEAR(run.state().v(2, last), 0.0, 1e-10) << beside << ", " << speed << ", " << step;
        EXPECT_NEAR(run.state().q(1, last), 0.1, 1e-10) << beside << ", " << speed << ", " << step;
      }
    }
  }
}

// A box that comes down turned, with impacts at the step's end: the corner that lands over the next tile meets
// its top, and not the seam.
TEST(SmoothFloors, ATurnedBoxLandsBesideASeamAsOnOne) {
  test::Draws draw(23);
  for (int k = 0; k < 40; ++k) {
    Body box = mover(true, draw.between(-2.0, 2.0));
    box.shape = Box{0.5, 0.3};
    box.position = {3.0 + draw.between(-0.3, 0.3), 0.7};
    box.angle = draw.between(-0.4, 0.4);
    const double h = draw.between(0.005, 0.015);
    const auto landed_on = [&](std::vector<Body> floor) {
      RunSetup s = over(std::move(floor), box, 0.0);
      s.method = {IntegratorId::kRk4, ImpactsId::kStepEnd, ContactsId::kLasting, h};
      Simulation run(s);
      run.advance_to(0.8);
      return Eigen::Vector3d(run.state().q.col(run.state().size() - 1));
    };
    std::vector<Body> tiles = floor_of({6.0, 0.35, 1.0, 1.0, 3.0});
    Body whole = tiles.front();
    whole.shape = Box{20.0, 1.0};
    EXPECT_LT((landed_on(tiles) - landed_on({whole})).norm(), 1e-3) << k << ", h = " << h;
  }
}

// With impacts at the step's end a corner sinks before it is seen. Where two flush boxes meet it has sunk
// between them: it is pushed out along their common surface, whether they are bodies or shapes of one.
TEST(SmoothFloors, ACornerThatSinksWhereTwoMeetIsPushedUp) {
  for (const bool one_body : {false, true}) {
    for (const double restitution : {0.0, 0.5, 1.0}) {
      for (int k = 0; k < 150; ++k) {
        RunSetup s = test::setup_with({}, restitution);
        Compound all;
        for (int i = 0; i < 6; ++i) {
          const Vec2 place(0.5 * i - 1.25, -0.5);
          all.shapes.push_back({Box{0.5, 1.0}, place, 0.0, ""});
          if (!one_body) s.scene.bodies.push_back(test::wall("tile-" + std::to_string(i), place, 0.5, 1.0));
        }
        if (one_body) {
          Body floor = test::wall("floor", {0.0, -0.5}, 1.0, 1.0);
          floor.shape = all;
          s.scene.bodies.push_back(floor);
        }
        // Most of them get near a seam within the first bounces; the last 50 meet one closely.
        Body box = test::disc("box", {k < 100 ? -0.3 + 0.004 * k : 1e-5 * (k - 125), 0.7},
                              {k % 2 == 0 ? 0.7 : 0.0, 0.0});
        box.shape = Box{0.3, 0.2};
        box.angle = 0.25 * std::numbers::pi;
        s.scene.bodies.push_back(box);
        s.scene.forces.gravity = Vec2(0.0, -9.81);
        s.method = {IntegratorId::kVelocityVerlet, ImpactsId::kStepEnd, ContactsId::kImpulse, 1.0 / 120.0};
        Simulation run(s);
        const double before = run.totals().energy();
        while (run.time() < 0.8) {
          run.step();
          ASSERT_GT(run.state().q(1, run.state().size() - 1), 0.05)
              << one_body << ' ' << restitution << ' ' << k;
          ASSERT_LT(run.totals().energy(), 1.1 * before) << one_body << ' ' << restitution << ' ' << k;
        }
      }
    }
  }
}

}  // namespace
}  // namespace carom
