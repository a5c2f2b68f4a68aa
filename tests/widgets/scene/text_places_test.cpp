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
};

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
