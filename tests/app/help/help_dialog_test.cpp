#include "app/help/help_dialog.h"

#include <QAbstractTextDocumentLayout>
#include <QDialog>
#include <QLineEdit>
#include <QListWidget>
#include <QTest>
#include <QTextBrowser>
#include <QTextDocument>
#include <QWidget>
#include <gtest/gtest.h>

namespace carom {
namespace {

TEST(HelpDialog, IsSearched) {
  QWidget window;
  show_help(&window, "# Keys\n\nSpace plays.");
  auto* field = window.findChild<QLineEdit*>();
  auto* pages = window.findChild<QListWidget*>("help-pages");
  auto* text = window.findChild<QTextBrowser*>();
  ASSERT_TRUE(field != nullptr && pages != nullptr && text != nullptr);
  EXPECT_TRUE(text->toPlainText().contains("A first lesson"));
  const auto shown = [&] {
    int count = 0;
    for (int row = 0; row < pages->count(); ++row) count += pages->item(row)->isHidden() ? 0 : 1;
    return count;
  };
  const int all = shown();
  field->setText("NEWTON");
  EXPECT_GT(shown(), 0);
  EXPECT_LT(shown(), all);
  EXPECT_EQ(text->textCursor().selectedText().toLower(), "newton");
  const int first = text->textCursor().position();
  QTest::keyClick(field, Qt::Key_Return);
  EXPECT_NE(text->textCursor().position(), first) << "the next place";
  field->setText("no such words");
  EXPECT_EQ(shown(), 0);
  EXPECT_TRUE(text->toPlainText().contains("No page has"));
  field->clear();
  EXPECT_EQ(shown(), all);
  EXPECT_FALSE(text->toPlainText().contains("No page has"));
}

TEST(HelpDialog, NoPageIsWiderThanItsWindow) {
  QWidget window;
  show_help(&window, "# Keys\n\nSpace plays.");
  auto* pages = window.findChild<QListWidget*>("help-pages");
  auto* text = window.findChild<QTextBrowser*>();
  for (int row = 0; row < pages->count(); ++row) {
    pages->setCurrentRow(row);
    const double width = text->document()->documentLayout()->documentSize().width();
    EXPECT_LE(width, text->viewport()->width() + 1.0) << pages->item(row)->text().toStdString();
  }
}

// A page is laid out once, not at each letter: that takes longer than all the searches.
TEST(HelpDialog, LettersLayNoPageOutAgain) {
  QWidget window;
  show_help(&window, "# Keys\n\nSpace plays.", HelpPage::kKeys);
  auto* text = window.findChild<QTextBrowser*>();
  auto* field = window.findChild<QLineEdit*>();
  ASSERT_TRUE(text->toPlainText().contains("Space plays."));
  const QTextDocument* shown = text->document();
  int changes = 0;
  QObject::connect(shown, &QTextDocument::contentsChanged, &window, [&] { ++changes; });
  QTest::keyClicks(field, "space");
  EXPECT_EQ(text->document(), shown);
  EXPECT_EQ(changes, 0);
  EXPECT_EQ(text->textCursor().selectedText().toLower(), "space");
}

}  // namespace
}  // namespace carom
