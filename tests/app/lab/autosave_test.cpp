#include "app/lab/autosave.h"

#include <QAction>
#include <QApplication>
#include <QDir>
#include <QFile>
#include <QLabel>
#include <QMessageBox>
#include <QProcess>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTest>
#include <QThread>
#include <QTimer>
#include <algorithm>
#include <csignal>
#include <gtest/gtest.h>
#include <random>
#include <utility>
#include <vector>

#include "app/lab/lab_window.h"
#include "app/lab/notice_bar.h"
#include "app/library/preset_library.h"
#include "physics/preset/preset.h"
#include "physics/preset/preset_file.h"
#include "tests/app/lab/late_discs.h"
#include "tests/app/lab/seen_run.h"
#include "tests/support/effort.h"
#include "tests/support/wait_events.h"
#include "widgets/plot/plot_panel.h"
#include "widgets/plot/run_plot.h"
#include "widgets/scene/scene_view.h"

namespace carom {
namespace {

class AutosaveTest : public testing::Test {
 protected:
  [[nodiscard]] QString kept() const { return folder_.filePath("kept"); }
  [[nodiscard]] QStringList files() const { return QDir(kept()).entryList({"*.json"}, QDir::Files); }

  static std::unique_ptr<LabWindow> lab(const QString& folder) {
    auto window = std::make_unique<LabWindow>(light_theme());
    window->show();
    EXPECT_TRUE(window->open("head-on"));
    window->keep_work(folder);
    EXPECT_TRUE(test::wait_in_event_loop([&] { return window->frame() != nullptr; }));
    return window;
  }
  [[nodiscard]] QByteArray bytes(const QString& name) const {
    QFile file(kept() + "/" + name);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
  }
  static void add_body(LabWindow& window) { emit window.scene_view().spawnRequested(0.3, 1.0); }
  static NoticeBar* bar(const LabWindow& window) { return window.findChild<NoticeBar*>("notice"); }
  static QString said(const LabWindow& window) { return bar(window)->findChild<QLabel*>()->text(); }
  static void click(const LabWindow& window, const QString& text) {
    for (auto* button : bar(window)->findChildren<QPushButton*>()) {
      if (button->text() == text) button->click();
    }
  }
  // The remains of a killed process: its file, and a lock with the id of a dead process.
  void leave_work(const QString& name, const QByteArray& text) const {
    QProcess gone;
    gone.start("true", QStringList());
    const qint64 pid = gone.processId();
    ASSERT_TRUE(gone.waitForFinished());
    QDir().mkpath(kept());
    QFile file(kept() + "/" + name);
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(text);
    QFile lock(file.fileName() + ".lock");
    ASSERT_TRUE(lock.open(QIODevice::WriteOnly));
    lock.write(QByteArray::number(pid) + "\ncarom_app_tests\n" + QSysInfo::machineHostName().toUtf8() +
               "\n\n\n");
  }
  // The parts of the work of a window that adds a body to this experiment, keeps it and is then killed.
  void leave_work_on(const std::string& experiment) const {
    std::vector<std::pair<QString, QByteArray>> parts;
    {
      const auto window = lab(kept());
      ASSERT_TRUE(window->open(experiment));
      ASSERT_TRUE(test::wait_in_event_loop([&] { return window->frame() != nullptr; }));
      add_body(*window);
      window->keep_now();
      for (const QString& name : QDir(kept()).entryList(QDir::Files)) parts.emplace_back(name, bytes(name));
    }
    for (const auto& [name, text] : parts) {
      if (name.endsWith(".json")) leave_work(name, text);
    }
    for (const auto& [name, text] : parts) {
      if (name.endsWith(".json") || name.endsWith(".lock")) continue;
      QFile file(kept() + "/" + name);
      ASSERT_TRUE(file.open(QIODevice::WriteOnly));
      file.write(text);
    }
  }
  static QString last_of_legend(const LabWindow& window) {
    return window.findChild<PlotPanel*>()->plots().front()->legend().back().first;
  }
  void expect_marks_until_first_start() {
    const auto window = lab(kept());
    click(*window, "Restore");
    EXPECT_EQ(last_of_legend(*window), "theory of the first scene");
    window->session().starts().go_to_first();
    EXPECT_EQ(last_of_legend(*window), "theory");
  }
  static QByteArray work(const std::string& title) {
    Preset preset = read_preset(find_preset("head-on"));
    preset.title = title;
    return QByteArray::fromStdString(write_preset(preset));
  }
  QTemporaryDir folder_;
};

TEST_F(AutosaveTest, KeepsEditsUntilTheyAreSavedOrGivenUp) {
  const auto window = lab(kept());
  window->keep_now();
  EXPECT_TRUE(files().isEmpty()) << "nothing was changed";
  add_body(*window);
  window->findChild<PlotPanel*>()->set_shown("drift", true);
  window->keep_now();
  ASSERT_EQ(files().size(), 1);
  const QString file = kept() + "/" + files().constFirst();
  const Preset preset = read_preset(file.toStdString());
  EXPECT_EQ(all_bodies(preset).size(), all_bodies(window->preset()).size());
  EXPECT_EQ(preset.plots, window->preset().plots);
  QTimer::singleShot(0, [] {
    auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
    ASSERT_NE(box, nullptr);
    box->button(QMessageBox::Discard)->click();
  });
  window->close();
  EXPECT_TRUE(test::wait_in_event_loop([&] { return !window->isVisible(); }));
  EXPECT_TRUE(QDir(kept()).entryList(QDir::Files).isEmpty());
}

TEST_F(AutosaveTest, WritesNothingWhereNothingIsNew) {
  const auto window = lab(kept());
  add_body(*window);
  window->keep_now();
  ASSERT_EQ(files().size(), 1);
  const QString file = kept() + "/" + files().constFirst();
  QFile::remove(file);
  window->keep_now();
  EXPECT_FALSE(QFile::exists(file));
  add_body(*window);
  window->keep_now();
  EXPECT_TRUE(QFile::exists(file));
}

// After an undo of all work nothing is kept; after a redo it is.
TEST_F(AutosaveTest, FollowsUndoAndRedo) {
  const auto window = lab(kept());
  add_body(*window);
  window->keep_now();
  ASSERT_EQ(files().size(), 1);
  window->session().edits().undo();
  EXPECT_TRUE(files().isEmpty());
  window->session().edits().redo();
  window->keep_now();
  ASSERT_EQ(files().size(), 1);
  EXPECT_EQ(all_bodies(read_preset((kept() + "/" + files().constFirst()).toStdString())).size(), 3U);
}

TEST_F(AutosaveTest, TheNextStartOffersTheWork) {
  leave_work("work-1-0.json", work("Lost work"));
  const auto window = lab(kept());
  ASSERT_TRUE(bar(*window)->isVisible());
  EXPECT_TRUE(said(*window).contains("“Lost work”")) << said(*window).toStdString();
  EXPECT_NE(window->preset().title, "Lost work");
  click(*window, "Restore");
  EXPECT_EQ(window->preset().title, "Lost work");
  EXPECT_TRUE(window->isWindowModified());
  EXPECT_FALSE(bar(*window)->isVisible());
  EXPECT_FALSE(files().contains("work-1-0.json"));
  EXPECT_EQ(files().size(), 1) << "kept as this window's own";
}

// The window was killed while it played on: discs that were added on the way come in as they were seen to.
TEST_F(AutosaveTest, WorkOfAKilledWindowRunsAsItDid) {
  Session seen;
  const Preset preset = late_discs_preset();
  seen.open(preset, preset.plots, {}, {}, {});
  add_late_discs(seen);

  QProcess killed;
  killed.start(QCoreApplication::applicationFilePath(), {"--keep-late-discs", kept()});
  ASSERT_TRUE(killed.waitForStarted());
  while (!killed.canReadLine()) ASSERT_TRUE(killed.waitForReadyRead(600'000));
  ASSERT_EQ(killed.readLine(), "kept\n");
  kill(static_cast<pid_t>(killed.processId()), SIGKILL);
  ASSERT_TRUE(killed.waitForFinished());
  ASSERT_EQ(files().size(), 1);
  const QByteArray left = bytes(files().constFirst());

  const auto window = lab(kept());
  ASSERT_TRUE(bar(*window)->isVisible());
  click(*window, "Restore");
  ASSERT_EQ(files().size(), 1);
  EXPECT_EQ(bytes(files().constFirst()), left) << "kept as it was";
  Session& session = window->session();
  for (const char* how : {"recovered", "begun again"}) {
    SCOPED_TRACE(how);
    session.runs().run_until(kLateDiscsEnd);
    wait_for_late_discs(session);
    expect_same(seen_runs(session.runs()), seen_runs(seen.runs()));
    session.starts().restart();
    ASSERT_TRUE(test::wait_in_event_loop([&] { return session.runs().frame()->time == 0.0; }));
  }
}

TEST_F(AutosaveTest, TheStartsComeBackWithTheWork) {
  const auto names = [](LabWindow& window) {
    QStringList all;
    for (const SessionStarts::Known& known : window.session().starts().known()) all << known.name;
    return all;
  };
  QStringList before;
  QByteArray starts;
  QByteArray left;
  {
    const auto window = lab(kept());
    window->run_until(0.5);
    Body body = window->session().runs().scene()->bodies[0];
    body.position.y() += 0.5;
    window->session().edit({Replace<Body>{body}}, "Move light");
    ASSERT_TRUE(test::wait_in_event_loop([&] { return window->frame()->time == 0.0; }));
    window->keep_now();
    before = names(*window);
    ASSERT_EQ(before.size(), 2);
    ASSERT_EQ(files().size(), 1);
    left = bytes(files().constFirst());
    starts = bytes(files().constFirst() + ".starts");
  }
  EXPECT_TRUE(QDir(kept()).entryList(QDir::Files).isEmpty()) << "at a normal end nothing is left";
  leave_work("work-1-0.json", left);
  QFile file(kept() + "/work-1-0.json.starts");
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write(starts);
  file.close();
  const auto window = lab(kept());
  click(*window, "Restore");
  EXPECT_EQ(names(*window), before);
  EXPECT_FALSE(QFile::exists(file.fileName()));
  const auto chips = window->scene_view().findChildren<QPushButton*>("chip");
  EXPECT_TRUE(std::any_of(chips.begin(), chips.end(), [](const QPushButton* chip) {
    return chip->text().startsWith("new start, from 0.5");
  }));
  window->session().starts().go_to_first();
  EXPECT_EQ(window->session().history().bodies()[0].position,
            read_preset(find_preset("head-on")).scene.bodies[0].position);
}

// Work on a file of one's own.
class KeptFileTest : public AutosaveTest {
 protected:
  void SetUp() override {
    ASSERT_TRUE(QFile::copy(QString::fromStdString(find_preset("head-on").string()), mine_));
    ASSERT_NO_FATAL_FAILURE(leave_work_on(mine_.toStdString()));
  }
  [[nodiscard]] std::size_t saved_bodies() const { return all_bodies(read_preset(mine_.toStdString())).size(); }

  const QString mine_ = folder_.filePath("mine.json");
};

TEST_F(KeptFileTest, TheWorkIsSavedToItsFileAgain) {
  const auto window = lab(kept());
  click(*window, "Restore");
  EXPECT_TRUE(window->windowTitle().startsWith("mine.json")) << window->windowTitle().toStdString();
  EXPECT_TRUE(window->isWindowModified());
  EXPECT_TRUE(window->save());
  EXPECT_EQ(saved_bodies(), 3U);
}

// The body was added: theories on the plots are for the scene without it.
TEST_F(KeptFileTest, TheoriesComeBackWithTheirMark) { expect_marks_until_first_start(); }

TEST_F(AutosaveTest, TheoriesOfAnExperimentComeBackWithTheirMark) {
  ASSERT_NO_FATAL_FAILURE(leave_work_on("head-on"));
  expect_marks_until_first_start();
}

TEST_F(KeptFileTest, AFileThatIsGoneIsMadeAgain) {
  ASSERT_TRUE(QFile::remove(mine_));
  const auto window = lab(kept());
  click(*window, "Restore");
  EXPECT_TRUE(window->save());
  EXPECT_EQ(saved_bodies(), 3U);
}

TEST_F(KeptFileTest, AFileThatWasChangedSinceIsNotReplaced) {
  QFile mine(mine_);
  ASSERT_TRUE(mine.open(QIODevice::ReadWrite));
  ASSERT_TRUE(mine.setFileTime(QDateTime::currentDateTime().addSecs(60), QFileDevice::FileModificationTime));
  mine.close();
  const auto window = lab(kept());
  EXPECT_TRUE(said(*window).contains("mine.json was changed since")) << said(*window).toStdString();
  click(*window, "Restore");
  EXPECT_TRUE(window->session().file().isEmpty());
  EXPECT_EQ(saved_bodies(), 2U);
}

// Killed at any moment, also while it writes.
TEST_F(AutosaveTest, TheStartsOfAKilledWindowComeBack) {
  std::mt19937 random(7);
  const int kills = test::by_effort(2, 6, 200);
  for (int i = 0; i < kills; ++i) {
    SCOPED_TRACE(i);
    QProcess killed;
    killed.start(QCoreApplication::applicationFilePath(), {"--keep-starts", kept()});
    ASSERT_TRUE(killed.waitForStarted());
    for (int lines = 1 + static_cast<int>(random() % 3); lines > 0; --lines) {
      while (!killed.canReadLine()) ASSERT_TRUE(killed.waitForReadyRead(600'000));
      ASSERT_EQ(killed.readLine(), "kept\n");
    }
    QThread::usleep(random() % 60'000);
    kill(static_cast<pid_t>(killed.processId()), SIGKILL);
    ASSERT_TRUE(killed.waitForFinished());
    const auto window = lab(kept());
    ASSERT_TRUE(bar(*window)->isVisible());
    click(*window, "Restore");
    SessionStarts& starts = window->session().starts();
    const std::size_t known = starts.known().size();
    EXPECT_GE(known, 2U);
    EXPECT_EQ(starts.known().front().name, "as opened");
    const std::vector<Body> opened = read_preset(find_preset("head-on")).scene.bodies;
    starts.go_to_first();
    EXPECT_EQ(window->session().history().bodies()[0].position, opened[0].position);
    window->session().edits().undo();
    EXPECT_EQ(starts.known().size(), known);
    window->session().edits().setClean();
    window->keep_now();
    EXPECT_TRUE(files().isEmpty());
  }
}

TEST_F(AutosaveTest, TheKeysAreTheScenesOnceAnOfferIsDiscarded) {
  leave_work("work-1-0.json", work("One"));
  const auto window = lab(kept());
  QApplication::setActiveWindow(window.get());
  for (auto* button : bar(*window)->findChildren<QPushButton*>()) {
    if (button->text() != "Discard") continue;
    button->setFocus();
    QTest::keyClick(button, Qt::Key_Return);
  }
  ASSERT_FALSE(bar(*window)->isVisible());
  QWidget* focus = QApplication::focusWidget();
  ASSERT_NE(focus, nullptr);
  QTest::keyClick(focus, Qt::Key_A, Qt::ControlModifier);
  EXPECT_EQ(window->scene_view().selection().size(), 2U) << focus->metaObject()->className();
}

TEST_F(AutosaveTest, WorkThatIsNotWantedIsOfferedOnce) {
  leave_work("work-1-0.json", work("One"));
  leave_work("work-2-0.json", work("Two"));
  {
    const auto window = lab(kept());
    click(*window, "Discard");
    EXPECT_TRUE(bar(*window)->isVisible()) << "there is another";
    EXPECT_EQ(files().size(), 1);
  }
  const auto window = lab(kept());
  EXPECT_TRUE(bar(*window)->isVisible()) << "an offer without an answer comes again";
  click(*window, "Discard");
  EXPECT_FALSE(bar(*window)->isVisible());
  EXPECT_TRUE(files().isEmpty());
}

TEST_F(AutosaveTest, WindowsLeaveOneAnothersWorkAlone) {
  const auto one = lab(kept());
  add_body(*one);
  one->keep_now();
  const auto two = lab(kept());
  EXPECT_FALSE(bar(*two)->isVisible());
  add_body(*two);
  two->keep_now();
  EXPECT_EQ(files().size(), 2);
  // Only one window at a time makes the offer.
  leave_work("work-1-0.json", work("Lost work"));
  const auto three = lab(kept());
  const auto four = lab(kept());
  EXPECT_TRUE(bar(*three)->isVisible());
  EXPECT_FALSE(bar(*four)->isVisible());
}

TEST_F(AutosaveTest, DamagedWorkIsReportedAndSetAside) {
  leave_work("work-1-0.json", work("Lost work").left(200));
  leave_work("work-2-0.json", work("Whole"));
  const auto window = lab(kept());
  ASSERT_TRUE(bar(*window)->isVisible());
  EXPECT_TRUE(said(*window).contains("cannot be brought back")) << said(*window).toStdString();
  EXPECT_EQ(QDir(kept()).entryList({"*.damaged"}).size(), 1);
  click(*window, "OK");
  EXPECT_TRUE(said(*window).contains("“Whole”")) << said(*window).toStdString();
}

TEST_F(AutosaveTest, AnUnwritableFolderIsReported) {
  QFile in_the_way(kept());
  ASSERT_TRUE(in_the_way.open(QIODevice::WriteOnly));
  const auto window = lab(kept());
  add_body(*window);
  window->keep_now();
  bool reported = false;
  for (const QLabel* label : window->findChildren<QLabel*>())
    reported = reported || label->toolTip().contains("Unsaved work is not kept");
  EXPECT_TRUE(reported);
}

}  // namespace
}  // namespace carom
