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

// The keys that no menu has are those that edit bodies, all of them.
TEST_F(KeysPage, HasTheKeysOfSelectedBodies) {
  std::set<KeyEdit> told;
  for (const KeyText& each : selection_keys()) {
    const std::optional<KeyEdit> edit = key_edit(each.key, each.modifiers);
    ASSERT_TRUE(edit) << each.keys;
    told.insert(*edit);
  }
  EXPECT_EQ(told.size(), 6U);
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
