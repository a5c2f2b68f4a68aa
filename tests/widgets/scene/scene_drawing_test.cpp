#include <QImage>
#include <QPainter>
#include <gtest/gtest.h>

#include "physics/preset/preset.h"
#include "tests/support/body_literal.h"
#include "tests/support/scene_fixture.h"
#include "widgets/scene/drawing.h"
#include "widgets/scene/paint_drawing.h"
#include "widgets/scene/scene_thumbnail.h"

namespace carom {
namespace {

using namespace test::literals;

class DrawingOf : public testing::Test {
 protected:
  [[nodiscard]] Drawing drawing(std::span<const ImpactRecord> impacts = {}) const {
    return make_drawing({*frame_, impacts, camera_, options_, light_theme(), ArrowScale{0.1, 0.5}});
  }

  void SetUp() override {
    camera_.center = Vec2(2.0, 1.0);
    camera_.scale = 100.0;
  }

  std::shared_ptr<Frame> frame_ = frame_of(Simulation(setup_of(two_discs())));
  Camera camera_;
  DrawingOptions options_;
};

TEST_F(DrawingOf, HasEveryBodyWhereItIs) {
  const Drawing d = drawing();
  ASSERT_EQ(d.boxes.size(), 1U);
  ASSERT_EQ(d.discs.size(), 2U);
  EXPECT_EQ(d.boxes[0].center, Vec2(2.0, -0.1));
  EXPECT_EQ(d.boxes[0].half, Vec2(2.0, 0.1));
  EXPECT_EQ(d.boxes[0].fill, light_theme().wall_fill);
  EXPECT_EQ(d.discs[0].center, Vec2(1.0, 1.0));
  EXPECT_EQ(d.discs[0].radius, 0.5);
  EXPECT_EQ(d.discs[0].fill, light_theme().body_fill);
  EXPECT_TRUE(d.discs[0].oriented);
}

// Fixed bodies are not drawn again.
TEST_F(DrawingOf, HasTheRunBeforeAsOutlinesUnderItsBodies) {
  Eigen::Matrix3Xd q = frame_->state.q;
  q.row(0).array() += 0.25;
  const PlacedBodies before{frame_->bodies, q};
  const auto drawn = [&] {
    return make_drawing({.frame = *frame_,
                         .impacts = {},
                         .camera = camera_,
                         .options = options_,
                         .theme = light_theme(),
                         .arrows = {0.1, 0.5},
                         .before = &before});
  };
  const Drawing d = drawn();
  ASSERT_EQ(d.discs.size(), 4U);
  EXPECT_EQ(d.boxes.size(), 1U);
  EXPECT_EQ(d.discs[0].center, Vec2(1.25, 1.0));
  EXPECT_EQ(d.discs[0].fill.alpha(), 0);
  EXPECT_NE(d.discs[0].line, d.discs[2].line) << "pale";
  EXPECT_EQ(d.discs[2].center, Vec2(1.0, 1.0));
  options_.run_before = false;
  EXPECT_EQ(drawn().discs.size(), 2U);
}

TEST_F(DrawingOf, NamesMovingBodiesBelowThem) {
  const Drawing d = drawing();
  ASSERT_EQ(d.labels.size(), 2U);
  EXPECT_EQ(d.labels[1].text, "B");
  EXPECT_EQ(d.labels[1].anchor, Vec2(3.0, 0.75));
}

// A cup of 3 m × 2 m whose corner is at the origin; x from 1 to 2 above y = 1 is empty.
TEST_F(DrawingOf, ADentIsFreeAndPartsHaveNoSeams) {
  Preset preset;
  Body& cup = preset.scene.bodies.emplace_back();
  cup.name = "cup";
  cup.shape = Polygon{{{0, 0}, {3, 0}, {3, 2}, {2, 2}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}};
  cup.position = Vec2(1.5, 0.9);
  frame_ = frame_of(Simulation(setup_of(preset)));
  ASSERT_EQ(drawing().labels.size(), 1U);
  EXPECT_LT((drawing().labels[0].anchor - Vec2(1.5, 0.0)).norm(), 1e-12) << "under its lowest point";
  options_.grid = options_.names = options_.velocities = false;
  camera_.center = Vec2(1.5, 1.0);
  camera_.viewport = QSizeF(400, 300);
  QImage image(400, 300, QImage::Format_RGB32);
  QPainter painter(&image);
  paint_drawing(painter, drawing(), camera_, light_theme());
  painter.end();
  const auto inside = [](const Vec2& at, double low, double high_x, double high_y) {
    return at.x() > low && at.x() < high_x && at.y() > low && at.y() < high_y;
  };
  constexpr double kLine = 0.03;  // m, more than the outline
  for (int x = 0; x < 300; ++x) {
    for (int y = 0; y < 200; ++y) {
      const Vec2 at(0.01 * x + 0.005, 0.01 * y + 0.005);
      const bool base = inside(at, kLine, 3.0 - kLine, 1.0 - kLine);
      const bool arm = inside(at, kLine, 1.0 - kLine, 2.0 - kLine);
      const bool dent = inside(at - Vec2(1.0, 1.0), kLine, 1.0 - kLine, 1.0);
      if (!base && !arm && !dent) continue;
      const QColor expected = dent ? light_theme().scene_ground : light_theme().body_fill;
      ASSERT_EQ(image.pixelColor(camera_.to_screen(at).toPoint()).name(), expected.name()) << at.transpose();
    }
  }
}

// The same cup fills a thumbnail of 60×40 px but for a margin.
TEST_F(DrawingOf, AThumbnailShowsTheDent) {
  Preset preset;
  Body& cup = preset.scene.bodies.emplace_back();
  cup.name = "cup";
  cup.shape = Polygon{{{0, 0}, {3, 0}, {3, 2}, {2, 2}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}};
  const QImage image =
      scene_thumbnail(*frame_of(Simulation(setup_of(preset))), light_theme(), {60, 40}, 1.0).toImage();
  ASSERT_EQ(image.size(), QSize(60, 40));
  const QColor body = image.pixelColor(30, 30);
  const QColor dent = image.pixelColor(30, 12);
  EXPECT_NE(body, dent);
  EXPECT_EQ(image.pixelColor(30, 1), dent) << "the ground";
  EXPECT_EQ(image.pixelColor(15, 12), body) << "left arm";
  EXPECT_EQ(image.pixelColor(45, 12), body) << "right arm";
}

TEST_F(DrawingOf, NamesNothingWhereItWouldBeClutter) {
  camera_.scale = 100.0;
  Preset preset;
  preset.scene.generators = {{.columns = 8, .rows = 8, .spacing = Vec2(0.3, 0.3)}};
  frame_ = frame_of(Simulation(setup_of(preset)));
  EXPECT_TRUE(drawing().labels.empty());
  frame_ = frame_of(Simulation(setup_of(two_discs())));
  camera_.scale = 20.0;
  EXPECT_EQ(drawing().labels.size(), 1U) << "a disc of 5 px is too small to name";
}

TEST_F(DrawingOf, NamesThatWouldLieOverOneAnotherAreLeftOut) {
  camera_.viewport = QSizeF(400, 300);
  const auto picture = [&](const Drawing& d) {
    QImage image(camera_.viewport.toSize(), QImage::Format_RGB32);
    QPainter painter(&image);
    paint_drawing(painter, d, camera_, light_theme());
    return image;
  };
  Drawing d = drawing();
  const QImage apart = picture(d);
  d.labels.push_back(d.labels[1]);
  d.labels.back().text = "domino";
  EXPECT_EQ(picture(d), apart);
  d.labels.back().drop += 30.0;
  EXPECT_NE(picture(d), apart);
}

TEST_F(DrawingOf, ArrowsAreVelocitiesInScale) {
  const Drawing d = drawing();
  ASSERT_EQ(d.arrows.size(), 1U) << "the disc at rest has none";
  EXPECT_EQ(d.arrows[0].from, Vec2(1.0, 1.0));
  EXPECT_TRUE(d.arrows[0].to.isApprox(Vec2(1.0, 1.2), 1e-12));
}

TEST_F(DrawingOf, OptionsTakeThingsAway) {
  options_ = {.grid = false, .velocities = false, .contacts = false, .names = false};
  const Drawing d = drawing();
  EXPECT_FALSE(d.has_grid);
  EXPECT_TRUE(d.arrows.empty());
  EXPECT_TRUE(d.labels.empty());
  EXPECT_EQ(d.discs.size(), 2U);
}

TEST_F(DrawingOf, ImpactsPushTheMovingBodyAndFade) {
  options_.velocities = false;
  frame_->time = 1.0;
  ImpactRecord impact;
  impact.time = 1.0 - kImpactShown / 2;
  impact.a = 0_b;  // the floor
  impact.b = 1_b;
  impact.point = Vec2(1.0, 0.0);
  impact.normal = Vec2::UnitY();
  impact.normal_impulse = 0.8;
  ImpactRecord old = impact;
  old.time = 1.0 - 2 * kImpactShown;
  const std::vector<ImpactRecord> impacts = {old, impact};
  const Drawing d = drawing(impacts);
  ASSERT_EQ(d.arrows.size(), 1U);
  EXPECT_TRUE(d.arrows[0].to.isApprox(Vec2(1.0, 0.4), 1e-12));
  EXPECT_NEAR(d.arrows[0].color.alphaF(), 0.5, 0.01);
}

TEST_F(DrawingOf, LeavesOutWhatTheCameraDoesNotSee) {
  camera_.center = Vec2(100.0, 100.0);
  const Drawing d = drawing();
  EXPECT_TRUE(d.discs.empty());
  EXPECT_TRUE(d.boxes.empty());
  EXPECT_TRUE(d.labels.empty());
  EXPECT_FALSE(d.grid.lines.empty());
}

TEST(ArrowScale, KeepsThePeakReadable) {
  for (double speed = 1e-3; speed < 1e4; speed *= 3.0) {
    const double length = arrow_scale({.speed = speed, .impulse = 0.0, .moving = 2}, 4.0).seconds * speed;
    EXPECT_LT(length, 0.25 * 4.0);
    EXPECT_GT(length, 0.08 * 4.0);
  }
}

TEST(ArrowScale, ShowsNoSpeedThatIsRounding) {
  EXPECT_LT(arrow_scale({.speed = 1e-14, .impulse = 0.0, .moving = 1}, 4.0).seconds * 1e-14, 1e-9);
}

}  // namespace
}  // namespace carom
