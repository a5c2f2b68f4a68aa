#include "widgets/scene/drawing_joints.h"

#include <gtest/gtest.h>

#include "physics/preset/preset.h"
#include "tests/support/run_fixture.h"

namespace carom {
namespace {

// At 100 px/m; each test adds its joints.
class JointsDrawn : public testing::Test {
 protected:
  JointsDrawn() { camera_.scale = 100.0; }

  [[nodiscard]] Drawing drawing() const {
    return make_drawing({frame_, {}, camera_, options_, light_theme(), ArrowScale{}});
  }
  JointState& joint(JointKind kind, const Vec2& from, const Vec2& to) {
    frame_.joints = {{.kind = kind, .from = from, .to = to, .length = (to - from).norm()}};
    return frame_.joints[0];
  }
  [[nodiscard]] static std::vector<Drawing::SegmentItem> lines(const Drawing& d) {
    std::vector<Drawing::SegmentItem> lines;
    for (const auto& s : d.segments) {
      if (s.from != s.to) lines.push_back(s);
    }
    return lines;
  }
  [[nodiscard]] static std::vector<Drawing::SegmentItem> dots(const Drawing& d) {
    std::vector<Drawing::SegmentItem> dots;
    for (const auto& s : d.segments) {
      if (s.from == s.to) dots.push_back(s);
    }
    return dots;
  }

  Frame frame_;
  Camera camera_;
  DrawingOptions options_{.grid = false, .velocities = false, .contacts = false, .names = false};
};

TEST_F(JointsDrawn, ARodIsABarBetweenItsPointsThickerThanATautString) {
  joint(JointKind::kRod, {0.0, 1.0}, {1.0, 0.5});
  const Drawing rod = drawing();
  ASSERT_EQ(lines(rod).size(), 1U);
  EXPECT_EQ(lines(rod)[0].from, Vec2(0.0, 1.0));
  EXPECT_EQ(lines(rod)[0].to, Vec2(1.0, 0.5));
  EXPECT_EQ(dots(rod).size(), 2U);
  joint(JointKind::kString, {0.0, 1.0}, {1.0, 0.5});
  const Drawing string = drawing();
  ASSERT_EQ(lines(string).size(), 1U);
  EXPECT_LT(lines(string)[0].width, lines(rod)[0].width);
}

TEST_F(JointsDrawn, ASlackStringSagsAndIsAsLongAsItIs) {
  Forces forces;
  forces.gravity = Vec2(0.0, -9.81);
  for (const bool weightless : {false, true}) {
    if (!weightless) frame_.forces = std::make_shared<const Forces>(forces);
    for (const Vec2& to : {Vec2(0.8, -0.3), Vec2(0.0, 0.5), Vec2(0.0, -0.5), Vec2(0.0, 0.0)}) {
      JointState& string = joint(JointKind::kString, {0.0, 0.0}, to);
      string.length = 1.2;
      string.taut = false;
      const auto pieces = lines(drawing());
      ASSERT_GT(pieces.size(), 8U) << to.transpose();
      EXPECT_TRUE(pieces.back().to.isApprox(to, 1e-12)) << to.transpose();
      Vec2 end(0.0, 0.0);
      double length = 0.0;
      double lowest = 0.0;
      for (std::size_t i = 0; i < pieces.size(); ++i) {
        EXPECT_EQ(pieces[i].from, end) << i;
        end = pieces[i].to;
        length += (pieces[i].to - pieces[i].from).norm();
        lowest = std::min(lowest, pieces[i].to.y());
      }
      EXPECT_NEAR(length, 1.2, 1e-6) << to.transpose();
      EXPECT_LT(lowest, std::min(0.0, to.y()) - 0.1) << to.transpose();
    }
  }
}

TEST_F(JointsDrawn, APinIsARingOverItsBarsWithADotWhereThePlaneHoldsIt) {
  joint(JointKind::kPin, {0.5, 0.5}, {0.5, 0.5});
  frame_.joints.push_back(
      {.kind = JointKind::kRod, .from = Vec2(0.0, 0.5), .to = Vec2(0.5, 0.5), .length = 0.5});
  const Drawing joint = drawing();
  ASSERT_EQ(joint.segments.size(), 5U) << "bar, its two ends, ring and hole";
  EXPECT_EQ(joint.segments[3].from, Vec2(0.5, 0.5));
  EXPECT_EQ(joint.segments[4].color, light_theme().scene_ground);
  EXPECT_LT(joint.segments[4].width, joint.segments[3].width);
  frame_.joints[0].in_plane = true;
  EXPECT_EQ(drawing().segments.size(), 6U);
}

TEST_F(JointsDrawn, AWeldIsADot) {
  joint(JointKind::kWeld, {0.5, 0.5}, {0.5, 0.5});
  const Drawing d = drawing();
  ASSERT_EQ(d.segments.size(), 1U);
  EXPECT_EQ(d.segments[0].from, Vec2(0.5, 0.5));
}

TEST_F(JointsDrawn, AWeldAcrossAGapIsADoubleLine) {
  Preset preset = head_on_scene();
  for (Body& body : preset.scene.bodies) body.velocity.setZero();
  Joint weld;
  weld.kind = JointKind::kWeld;
  weld.body = preset.scene.bodies[0].name;
  weld.to = preset.scene.bodies[1].name;
  const Vec2 apart = preset.scene.bodies[1].position - preset.scene.bodies[0].position;
  weld.point = 0.5 * apart;
  weld.anchor = -0.5 * apart;
  preset.scene.joints = {weld};
  frame_ = run_to(preset, 0.0);
  frame_.scene = std::make_shared<const Scene>(preset.scene);
  EXPECT_EQ(lines(drawing()).size(), 4U) << "two from each body";
  // Bodies that touch hide it.
  preset.scene.bodies[1].position =
      preset.scene.bodies[0].position +
      2.0 * std::get<Disc>(preset.scene.bodies[0].shape).radius * apart.normalized();
  weld.point = 0.5 * (preset.scene.bodies[1].position - preset.scene.bodies[0].position);
  weld.anchor = -weld.point;
  preset.scene.bodies[1].shape = preset.scene.bodies[0].shape;
  preset.scene.joints = {weld};
  frame_ = run_to(preset, 0.0);
  frame_.scene = std::make_shared<const Scene>(preset.scene);
  EXPECT_TRUE(lines(drawing()).empty());
}

// A weld made by an impact is among the joints from then on.
TEST_F(JointsDrawn, AFrameHasTheWeldsOfBodiesThatStick) {
  Preset preset = head_on_scene();
  Material glue;
  glue.sticks = true;
  preset.scene.materials = {glue};
  EXPECT_TRUE(run_to(preset, 0.1).joints.empty());
  const Frame frame = run_to(preset, 0.5);
  ASSERT_EQ(frame.joints.size(), 1U);
  EXPECT_EQ(frame.joints[0].kind, JointKind::kWeld);
  EXPECT_NEAR(frame.joints[0].to.x(), 0.5 * (frame.state.position(0).x() + frame.state.position(1).x()), 1e-9);
}

TEST_F(JointsDrawn, ThePlaneHasALargerDotThanABody) {
  joint(JointKind::kRod, {0.0, 1.0}, {1.0, 0.5}).in_plane = true;
  const auto ends = dots(drawing());
  ASSERT_EQ(ends.size(), 2U);
  EXPECT_GT(ends[0].width, ends[1].width);
}

TEST_F(JointsDrawn, OutOfSightNothingIsDrawn) {
  joint(JointKind::kRod, {0.0, 1.0}, {1.0, 0.5});
  camera_.center = Vec2(50.0, 50.0);
  EXPECT_TRUE(drawing().segments.empty());
}

// A bob on a rod from (0, 1), a box pinned by its corner, a disc that falls until its string is taut.
Preset jointed_scene() {
  Preset preset;
  preset.scene.forces.gravity = Vec2(0.0, -10.0);
  preset.scene.bodies = {disc("bob", {1.0, 1.0}, {0.0, 0.0}, 1.0), disc("box", {3.0, 0.0}, {0.0, 0.0}, 1.0),
                         disc("hung", {6.0, 0.0}, {0.0, 0.0}, 1.0)};
  preset.scene.bodies[1].shape = Box{0.4, 0.2};
  preset.scene.bodies[1].angle = 0.5;
  Joint rod;
  rod.body = "bob";
  rod.anchor = Vec2(0.0, 1.0);
  Joint pin;
  pin.kind = JointKind::kPin;
  pin.body = "box";
  pin.point = Vec2(0.2, 0.1);
  pin.anchor = Vec2(3.0 + 0.2 * std::cos(0.5) - 0.1 * std::sin(0.5), 0.2 * std::sin(0.5) + 0.1 * std::cos(0.5));
  Joint string;
  string.kind = JointKind::kString;
  string.body = "hung";
  string.anchor = Vec2(6.0, 1.0);
  string.length = 2.0;
  preset.scene.joints = {rod, pin, string};
  return preset;
}

TEST_F(JointsDrawn, AFrameHasJointEndsAndTautStrings) {
  const Preset preset = jointed_scene();
  for (const double time : {0.0, 0.3, 0.6}) {
    const Frame frame = run_to(preset, time);
    ASSERT_EQ(frame.joints.size(), 3U);
    EXPECT_EQ(frame.joints[0].from, Vec2(0.0, 1.0));
    EXPECT_EQ(frame.joints[0].to, frame.state.position(0));
    EXPECT_NEAR(frame.joints[0].length, 1.0, 1e-15);
    EXPECT_LT((frame.joints[1].to - frame.joints[1].from).norm(), 1e-12) << time;
    EXPECT_TRUE(frame.joints[0].taut);
    // It is taut from t = √(2·1 m/g) = 0.447 s on.
    EXPECT_EQ(frame.joints[2].taut, time > 0.5) << time;
    EXPECT_EQ(frame.joints[2].length, 2.0);
  }
}

TEST_F(JointsDrawn, FittingHoldsWhatJointsHangOn) {
  joint(JointKind::kString, {-3.0, 4.0}, {0.0, 0.0}).in_plane = true;
  frame_.bodies = std::make_shared<const std::vector<Body>>();
  EXPECT_EQ(bounds(frame_).lower.x(), -3.0);
  EXPECT_EQ(bounds(frame_).upper.y(), 4.0);
}

}  // namespace
}  // namespace carom
