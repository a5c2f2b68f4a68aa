#include <QLabel>
#include <QTest>
#include <gtest/gtest.h>

#include "physics/preset/preset.h"
#include "physics/preset/preset_file.h"
#include "tests/app/lab/lab_fixture.h"
#include "tests/support/source_folder.h"
#include "tests/support/wait_events.h"
#include "widgets/run/experiment_preview.h"

// The list of experiments in the window, and the preview of what it marks.
namespace carom {
namespace {

using LabListTest = LabWindowTest;

// Below 1600 px the list is over the scene, and gone once an experiment is chosen; a wide window keeps it.
TEST_F(LabListTest, TheListOpensOverTheSceneAndCloses) {
  auto* experiments = window_.findChild<ExperimentList*>();
  EXPECT_FALSE(experiments->isVisible());
  QTest::keyClick(&window_.scene_view(), Qt::Key_E);
  ASSERT_TRUE(experiments->isVisible());
  auto* search = experiments->findChild<QLineEdit*>();
  EXPECT_EQ(QApplication::focusWidget(), search);
  QTest::keyClicks(search, "no such thing");
  ASSERT_EQ(list()->count(), 1);
  EXPECT_EQ(list()->item(0)->flags(), Qt::NoItemFlags) << "it says that there is none";
  search->clear();
  QTest::keyClicks(search, "glancing");
  QTest::keyClick(search, Qt::Key_Return);
  EXPECT_EQ(search->text(), "") << "the next search begins anew";
  ASSERT_TRUE(wait_for([this] { return window_.session().name() == "glancing"; }));
  EXPECT_FALSE(experiments->isVisible());
  EXPECT_EQ(QApplication::focusWidget(), &window_.scene_view());
  QTest::keyClick(&window_.scene_view(), Qt::Key_E);
  QTest::keyClick(search, Qt::Key_Escape);
  EXPECT_FALSE(experiments->isVisible());
  window_.resize(1700, 900);
  EXPECT_TRUE(experiments->isVisible());
  QTest::keyClick(search, Qt::Key_Escape);
  EXPECT_TRUE(experiments->isVisible());
  for (int i = 0; i < 2; ++i) {
    window_.scene_view().setFocus();
    QTest::keyClick(&window_.scene_view(), Qt::Key_E);
    EXPECT_EQ(QApplication::focusWidget(), search) << "E goes to its search";
    EXPECT_TRUE(experiments->isVisible());
  }
  QAction* beside = action("Experiments beside the scene");
  beside->trigger();
  EXPECT_FALSE(experiments->isVisible()) << "it opens over the scene again";
  QTest::keyClick(&window_.scene_view(), Qt::Key_E);
  EXPECT_TRUE(experiments->isVisible());
  QTest::keyClick(search, Qt::Key_Escape);
  EXPECT_FALSE(experiments->isVisible());
  action("Standard layout")->trigger();
  EXPECT_TRUE(experiments->isVisible());
  EXPECT_TRUE(beside->isEnabled());
  window_.resize(1300, 800);
  EXPECT_FALSE(experiments->isVisible());
  EXPECT_FALSE(beside->isEnabled());
}

// Others that speak of the words stand before it in the list.
TEST_F(LabListTest, EnterOpensTheExperimentWhoseTitleIsTyped) {
  auto* search = window_.findChild<ExperimentList*>()->findChild<QLineEdit*>();
  for (const auto& [words, name] : {std::pair("pile on", "pile"), std::pair("one ball", "ball-in-a-box")}) {
    QTest::keyClick(&window_.scene_view(), Qt::Key_E);
    QTest::keyClicks(search, words);
    ASSERT_NE(list()->currentItem(), nullptr) << "it is marked";
    QTest::keyClick(search, Qt::Key_Return);
    EXPECT_TRUE(wait_for([&, name = name] { return window_.session().name() == name; })) << words;
  }
}

// The start of the marked experiment is seen; run, undo and unsaved work are left alone.
TEST_F(LabListTest, ArrowsInTheListShowTheExperimentUnderTheMark) {
  ASSERT_TRUE(window_.open("head-on"));
  ASSERT_TRUE(wait_for([this] { return window_.frame() != nullptr; }));
  ASSERT_FALSE(window_.session().add_body(0.0, 5.0).empty());
  window_.run_until(0.5);
  const auto time = [this] { return window_.session().runs().shown_time(); };
  const double shown = time();
  const int edits = window_.session().edits().count();
  auto* search = window_.findChild<ExperimentList*>()->findChild<QLineEdit*>();
  auto* preview = window_.findChild<ExperimentPreview*>();
  QTest::keyClick(&window_.scene_view(), Qt::Key_E);
  QTest::keyClick(search, Qt::Key_Down);
  const QString next = list()->currentItem()->data(Qt::UserRole).toString();
  EXPECT_NE(next, "head-on");
  EXPECT_FALSE(preview->isVisible()) << "while the key may come again";
  ASSERT_TRUE(wait_for([&] { return preview->isVisible(); }));
  EXPECT_EQ(QApplication::focusWidget(), search);
  EXPECT_EQ(list()->currentItem()->data(Qt::UserRole).toString(), next);
  EXPECT_EQ(window_.session().name(), "head-on");
  QTest::keyClick(search, Qt::Key_Up);
  ASSERT_TRUE(wait_for([&] { return !preview->isVisible(); })) << "the open one";
  QTest::keyClick(search, Qt::Key_Down);
  ASSERT_TRUE(wait_for([&] { return preview->isVisible(); }));
  QTest::keyClick(search, Qt::Key_Escape);
  EXPECT_FALSE(preview->isVisible());
  EXPECT_EQ(window_.session().name(), "head-on");
  EXPECT_EQ(window_.session().edits().count(), edits);
  EXPECT_EQ(time(), shown);
  EXPECT_TRUE(window_.isWindowModified());
  EXPECT_TRUE(window_.findChildren<QMessageBox*>().isEmpty());
}

TEST_F(LabListTest, EnterOrAClickOpensThePreviewedExperiment) {
  auto* search = window_.findChild<ExperimentList*>()->findChild<QLineEdit*>();
  auto* preview = window_.findChild<ExperimentPreview*>();
  for (const bool click : {false, true}) {
    ASSERT_TRUE(window_.open("head-on"));
    QTest::keyClick(&window_.scene_view(), Qt::Key_E);
    QTest::keyClick(search, Qt::Key_Down);
    const QString next = list()->currentItem()->data(Qt::UserRole).toString();
    ASSERT_TRUE(wait_for([&] { return preview->isVisible(); }));
    if (click) {
      QTest::mouseClick(preview, Qt::LeftButton);
    } else {
      QTest::keyClick(search, Qt::Key_Return);
    }
    EXPECT_FALSE(preview->isVisible());
    EXPECT_EQ(window_.session().name(), next);
  }
}

TEST_F(LabListTest, WhatTheSearchMarksIsPreviewed) {
  ASSERT_TRUE(window_.open("head-on"));
  auto* search = window_.findChild<ExperimentList*>()->findChild<QLineEdit*>();
  auto* preview = window_.findChild<ExperimentPreview*>();
  QTest::keyClick(&window_.scene_view(), Qt::Key_E);
  QTest::keyClicks(search, "glancing");
  ASSERT_TRUE(wait_for([&] { return preview->isVisible(); }));
  search->clear();
  ASSERT_TRUE(wait_for([&] { return !preview->isVisible(); })) << "the open one is marked";
  QTest::keyClicks(search, "glancing");
  ASSERT_TRUE(wait_for([&] { return preview->isVisible(); }));
  ASSERT_TRUE(window_.open("bouncing-ball"));
  EXPECT_FALSE(preview->isVisible()) << "as by a file that is dropped";
}

// It would cover what the user has gone to.
TEST_F(LabListTest, APreviewDoesNotComeOnceTheListIsLeft) {
  ASSERT_TRUE(window_.open("head-on"));
  auto* search = window_.findChild<ExperimentList*>()->findChild<QLineEdit*>();
  QTest::keyClick(&window_.scene_view(), Qt::Key_E);
  QTest::keyClick(search, Qt::Key_Down);
  window_.scene_view().setFocus();
  QTest::qWait(400);
  EXPECT_FALSE(window_.findChild<ExperimentPreview*>()->isVisible());
}

TEST_F(LabListTest, TheBestMatchStaysMarkedWhenTheWindowIsResized) {
  ASSERT_TRUE(window_.open("head-on"));
  auto* search = window_.findChild<ExperimentList*>()->findChild<QLineEdit*>();
  QTest::keyClick(&window_.scene_view(), Qt::Key_E);
  QTest::keyClicks(search, "glancing");
  const QString best = list()->currentItem()->data(Qt::UserRole).toString();
  window_.resize(window_.size() + QSize(20, 10));
  QTest::qWait(50);
  EXPECT_EQ(list()->currentItem()->data(Qt::UserRole).toString(), best);
}

// It is left with the mouse as well.
TEST_F(LabListTest, APreviewGoesWhenTheMouseIsPressedElsewhere) {
  ASSERT_TRUE(window_.open("head-on"));
  auto* search = window_.findChild<ExperimentList*>()->findChild<QLineEdit*>();
  auto* preview = window_.findChild<ExperimentPreview*>();
  QTest::keyClick(&window_.scene_view(), Qt::Key_E);
  QTest::keyClick(search, Qt::Key_Down);
  ASSERT_TRUE(wait_for([&] { return preview->isVisible(); }));
  QTest::mouseClick(window_.findChild<TransportBar*>(), Qt::LeftButton);
  EXPECT_FALSE(preview->isVisible());
  EXPECT_EQ(window_.session().name(), "head-on");
  EXPECT_EQ(list()->currentItem()->data(Qt::UserRole).toString(), "head-on");
}

// Words may stand anywhere in what is said of an experiment.
TEST_F(LabListTest, TheListIsSearchedByWords) {
  auto* search = window_.findChild<ExperimentList*>()->findChild<QLineEdit*>();
  const auto found = [&](const QString& words) {
    search->setText(words);
    QStringList names;
    for (int row = 0; row < list()->count(); ++row) {
      const QString name = list()->item(row)->data(Qt::UserRole).toString();
      if (!name.isEmpty()) names << name;
    }
    return names;
  };
  const qsizetype all = found({}).size();
  for (const char* word : {"elastic", "restitution", "momentum"}) {
    EXPECT_GT(found(word).size(), 3) << word;
    EXPECT_LT(found(word).size(), all / 2) << word;
  }
  EXPECT_EQ(found("  Glancing ELASTIC "), QStringList{"glancing"});
  for (const char* name : {"bouncing-ball", "head-on", "rough-bounce", "stacked-drop"})
    EXPECT_TRUE(found("restitution").contains(name)) << name;
  EXPECT_EQ(found("restit"), found("restitution")) << "while it is typed";
  EXPECT_TRUE(found("elastic no-such-word").isEmpty());
}

TEST_F(LabListTest, ClickInTheListOpensAnExperiment) {
  window_.run_until(0.5);
  click_experiment("newtons-cradle");
  EXPECT_EQ(marked_experiment(), "newtons-cradle");
  EXPECT_EQ(window_.preset().title,
            read_preset(test::preset_file("chains-and-cradles/newtons-cradle.json")).title);
  ASSERT_TRUE(wait_for([this] { return window_.frame()->bodies->size() == 5; }));
  EXPECT_EQ(time(), 0.0);
  EXPECT_TRUE(boxes_.empty());
}

}  // namespace
}  // namespace carom
