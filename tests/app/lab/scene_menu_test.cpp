#include <QClipboard>
#include <QLineEdit>
#include <QMenuBar>
#include <QPushButton>

#include "app/lab/session.h"
#include "tests/app/lab/lab_fixture.h"
#include "widgets/edit/inspector.h"

// The menu of a right click in the scene.
namespace carom {
namespace {

class SceneMenuTest : public LabWindowTest {
 protected:
  void SetUp() override {
    ASSERT_NO_FATAL_FAILURE(LabWindowTest::SetUp());
    ASSERT_TRUE(wait_for([this] { return window_.frame()->scene != nullptr; }));
  }
  void TearDown() override {
    if (QWidget* menu = QApplication::activePopupWidget()) menu->close();
  }
  SceneView& view() { return window_.scene_view(); }
  [[nodiscard]] Vec2 place(const std::string& name) {
    for (const Body& body : window_.frame()->scene->bodies) {
      if (body.name == name) return body.position;
    }
    throw std::runtime_error("no body " + name);
  }
  QMenu* menu_at(const Vec2& world) {
    if (QWidget* open = QApplication::activePopupWidget()) open->close();
    QTest::mouseClick(&view(), Qt::RightButton, {}, view().camera().to_screen(world).toPoint());
    return qobject_cast<QMenu*>(QApplication::activePopupWidget());
  }
  QAction* entry(QMenu* menu, const QString& text) {
    for (QAction* a : menu->actions()) {
      if (a->text().remove('&') == text) return a;
    }
    throw std::runtime_error("no entry " + text.toStdString());
  }
  void choose(const Vec2& world, const QString& text) {
    QMenu* menu = menu_at(world);
    ASSERT_NE(menu, nullptr);
    QAction* action = entry(menu, text);
    ASSERT_TRUE(action->isEnabled()) << text.toStdString();
    action->trigger();
    menu->close();
  }
  [[nodiscard]] bool has(std::size_t bodies) {
    return wait_for([=, this] { return window_.frame()->bodies->size() == bodies && window_.frame()->scene; });
  }
  using Names = std::vector<std::string>;
};

TEST_F(SceneMenuTest, ARightClickSelectsAndADragPans) {
  QMenu* menu = menu_at(place("light"));
  ASSERT_NE(menu, nullptr);
  EXPECT_EQ(view().selection(), Names{"light"});
  EXPECT_EQ(menu->actions().front()->text(), "light · disc, 1 kg");
  EXPECT_EQ(entry(menu, "Duplicate")->shortcut(), QKeySequence("Ctrl+D"));
  EXPECT_THROW(entry(menu, "Put in touch with light"), std::runtime_error);
  view().select({"heavy", "light"});
  menu = menu_at(place("light"));
  EXPECT_EQ(view().selection(), (Names{"heavy", "light"})) << "it was selected";
  EXPECT_FALSE(entry(menu, "Rename")->isEnabled());
  EXPECT_TRUE(entry(menu, "Put in touch with light")->isEnabled());
  menu->close();
  const QPoint at = view().camera().to_screen(place("light")).toPoint();
  QTest::mousePress(&view(), Qt::RightButton, {}, at);
  const QPoint to = at + QPoint(20, 0);
  QMouseEvent move(QEvent::MouseMove, to, view().mapToGlobal(to), Qt::NoButton, Qt::RightButton, {});
  QApplication::sendEvent(&view(), &move);
  QTest::mouseRelease(&view(), Qt::RightButton, {}, to);
  EXPECT_EQ(QApplication::activePopupWidget(), nullptr);
}

TEST_F(SceneMenuTest, ItsKeysOpenItAtTheSelection) {
  for (const auto& [key, held] :
       {std::pair(Qt::Key_Menu, Qt::NoModifier), std::pair(Qt::Key_F10, Qt::ShiftModifier)}) {
    view().select({"light"});
    QTest::keyClick(&view(), key, held);
    auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
    ASSERT_NE(menu, nullptr);
    EXPECT_EQ(menu->actions().front()->text(), "light · disc, 1 kg");
    const QPoint at = view().mapToGlobal(view().camera().to_screen(place("light")).toPoint());
    EXPECT_TRUE(menu->geometry().adjusted(-2, -2, 2, 2).contains(at));
    menu->close();
  }
  view().select({});
  QTest::keyClick(&view(), Qt::Key_Menu);
  auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
  ASSERT_NE(menu, nullptr);
  EXPECT_NO_THROW(entry(menu, "Paste here"));
}

TEST_F(SceneMenuTest, EntriesDoWhatTheirKeysDo) {
  const Vec2 light = place("light");
  choose(light, "Reverse the velocity");
  EXPECT_EQ(window_.session().edits().undoText(), "Reverse light");
  choose(light, "Bring to rest");
  EXPECT_EQ(window_.session().edits().undoText(), "Bring light to rest");
  choose(light, "Lock: hands off");
  EXPECT_TRUE(view().all_locked());
  const int count = window_.session().edits().count();
  choose(light, "Delete");
  choose(light, "Cut");
  EXPECT_EQ(window_.session().edits().count(), count) << "it is locked";
  EXPECT_TRUE(QApplication::clipboard()->text().contains("light"));
  choose(light, "Unlock");
  choose(light, "Duplicate");
  ASSERT_TRUE(has(3));
  choose(light, "Delete");
  ASSERT_TRUE(has(2));
}

TEST_F(SceneMenuTest, ABodyIsPlottedAndStopsTheRun) {
  const auto choose_of = [this](const QString& menu, const QString& text) {
    QMenu* open = menu_at(place("light"));
    ASSERT_NE(open, nullptr);
    entry(entry(open, menu)->menu(), text)->trigger();
    open->close();
  };
  auto* panel = window_.findChild<PlotPanel*>();
  const std::size_t plots = panel->plots().size();
  choose_of("Plot its", "speed");
  ASSERT_EQ(panel->plots().size(), plots + 1);
  EXPECT_EQ(window_.preset().plots.back().y, (std::vector<QuantityName>{{"speed", {"light"}}}));
  EXPECT_EQ(window_.session().edits().undoText(), "Add plot");

  choose_of("Stop when it passes", "x ...");
  auto* value = qobject_cast<QLineEdit*>(QApplication::focusWidget());
  ASSERT_NE(value, nullptr);
  EXPECT_EQ(value->accessibleName(), "Value");
  QTest::keyClicks(value, "0.25");
  QTest::keyClick(value, Qt::Key_Return);
  ASSERT_EQ(window_.preset().stops.size(), 1U);
  EXPECT_EQ(sentence_of(window_.preset().stops[0]), "when light passes x = 0.25 m");
  QApplication::activePopupWidget()->close();
  Body fixed = window_.frame()->scene->bodies.front();
  fixed.fixed = true;
  fixed.velocity.setZero();
  window_.session().edit({Replace<Body>{fixed}}, "Fix");
  ASSERT_TRUE(wait_for([this] { return window_.frame()->scene && window_.frame()->scene->bodies[0].fixed; }));
  QMenu* menu = menu_at(place(fixed.name));
  EXPECT_EQ(menu->actions().front()->text(), QString::fromStdString(fixed.name) + " · disc, fixed");
  EXPECT_THROW(entry(menu, "Plot its"), std::runtime_error);
}

TEST_F(SceneMenuTest, RenamePutsTheCursorIntoTheName) {
  action("Inspector")->setChecked(false);
  choose(place("light"), "Rename");
  auto* name = qobject_cast<QLineEdit*>(QApplication::focusWidget());
  ASSERT_NE(name, nullptr);
  EXPECT_EQ(name->accessibleName(), "Name");
  EXPECT_TRUE(action("Inspector")->isChecked());
  QTest::keyClicks(name, "small");
  QTest::keyClick(name, Qt::Key_Return);
  ASSERT_TRUE(wait_for([this] { return view().selection() == Names{"small"}; }));
}

TEST_F(SceneMenuTest, EmptySpaceTakesNewAndCopiedBodies) {
  view().select({"light"});
  action("Copy")->trigger();
  const Vec2 free = place("light") + Vec2(0.0, 0.5);
  choose(free, "Paste here");
  EXPECT_TRUE(view().selection().empty());
  ASSERT_TRUE(has(3));
  EXPECT_LT((window_.frame()->scene->bodies.back().position - free).norm(), 0.01);
  choose(free + Vec2(0.5, 0.0), "New box here");
  ASSERT_TRUE(has(4));
  choose(free + Vec2(-0.5, 0.0), "New disc here");
  ASSERT_TRUE(has(5));
  EXPECT_EQ(view().tool(), SceneTool::kSelect);
}

TEST_F(SceneMenuTest, BodiesBecomeOneAndAreTakenApart) {
  const auto undo_text = [this] { return window_.session().edits().undoText(); };
  view().select({"heavy", "light"});
  choose(place("light"), "Join into one body");
  EXPECT_EQ(undo_text(), "") << "they are of two densities";
  std::vector<Body> bodies = window_.frame()->scene->bodies;
  for (Body& body : bodies) {
    body.mass.reset();
    body.density = 2.0;
  }
  window_.session().edit({Replace<Body>{bodies[0]}, Replace<Body>{bodies[1]}}, "Density");
  ASSERT_TRUE(wait_for(
      [this] { return window_.frame()->scene && window_.frame()->scene->bodies.front().density == 2.0; }));
  choose(place("light"), "Join into one body");
  EXPECT_EQ(undo_text(), "Join heavy and light into one body");
  ASSERT_TRUE(has(1));
  EXPECT_EQ(view().selection(), Names{"heavy"});
  action("Take apart")->trigger();
  EXPECT_EQ(undo_text(), "Take heavy apart into 2 bodies");
  ASSERT_TRUE(has(2));
  EXPECT_EQ(view().selection(), (Names{"heavy-1", "heavy-2"}));
  window_.session().edits().undo();
  ASSERT_TRUE(has(1));
  const auto& shape = window_.frame()->scene->bodies.front().shape;
  choose(place("heavy") + std::get<Compound>(shape).shapes[1].position, "Take apart");
  ASSERT_TRUE(has(2));
}

TEST_F(SceneMenuTest, AJointIsChosen) {
  const Vec2 light = place("light");
  view().select({"light", "heavy"});
  QTest::keyClick(&view(), Qt::Key_0);
  ASSERT_TRUE(wait_for([this] {
    return window_.frame()->scene && window_.frame()->scene->bodies.front().velocity.isZero(0.0);
  }));
  QTest::keyClick(&view(), Qt::Key_O);
  QTest::keyClick(&view(), Qt::Key_Return);
  ASSERT_TRUE(wait_for([this] { return window_.frame()->joints.size() == 1 && window_.frame()->scene; }));
  choose(0.5 * (light + place("heavy")), "Delete");
  EXPECT_EQ(window_.session().edits().undoText(), "Delete Rod 1");
}

TEST_F(SceneMenuTest, SeveralBodiesAreAlignedFromTheirMenu) {
  view().select({"light", "heavy"});
  QMenu* menu = menu_at(place("light"));
  ASSERT_NE(menu, nullptr);
  QMenu* align = entry(menu, "Align")->menu();
  ASSERT_NE(align, nullptr);
  EXPECT_TRUE(align->isEnabled());
  entry(align, "Left sides")->trigger();
  EXPECT_TRUE(window_.session().edits().undoText().startsWith("Align 2 bodies"));
  menu->close();
  view().select({"light"});
  EXPECT_THROW(entry(menu_at(place("light")), "Align"), std::runtime_error);
}

TEST_F(SceneMenuTest, TheInspectorHasTheActionsOfSeveralBodies) {
  const auto tool = [this](const QString& text) {
    for (QPushButton* each : window_.findChild<Inspector*>()->findChildren<QPushButton*>()) {
      if (each->accessibleName() == text) return each;
    }
    throw std::runtime_error("no button " + text.toStdString());
  };
  view().select({"light"});
  EXPECT_FALSE(tool("Align")->isVisible());
  view().select({"light", "heavy"});
  EXPECT_TRUE(tool("Align")->isVisible());
  EXPECT_FALSE(tool("Distribute")->isEnabled()) << "two have one gap";
  QAction* lefts = entry(tool("Align")->menu(), "Left sides");
  EXPECT_EQ(lefts, action("Left sides")) << "that of the menu Edit";
  lefts->trigger();
  EXPECT_EQ(window_.session().edits().undoText(), "Align 2 bodies at the left");
  ASSERT_TRUE(wait_for([this] { return window_.frame()->scene != nullptr; }));
  QTest::mouseClick(tool("Put in touch"), Qt::LeftButton);
  EXPECT_EQ(window_.session().edits().undoText(), "Put light in touch with heavy");
}

TEST_F(SceneMenuTest, TheMenuBarSaysWhatCanBeDone) {
  view().select({});
  for (const char* name : {"Cut", "Copy", "Duplicate"}) EXPECT_FALSE(action(name)->isEnabled()) << name;
  QMenu* edit = window_.menuBar()->actions()[1]->menu();
  emit edit->aboutToShow();
  EXPECT_FALSE(entry(edit, "Delete\tDel")->isEnabled());
  entry(edit, "Select all\tCtrl+A")->trigger();
  EXPECT_EQ(view().selection().size(), 2U);
  for (const char* name : {"Cut", "Copy", "Duplicate"}) EXPECT_TRUE(action(name)->isEnabled()) << name;
  emit edit->aboutToShow();
  EXPECT_TRUE(entry(edit, "Delete\tDel")->isEnabled());
  entry(edit, "Delete\tDel")->trigger();
  EXPECT_TRUE(has(0));
  for (const char* name : {"Grid", "Velocities", "Forces", "Contacts", "Names"})
    EXPECT_FALSE(action(name)->isIconVisibleInMenu() && !action(name)->icon().isNull())
        << name << " has a tick";
}

}  // namespace
}  // namespace carom
