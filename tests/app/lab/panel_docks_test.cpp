#include "app/lab/panel_docks.h"

#include <QSettings>

#include "app/lab/drawer.h"
#include "app/lab/drop_mark.h"
#include "app/lab/floating_panel.h"
#include "tests/app/lab/lab_fixture.h"
#include "widgets/edit/inspector.h"

namespace carom {
namespace {

using Panel = PanelDocks::Panel;
using Dock = PanelDocks::Dock;

// Panels are moved by a drag of their head.
class PanelDocksTest : public LabWindowTest {
 protected:
  struct Held {
    QWidget* head = nullptr;
    QPoint at;
  };
  [[nodiscard]] static PanelDocks& docks(LabWindow& window) { return *window.findChild<PanelDocks*>(); }
  [[nodiscard]] PanelDocks& docks() { return docks(window_); }
  [[nodiscard]] static QWidget* widget(LabWindow& window, Panel panel) {
    switch (panel) {
      case PanelDocks::kInspector:
        return window.findChild<Inspector*>();
      case PanelDocks::kPlots:
        return window.findChild<PlotPanel*>();
      default:
        return window.findChild<Drawer*>();
    }
  }
  // Where the mouse takes the panel.
  [[nodiscard]] Held head(Panel panel) {
    switch (panel) {
      case PanelDocks::kInspector:
        return {inspector_->head(), {60, 20}};
      case PanelDocks::kPlots:
        return {plots_->plots()[0], {200, 6}};
      default:
        return {drawer_, {drawer_->width() / 2 + 200, 14}};
    }
  }
  // A place in the middle of a dock that is empty.
  [[nodiscard]] QPoint edge(Dock dock) {
    const QSize all = docks().size();
    const QPoint at = dock == PanelDocks::kLeft    ? QPoint(20, all.height() / 2)
                      : dock == PanelDocks::kRight ? QPoint(all.width() - 20, all.height() / 2)
                                                   : QPoint(all.width() / 2, all.height() - 20);
    return docks().mapToGlobal(at);
  }
  void pull(Panel panel, const QPoint& to) {
    const auto [widget, at] = head(panel);
    QTest::mousePress(widget, Qt::LeftButton, {}, at);
    move(widget, at + QPoint(10, 0));
    move(widget, widget->mapFromGlobal(to));
    held_ = {widget, widget->mapFromGlobal(to)};
  }
  // With the button down.
  static void move(QWidget* widget, const QPoint& to) {
    QMouseEvent event(QEvent::MouseMove, to, widget->mapToGlobal(to), Qt::NoButton, Qt::LeftButton, {});
    QApplication::sendEvent(widget, &event);
  }
  void let_go() {
    QTest::mouseRelease(held_.head, Qt::LeftButton, {}, held_.at);
    QTest::qWait(20);
  }
  void drag(Panel panel, const QPoint& to) {
    pull(panel, to);
    let_go();
  }
  [[nodiscard]] QPoint middle_of_scene() {
    return window_.scene_view().mapToGlobal(window_.scene_view().rect().center());
  }
  // Where a panel is seen, beside the scene.
  [[nodiscard]] static Dock seen_at(LabWindow& window, Panel panel) {
    const auto centre = [&](QWidget* of) { return of->mapTo(&window, of->rect().center()); };
    const QWidget& view = window.scene_view();
    const int left = view.mapTo(&window, QPoint()).x();
    const QPoint at = centre(widget(window, panel));
    return at.x() < left                  ? PanelDocks::kLeft
           : at.x() > left + view.width() ? PanelDocks::kRight
                                          : PanelDocks::kBottom;
  }

  [[nodiscard]] QMenu* find_menu(const QString& title) {
    for (QMenu* menu : window_.findChildren<QMenu*>()) {
      if (menu->title().remove('&') == title) return menu;
    }
    throw std::runtime_error("no menu " + title.toStdString());
  }

  void SetUp() override {
    LabWindowTest::SetUp();
    inspector_ = window_.findChild<Inspector*>();
    plots_ = window_.findChild<PlotPanel*>();
    drawer_ = window_.findChild<Drawer*>();
  }
  QSettings settings_{folder_.filePath("carom.ini"), QSettings::IniFormat};
  Inspector* inspector_ = nullptr;
  PlotPanel* plots_ = nullptr;
  Drawer* drawer_ = nullptr;
  Held held_{};
};

constexpr std::array kPanels = {PanelDocks::kInspector, PanelDocks::kPlots, PanelDocks::kDrawer};
constexpr std::array kDocks = {PanelDocks::kLeft, PanelDocks::kRight, PanelDocks::kBottom};

TEST_F(PanelDocksTest, EveryPanelGoesToEveryDock) {
  for (const Panel panel : kPanels) {
    for (const Dock dock : kDocks) {
      drag(panel, edge(dock));
      EXPECT_EQ(docks().dock_of(panel), dock);
      EXPECT_EQ(seen_at(window_, panel), dock) << panel;
      EXPECT_TRUE(widget(window_, panel)->isVisible());
      EXPECT_GT(window_.scene_view().width(), 300);
      EXPECT_GT(window_.scene_view().height(), 150);
    }
    action("Standard layout")->trigger();
    QTest::qWait(20);
  }
}

TEST_F(PanelDocksTest, TheStandardLayoutIsBackWithAllSizes) {
  const QSize scene = window_.scene_view().size();
  const int inspector = inspector_->height();
  drag(PanelDocks::kPlots, edge(PanelDocks::kLeft));
  drag(PanelDocks::kDrawer, edge(PanelDocks::kRight));
  drag(PanelDocks::kInspector, middle_of_scene());
  EXPECT_NE(window_.scene_view().size(), scene);
  action("Standard layout")->trigger();
  QTest::qWait(20);
  for (const Panel panel : kPanels)
    EXPECT_EQ(seen_at(window_, panel), panel == PanelDocks::kDrawer ? PanelDocks::kBottom : PanelDocks::kRight);
  EXPECT_NEAR(window_.scene_view().width(), scene.width(), 2);
  EXPECT_NEAR(window_.scene_view().height(), scene.height(), 2);
  EXPECT_NEAR(inspector_->height(), inspector, 2);
}

TEST_F(PanelDocksTest, OverTheSceneItIsAWindowAndComesBackByADrag) {
  for (const Panel panel : kPanels) {
    drag(panel, middle_of_scene());
    EXPECT_TRUE(docks().window_of(panel).floating());
    EXPECT_NE(widget(window_, panel)->window(), &window_);
    drag(panel, edge(PanelDocks::kLeft));
    EXPECT_FALSE(docks().window_of(panel).floating());
    EXPECT_EQ(seen_at(window_, panel), PanelDocks::kLeft);
  }
}

TEST_F(PanelDocksTest, AMarkShowsWhereAndEscapeEndsTheDrag) {
  const auto* mark = window_.findChild<DropMark*>();
  pull(PanelDocks::kInspector, edge(PanelDocks::kLeft));
  EXPECT_TRUE(mark->isVisible());
  EXPECT_LT(mark->geometry().right(), docks().width() / 2);
  EXPECT_GT(mark->height(), docks().height() - 10);
  QTest::keyClick(&window_.scene_view(), Qt::Key_Escape);
  EXPECT_FALSE(mark->isVisible());
  let_go();
  EXPECT_EQ(docks().dock_of(PanelDocks::kInspector), PanelDocks::kRight);
  EXPECT_EQ(QApplication::overrideCursor(), nullptr);
}

TEST_F(PanelDocksTest, APressAloneMovesNothing) {
  const auto [widget, at] = head(PanelDocks::kInspector);
  QTest::mouseClick(widget, Qt::LeftButton, {}, at);
  move(widget, at + QPoint(-600, 0));
  EXPECT_FALSE(window_.findChild<DropMark*>()->isVisible());
  EXPECT_FALSE(docks().window_of(PanelDocks::kInspector).floating());
}

TEST_F(PanelDocksTest, PlacesAndSizesAreRemembered) {
  drag(PanelDocks::kPlots, edge(PanelDocks::kLeft));
  drag(PanelDocks::kDrawer, edge(PanelDocks::kRight));
  window_.keep_layout(settings_);
  LabWindow next(light_theme());
  next.restore_layout(settings_);
  next.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&next));
  for (const Panel panel : kPanels) {
    EXPECT_EQ(seen_at(next, panel), seen_at(window_, panel)) << panel;
    EXPECT_NEAR(widget(next, panel)->width(), widget(window_, panel)->width(), 2) << panel;
    EXPECT_NEAR(widget(next, panel)->height(), widget(window_, panel)->height(), 2) << panel;
  }
}

TEST_F(PanelDocksTest, InASmallWindowATabIsDraggedAway) {
  window_.resize(1024, 700);
  QTest::qWait(20);
  QTabBar* tabs = nullptr;
  for (QTabBar* each : docks().findChildren<QTabBar*>()) {
    if (each->isVisible() && each->count() == 2) tabs = each;
  }
  ASSERT_NE(tabs, nullptr);
  const QPoint at = tabs->tabRect(1).center();
  QTest::mousePress(tabs, Qt::LeftButton, {}, at);
  move(tabs, at + QPoint(-10, 0));
  const QPoint to = tabs->mapFromGlobal(edge(PanelDocks::kLeft));
  move(tabs, to);
  QTest::mouseRelease(tabs, Qt::LeftButton, {}, to);
  QTest::qWait(20);
  EXPECT_EQ(seen_at(window_, PanelDocks::kPlots), PanelDocks::kLeft);
  EXPECT_EQ(seen_at(window_, PanelDocks::kInspector), PanelDocks::kRight);
  EXPECT_TRUE(plots_->isVisible() && inspector_->isVisible());
  EXPECT_FALSE(tabs->isVisible());
}

TEST_F(PanelDocksTest, TheMenuDoesWhatADragDoes) {
  const auto* places = find_menu("Places of the panels");
  for (const Panel panel : kPanels) {
    QMenu* menu = places->actions()[panel]->menu();
    for (const Dock dock : kDocks) {
      menu->actions()[dock]->trigger();
      QTest::qWait(20);
      EXPECT_EQ(seen_at(window_, panel), dock);
      emit menu->aboutToShow();
      for (const Dock other : kDocks) EXPECT_EQ(menu->actions()[other]->isChecked(), other == dock);
    }
  }
}

TEST_F(PanelDocksTest, TheDrawerFoldsOnlyBesideOthers) {
  drag(PanelDocks::kDrawer, edge(PanelDocks::kRight));
  const int plots = plots_->parentWidget()->height();
  drawer_->set_folded(true);
  EXPECT_TRUE(QTest::qWaitFor([this] { return drawer_->height() < 60; })) << drawer_->height();
  EXPECT_TRUE(QTest::qWaitFor([&] { return plots_->parentWidget()->height() > plots + 50; }))
      << "they get the room";
  drag(PanelDocks::kDrawer, edge(PanelDocks::kLeft));
  EXPECT_FALSE(drawer_->folded()) << "it would leave a hole";
  EXPECT_TRUE(QTest::qWaitFor([this] { return drawer_->height() > docks().height() / 2; }))
      << drawer_->height();
}

}  // namespace
}  // namespace carom
