#include <QSettings>

#include "app/lab/drawer.h"
#include "tests/app/lab/lab_fixture.h"
#include "widgets/edit/bodies_sheet.h"
#include "widgets/edit/inspector.h"

namespace carom {
namespace {

// Panels in windows of their own.
class FloatingPanelTest : public LabWindowTest {
 protected:
  [[nodiscard]] Drawer& drawer() { return *window_.findChild<Drawer*>(); }
  QSettings settings_{folder_.filePath("carom.ini"), QSettings::IniFormat};
};

TEST_F(FloatingPanelTest, PanelsFloatAndComeBack) {
  const auto seen_in_window = [this](QWidget* panel) {
    return panel->isVisible() && panel->window() == &window_;
  };
  const std::vector<std::pair<QString, QWidget*>> panels = {
      {"Inspector in a window", window_.findChild<Inspector*>()},
      {"Plots in a window", window_.findChild<PlotPanel*>()},
      {"Tables in a window", &drawer()}};
  const int height = window_.scene_view().height();
  const int width = window_.scene_view().width();
  for (const auto& [entry, panel] : panels) {
    action(entry)->trigger();
    EXPECT_TRUE(panel->isVisible()) << entry.toStdString();
    EXPECT_FALSE(seen_in_window(panel));
    panel->window()->close();
    EXPECT_TRUE(seen_in_window(panel)) << entry.toStdString();
    EXPECT_FALSE(action(entry)->isChecked());
  }
  QTest::qWait(20);
  EXPECT_NEAR(window_.scene_view().height(), height, 2);
  EXPECT_NEAR(window_.scene_view().width(), width, 2);
  for (const auto& [entry, panel] : panels) action(entry)->trigger();
  QTest::qWait(20);
  EXPECT_GT(window_.scene_view().width(), width + 200) << "nothing stands in the right column";
  EXPECT_GT(window_.scene_view().height(), height + 100);
  drawer().press(drawer().shows(window_.findChild<BodiesSheet*>()) ? 0 : 1);
  EXPECT_FALSE(drawer().folded()) << "not in its own window";
  window_.keep_layout(settings_);
  LabWindow next(light_theme());
  next.restore_layout(settings_);
  next.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&next));
  EXPECT_NE(next.findChild<Drawer*>()->window(), &next);
  EXPECT_NE(next.findChild<Inspector*>()->window(), &next);
  EXPECT_TRUE(next.findChild<PlotPanel*>()->isVisible());
  action("Standard layout")->trigger();
  for (const auto& [entry, panel] : panels) EXPECT_TRUE(seen_in_window(panel)) << entry.toStdString();
  QTest::qWait(20);
  EXPECT_NEAR(window_.scene_view().width(), width, 2);
}

TEST_F(FloatingPanelTest, TheButtonWorksWhileARunPlays) {
  const auto* inspector = window_.findChild<Inspector*>();
  auto* button = inspector->head()->findChildren<QToolButton*>().last();
  ASSERT_EQ(button->defaultAction(), action("Inspector in a window"));
  choose_speed(0.0625);
  action("Play or pause")->trigger();
  ASSERT_TRUE(wait_for([this] { return window_.frame()->playing && time() > 0.0; }));
  QTest::mouseClick(button, Qt::LeftButton);
  EXPECT_NE(inspector->window(), &window_);
  EXPECT_TRUE(window_.frame()->playing);
  QTest::mouseClick(button, Qt::LeftButton);
  EXPECT_EQ(inspector->window(), &window_);
}

}  // namespace
}  // namespace carom
