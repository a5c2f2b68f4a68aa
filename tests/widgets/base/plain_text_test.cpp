#include "widgets/base/plain_text.h"

#include <QApplication>
#include <QMessageBox>
#include <QTextDocument>
#include <QTimer>
#include <gtest/gtest.h>

#include "widgets/base/elided_label.h"
#include "widgets/base/plain_text_edit.h"

namespace carom {
namespace {

const QString kHtml = "<b>x</b> & <img src='/etc/hostname'>\nnext &lt; line";

TEST(PlainText, LabelsShowTagsAsTheyAre) {
  EXPECT_EQ(PlainLabel(kHtml).textFormat(), Qt::PlainText);
  EXPECT_EQ(PlainLabel().textFormat(), Qt::PlainText);
  EXPECT_EQ(ElidedLabel().textFormat(), Qt::PlainText);
}

TEST(PlainText, TooltipSaysTheTextItself) {
  QTextDocument shown;
  shown.setHtml(plain_tip(kHtml));
  EXPECT_EQ(shown.toPlainText(), kHtml);
  EXPECT_EQ(plain_tip("two\nlines"), "two\nlines");
  EXPECT_EQ(plain_tip({}), QString());
}

// Such as a file dialog's own question whether to replace a file of this name.
TEST(PlainText, MessageBoxesOfQtsOwnShowTagsAsTheyAre) {
  keep_messages_plain();
  QStringList rich;
  QTimer::singleShot(0, [&] {
    auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
    ASSERT_NE(box, nullptr);
    for (const QLabel* label : box->findChildren<QLabel*>()) {
      if (label->textFormat() != Qt::PlainText && Qt::mightBeRichText(label->text())) rich << label->text();
    }
    box->reject();
  });
  QMessageBox::warning(nullptr, "Replace?", "<b>name</b>.json already exists.");
  EXPECT_TRUE(rich.isEmpty()) << rich.join("; ").toStdString();
}

// Pasting from an empty clipboard, as a middle click does where nothing is selected on the screen.
TEST(PlainText, PasteOfNothingDoesNothing) {
  class Field : public PlainTextEdit {
   public:
    using PlainTextEdit::canInsertFromMimeData;
    using PlainTextEdit::insertFromMimeData;
  };
  Field field;
  field.setPlainText("words");
  const QMimeData nothing;
  for (const QMimeData* source : {&nothing, static_cast<const QMimeData*>(nullptr)}) {
    EXPECT_FALSE(field.canInsertFromMimeData(source));
    field.insertFromMimeData(source);
  }
  EXPECT_EQ(field.toPlainText(), "words");
}

}  // namespace
}  // namespace carom
