#include <QAction>
#include <QApplication>
#include <QDialog>
#include <QTest>
#include <QTimer>
#include <gtest/gtest.h>

#include "app/lab/lab_window.h"
#include "app/lab/report_dialog.h"
#include "widgets/run/transport_bar.h"

// The lab report waits for the run to pause; the window stays responsive.
namespace carom {
namespace {

class LabWait : public testing::Test {
 protected:
  void SetUp() override {
    window_.show();
    ASSERT_TRUE(window_.open("gas"));
    ASSERT_TRUE(QTest::qWaitFor([&] { return window_.frame() != nullptr; }));
    trigger(QKeySequence(Qt::Key_Space));
    ASSERT_TRUE(QTest::qWaitFor([&] { return window_.frame()->playing && window_.frame()->steps > 0; }));
    QObject::connect(&leaving_, &QTimer::timeout, [this] {
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
  void expect_no_dialog() {
    QTest::qWait(200);
    EXPECT_EQ(dialogs_, 0);
  }
  LabWindow window_{light_theme()};
  QTimer leaving_;
  int dialogs_ = 0;
  bool report_ = false;
};

TEST_F(LabWait, TheReportComesOnceTheRunHasStopped) {
  ask_for_report();
  EXPECT_TRUE(QTest::qWaitFor([&] { return report_; }));
  EXPECT_FALSE(window_.frame()->playing);
}

// Before any frame of the pause can arrive.
TEST_F(LabWait, AnotherExperimentForgetsTheReport) {
  QTimer::singleShot(0, [&] { window_.open("head-on"); });
  ask_for_report();
  EXPECT_TRUE(
      QTest::qWaitFor([&] { return window_.frame() != nullptr && window_.frame()->bodies->size() == 2; }));
  expect_no_dialog();
}

TEST_F(LabWait, ARestartForgetsTheReport) {
  QTimer::singleShot(0, [&] { trigger(QKeySequence(Qt::Key_R)); });
  ask_for_report();
  expect_no_dialog();
}

TEST_F(LabWait, ClosingForgetsTheReport) {
  QTimer::singleShot(0, [&] { window_.close(); });
  ask_for_report();
  expect_no_dialog();
}

}  // namespace
}  // namespace carom
