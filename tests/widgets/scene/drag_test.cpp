#include "widgets/scene/drag.h"

#include <gtest/gtest.h>
#include <numbers>

#include "widgets/scene/drag_limits.h"

namespace carom {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

Body disc_at(const char* name, double x, double y, double radius) {
  Body body;
  body.name = name;
  body.shape = Disc{radius};
  body.position = Vec2(x, y);
  return body;
}

DragStart start_of(HandleKind kind, const Body& body, const Vec2& press) {
  return {.kind = kind, .bodies = {body}, .others = {}, .press = press, .arrow_seconds = 0.5, .grid = 0.0};
}

// 100 px/m throughout.
Dragged drag(const DragStart& start, const Vec2& to, Qt::KeyboardModifiers keys = {}) {
  return drag_to(start, {.at = to, .scale = 100.0, .keys = keys});
}

TEST(DragTest, MovesRelativeToThePress) {
  const DragStart start = start_of(HandleKind::kBody, disc_at("light", 1.0, 1.0, 0.5), Vec2(1.2, 0.9));
  const Dragged moved = drag(start, Vec2(1.53, 0.78));
  EXPECT_TRUE(moved.bodies[0].position.isApprox(Vec2(1.33, 0.88), 1e-12));
  EXPECT_EQ(moved.value, "x 1.33 m, y 0.88 m");
  EXPECT_EQ(moved.name, "Move light");
}

TEST(DragTest, AWayAroundTheCentreChangesTheSpin) {
  Body light = disc_at("light", 1.0, 1.0, 0.5);
  light.spin = 1.0;
  const DragStart start = start_of(HandleKind::kSpin, light, Vec2(1.0, 0.4));
  const auto spun = [&](double degrees, Qt::KeyboardModifiers keys) {
    return drag_to(start, {.at = Vec2(1.0, 0.4), .scale = 100.0, .keys = keys, .swept = degrees * kDegree});
  };
  EXPECT_EQ(spun(17.0, {}).bodies[0].spin, 2.0);
  EXPECT_EQ(spun(17.0, {}).value, "2.00 rad/s");
  EXPECT_EQ(spun(17.0, {}).name, "Spin of light 1.00 → 2.00 rad/s");
  EXPECT_EQ(spun(-400.0, {}).bodies[0].spin, -25.5);
  EXPECT_NEAR(spun(17.0, Qt::ControlModifier).bodies[0].spin, 1.0 + 17.0 / 15.0, 1e-12);
  EXPECT_NEAR(spun(100.0, Qt::ShiftModifier).bodies[0].spin, 2.0 * std::numbers::pi, 1e-12);
  EXPECT_EQ(spun(100.0, Qt::ShiftModifier).detail, "1.00 turns a second · was 1.00 rad/s");
}

TEST(DragTest, ShiftKeepsTheLongerAxis) {
  const DragStart start = start_of(HandleKind::kBody, disc_at("light", 1.0, 1.0, 0.5), Vec2(1.0, 1.0));
  EXPECT_EQ(drag(start, Vec2(1.3, 1.2), Qt::ShiftModifier).bodies[0].position, Vec2(1.3, 1.0));
  EXPECT_EQ(drag(start, Vec2(1.1, 0.5), Qt::ShiftModifier).bodies[0].position, Vec2(1.0, 0.5));
}

TEST(DragTest, SnapsToTheGridWithinEightPixels) {
  DragStart start = start_of(HandleKind::kBody, disc_at("light", 1.0, 1.0, 0.5), Vec2(1.0, 1.0));
  start.grid = 0.2;
  EXPECT_EQ(drag(start, Vec2(1.27, 1.31)).bodies[0].position, Vec2(1.2, 1.31));
  EXPECT_EQ(drag(start, Vec2(1.33, 1.31)).bodies[0].position, Vec2(1.4, 1.31));
  EXPECT_EQ(drag(start, Vec2(1.33, 1.31), Qt::ControlModifier).bodies[0].position, Vec2(1.33, 1.31));
  // The held axis doesn't snap.
  start.bodies[0].position = Vec2(1.0, 1.03);
  EXPECT_EQ(drag(start, Vec2(1.27, 1.0), Qt::ShiftModifier).bodies[0].position, Vec2(1.2, 1.03));
}

TEST(DragTest, SnapsToTouchingBeforeTheGrid) {
  DragStart start = start_of(HandleKind::kBody, disc_at("light", 0.0, 0.0, 0.1), Vec2(0.0, 0.0));
  start.grid = 0.2;
  start.others = {disc_at("heavy", 1.0, 0.0, 0.2)};
  const Dragged moved = drag(start, Vec2(0.65, 0.0));
  EXPECT_NEAR(moved.bodies[0].position.x(), 0.7, 1e-12);
  EXPECT_EQ(moved.detail, "touches heavy");
  // Beside the line of the centres, along it.
  const Vec2 aslant = drag(start, Vec2(0.8, 0.2)).bodies[0].position;
  EXPECT_NEAR((aslant - Vec2(1.0, 0.0)).norm(), 0.3, 1e-12);
  // With Shift on the axis: the centre at x where (1 - x)² + 0.1² = 0.3².
  start.bodies[0].position = Vec2(0.0, 0.1);
  const Vec2 held = drag(start, Vec2(0.7, 0.0), Qt::ShiftModifier).bodies[0].position;
  EXPECT_NEAR(held.x(), 1.0 - std::sqrt(0.08), 1e-12);
  EXPECT_EQ(held.y(), 0.1);
}

TEST(DragTest, SnapsDiscsToBoxesAndBoxesToHalfPlanes) {
  Body box = disc_at("box", 0.0, -0.5, 0.0);
  box.shape = Box{4.0, 1.0};  // its top is y = 0
  DragStart start = start_of(HandleKind::kBody, disc_at("light", 0.0, 1.0, 0.1), Vec2(0.0, 1.0));
  start.others = {box};
  EXPECT_NEAR(drag(start, Vec2(0.5, 0.15)).bodies[0].position.y(), 0.1, 1e-9);
  Body ground = disc_at("ground", 0.0, 0.0, 0.0);
  ground.shape = Wall{};
  box.position = Vec2(0.0, 2.0);
  start = start_of(HandleKind::kBody, box, box.position);
  start.others = {ground};
  const Dragged moved = drag(start, Vec2(0.33, 0.45));
  EXPECT_NEAR(moved.bodies[0].position.y(), 0.5, 1e-12);
  EXPECT_EQ(moved.detail, "touches ground");
}

// Carts on a track, a box beside a thin wall, corner on face, and shapes of a compound.
TEST(DragTest, AnyTwoShapesSnapToTouching) {
  const auto boxed = [](const char* name, double x, double y, double width, double height, double angle = 0.0) {
    Body body = disc_at(name, x, y, 0.0);
    body.shape = Box{width, height};
    body.angle = angle;
    return body;
  };
  const auto moved_to = [](const Body& body, const Body& other, const Vec2& by) {
    DragStart start = start_of(HandleKind::kBody, body, Vec2::Zero());
    start.others = {other};
    return drag(start, by).bodies[0].position;
  };
  const Body cart = boxed("cart", 0.0, 0.1, 0.3, 0.2);
  EXPECT_NEAR(moved_to(cart, boxed("other", 1.0, 0.1, 0.3, 0.2), Vec2(0.66, 0.03)).x(), 0.7, 1e-12);
  EXPECT_NEAR(moved_to(cart, boxed("other", 1.0, 0.1, 0.3, 0.2), Vec2(0.75, 0.0)).x(), 0.7, 1e-12);
  Body post = disc_at("post", 1.0, 0.0, 0.0);
  post.shape = Wall{2.0};
  post.angle = 90.0 * kDegree;
  EXPECT_NEAR(moved_to(cart, post, Vec2(0.8, 0.0)).x(), 0.85, 1e-12);
  const Body tilted = boxed("tilted", 0.0, 1.0, 0.2, 0.2, 45.0 * kDegree);
  const double low = 0.1 * std::numbers::sqrt2;
  EXPECT_NEAR(moved_to(tilted, boxed("table", 0.0, -0.5, 4.0, 1.0), Vec2(0.1, low - 1.03)).y(), low, 1e-12);
  EXPECT_EQ(moved_to(cart, boxed("other", 1.0, 0.1, 0.3, 0.2), Vec2(0.6, 0.0)), Vec2(0.6, 0.1)) << "10 px away";
  Body hollow = boxed("hollow", 0.0, 0.0, 0.1, 0.1);
  const auto placed = [](double x) {
    PlacedShape shape;
    shape.shape = Box{0.1, 0.1};
    shape.position.x() = x;
    return shape;
  };
  hollow.shape = Compound{{placed(-0.2), placed(0.2)}};
  EXPECT_NEAR(moved_to(hollow, post, Vec2(0.73, 0.0)).x(), 0.75, 1e-12);
}

TEST(DragTest, SeveralBodiesMoveTogether) {
  DragStart start = start_of(HandleKind::kBody, disc_at("a", 0.0, 0.0, 0.1), Vec2(0.0, 0.0));
  start.bodies.push_back(disc_at("b", 1.0, 0.5, 0.1));
  start.bodies.push_back(disc_at("c", 2.0, 0.5, 0.1));
  const Dragged moved = drag(start, Vec2(0.25, -0.5));
  EXPECT_EQ(moved.bodies[1].position, Vec2(1.25, 0.0));
  EXPECT_EQ(moved.bodies[2].position, Vec2(2.25, 0.0));
  EXPECT_EQ(moved.name, "Move 3 bodies");
}

// 0.5 m of arrow for each m/s: the tip of 1 m/s stands 0.5 m from the centre.
class VelocityDragTest : public testing::Test {
 protected:
  VelocityDragTest() {
    Body body = disc_at("light", 0.0, 0.0, 0.1);
    body.velocity = Vec2(1.0, 0.0);
    start_ = start_of(HandleKind::kVelocity, body, Vec2(0.5, 0.0));
  }
  DragStart start_;
};

TEST_F(VelocityDragTest, FollowsTheArrowScaleAndSnaps) {
  const Dragged pulled = drag(start_, Vec2(1.01, 0.02));
  EXPECT_EQ(pulled.bodies[0].velocity, Vec2(2.0, 0.0));
  EXPECT_EQ(pulled.value, "2.0 m/s at 0°");
  EXPECT_EQ(pulled.detail, "v = (2.00, 0.00) m/s · was (1.00, 0.00)");
  EXPECT_EQ(pulled.name, "Speed of light 1.00 → 2.00 m/s");
  const Dragged up = drag(start_, 1.02 * Vec2(std::cos(12 * kDegree), std::sin(12 * kDegree)));
  EXPECT_TRUE(
      up.bodies[0].velocity.isApprox(2.0 * Vec2(std::cos(15 * kDegree), std::sin(15 * kDegree)), 1e-12));
  EXPECT_EQ(up.value, "2.0 m/s at 15°");
}

TEST_F(VelocityDragTest, ControlSnapsNothing) {
  const Dragged pulled = drag(start_, Vec2(1.015, 0.1), Qt::ControlModifier);
  EXPECT_TRUE(pulled.bodies[0].velocity.isApprox(Vec2(2.03, 0.2), 1e-12));
}

TEST_F(VelocityDragTest, ShiftKeepsTheDirection) {
  EXPECT_EQ(drag(start_, Vec2(0.81, 0.4), Qt::ShiftModifier).bodies[0].velocity, Vec2(1.6, 0.0));
  EXPECT_EQ(drag(start_, Vec2(-0.8, 0.4), Qt::ShiftModifier).bodies[0].velocity, Vec2(0.0, 0.0));
}

TEST_F(VelocityDragTest, IntoTheBodyIsAtRest) {
  const Dragged stopped = drag(start_, Vec2(0.06, 0.04));
  EXPECT_EQ(stopped.bodies[0].velocity, Vec2(0.0, 0.0));
  EXPECT_EQ(stopped.value, "0.0 m/s");
}

TEST_F(VelocityDragTest, AGripOfABodyAtRestIsRelative) {
  start_.bodies[0].velocity.setZero();
  EXPECT_EQ(drag(start_, Vec2(0.75, 0.0)).bodies[0].velocity, Vec2(0.5, 0.0));
}

TEST_F(VelocityDragTest, SeveralGetTheSameChange) {
  start_.bodies.push_back(disc_at("b", 1.0, 1.0, 0.1));
  start_.bodies[1].velocity = Vec2(0.0, -1.0);
  const Dragged pulled = drag(start_, Vec2(1.0, 0.0));
  EXPECT_EQ(pulled.bodies[1].velocity, Vec2(1.0, -1.0));
  EXPECT_EQ(pulled.name, "Speed of 2 bodies");
}

TEST_F(VelocityDragTest, TheSameSpeedIsNamedByItsDirection) {
  EXPECT_EQ(drag(start_, Vec2(0.0, 0.5)).name, "Direction of light 0° → 90°");
}

TEST(DragTest, TurnsInAbsoluteSteps) {
  Body body = disc_at("light", 0.0, 0.0, 0.1);
  body.angle = 3.0 * kDegree;
  const DragStart start = start_of(HandleKind::kTurn, body, Vec2(0.0, 1.0));
  const auto at = [](double degrees) {
    return Vec2(-std::sin(degrees * kDegree), std::cos(degrees * kDegree));
  };
  EXPECT_NEAR(drag(start, at(20.0)).bodies[0].angle, 25.0 * kDegree, 1e-12);
  EXPECT_EQ(drag(start, at(20.0)).value, "25°");
  EXPECT_EQ(drag(start, at(20.0)).detail, "was 3°");
  EXPECT_EQ(drag(start, at(20.0), Qt::ControlModifier).detail, "was 3.0°");
  EXPECT_NEAR(drag(start, at(40.0), Qt::ShiftModifier).bodies[0].angle, 45.0 * kDegree, 1e-12);
  EXPECT_NEAR(drag(start, at(-10.4), Qt::ControlModifier).bodies[0].angle, -7.4 * kDegree, 1e-12);
  EXPECT_EQ(drag(start, at(20.0)).name, "Turn light");
}

TEST(DragTest, ResizesADiscAtItsDensity) {
  Body body = disc_at("light", 1.0, 1.0, 0.1);
  body.mass = 1.0;
  body.inertia = 0.01;
  const DragStart start = start_of(HandleKind::kRadius, body, Vec2(1.2, 1.2));
  // The corner 0.098 m farther out in x and y.
  const Dragged resized = drag(start, Vec2(1.298, 1.298));
  EXPECT_NEAR(std::get<Disc>(resized.bodies[0].shape).radius, 0.2, 1e-12);
  EXPECT_NEAR(*resized.bodies[0].mass, 4.0, 1e-12);
  EXPECT_NEAR(*resized.bodies[0].inertia, 0.16, 1e-12);
  EXPECT_EQ(resized.bodies[0].position, Vec2(1.0, 1.0));
  EXPECT_EQ(resized.value, "r 0.20 m");
  EXPECT_EQ(resized.detail, "m = 4 kg · was 0.10 m");
  EXPECT_EQ(resized.name, "Resize light");
  EXPECT_NEAR(std::get<Disc>(drag(start, Vec2(1.298, 1.298), Qt::ControlModifier).bodies[0].shape).radius,
              0.198, 1e-12);
  EXPECT_GT(std::get<Disc>(drag(start, Vec2(1.0, 1.0)).bodies[0].shape).radius, 0.0);
}

TEST(DragTest, ResizesABoxFromItsFarSide) {
  Body body = disc_at("box", 1.0, 1.0, 0.0);
  body.shape = Box{0.4, 0.2};
  body.angle = 90.0 * kDegree;  // its right side points up
  body.mass = 1.0;
  const DragStart start = start_of(HandleKind::kRight, body, Vec2(1.0, 1.3));
  const Dragged resized = drag(start, Vec2(1.07, 1.504));
  const Box box = std::get<Box>(resized.bodies[0].shape);
  EXPECT_NEAR(box.width, 0.6, 1e-12);
  EXPECT_NEAR(box.height, 0.2, 1e-12);
  EXPECT_TRUE(resized.bodies[0].position.isApprox(Vec2(1.0, 1.1), 1e-12));
  EXPECT_NEAR(*resized.bodies[0].mass, 1.5, 1e-12);
  EXPECT_EQ(resized.value, "0.60 m × 0.20 m");
  EXPECT_NEAR(std::get<Box>(drag(start, Vec2(1.07, 1.504), Qt::ShiftModifier).bodies[0].shape).height, 0.3,
              1e-12);
}

TEST(DragTest, ResizesACompoundAboutItsCentre) {
  Body body = disc_at("dumbbell", 1.0, 1.0, 0.0);
  const auto placed = [](double x) {
    PlacedShape shape;
    shape.shape = Disc{0.1};
    shape.position.x() = x;
    return shape;
  };
  body.shape = Compound{{placed(-0.3), placed(0.3)}};
  body.mass = 2.0;
  const DragStart start = start_of(HandleKind::kRadius, body, Vec2(1.3, 1.3));
  const Dragged resized = drag(start, Vec2(1.452, 1.45));
  const auto& shapes = std::get<Compound>(resized.bodies[0].shape).shapes;
  EXPECT_NEAR(std::get<Disc>(shapes[0].shape).radius, 0.15, 1e-12);
  EXPECT_NEAR(shapes[1].position.x(), 0.45, 1e-12);
  EXPECT_NEAR(*resized.bodies[0].mass, 4.5, 1e-12);
  EXPECT_EQ(resized.value, "1.20 m × 0.30 m");
  EXPECT_NEAR(
      std::get<Disc>(std::get<Compound>(drag(start, Vec2(1.0, 1.0)).bodies[0].shape).shapes[0].shape).radius,
      0.005, 1e-12);
}

// And with it what pulls beside the centre, which moves by 0.1 m; what pulls at the centre goes with that.
TEST(DragTest, SpringsAndForcesStayAtAResizedBox) {
  Body body = disc_at("box", 1.0, 1.0, 0.0);
  body.shape = Box{0.4, 0.2};
  body.angle = 90.0 * kDegree;
  DragStart start = start_of(HandleKind::kRight, body, Vec2(1.0, 1.3));
  Spring spring;
  spring.body = "box";
  spring.point = Vec2(-0.2, 0.0);
  Spring at_centre;
  at_centre.body = "box";
  AppliedForce force;
  force.body = "box";
  force.point = Vec2(0.1, 0.1);
  start.forces.springs = {spring, at_centre};
  start.forces.applied = {force};
  const auto attached_at = [&](const Vec2& mouse) {
    const DragPoint point{.at = mouse, .scale = 100.0};
    return within_joints(start, drag_to(start, point), point).attached;
  };
  const SceneEdits moved = attached_at(Vec2(1.0, 1.5));
  ASSERT_EQ(moved.size(), 2U);
  EXPECT_TRUE(std::get<Replace<Spring>>(moved[0]).part.point.isApprox(Vec2(-0.3, 0.0), 1e-12));
  EXPECT_TRUE(std::get<Replace<AppliedForce>>(moved[1]).part.point.isApprox(Vec2(0.0, 0.1), 1e-9));
  EXPECT_TRUE(
      std::get<Replace<Spring>>(attached_at(Vec2(1.0, 1.3)).at(0)).part.point.isApprox(spring.point, 1e-12));
}

TEST(DragTest, TheFarEndOfATurnedWallStays) {
  Body wall = disc_at("ramp", 1.0, 1.0, 0.0);
  wall.shape = Wall{1.0};
  wall.fixed = true;
  wall.angle = 30.0 * kDegree;
  const Vec2 along(std::cos(wall.angle), std::sin(wall.angle));
  const DragStart right = start_of(HandleKind::kRight, wall, wall.position + 0.58 * along);
  const Dragged grown = drag(right, wall.position + 0.78 * along + Vec2(-0.05, 0.0866));
  EXPECT_NEAR(*std::get<Wall>(grown.bodies[0].shape).length, 1.2, 1e-12);
  EXPECT_TRUE(grown.bodies[0].position.isApprox(wall.position + 0.1 * along, 1e-12));
  EXPECT_EQ(grown.bodies[0].angle, wall.angle);
  EXPECT_EQ(grown.value, "1.20 m");
  EXPECT_EQ(grown.detail, "was 1.00 m");
  EXPECT_EQ(grown.name, "Resize ramp");
  const DragStart left = start_of(HandleKind::kLeft, wall, wall.position - 0.58 * along);
  const Dragged shrunk = drag(left, wall.position - 0.18 * along);
  EXPECT_NEAR(*std::get<Wall>(shrunk.bodies[0].shape).length, 0.6, 1e-12);
  EXPECT_TRUE(shrunk.bodies[0].position.isApprox(wall.position + 0.2 * along, 1e-12));
}

TEST(DragTest, TheFarCornerOfABoxStays) {
  Body box = disc_at("box", 1.0, 1.0, 0.1);
  box.shape = Box{0.4, 0.2};
  box.mass = 2.0;
  const DragStart start = start_of(HandleKind::kTopRight, box, Vec2(1.2, 1.1));
  const Dragged grown = drag(start, Vec2(1.401, 1.199));
  const Box size = std::get<Box>(grown.bodies[0].shape);
  EXPECT_DOUBLE_EQ(size.width, 0.6);
  EXPECT_DOUBLE_EQ(size.height, 0.3);
  EXPECT_TRUE(grown.bodies[0].position.isApprox(Vec2(1.1, 1.05), 1e-12));
  EXPECT_NEAR(*grown.bodies[0].mass, 4.5, 1e-12);
  EXPECT_EQ(grown.value, "0.60 m × 0.30 m");
  // Proportions: the larger change leads.
  const Dragged alike = drag(start, Vec2(1.6, 1.1), Qt::ShiftModifier);
  EXPECT_DOUBLE_EQ(std::get<Box>(alike.bodies[0].shape).height, 0.4);
  EXPECT_TRUE(alike.bodies[0].position.isApprox(Vec2(1.2, 1.1), 1e-12));
  // A quarter turn: the corner at the upper right is now that at the upper left.
  box.angle = 0.5 * std::numbers::pi;
  const Dragged turned = drag(start_of(HandleKind::kTopRight, box, Vec2(0.9, 1.2)), Vec2(0.8, 1.4));
  EXPECT_TRUE(turned.bodies[0].position.isApprox(Vec2(0.95, 1.1), 1e-12));
  EXPECT_DOUBLE_EQ(std::get<Box>(turned.bodies[0].shape).width, 0.6);
}

}  // namespace
}  // namespace carom
