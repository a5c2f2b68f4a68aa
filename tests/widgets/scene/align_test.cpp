#include "widgets/scene/align.h"

#include <cmath>
#include <numbers>

#include "tests/widgets/scene/scene_tools_fixture.h"

namespace carom {
namespace {

std::vector<Body> three() {
  std::vector<Body> bodies(3);
  bodies[0].shape = Disc{0.5};
  bodies[0].position = Vec2(0.0, 0.0);
  bodies[1].shape = Box{2.0, 1.0};
  bodies[1].position = Vec2(5.0, 1.0);
  bodies[1].angle = 0.5 * std::numbers::pi;  // 1 m wide, 2 m high
  bodies[2].shape = Disc{0.25};
  bodies[2].position = Vec2(1.75, 3.0);
  return bodies;
}

TEST(Align, PutsSidesAndMiddlesOfTheBoundsInLine) {
  const auto at = [](Alignment alignment, int axis) {
    std::vector<double> out;
    for (const Body& body : aligned(three(), alignment))
      out.push_back(std::round(1e9 * body.position[axis]) / 1e9);
    return out;
  };
  using Places = std::vector<double>;
  EXPECT_EQ(at(Alignment::kLeft, 0), (Places{0.0, 0.0, -0.25}));
  EXPECT_EQ(at(Alignment::kCentre, 0), (Places{2.5, 2.5, 2.5}));
  EXPECT_EQ(at(Alignment::kRight, 0), (Places{5.0, 5.0, 5.25}));
  EXPECT_EQ(at(Alignment::kTop, 1), (Places{2.75, 2.25, 3.0}));
  EXPECT_EQ(at(Alignment::kMiddle, 1), (Places{1.375, 1.375, 1.375}));
  EXPECT_EQ(at(Alignment::kBottom, 1), (Places{0.0, 0.5, -0.25}));
  EXPECT_EQ(at(Alignment::kLeft, 1), (Places{0.0, 1.0, 3.0}));
}

// A dumb-bell, upright and tilted, beside a box whose right side is at 5.5 m.
TEST(Align, TakesTheBoundsOfEachShape) {
  std::vector<Body> bodies = three();
  bodies[0].shape = Compound{{{Disc{0.3}, Vec2(-0.5, 0.0), 0.0, {}}, {Disc{0.3}, Vec2(0.5, 0.0), 0.0, {}}}};
  bodies[0].angle = 0.5 * std::numbers::pi;
  EXPECT_NEAR(aligned(bodies, Alignment::kRight)[0].position.x(), 5.2, 1e-12);
  bodies[0].angle = 0.3;
  EXPECT_NEAR(aligned(bodies, Alignment::kRight)[0].position.x(), 5.2 - 0.5 * std::cos(0.3), 1e-12);
}

TEST(Align, DistributesWithEqualGaps) {
  const std::vector<Body> spread = aligned(three(), Alignment::kAcross);
  EXPECT_NEAR(spread[0].position.x(), 0.0, 1e-12);
  EXPECT_NEAR(spread[1].position.x(), 5.0, 1e-12);
  EXPECT_NEAR(spread[2].position.x(), 2.5, 1e-12);
}

TEST(Align, LeavesHalfPlanesOut) {
  std::vector<Body> bodies = three();
  bodies[1].shape = Wall{};
  const std::vector<Body> out = aligned(bodies, Alignment::kRight);
  EXPECT_EQ(out[1].position, Vec2(5.0, 1.0));
  EXPECT_NEAR(out[0].position.x(), 1.5, 1e-12);
}

TEST_F(SceneToolsTest, AlignsTheSelectedBodiesInOneStep) {
  view_.select({"A"});
  EXPECT_FALSE(view_.can_align());
  scene_.bodies.back().position.y() = 1.6;
  show(true);
  view_.select({"A", "B"});
  ASSERT_TRUE(view_.can_align());
  view_.align(Alignment::kMiddle);
  ASSERT_EQ(told_.size(), 1U);
  EXPECT_EQ(told_[0].name, "Align 2 bodies in a row");
  ASSERT_EQ(told_[0].edits.size(), 2U);
  EXPECT_NEAR(replaced(told_[0].edits[0]).position.y(), replaced(told_[0].edits[1]).position.y(), 1e-12);
}

TEST_F(SceneToolsTest, SaysTheOverlapThatAnAlignmentMakes) {
  answers_ = true;
  scene_.bodies.back().position = scene_.bodies[1].position + Vec2(0.1, 0.9);
  show(true);
  view_.select({"A", "B"});
  view_.align(Alignment::kMiddle);
  EXPECT_TRUE(view_.bubble().value.contains("overlap by")) << view_.bubble().value.toStdString();
  EXPECT_TRUE(view_.bubble().fault);
  scene_.bodies.back().position = scene_.bodies[1].position + Vec2(2.0, 0.9);
  show(true);
  view_.align(Alignment::kMiddle);
  EXPECT_TRUE(view_.bubble().value.isEmpty());
}

}  // namespace
}  // namespace carom
