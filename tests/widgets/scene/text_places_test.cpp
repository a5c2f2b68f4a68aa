#include "widgets/scene/text_places.h"

#include "tests/widgets/scene/scene_tools_fixture.h"
#include "widgets/scene/scale_row.h"

// Where names stand beside handles and the signs of overlaps.
namespace carom {
namespace {

class TextPlacesTest : public SceneToolsTest {
 protected:
  [[nodiscard]] Overlay overlay() const { return view_.findChild<SceneTools*>()->overlay(); }
  [[nodiscard]] QRectF place_of_name(const QString& name, const Obstacles& obstacles) const {
    for (const NamePlace& place : name_places(view_.drawing(), view_.camera(), view_.font(), obstacles)) {
      if (view_.drawing().labels[place.label].text == name) return place.rect;
    }
    return {};
  }
  void add_stack(double width, int count) {
    scene_.bodies.clear();
    for (int k = 0; k < count; ++k) {
      Body brick;
      brick.name = "brick-" + std::to_string(k);
      brick.shape = Box{width, kHeight};
      brick.position = Vec2(2.0, 0.4 + kHeight * k);
      scene_.bodies.push_back(brick);
    }
    give_ids(scene_);
    show(true);
  }
  [[nodiscard]] QRectF brick(int k) const {
    const Body& body = scene_.bodies[static_cast<std::size_t>(k)];
    const double width = 100.0 * std::get<Box>(body.shape).width;
    const QPointF centre = view_.camera().to_screen(body.position);
    return {centre.x() - 0.5 * width, centre.y() - 50.0 * kHeight, width, 100.0 * kHeight};
  }
  static constexpr double kHeight = 0.3;  // m
};

// Broad bricks have room for their names, narrow ones beside them. The lowest one stands on nothing.
TEST_F(TextPlacesTest, NamesOfAStackStandOnNoOtherBody) {
  for (const double width : {1.2, 0.16}) {
    add_stack(width, 4);
    for (int k = 0; k < 4; ++k) {
      const QRectF name = place_of_name(QString("brick-%1").arg(k), {});
      ASSERT_FALSE(name.isEmpty()) << k;
      for (int i = 0; i < 4; ++i) {
        if (i == k && k > 0 && width > 1.0) {
          EXPECT_TRUE(brick(i).contains(name)) << k;
        } else {
          EXPECT_FALSE(brick(i).intersects(name)) << k << " on " << i;
        }
      }
    }
  }
}

TEST_F(TextPlacesTest, ANameWithinABodyMakesRoomForAnArrow) {
  add_stack(1.2, 2);
  Drawing drawing = view_.drawing();
  const auto place = [&]() -> QRectF {
    for (const NamePlace& each : name_places(drawing, view_.camera(), view_.font(), {})) {
      if (drawing.labels[each.label].text == "brick-1") return each.rect;
    }
    return {};
  };
  const QRectF before = place();
  const Vec2 centre = view_.camera().to_world(before.center());
  drawing.arrows.push_back({centre - Vec2(0.0, 0.2), centre + Vec2(0.0, 0.2), Qt::red, 2.0});
  EXPECT_NE(place(), before);
  EXPECT_TRUE(brick(1).contains(place()));
  Obstacles arrow;
  arrow.lines.emplace_back(before.center() + QPointF(0.0, 20.0), before.center() - QPointF(0.0, 20.0));
  EXPECT_EQ(arrow.covered_by(place()), 0);
}

// As where discs are packed: a name on another body would be taken for that one's.
TEST_F(TextPlacesTest, ANameWithoutAPlaceIsLeftOut) {
  scene_.bodies.clear();
  for (int k = 0; k < 9; ++k) {
    Body ball;
    ball.name = k == 4 ? "middle" : std::string(1, static_cast<char>('a' + k));
    ball.shape = Disc{0.15};
    ball.position = Vec2(2.0 + 0.3 * (k % 3), 1.0 + 0.3 * (k / 3));
    scene_.bodies.push_back(ball);
  }
  give_ids(scene_);
  show(true);
  EXPECT_TRUE(place_of_name("middle", {}).isEmpty());
  EXPECT_FALSE(place_of_name("a", {}).isEmpty());
}

TEST_F(TextPlacesTest, NamesStandClearOfHandles) {
  // The arrow points up, so the knob stands below, where the name would be.
  view_.select({"A"});
  const Obstacles obstacles = obstacles_of_names(overlay(), view_.camera());
  EXPECT_GT(obstacles.covered_by(place_of_name("A", {})), 0);
  EXPECT_EQ(obstacles.covered_by(place_of_name("A", obstacles)), 0);
  EXPECT_GT(place_of_name("A", obstacles).top(), place_of_name("A", {}).top());
}

TEST_F(TextPlacesTest, NamesStandClearOfTheSignOfAnOverlap) {
  scene_.bodies[2].position = Vec2(1.0, 0.35);  // its sign lies under A
  show(true);
  const Obstacles obstacles = obstacles_of_names(overlay(), view_.camera());
  ASSERT_EQ(obstacles.rects.size(), 1U);
  Obstacles at_name;
  at_name.rects.push_back(place_of_name("B", {}));
  EXPECT_EQ(at_name.covered_by(place_of_name("B", at_name)), 0);
  EXPECT_EQ(obstacles.covered_by(place_of_name("A", obstacles)), 0);
}

// Above a body where the scale is below it, and where the view ends.
TEST_F(TextPlacesTest, NamesStandClearOfTheScaleAndTheEdge) {
  const Camera& camera = view_.camera();
  const std::vector<ScaleMark> row = scale_row(view_.drawing(), camera, view_.font());
  ASSERT_FALSE(row.empty());
  const QPointF scale = row.front().rect.center();
  const QPointF edge(0.7 * camera.viewport.width(), camera.viewport.height());
  for (const QPointF& at : {scale, edge}) {
    const double radius = half_extent(scene_.bodies[1].shape, 0.0).y();
    scene_.bodies[1].position = camera.to_world(at) + Vec2(0.0, radius + 12.0 / camera.scale);
    show(true);
    const QRectF name = place_of_name("A", {});
    EXPECT_LT(name.bottom(), camera.to_screen(scene_.bodies[1].position).y()) << at.y();
    for (const ScaleMark& mark : row) EXPECT_FALSE(mark.rect.intersects(name));
  }
}

TEST_F(TextPlacesTest, TheNearestClearPlaceIsTaken) {
  Obstacles obstacles;
  const QRectF view(0, 0, 600, 400);
  const QRectF text(100, 100, 60, 16);
  EXPECT_EQ(clear_place(text, obstacles, view, {}), text);
  obstacles.discs.push_back({text.center(), 50.0});
  const QRectF moved = clear_place(text, obstacles, view, QPointF(1.0, 0.0));
  EXPECT_EQ(obstacles.covered_by(moved), 0);
  EXPECT_LT(QLineF(moved.center(), text.center()).length(), 100.0);
  obstacles.rects.push_back(view);  // nothing is clear: still near, and in view
  EXPECT_TRUE(view.contains(clear_place(text, obstacles, view, QPointF(1.0, 0.0))));
}

}  // namespace
}  // namespace carom
