#include <cmath>
#include <cstdint>
#include <gtest/gtest.h>
#include <numbers>
#include <string>
#include <vector>

#include "physics/dynamics/integrators/integrators.h"
#include "physics/math/vectors.h"
#include "physics/run/simulation.h"
#include "tests/support/draws.h"
#include "tests/support/scenes.h"

// Faces that meet flat, bodies welded into one, and corners that meet tip to tip: rounding decides nothing.
namespace carom {
namespace {

using test::box;

constexpr double kG = 9.81;

template <class Check>
void for_every_way(const Check& check) {
  for (const ContactsId contacts : {ContactsId::kImpulse, ContactsId::kLasting}) {
    for (const auto& impacts : kImpacts) check(Method{IntegratorId::kRk4, impacts.id, contacts, 0.001});
  }
}

// The impulse acts below the centre: -(1 + e_t) of the slip is reversed, K_tt = 1/m + r²/I = 2.5/kg.
TEST(FlatLandings, TangentialRestitutionHoldsWhereverABoxLands) {
  for_every_way([](const Method& method) {
    for (const double x : {0.0, 0.1, 0.37, -2.3}) {
      RunSetup s = test::setup_with(
          {test::wall("floor", {0.0, -0.5}, 20.0, 1.0), box("box", {x, 1.5}, {0.3, 0.0}, 1.0, 1.0)}, 0.5, 0.1);
      s.scene.materials[0].tangential_restitution = 0.2;
      s.scene.forces.gravity = {0.0, -kG};
      s.method = method;
      Simulation run(s);
      run.advance_to(0.5);
      EXPECT_NEAR(run.state().v(0, 1), 0.3 * (1.0 - 1.2 / 2.5), 1e-3) << x;
      EXPECT_NEAR(run.state().v(2, 1), -0.3 * 1.2 / 2.5 * 3.0, 1e-3) << x;
    }
  });
}

// Two halves make a plank, two discs a dumb-bell: neither turns, as one box would not.
TEST(FlatLandings, WeldedBodiesLandAsOne) {
  for_every_way([](const Method& method) {
    for (const bool discs : {false, true}) {
      Body a = box("a", {-0.5, 1.0}, {0.0, 0.0}, 1.0, 0.2);
      Body b = box("b", {0.5, 1.0}, {0.0, 0.0}, 1.0, 0.2);
      if (discs) a.shape = b.shape = Disc{0.5};
      RunSetup s = test::setup_with({test::wall("floor", {0.0, -0.5}, 20.0, 1.0), a, b}, 0.5);
      Joint weld;
      weld.kind = JointKind::kWeld;
      weld.body = "a";
      weld.to = "b";
      weld.point = {0.5, 0.0};
      weld.anchor = {-0.5, 0.0};
      s.scene.joints = {weld};
      s.scene.forces.gravity = {0.0, -kG};
      s.method = method;
      Simulation run(s);
      run.advance_to(0.5);
      EXPECT_EQ(run.impact_count(), 1) << discs;
      EXPECT_NEAR(run.state().v(2, 1), 0.0, 1e-12) << discs;
      EXPECT_NEAR(run.state().v(0, 1), 0.0, 1e-12) << discs;
    }
  });
}

TEST(FlatLandings, SquaresThatMeetTipToTipRebound) {
  test::Draws draw(2);
  for (int k = 0; k < 20; ++k) {
    const double turned = k == 0 ? 0.0 : draw.angle();
    std::vector<Body> bodies = {box("a", {-1.5, 0.0}, {1.0, 0.0}, 1.0, 1.0),
                                box("b", {1.5, 0.0}, {-1.0, 0.0}, 1.0, 1.0)};
    for (Body& b : bodies) {
      b.position = turned_by(turned, b.position);
      b.velocity = turned_by(turned, b.velocity);
      b.angle = turned + 0.25 * std::numbers::pi;
    }
    RunSetup s = test::setup_with(bodies);
    s.method = {IntegratorId::kRk4, ImpactsId::kLocated, ContactsId::kImpulse, 0.01};
    Simulation run(s);
    run.advance_to(1.5);
    EXPECT_NEAR((run.state().velocity(0) + turned_by(turned, Vec2(1.0, 0.0))).norm(), 0.0, 1e-9) << turned;
    EXPECT_NEAR(run.state().v(2, 0), 0.0, 1e-9) << turned;
  }
}

// Squares that meet corner on corner somewhere else than at the origin, where rounding adds up on the way: the
// first one hands all of its motion over.
TEST(FlatLandings, SquaresThatMeetTipToTipReboundAnywhere) {
  for (const Vec2& at :
       {Vec2(0.0, 0.0), Vec2(10.0, 7.0), Vec2(-3.0, 8.0), Vec2(0.7, -41.0), Vec2(100.0, 70.0)}) {
    for (const double step : {1.0 / 60.0, 0.005, 0.001}) {
      for (const double sign : {1.0, -1.0}) {
        RunSetup s = test::setup_with({box("a", at + Vec2(-0.5, -0.5 * sign), {1.0, sign}, 0.2, 0.2),
                                       box("b", at, {0.0, 0.0}, 0.2, 0.2)});
        s.method = {IntegratorId::kRk4, ImpactsId::kLocated, ContactsId::kImpulse, step};
        Simulation run(s);
        run.advance_to(0.5);
        EXPECT_EQ(run.impact_count(), 1) << at.transpose() << ", h = " << step;
        EXPECT_NEAR((run.state().velocity(1) - Vec2(1.0, sign)).norm(), 0.0, 1e-9);
        EXPECT_NEAR(run.state().v(2, 1), 0.0, 1e-9) << at.transpose() << ", h = " << step;
      }
    }
  }
}

// Mirror images that meet tip to tip at any angle stay mirror images: each tip is pushed straight back.
TEST(FlatLandings, TiltedSquaresThatMeetTipToTipStayMirrorImages) {
  for (const auto& impacts : kImpacts) {
    for (const double tilt : {0.05, -0.05, 0.143, -0.143, 0.3, -0.3, 0.39, -0.39, 0.45, -0.45, 0.7, -0.7}) {
      for (const Vec2& shift : {Vec2(0.0, 0.0), Vec2(1.0, 0.0), Vec2(-13.0, 8.0)}) {
        RunSetup s = test::setup_with({box("a", shift + Vec2(-0.5, 0.0), {1.0, 0.0}, 0.2, 0.2),
                                       box("b", shift + Vec2(0.5, 0.0), {-1.0, 0.0}, 0.2, 0.2)});
        s.scene.bodies[0].angle = tilt;
        s.scene.bodies[1].angle = -tilt;
        s.method = {IntegratorId::kRk4, impacts.id, ContactsId::kLasting, 0.005};
        Simulation run(s);
        while (run.impact_count() == 0 && run.time() < 1.0) run.step();
        // The tip is off the line of centres by this.
        const double off = std::sqrt(0.02) * std::sin(0.25 * std::numbers::pi - std::abs(tilt));
        const double inertia = 0.04 / 6.0;
        const double impulse = 2.0 / (1.0 + off * off / inertia);
        EXPECT_NEAR(run.state().velocity(0).x(), 1.0 - impulse, 1e-9) << tilt << ", " << shift.transpose();
        EXPECT_NEAR(run.state().velocity(0).y(), 0.0, 1e-9);
        EXPECT_NEAR(std::abs(run.state().v(2, 0)), impulse * off / inertia, 1e-9);
        EXPECT_NEAR(run.state().v(2, 0), -run.state().v(2, 1), 1e-9);
      }
    }
  }
}

// At the step's end corners have gone into each other by up to a step's way: still along their middle.
TEST(FlatLandings, SquaresThatMeetTipToTipReboundAtTheStepsEnd) {
  for (const double mass : {1.0, 2.0, 0.1}) {
    for (const double turned : {0.0, 0.4, 2.1}) {
      for (const double step : {1.0 / 60.0, 0.005, 0.001}) {
        RunSetup s = test::setup_with(
            {box("a", {-0.5, 0.0}, {1.0, 0.0}, 0.2, 0.2), box("b", {0.0, 0.0}, {0.0, 0.0}, 0.2, 0.2)});
        for (Body& b : s.scene.bodies) {
          b.position = turned_by(turned, b.position) + Vec2(3.0, -1.0);
          b.velocity = turned_by(turned, b.velocity);
          b.angle = turned + 0.25 * std::numbers::pi;
        }
        s.scene.bodies[1].mass = mass;
        s.method = {IntegratorId::kRk4, ImpactsId::kStepEnd, ContactsId::kLasting, step};
        Simulation run(s);
        run.advance_to(0.4);
        const Vec2 after = turned_by(turned, Vec2((1.0 - mass) / (1.0 + mass), 0.0));
        EXPECT_NEAR((run.state().velocity(0) - after).norm(), 0.0, 1e-9) << mass << ", h = " << step;
        EXPECT_NEAR(run.state().v(2, 0), 0.0, 1e-9) << mass << ", h = " << step;
        EXPECT_NEAR(run.state().v(2, 1), 0.0, 1e-9) << mass << ", h = " << step;
      }
    }
  }
}

// A box that lands half over an edge: the impulse acts where both ends of the stretch stop.
TEST(FlatLandings, ABoxOverAnEdgeDoesNotTurnWhileItsCentreIsSupported) {
  for (const double x : {0.45, 0.2, -0.3}) {
    RunSetup s = test::setup_with(
        {test::wall("floor", {-1.0, -0.5}, 2.0, 1.0), box("box", {x - 0.5, 1.0}, {0.0, 0.0}, 1.0, 1.0)}, 0.5);
    s.scene.forces.gravity = {0.0, -kG};
    s.method = {IntegratorId::kRk4, ImpactsId::kLocated, ContactsId::kImpulse, 0.01};
    Simulation run(s);
    run.advance_to(0.4);
    EXPECT_EQ(run.impact_count(), 1);
    EXPECT_NEAR(run.state().v(2, 1), 0.0, 1e-12) << x;
    EXPECT_NEAR(run.state().v(1, 1), 1.5 * std::sqrt(2.0 * kG * 0.5) - kG * 0.4, 1e-9) << x;
  }
}

// Two fixed pegs, which need not be alike: both are hit at once, in either order of the file.
TEST(FlatLandings, APlankLandsOnTwoPegsAtOnce) {
  for_every_way([](const Method& method) {
    for (const auto& [first, second] :
         {std::pair<Shape, Shape>(Disc{0.1}, Disc{0.1}), std::pair<Shape, Shape>(Disc{0.1}, Box{0.2, 0.2}),
          std::pair<Shape, Shape>(Box{0.2, 0.2}, Disc{0.1})}) {
      RunSetup s = test::setup_with(
          {test::fixed("left", first, {-0.25, -0.1}), test::fixed("right", second, {0.25, -0.1}),
           box("plank", {0.0, 0.15}, {0.0, 0.0}, 1.0, 0.1)},
          1.0, 0.3);
      s.scene.forces.gravity = {0.0, -kG};
      s.method = method;
      Simulation run(s);
      run.advance_to(0.2);
      EXPECT_EQ(run.impact_count(), 2);
      EXPECT_NEAR(run.state().v(2, 2), 0.0, 1e-10);
      EXPECT_NEAR(run.state().v(1, 2), 2.0 * std::sqrt(2.0 * kG * 0.1) - kG * 0.2, 0.02);
    }
  });
}

// After the first impact of a box of 1 kg that is let fall 0.3 m onto a rough floor, seen along that floor.
struct Landed {
  double along;  // m/s
  double up;     // m/s
  double spin;   // rad/s
};

Landed landed(const Vec2& size, double speed, double restitution, double friction, double turned,
              const Method& method) {
  const Vec2 up = turned_by(turned, Vec2::UnitY());
  const Vec2 along(up.y(), -up.x());
  Body floor = test::wall("floor", -0.5 * up, 40.0, 1.0);
  Body falls = box("box", (0.5 * size.y() + 0.3) * up + 0.1 * along, speed * along, size.x(), size.y());
  floor.angle = falls.angle = turned;
  RunSetup s = test::setup_with({floor, falls}, restitution, friction);
  s.scene.forces.gravity = -kG * up;
  s.method = method;
  Simulation run(s);
  // Without rebound it may be contact forces that stop it, at the end of a step.
  while (run.impact_count() == 0 && run.time() < std::sqrt(0.6 / kG) + method.step) run.step();
  const Vec2 v = run.state().velocity(1);
  return {v.dot(along), v.dot(up), run.state().v(2, 1)};
}

// Both ends of a face hold it: where friction stops its slip, or only slows it, and the resultant acts within
// the face, it does not turn. Beyond the front edge the impact is there, and it tips over.
TEST(FlatLandings, FrictionTurnsAFaceOnlyAboutItsEnd) {
  const double falls = std::sqrt(2.0 * kG * 0.3);
  for_every_way([&](const Method& method) {
    // What gravity does until the step's end, or in the step before it.
    const double about = 2.0 * kG * method.step;
    for (const double turned : {0.0, 0.3, -2.0}) {
      for (const double e : {0.0, 0.5}) {
        SCOPED_TRACE(testing::Message() << turned << " " << e);
        for (const double forth : {1.0, -1.0}) {
          const Landed stops = landed({0.3, 0.3}, 0.5 * forth, e, 0.4, turned, method);
          EXPECT_NEAR(stops.along, 0.0, 1e-12);
          EXPECT_NEAR(stops.up, e * falls, about);
          EXPECT_NEAR(stops.spin, 0.0, 1e-9);
          const Landed slides = landed({0.3, 0.3}, 3.0 * forth, e, 0.4, turned, method);
          EXPECT_NEAR(slides.along, forth * (3.0 - 0.4 * (1.0 + e) * falls), about);
          EXPECT_NEAR(slides.up, e * falls, about);
          EXPECT_NEAR(slides.spin, 0.0, 1e-9);
        }
      }
      // Contact forces stop it in two steps, and by the second one it has turned.
      if (method.contacts == ContactsId::kLasting && method.impacts == ImpactsId::kStepEnd) continue;
      const double inertia = (0.01 + 0.36) / 12.0;
      const double impulse = falls / (1.0 + 0.05 * (0.05 - 0.3 * 0.9) / inertia);
      const Landed tips = landed({0.1, 0.6}, 20.0, 0.0, 0.9, turned, method);
      EXPECT_NEAR(tips.along, 20.0 - 0.9 * impulse, about);
      EXPECT_NEAR(tips.up, impulse - falls, 10.0 * about);
      EXPECT_NEAR(tips.spin, (0.05 - 0.3 * 0.9) * impulse / inertia, 10.0 * about);
    }
  });
}

// Two or three welded boxes land flat and come to rest: nothing is too fast for a weld.
TEST(FlatLandings, WeldedBodiesComeToRestWithoutAWarning) {
  for (const int count : {2, 3}) {
    for (const double e : {0.2, 0.3, 0.5}) {
      for (const double turned : {0.0, 0.3, 1.1, 2.7}) {
        for (const double h : {0.001, 0.005}) {
          RunSetup s = test::setup_with({test::wall("floor", {0.0, -0.5}, 20.0, 1.0)}, e);
          for (int i = 0; i < count; ++i)
            s.scene.bodies.push_back(box("b" + std::to_string(i), {-0.3 * i, 0.6}, {0.0, 0.0}, 0.3, 0.2));
          for (int i = 1; i < count; ++i) {
            Joint weld;
            weld.kind = JointKind::kWeld;
            weld.body = "b" + std::to_string(i);
            weld.to = "b" + std::to_string(i - 1);
            weld.point = {0.15, 0.0};
            weld.anchor = {-0.15, 0.0};
            s.scene.joints.push_back(weld);
          }
          for (Body& body : s.scene.bodies) {
            body.position = turned_by(turned, body.position);
            body.angle = turned;
          }
          s.scene.forces.gravity = turned_by(turned, {0.0, -kG});
          s.method = {IntegratorId::kRk4, ImpactsId::kLocated, ContactsId::kLasting, h};
          Simulation run(s);
          run.advance_to(1.5);
          EXPECT_EQ(run.notices().text(), "ok") << count << " " << e << " " << turned << " " << h;
          EXPECT_LT(run.state().v.cwiseAbs().maxCoeff(), 1e-9);
        }
      }
    }
  }
}

// Hexagons that meet tip to tip without rebound go on together, and none turns: in free space and on a track,
// where their tips may come to touch at a step's end.
TEST(FlatLandings, TipsMeetStraightWithoutRebound) {
  const auto hexagon = [](const char* name, double x, double half, double speed, double mass) {
    Body body = test::disc(name, {x, 0.05}, {speed, 0.0}, 0.1, mass);
    body.shape = Polygon{
        {{-half, -0.05}, {half, -0.05}, {2.0 * half, 0.0}, {half, 0.05}, {-half, 0.05}, {-2.0 * half, 0.0}}};
    return body;
  };
  for_every_way([&](Method method) {
    for (const double h : {0.001, 0.005, 1.0 / 60.0}) {
      for (const double turned : {0.0, 0.3, -1.1}) {
        for (const bool on_track : {false, true}) {
          SCOPED_TRACE(testing::Message() << h << " " << turned << " " << on_track);
          // At 0.4 m/s they meet after 0.325 s, at the end of a step of 5 ms.
          RunSetup s = test::setup_with(
              {test::wall("track", {0.0, -0.5}, 20.0, 1.0), hexagon("first", -0.5, 0.05, 0.4, 1.0),
               hexagon("second", -0.12, 0.075, 0.0, 2.0)},
              0.0);
          if (!on_track) s.scene.bodies[0].position.y() = -5.0;
          for (Body& body : s.scene.bodies) {
            body.position = turned_by(turned, body.position);
            body.velocity = turned_by(turned, body.velocity);
            body.angle = turned;
          }
          if (on_track) s.scene.forces.gravity = turned_by(turned, {0.0, -kG});
          method.step = h;
          s.method = method;
          Simulation run(s);
          run.advance_to(0.7);
          // Where impacts are not located, or gravity presses without contact forces, there is an error of the
          // method.
          const bool exact =
              !on_track || (method.contacts == ContactsId::kLasting && method.impacts == ImpactsId::kLocated);
          for (const int k : {1, 2}) {
            const Vec2 v = turned_by(-turned, run.state().velocity(k));
            EXPECT_NEAR(v.x(), 0.4 / 3.0, exact ? 1e-9 : 2e-3) << k;
            EXPECT_NEAR(run.state().v(2, k), 0.0, exact ? 1e-9 : 0.1) << k;
          }
        }
      }
    }
  });
}

// A light box with a heavy one on it rocks from corner to corner as it slides; while one corner rests, the
// other one hits. Neither sinks into the other, and the last bounces end.
TEST(FlatLandings, AStackThatRocksComesToRest) {
  struct Stack {
    double restitution;
    double friction;
    double step;   // s
    double lift;   // m
    double speed;  // m/s
    double masses[2];
    Vec2 sizes[2];  // m
    double places[2];
  };
  for (const Stack& stack : {Stack{0.6,
                                   0.0,
                                   1.0 / 60.0,
                                   0.1120601,
                                   1.734098,
                                   {1.1110097, 2.8892572},
                                   {{0.7405972, 0.2805309}, {0.6973762, 0.2082858}},
                                   {-0.033266, 0.0349387}},
                             Stack{0.9,
                                   0.1,
                                   0.002,
                                   0.0519029,
                                   0.355654,
                                   {0.652619, 2.9517273},
                                   {{0.6995541, 0.3293232}, {0.5187864, 0.4392363}},
                                   {-0.0943465, -0.0255107}}}) {
    for (const double mirrored : {1.0, -1.0}) {
      RunSetup s =
          test::setup_with({test::wall("floor", {0.0, -0.5}, 20.0, 1.0)}, stack.restitution, stack.friction);
      double height = stack.lift;
      for (const int k : {0, 1}) {
        const Vec2& size = stack.sizes[k];
        s.scene.bodies.push_back(box(k == 0 ? "lower" : "upper",
                                     {mirrored * stack.places[k], height + 0.5 * size.y()},
                                     {mirrored * stack.speed, 0.0}, size.x(), size.y(), stack.masses[k]));
        height += size.y();
      }
      s.scene.forces.gravity = {0.0, -kG};
      s.method = {IntegratorId::kRk4, ImpactsId::kLocated, ContactsId::kLasting, stack.step};
      Simulation run(s);
      run.advance_to(1.2);
      EXPECT_LT(std::abs(run.ledger().penetration_correction), 0.05);
      EXPECT_NEAR(run.state().position(1).y(), 0.5 * stack.sizes[0].y(), 1e-9);
      EXPECT_NEAR(run.state().position(2).y(), stack.sizes[0].y() + 0.5 * stack.sizes[1].y(), 1e-9);
      for (const int k : {1, 2}) EXPECT_NEAR(run.state().q(2, k), 0.0, 1e-9);
    }
  }
}

// The bounces of stacks like these are not many.
TEST(FlatLandings, StacksThatRockMeetSomeHundredTimes) {
  test::Draws draw(5);
  std::int64_t impacts = 0;
  constexpr int kStacks = 40;
  for (int i = 0; i < kStacks; ++i) {
    RunSetup s = test::setup_with({test::wall("floor", {0.0, -0.5}, 20.0, 1.0)}, draw.between(0.3, 0.95),
                                  draw.between(0.05, 0.8));
    double height = draw.between(0.02, 0.15);
    const double speed = draw.between(-1.0, 1.0);
    for (const char* name : {"lower", "upper"}) {
      const Vec2 size(draw.between(0.4, 0.8), draw.between(0.2, 0.5));
      s.scene.bodies.push_back(box(name, {draw.between(-0.1, 0.1), height + 0.5 * size.y()}, {speed, 0.0},
                                   size.x(), size.y(), draw.between(0.5, 3.0)));
      height += size.y();
    }
    s.scene.forces.gravity = {0.0, -kG};
    s.method = {IntegratorId::kRk4, ImpactsId::kLocated, ContactsId::kLasting, i % 2 == 0 ? 0.005 : 0.002};
    Simulation run(s);
    run.advance_to(2.5);
    impacts += run.impact_count();
    EXPECT_EQ(run.notices().text(), "ok");
  }
  EXPECT_LT(impacts, 400 * kStacks);
}

}  // namespace
}  // namespace carom
