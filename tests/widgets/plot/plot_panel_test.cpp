#include "widgets/plot/plot_panel.h"

#include <QApplication>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QTest>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <qwt_plot.h>
#include <qwt_plot_curve.h>
#include <qwt_scale_div.h>
#include <qwt_scale_widget.h>

#include "physics/preset/names.h"
#include "physics/preset/preset.h"
#include "physics/scene/validate.h"
#include "tests/support/run_fixture.h"
#include "tests/widgets/plot/plot_panel_fixture.h"
#include "widgets/base/number_text.h"
#include "widgets/plot/legend_button.h"
#include "widgets/plot/plot_content.h"
#include "widgets/plot/plot_dialog.h"
#include "widgets/plot/reading_table.h"
#include "widgets/plot/run_plot.h"
#include "widgets/theme/theme.h"

namespace carom {
namespace {

// Wheel notches towards the user are negative.
void wheel(QWidget* widget, const QPoint& at, int notches, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
  QWheelEvent event(at, widget->mapToGlobal(at), QPoint(), QPoint(0, 120 * notches), Qt::NoButton, modifiers,
                    Qt::NoScrollPhase, false);
  QApplication::sendEvent(widget, &event);
  QApplication::processEvents();
}

// Replaces the values of a scene's observable in the frame's rows by value(row).
template <class Value>
void set_values(Frame& frame, std::string_view observable, const Value& value) {
  Rows& rows = frame.rows[0];
  const std::size_t width = rows.curves->size();
  for (std::size_t column = 0; column < width; ++column) {
    if ((*rows.curves)[column].y.observable->name != observable) continue;
    for (std::size_t i = 0; i < rows.size(); ++i)
      rows.values[i * width + column] = value(static_cast<double>(i));
  }
}

class PlotPanelTest : public PlotPanelFixture {
 protected:
  [[nodiscard]] QWidget* canvas(int plot) const {
    return panel.plots()[static_cast<std::size_t>(plot)]->plot()->canvas();
  }
  [[nodiscard]] RunPlot* plot(int index) const { return panel.plots()[static_cast<std::size_t>(index)]; }
  [[nodiscard]] bool chip_shown(int index) const {
    const auto labels = plot(index)->findChildren<QLabel*>("chip");
    return std::any_of(labels.begin(), labels.end(), [](const QLabel* label) {
      return label->isVisible() && label->text().startsWith("zoomed");
    });
  }
};

TEST_F(PlotPanelTest, StacksThePlotsAskedForOverOneAxis) {
  show(run_to(head_on_scene(), 0.45, panel.curves()));
  ASSERT_EQ(panel.plots().size(), 3u);
  for (const RunPlot* each : panel.plots()) {
    EXPECT_EQ(each->time_range(), QwtInterval(0.0, 0.5));
    EXPECT_EQ(each->plot()->canvas()->mapTo(&panel, QPoint()).x(), canvas(0)->mapTo(&panel, QPoint()).x());
    EXPECT_EQ(each->plot()->canvas()->width(), canvas(0)->width());
  }
  EXPECT_EQ(plot(0)->value_range().minValue(), 0.0);
  EXPECT_GE(plot(0)->value_range().maxValue(), 4.5);

  panel.set_plots({named("impulse"), named("energy")}, {});
  ASSERT_EQ(panel.plots().size(), 2u);
  EXPECT_EQ(plot(0)->content().plot.id, "impulse");
  EXPECT_EQ(plot(1)->content().plot.id, "energy");
}

TEST_F(PlotPanelTest, TheUserChoosesPlots) {
  show(run_to(head_on_scene(), 0.45, panel.curves()));
  const QList<QAction*> actions = panel.menu()->actions();
  const auto action = [&](const QString& id) {
    return *std::find_if(actions.begin(), actions.end(), [&](QAction* a) { return a->data() == id; });
  };
  EXPECT_FALSE(action("drift")->isChecked());
  action("drift")->trigger();
  ASSERT_EQ(panel.plots().size(), 4u);
  EXPECT_EQ(plot(3)->content().plot.id, "drift");
  action("ledger")->trigger();
  EXPECT_EQ(plot(3)->content().plot.id, "ledger") << "at its place";
  EXPECT_TRUE(action("ledger")->isChecked());
  for (const char* id : {"energy", "ledger", "drift", "momentum"}) action(id)->trigger();
  ASSERT_EQ(panel.plots().size(), 1u);
  EXPECT_TRUE(panel.shows("impulse"));
  EXPECT_FALSE(action("impulse")->isEnabled()) << "the last one stays";
  panel.set_plots({named("drift")}, {});
  EXPECT_TRUE(action("drift")->isChecked());
  EXPECT_FALSE(action("impulse")->isChecked());
}

TEST_F(PlotPanelTest, NamesOfPresetFilesAreThePlots) {
  ASSERT_EQ(named_plots().size(), kPlotNames.size());
  for (std::size_t i = 0; i < kPlotNames.size(); ++i) EXPECT_EQ(named_plots()[i].plot.id, kPlotNames[i]);
}

// 1e-6 kg in millimetres: 1e-11 J and 1e-9 N s.
TEST_F(PlotPanelTest, ASmallSceneIsNoNoise) {
  Preset preset = head_on_scene();
  for (Body& body : preset.scene.bodies) {
    body.shape = Disc{0.2e-3};
    body.position *= 1e-3;
    body.velocity *= 1e-3;
    *body.mass *= 1e-6;
  }
  show(run_to(preset, 0.45, panel.curves()));
  EXPECT_NEAR(plot(0)->value_range().maxValue(), 5e-12, 1e-12);
  EXPECT_NEAR(plot(1)->value_range().maxValue(), 3e-9, 1.1e-9);
  EXPECT_NEAR(plot(2)->value_range().maxValue(), 4e-9, 1.1e-9);
}

TEST_F(PlotPanelTest, AConservedZeroIsAFlatLine) {
  Preset preset = head_on_scene();
  preset.scene.bodies[0].velocity = Vec2(1.0, 0.7);
  preset.scene.bodies[1].velocity = Vec2(-0.5, -0.35);  // no momentum in sum
  Frame frame = run_to(preset, 1.0, panel.curves());
  set_values(frame, "momentum_x", [](double row) { return 1e-16 * std::fmod(row, 7.0); });
  set_values(frame, "momentum_y", [](double) { return -1e-16; });
  show(frame);
  EXPECT_GT(plot(1)->value_range().maxValue(), 1.0);
  EXPECT_LT(plot(1)->value_range().maxValue(), 10.0);
}

TEST_F(PlotPanelTest, ADriftHasAScaleOfItsOwn) {
  panel.set_plots({named("drift")}, {});
  Frame frame = run_to(head_on_scene(), 1.0, panel.curves());
  const auto rows = static_cast<double>(frame.rows[0].size());
  set_values(frame, "numerical_drift", [rows](double row) { return -1e-12 * row / rows; });
  show(frame);
  EXPECT_LE(plot(0)->value_range().minValue(), -1e-12);
  EXPECT_GT(plot(0)->value_range().minValue(), -3e-12);
  set_values(frame, "numerical_drift", [](double) { return 1e-17; });
  frame.run = 2;
  recorder->add(frame);
  panel.update_from({{recorder, "run"}});
  panel.show_now();
  QApplication::processEvents();
  EXPECT_NEAR(plot(0)->value_range().maxValue(), 5e-15, 1e-16) << "rounding of 4.5 J";
}

TEST_F(PlotPanelTest, LegendHidesAndShowsACurve) {
  show(run_to(head_on_scene(), 0.5, panel.curves()));
  const auto buttons = plot(0)->findChildren<LegendButton*>();
  ASSERT_EQ(buttons.size(), 4);
  EXPECT_TRUE(buttons[2]->isVisible());
  EXPECT_FALSE(buttons[3]->isVisible()) << "there is no run before";
  const auto shown = [this](const QString& title) {
    for (const QwtPlotItem* item : plot(0)->plot()->itemList(QwtPlotItem::Rtti_PlotCurve)) {
      if (item->title().text() == title) return item->isVisible();
    }
    ADD_FAILURE() << "no curve " << title.toStdString();
    return false;
  };
  ASSERT_EQ(buttons[0]->text(), "kinetic");
  QTest::mouseClick(buttons[0], Qt::LeftButton);
  EXPECT_FALSE(shown("kinetic"));
  EXPECT_TRUE(shown("potential"));
  EXPECT_TRUE(shown("total"));
  QTest::mouseClick(buttons[0], Qt::LeftButton);
  EXPECT_TRUE(shown("kinetic"));
}

// Its first click is no click of its own.
TEST_F(PlotPanelTest, ADoubleClickLeavesTheMarksAlone) {
  show(run_to(head_on_scene(), 1.0, panel.curves()));
  const QPoint a(canvas(1)->width() / 4, canvas(1)->height() / 2);
  const auto double_click = [&](const QPoint& at) {
    QTest::mouseClick(canvas(1), Qt::LeftButton, Qt::NoModifier, at);
    QTest::mouseDClick(canvas(1), Qt::LeftButton, Qt::NoModifier, at);
  };
  double_click(a);
  EXPECT_FALSE(panel.marks().a);
  QTest::mouseClick(canvas(1), Qt::LeftButton, Qt::NoModifier, a);
  const auto mark = panel.marks().a;
  ASSERT_TRUE(mark);
  double_click(2 * a);
  EXPECT_EQ(panel.marks().a, mark);
}

TEST_F(PlotPanelTest, WheelZoomsAllTimeAxesAboutTheCursorAndDoubleClickResets) {
  show(run_to(head_on_scene(), 1.0, panel.curves()));
  const QPoint at(canvas(1)->width() / 4, canvas(1)->height() / 2);
  const double under = plot(1)->plot()->invTransform(QwtAxis::XBottom, at.x());
  wheel(canvas(1), at, 2);
  EXPECT_TRUE(panel.zoomed());
  const QwtInterval zoomed = plot(0)->time_range();
  EXPECT_NEAR(zoomed.width(), 0.64, 1e-12);
  for (const RunPlot* each : panel.plots()) EXPECT_EQ(each->time_range(), zoomed);
  // Labels that need more room may have moved the canvas by a few pixels.
  EXPECT_NEAR(plot(1)->plot()->transform(QwtAxis::XBottom, under), at.x(), 8.0);
  EXPECT_FALSE(chip_shown(0));
  EXPECT_TRUE(chip_shown(1));

  // While zoomed, new data leave the axes alone.
  Frame later = run_to(head_on_scene(), 5.0, panel.curves());
  later.run = 2;
  recorder->add(later);
  panel.update_from({{recorder, "run"}});
  panel.show_now();
  QApplication::processEvents();
  EXPECT_EQ(plot(0)->time_range(), zoomed);

  QTest::mouseDClick(canvas(2), Qt::LeftButton);
  QApplication::processEvents();
  EXPECT_FALSE(panel.zoomed());
  EXPECT_FALSE(chip_shown(1));
  for (const RunPlot* each : panel.plots()) EXPECT_EQ(each->time_range(), QwtInterval(0.0, 5.0));
}

TEST_F(PlotPanelTest, CtrlWheelZoomsTheValuesOfOnePlotAndCtrlHomeResets) {
  show(run_to(head_on_scene(), 1.0, panel.curves()));
  const QwtInterval energy = plot(0)->value_range();
  const QwtInterval momentum = plot(1)->value_range();
  wheel(canvas(0), {50, 20}, 1, Qt::ControlModifier);
  EXPECT_NEAR(plot(0)->value_range().width(), 0.8 * energy.width(), 1e-12);
  EXPECT_EQ(plot(1)->value_range(), momentum);
  EXPECT_EQ(plot(0)->time_range(), QwtInterval(0.0, 1.0));
  QTest::keyClick(canvas(0), Qt::Key_Home, Qt::ControlModifier);
  QApplication::processEvents();
  EXPECT_FALSE(panel.zoomed());
  EXPECT_EQ(plot(0)->value_range(), energy);
}

TEST_F(PlotPanelTest, DragMovesTimeOfAllAndValuesOfOne) {
  show(run_to(head_on_scene(), 1.0, panel.curves()));
  const QwtInterval momentum = plot(1)->value_range();
  QTest::mousePress(canvas(0), Qt::LeftButton, Qt::NoModifier, {100, 50});
  QTest::mouseMove(canvas(0), {101, 50});
  QApplication::processEvents();
  EXPECT_FALSE(panel.zoomed());
  QMouseEvent move(QEvent::MouseMove, QPointF(60, 50), canvas(0)->mapToGlobal(QPointF(60, 50)), Qt::NoButton,
                   Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(canvas(0), &move);
  QTest::mouseRelease(canvas(0), Qt::LeftButton, Qt::NoModifier, {60, 50});
  QApplication::processEvents();
  EXPECT_GT(plot(2)->time_range().minValue(), 0.05);
  EXPECT_NEAR(plot(2)->time_range().width(), 1.0, 1e-12);
  EXPECT_EQ(plot(1)->value_range(), momentum);
}

TEST_F(PlotPanelTest, ConstantDataHaveARange) {
  Preset preset;
  preset.scene.bodies = {disc("A", {0.0, 0.0}, {0.1, 0.0}, 3.0)};
  show(run_to(preset, 1.0, panel.curves()));
  const QwtInterval energy = plot(0)->value_range();
  EXPECT_TRUE(std::isfinite(energy.width()));
  EXPECT_LE(energy.minValue(), 0.0);
  EXPECT_GT(energy.maxValue(), 0.015);
  EXPECT_LT(energy.maxValue(), 0.05);
  EXPECT_EQ(plot(2)->value_range(), QwtInterval(-1.0, 1.0));  // no impacts
}

// A quantity of a body, two in one plot, and a path: the texts of lines and title.
TEST_F(PlotPanelTest, PlotsOfAnyQuantity) {
  const std::vector<Body> bodies = head_on_scene().scene.bodies;
  Plot speeds;
  speeds.y = {{"speed", {"A"}}, {"speed", {"B"}}};
  Plot path;
  path.y = {{"velocity_x", {"A"}}};
  path.x = QuantityName{"x", {"A"}};
  Plot mixed;
  mixed.y = {{"x", {"A"}}, {"kinetic_energy", {}}};
  Plot drift;
  drift.y = {{"numerical_drift", {}}};
  drift.logarithmic = true;
  panel.set_plots({speeds, path, mixed, drift}, bodies);
  EXPECT_EQ(panel.chosen(), (std::vector<Plot>{speeds, path, mixed, drift}));
  EXPECT_EQ(panel.curves().size(), 6u);
  EXPECT_EQ(plot(0)->content().title, "Speed");
  EXPECT_EQ(plot(0)->content().unit.name, "m/s");
  EXPECT_EQ(plot(0)->content().lines[1].label, "B");
  EXPECT_EQ(plot(1)->content().title, "Velocity x over x of A");
  EXPECT_EQ(plot(2)->content().legend(plot(2)->content().lines[0]), "x of A / m");
  EXPECT_EQ(plot(3)->content().title, "|numerical drift|");
  show(run_to(head_on_scene(), 1.0, panel.curves()));
  EXPECT_EQ(plot(0)->value_range(), QwtInterval(0.0, 4.0));
  EXPECT_GT(plot(3)->value_range().minValue(), 0.0);
  // From -1 m at 3 m/s to the impact, back at -1 m/s from 0.2 s on: at -1.2 m after 1 s.
  const QwtInterval x = plot(1)->plot()->axisScaleDiv(QwtAxis::XBottom).interval();
  EXPECT_LE(x.minValue(), -1.2);
  EXPECT_GE(x.maxValue(), -0.4);
  EXPECT_LE(x.width(), 1.5);
  const auto time = plot(0)->time_range();
  wheel(canvas(1), {20, 20}, 1);
  EXPECT_EQ(plot(0)->time_range(), time) << "the path has an axis of its own";
  EXPECT_LT(plot(1)->plot()->axisScaleDiv(QwtAxis::XBottom).interval().width(), 0.9 * x.width());
}

// Clicks mark records, arrows move to the next one; the table has their values: the kinetic energy of the
// head-on impact is 4.5 J before and after, the momentum of A alone falls from 3 to -1 N s.
TEST_F(PlotPanelTest, MarksAreRead) {
  Plot momentum;
  momentum.y = {{"body_momentum_x", {"A"}}};
  panel.set_plots({named("energy"), momentum}, head_on_scene().scene.bodies);
  show(run_to(head_on_scene(), 1.0, panel.curves()));
  const auto click = [&](double time, Qt::KeyboardModifiers modifiers) {
    const auto x = static_cast<int>(std::lround(plot(0)->plot()->transform(QwtAxis::XBottom, time)));
    QTest::mouseClick(canvas(0), Qt::LeftButton, modifiers, {x, 20});
    QApplication::processEvents();
  };
  EXPECT_FALSE(panel.marks().a.has_value());
  click(0.1, Qt::NoModifier);
  click(0.5, Qt::ShiftModifier);
  ASSERT_TRUE(panel.marks().a && panel.marks().b);
  EXPECT_NEAR(*panel.marks().a, 0.1, 0.009) << "a pixel, and the record before";
  EXPECT_NEAR(std::remainder(*panel.marks().a, 0.005), 0.0, 1e-12) << "a record's time";
  const double before = *panel.marks().a;
  QTest::keyClick(&panel, Qt::Key_Right);
  EXPECT_NEAR(*panel.marks().a, before + 0.005, 1e-12);
  QTest::keyClick(&panel, Qt::Key_Left);
  EXPECT_EQ(*panel.marks().a, before);

  ReadingTable table;
  table.update_from({{recorder, "run"}}, panel.contents(), panel.marks());
  const auto text = [&](int row, int column) { return table.model()->index(row, column).data().toString(); };
  EXPECT_EQ(text(0, 0), "time / s");
  EXPECT_EQ(text(1, 0), "Energy, kinetic / J");
  EXPECT_EQ(text(1, 1), "4.500");
  EXPECT_EQ(text(1, 7), "4.50");
  EXPECT_EQ(text(4, 0), QString::fromUtf8("Momentum x of A / N·s"));
  EXPECT_EQ(text(4, 1), "3.000");
  EXPECT_EQ(text(4, 2), QString::fromUtf8("−1.000"));
  EXPECT_EQ(text(4, 3), QString::fromUtf8("−4.000"));
  const double a = *panel.marks().a;
  const double b = *panel.marks().b;
  const double area = 3.0 * (0.2 - a) - 1.0 * (b - 0.2);
  EXPECT_EQ(text(4, 4), figure(-4.0 / (b - a), 3));
  EXPECT_EQ(text(4, 5), figure(area, 3));
  EXPECT_EQ(text(4, 6), figure(area / (b - a), 3));
  QTest::keyClick(&panel, Qt::Key_Escape);
  EXPECT_FALSE(panel.marks().a || panel.marks().b);
}

TEST_F(PlotPanelTest, PlotsComeChangeAndGo) {
  panel.set_plots({named("energy")}, head_on_scene().scene.bodies);
  int changes = 0;
  QObject::connect(&panel, &PlotPanel::layoutChanged, [&] { ++changes; });
  Plot spin;
  spin.y = {{"spin", {"B"}}};
  panel.add(spin);
  ASSERT_EQ(panel.plots().size(), 2u);
  spin.logarithmic = true;
  panel.replace(plot(1), spin);
  ASSERT_EQ(panel.plots().size(), 2u);
  EXPECT_EQ(panel.chosen()[1], spin);
  spin.y[0].bodies = {"nobody"};
  EXPECT_THROW(panel.replace(plot(1), spin), SceneError);
  EXPECT_THROW(panel.add(spin), SceneError);
  EXPECT_EQ(panel.plots().size(), 2u);
  panel.remove(plot(0));
  panel.remove(plot(0));
  EXPECT_EQ(panel.plots().size(), 1u) << "the last one stays";
  EXPECT_EQ(changes, 3);
}

TEST(PlotDialog, AnotherCurveIsOfTheNextBody) {
  std::vector<Body> bodies = head_on_scene().scene.bodies;
  bodies[1].fixed = true;
  bodies.push_back(disc("C", {5.0, 0.0}, {0.0, 0.0}, 1.0));
  PlotDialog dialog(bodies);
  Plot speed;
  speed.y = {{"speed", {"A"}}};
  dialog.set_plot(speed);
  for (QPushButton* button : dialog.findChildren<QPushButton*>()) {
    if (button->text().startsWith("+")) button->click();
  }
  EXPECT_EQ(dialog.plot().y, (std::vector<QuantityName>{{"speed", {"A"}}, {"speed", {"C"}}}));
}

TEST(PlotDialog, PutsAPlotTogether) {
  const std::vector<Body> bodies = head_on_scene().scene.bodies;
  PlotDialog dialog(bodies);
  auto* ok = dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok);
  EXPECT_TRUE(ok->isEnabled());
  Plot wanted;
  wanted.title = "Both";
  wanted.y = {{"distance", {"A", "B"}}, {"speed", {"B"}}, {"total_energy", {}}};
  wanted.x = QuantityName{"x", {"B"}};
  wanted.logarithmic = true;
  dialog.set_plot(wanted);
  EXPECT_EQ(dialog.plot(), wanted);
  QPushButton* away = dialog.findChildren<QPushButton*>(QString(), Qt::FindChildrenRecursively)[0];
  for (QPushButton* button : dialog.findChildren<QPushButton*>()) {
    if (button->toolTip().startsWith("Remove this curve")) away = button;
  }
  away->click();
  EXPECT_EQ(dialog.plot().y.size(), 2u);
  // A body that does not exist.
  dialog.findChildren<QComboBox*>()[1]->setCurrentText("nobody");
  EXPECT_FALSE(ok->isEnabled());
}

// Also between the frames of a run that plays.
TEST_F(PlotPanelTest, AllPlotsEndAtTheSameMoment) {
  show(run_to(head_on_scene(), 0.2, panel.curves()));
  const auto ends = [this](int index) {
    const auto* curve =
        static_cast<const QwtPlotCurve*>(plot(index)->plot()->itemList(QwtPlotItem::Rtti_PlotCurve).front());
    return curve->sample(static_cast<int>(curve->dataSize()) - 1).x();
  };
  double newest = 0.2;
  for (int i = 0; i < 10; ++i) {
    newest += 0.01;
    recorder = std::make_shared<Recorder>();
    recorder->add(run_to(head_on_scene(), newest, panel.curves()));
    panel.update_from({{recorder, "run"}});
    QApplication::processEvents();
    EXPECT_EQ(ends(0), ends(1)) << "after frame " << i;
  }
  EXPECT_TRUE(QTest::qWaitFor([&] { return std::abs(ends(0) - newest) < 2e-3; }, 1000));
}

TEST_F(PlotPanelTest, TheTimeAxisSpansTheDurationFromTheStart) {
  panel.set_duration(3.0);
  for (const double time : {0.01, 0.9, 2.5}) {
    recorder = std::make_shared<Recorder>();
    show(run_to(head_on_scene(), time, panel.curves()));
    for (const RunPlot* each : panel.plots()) EXPECT_EQ(each->time_range(), QwtInterval(0.0, 3.0)) << time;
  }
}

// Also where one had wider labels of its values before.
TEST_F(PlotPanelTest, AllTimeAxesHaveTheSameTicks) {
  show(run_to(head_on_scene(), 0.9, panel.curves()));
  for (int width = 340; width < 440; width += 3) {
    panel.resize(width, 560);
    QApplication::processEvents();
    plot(0)->axes().set_label_extent(80);
    panel.show_now();
    const auto ticks = [this](int index) {
      return plot(index)->plot()->axisScaleDiv(QwtAxis::XBottom).ticks(QwtScaleDiv::MajorTick);
    };
    EXPECT_EQ(ticks(0), ticks(1)) << width;
    EXPECT_EQ(ticks(0), ticks(2)) << width;
  }
}

TEST_F(PlotPanelTest, HiddenItDoesNothing) {
  recorder->add(run_to(head_on_scene(), 2.0, panel.curves()));
  panel.update_from({{recorder, "run"}});
  QApplication::processEvents();
  EXPECT_EQ(plot(0)->time_range(), QwtInterval(0.0, 1.0));
  panel.show();
  QApplication::processEvents();
  EXPECT_EQ(plot(0)->time_range(), QwtInterval(0.0, 2.0));
}

// As a frame about it, which leaves its ground as it is.
TEST_F(PlotPanelTest, APlotWithTheFocusHasAFrame) {
  show(run_to(head_on_scene(), 0.45, panel.curves()));
  QWidget* canvas = plot(0)->plot()->canvas();
  const QPoint ground(canvas->width() / 2, 6);
  for (const Theme& theme : {light_theme(), dark_theme()}) {
    panel.set_theme(theme);
    canvas->clearFocus();
    EXPECT_NE(canvas->grab().toImage().pixelColor(0, canvas->height() / 2), theme.accent);
    panel.activateWindow();
    canvas->setFocus();
    QApplication::processEvents();
    ASSERT_TRUE(canvas->hasFocus());
    const QImage focused = canvas->grab().toImage();
    EXPECT_EQ(focused.pixelColor(ground), theme.panel);
    for (const int x : {0, 1}) EXPECT_EQ(focused.pixelColor(x, canvas->height() / 2), theme.accent) << x;
    EXPECT_NE(focused.pixelColor(2, canvas->height() / 2), theme.accent);
  }
}

}  // namespace
}  // namespace carom
