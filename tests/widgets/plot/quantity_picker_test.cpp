#include "widgets/plot/quantity_picker.h"

#include <QComboBox>
#include <QLineEdit>
#include <QTest>
#include <gtest/gtest.h>

namespace carom {
namespace {

TEST(QuantityPicker, IsSearchedByTyping) {
  QuantityPicker picker({}, {}, nullptr);
  picker.show();
  QLineEdit* typed = nullptr;
  for (const QComboBox* box : picker.findChildren<QComboBox*>()) {
    if (box->accessibleName() == "Quantity") typed = box->lineEdit();
  }
  ASSERT_NE(typed, nullptr);
  const auto type = [&](const QString& text) {
    typed->selectAll();
    QTest::keyClicks(typed, text);
    QTest::keyClick(typed, Qt::Key_Return);
    return picker.quantity().observable;
  };
  EXPECT_EQ(type("TOTAL energy"), "total_energy");
  EXPECT_TRUE(typed->text().contains("total energy")) << "the whole entry is shown";
  EXPECT_EQ(type("no such quantity"), "total_energy");
  EXPECT_TRUE(typed->text().contains("total energy")) << "what is none is taken back";
  EXPECT_EQ(type("energy of all bodies"), "total_energy") << "a heading is no quantity";
}

TEST(QuantityPicker, AClickMarksTheEntrySoThatTypingReplacesIt) {
  QuantityPicker picker({}, {}, nullptr);
  picker.resize(400, 40);
  picker.show();
  picker.activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&picker));
  QComboBox* box = picker.findChildren<QComboBox*>().first();
  QLineEdit* typed = box->lineEdit();
  for (int i = 0; i < 2; ++i) {  // the second time it has the focus already
    QTest::mouseClick(typed, Qt::LeftButton, {}, QPoint(typed->width() - 4, typed->height() / 2));
    QTest::keyClicks(typed, "mom");
    EXPECT_EQ(typed->text(), "mom");
    QTest::keyClick(typed, Qt::Key_Return);
    EXPECT_NE(typed->text(), "mom");
  }
}

TEST(QuantityPicker, NoTwoEntriesReadTheSame) {
  QuantityPicker picker({}, {}, nullptr);
  const QComboBox* box = picker.findChildren<QComboBox*>().first();
  for (int i = 0; i < box->count(); ++i) EXPECT_EQ(box->findText(box->itemText(i)), i);
  EXPECT_GE(box->findText("   kinetic energy, one body / J"), 0);
  EXPECT_GE(box->findText("   kinetic energy, all bodies / J"), 0);
}

}  // namespace
}  // namespace carom
