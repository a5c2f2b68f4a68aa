#include "app/lab/notice_bar.h"

#include <QAction>
#include <QLabel>
#include <QMainWindow>
#include <QPushButton>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <gtest/gtest.h>

#include "app/lab/lab_window.h"
#include "physics/preset/preset.h"
#include "physics/preset/preset_file.h"
#include "tests/support/scenes.h"
#include "tests/support/wait_events.h"

namespace carom {
namespace {

QPushButton* button(const QWidget& bar, const QString& text) {
  for (auto* b : bar.findChildren<QPushButton*>()) {
    if (b->text() == text) return b;
  }
  return nullptr;
}

// The focused button takes a key before the window does.
TEST(NoticeBar, IsAnsweredByKeyboard) {
  QMainWindow window;
  QAction play;
  play.setShortcut(Qt::Key_Space);
  window.addAction(&play);
  auto* bar = new NoticeBar;
  window.setCentralWidget(bar);
  bar->say("text", "Yes", "No");
  window.show();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&window));
  QSignalSpy played(&play, &QAction::triggered);
  QSignalSpy accepted(bar, &NoticeBar::accepted);
  QSignalSpy dismissed(bar, &NoticeBar::dismissed);
  button(*bar, "Yes")->setFocus(Qt::TabFocusReason);
  QTest::keyClick(button(*bar, "Yes"), Qt::Key_Space);
  QTest::keyClick(button(*bar, "Yes"), Qt::Key_Return);
  EXPECT_EQ(accepted.count(), 2);
  button(*bar, "No")->setFocus(Qt::TabFocusReason);
  QTest::keyClick(button(*bar, "No"), Qt::Key_Enter);
  EXPECT_EQ(dismissed.count(), 1);
  EXPECT_EQ(played.count(), 0);
}

// A spring far too stiff for the step.
TEST(LostBar, ComesBackWhereItIsPlayedAgain) {
  Preset s = test::preset_with({test::disc("a", {1, 0}, {0, 0})});
  Spring spring;
  spring.body = "a";
  spring.stiffness = 1e6;
  s.scene.forces.springs = {spring};
  s.method = {IntegratorId::kRk4, ImpactsId::kLocated, ContactsId::kImpulse, 0.005};
  const QTemporaryDir folder;
  const std::string file = folder.filePath("lost.json").toStdString();
  save_preset(s, file);

  LabWindow window(light_theme());
  window.show();
  ASSERT_TRUE(window.open(file));
  ASSERT_TRUE(test::wait_in_event_loop([&] { return window.frame() != nullptr; }));
  const auto play = [&] {
    for (QAction* action : window.findChildren<QAction*>()) {
      if (action->shortcut() == QKeySequence(Qt::Key_Space)) action->trigger();
    }
  };
  const auto bar = [&]() -> NoticeBar* {
    for (auto* b : window.findChildren<NoticeBar*>()) {
      if (b->isVisible()) return b;
    }
    return nullptr;
  };
  play();
  ASSERT_TRUE(test::wait_in_event_loop([&] { return window.frame()->lost && bar() != nullptr; }));
  const auto said_in_chip = [&] {
    for (const QLabel* label : window.findChildren<QLabel*>("chip")) {
      if (label->isVisible() && label->toolTip().contains("lost at t")) return true;
    }
    return false;
  };
  EXPECT_FALSE(said_in_chip());
  QTest::mouseClick(button(*bar(), "Dismiss"), Qt::LeftButton);
  EXPECT_EQ(bar(), nullptr);
  EXPECT_TRUE(said_in_chip());
  play();
  EXPECT_NE(bar(), nullptr);
}

}  // namespace
}  // namespace carom
