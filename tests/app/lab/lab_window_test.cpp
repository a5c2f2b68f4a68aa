#include "app/lab/lab_window.h"

#include <QAction>
#include <QFile>
#include <QLabel>
#include <QTest>
#include <QToolButton>
#include <gtest/gtest.h>

#include "physics/preset/preset.h"
#include "physics/preset/preset_file.h"
#include "tests/app/lab/lab_fixture.h"
#include "tests/support/source_folder.h"
#include "tests/support/wait_events.h"
#include "widgets/plot/plot_panel.h"
#include "widgets/plot/run_plot.h"

namespace carom {
namespace {

TEST_F(LabWindowTest, RunsAnExperimentToATime) {
  window_.run_until(1.0);
  EXPECT_NEAR(time(), 1.0, 1e-9);
  EXPECT_EQ(window_.frame()->impact_count, 1);
  EXPECT_NEAR(window_.frame()->totals.momentum.x(), -0.5, 1e-12);
  EXPECT_FALSE(window_.isWindowModified());
  EXPECT_EQ(marked_experiment(), "head-on");
  EXPECT_TRUE(boxes_.empty());
}

TEST_F(LabWindowTest, MethodsAreChosenFromTheMenus) {
  ASSERT_EQ(window_.preset().method.integrator, IntegratorId::kRk4);
  action("Explicit Euler")->trigger();
  EXPECT_EQ(window_.preset().method.integrator, IntegratorId::kExplicitEuler);
  EXPECT_TRUE(window_.isWindowModified());
  action("impacts at the step's end")->trigger();
  EXPECT_EQ(window_.preset().method.impacts, ImpactsId::kStepEnd);
  action("contacts that last")->trigger();
  EXPECT_EQ(window_.preset().method.contacts, ContactsId::kLasting);
  action("h = 10 ms")->trigger();
  EXPECT_EQ(window_.preset().method.step, 0.01);
  EXPECT_EQ(window_.preset().method.integrator, IntegratorId::kExplicitEuler);
  // The worker uses it: 0.3 s are 30 steps.
  window_.run_until(0.3);
  EXPECT_EQ(steps(), 30);
}

// A disc on a floor, with friction.
TEST_F(LabWindowTest, ContactsAreChosenBesideTheImpacts) {
  EXPECT_EQ(button("How lasting contacts are treated")->text(), "impulses only ▾");
  Preset preset;
  preset.scene.forces.gravity = Vec2(0.0, -10.0);
  preset.scene.bodies.resize(2);
  preset.scene.bodies[0].name = "floor";
  preset.scene.bodies[0].shape = Box{4.0, 0.2};
  preset.scene.bodies[0].position = Vec2(0.0, -0.1);
  preset.scene.bodies[0].fixed = true;
  preset.scene.bodies[1].name = "block";
  preset.scene.bodies[1].shape = Box{0.4, 0.4};
  preset.scene.bodies[1].position = Vec2(0.0, 0.2);
  preset.scene.bodies[1].mass = 3.0;
  preset.scene.materials = {{.restitution = 0.5}};
  window_.show_scene(preset, {}, {});
  window_.run_until(0.1);
  EXPECT_TRUE(window_.frame()->contacts.empty());
  EXPECT_TRUE(about().contains("as repeated impacts"));

  const QToolButton* choice = button("How lasting contacts are treated");
  QAction* lasting = choice->menu()->actions().back();
  EXPECT_TRUE(lasting->toolTip().contains("static and kinetic friction"));
  lasting->trigger();
  EXPECT_EQ(choice->text(), "contacts that last ▾");
  EXPECT_FALSE(about().contains("as repeated impacts"));
  EXPECT_TRUE(window_.isWindowModified());
  window_.run_until(0.2);
  double held = 0.0;
  for (const ContactForce& contact : window_.frame()->contacts) held += contact.normal_force;
  EXPECT_NEAR(held, 30.0, 1e-6);
  EXPECT_FALSE(window_.scene_view().drawing().arrows.empty());
  action("impulses only")->trigger();
  EXPECT_EQ(window_.preset().method.contacts, ContactsId::kImpulse);
  window_.run_until(0.3);
  EXPECT_TRUE(window_.frame()->contacts.empty());
}

TEST_F(LabWindowTest, WhatIsModelledStandsUnderAbout) {
  EXPECT_TRUE(about().contains("Modelled: normal impulses")) << about().toStdString();
  EXPECT_TRUE(about().section("Not needed", 1).contains("friction"));
  ASSERT_TRUE(window_.open("drag-projectile"));
  EXPECT_TRUE(about().contains("Modelled: normal impulses, gravity"));
}

TEST_F(LabWindowTest, PlotsAreChosenFromTheMenu) {
  const auto plots = [this] { return window_.findChild<PlotPanel*>()->plots().size(); };
  EXPECT_EQ(plots(), window_.preset().plots.size());
  const int height = window_.height();
  for (const char* title : {"Ledger", "Energy drift", "Momentum drift"}) {
    const std::size_t before = plots();
    plot_action(title)->trigger();
    EXPECT_EQ(plots(), before + 1);
  }
  QApplication::processEvents();
  EXPECT_EQ(window_.height(), height) << "more plots are scrolled";
  EXPECT_FALSE(window_.isWindowModified());
  ASSERT_TRUE(window_.open("spring-box"));
  EXPECT_EQ(plots(), window_.preset().plots.size());
}

// A run plays until another experiment is opened: its last picture stays for a moment, and bodies of it can't
// be pulled.
TEST_F(LabWindowTest, NothingIsTakenHoldOfUntilTheNextSceneIsShown) {
  ASSERT_TRUE(window_.open("head-on"));
  ASSERT_TRUE(wait_for([this] { return window_.frame() != nullptr; }));
  window_.session().runs().set_playing(true);
  ASSERT_TRUE(wait_for([this] { return window_.frame()->playing; }));
  SceneView& view = window_.scene_view();
  ASSERT_TRUE(window_.open("bouncing-ball"));
  ASSERT_EQ(window_.frame(), nullptr);
  const QPoint at = view.camera().to_screen(view.frame()->state.position(0)).toPoint();  // as still seen
  ASSERT_TRUE(view.rect().contains(at));
  QTest::mousePress(&view, Qt::LeftButton, {}, at);
  QTest::mouseMove(&view, at + QPoint(60, 40));
  QTest::mouseRelease(&view, Qt::LeftButton, {}, at + QPoint(60, 40));
  EXPECT_EQ(window_.session().edits().count(), 0);
  EXPECT_TRUE(wait_for([this] { return window_.frame() != nullptr; }));
}

TEST_F(LabWindowTest, AnotherSceneHasNoPlaceOfTheMouseYet) {
  ASSERT_TRUE(window_.open("head-on"));
  const auto place_shown = [this] {
    const auto labels = window_.scene_view().findChildren<QLabel*>();
    return std::any_of(labels.begin(), labels.end(), [](const QLabel* label) {
      return label->isVisible() && label->text().startsWith("x = ");
    });
  };
  emit window_.scene_view().cursorMoved(0.25, 0.5);
  ASSERT_TRUE(place_shown());
  ASSERT_TRUE(window_.open("glancing"));
  EXPECT_FALSE(place_shown());
}

TEST_F(LabWindowTest, ANarrowWindowFoldsTheSwitchesOfTheView) {
  const auto shown = [this](const char* tip) {
    const QList<QToolButton*> buttons = window_.findChildren<QToolButton*>();
    return std::any_of(buttons.begin(), buttons.end(), [&](const QToolButton* each) {
      return each->isVisible() && each->toolTip().startsWith(tip);
    });
  };
  EXPECT_TRUE(shown("Grid in metres"));
  window_.resize(window_.minimumSize());
  EXPECT_TRUE(wait_for([&] { return !shown("Grid in metres"); }));
  EXPECT_TRUE(wait_for([this] { return !button("How free motion is advanced")->text().isEmpty(); }));
  window_.resize(1280, 800);
  EXPECT_TRUE(wait_for([&] { return shown("Grid in metres"); }));
}

TEST_F(LabWindowTest, TheDiscToolAddsADisc) {
  click_scene({0.1, 0.4});
  EXPECT_TRUE(window_.isWindowModified());
  ASSERT_TRUE(wait_for([this] { return window_.frame()->bodies->size() == 3; }));
  const Body& added = window_.frame()->bodies->back();
  const double pixel = 1.0 / window_.scene_view().camera().scale;
  EXPECT_NEAR(added.position.x(), 0.1, pixel);
  EXPECT_NEAR(added.position.y(), 0.4, pixel);
  EXPECT_FALSE(added.fixed);
  ASSERT_TRUE(std::holds_alternative<Disc>(added.shape));
  // A click on a body adds no other.
  click_scene({0.1, 0.4});
  EXPECT_EQ(all_bodies(window_.preset()).size(), 3U);
  // It survives a restart.
  window_.run_until(0.1);
  click_button("Restart");
  ASSERT_TRUE(wait_for([this] { return time() == 0.0; }));
  EXPECT_EQ(window_.frame()->bodies->size(), 3U);
}

// Of those to choose from. The slowest plays for a minute, so that no machine is too slow to pause it.
constexpr double kSlowest = 1.0 / 64.0;
constexpr double kFastest = 20.0;

TEST_F(LabWindowTest, PlaysPausesStepsAndRestarts) {
  choose_speed(kSlowest);
  click_button("Play");
  ASSERT_TRUE(wait_for([this] { return window_.frame()->playing && time() > 0.0; }));
  click_button("Play");
  ASSERT_TRUE(wait_for([this] { return !window_.frame()->playing; }));
  const double paused = time();
  const std::int64_t before = steps();
  EXPECT_LT(paused, 1.0);
  // If it still played, or did after a step, it would be further when the next one shows.
  choose_speed(kFastest);
  for (int i = 1; i <= 10; ++i) {
    const std::int64_t last = steps();
    click_button("One step");
    ASSERT_TRUE(wait_for([&] { return steps() != last; }));
    EXPECT_EQ(steps(), before + i);
    EXPECT_NEAR(time(), paused + 0.005 * i, 1e-12);
  }
  click_button("Restart");
  ASSERT_TRUE(wait_for([this] { return time() == 0.0; }));
  EXPECT_EQ(steps(), 0);
  EXPECT_FALSE(window_.frame()->playing);
  EXPECT_FALSE(window_.isWindowModified());
}

TEST_F(LabWindowTest, KeysMakeItFasterAndSlower) {
  const LabRuns& runs = window_.session().runs();
  const auto press = [this](Qt::Key key, int times) {
    for (int i = 0; i < times; ++i) QTest::keyClick(&window_.scene_view(), key, Qt::ControlModifier);
  };
  press(Qt::Key_Period, 2);
  EXPECT_EQ(runs.speed(), 4.0);
  press(Qt::Key_Period, 9);
  EXPECT_EQ(runs.speed(), 20.0);
  EXPECT_EQ(button("Speed")->text(), "×20");
  press(Qt::Key_Comma, 20);
  EXPECT_EQ(runs.speed(), 0.001);
  EXPECT_EQ(button("Speed")->text(), "×1/1000");
}

TEST_F(LabWindowTest, KeysPlayStepAndRestart) {
  QTest::keyClick(&window_.scene_view(), Qt::Key_Period);
  ASSERT_TRUE(wait_for([this] { return steps() == 1; }));
  choose_speed(kSlowest);
  QTest::keyClick(&window_.scene_view(), Qt::Key_Space);
  ASSERT_TRUE(wait_for([this] { return window_.frame()->playing && steps() > 1; }));
  QTest::keyClick(&window_.scene_view(), Qt::Key_Space);
  ASSERT_TRUE(wait_for([this] { return !window_.frame()->playing; }));
  QTest::keyClick(&window_.scene_view(), Qt::Key_R);
  EXPECT_TRUE(wait_for([this] { return time() == 0.0; }));
}

TEST_F(LabWindowTest, PlayStopsAtTheEndAndBeginsAgainFromThere) {
  window_.run_until(0.97);
  click_button("Play");
  ASSERT_TRUE(wait_for([this] { return time() > 0.99 && !window_.frame()->playing; }));
  EXPECT_NEAR(time(), 1.0, 1e-9);
  choose_speed(kSlowest);
  QTest::keyClick(&window_.scene_view(), Qt::Key_Space);
  ASSERT_TRUE(wait_for([this] { return window_.frame()->playing && time() > 0.0; }));
  EXPECT_LT(time(), 0.5);
}

TEST_F(LabWindowTest, GoesOnPastTheEndOnRequest) {
  window_.run_until(1.0);
  action("Play on past the end")->trigger();
  ASSERT_TRUE(wait_for([this] { return time() > 1.02; }));
  QTest::keyClick(&window_.scene_view(), Qt::Key_Space);
  ASSERT_TRUE(wait_for([this] { return !window_.frame()->playing; }));
  const double paused = time();
  QTest::keyClick(&window_.scene_view(), Qt::Key_Space);
  EXPECT_TRUE(wait_for([&] { return time() > paused; })) << "it goes on where it was paused";
}

TEST_F(LabWindowTest, ThemeIsSwitchedThereAndBack) {
  window_.run_until(0.1);
  const auto corner = [this] {
    const QImage picture = window_.scene_view().grab().toImage();
    return picture.pixelColor(3, picture.height() - 4).lightnessF();
  };
  EXPECT_GT(corner(), 0.6F);
  action("Dark colours")->trigger();
  EXPECT_LT(corner(), 0.4F);
  action("Light colours")->trigger();
  EXPECT_GT(corner(), 0.6F);
  EXPECT_FALSE(window_.isWindowModified());
}

TEST_F(LabWindowTest, NewExperimentRunsToItsOwnTime) {
  window_.run_until(1.0);
  ASSERT_TRUE(window_.open("newtons-cradle"));
  window_.run_until(0.5);
  EXPECT_NEAR(time(), 0.5, 1e-9);
  EXPECT_EQ(window_.frame()->bodies->size(), 5U);
}

// Saved on closing, under a name from the dialog.
// The menu names the undone change; the modified mark and the picture follow.
TEST_F(LabWindowTest, EditsAreUndoneFromTheMenu) {
  const auto trigger = [&](const QKeySequence& key) {
    for (QAction* a : window_.findChildren<QAction*>()) {
      if (a->shortcut() == key) return a->trigger();
    }
  };
  const QKeySequence undo(Qt::CTRL | Qt::Key_Z);
  const QKeySequence redo(Qt::CTRL | Qt::SHIFT | Qt::Key_Z);
  EXPECT_FALSE(action("Undo")->isEnabled());
  window_.run_until(0.1);
  action("Explicit Euler")->trigger();
  EXPECT_EQ(button("How free motion is advanced")->text(), "Explicit Euler ▾");
  click_scene({0.1, 0.4});
  ASSERT_TRUE(wait_for([this] { return window_.frame()->bodies->size() == 3; }));
  plot_action("Ledger")->trigger();
  auto* plots = window_.findChild<PlotPanel*>();
  EXPECT_TRUE(plots->shows("ledger"));
  EXPECT_TRUE(action("Undo Add plot")->isEnabled());
  trigger(undo);
  EXPECT_FALSE(plots->shows("ledger"));
  EXPECT_TRUE(action("Redo Add plot")->isEnabled());
  EXPECT_TRUE(action("Undo Drop disc at 0.1 s")->isEnabled());
  trigger(undo);
  ASSERT_TRUE(wait_for([this] { return window_.frame()->bodies->size() == 2; }));
  EXPECT_EQ(window_.preset().scene.bodies.size(), 2U);
  EXPECT_TRUE(window_.isWindowModified());
  trigger(undo);
  EXPECT_FALSE(window_.isWindowModified());
  EXPECT_EQ(button("How free motion is advanced")->text(), "RK4 ▾");
  ASSERT_TRUE(wait_for([this] { return window_.frame()->setup->edits.empty(); }));
  EXPECT_NEAR(time(), 0.1, 1e-9);
  for (int i = 0; i < 3; ++i) trigger(redo);
  EXPECT_TRUE(plots->shows("ledger"));
  EXPECT_TRUE(window_.isWindowModified());
  ASSERT_TRUE(wait_for([this] { return window_.frame()->setup->edits.size() == 2; }));
}

// A plot keeps its notes and its zoom where another plot is added or removed.
TEST_F(LabWindowTest, UndoOfANoteLeavesThePlotsAsTheyAre) {
  auto* plots = window_.findChild<PlotPanel*>();
  RunPlot* first = plots->plots().front();
  first->set_notes({{0.5, 1.0, "here"}});
  emit plots->layoutChanged();
  EXPECT_TRUE(window_.isWindowModified());
  action("Undo Notes of a plot")->trigger();
  EXPECT_EQ(plots->plots().front(), first);
  EXPECT_TRUE(first->content().plot.notes.empty());
  EXPECT_FALSE(window_.isWindowModified());
  action("Redo Notes of a plot")->trigger();
  EXPECT_EQ(first->content().plot.notes.size(), 1U);
}

TEST_F(LabWindowTest, SaysOverTheSceneWhyARunIsLost) {
  Preset s;
  s.title = "Stiff spring";
  Body body;
  body.name = "a";
  body.position = {1, 0};
  s.scene.bodies = {body};
  Spring spring;
  spring.body = "a";
  spring.stiffness = 1e6;
  s.scene.forces.springs = {spring};
  window_.show_scene(s, "stiff", {});
  ASSERT_TRUE(wait_for([this] { return window_.frame()->bodies->size() == 1; }));
  window_.run_until(1.0);
  ASSERT_TRUE(wait_for([this] { return window_.frame()->lost.has_value(); }));
  const auto shown = [this](const QString& text) {
    for (const QLabel* label : window_.findChildren<QLabel*>()) {
      if (label->isVisible() && label->text().contains(text)) return true;
    }
    return false;
  };
  EXPECT_TRUE(test::wait_in_event_loop([&] { return shown("The run is lost at t = "); }));
  QTest::keyClick(&window_, Qt::Key_R);
  ASSERT_TRUE(wait_for([this] { return steps() == 0 && !window_.frame()->lost; }));
  EXPECT_TRUE(test::wait_in_event_loop([&] { return !shown("The run is lost"); }));
}

}  // namespace
}  // namespace carom
