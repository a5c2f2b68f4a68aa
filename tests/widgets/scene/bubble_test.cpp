#include "widgets/scene/bubble.h"

#include "tests/widgets/scene/scene_tools_fixture.h"

// Where the bubble of a drag stands. The arrow of A points up from (200, 200).
namespace carom {
namespace {

class BubbleTest : public SceneToolsTest {
 protected:
  [[nodiscard]] QRectF rect() const { return rect_of(view_.bubble(), view_.font(), QSizeF(view_.size())); }
  // Pulls the tip of A's arrow to there, and holds it.
  void pull_to(const QPoint& to) {
    view_.select({"A"});
    const Camera& camera = view_.camera();
    const QPoint tip = camera.to_screen(view_.drawing().arrows[0].to).toPoint();
    press(tip);
    move((tip + to) / 2);
    move(to);
    ASSERT_FALSE(view_.bubble().value.isEmpty());
  }
  [[nodiscard]] Vec2 world(const QPointF& at) const { return view_.camera().to_world(at); }
  [[nodiscard]] Aim aim(const QPointF& from, const QPointF& to) const {
    return {.time = 1.0, .paths = {{world(from), world(to)}}, .meeting = {}};
  }
};

// A chip lies over the view, where the mouse goes.
TEST_F(BubbleTest, StandsClearOfWhatLiesOverTheView) {
  answers_ = true;
  ASSERT_NO_FATAL_FAILURE(pull_to(QPoint(280, 150)));
  QWidget chip(&view_);
  chip.setGeometry(rect().toRect().adjusted(10, 10, 40, 0));
  chip.show();
  move(QPoint(281, 151));
  EXPECT_FALSE(rect().intersects(QRectF(chip.geometry())));
}

TEST_F(BubbleTest, StandsClearOfTheWayToTheFirstImpact) {
  answers_ = true;
  ASSERT_NO_FATAL_FAILURE(pull_to(QPoint(280, 150)));
  EXPECT_NEAR(rect().left(), 280.0 + 16.0, 1e-9) << "where the mouse went";
  EXPECT_NEAR(rect().bottom(), 150.0 - 16.0, 1e-9);
  view_.set_aim(aim(QPointF(280, 150), QPointF(590, 20)));
  EXPECT_NEAR(rect().right(), 280.0 - 16.0, 1e-9);
  EXPECT_NEAR(rect().bottom(), 150.0 - 16.0, 1e-9);
  EXPECT_EQ(view_.bubble().clear_of.covered_by(rect()), 0);
  // Below are the arrow and its angle: no place covers nothing.
  Aim two = aim(QPointF(280, 150), QPointF(590, 20));
  two.paths.push_back({world(QPointF(280, 150)), world(QPointF(100, 10))});
  view_.set_aim(two);
  EXPECT_EQ(view_.bubble().clear_of.covered_by(rect()), 1);
}

TEST_F(BubbleTest, StandsClearOfTheGhost) {
  view_.select({"A"});
  press(a_);
  move(a_ + QPoint(8, 8));
  move(a_ + QPoint(12, 12));
  EXPECT_FALSE(view_.bubble().value.isEmpty());
  EXPECT_EQ(view_.bubble().clear_of.rects.size(), 0U) << "the drag hides the handles";
  EXPECT_GT(view_.bubble().clear_of.areas.size(), 0U) << "the ghost";
  EXPECT_EQ(view_.bubble().clear_of.covered_by(rect()), 0);
}

// Handles can be seen around; words can't be read under it.
TEST_F(BubbleTest, CoversHandlesBeforeWords) {
  Bubble bubble{"2.0 m/s", {}, QPointF(300, 200), QPointF(290, 210), false};
  const QSizeF size(80, 30);
  const QSizeF view(600, 400);
  const QRectF first = place_of(bubble, size, view);
  bubble.clear_of.texts = {first};
  for (const QPointF& away : {QPointF(-112, 0), QPointF(0, 62), QPointF(-112, 62)}) {
    for (const int x : {5, 30, 55}) {
      bubble.clear_of.rects.emplace_back(first.topLeft() + away + QPointF(x, 5), QSizeF(10, 10));
    }
  }
  EXPECT_FALSE(place_of(bubble, size, view).intersects(first));
}

TEST_F(BubbleTest, StandsWithinTheScene) {
  const Bubble bubble{"2.0 m/s", {}, QPointF(590, 5), QPointF(500, 50), false};
  const QRectF place = place_of(bubble, {80, 30}, {600, 400});
  EXPECT_EQ(place.topRight(), QPointF(590.0 - 16.0, 5.0 + 16.0));
}

TEST_F(BubbleTest, AnAngleStandsBesideThePulledArrow) {
  ASSERT_NO_FATAL_FAILURE(pull_to(QPoint(280, 150)));
  const Overlay overlay = view_.findChild<SceneTools*>()->overlay();
  ASSERT_TRUE(overlay.direction);
  EXPECT_EQ(overlay.direction->foot, QPointF(200.0, 200.0));
  EXPECT_NEAR(overlay.direction->degrees, 30.0, 1e-9);
  const QRectF text = text_place(*overlay.direction);
  EXPECT_GT(text.left(), 200.0 + 0.5 * overlay.direction->length);
  EXPECT_LT(text.center().y(), 200.0);
  EXPECT_GT(text.top(), 150.0);
  // A small angle leaves no room between the arrow and the horizontal.
  EXPECT_GT(text_place({QPointF(200.0, 200.0), 100.0, 5.0}).top(), 200.0);
  EXPECT_TRUE(text_place({QPointF(200.0, 200.0), 100.0, 0.0}).isEmpty());
  release(QPoint(280, 150));
  EXPECT_FALSE(view_.findChild<SceneTools*>()->overlay().direction);
}

}  // namespace
}  // namespace carom
