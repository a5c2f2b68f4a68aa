#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "physics/run/run_setup.h"
#include "tests/support/scenes.h"

// Small bodies on very long floors: what they do doesn't depend on the length.
namespace carom {
namespace {

constexpr double kSize = 0.01;  // m, of the bodies
constexpr double kSpeed = 0.3;  // m/s

struct LongFloors {
  std::vector<Body> bodies;
  std::vector<Body> floors;
  double restitution = 0.0;
  double friction = 0.0;
};

// The places of the bodies in sizes, their angles and their velocities in the unit of speed, after a while.
std::vector<double> end_of(const LongFloors& scene) {
  RunSetup s = test::setup_with(scene.bodies, scene.restitution, scene.friction);
  s.scene.bodies.insert(s.scene.bodies.end(), scene.floors.begin(), scene.floors.end());
  s.scene.forces.gravity = {0.0, -9.81};
  s.method = {IntegratorId::kRk4, ImpactsId::kLocated, ContactsId::kLasting, kSize / kSpeed / 7.0};
  Simulation run(s);
  run.advance_to(8.0 * kSize / kSpeed);
  EXPECT_EQ(run.status(), "ok");
  std::vector<double> end;
  for (int i = 0; i < static_cast<int>(scene.bodies.size()); ++i) {
    for (const double x :
         {run.state().q(0, i) / kSize, run.state().q(1, i) / kSize, run.state().q(2, i),
          run.state().v(0, i) / kSpeed, run.state().v(1, i) / kSpeed, run.state().v(2, i) * kSize / kSpeed})
      end.push_back(x);
  }
  return end;
}

// The top at y = 0, from one x to the other.
Body floor_between(double from, double to, const std::string& name = "floor") {
  return test::wall(name, {0.5 * (from + to), -0.05}, to - from, 0.1);
}

Body small_box(Vec2 position, double speed, const std::string& name = "box") {
  return test::box(name, kSize * position, {speed * kSpeed, 0.0}, kSize, kSize);
}

// scene(length) is on floors of this length (m).
template <class Scene>
void expect_any_length_alike(const Scene& scene) {
  const std::vector<double> expected = end_of(scene(30.0 * kSize));
  for (const double length : {10.0, 300.0, 1000.0}) {
    const std::vector<double> end = end_of(scene(length));
    double off = 0.0;
    for (std::size_t k = 0; k < end.size(); ++k) off = std::max(off, std::abs(end[k] - expected[k]));
    EXPECT_LT(off, 1e-6) << length << " m";
  }
}

TEST(LongFloors, ABoxSlidesOffTheEnd) {
  for (const double friction : {0.0, 0.2}) {
    for (const double restitution : {0.0, 0.3}) {
      SCOPED_TRACE(testing::Message() << "e = " << restitution << ", mu = " << friction);
      expect_any_length_alike([&](double length) {
        return LongFloors{{small_box({-2.0, 0.5}, 1.0)}, {floor_between(-length, 0.0)}, restitution, friction};
      });
    }
  }
}

TEST(LongFloors, ABoxSlidesOffAThinWall) {
  expect_any_length_alike([&](double length) {
    return LongFloors{{small_box({-2.0, 0.5}, 1.0)},
                      {test::fixed("floor", Wall{length}, {-0.5 * length, 0.0})}};
  });
}

TEST(LongFloors, ACapsuleSlidesOffTheEnd) {
  expect_any_length_alike([&](double length) {
    Body capsule = small_box({-2.0, 0.3}, 1.0);
    capsule.shape = Polygon{{{-0.5 * kSize, 0.0}, {0.5 * kSize, 0.0}}, 0.3 * kSize};
    return LongFloors{{capsule}, {floor_between(-length, 0.0)}};
  });
}

TEST(LongFloors, ABoxOnABoxSlidesAndTips) {
  for (const double beside : {-0.15, 0.1, 0.2}) {
    for (const double restitution : {0.3, 0.5}) {
      SCOPED_TRACE(testing::Message() << "e = " << restitution << ", " << beside);
      expect_any_length_alike([&](double length) {
        return LongFloors{{small_box({0.0, 0.5}, 0.0), small_box({beside, 1.5}, 0.7, "upper box")},
                          {floor_between(-length, length)},
                          restitution,
                          0.6};
      });
    }
  }
}

TEST(LongFloors, ACartLandsAndRolls) {
  expect_any_length_alike([&](double length) {
    Body body = small_box({0.0, 1.2}, 0.3);
    body.shape = Box{2.0 * kSize, 0.4 * kSize};
    const auto wheel = [](const std::string& name, double x) {
      return test::disc(name, {x * kSize, 0.5 * kSize}, {kSpeed, 0.0}, 0.5 * kSize);
    };
    return LongFloors{
        {body, wheel("rear", -0.7), wheel("front", 0.7)}, {floor_between(-length, length)}, 0.3, 0.6};
  });
}

}  // namespace
}  // namespace carom
