#include <QLabel>

#include "tests/app/lab/hands_fixture.h"
#include "widgets/scene/loupe.h"
#include "widgets/scene/overlap.h"

// Tools in hand, what they leave selected, and the keys of what is shown.
namespace carom {
namespace {

class LabToolsTest : public LabHandsTest {
 protected:
  void SetUp() override {
    ASSERT_NO_FATAL_FAILURE(LabHandsTest::SetUp());
    action("New")->trigger();
    ASSERT_TRUE(wait_for([this] { return window_.frame() && window_.frame()->bodies->empty(); }));
  }
  [[nodiscard]] QString hint() {
    for (const QLabel* label : window_.scene_view().findChildren<QLabel*>("note")) {
      if (label->accessibleName() == "What the mouse does" && label->isVisible()) return label->text();
    }
    return {};
  }
  [[nodiscard]] QString inspector_refusal() {
    for (const QLabel* label : window_.findChild<Inspector*>()->findChildren<QLabel*>("fault")) {
      if (label->isVisible()) return label->text();
    }
    return {};
  }
  using Names = std::vector<std::string>;
  [[nodiscard]] const Names& selection() { return window_.scene_view().selection(); }
};

TEST_F(LabToolsTest, AnEmptyFirstStartSaysHowTheBodiesComeBack) {
  draw_two_discs();
  key(Qt::Key_R, Qt::ControlModifier);
  ASSERT_TRUE(wait_for([this] { return window_.frame()->bodies->empty(); }));
  const auto labels = window_.scene_view().findChildren<QLabel*>();
  EXPECT_TRUE(std::any_of(labels.begin(), labels.end(), [](const QLabel* label) {
    return label->isVisible() && label->text().contains("first start is empty");
  }));
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_TRUE(wait_for([this] { return window_.frame()->bodies->size() == 2; }));
}

TEST_F(LabToolsTest, AKeptToolLooksDifferentAndSaysSo) {
  key(Qt::Key_B);
  EXPECT_TRUE(hint().startsWith("Box, once · click: a square")) << hint().toStdString();
  EXPECT_FALSE(button("Box")->property("kept").toBool());
  key(Qt::Key_B);
  EXPECT_TRUE(hint().startsWith("Box, kept: Esc ends it")) << hint().toStdString();
  EXPECT_TRUE(button("Box")->property("kept").toBool());
  EXPECT_TRUE(button("Box")->toolTip().contains("Kept"));
  EXPECT_EQ(button("Box")->accessibleDescription(), "kept until Escape");
  drag({0.2, 0.2}, {0.6, 0.6});
  ASSERT_TRUE(wait_for([this] { return window_.frame()->bodies->size() == 1; }));
  EXPECT_TRUE(button("Box")->property("kept").toBool());
  EXPECT_EQ(selection(), Names{}) << "the tool is kept for more of them";
  key(Qt::Key_Escape);
  EXPECT_FALSE(hint().startsWith("Box"));
  EXPECT_FALSE(button("Box")->property("kept").toBool());
  EXPECT_FALSE(button("Box")->toolTip().contains("Kept"));
  EXPECT_EQ(button("Box")->accessibleDescription(), "");
}

TEST_F(LabToolsTest, TheLineAtTheTopSaysWhatTheMouseCanDo) {
  const auto hover = [this](const Vec2& at) {
    QTest::mouseMove(&window_.scene_view(), window_.scene_view().camera().to_screen(at).toPoint());
  };
  key(Qt::Key_D);
  drag({-1.0, 0.0}, {-0.8, 0.0});
  ASSERT_TRUE(wait_for([this] { return selection() == Names{"A"} && window_.frame()->scene; }));
  hover({-1.0, 0.05});
  EXPECT_TRUE(hint().startsWith("drag: move")) << hint().toStdString();
  hover({0.5, 0.5});
  EXPECT_TRUE(hint().startsWith("drag: select bodies")) << hint().toStdString();
  key(Qt::Key_D);
  hover({-1.0, 0.05});
  EXPECT_TRUE(hint().startsWith("drag: move")) << hint().toStdString();
  hover({0.5, 0.5});
  EXPECT_TRUE(hint().startsWith("Disc, once")) << hint().toStdString();
  key(Qt::Key_Escape);
  key(Qt::Key_Space);
  ASSERT_TRUE(wait_for([this] { return window_.frame()->playing && window_.frame()->time > 0.0; }));
  hover({-1.0, 0.06});
  EXPECT_TRUE(hint().startsWith("click: select")) << hint().toStdString();
  key(Qt::Key_Space);
}

TEST_F(LabToolsTest, ADraggedDiscFallsIntoTheRun) {
  key(Qt::Key_D);
  drag({-1.0, 0.0}, {-0.8, 0.0});
  ASSERT_TRUE(wait_for([this] { return selection() == Names{"A"} && window_.frame()->scene; }));
  key(Qt::Key_Space);
  ASSERT_TRUE(wait_for([this] { return window_.frame()->playing && window_.frame()->time > 0.0; }));
  key(Qt::Key_D);
  drag({1.0, 0.0}, {1.0, 0.3});
  ASSERT_TRUE(wait_for([this] { return window_.frame()->bodies->size() == 2; }));
  EXPECT_TRUE(window_.frame()->playing);
  EXPECT_GT(window_.frame()->time, 0.0);
  ASSERT_EQ(window_.preset().edits.size(), 1U) << "it comes in during the run";
  const Body& disc = added_body(window_.preset().edits[0]);
  EXPECT_NEAR(std::get<Disc>(disc.shape).radius, 0.3, 0.02);
  EXPECT_NEAR(disc.position.x(), 1.0, 0.02);
  key(Qt::Key_Space);
}

TEST_F(LabToolsTest, ANewBodyIsSelected) {
  key(Qt::Key_D);
  drag({-1.0, 0.0}, {-0.8, 0.0});
  EXPECT_TRUE(wait_for([this] { return selection() == Names{"A"}; }));
  EXPECT_TRUE(window_.scene_view().bubble().value.startsWith("r ")) << "its size is still said";
  click_scene({0.0, 0.5});  // of random radius
  EXPECT_TRUE(wait_for([this] { return selection() == Names{"B"}; }));
  key(Qt::Key_W);
  drag({0.5, -0.5}, {1.0, -0.5});
  EXPECT_TRUE(wait_for([this] { return selection() == Names{"C"}; }));
  key(Qt::Key_P);
  for (const Vec2& corner : {Vec2(0.4, 0.0), Vec2(0.8, 0.0), Vec2(0.6, 0.3)}) select(corner);
  key(Qt::Key_Return);
  EXPECT_TRUE(wait_for([this] { return selection() == Names{"D"}; }));
}

TEST_F(LabToolsTest, ShiftAndALetterShowsAndHides) {
  const auto switches = [this](int letter, bool DrawingOptions::*flag) {
    const bool before = window_.scene_view().options().*flag;
    key(letter, Qt::ShiftModifier);
    EXPECT_NE(window_.scene_view().options().*flag, before) << static_cast<char>(letter);
    key(letter, Qt::ShiftModifier);
    EXPECT_EQ(window_.scene_view().options().*flag, before) << static_cast<char>(letter);
  };
  switches(Qt::Key_G, &DrawingOptions::grid);
  switches(Qt::Key_V, &DrawingOptions::velocities);
  switches(Qt::Key_F, &DrawingOptions::forces);
  switches(Qt::Key_K, &DrawingOptions::contacts);
  switches(Qt::Key_J, &DrawingOptions::jumps);
  switches(Qt::Key_N, &DrawingOptions::names);
}

TEST_F(LabToolsTest, EnterDrawsBesideWhatIsThere) {
  std::size_t drawn = 0;
  for (const int tool : {Qt::Key_D, Qt::Key_D, Qt::Key_B, Qt::Key_P, Qt::Key_D, Qt::Key_B}) {
    key(tool);
    key(Qt::Key_Return);
    ASSERT_TRUE(wait_for([&] { return window_.frame()->bodies->size() == drawn + 1; }));
    const std::vector<Body>& bodies = window_.preset().scene.bodies;
    const Surroundings others{{bodies.begin(), bodies.end() - 1}, {}};
    EXPECT_TRUE(overlaps_of({&bodies.back(), 1}, others).empty()) << bodies.back().name;
    ++drawn;
  }
}

// Two discs of 0.1 m with a gap of half a pixel between them.
TEST_F(LabToolsTest, YHoldsALoupe) {
  draw_two_discs();
  SceneView& view = window_.scene_view();
  const double gap = 0.5 / view.camera().scale;
  view.select({"B"});
  type("Radius, m", "0.1");
  type("Position x, m", QString::number(-0.8 + gap, 'g', 17));
  ASSERT_TRUE(wait_for([&] { return std::abs(now("B").position.x() + 0.8 - gap) < 1e-9; }));
  const auto* loupe = view.findChild<Loupe*>();
  ASSERT_NE(loupe, nullptr);
  EXPECT_FALSE(loupe->isVisible());
  view.select({});
  QCursor::setPos(view.mapToGlobal(pixel({-0.9, 0.0})));
  QTest::keyPress(&view, Qt::Key_Y);
  ASSERT_TRUE(loupe->isVisible());
  EXPECT_DOUBLE_EQ(loupe->camera().scale, 5.0 * view.camera().scale);
  EXPECT_NEAR(loupe->camera().center.x(), -0.9, 1.0 / view.camera().scale);
  // It shows nothing but what the camera sees there, at the moment that is shown.
  const QPointF touch = loupe->camera().to_screen({-0.9 + 0.5 * gap, 0.0});
  const QImage picture = const_cast<Loupe*>(loupe)->grab().toImage();
  EXPECT_TRUE(QRect({}, picture.size()).contains(touch.toPoint()));
  EXPECT_NE(picture.pixelColor(touch.toPoint()), picture.pixelColor((touch - QPointF(40.0, 0.0)).toPoint()));
  QTest::keyRelease(&view, Qt::Key_Y);
  EXPECT_FALSE(loupe->isVisible());
  action("Loupe at the mouse\tY")->trigger();
  EXPECT_TRUE(loupe->isVisible());
  action("Loupe at the mouse\tY")->trigger();
  EXPECT_FALSE(loupe->isVisible());
}

TEST_F(LabToolsTest, QSwitchesSnapping) {
  draw_two_discs();
  const double px = 1.0 / window_.scene_view().camera().scale;
  const auto moved_by = [&](const Vec2& to) {
    const Vec2 from = now("A").position;
    const Camera& camera = window_.scene_view().camera();
    const Vec2 way = camera.to_world(pixel(to)) - camera.to_world(pixel(from));
    drag(from, to);
    EXPECT_TRUE(wait_for([&] { return now("A").position != from; }) && shows_start());
    return Vec2(now("A").position - from - way);
  };
  EXPECT_GT(moved_by({-1.0 + 5.0 * px, 0.5 + 5.0 * px}).norm(), px) << "to the grid";
  key(Qt::Key_Q);
  EXPECT_LT(moved_by({-1.0 + 10.0 * px, 0.4}).norm(), 1e-12);
  EXPECT_TRUE(hint().startsWith("no snapping (Q)")) << hint().toStdString();
  const Vec2 before = now("A").position;
  key(Qt::Key_Right);
  ASSERT_TRUE(wait_for([&] { return now("A").position != before; }));
  const double step = now("A").position.x() - before.x();
  EXPECT_LE(step, px * (1.0 + 1e-9));
  EXPECT_GT(step, 0.4 * px);
  key(Qt::Key_Q);
  EXPECT_FALSE(hint().contains("no snapping (Q)")) << hint().toStdString();
  EXPECT_GT(moved_by({-1.0 + 5.0 * px, 0.5 + 5.0 * px}).norm(), px);
}

// What the scene can't be is said where the mouse is, and nowhere else.
TEST_F(LabToolsTest, ARefusedDriveIsSaidInTheBubble) {
  key(Qt::Key_D);
  drag({0.0, 0.0}, {0.2, 0.0});
  ASSERT_TRUE(wait_for([this] { return window_.frame()->bodies->size() == 1; }));
  ASSERT_TRUE(shows_start());
  key(Qt::Key_N);
  select({0.0, 0.0});
  ASSERT_EQ(window_.preset().scene.joints.size(), 1U);
  ASSERT_TRUE(shows_start());
  const int steps = window_.session().edits().count();
  key(Qt::Key_M);
  drag({0.0, 0.0}, {0.6, 0.0});
  const Bubble& bubble = window_.scene_view().bubble();
  EXPECT_TRUE(bubble.fault);
  EXPECT_EQ(bubble.value, "Pin 1 acts on A, which would no longer move freely.");
  EXPECT_EQ(bubble.detail, "Remove Pin 1 first.");
  EXPECT_EQ(window_.session().edits().count(), steps);
  EXPECT_EQ(inspector_refusal(), "");
  // What the inspector refuses is said there, until the run plays.
  window_.scene_view().select({"A"});
  type("Velocity x, m/s", "1");
  EXPECT_EQ(inspector_refusal(),
            "Pin 1 joins A and the plane: their ends would part at 1 m/s. Give a velocity that it allows, or "
            "remove it.");
  action("Play or pause")->trigger();
  EXPECT_EQ(inspector_refusal(), "");
}

}  // namespace
}  // namespace carom
