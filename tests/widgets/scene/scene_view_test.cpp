#include "widgets/scene/scene_view.h"

#include <QGuiApplication>
#include <QHelpEvent>
#include <QImage>
#include <QPixmap>
#include <QSignalSpy>
#include <QTest>
#include <QToolTip>
#include <QWheelEvent>
#include <gtest/gtest.h>

#include "physics/preset/preset.h"
#include "tests/support/body_literal.h"
#include "tests/support/scene_fixture.h"
#include "widgets/scene/hit.h"
#include "widgets/scene/paint_drawing.h"

namespace carom {
namespace {

using namespace test::literals;

// 600×400 px, 100 px/m: the world's (2, 1) stands at (300, 200).
class SceneViewTest : public testing::Test {
 protected:
  void SetUp() override { open(view_); }

  static void open(SceneView& view) {
    view.resize(600, 400);
    view.set_view(View{Vec2(2.0, 1.0), 6.0});
    view.set_frame(frame_of(Simulation(setup_of(two_discs()))));
    view.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&view));
  }

  void wheel(const QPoint& at, int delta) {
    QWheelEvent event(at, view_.mapToGlobal(at), {}, {0, delta}, Qt::NoButton, Qt::NoModifier,
                      Qt::NoScrollPhase, false);
    QGuiApplication::sendEvent(&view_, &event);
  }

  SceneView view_{light_theme()};
  QSignalSpy spawned_{&view_, &SceneView::spawnRequested};
  QSignalSpy selected_{&view_, &SceneView::selectionChanged};
};

TEST_F(SceneViewTest, PaintsBodiesOnTheGround) {
  DrawingOptions options;
  options.grid = false;
  options.velocities = false;
  view_.set_options(options);
  const QImage image = view_.grab().toImage();
  EXPECT_EQ(image.pixelColor(180, 210), light_theme().body_fill);
  EXPECT_EQ(image.pixelColor(300, 310), light_theme().wall_fill);
  EXPECT_EQ(image.pixelColor(300, 100), light_theme().scene_ground);
  view_.set_theme(dark_theme());
  EXPECT_EQ(view_.grab().toImage().pixelColor(180, 210), dark_theme().body_fill);
}

TEST_F(SceneViewTest, TheMouseFindsAThinWall) {
  Preset preset = two_discs();
  preset.scene.bodies[0].shape = Wall{2.0};
  preset.scene.bodies[0].position = Vec2(2.0, 2.0);
  const auto frame = frame_of(Simulation(setup_of(preset)));
  const QPointF on = view_.camera().to_screen(Vec2(2.5, 2.0));
  EXPECT_EQ(body_at(*frame, view_.camera(), on), 0);
  EXPECT_EQ(body_at(*frame, view_.camera(), on + QPointF(0.0, 5.0)), 0);
  EXPECT_EQ(body_at(*frame, view_.camera(), on + QPointF(0.0, 8.0)), -1);
}

// A cup of 3 m × 2 m with a dent 1 m wide and deep, turned by 90°: the dent opens to the left.
TEST_F(SceneViewTest, TheMouseFindsABodyOfSeveralShapesButNotItsDent) {
  Preset preset = two_discs();
  Body& cup = preset.scene.bodies[0];
  cup.shape = Polygon{{{0, 0}, {3, 0}, {3, 2}, {2, 2}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}};
  cup.position = Vec2(2.0, 1.0);
  cup.angle = 0.5 * M_PI;
  preset.scene.bodies.resize(1);
  for (const bool fixed : {true, false}) {
    preset.scene.bodies[0].fixed = fixed;
    const auto frame = frame_of(Simulation(setup_of(preset)));
    const auto found = [&](const Vec2& from_centre) {
      return body_at(*frame, view_.camera(), view_.camera().to_screen(Vec2(2.0, 1.0) + from_centre));
    };
    // Its centre of mass is 0.9 m above its base, which is on the right.
    EXPECT_EQ(found({0.8, 1.4}), 0) << "base";
    EXPECT_EQ(found({-1.0, 1.4}), 0) << "upper arm";
    EXPECT_EQ(found({-1.0, -1.4}), 0) << "lower arm";
    EXPECT_EQ(found({-0.5, 0.0}), -1) << "dent";
    EXPECT_EQ(found({-0.15, 0.0}), -1) << "its end";
    EXPECT_EQ(found({-0.05, 0.0}), 0) << "its ground";
    const auto in = [&](const Vec2& low, const Vec2& high) {
      return bodies_in(*frame, view_.camera(),
                       QRectF(view_.camera().to_screen(Vec2(2.0, 1.0) + Vec2(low.x(), high.y())),
                              view_.camera().to_screen(Vec2(2.0, 1.0) + Vec2(high.x(), low.y()))))
          .size();
    };
    EXPECT_EQ(in({-0.9, -0.4}, {-0.2, 0.4}), 0U) << "a band within the dent";
    EXPECT_EQ(in({-0.9, -0.4}, {-0.2, 0.6}), 1U);
  }
}

TEST_F(SceneViewTest, TheMouseFindsABodyOfThinWalls) {
  Preset preset = two_discs();
  preset.scene.bodies[0].shape =
      Compound{{{Wall{2.0}, {0.0, 0.0}, 0.0, ""}, {Wall{2.0}, {1.0, 1.0}, 0.5 * M_PI, ""}}};
  preset.scene.bodies[0].position = Vec2(2.0, 1.0);
  preset.scene.bodies.resize(1);
  const auto frame = frame_of(Simulation(setup_of(preset)));
  // Its centre is 0.5 m from either wall.
  const QPointF level = view_.camera().to_screen(Vec2(1.5, 0.5));
  const QPointF upright = view_.camera().to_screen(Vec2(2.5, 1.5));
  EXPECT_EQ(body_at(*frame, view_.camera(), level + QPointF(0.0, 5.0)), 0);
  EXPECT_EQ(body_at(*frame, view_.camera(), level + QPointF(0.0, 8.0)), -1);
  EXPECT_EQ(body_at(*frame, view_.camera(), upright + QPointF(-5.0, 0.0)), 0);
  EXPECT_EQ(body_at(*frame, view_.camera(), upright + QPointF(-8.0, 0.0)), -1);
}

TEST_F(SceneViewTest, ZoomsToTheSelection) {
  const double scale = view_.camera().scale;
  view_.show_selected();
  EXPECT_EQ(view_.camera().scale, scale) << "nothing is selected";
  const Body body = two_discs().scene.bodies[1];
  view_.select({body.name});
  view_.show_selected();
  const QPointF at = view_.camera().to_screen(body.position);
  EXPECT_NEAR(at.x(), 300.0, 20.0);
  EXPECT_NEAR(at.y(), 200.0, 20.0);
  EXPECT_GT(view_.camera().scale, scale);
  const double diameter = 2.0 * bounding_radius(body.shape) * view_.camera().scale;
  EXPECT_GT(diameter, 100.0);
  EXPECT_LT(diameter, 250.0) << "there is room around it";
  Preset preset = two_discs();
  preset.scene.bodies[0].shape = Wall{};
  view_.set_frame(frame_of(Simulation(setup_of(preset))));
  view_.select({preset.scene.bodies[0].name});
  const double before = view_.camera().scale;
  view_.show_selected();
  EXPECT_EQ(view_.camera().scale, before) << "a half-plane has no end";
}

TEST_F(SceneViewTest, ArrowsAreThoseOfTheSceneNotOfTheOneBefore) {
  const double slow = view_.look().peaks.speed;
  Preset fast = two_discs();
  for (Body& body : fast.scene.bodies) body.velocity *= 100.0;
  auto frame = frame_of(Simulation(setup_of(fast)));
  frame->run = 1;
  view_.set_frame(frame);
  ASSERT_GT(view_.look().peaks.speed, slow);
  view_.set_view(View{Vec2(2.0, 1.0), 6.0});
  frame = frame_of(Simulation(setup_of(two_discs())));
  frame->run = 2;
  view_.set_frame(frame);
  EXPECT_EQ(view_.look().peaks.speed, slow);
}

TEST_F(SceneViewTest, MiddleAndRightDragPanAndAskForNothing) {
  for (const Qt::MouseButton button : {Qt::RightButton, Qt::MiddleButton}) {
    const Vec2 before = view_.camera().center;
    QTest::mousePress(&view_, button, {}, QPoint(350, 100));
    for (int x = 350; x <= 450; x += 10) {
      const QPointF at(x, 100);
      QMouseEvent move(QEvent::MouseMove, at, view_.mapToGlobal(at), Qt::NoButton, button, {});
      QGuiApplication::sendEvent(&view_, &move);
    }
    QTest::mouseRelease(&view_, button, {}, QPoint(450, 100));
    EXPECT_NEAR(view_.camera().center.x(), before.x() - 1.0, 1e-9);
    EXPECT_NEAR(view_.camera().center.y(), before.y(), 1e-9);
  }
  EXPECT_EQ(spawned_.count() + selected_.count(), 0);
}

TEST_F(SceneViewTest, WheelZoomsAtTheCursorWithinLimits) {
  const QPoint at(420, 90);
  const Vec2 held = view_.camera().to_world(at);
  wheel(at, 120);
  EXPECT_GT(view_.camera().scale, 100.0);
  EXPECT_TRUE(view_.camera().to_world(at).isApprox(held, 1e-12));
  for (int i = 0; i < 200; ++i) wheel(at, 120);
  EXPECT_LE(view_.camera().scale, 100.0 * 100.0 * 1.001);
  for (int i = 0; i < 200; ++i) wheel(at, -120);
  EXPECT_GE(view_.camera().scale, 100.0 / 50.0 * 0.999);
}

TEST_F(SceneViewTest, FitsUntilTheUserMovesTheCamera) {
  QTest::keyClick(&view_, Qt::Key_F);
  const double fitted = view_.camera().scale;
  view_.resize(900, 600);
  EXPECT_GT(view_.camera().scale, fitted);
  for (const Vec2& corner : {Vec2(0.0, -0.2), Vec2(4.0, 1.5)}) {
    EXPECT_TRUE(QRectF(view_.rect()).contains(view_.camera().to_screen(corner)));
  }
  QTest::keyClick(&view_, Qt::Key_Plus);
  const double zoomed = view_.camera().scale;
  view_.resize(600, 400);
  EXPECT_EQ(view_.camera().scale, zoomed);
  QTest::keyClick(&view_, Qt::Key_F);
  QTest::keyClick(&view_, Qt::Key_F);
  EXPECT_NEAR(view_.camera().scale, fitted, 1e-9);
}

TEST_F(SceneViewTest, TooltipDescribesTheBody) {
  const QPoint at(200, 180);
  QHelpEvent help(QEvent::ToolTip, at, view_.mapToGlobal(at));
  QGuiApplication::sendEvent(&view_, &help);
  const QString text = QToolTip::text();
  for (const char* part : {"A", "0.7854 kg", "(1, 1) m", "(0, 2) m/s", "0 rad/s"}) {
    EXPECT_TRUE(text.contains(part)) << part << " in " << text.toStdString();
  }
}

TEST_F(SceneViewTest, ShowsThatTheKeyboardCameByTab) {
  EXPECT_NE(view_.grab().toImage().pixelColor(1, 100), light_theme().accent);
  QFocusEvent in(QEvent::FocusIn, Qt::TabFocusReason);
  QGuiApplication::sendEvent(&view_, &in);
  EXPECT_EQ(view_.grab().toImage().pixelColor(1, 100), light_theme().accent);
  QFocusEvent out(QEvent::FocusOut, Qt::TabFocusReason);
  QGuiApplication::sendEvent(&view_, &out);
  EXPECT_NE(view_.grab().toImage().pixelColor(1, 100), light_theme().accent);
}

TEST_F(SceneViewTest, KeepsImpactsOfTheLastMoments) {
  auto frame = std::make_shared<Frame>(*frame_of(Simulation(setup_of(two_discs()))));
  frame->time = 1.0;
  ImpactRecord impact;
  impact.time = 0.9;
  impact.a = 1_b;
  impact.b = 2_b;
  impact.normal_impulse = 1.0;
  impact.point = Vec2(2.0, 1.0);
  frame->impacts = {impact};
  view_.set_frame(frame);
  EXPECT_EQ(view_.drawing().segments.size(), 1U);
  auto later = std::make_shared<Frame>(*frame);
  later->impacts.clear();
  later->time = 1.1;
  view_.set_frame(later);
  EXPECT_EQ(view_.drawing().segments.size(), 1U);
  // An edit before the impact was undone or redone.
  auto replayed = std::make_shared<Frame>(*later);
  replayed->back_to = 0.8;
  view_.set_frame(replayed);
  EXPECT_TRUE(view_.drawing().segments.empty());
  view_.set_frame(frame);
  EXPECT_EQ(view_.drawing().segments.size(), 1U);
  auto restarted = std::make_shared<Frame>(*later);
  restarted->run += 1;
  view_.set_frame(restarted);
  EXPECT_TRUE(view_.drawing().segments.empty());
}

TEST_F(SceneViewTest, OpenGlPaintsLikeQPainter) {
  if (QGuiApplication::platformName() != "xcb") GTEST_SKIP() << "needs OpenGL: run under X with xcb";
  ASSERT_TRUE(view_.uses_opengl());
  qputenv("CAROM_PAINTER", "qpainter");
  SceneView twin(light_theme());
  qunsetenv("CAROM_PAINTER");
  EXPECT_FALSE(twin.uses_opengl());
  open(twin);
  const QImage gl = view_.grab().toImage();
  const QImage painter = twin.grab().toImage();
  ASSERT_EQ(gl.size(), painter.size());
  // Disc, its orientation line, velocity arrow, floor, its outline, grid, ground.
  for (const QPoint at : {QPoint(180, 210), QPoint(230, 200), QPoint(200, 180), QPoint(300, 311),
                          QPoint(300, 300), QPoint(300, 50), QPoint(311, 53)}) {
    const QColor a = gl.pixelColor(at);
    const QColor b = painter.pixelColor(at);
    EXPECT_NEAR(a.red(), b.red(), 12) << at.x() << "," << at.y();
    EXPECT_NEAR(a.green(), b.green(), 12) << at.x() << "," << at.y();
    EXPECT_NEAR(a.blue(), b.blue(), 12) << at.x() << "," << at.y();
  }
  // The scale bar is drawn with the text.
  EXPECT_LT(painter.pixelColor(60, 384).lightness(), 180);
  EXPECT_LT(gl.pixelColor(60, 384).lightness(), 180);
}

}  // namespace
}  // namespace carom
