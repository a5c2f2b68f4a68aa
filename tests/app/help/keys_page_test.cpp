#include "app/help/keys_page.h"

#include <QAction>
#include <QMenuBar>
#include <QTextBrowser>
#include <algorithm>
#include <gtest/gtest.h>
#include <set>

#include "tests/app/lab/lab_fixture.h"
#include "widgets/scene/key_edits.h"

namespace carom {
namespace {

class KeysPage : public LabWindowTest {};

TEST_F(KeysPage, HasEachShortcutOfTheMenus) {
  const QString page = keys_page(*window_.menuBar());
  int keys = 0;
  for (const QAction* action : window_.findChildren<QAction*>()) {
    if (action->shortcut().isEmpty() || action->associatedObjects().isEmpty()) continue;
    const QString key = action->shortcut().toString(QKeySequence::NativeText);
    EXPECT_TRUE(page.contains("| " + key)) << action->text().toStdString() << ": " << key.toStdString();
    ++keys;
  }
  EXPECT_GT(keys, 60);
  EXPECT_TRUE(page.contains("## Tools")) << page.toStdString();
  EXPECT_TRUE(page.contains("| B | Box |"));
}

// A key that the scene has, which its menu only names.
TEST_F(KeysPage, HasTheKeysThatMenusName) {
  const QString page = keys_page(*window_.menuBar());
  EXPECT_TRUE(page.contains("| Del | Delete |")) << page.toStdString();
  EXPECT_TRUE(page.contains("| Ctrl+A | Select all |"));
  EXPECT_TRUE(page.contains("| K | Put in touch |"));
  EXPECT_TRUE(page.contains("| Y | Loupe at the mouse |"));
}

// The keys that no menu has: all that edit bodies, and the others of the scene.
TEST_F(KeysPage, HasTheKeysOfSelectedBodies) {
  std::set<KeyEdit> told;
  std::set<int> keys;
  for (const KeyText& each : selection_keys()) {
    if (const std::optional<KeyEdit> edit = key_edit(each.key, each.modifiers)) told.insert(*edit);
    keys.insert(each.key);
  }
  EXPECT_EQ(told.size(), 6U);
  for (const int key : {Qt::Key_L, Qt::Key_F2, Qt::Key_Tab, Qt::Key_Enter, Qt::Key_Escape, Qt::Key_F10})
    EXPECT_TRUE(keys.contains(key)) << key;
  const QString page = keys_page(*window_.menuBar());
  for (const char* row : {"| L |", "| F2 |", "| Tab, Shift+Tab |", "| Enter |", "| Esc |", "| Shift+F10 |"})
    EXPECT_TRUE(page.contains(row)) << row;
}

TEST_F(KeysPage, IsOpenedByItsKey) {
  action("Keys")->trigger();
  const auto* text = window_.findChild<QTextBrowser*>();
  ASSERT_NE(text, nullptr);
  EXPECT_TRUE(text->toPlainText().contains("Selected bodies"));
  EXPECT_EQ(action("Keys")->shortcut(), QKeySequence(Qt::Key_Question));
}

}  // namespace
}  // namespace carom
