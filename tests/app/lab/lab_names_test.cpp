#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSlider>
#include <QAccessible>
#include <QComboBox>
#include <QLineEdit>
#include <QListWidget>
#include <QScrollBar>
#include <qwt_plot.h>

#include "app/lab/drawer.h"
#include "tests/app/lab/lab_fixture.h"
#include "widgets/run/experiment_list.h"

namespace carom {
namespace {

class LabNamesTest : public LabWindowTest {
 protected:
  [[nodiscard]] static bool needs_name(const QWidget& widget) {
    if (qobject_cast<const QScrollBar*>(&widget) != nullptr || widget.objectName().startsWith("qt_"))
      return false;
    return qobject_cast<const QAbstractButton*>(&widget) != nullptr ||
           qobject_cast<const QComboBox*>(&widget) != nullptr ||
           qobject_cast<const QLineEdit*>(&widget) != nullptr ||
           qobject_cast<const QAbstractSlider*>(&widget) != nullptr ||
           qobject_cast<const QAbstractItemView*>(&widget) != nullptr ||
           qobject_cast<const QwtPlot*>(&widget) != nullptr;
  }
  // A head is no widget of its own to readers, and neither is the button in a table's corner.
  [[nodiscard]] static bool is_part_of_table(const QWidget& widget) {
    return qobject_cast<const QAbstractItemView*>(widget.parentWidget()) != nullptr;
  }
  void expect_names() {
    for (QWidget* widget : window_.findChildren<QWidget*>()) {
      if (!widget->isVisible() || !needs_name(*widget) || is_part_of_table(*widget)) continue;
      const QAccessibleInterface* known = QAccessible::queryAccessibleInterface(widget);
      ASSERT_NE(known, nullptr);
      EXPECT_NE(known->text(QAccessible::Name), "")
          << widget->metaObject()->className() << " " << widget->toolTip().toStdString();
    }
  }
};

TEST_F(LabNamesTest, EveryButtonFieldTableAndPlotHasAName) {
  ASSERT_NO_FATAL_FAILURE(expect_names());
  auto* drawer = window_.findChild<Drawer*>();
  for (int tab = 0; tab < drawer->titles().size(); ++tab) {
    SCOPED_TRACE(drawer->titles()[tab].toStdString());
    drawer->press(tab);
    QApplication::processEvents();
    ASSERT_NO_FATAL_FAILURE(expect_names());
  }
  for (const Body& body : window_.preset().scene.bodies) {
    SCOPED_TRACE(body.name);
    window_.scene_view().select({body.name});
    QApplication::processEvents();
    ASSERT_NO_FATAL_FAILURE(expect_names());
  }
}

TEST_F(LabNamesTest, TheExperimentsAreReadOut) {
  QTest::keyClick(&window_.scene_view(), Qt::Key_E);
  auto* list = window_.findChild<ExperimentList*>()->findChild<QListWidget*>();
  ASSERT_GT(list->count(), 40);
  QAccessibleInterface* known = QAccessible::queryAccessibleInterface(list);
  int described = 0;
  for (int row = 0; row < list->count(); ++row) {
    EXPECT_NE(known->child(row)->text(QAccessible::Name), "") << row;
    described += known->child(row)->text(QAccessible::Description).isEmpty() ? 0 : 1;
  }
  EXPECT_GT(described, 40);
}

TEST_F(LabNamesTest, ThePlayButtonSaysWhatItWillDo) {
  EXPECT_EQ(button("Play")->accessibleName(), "Play");
  click_button("Play");
  ASSERT_TRUE(wait_for([this] { return window_.frame()->playing; }));
  EXPECT_EQ(button("Play")->accessibleName(), "Pause");
  choose_speed(0.5);
  EXPECT_EQ(button("Speed")->accessibleName(), QString::fromUtf8("Speed ×1/2"));
}

}  // namespace
}  // namespace carom
