#include <QLineEdit>
#include <QScrollArea>
#include <QSettings>
#include <QSplitter>
#include <QTabBar>
#include <QToolBar>
#include <stdexcept>

#include "app/lab/drawer.h"
#include "app/lab/panel_docks.h"
#include "tests/app/lab/lab_fixture.h"
#include "tests/app/lab/two_discs.h"
#include "widgets/edit/inspector.h"
#include "widgets/plot/plot_panel.h"
#include "widgets/plot/run_plot.h"
#include "widgets/run/before_after.h"

namespace carom {
namespace {

// How the panels share a window of any size.
class LabLayoutTest : public LabWindowTest {
 protected:
  void resize(const QSize& size) {
    window_.resize(size);
    QTest::qWait(20);
  }
  [[nodiscard]] static PanelDocks& docks(LabWindow& window) { return *window.findChild<PanelDocks*>(); }
  // Of the side column with the inspector.
  [[nodiscard]] static int column_width(LabWindow& window) {
    const QWidget* column = window.findChild<Inspector*>();
    while (column->parentWidget()->parentWidget() != &docks(window)) column = column->parentWidget();
    return column->width();
  }
  [[nodiscard]] int inspector_height() { return inspector_height(window_); }
  [[nodiscard]] static int inspector_height(LabWindow& window) {
    const QWidget* panel = window.findChild<Inspector*>();
    while (qobject_cast<QSplitter*>(panel->parentWidget()) == nullptr) panel = panel->parentWidget();
    return panel->height();
  }
  [[nodiscard]] bool inspector_seen() { return window_.findChild<Inspector*>()->isVisible(); }
  [[nodiscard]] bool plots_seen() { return window_.findChild<PlotPanel*>()->isVisible(); }
  // The edge between the scene and the right column.
  void pull_columns(int by) {
    QWidget* handle = docks(window_).findChild<QSplitter*>()->handle(2);
    const QPoint at = handle->rect().center();
    QTest::mousePress(handle, Qt::LeftButton, {}, at);
    const QPoint to = at + QPoint(by, 0);
    QMouseEvent move(QEvent::MouseMove, to, handle->mapToGlobal(to), Qt::NoButton, Qt::LeftButton, {});
    QApplication::sendEvent(handle, &move);
    QTest::mouseRelease(handle, Qt::LeftButton, {}, to);
  }
  // Of inspector and plots.
  [[nodiscard]] QTabBar* visible_tabs() {
    for (QTabBar* tabs : window_.findChildren<QTabBar*>()) {
      if (tabs->isVisible() && tabs->count() == 2) return tabs;
    }
    throw std::runtime_error("no tabs");
  }
  void press(int key, Qt::KeyboardModifiers keys = {}) {
    QWidget* focus = QApplication::focusWidget();
    ASSERT_NE(focus, nullptr);
    QTest::keyClick(focus, static_cast<Qt::Key>(key), keys);
  }
  [[nodiscard]] Drawer& drawer() { return *window_.findChild<Drawer*>(); }
  QSettings settings_{folder_.filePath("carom.ini"), QSettings::IniFormat};
};

TEST_F(LabLayoutTest, InspectorAndPlotsAreTabsWhereThereIsLittleRoom) {
  const int usual = column_width(window_);
  const int inspector = inspector_height();
  EXPECT_TRUE(inspector_seen() && plots_seen());
  for (const QSize& small : {QSize(1024, 760), QSize(1280, 700)}) {
    resize(small);
    EXPECT_TRUE(inspector_seen());
    EXPECT_FALSE(plots_seen());
    EXPECT_EQ(column_width(window_), 280);
    QTest::keyClick(&window_.scene_view(), Qt::Key_I);
    EXPECT_TRUE(plots_seen());
    EXPECT_FALSE(inspector_seen());
    QTest::keyClick(&window_.scene_view(), Qt::Key_I);
    EXPECT_TRUE(inspector_seen());
    EXPECT_TRUE(action("Inspector")->isChecked());
    auto* tabs = visible_tabs();
    QTest::mouseClick(tabs, Qt::LeftButton, {}, tabs->tabRect(1).center());
    EXPECT_TRUE(plots_seen());
    EXPECT_FALSE(action("Inspector")->isChecked());
    resize({1280, 800});
    EXPECT_TRUE(inspector_seen() && plots_seen());
    EXPECT_NEAR(column_width(window_), usual, 1);
    EXPECT_NEAR(inspector_height(), inspector, 1);
    action("Standard layout")->trigger();
  }
}

TEST_F(LabLayoutTest, TheInspectorIsLowerInASmallWindow) {
  EXPECT_NEAR(inspector_height(), 408, 1);
  resize({1366, 720});
  action("Standard layout")->trigger();
  EXPECT_NEAR(inspector_height(), 300, 1);
  window_.keep_layout(settings_);
  LabWindow next(light_theme());
  next.restore_layout(settings_);
  next.resize(1280, 800);
  next.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&next));
  EXPECT_NEAR(inspector_height(next), 408, 1) << "nobody has pulled it";
}

TEST_F(LabLayoutTest, NoNumberIsCutInTheNarrowInspector) {
  Preset preset = two_discs();
  preset.scene.bodies[0].position = {-0.885714, -0.123457};
  preset.scene.bodies[0].velocity = {-1.428571, -0.123457};
  window_.show_scene(preset, {}, {});
  ASSERT_TRUE(wait_for([this] { return window_.frame()->scene != nullptr; }));
  window_.scene_view().select({"left"});
  for (const QSize& size : {QSize(1024, 700), QSize(1200, 800), QSize(1280, 800)}) {
    resize(size);
    int seen = 0;
    for (const QLineEdit* field : window_.findChild<Inspector*>()->findChildren<QLineEdit*>()) {
      if (!field->isVisible()) continue;
      constexpr int kInsets = 16;  // px
      EXPECT_LE(field->fontMetrics().horizontalAdvance(field->text()) + kInsets, field->width())
          << size.width() << ": " << field->accessibleName().toStdString();
      ++seen;
    }
    EXPECT_GT(seen, 5);
  }
}

TEST_F(LabLayoutTest, WhatLessonsChangeOfABodyIsSeenWithoutScrolling) {
  resize({1280, 800});
  ASSERT_TRUE(window_.open("head-on"));
  window_.scene_view().select({"light"});
  QTest::qWait(20);
  const auto* inspector = window_.findChild<Inspector*>();
  const auto* seen = inspector->findChild<QScrollArea*>()->viewport();
  int fields = 0;
  for (const QLineEdit* field : inspector->findChildren<QLineEdit*>()) {
    const QStringList wanted = {"Mass, kg",   "Radius, m",    "Position x, m", "Position y, m", "Angle, °",
                                "Speed, m/s", "Direction, °", "Spin, rad/s",   "e of wood"};
    if (!wanted.contains(field->accessibleName())) continue;
    ++fields;
    EXPECT_LE(field->mapTo(seen, field->rect().bottomLeft()).y(), seen->height())
        << field->accessibleName().toStdString();
  }
  EXPECT_EQ(fields, 9);
}

// Of two bodies and their sum.
TEST_F(LabLayoutTest, BeforeAndAfterShowsBothBodiesOfAnImpact) {
  resize({1280, 800});
  ASSERT_TRUE(window_.open("head-on"));
  press(Qt::Key_2, Qt::ControlModifier);
  window_.run_until(1.0);
  QTest::qWait(50);
  auto* table = window_.findChild<BeforeAfterTable*>();
  ASSERT_EQ(table->model()->rowCount(), 3);
  EXPECT_GE(table->viewport()->height(), 3 * table->rowHeight(0));
}

// It comes under the last one, where a small window does not reach.
TEST_F(LabLayoutTest, ANewPlotIsSeen) {
  resize({1280, 800});
  ASSERT_TRUE(window_.open("head-on"));
  auto* plots = window_.findChild<PlotPanel*>();
  for (const char* quantity : {"rotational_energy", "momentum_y", "fastest"}) {
    Plot plot;
    plot.y = {{std::string(quantity), {}}};
    plots->add(plot);
    QTest::qWait(50);
    EXPECT_FALSE(plots->plots().back()->visibleRegion().isEmpty()) << quantity;
  }
}

TEST_F(LabLayoutTest, TheOpenTabIsRemembered) {
  resize({1024, 700});
  QTest::keyClick(&window_.scene_view(), Qt::Key_I);
  window_.keep_layout(settings_);
  LabWindow next(light_theme());
  next.restore_layout(settings_);
  next.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&next));
  EXPECT_TRUE(next.findChild<PlotPanel*>()->isVisible());
  EXPECT_FALSE(next.findChild<Inspector*>()->isVisible());
  EXPECT_EQ(column_width(next), 280);
}

TEST_F(LabLayoutTest, PanelsStandAtTheLeftAndKeepTheirWidth) {
  const auto at_left = [](LabWindow& window) {
    const int scene = window.scene_view().mapTo(&window, QPoint()).x();
    const auto* inspector = window.findChild<Inspector*>();
    return inspector->mapTo(&window, QPoint()).x() < scene;
  };
  for (const QSize& size : {QSize(1280, 800), QSize(1024, 700), QSize(1700, 900)}) {
    resize(size);
    pull_columns(-40);
    const int before = column_width(window_);
    EXPECT_FALSE(at_left(window_));
    action("Panels at the left")->trigger();
    QTest::qWait(20);
    EXPECT_TRUE(at_left(window_)) << size.width();
    EXPECT_NEAR(column_width(window_), before, 1) << size.width();
    action("Inspector in a window")->trigger();
    action("Inspector in a window")->trigger();
    QTest::qWait(20);
    EXPECT_TRUE(at_left(window_)) << size.width();
    EXPECT_NEAR(column_width(window_), before, 1) << size.width();
    window_.keep_layout(settings_);
    LabWindow next(light_theme());
    next.restore_layout(settings_);
    next.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&next));
    EXPECT_TRUE(at_left(next)) << size.width();
    EXPECT_NEAR(column_width(next), column_width(window_), 2) << size.width();
    action("Standard layout")->trigger();
    QTest::qWait(20);
    EXPECT_FALSE(at_left(window_)) << size.width();
    EXPECT_FALSE(action("Panels at the left")->isChecked());
  }
}

TEST_F(LabLayoutTest, F6GoesFromPanelToPanel) {
  resize({1280, 800});
  drawer().set_folded(false);
  const std::vector<QWidget*> panels = {&window_.scene_view(),
                                        window_.findChild<TransportBar*>(),
                                        &drawer(),
                                        window_.findChild<Inspector*>(),
                                        window_.findChild<PlotPanel*>(),
                                        window_.findChild<QToolBar*>("column")};
  const auto has_focus = [](const QWidget* panel) {
    const QWidget* focus = QApplication::focusWidget();
    return panel == focus || panel->isAncestorOf(focus);
  };
  for (std::size_t i = 1; i <= panels.size(); ++i) {
    press(Qt::Key_F6);
    EXPECT_TRUE(has_focus(panels[i % panels.size()])) << i;
  }
  for (std::size_t i = panels.size(); i-- > 0;) {
    press(Qt::Key_F6, Qt::ShiftModifier);
    EXPECT_TRUE(has_focus(panels[i])) << i;
  }
  action("Inspector")->trigger();
  window_.findChild<TransportBar*>()->setFocus();
  drawer().findChild<QTabBar*>()->setFocus();
  press(Qt::Key_F6);
  EXPECT_TRUE(has_focus(window_.findChild<PlotPanel*>())) << "the closed inspector is passed over";
}

TEST_F(LabLayoutTest, CtrlAndADigitOpenTheTabsOfTheDrawer) {
  resize({1280, 800});
  drawer().set_folded(true);
  const auto* tabs = drawer().findChild<QTabBar*>();
  ASSERT_EQ(tabs->count(), 8);
  for (int tab = 7; tab >= 0; --tab) {
    press(Qt::Key_1 + tab, Qt::ControlModifier);
    EXPECT_FALSE(drawer().folded());
    EXPECT_EQ(tabs->currentIndex(), tab);
  }
  press(Qt::Key_1, Qt::ControlModifier);
  EXPECT_TRUE(drawer().folded()) << "the key of the open one";
  press(Qt::Key_1, Qt::ControlModifier);
  EXPECT_FALSE(drawer().folded());
}

}  // namespace
}  // namespace carom
