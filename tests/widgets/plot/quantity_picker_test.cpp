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

}  // namespace
}  // namespace carom
