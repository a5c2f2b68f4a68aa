#include <QDir>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QFile>
#include <QMimeData>
#include <QTabWidget>
#include <QTemporaryDir>
#include <algorithm>
#include <gtest/gtest.h>

#include "physics/preset/preset.h"
#include "physics/preset/preset_file.h"
#include "tests/app/lab/lab_fixture.h"
#include "tests/support/source_folder.h"
#include "tests/support/wait_events.h"

namespace carom {
namespace {

// Opening, saving and closing, with the questions that they ask.
class LabFilesTest : public LabWindowTest {
 protected:
  // A file with a change, whose folder is gone.
  void open_what_will_be_gone() {
    const QString file = folder_.filePath("gone/mine.json");
    ASSERT_TRUE(QDir(folder_.path()).mkdir("gone"));
    ASSERT_TRUE(QFile::copy(test::preset_file("first-collisions/head-on.json").c_str(), file));
    ASSERT_TRUE(window_.open(file.toStdString()));
    click_scene({0.1, 0.4});
    ASSERT_TRUE(QDir(folder_.filePath("gone")).removeRecursively());
  }
};

TEST_F(LabFilesTest, BadFileIsReportedAndTheOldSceneStays) {
  window_.run_until(0.2);
  const QString file = folder_.filePath("bad.json");
  QFile bad(file);
  ASSERT_TRUE(bad.open(QIODevice::WriteOnly));
  bad.write(R"({"format": "carom-preset", "version": 1, "title": "<b>", "colour": 1})");
  bad.close();
  EXPECT_FALSE(window_.open(file.toStdString()));
  ASSERT_TRUE(wait_for_boxes(1));
  EXPECT_TRUE(boxes_[0].contains("bad.json") && boxes_[0].contains("/colour")) << boxes_[0].toStdString();
  EXPECT_EQ(window_.preset().title, read_preset(test::preset_file("first-collisions/head-on.json")).title);
  window_.run_until(0.4);
  EXPECT_NEAR(time(), 0.4, 1e-9);
  EXPECT_EQ(window_.frame()->bodies->size(), 2U);
  EXPECT_FALSE(window_.open("no-such-experiment"));
  EXPECT_TRUE(wait_for_boxes(2));
}

TEST_F(LabFilesTest, SavedFileHoldsWhatWasChanged) {
  const QString file = folder_.filePath("mine.json");
  ASSERT_TRUE(QFile::copy(test::preset_file("first-collisions/head-on.json").c_str(), file));
  ASSERT_TRUE(window_.open(file.toStdString()));
  EXPECT_EQ(marked_experiment(), "");
  click_scene({0.1, 0.4});
  action("Semi-implicit Euler")->trigger();
  ASSERT_TRUE(window_.save());
  EXPECT_FALSE(window_.isWindowModified());
  const Preset saved = read_preset(file.toStdString());
  ASSERT_EQ(saved.scene.bodies.size(), 3U) << "it belongs to the start";
  EXPECT_EQ(saved.scene.bodies[2].position, window_.preset().scene.bodies[2].position);
  EXPECT_EQ(saved.scene.bodies[2].name, window_.preset().scene.bodies[2].name);
  EXPECT_EQ(saved.method, window_.preset().method);
  EXPECT_EQ(saved.expect.size(), window_.preset().expect.size());
  EXPECT_TRUE(boxes_.empty());
}

TEST_F(LabFilesTest, BuiltInExperimentIsSavedUnderANewName) {
  click_scene({0.1, 0.4});
  chosen_file_ = folder_.filePath("new");
  EXPECT_FALSE(window_.save()) << "it asks first";
  ASSERT_TRUE(test::wait_in_event_loop([&] { return !window_.isWindowModified(); }));
  EXPECT_EQ(all_bodies(read_preset(folder_.filePath("new.json").toStdString())).size(), 3U);
  EXPECT_EQ(read_preset(test::preset_file("first-collisions/head-on.json")).scene.bodies.size(), 2U);
}

TEST_F(LabFilesTest, ReplacingAFileIsAskedFirst) {
  const QString file = folder_.filePath("mine.json");
  ASSERT_TRUE(QFile::copy(test::preset_file("piles/pile.json").c_str(), file));
  for (const char* typed : {"mine.json", "mine"}) {
    chosen_file_ = folder_.filePath(typed);
    button_ = QMessageBox::No;
    boxes_.clear();
    EXPECT_FALSE(window_.save()) << typed;
    EXPECT_TRUE(wait_for_boxes(1)) << typed;
    EXPECT_EQ(read_preset(file.toStdString()).title, read_preset(test::preset_file("piles/pile.json")).title)
        << typed;
  }
}

TEST_F(LabFilesTest, UnwritableFileIsReported) {
  ASSERT_NO_FATAL_FAILURE(open_what_will_be_gone());
  EXPECT_FALSE(window_.save());
  ASSERT_TRUE(wait_for_boxes(1));
  EXPECT_TRUE(boxes_[0].contains("mine.json"));
  EXPECT_TRUE(window_.isWindowModified());
}

// Where the file cannot be written.
TEST_F(LabFilesTest, AnotherNameIsOffered) {
  ASSERT_NO_FATAL_FAILURE(open_what_will_be_gone());
  chosen_file_ = folder_.filePath("kept.json");
  offer_ = "Save as...";
  EXPECT_FALSE(window_.save());
  ASSERT_TRUE(test::wait_in_event_loop([&] { return !window_.isWindowModified(); }));
  EXPECT_EQ(all_bodies(read_preset(folder_.filePath("kept.json").toStdString())).size(), 3U);
}

TEST_F(LabFilesTest, TheTitleNamesTheFileAndSavingIsSaid) {
  EXPECT_TRUE(window_.windowTitle().startsWith("Head-on")) << window_.windowTitle().toStdString();
  click_scene({0.1, 0.4});
  chosen_file_ = folder_.filePath("lesson.json");
  EXPECT_FALSE(window_.save());
  ASSERT_TRUE(test::wait_in_event_loop([&] { return !window_.isWindowModified(); }));
  EXPECT_TRUE(window_.windowTitle().startsWith("lesson.json – Head-on")) << window_.windowTitle().toStdString();
  const QList<QLabel*> chips = window_.findChildren<QLabel*>("chip");
  EXPECT_TRUE(std::any_of(chips.begin(), chips.end(), [](const QLabel* chip) {
    return chip->isVisible() && chip->text().contains("saved as lesson.json");
  }));
}

// A name from the title is suggested: of letters and digits alone.
TEST_F(LabFilesTest, SavingSuggestsAName) {
  const auto suggested = [this] {
    QString name;
    window_.save();
    EXPECT_TRUE(test::wait_in_event_loop([&] {
      for (auto* dialog : window_.findChildren<QFileDialog*>())
        name = QFileInfo(dialog->selectedFiles().value(0)).fileName();
      return !name.isEmpty();
    }));
    EXPECT_TRUE(test::wait_in_event_loop([&] { return window_.findChildren<QFileDialog*>().isEmpty(); }));
    return name;
  };
  EXPECT_EQ(suggested(), "head-on.json");
  Preset preset = window_.preset();
  preset.title = "Two carts: e = 1/2!";
  window_.show_scene(preset, {}, {});
  EXPECT_EQ(suggested(), "two-carts-e-1-2.json");
  preset.title = "???";
  window_.show_scene(preset, {}, {});
  EXPECT_EQ(suggested(), "experiment.json");
}

TEST_F(LabFilesTest, ADroppedFileIsOpened) {
  const auto drop = [this](const QList<QUrl>& urls) {
    QMimeData data;
    data.setUrls(urls);
    QDragEnterEvent enter({40, 40}, Qt::CopyAction, &data, Qt::LeftButton, {});
    QApplication::sendEvent(&window_, &enter);
    if (!enter.isAccepted()) return false;
    QDropEvent event({40, 40}, Qt::CopyAction, &data, Qt::LeftButton, {});
    QApplication::sendEvent(&window_, &event);
    return true;
  };
  const QUrl file = QUrl::fromLocalFile(test::preset_file("chains-and-cradles/newtons-cradle.json").c_str());
  EXPECT_FALSE(drop({file, file}));
  EXPECT_FALSE(drop({QUrl("https://example.org/a.json")}));
  EXPECT_TRUE(drop({file}));
  ASSERT_TRUE(wait_for([this] { return window_.frame()->bodies->size() == 5; }));
}

// The drawer of an experiment without a comparison is not left on it.
TEST_F(LabFilesTest, TheDrawerFollowsTheExperiment) {
  const auto* tabs = window_.findChild<QTabWidget*>();
  ASSERT_TRUE(window_.open("drag-projectile"));
  EXPECT_EQ(tabs->tabText(tabs->currentIndex()), "Compare");
  ASSERT_TRUE(window_.open("head-on"));
  EXPECT_EQ(tabs->currentIndex(), 0);
}

TEST_F(LabFilesTest, ChangesAreAskedAboutBeforeAnotherExperiment) {
  click_scene({0.1, 0.4});
  button_ = QMessageBox::Cancel;
  click_experiment("glancing");
  EXPECT_TRUE(wait_for_boxes(1));
  EXPECT_EQ(all_bodies(window_.preset()).size(), 3U);
  EXPECT_TRUE(window_.isWindowModified());
  EXPECT_EQ(marked_experiment(), "head-on");
  button_ = QMessageBox::Discard;
  click_experiment("glancing");
  EXPECT_TRUE(wait_for_boxes(2));
  EXPECT_EQ(window_.preset().title, read_preset(test::preset_file("first-collisions/glancing.json")).title);
  EXPECT_FALSE(window_.isWindowModified());
  EXPECT_EQ(marked_experiment(), "glancing");
}

TEST_F(LabFilesTest, ChangesAreAskedAboutBeforeTheWindowCloses) {
  action("Explicit Euler")->trigger();
  button_ = QMessageBox::Cancel;
  EXPECT_FALSE(window_.close());
  EXPECT_TRUE(wait_for_boxes(1));
  EXPECT_TRUE(window_.isVisible());
  button_ = QMessageBox::Discard;
  EXPECT_FALSE(window_.close()) << "it asks first";
  EXPECT_TRUE(test::wait_in_event_loop([&] { return !window_.isVisible(); }));
  EXPECT_EQ(boxes_.size(), 2U);
}

TEST_F(LabFilesTest, ChangesAreSavedBeforeTheWindowCloses) {
  action("Explicit Euler")->trigger();
  button_ = QMessageBox::Save;
  chosen_file_ = folder_.filePath("last.json");
  EXPECT_FALSE(window_.close());
  ASSERT_TRUE(test::wait_in_event_loop([&] { return !window_.isVisible(); }));
  EXPECT_EQ(read_preset(folder_.filePath("last.json").toStdString()).method.integrator,
            IntegratorId::kExplicitEuler);
}

}  // namespace
}  // namespace carom
