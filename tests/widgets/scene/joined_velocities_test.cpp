#include "widgets/scene/joined_velocities.h"

#include <cmath>
#include <gtest/gtest.h>
#include <random>

#include "physics/math/vectors.h"

namespace carom {
namespace {

class JoinedVelocities : public testing::Test {
 protected:
  double number(double from, double to) { return std::uniform_real_distribution<>(from, to)(random_); }
  Vec2 vector() { return {number(-1.0, 1.0), number(-1.0, 1.0)}; }
  Body body(const char* name) {
    Body out;
    out.name = name;
    out.shape = Box{number(0.1, 1.0), number(0.1, 1.0)};
    out.mass = number(0.1, 10.0);
    out.position = vector();
    out.angle = number(-3.0, 3.0);
    out.velocity = vector();
    out.spin = number(-5.0, 5.0);
    return out;
  }
  // A joint that holds the bodies at places of the world; no second body: on the plane.
  static Joint joint_of(JointKind kind, const Body& a, const Vec2& at, const Body* b, const Vec2& other) {
    const auto own = [](const Body& body, const Vec2& place) {
      return turned_by(-body.angle, place - body.position);
    };
    Joint joint;
    joint.kind = kind;
    joint.body = a.name;
    joint.point = own(a, at);
    joint.to = b != nullptr ? b->name : "";
    joint.anchor = b != nullptr ? own(*b, other) : other;
    return joint;
  }
  static std::vector<Body> joined(std::vector<Body> bodies, const std::vector<Joint>& joints) {
    Scene scene;
    scene.bodies = std::move(bodies);
    scene.joints = joints;
    return as_joined(scene, joints.back());
  }
  static Vec2 velocity_at(const Body& body, const Vec2& place) {
    return body.velocity + body.spin * crossed(place - body.position);
  }
  static double angular_momentum(const Body& b) {
    const Vec2 p = mass_of(b) * b.velocity;
    return b.position.x() * p.y() - b.position.y() * p.x() + inertia_of(b) * b.spin;
  }
  static double kinetic(const Body& b) {
    return 0.5 * mass_of(b) * b.velocity.squaredNorm() + 0.5 * inertia_of(b) * b.spin * b.spin;
  }
  std::mt19937 random_{7};
};

TEST_F(JoinedVelocities, EndsMoveTogetherAndMomentumStays) {
  for (int k = 0; k < 300; ++k) {
    const Body a = body("a");
    const Body b = body("b");
    for (const JointKind kind : {JointKind::kRod, JointKind::kPin, JointKind::kWeld}) {
      const Vec2 at = vector();
      const Vec2 other = kind == JointKind::kRod ? vector() : at;
      const Joint joint = joint_of(kind, a, at, &b, other);
      const std::vector<Body> now = joined({a, b}, {joint});
      ASSERT_EQ(now.size(), 2U);
      const Vec2 apart = velocity_at(now[0], at) - velocity_at(now[1], other);
      if (kind == JointKind::kRod) {
        EXPECT_NEAR((at - other).normalized().dot(apart), 0.0, 1e-12);
      } else {
        EXPECT_NEAR(apart.norm(), 0.0, 1e-12);
      }
      if (kind == JointKind::kWeld) {
        EXPECT_NEAR(now[0].spin, now[1].spin, 1e-12);
      }
      const auto momentum = [](const Body& x, const Body& y) {
        return Vec2(mass_of(x) * x.velocity + mass_of(y) * y.velocity);
      };
      EXPECT_NEAR((momentum(now[0], now[1]) - momentum(a, b)).norm(), 0.0, 1e-12);
      EXPECT_NEAR(angular_momentum(now[0]) + angular_momentum(now[1]),
                  angular_momentum(a) + angular_momentum(b), 1e-11);
      EXPECT_LE(kinetic(now[0]) + kinetic(now[1]), kinetic(a) + kinetic(b));
      EXPECT_TRUE(joined(now, {joint}).empty()) << "it is allowed now";
    }
  }
}

// A joint on one body of a chain: the others keep holding, and all of them share what is lost.
TEST_F(JoinedVelocities, AChainStaysJoined) {
  Body a = body("a");
  Body b = body("b");
  Body c = body("c");
  for (Body* each : {&a, &b, &c}) {
    each->velocity = Vec2(0.4, -0.2);
    each->spin = 0.0;
  }
  const std::vector<Joint> joints = {joint_of(JointKind::kPin, a, b.position, &b, b.position),
                                     joint_of(JointKind::kRod, b, b.position, &c, c.position),
                                     joint_of(JointKind::kString, b, b.position, nullptr, Vec2(9.0, 9.0)),
                                     joint_of(JointKind::kPin, a, a.position, nullptr, a.position)};
  const std::vector<Body> now = joined({a, b, c}, joints);
  ASSERT_EQ(now.size(), 3U);
  EXPECT_NEAR(now[0].velocity.norm(), 0.0, 1e-14);
  EXPECT_NEAR((velocity_at(now[0], b.position) - now[1].velocity).norm(), 0.0, 1e-14);
  EXPECT_NEAR((b.position - c.position).normalized().dot(now[1].velocity - now[2].velocity), 0.0, 1e-14);
  EXPECT_LT(kinetic(now[0]) + kinetic(now[1]) + kinetic(now[2]), kinetic(a) + kinetic(b) + kinetic(c));
}

TEST_F(JoinedVelocities, ThePlaneAndFixedBodiesTakeMomentum) {
  Body bob = body("bob");
  bob.position = {0.0, -1.0};
  bob.velocity = {0.3, 0.4};
  bob.spin = 2.0;
  const std::vector<Body> swings =
      joined({bob}, {joint_of(JointKind::kRod, bob, bob.position, nullptr, Vec2::Zero())});
  ASSERT_EQ(swings.size(), 1U);
  EXPECT_NEAR((swings[0].velocity - Vec2(0.3, 0.0)).norm(), 0.0, 1e-15);
  EXPECT_EQ(swings[0].spin, 2.0);
  Body table = body("table");
  table.fixed = true;
  table.velocity.setZero();
  table.spin = 0.0;
  const std::vector<Body> stopped =
      joined({bob, table}, {joint_of(JointKind::kWeld, bob, Vec2(0, -1), &table, Vec2(0, -1))});
  ASSERT_EQ(stopped.size(), 1U);
  EXPECT_NEAR(stopped[0].velocity.norm() + std::abs(stopped[0].spin), 0.0, 1e-14);
  EXPECT_TRUE(joined({bob}, {joint_of(JointKind::kString, bob, bob.position, nullptr, Vec2::Zero())}).empty());
}

// Nothing turns it.
TEST_F(JoinedVelocities, APointIsPinnedOrWelded) {
  Body point = body("point");
  point.shape = Disc{0.0};
  point.spin = 0.0;
  const Body box = body("box");
  for (const JointKind kind : {JointKind::kPin, JointKind::kWeld}) {
    const Vec2 at = point.position;
    const std::vector<Body> now = joined({point, box}, {joint_of(kind, point, at, &box, at)});
    ASSERT_EQ(now.size(), 2U);
    EXPECT_NEAR((now[0].velocity - velocity_at(now[1], at)).norm(), 0.0, 1e-12);
    EXPECT_EQ(now[0].spin, 0.0);
    EXPECT_NEAR(angular_momentum(now[0]) + angular_momentum(now[1]),
                angular_momentum(point) + angular_momentum(box), 1e-11);
  }
}

}  // namespace
}  // namespace carom
