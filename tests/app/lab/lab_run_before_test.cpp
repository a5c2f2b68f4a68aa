#include <QSettings>
#include <algorithm>
#include <cmath>
#include <qwt_plot.h>
#include <qwt_plot_curve.h>

#include "tests/app/lab/hands_fixture.h"
#include "tests/support/scenes.h"
#include "widgets/plot/run_plot.h"

// The run before, pale in the window's plots and scene.
namespace carom {
namespace {

class LabRunBeforeTest : public LabHandsTest {
 protected:
  void SetUp() override {
    ASSERT_NO_FATAL_FAILURE(LabHandsTest::SetUp());
    name_ = window_.preset().scene.bodies[0].name;
  }
  [[nodiscard]] PlotPanel& panel() const { return *window_.findChild<PlotPanel*>(); }
  [[nodiscard]] RunPlot& plot() const { return *panel().plots().front(); }
  // Of the first plot.
  [[nodiscard]] bool in_legend() {
    panel().show_now();
    for (const auto& [name, pen] : plot().legend()) {
      if (name == "run before") return true;
    }
    return false;
  }
  // The times of the first plot's pale curve; nothing where none is shown.
  [[nodiscard]] std::vector<double> pale_times() {
    panel().show_now();
    constexpr double kPale = 10.0;
    for (const QwtPlotItem* item : plot().plot()->itemList(QwtPlotItem::Rtti_PlotCurve)) {
      const auto* curve = static_cast<const QwtPlotCurve*>(item);
      if (curve->z() != kPale || !curve->isVisible() || curve->dataSize() == 0) continue;
      std::vector<double> times;
      for (std::size_t i = 0; i < curve->dataSize(); ++i)
        times.push_back(curve->sample(static_cast<int>(i)).x());
      return times;
    }
    return {};
  }
  // s, where it begins and ends; NaN: nowhere.
  [[nodiscard]] double pale_begin() {
    const std::vector<double> times = pale_times();
    return times.empty() ? std::nan("") : times.front();
  }
  [[nodiscard]] double pale_end() {
    const std::vector<double> times = pale_times();
    return times.empty() ? std::nan("") : times.back();
  }
  void restart() {
    key(Qt::Key_R);
    ASSERT_TRUE(shows_start());
  }
  // The scene knows where the bodies were at each of these steps.
  void make_steps(int count) {
    const std::int64_t until = steps() + count;
    while (steps() < until) {
      const std::int64_t now = steps();
      key(Qt::Key_Period);
      ASSERT_TRUE(wait_for([&] { return steps() == now + 1 && window_.frame()->scene; }));
    }
  }
  // The discs that are drawn as outlines alone.
  [[nodiscard]] std::vector<Vec2> outlines() {
    std::vector<Vec2> centers;
    for (const Drawing::DiscItem& disc : window_.scene_view().drawing().discs) {
      if (disc.fill.alpha() == 0) centers.push_back(disc.center);
    }
    return centers;
  }

  std::string name_;
};

TEST_F(LabRunBeforeTest, ARestartLeavesItPaleInThePlots) {
  window_.run_until(0.8);
  EXPECT_FALSE(in_legend());
  restart();
  EXPECT_TRUE(in_legend());
  EXPECT_EQ(pale_begin(), 0.0);
  EXPECT_NEAR(pale_end(), 0.8, 0.006);
  EXPECT_GE(plot().time_range().maxValue(), 0.8) << "the axis has room for it";
  key(Qt::Key_Z, Qt::ControlModifier);
  ASSERT_TRUE(wait_for([this] { return time() > 0.7; }));
  EXPECT_FALSE(in_legend()) << "it is the present run again";
  EXPECT_TRUE(pale_times().empty());
}

TEST_F(LabRunBeforeTest, ANewStartLeavesIt) {
  window_.run_until(0.8);
  window_.scene_view().select({name_});
  window_.scene_view().setFocus();
  key(Qt::Key_Up);
  ASSERT_TRUE(shows_start());
  EXPECT_TRUE(in_legend());
  EXPECT_NEAR(pale_end(), 0.8, 0.006);
  window_.run_until(0.3);
  restart();
  EXPECT_NEAR(pale_end(), 0.8, 0.006) << "a restart of this start leaves it";
  window_.run_until(0.2);
  window_.scene_view().select({name_});
  window_.scene_view().setFocus();
  key(Qt::Key_Up);
  ASSERT_TRUE(shows_start());
  EXPECT_NEAR(pale_end(), 0.2, 0.006) << "until the next new start";
}

TEST_F(LabRunBeforeTest, TheRestThatIsCutOffIsPaleFromThereOn) {
  window_.run_until(0.8);
  window_.session().runs().go_to(0.5);
  ASSERT_TRUE(wait_for([this] { return window_.session().runs().there(); }));
  key(Qt::Key_G);
  ASSERT_TRUE(wait_for([this] { return !window_.session().runs().in_past() && window_.frame()->scene; }));
  ASSERT_NEAR(time(), 0.5, 0.006);
  ASSERT_TRUE(in_legend());
  // The line begins at the last point before the cut.
  EXPECT_NEAR(pale_begin(), 0.5, 0.011);
  EXPECT_NEAR(pale_end(), 0.8, 0.006);
  key(Qt::Key_Z, Qt::ControlModifier);
  ASSERT_TRUE(wait_for([this] { return window_.session().runs().newest().front()->time > 0.7; }));
  EXPECT_FALSE(in_legend());
}

TEST_F(LabRunBeforeTest, ShiftBHidesItAndIsRemembered) {
  window_.run_until(0.8);
  restart();
  ASSERT_TRUE(in_legend());
  key(Qt::Key_B, Qt::ShiftModifier);
  EXPECT_FALSE(action("Run before")->isChecked());
  EXPECT_FALSE(in_legend());
  EXPECT_TRUE(pale_times().empty());
  EXPECT_LT(plot().time_range().maxValue(), 1.1);
  QSettings settings(folder_.filePath("carom.ini"), QSettings::IniFormat);
  window_.keep_layout(settings);
  LabWindow next(light_theme());
  next.restore_layout(settings);
  EXPECT_FALSE(next.scene_view().options().run_before);
  key(Qt::Key_B, Qt::ShiftModifier);
  EXPECT_TRUE(in_legend());
  window_.keep_layout(settings);
  LabWindow last(light_theme());
  last.restore_layout(settings);
  EXPECT_TRUE(last.scene_view().options().run_before);
}

TEST_F(LabRunBeforeTest, ItsBodiesAreOutlinesAtTheSameTimeSinceTheStart) {
  make_steps(30);
  EXPECT_TRUE(outlines().empty());
  key(Qt::Key_R);
  ASSERT_TRUE(shows_start());
  ASSERT_EQ(outlines().size(), 2U);
  make_steps(20);
  const double first = time();
  restart();
  ASSERT_EQ(outlines().size(), 2U);
  EXPECT_LT((outlines()[0] - window_.frame()->state.position(0)).norm(), 1e-5);
  key(Qt::Key_Period);
  ASSERT_TRUE(wait_for([this] { return steps() == 1; }));
  ASSERT_EQ(outlines().size(), 2U);
  EXPECT_LT((outlines()[0] - window_.frame()->state.position(0)).norm(), 1e-5) << "the same run again";
  key(Qt::Key_B, Qt::ShiftModifier);
  EXPECT_TRUE(outlines().empty());
  key(Qt::Key_B, Qt::ShiftModifier);
  EXPECT_EQ(outlines().size(), 2U);
  window_.run_until(first + 0.1);
  EXPECT_TRUE(outlines().empty()) << "it did not come that far";
}

TEST_F(LabRunBeforeTest, DigitsAreTheSameWithAndWithoutIt) {
  window_.run_until(0.8);
  const State first = window_.frame()->state;
  for (const bool shown : {true, false}) {
    restart();
    EXPECT_EQ(action("Run before")->isChecked(), shown);
    window_.run_until(0.8);
    EXPECT_TRUE(test::same_bytes(window_.frame()->state, first)) << shown;
    key(Qt::Key_B, Qt::ShiftModifier);
  }
}

// Curves know bodies by their places, and a deleted body leaves its place to another.
TEST_F(LabRunBeforeTest, CurvesStayWithTheirBodies) {
  const std::string other = window_.preset().scene.bodies[1].name;
  Plot speed;
  speed.y = {{"speed", {other}}};
  window_.session().change_plots({speed});
  ASSERT_TRUE(wait_for([this] { return panel().plots().size() == 1; }));
  window_.run_until(0.2);
  window_.session().edit({Remove<Body>{now(name_).id}}, "Delete");
  ASSERT_TRUE(wait_for([this] { return time() == 0.0 && window_.frame()->bodies->size() == 1; }));
  ASSERT_TRUE(in_legend());
  EXPECT_NEAR(pale_end(), 0.2, 0.006);
}

}  // namespace
}  // namespace carom
