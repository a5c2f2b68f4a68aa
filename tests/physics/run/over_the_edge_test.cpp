#include <algorithm>
#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <tuple>
#include <utility>
#include <vector>

#include "physics/math/vectors.h"
#include "physics/run/simulation.h"
#include "tests/support/scenes.h"

// Bodies that slide or roll over the end of a table and leave it, beside their equations of motion about the
// corner, which are solved here in small steps.
namespace carom {
namespace {

constexpr double kG = 9.81;
constexpr double kHeight = 3.0;  // m, of the table's top

// What stays after a body has left the corner.
struct Left {
  double spin = 0.0;   // rad/s
  double speed = 0.0;  // m/s, along x
  double start = 0.0;  // m: where x would be at t = 0 at that speed
};

void expect_near(const Left& left, const Left& expected, double within) {
  EXPECT_NEAR(left.spin, expected.spin, within);
  EXPECT_NEAR(left.speed, expected.speed, within);
  EXPECT_NEAR(left.start, expected.start, within);
}

// That of the second of these bodies after `until` s.
Left run_over(std::vector<Body> bodies, double friction, IntegratorId integrator, double step, double until) {
  RunSetup s = test::setup_with(std::move(bodies), 0.0, friction);
  s.scene.forces.gravity = {0.0, -kG};
  s.method = {integrator, ImpactsId::kLocated, ContactsId::kLasting, step};
  Simulation run(s);
  run.advance_to(until, [] {});
  const auto v = run.state().v.col(1);
  return {v[2], v[0], run.state().q.col(1)[0] - v[0] * until};
}

// Values that change at these rates, until `margin` of them is no longer positive.
template <std::size_t N, class Rates, class Margin>
double fly_until(const Rates& rates, const Margin& margin, std::array<double, N>& y) {
  const auto stepped = [&](double h) {
    const auto at = [&](double part, const std::array<double, N>& k) {
      std::array<double, N> z = y;
      for (std::size_t i = 0; i < N; ++i) z[i] += part * h * k[i];
      return z;
    };
    const auto k1 = rates(y);
    const auto k2 = rates(at(0.5, k1));
    const auto k3 = rates(at(0.5, k2));
    const auto k4 = rates(at(1.0, k3));
    std::array<double, N> z = y;
    for (std::size_t i = 0; i < N; ++i) z[i] += h / 6.0 * (k1[i] + 2.0 * k2[i] + 2.0 * k3[i] + k4[i]);
    return z;
  };
  constexpr double kStep = 1e-4;
  double time = 0.0;
  while (margin(stepped(kStep)) > 0.0) {
    y = stepped(kStep);
    time += kStep;
  }
  double low = 0.0;
  double high = kStep;
  for (int k = 0; k < 50; ++k) {
    const double middle = 0.5 * (low + high);
    (margin(stepped(middle)) > 0.0 ? low : high) = middle;
  }
  y = stepped(high);
  return time + high;
}

// A body of 1 kg with a flat bottom, which slides from `start` over the edge at x = 0.
struct Slider {
  double half_width = 0.2;  // m, of the bottom
  double depth = 0.1;       // m, below its centre
  double inertia = 0.0;     // kg m²
  double speed = 0.0;       // m/s
  double start = 0.0;       // m
  double friction = 0.0;

  // It tips about the edge once the middle of the normal forces is there, and leaves it with its rear end, or
  // before.
  [[nodiscard]] Left expected() const {
    const double tips = -friction * depth;  // m
    const double then = std::sqrt(speed * speed + 2.0 * friction * kG * (start - tips));
    const double slows = friction > 0.0 ? (speed - then) / (friction * kG) : (tips - start) / speed;
    struct At {
      Vec2 normal, along, force;
      double place, normal_force, turning;
    };
    const auto at = [&](const std::array<double, 6>& y) {
      At a;
      a.normal = turned_by(y[2], Vec2::UnitY());
      a.along = turned_by(y[2], Vec2::UnitX());
      const Vec2 from_edge(y[0], y[1] - kHeight);
      const Vec2 velocity(y[3], y[4]);
      a.place = -from_edge.dot(a.along);  // of the edge, from the middle
      const double arm = a.place - friction * depth;
      a.normal_force =
          (kG * a.normal.y() + 2.0 * y[5] * a.along.dot(velocity) + y[5] * y[5] * a.normal.dot(from_edge)) /
          (1.0 + a.place * arm / inertia);
      a.force = a.normal_force * (a.normal - friction * a.along);
      a.turning = a.normal_force * arm / inertia;
      return a;
    };
    const auto rates = [&](const std::array<double, 6>& y) {
      const At a = at(y);
      return std::array<double, 6>{y[3], y[4], y[5], a.force.x(), a.force.y() - kG, a.turning};
    };
    const auto margin = [&](const std::array<double, 6>& y) {
      const At a = at(y);
      return std::min(a.normal_force, a.place + half_width);
    };
    std::array<double, 6> y{tips, kHeight + depth, 0.0, then, 0.0, 0.0};
    const double time = slows + fly_until(rates, margin, y);
    return {y[5], y[3], y[0] - y[3] * time};
  }

  [[nodiscard]] Left run_with(const Shape& shape, IntegratorId integrator, double step) const {
    Body body = test::box("body", {start, kHeight + depth}, {speed, 0.0}, 1.0, 1.0);
    body.shape = shape;
    body.inertia = inertia;
    return run_over({test::wall("table", {-2.0, kHeight - 0.25}, 4.0, 0.5), body}, friction, integrator, step,
                    -start / speed + 0.33);
  }
};

// Steps, and how near an integrator of order 4 comes.
constexpr std::array<std::pair<double, double>, 3> kSteps{{{1.0 / 60.0, 6e-5}, {0.01, 8e-6}, {0.005, 6e-7}}};

// Where something rubs velocity Verlet has linear contact forces, too.
constexpr std::array kLinear{IntegratorId::kRk4, IntegratorId::kVelocityVerlet};
// Else it is of order 2.
double within_order_2(double step) { return 60.0 * step * step; }

TEST(OverTheEdge, ARoughBox) {
  for (const auto& [step, within] : kSteps) {
    for (int k = 0; k < 24; ++k) {
      Slider box;
      box.inertia = (0.4 * 0.4 + 0.2 * 0.2) / 12.0;
      box.friction = 0.2;
      box.speed = 1.45 + 0.03 * k;
      box.start = -0.2 - 0.0071 * k;
      SCOPED_TRACE(testing::Message() << step << ' ' << k);
      for (const IntegratorId integrator : kLinear)
        expect_near(box.run_with(Box{0.4, 0.2}, integrator, step), box.expected(), within);
    }
  }
}

// Where its rear end begins to curve it leaves the edge, as it moves too fast to go round.
TEST(OverTheEdge, ARoundedBoxAndACapsule) {
  for (const auto& [step, within] : kSteps) {
    for (int k = 0; k < 24; ++k) {
      Slider box;
      box.half_width = 0.16;
      box.inertia = 0.013;
      box.speed = 0.9 + 0.06 * k;
      box.start = -0.2 - 0.0113 * k;
      Polygon rounded{{{-0.16, -0.06}, {0.16, -0.06}, {0.16, 0.06}, {-0.16, 0.06}}, 0.04};
      SCOPED_TRACE(testing::Message() << step << ' ' << k);
      expect_near(box.run_with(rounded, IntegratorId::kRk4, step), box.expected(), within);
      expect_near(box.run_with(rounded, IntegratorId::kVelocityVerlet, step), box.expected(),
                  within_order_2(step));
      box.depth = 0.05;
      const Polygon capsule{{{-0.16, 0.0}, {0.16, 0.0}}, 0.05};
      expect_near(box.run_with(capsule, IntegratorId::kRk4, step), box.expected(), within);
    }
  }
}

// The seams come to the edge while the box tips, one of them where it begins to.
TEST(OverTheEdge, ABoxOfSeveralParts) {
  for (const auto& [step, within] : kSteps) {
    for (int k = 0; k < 12; ++k) {
      for (const int parts : {1, 2, 3, 4, 5}) {
        Slider box;
        box.inertia = (0.4 * 0.4 + 0.2 * 0.2) / 12.0;
        box.speed = 0.83 + 0.137 * k;
        box.start = -0.21 - 0.0231 * k;
        const double width = 0.4 / parts;
        Compound compound;
        for (int i = 0; i < parts; ++i)
          compound.shapes.push_back({Box{width, 0.2}, {-0.2 + width * (i + 0.5), 0.0}, 0.0, ""});
        SCOPED_TRACE(testing::Message() << step << ' ' << k << ' ' << parts);
        expect_near(box.run_with(compound, IntegratorId::kRk4, step), box.expected(), within);
        expect_near(box.run_with(compound, IntegratorId::kVelocityVerlet, step), box.expected(),
                    within_order_2(step));
      }
    }
  }
}

// A smooth plate on two square feet of 0.1 m, 0.2 m apart. Once the rear corner of the front foot has left the
// table the plate tips about the front corner of the rear foot, which slides on.
TEST(OverTheEdge, APlateOnTwoFeet) {
  constexpr double kSpeed = 1.5;
  constexpr double kStart = -0.3;
  constexpr double kUntil = 0.25;
  const Compound plate{{{Box{0.1, 0.1}, {-0.15, 0.05}, 0.0, ""},
                        {Box{0.1, 0.1}, {0.15, 0.05}, 0.0, ""},
                        {Box{0.4, 0.1}, {0.0, 0.15}, 0.0, ""}}};
  constexpr double kDepth = (2.0 * 0.01 * 0.05 + 0.04 * 0.15) / 0.06;  // m, of the centre of mass
  constexpr double kInertia = 0.03;
  const Vec2 corner(-0.1, -kDepth);
  std::array<double, 3> y{0.0, 0.0, (-kStart - 0.1) / kSpeed};  // the angle, the spin and the time
  (void)fly_until(
      [&](const std::array<double, 3>& now) {
        const Vec2 r = turned_by(now[0], corner);
        const double turning = r.x() * (kG + r.y() * now[1] * now[1]) / (kInertia + r.x() * r.x());
        return std::array<double, 3>{now[1], turning, 1.0};
      },
      [&](const std::array<double, 3>& now) { return kUntil - now[2]; }, y);
  for (const double step : {1.0 / 60.0, 0.01, 0.004}) {
    for (int k = 0; k < 8; ++k) {
      const double start = kStart - k * kSpeed * step / 8.0;
      Body body = test::box("body", {start, kHeight + kDepth}, {kSpeed, 0.0}, 1.0, 1.0);
      body.shape = plate;
      body.inertia = kInertia;
      RunSetup s = test::setup_with({test::wall("table", {-2.0, kHeight - 0.25}, 4.0, 0.5), body}, 0.0, 0.0);
      s.scene.forces.gravity = {0.0, -kG};
      s.method = {IntegratorId::kRk4, ImpactsId::kLocated, ContactsId::kLasting, step};
      Simulation run(s);
      run.advance_to(kUntil + (kStart - start) / kSpeed, [] {});
      EXPECT_NEAR(run.state().q(2, 1), y[0], 1e-6) << step << ' ' << k;
      EXPECT_NEAR(run.state().v(2, 1), y[1], 1e-5) << step << ' ' << k;
      EXPECT_NEAR(run.state().q(1, 1), kHeight - turned_by(y[0], corner).y(), 1e-6) << step << ' ' << k;
    }
  }
}

// A plank that slides over two posts has four contacts in a row, of which two would hold it: which do so is no
// matter for its motion. It leaves the first post, and tips about the near edge of the second.
TEST(OverTheEdge, APlankOnTwoPosts) {
  const auto at_the_end = [](double step) {
    const auto post = [](const char* name, double x) {
      return test::wall(name, {x, kHeight - 0.25}, 0.1, 0.5);
    };
    RunSetup s = test::setup_with({post("first", -0.3), post("second", 0.3),
                                   test::box("plank", {0.0, kHeight + 0.025}, {1.0, 0.0}, 0.9, 0.05)},
                                  0.0, 0.0);
    s.scene.forces.gravity = {0.0, -kG};
    s.method = {IntegratorId::kRk4, ImpactsId::kLocated, ContactsId::kLasting, step};
    Simulation run(s);
    run.advance_to(0.5, [] {});
    return Eigen::Vector3d(run.state().v.col(2));
  };
  const Eigen::Vector3d fine = at_the_end(0.0005);
  // m/s and 1/s: with half the step, a sixteenth of the error.
  double within = 1e-5;
  for (const double step : {1.0 / 60.0, 1.0 / 120.0, 1.0 / 240.0}) {
    EXPECT_LT((at_the_end(step) - fine).norm(), within + 2e-8) << step;
    within /= 16.0;
  }
}

// Two smooth boxes that slide together over the edge: the rear corner of the first one comes to it at the
// moment at which the front corner of the second one does, which pushes the first one on until then. The spins
// with which it leaves are those of its equation of motion about the corner, for 1 and 2 m/s.
TEST(OverTheEdge, TwoBoxesTogether) {
  for (const auto& [speed, until, spin] :
       {std::tuple(1.0, 0.29, -2.237708356), std::tuple(2.0, 0.16, -1.067918465)}) {
    for (const bool swapped : {false, true}) {
      for (const auto& [step, within] :
           {std::pair(1.0 / 60.0, 3e-4), std::pair(0.01, 3e-5), std::pair(0.004, 3e-6)}) {
        std::vector<Body> bodies = {test::box("first", {-0.15, 0.1}, {speed, 0.0}, 0.2, 0.2, 1.0),
                                    test::box("second", {-0.35, 0.1}, {speed, 0.0}, 0.2, 0.2, 2.0),
                                    test::wall("table", {-2.0, -0.25}, 4.0, 0.5)};
        if (swapped) std::reverse(bodies.begin(), bodies.end());
        const int first = swapped ? 2 : 0;
        RunSetup s = test::setup_with(std::move(bodies), 0.0, 0.0);
        s.scene.forces.gravity = {0.0, -kG};
        s.method = {IntegratorId::kRk4, ImpactsId::kLocated, ContactsId::kLasting, step};
        Simulation run(s);
        run.advance_to(until, [] {});
        EXPECT_NEAR(run.state().v(2, first), spin, within) << speed << ' ' << swapped << ' ' << step;
      }
    }
  }
}

// A disc of 1 kg rolls about the edge until that takes more than full friction, slips, and leaves it when
// nothing presses it any more.
struct Roller {
  double radius = 0.025;  // m
  double speed = 0.3;     // m/s
  double start = 0.0;     // m
  double friction = 1.0;

  [[nodiscard]] Left expected() const {
    using Values = std::array<double, 3>;  // the angle from the vertical, its rate, and how fast it rolls
    const auto normal_force = [&](const Values& y) { return kG * std::cos(y[0]) - radius * y[1] * y[1]; };
    Values y{0.0, speed / radius, speed / radius};
    double time = -start / speed;
    time += fly_until(
        [&](const Values& z) {
          const double by = 2.0 / 3.0 * kG / radius * std::sin(z[0]);
          return Values{z[1], by, by};
        },
        [&](const Values& z) { return friction * normal_force(z) - kG * std::sin(z[0]) / 3.0; }, y);
    time += fly_until(
        [&](const Values& z) {
          const double by = friction * normal_force(z) / radius;
          return Values{z[1], kG / radius * std::sin(z[0]) - by, 2.0 * by};
        },
        normal_force, y);
    const double along = radius * y[1] * std::cos(y[0]);
    return {-y[2], along, radius * std::sin(y[0]) - along * time};
  }

  [[nodiscard]] Left run_with(IntegratorId integrator, double step) const {
    Body ball = test::disc("ball", {start, kHeight + radius}, {speed, 0.0}, radius);
    ball.spin = -speed / radius;
    return run_over({test::wall("table", {-0.5, kHeight - 0.025}, 1.0, 0.05), ball}, friction, integrator, step,
                    -start / speed + 0.15);
  }
};

// The ball turns by 0.2 to 0.4 rad in a step of 1/60 s here.
TEST(OverTheEdge, ABallRollsSlipsAndLeaves) {
  for (const auto& [step, within] :
       {std::pair(1.0 / 60.0, 5e-3), std::pair(0.01, 9e-4), std::pair(0.005, 2e-4), std::pair(0.002, 5e-6)}) {
    for (int k = 0; k < 24; ++k) {
      Roller ball;
      ball.start = -0.1 - k * 0.3 * step / 24.0;
      SCOPED_TRACE(testing::Message() << step << ' ' << k);
      for (const IntegratorId integrator : kLinear)
        expect_near(ball.run_with(integrator, step), ball.expected(), within);
    }
  }
}

}  // namespace
}  // namespace carom
