#include <QAction>
#include <QApplication>
#include <QDialog>
#include <QTest>
#include <QTimer>
#include <gtest/gtest.h>

#include "app/lab/lab_window.h"
#include "app/lab/report_dialog.h"
#include "tests/support/wait_events.h"
#include "widgets/run/transport_bar.h"

// The lab report waits for the run to pause; the window stays responsive.
namespace carom {
namespace {

class LabWait : public testing::Test {
 protected:
  void SetUp() override {
    window_.show();
    ASSERT_TRUE(window_.open("gas"));
    ASSERT_TRUE(test::wait_in_event_loop([&] { return window_.frame() != nullptr; }));
    trigger(QKeySequence(Qt::Key_Space));
    ASSERT_TRUE(
        test::wait_in_event_loop([&] { return window_.frame()->playing && window_.frame()->steps > 0; }));
    QObject::connect(&leaving_, &QTimer::timeout, [this] {
      ++looks_;
      if (QWidget* dialog = QApplication::activeModalWidget()) {
        ++dialogs_;
        report_ = report_ || qobject_cast<ReportDialog*>(dialog) != nullptr;
        dialog->close();
      }
    });
    leaving_.start(10);
  }
  void trigger(const QKeySequence& key) {
    for (QAction* action : window_.findChildren<QAction*>()) {
      if (action->shortcut() == key) return action->trigger();
    }
    FAIL();
  }
  void ask_for_report() { trigger(QKeySequence(Qt::CTRL | Qt::Key_L)); }
  // Neither with the frame that shows that no run plays, nor by what that frame has put into the event loop.
  void expect_no_dialog() {
    EXPECT_TRUE(
        test::wait_in_event_loop([&] { return window_.frame() != nullptr && !window_.frame()->playing; }));
    const int before = looks_;
    EXPECT_TRUE(test::wait_in_event_loop([&] { return looks_ > before + 3; }));
    EXPECT_EQ(dialogs_, 0);
  }
  LabWindow window_{light_theme()};
  QTimer leaving_;
  int looks_ = 0;  // for dialogs
  int dialogs_ = 0;
  bool report_ = false;
};

TEST_F(LabWait, TheReportComesOnceTheRunHasStopped) {
  ask_for_report();
  EXPECT_TRUE(test::wait_in_event_loop([&] { return report_; }));
  EXPECT_FALSE(window_.frame()->playing);
}

// These come at once: before any frame of the pause can arrive.

TEST_F(LabWait, AnotherExperimentForgetsTheReport) {
  ask_for_report();
  ASSERT_TRUE(window_.open("head-on"));
  EXPECT_TRUE(test::wait_in_event_loop(
      [&] { return window_.frame() != nullptr && window_.frame()->bodies->size() == 2; }));
  expect_no_dialog();
}

TEST_F(LabWait, ARestartForgetsTheReport) {
  ask_for_report();
  trigger(QKeySequence(Qt::Key_R));
  expect_no_dialog();
}

TEST_F(LabWait, ClosingForgetsTheReport) {
  ask_for_report();
  window_.close();
  expect_no_dialog();
}

}  // namespace
}  // namespace carom
