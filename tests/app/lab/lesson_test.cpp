#include <cmath>

#include "tests/app/lab/lesson_fixture.h"
#include "widgets/edit/bodies_model.h"

// The first lesson in the real window, by hand and by keyboard: every step with real events, and what is seen
// after each.
namespace carom {
namespace {

TEST_F(LessonTest, ByHand) {
  // 1. A new scene, and two discs drawn in it.
  begin_new();
  press(Qt::Key_D);
  pull({-1.0, 0.0}, {-0.9, 0.0});
  ASSERT_TRUE(has(1));
  EXPECT_EQ(undo_text(), "Add disc A");
  press(Qt::Key_D);
  pull({1.0, 0.0}, {1.15, 0.0});
  ASSERT_TRUE(has(2));
  EXPECT_NEAR(std::get<Disc>(body(0).shape).radius, 0.10, 1e-12);
  EXPECT_NEAR(std::get<Disc>(body(1).shape).radius, 0.15, 1e-12);
  EXPECT_EQ(bubble(), "r 0.15 m");
  EXPECT_TRUE(names_in_scene().contains("A"));
  EXPECT_TRUE(names_in_scene().contains("B"));
  EXPECT_EQ(cell(0, BodiesModel::kBody), "A");

  // 2. The velocity is pulled, and typed.
  click({-1.0, 0.0});
  const Vec2 stub = grip(HandleKind::kVelocity);
  hold(stub, stub + Vec2(0.4, 0.0));
  ASSERT_TRUE(wait_for([this] { return body(0).velocity.x() > 0.0; }));
  EXPECT_TRUE(bubble().contains("m/s at 0°")) << bubble().toStdString();
  EXPECT_EQ(overlay().ghosts.size(), 1U);
  let_go(stub + Vec2(0.4, 0.0));
  EXPECT_TRUE(undo_text().startsWith("Speed of A")) << undo_text().toStdString();
  ASSERT_TRUE(shows_start());
  click_field("Speed, m/s");
  write("2 m/s");
  ASSERT_TRUE(shows_start());
  EXPECT_EQ(body(0).velocity, Vec2(2.0, 0.0));
  EXPECT_EQ(field("Velocity x, m/s")->text(), "2");
  EXPECT_TRUE(wait_for([this] { return cell(0, BodiesModel::kVelocityX) == "2.000"; }))
      << cell(0, BodiesModel::kVelocityX).toStdString();

  // 3. Masses, down the column.
  click_cell(0, BodiesModel::kMass);
  write("1");
  write("2.5");
  ASSERT_TRUE(shows_start());
  EXPECT_DOUBLE_EQ(mass_of(body(0)), 1.0);
  EXPECT_EQ(body(1).mass, 2.5);
  EXPECT_TRUE(undo_text().startsWith("Mass of B")) << undo_text().toStdString();

  // 4. A body dragged onto another touches it; the step is taken back.
  const Vec2 a = body(0).position;
  const Vec2 b = body(1).position;
  hold(a, b + Vec2(-0.1, 0.05));
  ASSERT_TRUE(wait_for([&] { return body(0).position != a; }));
  EXPECT_FALSE(overlay().overlaps.empty());
  EXPECT_TRUE((bubble() + overlay().bubble.detail).contains("overlap by")) << bubble().toStdString();
  let_go(b + Vec2(-0.1, 0.05));
  ASSERT_TRUE(shows_start());
  EXPECT_NEAR((body(0).position - b).norm(), 0.25, 1e-9);
  EXPECT_EQ(undo_text(), "Move A");
  press(Qt::Key_Z, Qt::ControlModifier);
  ASSERT_TRUE(shows_start());
  EXPECT_EQ(body(0).position, a);

  // 5. A rod to a place above: the body swings on it; with Ctrl it lengthens.
  const Vec2 above = a + Vec2(0.0, 0.8);
  press(Qt::Key_O);
  pull(a, above);
  ASSERT_TRUE(wait_for([this] { return window_.frame()->joints.size() == 1; }));
  EXPECT_EQ(undo_text(), "Add rod from A to the plane");
  const Vec2 hook = window_.preset().scene.joints[0].anchor;
  EXPECT_TRUE(hook.isApprox(above, 0.02)) << hook.transpose();
  const double length = (a - hook).norm();
  ASSERT_TRUE(shows_start());
  pull(a, a + Vec2(0.4, 0.1));
  ASSERT_TRUE(shows_start());
  EXPECT_NEAR((body(0).position - hook).norm(), length, 1e-9);
  EXPECT_GT(body(0).position.x(), a.x() + 0.2);
  EXPECT_NEAR(body(0).velocity.dot(body(0).position - hook), 0.0, 1e-9);
  const Vec2 swung = body(0).position;
  pull(swung, swung + Vec2(0.1, -0.2), Qt::ControlModifier);
  ASSERT_TRUE(shows_start());
  EXPECT_GT((body(0).position - hook).norm(), length + 0.1);
  EXPECT_NEAR((body(0).position - swung - Vec2(0.1, -0.2)).norm(), 0.0, 0.01);

  // 6. What can't be is said, and the last good value holds.
  click_field("e of default");
  write("1.2");
  EXPECT_EQ(sentence(), "e lies between 0 and 1.");
  EXPECT_TRUE(field("e of default")->property("fault").toBool());
  const QString before = undo_text();
  field("e of default")->selectAll();
  write("0.6");
  EXPECT_NE(undo_text(), before);
  EXPECT_TRUE(undo_text().startsWith("e of default")) << undo_text().toStdString();
  EXPECT_EQ(sentence(), "");
  EXPECT_EQ(material_named(window_.preset().scene, "default").restitution, 0.6);
  ASSERT_TRUE(shows_start());

  // 7. Both are doubled and moved, in two steps, and deleted.
  window_.scene_view().setFocus();
  press(Qt::Key_A, Qt::ControlModifier);
  press(Qt::Key_D, Qt::ControlModifier);
  ASSERT_TRUE(has(4));
  EXPECT_TRUE(undo_text().startsWith("Duplicate 2 bodies")) << undo_text().toStdString();
  ASSERT_TRUE(wait_for([this] { return window_.scene_view().selection() == new_ones(); }));
  const int steps = window_.session().edits().count();
  const double height = body(3).position.y();
  for (int i = 0; i < 10; ++i) press(Qt::Key_Up);
  ASSERT_TRUE(shows_start());
  EXPECT_GT(body(3).position.y(), height + 0.1);
  EXPECT_EQ(window_.session().edits().count(), steps + 1);
  EXPECT_EQ(undo_text(), "Move 2 bodies");
  press(Qt::Key_Delete);
  ASSERT_TRUE(has(2));

  // 8.
  ASSERT_NO_FATAL_FAILURE(take_all_back_and_save());
}

TEST_F(LessonTest, ByKeyboardAlone) {
  // 1. A new scene; discs appear in its middle, and get their sizes and places as numbers.
  begin_new();
  press(Qt::Key_D);
  press(Qt::Key_Return);
  ASSERT_TRUE(has(1));
  const auto selected = [this](const char* name) {
    return wait_for([&] { return window_.scene_view().selection() == std::vector<std::string>{name}; });
  };
  ASSERT_TRUE(selected("A")) << "a new body is selected";
  // A step of the grid is 10 or 20 cm, by the room that the scene has.
  for (int i = 0; i < 4 && body(0).position.x() > -0.35; ++i) press(Qt::Key_Left);
  ASSERT_TRUE(shows_start());
  EXPECT_NEAR(body(0).position.x(), -0.4, 1e-9);
  EXPECT_EQ(undo_text(), "Move A");
  tab_to(field("Radius, m"));
  write("10 cm");
  ASSERT_TRUE(shows_start());
  EXPECT_EQ(std::get<Disc>(body(0).shape).radius, 0.1);
  tab_to(&window_.scene_view());
  press(Qt::Key_D);
  press(Qt::Key_Return);
  ASSERT_TRUE(has(2));
  EXPECT_EQ(body(1).name, "B");

  // 2. The velocity by keys: the bubble and the inspector follow.
  ASSERT_TRUE(selected("B"));
  press(Qt::Key_Tab, Qt::ShiftModifier);
  ASSERT_TRUE(selected("A"));
  press(Qt::Key_Right, Qt::ControlModifier | Qt::ShiftModifier);
  press(Qt::Key_Right, Qt::ControlModifier | Qt::ShiftModifier);
  ASSERT_TRUE(shows_start());
  EXPECT_NEAR(body(0).velocity.x(), 2.0, 1e-12);
  EXPECT_TRUE(bubble().startsWith("2.0")) << bubble().toStdString();
  EXPECT_EQ(field("Velocity x, m/s")->text(), "2");
  EXPECT_TRUE(undo_text().startsWith("Speed of A 0.00 → 2.00")) << undo_text().toStdString();

  // 3. Masses, down the column of the table.
  tab_to(&table());
  for (int i = 0; i < 10; ++i) press(Qt::Key_Up);
  for (int i = 0; i < 10; ++i) press(Qt::Key_Left);
  press(Qt::Key_Right);
  write("1");
  write("2.5");
  ASSERT_TRUE(shows_start());
  EXPECT_DOUBLE_EQ(mass_of(body(0)), 1.0);
  EXPECT_EQ(body(1).mass, 2.5);

  // 4. Put in touch, and taken back.
  const Vec2 apart = body(0).position;
  while (QApplication::focusWidget() != &window_.scene_view()) press(Qt::Key_Tab);
  press(Qt::Key_A, Qt::ControlModifier);
  press(Qt::Key_K);
  ASSERT_TRUE(shows_start());
  EXPECT_EQ(undo_text(), "Put A in touch with B");
  const double radii = 0.1 + std::get<Disc>(body(1).shape).radius;
  EXPECT_NEAR((body(0).position - body(1).position).norm(), radii, 1e-9);
  press(Qt::Key_Z, Qt::ControlModifier);
  ASSERT_TRUE(shows_start());
  EXPECT_EQ(body(0).position, apart);

  // 5. A rod between both; an arrow turns A about B. The length is typed.
  press(Qt::Key_0);  // at rest
  ASSERT_TRUE(shows_start());
  press(Qt::Key_O);
  press(Qt::Key_Return);
  ASSERT_TRUE(wait_for([this] { return window_.frame()->joints.size() == 1; }));
  EXPECT_EQ(undo_text(), "Add rod from A to B");
  press(Qt::Key_Escape);
  press(Qt::Key_Tab);
  ASSERT_EQ(window_.scene_view().selection(), std::vector<std::string>{"A"});
  const double length = (body(0).position - body(1).position).norm();
  for (int i = 0; i < 2; ++i) press(Qt::Key_Up);
  ASSERT_TRUE(shows_start());
  EXPECT_GT(body(0).position.y(), apart.y() + 0.1);
  EXPECT_NEAR((body(0).position - body(1).position).norm(), length, 1e-9);

  // 6. What can't be is said, and the last good value holds.
  tab_to(field("e of default"));
  write("1.2");
  EXPECT_EQ(sentence(), "e lies between 0 and 1.");
  press(Qt::Key_Escape);
  EXPECT_EQ(field("e of default")->text(), "1");
  write("0.6");
  EXPECT_TRUE(undo_text().startsWith("e of default")) << undo_text().toStdString();

  // 7. Both are doubled and moved, in two steps, and deleted.
  tab_to(&window_.scene_view());
  press(Qt::Key_A, Qt::ControlModifier);
  press(Qt::Key_D, Qt::ControlModifier);
  ASSERT_TRUE(has(4));
  ASSERT_TRUE(wait_for([this] { return window_.scene_view().selection() == new_ones(); }));
  const int steps = window_.session().edits().count();
  for (int i = 0; i < 10; ++i) press(Qt::Key_Up);
  ASSERT_TRUE(shows_start());
  EXPECT_EQ(window_.session().edits().count(), steps + 1);
  press(Qt::Key_Delete);
  ASSERT_TRUE(has(2));

  // 8.
  ASSERT_NO_FATAL_FAILURE(take_all_back_and_save());
}

// How many actions "two carts, e = 1, then 0.5, then 0" takes.
TEST_F(LessonTest, TwoCartsFromNewTakeAtMostTwelveActions) {
  begin_new();
  press(Qt::Key_D);
  pull({-1.0, 0.0}, {-0.9, 0.0});
  ASSERT_TRUE(has(1));
  press(Qt::Key_D);
  pull({0.0, 0.0}, {0.1, 0.0});
  ASSERT_TRUE(has(2));
  click({-1.0, 0.0});
  press(Qt::Key_Right, Qt::ControlModifier | Qt::ShiftModifier);
  ASSERT_TRUE(shows_start());
  EXPECT_EQ(body(0).velocity, Vec2(1.0, 0.0));
  choose_speed(20.0);  // the wait is no action
  play_to_the_end(10.0);
  EXPECT_NEAR(speed("B") - speed("A"), 1.0, 1e-9);
  slide("e of default", 0.5);
  play_to_the_end(10.0);
  EXPECT_NEAR(speed("B") - speed("A"), 0.5, 1e-9);
  slide("e of default", 0.0);
  play_to_the_end(10.0);
  EXPECT_NEAR(speed("B") - speed("A"), 0.0, 1e-9);
  EXPECT_LE(actions_, 12);
}

TEST_F(LessonTest, TwoCartsOfAnExperimentTakeAtMostFiveActions) {
  ASSERT_TRUE(window_.open("head-on-equal"));
  ASSERT_TRUE(shows_start());
  window_.scene_view().setFocus();
  actions_ = 0;
  play_to_the_end(1.0);
  EXPECT_NEAR(speed("right") - speed("left"), 3.0, 1e-9);
  slide("e of steel", 0.5);
  play_to_the_end(1.0);
  EXPECT_NEAR(speed("right") - speed("left"), 1.5, 1e-9);
  slide("e of steel", 0.0);
  play_to_the_end(1.0);
  EXPECT_NEAR(speed("right") - speed("left"), 0.0, 1e-9);
  EXPECT_LE(actions_, 5);
}

}  // namespace
}  // namespace carom
