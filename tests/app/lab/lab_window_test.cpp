#include "app/lab/lab_window.h"

#include <QAction>
#include <QApplication>
#include <QFile>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QMessageBox>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>
#include <gtest/gtest.h>
#include <stdexcept>

#include "physics/preset/preset.h"
#include "physics/preset/preset_file.h"
#include "widgets/plot/plot_panel.h"
#include "widgets/plot/run_plot.h"
#include "widgets/run/experiment_list.h"
#include "widgets/scene/scene_view.h"

namespace carom {
namespace {

class LabWindowTest : public testing::Test {
 protected:
  void SetUp() override {
    // Every question is answered at once, so that no test can hang.
    QObject::connect(&answering_, &QTimer::timeout, [this] { answer(); });
    answering_.start(10);
    window_.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&window_));
    ASSERT_TRUE(window_.open("head-on"));
    ASSERT_TRUE(wait_for([this] { return window_.frame()->bodies->size() == 2; }));
    window_.scene_view().setFocus();
  }

  // Waits until this number of questions were asked and answered in all.
  [[nodiscard]] bool wait_for_boxes(std::size_t count) {
    return QTest::qWaitFor(
        [&] { return boxes_.size() >= count && QApplication::activeModalWidget() == nullptr; }, 5000);
  }
  // Waits for a frame with `fulfilled`; returns false if that takes too long.
  template <class Condition>
  bool wait_for(const Condition& fulfilled) {
    return QTest::qWaitFor([&] { return window_.frame() != nullptr && fulfilled(); }, 5000);
  }
  [[nodiscard]] double time() const { return window_.frame()->time; }
  [[nodiscard]] std::int64_t steps() const { return window_.frame()->steps; }

  QAction* action(const QString& text) {
    for (QAction* a : window_.findChildren<QAction*>()) {
      if (a->text().remove('&') == text) return a;
    }
    ADD_FAILURE() << "no action " << text.toStdString();
    return nullptr;
  }
  QToolButton* button(const QString& tip) {
    for (QToolButton* b : window_.findChildren<QToolButton*>()) {
      if (b->toolTip().startsWith(tip)) return b;
    }
    throw std::runtime_error("no button " + tip.toStdString());
  }
  void click_button(const QString& tip) { QTest::mouseClick(button(tip), Qt::LeftButton); }
  QLabel* chip(const QString& name) {
    for (QLabel* label : window_.findChildren<QLabel*>("chip")) {
      if (label->accessibleName() == name) return label;
    }
    throw std::runtime_error("no chip " + name.toStdString());
  }
  QAction* plot_action(const QString& title) {
    for (QAction* a : window_.findChild<PlotPanel*>()->menu()->actions()) {
      if (a->text() == title) return a;
    }
    throw std::runtime_error("no plot " + title.toStdString());
  }
  void click_scene(const Vec2& world) {
    const QPoint at = window_.scene_view().camera().to_screen(world).toPoint();
    ASSERT_TRUE(window_.scene_view().rect().contains(at));
    QTest::mouseClick(&window_.scene_view(), Qt::LeftButton, {}, at);
  }
  QListWidget* list() { return window_.findChild<ExperimentList*>()->findChild<QListWidget*>(); }
  void click_experiment(const QString& name) {
    for (int row = 0; row < list()->count(); ++row) {
      QListWidgetItem* item = list()->item(row);
      if (item->data(Qt::UserRole).toString() != name) continue;
      list()->scrollToItem(item);
      QTest::mouseClick(list()->viewport(), Qt::LeftButton, {}, list()->visualItemRect(item).center());
      return;
    }
    ADD_FAILURE() << "no experiment " << name.toStdString();
  }
  [[nodiscard]] QString marked_experiment() {
    const QListWidgetItem* item = list()->currentItem();
    return item == nullptr ? QString() : item->data(Qt::UserRole).toString();
  }

  QTemporaryDir folder_;
  std::vector<QString> boxes_;                                // texts of the message boxes so far
  QMessageBox::StandardButton button_ = QMessageBox::Cancel;  // pressed in them
  QString chosen_file_;                                       // in a file dialog
  LabWindow window_{light_theme()};

 private:
  void answer() {
    QWidget* asking = QApplication::activeModalWidget();
    if (auto* box = qobject_cast<QMessageBox*>(asking)) {
      boxes_.push_back(box->text() + "\n" + box->informativeText());
      QAbstractButton* button = box->button(button_);
      if (button != nullptr) {
        button->click();
      } else {
        box->reject();
      }
    } else if (auto* dialog = qobject_cast<QFileDialog*>(asking)) {
      if (chosen_file_.isEmpty()) return dialog->reject();
      const QString file = std::exchange(chosen_file_, {});
      dialog->setDirectory(QFileInfo(file).path());
      auto* name = dialog->findChild<QLineEdit*>("fileNameEdit");
      name->setText(QFileInfo(file).fileName());
      // Deferred: a question of the dialog would wait for the end of this timer event.
      QMetaObject::invokeMethod(dialog, "accept", Qt::QueuedConnection);
    } else if (asking != nullptr) {
      asking->close();
    }
  }
  QTimer answering_;
};

TEST_F(LabWindowTest, RunsAnExperimentToATime) {
  window_.run_until(1.0);
  EXPECT_NEAR(time(), 1.0, 1e-9);
  EXPECT_EQ(window_.frame()->impact_count, 1);
  EXPECT_NEAR(window_.frame()->totals.momentum.x(), -0.5, 1e-12);
  EXPECT_FALSE(window_.isWindowModified());
  EXPECT_EQ(marked_experiment(), "head-on");
  EXPECT_TRUE(boxes_.empty());
}

TEST_F(LabWindowTest, BadFileIsToldAndTheOldSceneStays) {
  window_.run_until(0.2);
  const QString file = folder_.filePath("bad.json");
  QFile bad(file);
  ASSERT_TRUE(bad.open(QIODevice::WriteOnly));
  bad.write(R"({"format": "carom-preset", "version": 1, "title": "<b>", "colour": 1})");
  bad.close();
  EXPECT_FALSE(window_.open(file.toStdString()));
  ASSERT_TRUE(wait_for_boxes(1));
  EXPECT_TRUE(boxes_[0].contains("bad.json") && boxes_[0].contains("/colour")) << boxes_[0].toStdString();
  EXPECT_EQ(window_.preset().title, read_preset(CAROM_PRESET_DIR "/first-collisions/head-on.json").title);
  window_.run_until(0.4);
  EXPECT_NEAR(time(), 0.4, 1e-9);
  EXPECT_EQ(window_.frame()->bodies->size(), 2U);
  EXPECT_FALSE(window_.open("no-such-experiment"));
  EXPECT_TRUE(wait_for_boxes(2));
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
  EXPECT_EQ(button("What holds bodies that touch")->text(), "impulses only ▾");
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
  EXPECT_TRUE(chip("What is modelled")->toolTip().contains("as repeated impacts"));

  const QToolButton* choice = button("What holds bodies that touch");
  QAction* lasting = choice->menu()->actions().back();
  EXPECT_TRUE(lasting->toolTip().contains("static and kinetic friction"));
  lasting->trigger();
  EXPECT_EQ(choice->text(), "contacts that last ▾");
  EXPECT_FALSE(chip("What is modelled")->toolTip().contains("as repeated impacts"));
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

TEST_F(LabWindowTest, TheToolBarIsWholeInANarrowWindow) {
  action("Dormand-Prince 5(4), adaptive")->trigger();
  const QToolButton* impacts = button("When impacts are resolved");
  EXPECT_LE(window_.minimumWidth(), 900);
  for (const int width : {1280, 1100, 950, 900}) {
    window_.resize(width, 640);
    QApplication::processEvents();
    ASSERT_EQ(window_.width(), width);
    const QToolButton* last = button("Dark colours");
    EXPECT_TRUE(last->isVisible()) << width;
    EXPECT_GT(button("How free motion is advanced")->text().size(), 4) << width;
    EXPECT_LE(last->mapTo(&window_, QPoint(last->width(), 0)).x(), width);
  }
  EXPECT_EQ(impacts->text(), "located ▾");
  window_.resize(1280, 640);
  QApplication::processEvents();
  EXPECT_EQ(impacts->text(), "impacts at their own time ▾");
}

TEST_F(LabWindowTest, TheStepButtonGoesByTheIntegrator) {
  EXPECT_EQ(button("Length of a step")->text(), "h = 5 ms ▾");
  action("Dormand-Prince 5(4), adaptive")->trigger();
  EXPECT_EQ(button("Largest error of a step")->text(), "tolerance 1e−9 ▾");
  action("tolerance 1e−6")->trigger();
  EXPECT_EQ(window_.preset().method.tolerance, 1e-6);
  EXPECT_EQ(button("Largest error of a step")->text(), "tolerance 1e−6 ▾");
  action("Exact flight")->trigger();
  EXPECT_EQ(button("Exact flight needs no step")->text(), "results every 5 ms ▾");
  window_.run_until(1.0);
  EXPECT_NEAR(window_.frame()->totals.momentum.x(), -0.5, 1e-12);
}

TEST_F(LabWindowTest, WhatASceneForbidsIsGreyAndSaysWhy) {
  EXPECT_TRUE(action("Exact flight")->isEnabled());
  ASSERT_TRUE(window_.open("drag-projectile"));
  EXPECT_FALSE(action("Exact flight")->isEnabled());
  EXPECT_TRUE(action("Exact flight")->toolTip().contains("not possible with drag"));
  EXPECT_TRUE(action("RK4")->isEnabled());
  ASSERT_TRUE(window_.open("head-on"));
  EXPECT_TRUE(action("Exact flight")->isEnabled());
}

TEST_F(LabWindowTest, WhatIsModelledIsToldAndAskedAgain) {
  EXPECT_TRUE(chip("What is modelled")->text().startsWith("modelled: normal impulses"));
  EXPECT_TRUE(chip("What is modelled")->toolTip().contains("Not needed by this scene"));
  EXPECT_TRUE(chip("What is modelled")->toolTip().contains("friction"));
  const QString before = chip("What is modelled")->toolTip();
  ASSERT_TRUE(window_.open("drag-projectile"));
  EXPECT_NE(chip("What is modelled")->toolTip(), before);
  EXPECT_TRUE(chip("What is modelled")->toolTip().startsWith("Modelled: normal impulses, gravity"));
  // Nothing extends beyond the scene, however narrow.
  for (const int width : {1280, 900, 700}) {
    window_.resize(width, 640);
    QApplication::processEvents();
    const QLabel* label = chip("What is modelled");
    EXPECT_LE(label->mapTo(&window_.scene_view(), QPoint(label->width(), 0)).x(), window_.scene_view().width())
        << width;
  }
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

TEST_F(LabWindowTest, ClickOnEmptySpaceAddsADisc) {
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
  EXPECT_EQ(window_.preset().scene.bodies.size(), 3U);
  // It survives a restart.
  window_.run_until(0.1);
  click_button("Restart");
  ASSERT_TRUE(wait_for([this] { return time() == 0.0; }));
  EXPECT_EQ(window_.frame()->bodies->size(), 3U);
}

TEST_F(LabWindowTest, SavedFileHoldsWhatWasChanged) {
  const QString file = folder_.filePath("mine.json");
  ASSERT_TRUE(QFile::copy(CAROM_PRESET_DIR "/first-collisions/head-on.json", file));
  ASSERT_TRUE(window_.open(file.toStdString()));
  EXPECT_EQ(marked_experiment(), "");
  click_scene({0.1, 0.4});
  action("Semi-implicit Euler")->trigger();
  ASSERT_TRUE(window_.save());
  EXPECT_FALSE(window_.isWindowModified());
  const Preset saved = read_preset(file.toStdString());
  ASSERT_EQ(saved.scene.bodies.size(), 3U);
  EXPECT_EQ(saved.scene.bodies[2].position, window_.preset().scene.bodies[2].position);
  EXPECT_EQ(saved.scene.bodies[2].name, window_.preset().scene.bodies[2].name);
  EXPECT_EQ(saved.method, window_.preset().method);
  EXPECT_EQ(saved.expect.size(), window_.preset().expect.size());
  EXPECT_TRUE(boxes_.empty());
}

TEST_F(LabWindowTest, BuiltInExperimentIsSavedUnderANewName) {
  click_scene({0.1, 0.4});
  chosen_file_ = folder_.filePath("new");
  EXPECT_FALSE(window_.save()) << "it asks first";
  ASSERT_TRUE(QTest::qWaitFor([&] { return !window_.isWindowModified(); }));
  EXPECT_EQ(read_preset(folder_.filePath("new.json").toStdString()).scene.bodies.size(), 3U);
  EXPECT_EQ(read_preset(CAROM_PRESET_DIR "/first-collisions/head-on.json").scene.bodies.size(), 2U);
}

TEST_F(LabWindowTest, ReplacingAFileIsAskedFirst) {
  const QString file = folder_.filePath("mine.json");
  ASSERT_TRUE(QFile::copy(CAROM_PRESET_DIR "/piles/pile.json", file));
  for (const char* typed : {"mine.json", "mine"}) {
    chosen_file_ = folder_.filePath(typed);
    button_ = QMessageBox::No;
    boxes_.clear();
    EXPECT_FALSE(window_.save()) << typed;
    EXPECT_TRUE(wait_for_boxes(1)) << typed;
    EXPECT_EQ(read_preset(file.toStdString()).title, read_preset(CAROM_PRESET_DIR "/piles/pile.json").title)
        << typed;
  }
}

TEST_F(LabWindowTest, UnwritableFileIsTold) {
  const QString file = folder_.filePath("gone/mine.json");
  ASSERT_TRUE(QDir(folder_.path()).mkdir("gone"));
  ASSERT_TRUE(QFile::copy(CAROM_PRESET_DIR "/first-collisions/head-on.json", file));
  ASSERT_TRUE(window_.open(file.toStdString()));
  click_scene({0.1, 0.4});
  ASSERT_TRUE(QDir(folder_.filePath("gone")).removeRecursively());
  EXPECT_FALSE(window_.save());
  ASSERT_TRUE(wait_for_boxes(1));
  EXPECT_TRUE(boxes_[0].contains("mine.json"));
  EXPECT_TRUE(window_.isWindowModified());
}

TEST_F(LabWindowTest, PlaysPausesStepsAndRestarts) {
  click_button("Play");
  ASSERT_TRUE(wait_for([this] { return window_.frame()->playing && time() > 0.05; }));
  click_button("Play");
  ASSERT_TRUE(wait_for([this] { return !window_.frame()->playing; }));
  const double paused = time();
  const std::int64_t before = steps();
  QTest::qWait(100);
  EXPECT_EQ(time(), paused);
  EXPECT_LT(paused, 1.0);
  click_button("One step");
  ASSERT_TRUE(wait_for([&] { return steps() != before; }));
  QTest::qWait(50);
  EXPECT_EQ(steps(), before + 1);
  EXPECT_NEAR(time(), paused + 0.005, 1e-12);
  click_button("Restart");
  ASSERT_TRUE(wait_for([this] { return time() == 0.0; }));
  EXPECT_EQ(steps(), 0);
  EXPECT_FALSE(window_.frame()->playing);
  EXPECT_FALSE(window_.isWindowModified());
}

TEST_F(LabWindowTest, KeysPlayStepAndRestart) {
  QTest::keyClick(&window_.scene_view(), Qt::Key_Period);
  ASSERT_TRUE(wait_for([this] { return steps() == 1; }));
  QTest::keyClick(&window_.scene_view(), Qt::Key_Space);
  ASSERT_TRUE(wait_for([this] { return window_.frame()->playing && time() > 0.02; }));
  QTest::keyClick(&window_.scene_view(), Qt::Key_Space);
  ASSERT_TRUE(wait_for([this] { return !window_.frame()->playing; }));
  QTest::keyClick(&window_.scene_view(), Qt::Key_R);
  EXPECT_TRUE(wait_for([this] { return time() == 0.0; }));
}

TEST_F(LabWindowTest, PlayStopsAtTheEndAndGoesOnFromThere) {
  window_.run_until(0.97);
  click_button("Play");
  ASSERT_TRUE(wait_for([this] { return time() > 0.99 && !window_.frame()->playing; }));
  EXPECT_NEAR(time(), 1.0, 1e-9);
  click_button("Play");
  EXPECT_TRUE(wait_for([this] { return time() > 1.02; }));
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

TEST_F(LabWindowTest, ClickInTheListOpensAnExperiment) {
  window_.run_until(0.5);
  click_experiment("newtons-cradle");
  EXPECT_EQ(marked_experiment(), "newtons-cradle");
  EXPECT_EQ(window_.preset().title,
            read_preset(CAROM_PRESET_DIR "/chains-and-cradles/newtons-cradle.json").title);
  ASSERT_TRUE(wait_for([this] { return window_.frame()->bodies->size() == 5; }));
  EXPECT_EQ(time(), 0.0);
  EXPECT_TRUE(boxes_.empty());
}

TEST_F(LabWindowTest, NewExperimentRunsToItsOwnTime) {
  window_.run_until(1.0);
  ASSERT_TRUE(window_.open("newtons-cradle"));
  window_.run_until(0.5);
  EXPECT_NEAR(time(), 0.5, 1e-9);
  EXPECT_EQ(window_.frame()->bodies->size(), 5U);
}

TEST_F(LabWindowTest, ChangesAreAskedAboutBeforeAnotherExperiment) {
  click_scene({0.1, 0.4});
  button_ = QMessageBox::Cancel;
  click_experiment("glancing");
  EXPECT_TRUE(wait_for_boxes(1));
  EXPECT_EQ(window_.preset().scene.bodies.size(), 3U);
  EXPECT_TRUE(window_.isWindowModified());
  EXPECT_EQ(marked_experiment(), "head-on");
  button_ = QMessageBox::Discard;
  click_experiment("glancing");
  EXPECT_TRUE(wait_for_boxes(2));
  EXPECT_EQ(window_.preset().title, read_preset(CAROM_PRESET_DIR "/first-collisions/glancing.json").title);
  EXPECT_FALSE(window_.isWindowModified());
  EXPECT_EQ(marked_experiment(), "glancing");
}

TEST_F(LabWindowTest, ChangesAreAskedAboutBeforeTheWindowCloses) {
  action("Explicit Euler")->trigger();
  button_ = QMessageBox::Cancel;
  EXPECT_FALSE(window_.close());
  EXPECT_TRUE(wait_for_boxes(1));
  EXPECT_TRUE(window_.isVisible());
  button_ = QMessageBox::Discard;
  EXPECT_FALSE(window_.close()) << "it asks first";
  EXPECT_TRUE(QTest::qWaitFor([&] { return !window_.isVisible(); }));
  EXPECT_EQ(boxes_.size(), 2U);
}

// Saved on closing, under a name from the dialog.
TEST_F(LabWindowTest, ChangesAreSavedBeforeTheWindowCloses) {
  action("Explicit Euler")->trigger();
  button_ = QMessageBox::Save;
  chosen_file_ = folder_.filePath("last.json");
  EXPECT_FALSE(window_.close());
  ASSERT_TRUE(QTest::qWaitFor([&] { return !window_.isVisible(); }));
  EXPECT_EQ(read_preset(folder_.filePath("last.json").toStdString()).method.integrator,
            IntegratorId::kExplicitEuler);
}

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
  EXPECT_TRUE(action("Undo change of plots")->isEnabled());
  trigger(undo);
  EXPECT_FALSE(plots->shows("ledger"));
  EXPECT_TRUE(action("Redo change of plots")->isEnabled());
  EXPECT_TRUE(action("Undo added body")->isEnabled());
  trigger(undo);
  ASSERT_TRUE(wait_for([this] { return window_.frame()->bodies->size() == 2; }));
  EXPECT_EQ(window_.preset().scene.bodies.size(), 2U);
  EXPECT_TRUE(window_.isWindowModified());
  trigger(undo);
  EXPECT_FALSE(window_.isWindowModified());
  EXPECT_EQ(button("How free motion is advanced")->text(), "RK4 ▾");
  ASSERT_TRUE(wait_for([this] { return window_.frame()->log->edits.empty(); }));
  EXPECT_NEAR(time(), 0.1, 1e-9);
  for (int i = 0; i < 3; ++i) trigger(redo);
  EXPECT_TRUE(plots->shows("ledger"));
  EXPECT_TRUE(window_.isWindowModified());
  ASSERT_TRUE(wait_for([this] { return window_.frame()->log->edits.size() == 2; }));
}

// A plot keeps its notes and its zoom where another plot is added or removed.
TEST_F(LabWindowTest, UndoOfANoteLeavesThePlotsAsTheyAre) {
  auto* plots = window_.findChild<PlotPanel*>();
  RunPlot* first = plots->plots().front();
  first->set_notes({{0.5, 1.0, "here"}});
  emit plots->layoutChanged();
  EXPECT_TRUE(window_.isWindowModified());
  action("Undo change of notes")->trigger();
  EXPECT_EQ(plots->plots().front(), first);
  EXPECT_TRUE(first->content().plot.notes.empty());
  EXPECT_FALSE(window_.isWindowModified());
  action("Redo change of notes")->trigger();
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
  EXPECT_TRUE(QTest::qWaitFor([&] { return shown("The run is lost at t = "); }, 5000));
  QTest::keyClick(&window_, Qt::Key_R);
  ASSERT_TRUE(wait_for([this] { return steps() == 0 && !window_.frame()->lost; }));
  EXPECT_TRUE(QTest::qWaitFor([&] { return !shown("The run is lost"); }, 5000));
}

}  // namespace
}  // namespace carom
