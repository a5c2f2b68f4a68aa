#include "widgets/scene/drawing_forces.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>
#include <numbers>

#include "physics/dynamics/state.h"
#include "tests/support/body_literal.h"

namespace carom {
namespace {

using namespace test::literals;

// A disc of 0.1 m at (1, 0) and one at (2, 0), at 100 px/m; each test adds its forces.
class ForcesDrawn : public testing::Test {
 protected:
  void SetUp() override {
    camera_.center = Vec2(1.0, 0.0);
    camera_.scale = 100.0;
    Body a;
    a.name = "a";
    a.position = Vec2(1.0, 0.0);
    Body b = a;
    b.name = "b";
    b.position = Vec2(2.0, 0.0);
    bodies_ = {a, b};
  }

  [[nodiscard]] Drawing drawing() {
    frame_.state = initial_state(bodies_);
    for (int i = 0; i < frame_.state.size(); ++i) {
      frame_.state.q.col(i).head<2>() = bodies_[static_cast<std::size_t>(i)].position;
    }
    frame_.bodies = std::make_shared<const std::vector<Body>>(bodies_);
    frame_.forces = std::make_shared<const Forces>(forces_);
    return make_drawing({frame_, {}, camera_, options_, light_theme(), arrows_});
  }
  Spring& spring() {
    if (forces_.springs.empty()) forces_.springs.push_back({.name = "", .body = "a", .to = ""});
    return forces_.springs[0];
  }
  [[nodiscard]] static double widest(const Drawing& d) {
    double widest = 0.0;
    for (const auto& line : d.lines) {
      if (line.from != line.to) widest = std::max(widest, line.width);
    }
    return widest;
  }
  // The ends of a spring's drawing, without its dot and plate.
  [[nodiscard]] static std::pair<double, double> reach(const Drawing& d) {
    double low = 1e9;
    double high = -1e9;
    for (const auto& line : d.lines) {
      low = std::min({low, line.from.x(), line.to.x()});
      high = std::max({high, line.from.x(), line.to.x()});
    }
    return {low, high};
  }

  std::vector<Body> bodies_;
  Forces forces_;
  Frame frame_;
  Camera camera_;
  DrawingOptions options_{.grid = false, .velocities = false, .contacts = false, .names = false};
  ArrowScale arrows_{.metres_per_newton = 0.1};
};

TEST_F(ForcesDrawn, ASpringIsAZigzagFromItsDotToTheRim) {
  spring().rest_length = 0.5;
  const Drawing d = drawing();
  ASSERT_GT(d.lines.size(), 10U);
  EXPECT_EQ(d.lines[0].from, d.lines[0].to) << "the anchor's dot";
  EXPECT_EQ(d.lines[0].from, Vec2(0.0, 0.0));
  EXPECT_NEAR(reach(d).first, 0.0, 1e-12);
  EXPECT_NEAR(reach(d).second, 0.9, 1e-12);
  double above = 0.0;
  double below = 0.0;
  for (std::size_t i = 1; i < d.lines.size(); ++i) {
    if (i > 1) {
      EXPECT_EQ(d.lines[i].from, d.lines[i - 1].to);
    }
    above = std::max(above, d.lines[i].to.y());
    below = std::min(below, d.lines[i].to.y());
  }
  EXPECT_NEAR(above, 0.06, 1e-12);
  EXPECT_NEAR(below, -0.06, 1e-12);
}

TEST_F(ForcesDrawn, ASpringBetweenBodiesRunsFromRimToRim) {
  spring().to = "b";
  EXPECT_NEAR(reach(drawing()).first, 1.1, 1e-12);
  EXPECT_NEAR(reach(drawing()).second, 1.9, 1e-12);
  bodies_[1].shape = Box{0.6, 0.2};
  bodies_[1].fixed = true;
  EXPECT_NEAR(reach(drawing()).second, 1.7, 1e-12);
  bodies_[1].angle = std::numbers::pi / 2;
  EXPECT_NEAR(reach(drawing()).second, 1.9, 1e-12);
}

TEST_F(ForcesDrawn, ABumperWaitsAtItsFreeLengthAndIsThinTillItPushes) {
  for (const SpringActs acts : {SpringActs::kPush, SpringActs::kWhileShort}) {
    spring().acts = acts;
    spring().rest_length = 0.6;
    const Drawing idle = drawing();
    EXPECT_NEAR(reach(idle).second, 0.5, 1e-12);
    spring().rest_length = 1.2;
    const Drawing pressed = drawing();
    EXPECT_NEAR(reach(pressed).second, 0.9, 1e-12);
    EXPECT_NE(pressed.lines[1].color, idle.lines[1].color);
    EXPECT_GT(pressed.lines[1].width, idle.lines[1].width);
    // The plate is vertical, centred on the line.
    EXPECT_NEAR(pressed.lines.back().from.y(), -0.09, 1e-12);
    EXPECT_NEAR(pressed.lines.back().to.y(), 0.09, 1e-12);
  }
}

TEST_F(ForcesDrawn, ARubberBandIsALineThinWhileSlack) {
  spring().acts = SpringActs::kPull;
  spring().rest_length = 0.5;
  const Drawing taut = drawing();
  EXPECT_EQ(taut.lines.size(), 2U) << "dot and line";
  spring().rest_length = 1.5;
  EXPECT_LT(widest(drawing()), widest(taut));
}

TEST_F(ForcesDrawn, StrangeSpringsAreNoTrouble) {
  spring().anchor = bodies_[0].position;
  EXPECT_EQ(drawing().lines.size(), 1U) << "of no length: its dot";
  spring().to = "nobody";
  EXPECT_TRUE(drawing().lines.empty());
  spring().to = "";
  camera_.center = Vec2(50.0, 50.0);
  EXPECT_TRUE(drawing().lines.empty()) << "out of sight";
}

TEST_F(ForcesDrawn, ADrivenBodyIsHatchedWithinItsShape) {
  bodies_[0].shape = Box{1.0, 0.4};
  bodies_[0].angle = 0.5;
  bodies_[0].drive = Drive{.amplitude = Vec2(0.0, 0.3), .angular_frequency = 2.0, .phase = 0.0};
  frame_.time = std::numbers::pi / 4;  // the peak: sin(ωt) = 1
  const Drawing d = drawing();
  ASSERT_GT(d.lines.size(), 5U);
  for (const auto& line : d.lines) {
    for (const Vec2& end : {line.from, line.to}) {
      const Vec2 own = Eigen::Rotation2Dd(-0.5) * (end - bodies_[0].position);
      EXPECT_LE(std::abs(own.x()), 0.5);
      EXPECT_LE(std::abs(own.y()), 0.2);
    }
  }
  EXPECT_EQ(d.boxes[0].fill, light_theme().wall_fill);
  // Centred on the vibration, as long as its amplitude.
  ASSERT_EQ(d.arrows.size(), 2U);
  EXPECT_TRUE(d.arrows[0].from.isApprox(Vec2(1.0, -0.3), 1e-12));
  EXPECT_NEAR(d.arrows[0].to.y(), 0.0, 1e-12);
  EXPECT_NEAR(d.arrows[1].to.y(), -0.6, 1e-12);
}

// A cup of 3 m × 2 m, of which x from 1 to 2 above y = 1 is empty.
TEST_F(ForcesDrawn, TheHatchingLeavesDentsFreeAndHasNoGaps) {
  bodies_.resize(1);
  bodies_[0].shape = Polygon{{{0, 0}, {3, 0}, {3, 2}, {2, 2}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}};
  bodies_[0].position = Vec2(1.5, 0.9);  // its centre of mass
  bodies_[0].drive = Drive{};
  const Drawing d = drawing();
  double hatched = 0.0;
  for (const auto& line : d.lines) {
    const Vec2 along = line.to - line.from;
    if (std::abs(along.x() - along.y()) > 1e-9) continue;  // the outline
    hatched += along.norm();
    const Vec2 middle = 0.5 * (line.from + line.to);
    for (const Vec2& at : {line.from, middle, line.to}) {
      const bool in_dent = at.x() > 1.0 && at.x() < 2.0 && at.y() > 1.0;
      EXPECT_FALSE(in_dent) << at.transpose();
    }
    EXPECT_GT(along.norm(), 0.0);
  }
  EXPECT_NEAR(0.07 * hatched, 5.0, 0.3) << "every 7 px";
}

TEST_F(ForcesDrawn, ADrivenDiscIsHatchedAndDeepZoomStaysCheap) {
  bodies_[0].drive = Drive{.velocity = Vec2(0.5, 0.0)};
  const Drawing d = drawing();
  ASSERT_GT(d.segments.size(), 1U);
  for (const auto& line : d.segments) EXPECT_LE((line.from - bodies_[0].position).norm(), 0.1);
  EXPECT_EQ(d.arrows.size(), 1U) << "where it goes";
  camera_.scale = 1e6;
  EXPECT_LT(drawing().segments.size(), 300U);
}

TEST_F(ForcesDrawn, AnAppliedForceRisesStaysAndEnds) {
  options_.names = true;
  forces_.applied = {{.body = "a", .force = Vec2(0.0, 4.0), .start = 1.0, .rise = 2.0, .end = 5.0}};
  const auto at = [this](double time) {
    frame_.time = time;
    return drawing().arrows;
  };
  EXPECT_TRUE(at(0.9).empty());
  ASSERT_EQ(at(2.0).size(), 1U);
  EXPECT_TRUE(at(2.0)[0].to.isApprox(Vec2(1.0, 0.2), 1e-12)) << "half of it";
  EXPECT_TRUE(at(4.0)[0].to.isApprox(Vec2(1.0, 0.4), 1e-12));
  EXPECT_EQ(drawing().labels.back().text, "4 N");
  EXPECT_TRUE(at(5.0).empty());
  options_.forces = false;
  EXPECT_TRUE(at(4.0).empty());
}

TEST_F(ForcesDrawn, ATorqueIsAnArcTheWayItTurns) {
  for (const double torque : {2.0, -2.0}) {
    AppliedForce turn;
    turn.body = "a";
    turn.torque = torque;
    forces_.applied = {turn};
    const Drawing d = drawing();
    ASSERT_GT(d.segments.size(), 5U);
    ASSERT_EQ(d.arrows.size(), 1U);
    const Vec2 radius = d.segments[0].from - bodies_[0].position;
    const Vec2 along = d.segments[0].to - d.segments[0].from;
    EXPECT_GT((radius.x() * along.y() - radius.y() * along.x()) * torque, 0.0);
  }
}

// Two contacts of 4 N: a on b, and b on the fixed body.
TEST_F(ForcesDrawn, AContactForceIsOneArrowOnABodyThatMoves) {
  options_.contacts = true;
  Body wall = bodies_[0];
  wall.name = "wall";
  wall.position = Vec2(3.0, 0.0);
  wall.fixed = true;
  bodies_.push_back(wall);
  ContactForce ab{.a = 0_b, .b = 1_b, .point = Vec2(1.5, 0.0), .normal = Vec2::UnitX()};
  ab.normal_force = 4.0;
  ab.tangential_force = 3.0;
  ContactForce bw = ab;
  bw.a = 1_b;
  bw.b = 2_b;
  bw.point = Vec2(2.5, 0.0);
  frame_.contacts = {ab, bw};
  const Drawing d = drawing();
  ASSERT_EQ(d.arrows.size(), 2U);
  EXPECT_EQ(d.arrows[0].from, Vec2(1.5, 0.0));
  EXPECT_TRUE(d.arrows[0].to.isApprox(Vec2(1.9, 0.3), 1e-12));
  EXPECT_TRUE(d.arrows[1].to.isApprox(Vec2(2.1, -0.3), 1e-12)) << "back, from the wall";
  EXPECT_EQ(d.arrows[0].color, light_theme().series[1]);
  EXPECT_EQ(d.segments.size(), 2U) << "a dot each";
  // 0.1 m/N at 100 px/m: 60 px would be 6 N.
  EXPECT_EQ(d.force_key.amount, 5.0);
  EXPECT_NEAR(d.force_key.length, 50.0, 1e-12);
  frame_.contacts.clear();
  EXPECT_EQ(drawing().force_key.amount, 0.0) << "nothing to read";
  frame_.contacts = {ab, bw};
  options_.contacts = false;
  EXPECT_TRUE(drawing().arrows.empty());
}

TEST_F(ForcesDrawn, StrangeContactsAreNoTrouble) {
  options_.contacts = true;
  ContactForce contact{.a = 0_b, .b = 7_b};
  contact.normal_force = 4.0;
  frame_.contacts = {contact};
  EXPECT_TRUE(drawing().arrows.empty());
  frame_.contacts[0] = {.a = 0_b, .b = 1_b};
  EXPECT_TRUE(drawing().arrows.empty()) << "no force";
}

TEST_F(ForcesDrawn, TheLargestContactForceOfLateSetsTheScale) {
  Peaks peaks;
  ContactForce contact{.a = 0_b, .b = 1_b};
  contact.normal_force = 30.0;
  contact.tangential_force = -40.0;
  frame_.contacts = {contact};
  frame_.time = 2.0;
  (void)drawing();
  peaks.observe(frame_);
  EXPECT_EQ(peaks.contact_force, 50.0);
  EXPECT_GT(arrow_scale(peaks, 4.0).metres_per_newton * 50.0, 0.08 * 4.0);
  EXPECT_LT(arrow_scale(peaks, 4.0).metres_per_newton * 50.0, 0.25 * 4.0);
  frame_.contacts[0].normal_force = 3.0;
  frame_.contacts[0].tangential_force = 4.0;
  peaks.observe(frame_);
  EXPECT_EQ(peaks.contact_force, 50.0);
  frame_.time = 2.1;
  peaks.observe(frame_);
  EXPECT_NEAR(peaks.contact_force, 50.0 / std::numbers::e, 1e-12);
  frame_.time = 3.0;
  peaks.observe(frame_);
  EXPECT_EQ(peaks.contact_force, 5.0);
  frame_.time = 0.0;
  peaks.observe(frame_);
  EXPECT_EQ(peaks.contact_force, 5.0) << "a new run";
  frame_.contacts.clear();
  frame_.time = 1e3;
  peaks.observe(frame_);
  EXPECT_EQ(peaks.contact_force, 0.05) << "what is far smaller is rounding";
}

TEST_F(ForcesDrawn, FittingHoldsTheAnchors) {
  spring().anchor = Vec2(-3.0, 4.0);
  (void)drawing();
  EXPECT_EQ(bounds(frame_).lower.x(), -3.0);
  EXPECT_EQ(bounds(frame_).upper.y(), 4.0);
}

}  // namespace
}  // namespace carom
