#include <QClipboard>
#include <cmath>

#include "physics/preset/preset_file.h"
#include "tests/app/lab/hands_fixture.h"
#include "widgets/plot/run_plot.h"

// A lesson by hand: bodies are made, moved, typed, thrown and taken back in the real window.
namespace carom {
namespace {

TEST_F(LabHandsTest, ALessonByHand) {
  ASSERT_NO_FATAL_FAILURE(draw_two_discs());
  EXPECT_NEAR(std::get<Disc>(window_.preset().scene.bodies[0].shape).radius, 0.1, 0.011);
  EXPECT_NEAR(std::get<Disc>(window_.preset().scene.bodies[1].shape).radius, 0.2, 0.011);
  // Numbers typed: a mass, a velocity.
  const std::string a = window_.preset().scene.bodies[0].name;
  const std::string b = window_.preset().scene.bodies[1].name;
  select({-1.0, 0.0});
  EXPECT_DOUBLE_EQ(mass_of(window_.preset().scene.bodies[0]), 1.0) << "the first one is round";
  type("Velocity x, m/s", "7.2 km/h");
  ASSERT_TRUE(shows_start());
  select({1.0, 0.0});
  type("Mass, kg", "3000 g");
  ASSERT_TRUE(shows_start());
  EXPECT_EQ(window_.preset().scene.bodies[0].velocity.x(), 2.0);
  EXPECT_EQ(*window_.preset().scene.bodies[1].mass, 3.0);
  // e = 1 by default: after the impact -1 and 1 m/s.
  window_.run_until(1.5);
  EXPECT_NEAR(now(a).velocity.x(), -1.0, 1e-9);
  EXPECT_NEAR(now(b).velocity.x(), 1.0, 1e-9);
  // In mid-run the mass of B: the run goes on. Then B is moved: a new start from there.
  select(now(b).position);
  type("Mass, kg", "*2");
  ASSERT_TRUE(wait_for([&] { return now(b).mass == 6.0; }));
  EXPECT_NEAR(time(), 1.5, 0.01);
  const Vec2 from = now(b).position;
  drag(from, from + Vec2(0.0, 0.5));
  ASSERT_TRUE(wait_for([&] { return time() == 0.0 && std::abs(now(b).position.y() - 0.5) < 0.06; }));
  EXPECT_NEAR(now(a).velocity.x(), -1.0, 1e-9) << "moves as it did";
  // All of it is taken back, and made again.
  QUndoStack& edits = window_.session().edits();
  EXPECT_TRUE(edits.undoText().contains(": Move")) << edits.undoText().toStdString();
  const int steps = edits.count();
  EXPECT_EQ(steps, 6);
  const std::string last = write_preset(window_.preset());
  for (int i = 0; i < steps; ++i) edits.undo();
  ASSERT_TRUE(wait_for([this] { return window_.frame() && window_.frame()->bodies->empty(); }));
  for (int i = 0; i < steps; ++i) edits.redo();
  EXPECT_EQ(write_preset(window_.preset()), last);
  ASSERT_TRUE(shows_start());
}

// After Enter a letter is a key again and no text.
TEST_F(LabHandsTest, EnterInTheInspectorGivesTheKeysBackToTheScene) {
  ASSERT_NO_FATAL_FAILURE(draw_two_discs());
  select({-1.0, 0.0});
  for (const QString field : {"Mass, kg", "e of default", "Velocity x, m/s"}) {
    QLineEdit* edit = nullptr;
    for (QLineEdit* each : window_.findChild<Inspector*>()->findChildren<QLineEdit*>()) {
      if (each->accessibleName() == field) edit = each;
    }
    ASSERT_NE(edit, nullptr) << field.toStdString();
    edit->setFocus();
    edit->selectAll();
    QTest::keyClicks(edit, "0.5");
    QTest::keyClick(edit, Qt::Key_Return);
    EXPECT_EQ(QApplication::focusWidget(), &window_.scene_view()) << field.toStdString();
  }
  EXPECT_EQ(*window_.preset().scene.bodies[0].mass, 0.5);
  window_.run_until(0.2);
  QTest::keyClick(QApplication::focusWidget(), Qt::Key_R);
  EXPECT_TRUE(wait_for([this] { return time() == 0.0; }));
  EXPECT_EQ(*window_.preset().scene.bodies[0].mass, 0.5);
}

// What can't be taken is still to be mended.
TEST_F(LabHandsTest, EnterOnAWrongValueKeepsTheKeys) {
  ASSERT_NO_FATAL_FAILURE(draw_two_discs());
  select({-1.0, 0.0});
  for (QLineEdit* edit : window_.findChild<Inspector*>()->findChildren<QLineEdit*>()) {
    if (edit->accessibleName() != "Mass, kg") continue;
    edit->setFocus();
    edit->selectAll();
    QTest::keyClicks(edit, "2 m");
    QTest::keyClick(edit, Qt::Key_Return);
    EXPECT_EQ(QApplication::focusWidget(), edit);
  }
}

TEST_F(LabHandsTest, FieldsThatADragChangesHaveARingUntilRelease) {
  ASSERT_NO_FATAL_FAILURE(draw_two_discs());
  const auto ringed = [this] {
    QStringList names;
    for (QLineEdit* edit : window_.findChild<Inspector*>()->findChildren<QLineEdit*>()) {
      if (edit->property("changes").toBool()) names << edit->accessibleName();
    }
    return names;
  };
  SceneView& view = window_.scene_view();
  const QPoint from = pixel({-1.0, 0.0});  // B is selected, A comes to be
  QTest::mousePress(&view, Qt::LeftButton, {}, from);
  for (const QPoint& at : {from + QPoint(0, 10), from + QPoint(0, 40)}) {
    QMouseEvent move(QEvent::MouseMove, at, view.mapToGlobal(at), Qt::NoButton, Qt::LeftButton, {});
    QApplication::sendEvent(&view, &move);
  }
  EXPECT_TRUE(wait_for([&] { return ringed() == QStringList{"Position y, m"}; }))
      << ringed().join(';').toStdString();
  QTest::mouseRelease(&view, Qt::LeftButton, {}, from + QPoint(0, 40));
  EXPECT_EQ(ringed(), QStringList{});
}

TEST_F(LabHandsTest, DrawnBodiesAreTakenBackMadeAgainAndSaved) {
  action("New")->trigger();
  ASSERT_TRUE(wait_for([this] { return window_.frame() && window_.frame()->bodies->empty(); }));
  const auto has = [this](std::size_t count) {
    return wait_for([=, this] { return window_.frame()->bodies->size() == count; });
  };
  key(Qt::Key_B);
  EXPECT_TRUE(button("Box")->isChecked());
  drag({-1.0, 0.2}, {-0.6, 0.4});
  ASSERT_TRUE(has(1));
  EXPECT_TRUE(button("Select")->isChecked());
  click_button("Polygon");
  for (const Vec2& corner : {Vec2(0.2, 0.2), Vec2(0.8, 0.2), Vec2(0.4, 0.6)}) select(corner);
  key(Qt::Key_Return);
  ASSERT_TRUE(has(2));
  // The key pressed twice keeps the tool.
  key(Qt::Key_W);
  key(Qt::Key_W);
  select({0.0, -0.4});
  ASSERT_TRUE(has(3));
  drag({1.0, -0.4}, {1.4, 0.4});
  ASSERT_TRUE(has(4));
  key(Qt::Key_Escape);
  ASSERT_TRUE(shows_start());
  const std::vector<Body> drawn = window_.preset().scene.bodies;
  EXPECT_TRUE(std::holds_alternative<Box>(drawn[0].shape));
  EXPECT_TRUE(drawn[1].position.isApprox(Vec2(1.4 / 3.0, 1.0 / 3.0), 1e-12));
  EXPECT_FALSE(std::get<Wall>(drawn[2].shape).length);
  EXPECT_NEAR(*std::get<Wall>(drawn[3].shape).length, std::hypot(0.4, 0.8), 1e-12);
  QUndoStack& edits = window_.session().edits();
  const std::string scene = write_preset(window_.preset());
  for (const char* name : {"Add wall D", "Add wall C", "Add polygon B", "Add box A"}) {
    EXPECT_EQ(edits.undoText(), name);
    undo();
  }
  EXPECT_FALSE(edits.canUndo());
  ASSERT_TRUE(has(0));
  while (edits.canRedo()) edits.redo();
  EXPECT_EQ(write_preset(window_.preset()), scene);
  ASSERT_TRUE(has(4));
  chosen_file_ = folder_.filePath("drawn.json");
  const std::string file = chosen_file_.toStdString();
  window_.save();
  ASSERT_TRUE(wait_for([this] { return !window_.session().modified(); }));
  ASSERT_TRUE(window_.open("head-on"));
  ASSERT_TRUE(window_.open(file));
  EXPECT_EQ(write_preset(window_.preset()), scene);
  ASSERT_TRUE(shows_start());
}

TEST_F(LabHandsTest, ADoubleClickOnItsButtonKeepsATool) {
  click_button("Box");
  drag({0.0, 0.4}, {0.2, 0.6});
  EXPECT_EQ(window_.scene_view().tool(), SceneTool::kSelect);
  click_button("Box");
  QTest::mouseDClick(button("Box"), Qt::LeftButton);
  QTest::mouseRelease(button("Box"), Qt::LeftButton);
  drag({0.4, 0.4}, {0.5, 0.6});
  EXPECT_EQ(window_.scene_view().tool(), SceneTool::kBox);
  key(Qt::Key_Escape);
  EXPECT_EQ(window_.scene_view().tool(), SceneTool::kSelect);
  EXPECT_EQ(window_.preset().scene.bodies.size(), 4U);
}

TEST_F(LabHandsTest, ABodyAtRestIsNotReversed) {
  draw_two_discs();
  select({-1.0, 0.0});
  const int steps = window_.session().edits().count();
  key(Qt::Key_X);
  key(Qt::Key_0);
  EXPECT_EQ(window_.session().edits().count(), steps);
}

TEST_F(LabHandsTest, ADrawnBodyPausesARunAndBeginsAnew) {
  window_.session().runs().set_playing(true);
  ASSERT_TRUE(wait_for([this] { return time() > 0.05 && window_.frame()->playing; }));
  key(Qt::Key_B);
  drag({0.0, 0.4}, {0.2, 0.6});
  ASSERT_TRUE(wait_for([this] { return window_.frame()->bodies->size() == 3 && time() == 0.0; }));
  EXPECT_FALSE(window_.frame()->playing);
  undo();
  ASSERT_TRUE(wait_for([this] { return window_.frame()->bodies->size() == 2; }));
}

TEST_F(LabHandsTest, ARodKeepsTwoDiscsApartUntilItIsDeleted) {
  action("New")->trigger();
  ASSERT_TRUE(wait_for([this] { return window_.frame() && window_.frame()->bodies->empty(); }));
  const auto has = [this](std::size_t bodies, std::size_t joints) {
    return wait_for([=, this] {
      return window_.frame()->bodies->size() == bodies && window_.frame()->joints.size() == joints;
    });
  };
  key(Qt::Key_D);
  drag({-0.8, 0.0}, {-0.6, 0.0});
  ASSERT_TRUE(has(1, 0));
  key(Qt::Key_D);
  drag({0.8, 0.0}, {1.0, 0.0});
  ASSERT_TRUE(has(2, 0));
  key(Qt::Key_Escape);
  select({-0.8, 0.0});
  key(Qt::Key_Up, Qt::ControlModifier | Qt::ShiftModifier);
  ASSERT_TRUE(shows_start());
  key(Qt::Key_O);
  EXPECT_TRUE(button("Rod")->isChecked());
  drag({-0.8, 0.0}, {0.8, 0.0});
  ASSERT_TRUE(has(2, 1));
  EXPECT_TRUE(button("Select")->isChecked());
  ASSERT_TRUE(shows_start());
  const auto distance = [this] { return (now("A").position - now("B").position).norm(); };
  const double length = distance();
  window_.run_until(1.0);
  EXPECT_NEAR(distance(), length, 1e-9);
  EXPECT_GT(std::abs(now("A").position.y() - now("B").position.y()), 0.1) << "they turn about each other";
  select(0.5 * (now("A").position + now("B").position));
  ASSERT_TRUE(window_.scene_view().part());
  EXPECT_TRUE(window_.scene_view().selection().empty());
  key(Qt::Key_Delete);
  ASSERT_TRUE(has(2, 0));
  EXPECT_FALSE(window_.scene_view().part());
  EXPECT_EQ(window_.session().edits().undoText(), "Delete Rod 1");
  undo();
  ASSERT_TRUE(has(2, 1));
}

// At the start and in a run: the scene follows while the button is down, and Escape brings back what was.
TEST_F(LabHandsTest, TheEndOfASpringIsDragged) {
  draw_two_discs();
  key(Qt::Key_S);
  drag({-1.0, 0.0}, {-1.0, 0.6});
  const auto anchor = [this] {
    const auto frame = window_.frame();
    const bool has = frame && frame->scene && !frame->scene->forces.springs.empty();
    return has ? frame->scene->forces.springs[0].anchor : Vec2(Vec2::Zero());
  };
  const auto is_at = [&](const Vec2& place) {
    return wait_for([&] { return (anchor() - place).norm() < 0.02; });
  };
  ASSERT_TRUE(is_at({-1.0, 0.6}));
  SceneView* view = &window_.scene_view();
  select({-1.0, 0.3});
  ASSERT_TRUE(view->part());
  hold({-1.0, 0.6}, {-0.6, 0.6});
  EXPECT_TRUE(is_at({-0.6, 0.6}));
  key(Qt::Key_Escape);
  QTest::mouseRelease(view, Qt::LeftButton, {}, pixel({-0.6, 0.6}));
  EXPECT_TRUE(is_at({-1.0, 0.6}));
  EXPECT_TRUE(window_.session().edits().undoText().startsWith("Add spring"));

  window_.run_until(0.5);
  ASSERT_TRUE(wait_for([this] { return window_.frame()->scene && window_.frame()->time > 0.4; }));
  const QString before = window_.session().edits().undoText();
  hold({-1.0, 0.6}, {-0.6, 0.6});
  EXPECT_TRUE(is_at({-0.6, 0.6}));
  key(Qt::Key_Escape);
  QTest::mouseRelease(view, Qt::LeftButton, {}, pixel({-0.6, 0.6}));
  EXPECT_TRUE(is_at({-1.0, 0.6}));
  EXPECT_TRUE(wait_for([this] { return window_.frame()->time > 0.4; }));
  EXPECT_EQ(window_.session().edits().undoText(), before);

  drag({-1.0, 0.6}, {-0.6, 0.6});
  EXPECT_TRUE(is_at({-0.6, 0.6}));
  EXPECT_TRUE(wait_for([this] { return window_.frame()->time == 0.0; }));
  EXPECT_TRUE(window_.session().edits().undoText().startsWith("New start from 0.5"))
      << "a joint's end is of motion";
  undo();
  EXPECT_TRUE(is_at({-1.0, 0.6}));
  EXPECT_TRUE(wait_for([this] { return window_.frame()->time > 0.4; }));
}

TEST_F(LabHandsTest, CopiesAndDeletes) {
  ASSERT_TRUE(window_.open("head-on"));
  ASSERT_TRUE(shows_start());
  const Vec2 light = now("light").position;
  select(light);
  key(Qt::Key_D, Qt::ControlModifier);
  ASSERT_TRUE(wait_for([this] { return window_.frame()->bodies->size() == 3; }));
  ASSERT_TRUE(
      wait_for([this] { return window_.scene_view().selection() == std::vector<std::string>{"light-1"}; }));
  EXPECT_EQ(now("light-1").velocity, now("light").velocity);
  action("Copy")->trigger();
  EXPECT_TRUE(QApplication::clipboard()->text().contains("carom-preset"));
  action("Paste")->trigger();
  ASSERT_TRUE(wait_for([this] { return window_.frame()->bodies->size() == 4; }));
  const Vec2 pasted = 1e3 * now("light-2").position;
  EXPECT_NEAR((pasted - Vec2(pasted.array().round())).norm(), 0.0, 1e-9)
      << "round, in mm: " << pasted.transpose();
  key(Qt::Key_Delete);
  ASSERT_TRUE(wait_for([this] { return window_.frame()->bodies->size() == 3; }));
  undo();
  ASSERT_TRUE(wait_for([this] { return window_.frame()->bodies->size() == 4; }));
  QApplication::clipboard()->setText("no preset");
  action("Paste")->trigger();
  EXPECT_EQ(window_.frame()->bodies->size(), 4U);
}

// Before a frame shows the copies, which are to be selected.
TEST_F(LabHandsTest, KeysWaitForTheCopiesThatTheyMove) {
  ASSERT_TRUE(window_.open("head-on"));
  ASSERT_TRUE(shows_start());
  const Vec2 light = now("light").position;
  select(light);
  key(Qt::Key_D, Qt::ControlModifier);
  for (int i = 0; i < 3; ++i) key(Qt::Key_Right);
  key(Qt::Key_0);
  ASSERT_TRUE(
      wait_for([this] { return window_.frame()->bodies->size() == 3 && now("light-1").velocity.isZero(); }));
  EXPECT_EQ(now("light").position, light);
  EXPECT_FALSE(now("light").velocity.isZero());
  EXPECT_EQ(window_.scene_view().selection(), std::vector<std::string>{"light-1"});
}

TEST_F(LabHandsTest, KeysThatWaitedForCopiesMoveNothingElse) {
  ASSERT_TRUE(window_.open("head-on"));
  ASSERT_TRUE(shows_start());
  select(now("light").position);
  const Vec2 heavy = now("heavy").position;
  key(Qt::Key_D, Qt::ControlModifier);
  key(Qt::Key_Right);
  key(Qt::Key_Delete);
  select(heavy);
  ASSERT_TRUE(wait_for([this] { return window_.frame()->bodies->size() == 3; }));
  QTest::qWait(100);
  EXPECT_EQ(now("heavy").position, heavy);
  EXPECT_EQ(window_.frame()->bodies->size(), 3U);
}

// The line to the first impact follows each edit of the start.
TEST_F(LabHandsTest, AnEditShowsWhereTheBodiesMeet) {
  ASSERT_TRUE(window_.open("head-on"));
  ASSERT_TRUE(wait_for([this] { return window_.session().runs().scene() != nullptr; }));
  EXPECT_FALSE(window_.scene_view().aim());
  Body light = window_.preset().scene.bodies[0];
  light.velocity = {3.0, 0.0};
  EXPECT_TRUE(wait_for([&] {  // a busy machine may leave one out
    light.velocity.x() += 1e-9;
    window_.session().edit({Replace<Body>{light}}, "Speed");
    return window_.scene_view().aim().has_value();
  }));
  EXPECT_NEAR(window_.scene_view().aim()->time, 0.25, 1e-6) << "1 m at 3 + 1 m/s";
  window_.session().runs().set_playing(true);
  EXPECT_TRUE(wait_for([this] { return !window_.scene_view().aim(); }));
}

TEST_F(LabHandsTest, EscapeTakesADragBack) {
  ASSERT_TRUE(window_.open("head-on"));
  ASSERT_TRUE(shows_start());
  const Vec2 light = now("light").position;
  SceneView* view = &window_.scene_view();
  QTest::mousePress(view, Qt::LeftButton, {}, pixel(light));
  const QPoint there = pixel(light + Vec2(0.0, 0.3));
  for (const QPoint& at : {pixel(light + Vec2(0.0, 0.1)), there}) {
    QMouseEvent move(QEvent::MouseMove, at, view->mapToGlobal(at), Qt::NoButton, Qt::LeftButton, {});
    QApplication::sendEvent(view, &move);
  }
  ASSERT_TRUE(wait_for([&] { return now("light").position != light; }));
  key(Qt::Key_Escape);
  QTest::mouseRelease(view, Qt::LeftButton, {}, there);
  ASSERT_TRUE(wait_for([&] { return now("light").position == light; }));
  EXPECT_FALSE(window_.session().edits().canUndo());
  EXPECT_FALSE(window_.session().edits().canRedo());
}

TEST_F(LabHandsTest, EscapeInTheInspectorGivesTheKeysBackToTheScene) {
  ASSERT_TRUE(window_.open("head-on"));
  ASSERT_TRUE(shows_start());
  window_.scene_view().select({"light"});
  QLineEdit* mass = nullptr;
  for (QLineEdit* edit : window_.findChild<Inspector*>()->findChildren<QLineEdit*>()) {
    if (edit->accessibleName() == "Mass, kg" && edit->isVisible()) mass = edit;
  }
  ASSERT_NE(mass, nullptr);
  QTest::mouseDClick(mass, Qt::LeftButton);
  mass->selectAll();
  QTest::keyClicks(mass, "2");
  QTest::keyClick(mass, Qt::Key_Escape);
  EXPECT_TRUE(mass->hasFocus());
  EXPECT_EQ(mass->selectedText(), mass->text()) << "the old value is back";
  QTest::keyClick(mass, Qt::Key_Escape);
  EXPECT_TRUE(window_.scene_view().hasFocus());
  EXPECT_FALSE(window_.scene_view().selection().empty()) << "Esc left the field, not the selection";
}

TEST_F(LabHandsTest, ANameThatIsTakenIsRefusedInWords) {
  ASSERT_TRUE(window_.open("head-on"));
  ASSERT_TRUE(shows_start());
  select(now("light").position);
  const std::string before = write_preset(window_.preset());
  type("Name", "heavy");
  EXPECT_EQ(write_preset(window_.preset()), before);
  type("Name", "small");
  ASSERT_TRUE(
      wait_for([this] { return window_.scene_view().selection() == std::vector<std::string>{"small"}; }));
  EXPECT_EQ(window_.preset().plots[0].y[0].bodies[0], "small") << "plots follow";
}

// A theory on the plots of an experiment is that of its own start: later it is only shown, and marked.
TEST_F(LabHandsTest, ATheoryGoesWithTheFirstEdit) {
  ASSERT_TRUE(window_.open("head-on"));
  ASSERT_TRUE(shows_start());
  const auto has_theory = [this] {
    for (const Plot& plot : window_.preset().plots) {
      for (const QuantityName& line : plot.y) {
        if (!line.theory.empty()) return true;
      }
    }
    return false;
  };
  const auto in_legend = [this](const QString& text) {
    const auto& plots = window_.findChild<PlotPanel*>()->plots();
    return std::any_of(plots.begin(), plots.end(), [&text](const RunPlot* plot) {
      const auto legend = plot->legend();
      return std::any_of(legend.begin(), legend.end(),
                         [&text](const auto& each) { return each.first == text; });
    });
  };
  ASSERT_TRUE(has_theory());
  EXPECT_TRUE(in_legend("theory"));
  select(now("light").position);
  type("Mass, kg", "2 kg");
  EXPECT_FALSE(has_theory()) << "in the document, which is saved";
  EXPECT_TRUE(window_.preset().expect.empty());
  EXPECT_FALSE(in_legend("theory"));
  EXPECT_TRUE(in_legend("theory of the first scene"));
  type("Mass, kg", "3 kg");
  EXPECT_TRUE(in_legend("theory of the first scene"));
  undo();
  undo();
  EXPECT_TRUE(has_theory());
  EXPECT_TRUE(in_legend("theory"));
  EXPECT_FALSE(in_legend("theory of the first scene"));
}

TEST_F(LabHandsTest, ABodyDraggedOntoAnotherTouchesIt) {
  ASSERT_NO_FATAL_FAILURE(draw_two_discs());
  const std::vector<Body> before = window_.preset().scene.bodies;
  drag(before[0].position, before[1].position + Vec2(-0.1, 0.05));
  ASSERT_TRUE(shows_start());
  const std::vector<Body>& after = window_.preset().scene.bodies;
  EXPECT_EQ(after[1].position, before[1].position);
  const double radii = std::get<Disc>(after[0].shape).radius + std::get<Disc>(after[1].shape).radius;
  EXPECT_NEAR((after[0].position - after[1].position).norm(), radii, 1e-9);
  QTest::keyClick(&window_.scene_view(), Qt::Key_Z, Qt::ControlModifier);
  ASSERT_TRUE(wait_for([&] { return window_.preset().scene.bodies[0].position == before[0].position; }));
  EXPECT_TRUE(shows_start());
}

TEST_F(LabHandsTest, TheAimGoesWithItsScene) {
  ASSERT_NO_FATAL_FAILURE(draw_two_discs());
  select({-1.0, 0.0});
  // The line has a few milliseconds to be computed, or it is left out.
  for (int k = 0; k < 100 && !window_.scene_view().aim(); ++k) type("Velocity x, m/s", k % 2 == 0 ? "4" : "5");
  ASSERT_TRUE(window_.scene_view().aim());
  window_.session().edits().setClean();
  action("New")->trigger();
  EXPECT_FALSE(window_.scene_view().aim());
}

TEST_F(LabHandsTest, UndoSelectsWhatWasSelectedBeforeTheEdit) {
  ASSERT_NO_FATAL_FAILURE(draw_two_discs());
  using Names = std::vector<std::string>;
  SceneView& view = window_.scene_view();
  const auto selects = [&](const Names& names) { return wait_for([&] { return view.selection() == names; }); };
  ASSERT_TRUE(selects({"B"})) << "it was drawn last";
  // Of a move.
  drag({-1.0, 0.0}, {-1.0, 0.5});
  ASSERT_TRUE(shows_start());
  EXPECT_EQ(view.selection(), Names{"A"});
  select({0.0, 1.0});
  EXPECT_EQ(view.selection(), Names{});
  undo();
  EXPECT_TRUE(selects({"A"}));
  EXPECT_TRUE(shows_start());
  // Of a removal.
  view.select({"A", "B"});
  key(Qt::Key_Delete);
  ASSERT_TRUE(wait_for([this] { return window_.frame()->bodies->empty(); }));
  EXPECT_TRUE(selects({}));
  undo();
  EXPECT_TRUE(selects({"A", "B"}));
  // Of a new body: what was selected before it.
  view.select({"A"});
  key(Qt::Key_D);
  drag({0.0, 1.0}, {0.1, 1.0});
  ASSERT_TRUE(selects({"C"}));
  undo();
  EXPECT_TRUE(selects({"A"}));
  // Of a name.
  type("Name", "light");
  ASSERT_TRUE(selects({"light"}));
  undo();
  EXPECT_TRUE(selects({"A"}));
}

// Dragged from where it is seen, and its ghost stands there.
TEST_F(LabHandsTest, ADrivenBodyIsDraggedFromWhereItIs) {
  ASSERT_TRUE(window_.open("moving-piston"));
  ASSERT_TRUE(wait_for([this] { return window_.frame()->scene && window_.frame()->bodies->size() == 5; }));
  constexpr int kSteps = 200;  // of 0.01 s: 0.2 m
  constexpr int kPiston = 1;
  for (int i = 0; i < kSteps; ++i) window_.session().starts().step_by(1);
  ASSERT_TRUE(wait_for([this] { return window_.frame()->steps == kSteps && window_.frame()->scene; }));
  const Vec2 seen = window_.frame()->state.position(kPiston);
  ASSERT_NEAR(seen.x(), 2.3, 1e-12);
  const Vec2 way(0.2, 0.0);
  drag(seen, seen + way, Qt::ControlModifier);
  const double pixel_size = 1.0 / window_.scene_view().camera().scale;
  ASSERT_TRUE(wait_for([this] { return window_.preset().saved.has_value() && window_.frame()->scene; }));
  EXPECT_TRUE(wait_for([&] {
    return (window_.frame()->state.position(kPiston) - seen - way).norm() < 2.0 * pixel_size;
  })) << window_.frame()->state.position(kPiston).transpose();
}

}  // namespace
}  // namespace carom
