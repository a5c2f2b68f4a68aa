#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

#include "widgets/scene/camera.h"
#include "widgets/scene/grid.h"

namespace carom {
namespace {

Camera sample_camera() {
  Camera camera;
  camera.center = Vec2(3.0, -2.0);
  camera.scale = 120.0;
  camera.viewport = QSizeF(800, 500);
  return camera;
}

TEST(Camera, ScreenAndWorldRoundTrip) {
  const Camera camera = sample_camera();
  const Vec2 point(4.25, -1.5);
  EXPECT_TRUE(camera.to_world(camera.to_screen(point)).isApprox(point, 1e-12));
  EXPECT_EQ(camera.to_screen(camera.center), QPointF(400, 250));
  EXPECT_LT(camera.to_screen(Vec2(3.0, 0.0)).y(), 250.0) << "y points up";
}

TEST(Camera, ZoomKeepsThePointUnderTheCursor) {
  Camera camera = sample_camera();
  const QPointF cursor(123, 456);
  const Vec2 before = camera.to_world(cursor);
  camera.zoom_at(cursor, 3.7);
  EXPECT_DOUBLE_EQ(camera.scale, 120.0 * 3.7);
  EXPECT_TRUE(camera.to_world(cursor).isApprox(before, 1e-12));
}

TEST(Camera, PanMovesTheWorldWithTheHand) {
  Camera camera = sample_camera();
  const QPointF before = camera.to_screen(Vec2(1.0, 1.0));
  camera.pan(QPointF(30, -20));
  const QPointF moved = camera.to_screen(Vec2(1.0, 1.0)) - before;
  EXPECT_NEAR(moved.x(), 30.0, 1e-9);
  EXPECT_NEAR(moved.y(), -20.0, 1e-9);
}

TEST(Camera, FitsWithinMargins) {
  Camera camera = sample_camera();
  camera.fit({Vec2(0.0, 0.0), Vec2(10.0, 1.0)}, QMarginsF(50, 10, 30, 40));
  EXPECT_NEAR(camera.to_screen(Vec2(0.0, 0.5)).x(), 50.0, 1e-9);
  EXPECT_NEAR(camera.to_screen(Vec2(10.0, 0.5)).x(), 770.0, 1e-9);
  EXPECT_NEAR(camera.to_screen(Vec2(5.0, 0.5)).y(), 10.0 + 450.0 / 2, 1e-9);
}

TEST(Camera, ShowsAllOfAView) {
  Camera camera = sample_camera();
  camera.show({Vec2(1.0, 2.0), 4.0});
  EXPECT_NEAR(camera.visible().lower.x(), -1.0, 1e-12);
  EXPECT_NEAR(camera.visible().upper.x(), 3.0, 1e-12);
  camera.show({Vec2(1.0, 2.0), 4.0, 5.0});
  EXPECT_NEAR(camera.visible().lower.y(), -0.5, 1e-12);
  EXPECT_NEAR(camera.visible().upper.y(), 4.5, 1e-12);
  camera.viewport = {800.0, 200.0};
  camera.show({Vec2(1.0, 2.0), 4.0});
  EXPECT_NEAR(camera.visible().lower.y(), 2.0 - 1.25, 1e-12) << "five eighths of the width";
}

TEST(Grid, StepsAreOneTwoFive) {
  EXPECT_DOUBLE_EQ(step_not_above(0.7), 0.5);
  EXPECT_DOUBLE_EQ(step_not_above(2.0), 2.0);
  EXPECT_DOUBLE_EQ(step_not_above(19.0), 10.0);
  EXPECT_DOUBLE_EQ(step_not_below(0.7), 1.0);
  EXPECT_DOUBLE_EQ(step_not_below(0.2), 0.2);
  EXPECT_DOUBLE_EQ(step_not_below(2.1), 5.0);
  EXPECT_DOUBLE_EQ(step_not_below(1000.0), 1000.0);
}

TEST(Grid, EveryFifthLineIsStrongAtEveryZoom) {
  Grid grid;
  for (double scale = 0.01; scale < 1e4; scale *= 1.7) {
    Camera camera = sample_camera();
    camera.scale = scale;
    place_grid(camera, grid);
    const auto strong = std::count_if(grid.lines.begin(), grid.lines.end(), [](auto& l) { return l.strong; });
    EXPECT_NEAR(static_cast<double>(grid.lines.size()) / 5.0, static_cast<double>(strong), 2.0);
    EXPECT_LT(grid.lines.size(), 80U);
    EXPECT_GT(grid.scale_bar * scale, 59.0);
    EXPECT_LT(grid.scale_bar * scale, 151.0);
  }
}

TEST(Grid, LinesLieOnWholeDevicePixels) {
  const Camera camera = sample_camera();
  for (const double ratio : {1.0, 1.5, 2.0}) {
    const QRectF line = line_rect({true, false, 0.37}, camera, 1.0, ratio);
    EXPECT_NEAR(line.left() * ratio, std::round(line.left() * ratio), 1e-9);
    EXPECT_NEAR(line.width() * ratio, std::round(line.width() * ratio), 1e-9);
    EXPECT_NEAR(line.center().x(), camera.to_screen(Vec2(0.37, 0.0)).x(), 1.0);
  }
}

TEST(Grid, LengthsHaveTheUnitThatSuits) {
  EXPECT_EQ(length_text(1.0), "1 m");
  EXPECT_EQ(length_text(0.2), "20 cm");
  EXPECT_EQ(length_text(0.005), "5 mm");
  EXPECT_EQ(length_text(2000.0), "2 km");
}

}  // namespace
}  // namespace carom
