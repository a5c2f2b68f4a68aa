#include <array>
#include <cmath>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <numbers>
#include <string>
#include <vector>

#include "physics/dynamics/integrators/integrators.h"
#include "tests/support/scenes.h"

// A box in a corner of a room, where its own corner is the end of both contacts: floor and wall hold it both,
// whatever rounding or a method's error puts into the one or the other.
namespace carom {
namespace {

constexpr double kG = 9.81;

// The wall at the left of a floor y = 0.
enum class Left { kHalfPlane, kBelow, kFloor, kLow };
constexpr std::array<Left, 4> kLefts = {Left::kHalfPlane, Left::kBelow, Left::kFloor, Left::kLow};

// A floor and a wall whose face is x = 0, and the box a beside it, of this size; without friction.
RunSetup corner(Left left, double width, double height, double friction = 0.0) {
  std::vector<Body> bodies = {test::fixed("floor", Wall{}, {0.0, 0.0})};
  if (left == Left::kHalfPlane) {
    bodies.push_back(test::fixed("wall", Wall{}, {0.0, 0.0}));
    bodies.back().angle = -0.5 * std::numbers::pi;
  } else {
    const double low = left == Left::kBelow ? -0.3 : 0.0;
    const double high = left == Left::kLow ? 0.8 * height : 1.0;
    bodies.push_back(test::wall("wall", {-0.1, 0.5 * (low + high)}, 0.2, high - low));
  }
  bodies.push_back(test::box("a", {0.5 * width, 0.5 * height}, Vec2::Zero(), width, height));
  RunSetup s = test::setup_with(std::move(bodies), 0.0, friction);
  s.scene.forces.gravity = {0.0, -kG};
  s.method.contacts = ContactsId::kLasting;
  return s;
}

void push(RunSetup& s, const Vec2& force, double rise = 0.0) {
  AppliedForce applied;
  applied.body = "a";
  applied.force = force;
  applied.rise = rise;
  s.scene.forces.applied.push_back(applied);
}

// Turned about the origin, and shifted.
RunSetup placed(RunSetup s, double angle, const Vec2& shift) {
  const double c = std::cos(angle);
  const double sine = std::sin(angle);
  const auto turned = [&](const Vec2& v) { return Vec2(c * v.x() - sine * v.y(), sine * v.x() + c * v.y()); };
  for (Body& b : s.scene.bodies) {
    b.position = shift + turned(b.position);
    b.angle += angle;
  }
  s.scene.forces.gravity = turned(s.scene.forces.gravity);
  for (AppliedForce& f : s.scene.forces.applied) f.force = turned(f.force);
  return s;
}

TEST(RoomCorners, ABoxThatIsPushedIntoOneStays) {
  for (const Left left : kLefts) {
    for (const auto& impacts : kImpacts) {
      for (const double h : {0.02, 0.01, 0.005, 0.002}) {
        for (const double angle : {0.0, 0.3, -2.2}) {
          for (const double force : {1.0, 1e-9, 30.0}) {
            RunSetup s = corner(left, 0.2, 0.1, force == 30.0 ? 0.3 : 0.0);
            push(s, {-force, 0.0});
            s = placed(std::move(s), angle, {0.37 * angle, 0.11});
            s.method.impacts = impacts.id;
            s.method.step = h;
            Simulation run(s);
            run.advance_to(0.4);
            const std::string where = fmt::format("wall {}, {}, h {}, turned {}, {} N", static_cast<int>(left),
                                                  impacts.name, h, angle, force);
            EXPECT_NEAR((run.state().position(2) - s.scene.bodies[2].position).norm(), 0.0, 1e-9) << where;
            EXPECT_LT(run.state().velocity(2).norm(), 1e-9) << where;
            EXPECT_NEAR(run.ledger().lost_to_restitution, 0.0, 1e-12) << where;
            EXPECT_EQ(run.impact_count(), 0) << where;
            EXPECT_EQ(run.notices().text(), "ok") << where;
          }
        }
      }
    }
  }
}

// A force that rises lets it go: at F = -5 N + t 10 N/s after half a second, from where x grows as t³.
TEST(RoomCorners, ABoxIsLetGoAtItsMoment) {
  for (const Left left : kLefts) {
    for (const auto& [width, height] : {std::pair(0.2, 0.1), std::pair(0.05, 0.5)}) {
      for (const double h : {0.02, 0.01, 0.005}) {
        RunSetup s = corner(left, width, height);
        push(s, {-5.0, 0.0});
        push(s, {10.0, 0.0}, 1.0);
        s.method.step = h;
        Simulation run(s);
        run.advance_to(0.8);
        EXPECT_NEAR(run.state().position(2).x(), 0.5 * width + 10.0 * std::pow(0.3, 3) / 6.0, 1e-10)
            << static_cast<int>(left) << ", " << width << ", " << h;
        EXPECT_NEAR(run.state().v(2, 2), 0.0, 1e-9);
        EXPECT_NEAR(run.ledger().lost_to_restitution, 0.0, 1e-12);
        EXPECT_EQ(run.notices().text(), "ok");
      }
    }
  }
}

// A spring between two boxes, the one at the wall: as without floor and weight, but for the method's error.
TEST(RoomCorners, TwoBoxesPartAsWithoutAFloor) {
  for (const double h : {0.01, 0.005}) {
    std::array<State, 2> ends;
    for (const bool floor : {false, true}) {
      RunSetup s = corner(Left::kHalfPlane, 0.2, 0.1);
      s.scene.bodies.push_back(test::box("b", {0.4, 0.05}, Vec2::Zero(), 0.2, 0.1, 2.0));
      Spring spring;
      spring.body = "a";
      spring.to = "b";
      spring.stiffness = 100.0;
      spring.rest_length = 0.5;
      s.scene.forces.springs = {spring};
      s.method.step = h;
      if (!floor) {
        s.scene.forces.gravity.setZero();
        s.scene.bodies.front().position.y() = -1.0;
      }
      Simulation run(s);
      run.advance_to(0.6);
      EXPECT_EQ(run.impact_count(), 0) << floor << ", " << h;
      ends[floor ? 1 : 0] = run.state();
    }
    EXPECT_NEAR((ends[0].q - ends[1].q).rightCols(2).cwiseAbs().maxCoeff(), 0.0, 2.0 * std::pow(h, 4)) << h;
    EXPECT_NEAR((ends[0].v - ends[1].v).rightCols(2).cwiseAbs().maxCoeff(), 0.0, 10.0 * std::pow(h, 4)) << h;
  }
}

// A driven ram that reaches down to the floor pushes a box, and lets it go where it is fastest.
TEST(RoomCorners, ARamPushesABoxAlongTheFloor) {
  for (const double h : {0.02, 0.01, 0.005}) {
    Body ram = test::box("ram", {0.05, 0.2}, Vec2::Zero(), 0.1, 0.4);
    ram.mass.reset();
    ram.drive = Drive{.velocity = Vec2::Zero(),
                      .amplitude = {0.1, 0.0},
                      .angular_frequency = 5.0,
                      .phase = -0.5 * std::numbers::pi};
    RunSetup s = test::setup_with(
        {test::fixed("floor", Wall{}, {0.0, 0.0}), ram, test::box("a", {0.1, 0.05}, Vec2::Zero(), 0.2, 0.1)},
        0.0);
    s.scene.forces.gravity = {0.0, -kG};
    s.method.contacts = ContactsId::kLasting;
    s.method.step = h;
    Simulation run(s);
    run.advance_to(0.5);
    EXPECT_NEAR(run.state().position(2).x(), 0.2 + 0.5 * (0.5 - 0.1 * std::numbers::pi), 1e-7) << h;
    EXPECT_NEAR(run.state().v(2, 2), 0.0, 1e-9);
    EXPECT_NEAR(run.ledger().lost_to_restitution, 0.0, 1e-12);
  }
}

// Friction holds a box against a force that rises, in a corner as on the floor alone: it does not creep.
TEST(RoomCorners, FrictionHoldsABoxAgainstARisingForce) {
  for (const Left left : kLefts) {
    for (const double h : {0.02, 0.01, 0.005}) {
      RunSetup s = corner(left, 0.2, 0.1, 0.3);
      push(s, {-5.0, 0.0}, 0.5);
      s.method.step = h;
      Simulation run(s);
      run.advance_to(0.5);
      EXPECT_NEAR(run.state().position(2).x(), 0.1, 1e-9) << static_cast<int>(left) << ", " << h;
      EXPECT_EQ(run.impact_count(), 0);
      EXPECT_EQ(run.notices().text(), "ok");
    }
  }
}

}  // namespace
}  // namespace carom
