#include "widgets/scene/joint_start.h"

#include <cmath>
#include <gtest/gtest.h>
#include <random>

#include "physics/math/vectors.h"

namespace carom {
namespace {

class JointStart : public testing::Test {
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

TEST_F(JointStart, EndsMoveTogetherAndMomentumStays) {
  for (int k = 0; k < 300; ++k) {
    const Body a = body("a");
    const Body b = body("b");
    for (const JointKind kind : {JointKind::kRod, JointKind::kPin, JointKind::kWeld}) {
      const Vec2 at = vector();
      const JointEnds ends{{a, b}, {at, kind == JointKind::kRod ? vector() : at}};
      const std::vector<Body> now = as_joined(kind, ends);
      ASSERT_EQ(now.size(), 2U);
      const Vec2 apart = velocity_at(now[0], ends.places[0]) - velocity_at(now[1], ends.places[1]);
      if (kind == JointKind::kRod) {
        EXPECT_NEAR((ends.places[0] - ends.places[1]).normalized().dot(apart), 0.0, 1e-12);
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
      EXPECT_TRUE(as_joined(kind, {{now[0], now[1]}, ends.places}).empty()) << "it is allowed now";
    }
  }
}

TEST_F(JointStart, ThePlaneAndFixedBodiesTakeMomentum) {
  Body bob = body("bob");
  bob.position = {0.0, -1.0};
  bob.velocity = {0.3, 0.4};
  bob.spin = 2.0;
  const JointEnds rod{{bob, std::nullopt}, {bob.position, Vec2::Zero()}};
  const std::vector<Body> swings = as_joined(JointKind::kRod, rod);
  ASSERT_EQ(swings.size(), 1U);
  EXPECT_NEAR((swings[0].velocity - Vec2(0.3, 0.0)).norm(), 0.0, 1e-15);
  EXPECT_EQ(swings[0].spin, 2.0);
  Body table = body("table");
  table.fixed = true;
  table.velocity.setZero();
  table.spin = 0.0;
  const std::vector<Body> stopped = as_joined(JointKind::kWeld, {{bob, table}, {Vec2(0, -1), Vec2(0, -1)}});
  ASSERT_EQ(stopped.size(), 1U);
  EXPECT_NEAR(stopped[0].velocity.norm() + std::abs(stopped[0].spin), 0.0, 1e-14);
  EXPECT_TRUE(as_joined(JointKind::kString, rod).empty());
}

// Nothing turns it.
TEST_F(JointStart, APointIsWelded) {
  Body point = body("point");
  point.shape = Disc{0.0};
  point.spin = 0.0;
  const Body box = body("box");
  const std::vector<Body> now = as_joined(JointKind::kPin, {{point, box}, {point.position, point.position}});
  ASSERT_EQ(now.size(), 2U);
  EXPECT_NEAR((now[0].velocity - velocity_at(now[1], point.position)).norm(), 0.0, 1e-12);
  EXPECT_EQ(now[0].spin, 0.0);
}

}  // namespace
}  // namespace carom
