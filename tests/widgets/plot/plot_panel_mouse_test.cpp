#include <QCursor>
#include <QMenu>
#include <QTest>
#include <gtest/gtest.h>
#include <qwt_plot.h>

#include "tests/support/run_fixture.h"
#include "widgets/plot/plot_panel.h"
#include "widgets/plot/run_plot.h"

// Plots that are removed while the mouse is on them, or while their menu or dialog is open.
namespace carom {
namespace {

class PlotPanelMouse : public testing::Test {
 protected:
  void SetUp() override {
    panel_.resize(500, 600);
    panel_.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&panel_));
    auto recorder = std::make_shared<Recorder>();
    recorder->add(run_to(head_on_scene(), 1.0, panel_.curves()));
    panel_.update_from({{recorder, "run"}});
    panel_.show_now();
  }
  // Sent like a screen event, so that Qt knows the widget under the mouse.
  void rest_on(RunPlot* plot) {
    QWidget* canvas = plot->plot()->canvas();
    const QPoint at = canvas->mapTo(&panel_, canvas->rect().center());
    QCursor::setPos(panel_.mapToGlobal(at));
    QTest::mouseMove(panel_.windowHandle(), at - QPoint(3, 3));
    QTest::mouseMove(panel_.windowHandle(), at);
  }
  PlotPanel panel_{light_theme()};
};

TEST_F(PlotPanelMouse, AllPlotsGoWhileItRestsOnOne) {
  for (std::size_t i = 0; i < 3; ++i) {
    ASSERT_EQ(panel_.plots().size(), 3U);
    rest_on(panel_.plots()[i]);
    panel_.set_plots({named("drift"), named("energy"), named("ledger")}, {});
    QCoreApplication::processEvents();
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    rest_on(panel_.plots()[i]);
  }
  EXPECT_EQ(panel_.findChildren<RunPlot*>().size(), 3);
}

TEST_F(PlotPanelMouse, OnePlotGoesWhileItRestsOnIt) {
  rest_on(panel_.plots()[1]);
  panel_.remove(panel_.plots()[1]);
  QCoreApplication::processEvents();
  rest_on(panel_.plots()[0]);
  EXPECT_EQ(panel_.plots().size(), 2U);
}

TEST_F(PlotPanelMouse, PanelGoesWhileItRestsOnAPlot) {
  auto other = std::make_unique<PlotPanel>(light_theme());
  other->resize(400, 500);
  other->show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(other.get()));
  QWidget* canvas = other->plots().front()->plot()->canvas();
  QTest::mouseMove(other->windowHandle(), canvas->mapTo(other.get(), canvas->rect().center()));
  other.reset();
  QCoreApplication::processEvents();
}

// The menu of a removed plot has no entries that act on it.
TEST_F(PlotPanelMouse, MenuOutlivesItsPlot) {
  RunPlot* plot = panel_.plots().front();
  const QPoint at = plot->geometry().center();
  QContextMenuEvent event(QContextMenuEvent::Mouse, at, panel_.mapToGlobal(at));
  QCoreApplication::sendEvent(&panel_, &event);
  QMenu* menu = nullptr;
  for (QMenu* each : panel_.findChildren<QMenu*>()) {
    if (each != panel_.menu() && each->isVisible()) menu = each;
  }
  ASSERT_NE(menu, nullptr);
  int asked = 0;
  QObject::connect(&panel_, &PlotPanel::pictureAsked, [&] { ++asked; });
  QObject::connect(&panel_, &PlotPanel::dataAsked, [&] { ++asked; });
  QObject::connect(&panel_, &PlotPanel::dataCopyAsked, [&] { ++asked; });
  panel_.set_plots({named("drift"), named("energy")}, {});
  QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
  for (const QString text :
       {"&Remove this plot", "&Change this plot...", "&Save the picture...", "&Copy the picture",
        "Save the &data...", "Copy &all the data", "Copy the data that is s&hown"}) {
    for (QAction* action : menu->actions()) {
      if (action->text() == text) action->trigger();
    }
  }
  EXPECT_EQ(asked, 0);
  EXPECT_EQ(panel_.plots().size(), 2U);
  menu->close();
}

}  // namespace
}  // namespace carom
