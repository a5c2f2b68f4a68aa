#include <algorithm>

#include "app/lab/drawer.h"
#include "tests/app/lab/lab_playhead_fixture.h"
#include "widgets/run/impacts_panel.h"

// The timeline, and the pace at which the record is played.
namespace carom {
namespace {

using LabTimelineTest = LabPlayheadTest;

TEST_F(LabTimelineTest, TheTimelineScrubs) {
  drag_timeline(0.9, 0.5);
  EXPECT_NEAR(time(), 0.5, 0.02);
  expect_step(steps());
  const double before = time();
  drag_timeline(before, before + 0.2, Qt::ShiftModifier);
  EXPECT_NEAR(time(), before + 0.02, 0.012) << "ten times finer";
  EXPECT_NEAR(timeline()->shown(), time(), 0.0);
  QWheelEvent wheel({5.0, 5.0}, timeline()->mapToGlobal(QPointF(5.0, 5.0)), {}, {0, -120}, Qt::NoButton,
                    Qt::NoModifier, Qt::NoScrollPhase, false);
  const std::int64_t at = steps();
  QApplication::sendEvent(timeline(), &wheel);
  ASSERT_TRUE(wait_there());
  expect_step(at - 1);
}

// 0.1 s of the run then take 2 s; live, and where the record is played.
TEST_F(LabTimelineTest, NearAnImpactItPlaysSlower) {
  action("Slow near impacts")->trigger();
  runs().go_to(0.25);
  ASSERT_TRUE(wait_there());
  runs().set_playing(true);
  expect_slow_near_the_impact();
  EXPECT_TRUE(wait_for([this] { return speed_chip().contains("slow near an impact"); }));
  runs().set_playing(false);
  window_.session().starts().restart();
  runs().set_playing(true);
  expect_slow_near_the_impact();
  double last = time();
  EXPECT_GT(first_shown([&] {
              if (runs().slow()) last = time();
              return !runs().slow();
            }),
            0.383);
  EXPECT_LT(last, 0.39);
}

// As that of a run, from which the chip says a lag.
TEST_F(LabTimelineTest, ThePaceOfTheRecordIsMeasured) {
  press(Qt::Key_Home);
  QTest::keyClick(&window_.scene_view(), Qt::Key_Space);
  double measured = 0.0;
  ASSERT_TRUE(wait_for([&] {
    if (runs().in_past()) measured = std::max(measured, window_.frame()->realised_speed);
    return measured > 0.0 || !runs().in_past();
  }));
  EXPECT_GT(measured, 0.0);
  EXPECT_LT(measured, 1.5);
  runs().set_playing(false);
}

// Pictures at 4 times the speed are 32 ms or more apart.
TEST_F(LabTimelineTest, NearAnImpactItPlaysSlowerHoweverFastBefore) {
  action("Slow near impacts")->trigger();
  choose_speed(4.0);
  runs().go_to_start();
  ASSERT_TRUE(wait_there());
  runs().set_playing(true);
  expect_slow_near_the_impact();
  runs().set_playing(false);
  window_.session().starts().restart();
  runs().set_playing(true);
  expect_slow_near_the_impact();
}

TEST_F(LabTimelineTest, AClickOnATickGoesToTheImpact) {
  const QPoint at(qRound(timeline()->x_of(1.0 / 3.0)) + 2, timeline()->height() / 2);
  QTest::mouseClick(timeline(), Qt::LeftButton, {}, at);
  ASSERT_TRUE(wait_there());
  EXPECT_EQ(chip("Impact at this moment")->text(), "impact 1 of 1");
}

TEST_F(LabTimelineTest, ATimeCanBeTyped) {
  QTest::mouseDClick(timeline(), Qt::LeftButton, {}, {40, timeline()->height() / 2});
  auto* field = timeline()->findChild<QLineEdit*>();
  ASSERT_TRUE(field->isVisible());
  QTest::keyClicks(field, "250 ms");
  QTest::keyClick(field, Qt::Key_Return);
  ASSERT_TRUE(wait_there());
  EXPECT_NEAR(time(), 0.25, 0.011);
  EXPECT_FALSE(field->isVisible());
}

// The field stays, red, and says why; Escape and a click elsewhere leave it.
TEST_F(LabTimelineTest, AWrongTimeIsSaid) {
  QTest::mouseDClick(timeline(), Qt::LeftButton, {}, {40, timeline()->height() / 2});
  auto* field = timeline()->findChild<QLineEdit*>();
  QTest::keyClicks(field, "soon");
  QTest::keyClick(field, Qt::Key_Return);
  EXPECT_TRUE(field->isVisible());
  EXPECT_TRUE(field->property("fault").toBool());
  EXPECT_FALSE(field->toolTip().isEmpty());
  field->selectAll();
  QTest::keyClicks(field, "7 s");
  EXPECT_FALSE(field->property("fault").toBool()) << "it is typed anew";
  QTest::keyClick(field, Qt::Key_Return);
  EXPECT_TRUE(field->isVisible());
  EXPECT_TRUE(field->toolTip().contains("The record goes from 0 to 1 s.")) << field->toolTip().toStdString();
  EXPECT_FALSE(runs().in_past());
  field->selectAll();
  QTest::keyClicks(field, "1");
  QTest::keyClick(field, Qt::Key_Return);
  EXPECT_FALSE(field->isVisible());
  QTest::mouseDClick(timeline(), Qt::LeftButton, {}, {40, timeline()->height() / 2});
  QTest::keyClicks(field, "0.5");
  window_.scene_view().setFocus();
  EXPECT_FALSE(field->isVisible());
}

TEST_F(LabTimelineTest, EscapeTakesAScrubBack) {
  press(Qt::Key_PageUp);
  const double impact = time();
  const auto drag_and_escape = [this](QWidget* on, const QPoint& from, const QPoint& to) {
    QTest::mousePress(on, Qt::LeftButton, {}, from);
    QMouseEvent move(QEvent::MouseMove, to, on->mapToGlobal(QPointF(to)), Qt::NoButton, Qt::LeftButton, {});
    QApplication::sendEvent(on, &move);
    ASSERT_TRUE(wait_there());
    EXPECT_GT(time(), 0.5);
    QTest::keyClick(&window_.scene_view(), Qt::Key_Escape);
    ASSERT_TRUE(wait_there());
    QMouseEvent more(QEvent::MouseMove, to + QPoint(5, 0), on->mapToGlobal(QPointF(to + QPoint(5, 0))),
                     Qt::NoButton, Qt::LeftButton, {});
    QApplication::sendEvent(on, &more);
    QTest::mouseRelease(on, Qt::LeftButton, {}, to);
    ASSERT_TRUE(wait_there());
  };
  const auto at = [this](double t) { return QPoint(qRound(timeline()->x_of(t)), timeline()->height() / 2); };
  drag_and_escape(timeline(), at(0.5), at(0.8));
  EXPECT_EQ(time(), impact);
  EXPECT_EQ(chip("Impact at this moment")->text(), "impact 1 of 1") << "it is picked again";
  auto* plots = window_.findChild<PlotPanel*>();
  plots->show_now();
  QwtPlot* plot = plots->plots().front()->plot();
  const auto on_plot = [plot](double t) { return QPoint(qRound(plot->transform(QwtAxis::XBottom, t)), 4); };
  drag_and_escape(plot->canvas(), on_plot(time()), on_plot(0.8));
  EXPECT_EQ(time(), impact);
  press(Qt::Key_End);
  drag_timeline(0.9, 0.5);
  EXPECT_NEAR(time(), 0.5, 0.02) << "the next drag moves again";
}

TEST_F(LabTimelineTest, ADoubleClickOnATickOpensTheImpact) {
  auto* panel = window_.findChild<ImpactsPanel*>();
  auto* drawer = window_.findChild<Drawer*>();
  drawer->set_folded(true);
  const QPoint at(qRound(timeline()->x_of(1.0 / 3.0)), timeline()->height() / 2);
  QTest::mouseClick(timeline(), Qt::LeftButton, {}, at);
  QTest::mouseDClick(timeline(), Qt::LeftButton, {}, at);
  ASSERT_TRUE(wait_there());
  EXPECT_TRUE(drawer->shows(panel));
  ASSERT_EQ(panel->table().model()->rowCount(), 1);
  EXPECT_EQ(panel->table().currentIndex().row(), 0);
  EXPECT_EQ(chip("Impact at this moment")->text(), "impact 1 of 1");
  EXPECT_FALSE(timeline()->findChild<QLineEdit*>()->isVisible());
  // The moment is just before it: the row is not pale as one that lies ahead.
  const auto* impacts = static_cast<const FigureModel*>(panel->table().model());
  EXPECT_FALSE(impacts->is_idle(0, 0));
  press(Qt::Key_Home);
  EXPECT_TRUE(impacts->is_idle(0, 0));
}

// Where the clock keeps its time, there is nothing before the start.
TEST_F(LabTimelineTest, TheTimelineIsFilledFromTheStartOn) {
  const auto filled = [this](double t) {
    const QImage image = timeline()->grab().toImage();
    return image.pixelColor(qRound(timeline()->x_of(t)), timeline()->height() / 2);
  };
  EXPECT_EQ(filled(0.1), light_theme().accent);
  timeline()->set_start(0.3);
  EXPECT_NE(filled(0.1), light_theme().accent);
  EXPECT_EQ(filled(0.6), light_theme().accent);
}

}  // namespace
}  // namespace carom
