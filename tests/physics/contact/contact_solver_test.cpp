#include "physics/contact/contact_solver.h"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

#include "tests/support/contact_scenes.h"

namespace carom {
namespace {

using test::ContactScene;

constexpr double kG = 9.81;
constexpr double kH = 1.0 / 60.0;
constexpr ContactSolverOptions kExact{.tolerance = 0.0, .max_newton = 200};  // down to rounding

double both(const Contacts& contacts, int interface) {
  return contacts.normal_impulse[2 * interface] + contacts.normal_impulse[2 * interface + 1];
}

// Gravity for one step, then the impulses that each pair of contacts in a stack must carry.
void expect_weights(ContactScene s, const std::vector<double>& masses, double relative) {
  s.accelerate({0.0, -kG}, kH);
  const ContactSolverReport report = s.solve(kExact);
  EXPECT_EQ(report.missed_islands, 0);
  double above = 0.0;
  for (int i = static_cast<int>(masses.size()) - 1; i >= 0; --i) {
    above += masses[i] * kG * kH;
    EXPECT_NEAR(both(s.contacts, i) / above, 1.0, relative) << "interface " << i;
  }
}

TEST(ContactSolver, BoxOnTwoCornersRests) {
  ContactScene s = test::stack_of({2.0}, 0.5);
  s.accelerate({0.0, -kG}, kH);
  const ContactSolverReport report = s.solve(kExact);
  EXPECT_EQ(report.islands, 1);
  EXPECT_EQ(report.missed_islands, 0);
  EXPECT_LT(s.v.cwiseAbs().maxCoeff(), 1e-15);
  for (const double impulse : s.contacts.normal_impulse) EXPECT_NEAR(impulse, kG * kH, 1e-14);
}

TEST(ContactSolver, StacksBearTheWeightAbove) {
  expect_weights(test::stack_of(std::vector<double>(20, 1.0), 0.5), std::vector<double>(20, 1.0), 1e-12);
  const std::vector<double> heavy{1.0, 1e6};
  expect_weights(test::stack_of(heavy, 0.5), heavy, 1e-14);
  std::vector<double> alternating;
  for (int i = 0; i < 20; ++i) alternating.push_back(i % 2 == 0 ? 1.0 : 1e6);
  expect_weights(test::stack_of(alternating, 0.5), alternating, 1e-12);
  const std::vector<double> light{1e3, 1.0, 1e-3, 1.0, 1e3};
  expect_weights(test::stack_of(light, 0.5), light, 1e-12);
}

// A body of width and height 1 (or a disc of radius 0.5) on a slope that rises along (cosθ, sinθ).
struct Slope {
  double theta;
  Vec2 up{std::cos(theta), std::sin(theta)};
  Vec2 normal{-std::sin(theta), std::cos(theta)};
};

TEST(ContactSolver, BlockSticksUpToTheConeAndSlidesBeyond) {
  constexpr double kMu = 0.5;
  for (const double share : {0.995, 1.005}) {
    for (const bool was_sticking : {true, false}) {
      const double mu_k = was_sticking ? 0.3 : kMu;  // must have no effect while the contacts stick
      const Slope slope{std::atan(share * kMu)};
      ContactScene s;
      const int floor = s.fixed();
      const int block = s.box(0.5 * slope.normal, 1.0, 1.0, 3.0);
      for (const double side : {-0.5, 0.5}) {
        const int c = s.contact(floor, block, side * slope.up, slope.normal, kMu);
        s.contacts.kinetic_friction[c] = mu_k;
        s.contacts.static_friction[c] = was_sticking ? kMu : 9.0;
        s.contacts.sticks[c] = was_sticking ? 1 : 0;
      }
      s.accelerate({0.0, -kG}, kH);
      ContactSolverOptions options = kExact;
      options.slip_speed = 1e-9;
      EXPECT_EQ(s.solve(options).missed_islands, 0);
      const double slide = share < 1.0 ? 0.0 : kG * (std::sin(slope.theta) - kMu * std::cos(slope.theta));
      EXPECT_NEAR(-s.v.col(block).head<2>().dot(slope.up), kH * slide, 1e-15) << share;
      EXPECT_NEAR(s.v.col(block).head<2>().dot(slope.normal), 0.0, 1e-15);
      EXPECT_NEAR(s.v(2, block), 0.0, 1e-14);
      for (const std::uint8_t sticks : s.contacts.sticks) EXPECT_EQ(sticks, share < 1.0 ? 1 : 0);
    }
  }
}

TEST(ContactSolver, DiscRollsSlipsOrIsHeld) {
  constexpr double kMu = 0.2;
  constexpr double kRadius = 0.5;
  struct Case {
    double tangent, rolling, acceleration, spin;
  };
  const auto rolling_to = [](double c, double tangent) {  // with M = c R N
    const double theta = std::atan(tangent);
    const double a = 2.0 / 3.0 * kG * (std::sin(theta) - c * std::cos(theta));
    return Case{tangent, c * kRadius, a, a / kRadius};
  };
  const double steep = std::atan(3.03 * kMu);
  const Case cases[] = {
      rolling_to(0.0, 2.97 * kMu),
      {std::tan(steep), 0.0, kG * (std::sin(steep) - kMu * std::cos(steep)),
       2.0 * kMu * kG * std::cos(steep) / kRadius},
      {0.0099, 0.01 * kRadius, 0.0, 0.0},
      rolling_to(0.01, 0.0101),
  };
  for (const Case& c : cases) {
    const Slope slope{std::atan(c.tangent)};
    ContactScene s;
    const int floor = s.fixed();
    const int disc = s.disc(kRadius * slope.normal, kRadius, 2.0);
    s.contacts.rolling[s.contact(floor, disc, {0.0, 0.0}, slope.normal, kMu)] = c.rolling;
    s.accelerate({0.0, -kG}, kH);
    EXPECT_EQ(s.solve(kExact).missed_islands, 0);
    EXPECT_NEAR(-s.v.col(disc).head<2>().dot(slope.up), kH * c.acceleration, 1e-15) << c.tangent;
    EXPECT_NEAR(s.v(2, disc), kH * c.spin, 1e-14) << c.tangent;
  }
}

TEST(ContactSolver, PullingTheLowerOfTwoBoxes) {
  constexpr double kMu = 0.4;
  constexpr double kLower = 3.0;
  constexpr double kUpper = 1.0;
  for (const double share : {0.99, 1.01}) {
    ContactScene s = test::stack_of({kLower, kUpper}, kMu);
    for (const int c : {0, 1}) s.contacts.static_friction[c] = s.contacts.kinetic_friction[c] = 0.0;
    const double force = share * kMu * kG * (kLower + kUpper);
    s.accelerate({0.0, -kG}, kH);
    s.v(0, 1) += kH * force / kLower;
    EXPECT_EQ(s.solve(kExact).missed_islands, 0);
    const double together = force / (kLower + kUpper);
    EXPECT_NEAR(s.v(0, 2), kH * (share < 1.0 ? together : kMu * kG), 1e-14);
    EXPECT_NEAR(s.v(0, 1), kH * (share < 1.0 ? together : (force - kMu * kG * kUpper) / kLower), 1e-14);
  }
}

TEST(ContactSolver, WedgeInAGroove) {
  // A V of half angle α with two contacts a side; friction above tan α jams it. Pushed in, it must rest.
  // Pulled out, it may stay or move, because the laws have both solutions, but it must be one of them.
  constexpr double kAlpha = 0.2;
  for (const double pull : {-1.0, 0.3, 1.0}) {
    ContactScene s;
    const int groove = s.fixed();
    const int wedge = s.box({0.0, 1.0}, 0.4, 1.0, 1.0);
    for (const double side : {-1.0, 1.0}) {
      const Vec2 inward(-side * std::cos(kAlpha), std::sin(kAlpha));
      for (const double along : {0.7, 1.3}) {
        s.contact(groove, wedge, {side * along * std::sin(kAlpha), along * std::cos(kAlpha)}, inward, 0.6);
      }
    }
    s.accelerate({0.2 * pull, pull}, 1.0);
    EXPECT_EQ(s.solve(kExact).missed_islands, 0);
    if (pull < 0.0) {
      EXPECT_LT(s.v.cwiseAbs().maxCoeff(), 1e-14);
    }
  }
}

TEST(ContactSolver, ArchStands) {
  constexpr int kStones = 15;
  ContactScene s;
  const int ground = s.fixed();
  const double angle = std::numbers::pi / kStones;
  const auto direction = [](double a) { return Vec2(std::cos(a), std::sin(a)); };
  int before = ground;
  for (int i = 0; i <= kStones; ++i) {
    const int stone = i < kStones ? s.box(direction((i + 0.5) * angle), 0.4, angle, 1.0) : ground;
    const Vec2 out = direction(i * angle);
    for (const double radius : {0.8, 1.2}) s.contact(before, stone, radius * out, Vec2(-out.y(), out.x()), 0.6);
    before = stone;
  }
  s.accelerate({0.0, -kG}, kH);
  EXPECT_EQ(s.solve(kExact).missed_islands, 0);
  EXPECT_LT(s.v.cwiseAbs().maxCoeff(), 1e-13);
  double carried = 0.0;
  for (const int c : {0, 1}) carried += s.contacts.normal_impulse[c];
  for (const int c : {2 * kStones, 2 * kStones + 1}) carried += s.contacts.normal_impulse[c];
  EXPECT_NEAR(carried, kStones * kG * kH, 1e-12);
}

TEST(ContactSolver, SpeculativeContacts) {
  ContactScene s;
  const int floor = s.fixed();
  const int slow = s.disc({0.0, 0.6}, 0.5, 1.0);
  const int fast = s.disc({5.0, 0.6}, 0.5, 1.0);
  for (const int disc : {slow, fast}) {
    const int c = s.contact(floor, disc, {s.position[disc].x(), 0.0}, {0.0, 1.0}, 0.5);
    s.contacts.target[c] = -0.1 / kH;
    s.contacts.normal_impulse[c] = 0.3;  // a guess that must vanish
  }
  s.v.col(slow) << 0.5, -5.0, 2.0;
  s.v.col(fast) << 0.0, -7.0, 0.0;
  const ContactSolverReport report = s.solve(kExact);
  EXPECT_EQ(report.islands, 2);
  EXPECT_EQ(report.missed_islands, 0);
  EXPECT_EQ(s.contacts.normal_impulse[0], 0.0);
  EXPECT_EQ(s.v.col(slow), Eigen::Vector3d(0.5, -5.0, 2.0));
  EXPECT_NEAR(s.v(1, fast), -0.1 / kH, 1e-14);
}

TEST(ContactSolver, DrivenTableCarriesOrSlipsUnder) {
  for (const double mu : {0.5, 0.01}) {
    ContactScene s;
    const int table = s.body({0.0, 0.0}, 0.0, 0.0, {0.01, 0.2, 0.0});
    const int box = s.box({0.0, 0.5}, 1.0, 1.0, 2.0);
    s.corners(table, box, 1.0, 1.0, mu);
    s.accelerate({0.0, -kG}, kH);
    EXPECT_EQ(s.solve(kExact).missed_islands, 0);
    EXPECT_EQ(s.v.col(table), Eigen::Vector3d(0.01, 0.2, 0.0));
    EXPECT_NEAR(s.v(1, box), 0.2, 1e-15);
    EXPECT_NEAR(s.v(0, box), mu == 0.5 ? 0.01 : mu * (kG * kH + 0.2), 1e-15);
  }
}

TEST(ContactSolver, ContactsOfImmovableBodiesAreLeftOut) {
  ContactScene s;
  s.fixed();
  s.fixed({0.0, 1.0});
  s.contact(0, 1, {0.0, 0.5}, {0.0, 1.0}, 0.5);
  s.contacts.normal_impulse[0] = 1.0;
  const ContactSolverReport report = s.solve();
  EXPECT_EQ(report.islands, 0);
  EXPECT_EQ(report.residual, 0.0);
  EXPECT_EQ(s.contacts.normal_impulse[0], 0.0);
}

TEST(ContactSolver, AWarmSolutionIsKept) {
  ContactScene s = test::pyramid(8, 0.6);
  s.accelerate({0.0, -kG}, kH);
  ContactScene again = s;
  ContactSolverOptions options;
  options.tolerance = 1e-10;
  EXPECT_EQ(s.solve(options).missed_islands, 0);
  again.contacts = s.contacts;
  const ContactSolverReport report = again.solve(options);
  EXPECT_EQ(report.sweeps, 0);
  EXPECT_EQ(report.newton_islands, 0);
  EXPECT_EQ(again.contacts.normal_impulse, s.contacts.normal_impulse);
}

TEST(ContactSolver, UnsolvableProblemsAreReported) {
  // A box in a closing gap: no velocity is allowed.
  ContactScene s;
  const int left = s.body({-1.0, 0.0}, 0.0, 0.0, {1.0, 0.0, 0.0});
  const int right = s.body({1.0, 0.0}, 0.0, 0.0, {-1.0, 0.0, 0.0});
  const int box = s.box({0.0, 0.0}, 2.0, 2.0, 1.0);
  s.contact(left, box, {-1.0, 0.0}, {1.0, 0.0}, 0.3);
  s.contact(box, right, {1.0, 0.0}, {1.0, 0.0}, 0.3);
  const ContactSolverReport report = s.solve();
  EXPECT_EQ(report.missed_islands, 1);
  EXPECT_GT(report.residual, 0.1);
  EXPECT_TRUE(s.v.allFinite());
}

// A disc between two walls so steep that friction holds it at any pressure, told to leave both: it can't, and
// no pressure would help.
TEST(ContactSolver, WhatIsJammedIsNotPressedEverHarder) {
  for (const double asked : {1e-12, 1e-9, 1e-6}) {
    ContactScene s;
    const int walls = s.fixed();
    const int disc = s.disc({0.0, 0.0}, 1.0, 1.0);
    for (const double side : {-1.0, 1.0}) {
      const Vec2 normal = Vec2(side, 0.1).normalized();
      s.contacts.target[s.contact(walls, disc, -normal, normal, 0.5)] = asked;
    }
    s.accelerate({0.0, -kG}, kH);
    ContactSolverOptions options = kExact;
    options.tolerance = 1e-15;
    for (int again = 0; again < 5; ++again) {  // from the impulses before
      const Eigen::Matrix3Xd free = s.v;
      const ContactSolverReport report = s.solve(options);
      EXPECT_EQ(report.missed_islands, 1);
      EXPECT_LE(report.residual, 2.0 * asked);
      EXPECT_LT(s.v.cwiseAbs().maxCoeff(), 2.0 * asked);
      for (const double impulse : s.contacts.normal_impulse) EXPECT_LT(impulse, 1e4 * kG * kH);
      s.v = free;
    }
  }
}

TEST(ProjectOverlaps, IsTheLeastDisplacement) {
  // Two discs of masses 1 and 3 penetrate by 0.1 and touch nothing else; they share it by inverse mass.
  ContactScene s;
  const int a = s.disc({0.0, 0.0}, 0.5, 1.0);
  const int b = s.disc({0.9, 0.0}, 0.5, 3.0);
  s.contacts.gap[s.contact(a, b, {0.45, 0.0}, {1.0, 0.0}, 0.5)] = -0.1;
  s.v.setConstant(7.0);  // without effect
  Eigen::Matrix3Xd dq;
  ContactWorkspace workspace;
  const ContactSolverReport report = project_penetrations(s.mass, s.contacts, 0.5, dq, kExact, workspace);
  EXPECT_EQ(report.missed_islands, 0);
  EXPECT_NEAR(dq(0, a), -0.0375, 1e-16);
  EXPECT_NEAR(dq(0, b), 0.0125, 1e-16);
  EXPECT_EQ(s.contacts.normal_impulse[0], 0.0);
}

TEST(ProjectOverlaps, ColumnRisesAndNeighboursAreNotHit) {
  // Ten boxes under a ceiling, each 2 cm deep in the one below. To correct half of that the top rises by 10
  // cm; with room for 6 cm it is impossible, and that is reported.
  for (const double room : {0.15, 0.06}) {
    ContactScene s = test::stack_of(std::vector<double>(10, 1.0), 0.5);
    for (double& gap : s.contacts.gap) gap = -0.02;
    s.corners(10, s.fixed({0.0, 10.5}), 1.0, 1.0, 0.0);
    for (const int c : {20, 21}) s.contacts.gap[c] = room;
    Eigen::Matrix3Xd dq;
    ContactWorkspace workspace;
    const ContactSolverReport report = project_penetrations(s.mass, s.contacts, 0.5, dq, {1e-12}, workspace);
    EXPECT_EQ(report.missed_islands, room > 0.1 ? 0 : 1);
    if (room > 0.1) {
      EXPECT_NEAR(dq(1, 10), 0.1, 1e-11);
    }
    EXPECT_TRUE(dq.allFinite());
  }
}

}  // namespace
}  // namespace carom
