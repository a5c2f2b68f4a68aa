#include <QTableView>
#include <qwt_axis.h>
#include <qwt_plot.h>

#include "app/lab/drawer.h"
#include "tests/app/lab/lab_playhead_fixture.h"
#include "widgets/edit/inspected.h"
#include "widgets/run/before_after_panel.h"
#include "widgets/run/impacts_panel.h"
#include "widgets/run/timeline.h"

// The playhead: moments of the record by keys and by the tables, and edits there.
namespace carom {
namespace {

TEST_F(LabPlayheadTest, KeysStepBackAndForthWithTheSameDigits) {
  const std::int64_t last = end_->steps;
  for (int i = 1; i <= 3; ++i) {
    press(Qt::Key_Comma);
    expect_step(last - i);
  }
  EXPECT_TRUE(runs().in_past());
  EXPECT_EQ(runs().newest().front()->steps, last);
  for (int i = 2; i >= 0; --i) {
    press(Qt::Key_Period);
    EXPECT_EQ(steps(), last - i);
  }
  EXPECT_FALSE(runs().in_past());
  EXPECT_TRUE(test::same_bytes(window_.frame()->state, end_->state));
  QTest::keyClick(&window_.scene_view(), Qt::Key_Period);
  ASSERT_TRUE(wait_for([=, this] { return steps() == last + 1; })) << "at the newest moment: a new step";
  EXPECT_FALSE(runs().in_past());
}

TEST_F(LabPlayheadTest, ManyKeysInARowAddUp) {
  for (int i = 0; i < 5; ++i) QTest::keyClick(&window_.scene_view(), Qt::Key_Comma);
  ASSERT_TRUE(wait_there());
  expect_step(end_->steps - 5);
}

TEST_F(LabPlayheadTest, ImpactsAndBothEnds) {
  press(Qt::Key_PageUp);
  EXPECT_NEAR(time(), 1.0 / 3.0, 1e-9);
  const Body& light = (*window_.frame()->bodies)[0];
  const Body& heavy = (*window_.frame()->bodies)[1];
  const State& touching = window_.frame()->state;
  EXPECT_NEAR((touching.position(0) - touching.position(1)).norm(),
              std::get<Disc>(light.shape).radius + std::get<Disc>(heavy.shape).radius, 1e-9);
  EXPECT_EQ(touching.velocity(0), light.velocity) << "before the impact";
  EXPECT_EQ(chip("Impact at this moment")->text(), "impact 1 of 1");
  EXPECT_TRUE(chip("Impact at this moment")->isVisible());
  EXPECT_EQ(window_.scene_view().accessibleDescription(), "paused at 0.333 s, impact 1 of 1, light with heavy");
  EXPECT_EQ(clock(), QString("t = %1 s of %2 s").arg(time(), 0, 'f', 3).arg(end_->time, 0, 'f', 3));
  press(Qt::Key_PageUp);
  EXPECT_EQ(steps(), 0) << "there is no earlier one";
  EXPECT_FALSE(chip("Impact at this moment")->isVisible());
  press(Qt::Key_PageDown);
  EXPECT_NEAR(time(), 1.0 / 3.0, 0.011);
  press(Qt::Key_End);
  EXPECT_FALSE(runs().in_past());
  EXPECT_EQ(steps(), end_->steps);
  press(Qt::Key_Home);
  expect_step(0);
  ASSERT_NE(window_.frame()->scene, nullptr) << "for edits";
}

// By `.` as by PgUp: where a step has the impact, it is shown.
TEST_F(LabPlayheadTest, AStepOntoAnImpactShowsIt) {
  const auto arrows = [this] { return window_.scene_view().drawing().jump.arrows.size(); };
  press(Qt::Key_PageUp);
  const std::size_t all = arrows();
  ASSERT_GT(all, 0U);
  press(Qt::Key_Comma);
  EXPECT_EQ(arrows(), 0U);
  press(Qt::Key_Period);
  EXPECT_EQ(arrows(), all);
  // In whole steps: that from 0.330 to 0.335 s has the impact.
  runs().go_to(0.33);
  ASSERT_TRUE(wait_there());
  EXPECT_EQ(arrows(), 0U);
  press(Qt::Key_Period);
  EXPECT_NEAR(time(), 0.335, 1e-9);
  EXPECT_EQ(arrows(), all);
  EXPECT_GT(window_.scene_view().drawing().velocity_key.amount, 0.0);
  press(Qt::Key_Period);
  EXPECT_EQ(arrows(), 0U);
  runs().go_to(0.335);  // not by a step
  ASSERT_TRUE(wait_there());
  EXPECT_EQ(arrows(), 0U);
}

TEST_F(LabPlayheadTest, AClickOnItsMarkInSceneOrPlotGoesToTheImpact) {
  runs().go_to(0.45);
  ASSERT_TRUE(wait_there());
  SceneView& scene = window_.scene_view();
  ASSERT_EQ(scene.drawing().marks.size(), 1U);
  const Vec2 mark = scene.drawing().marks.front().point;
  QTest::mouseClick(&scene, Qt::LeftButton, {}, scene.camera().to_screen(mark).toPoint());
  ASSERT_TRUE(wait_there());
  EXPECT_EQ(chip("Impact at this moment")->text(), "impact 1 of 1");
  ASSERT_TRUE(runs().picked());
  runs().go_to(0.45);
  ASSERT_TRUE(wait_there());
  EXPECT_FALSE(runs().picked());
  auto* plots = window_.findChild<PlotPanel*>();
  plots->show_now();
  QwtPlot* plot = plots->plots().front()->plot();
  const QPoint at(qRound(plot->transform(QwtAxis::XBottom, 1.0 / 3.0)), 20);
  QTest::mouseClick(plot->canvas(), Qt::LeftButton, {}, at);
  ASSERT_TRUE(wait_there());
  EXPECT_TRUE(runs().picked());
}

TEST_F(LabPlayheadTest, TheHeadOfThePlotsLineScrubs) {
  auto* plots = window_.findChild<PlotPanel*>();
  QwtPlot* plot = plots->plots().front()->plot();
  const auto drag = [&](double from, double to, Qt::KeyboardModifiers held = {}) {
    plots->show_now();
    const auto at = [&](double t) { return QPoint(qRound(plot->transform(QwtAxis::XBottom, t)), 4); };
    QTest::mousePress(plot->canvas(), Qt::LeftButton, held, at(from));
    QMouseEvent move(QEvent::MouseMove, at(to), plot->canvas()->mapToGlobal(QPointF(at(to))), Qt::NoButton,
                     Qt::LeftButton, held);
    QApplication::sendEvent(plot->canvas(), &move);
    QTest::mouseRelease(plot->canvas(), Qt::LeftButton, held, at(to));
    ASSERT_TRUE(wait_there());
  };
  runs().go_to(0.7);
  ASSERT_TRUE(wait_there());
  const QwtInterval range = plots->plots().front()->time_range();
  drag(time(), 0.5);
  EXPECT_NEAR(time(), 0.5, 0.012);
  expect_step(steps());
  EXPECT_EQ(plots->plots().front()->time_range(), range) << "the plot stays";
  EXPECT_FALSE(plots->marks().a);
  const double before = time();
  drag(before, before + 0.2, Qt::ShiftModifier);
  EXPECT_NEAR(time(), before + 0.02, 0.012) << "ten times finer";
  drag(time(), 2.0);
  EXPECT_FALSE(runs().in_past()) << "past the end is the newest moment";
}

TEST_F(LabPlayheadTest, ARowOfTheImpactsGoesToItsMoment) {
  auto* panel = window_.findChild<ImpactsPanel*>();
  ImpactsTable* table = &panel->table();
  auto* drawer = window_.findChild<Drawer*>();
  drawer->set_folded(false);
  drawer->choose(panel);
  QApplication::processEvents();
  const QPoint at = table->visualRect(table->model()->index(0, 1)).center();
  QTest::mouseClick(table->viewport(), Qt::LeftButton, {}, at);
  ASSERT_TRUE(wait_there());
  EXPECT_EQ(chip("Impact at this moment")->text(), "impact 1 of 1");
}

// The table follows the impact that is gone to.
TEST_F(LabPlayheadTest, BeforeAndAfterOfTheImpactThatIsGoneTo) {
  auto* panel = window_.findChild<BeforeAfterPanel*>();
  const QAbstractItemModel* table = panel->findChild<BeforeAfterTable*>()->model();
  window_.findChild<Drawer*>()->choose(panel);
  EXPECT_EQ(table->rowCount(), 3) << "no impact at the end: the last one";
  panel->choose(BeforeAfterPanel::Choice::kLast);
  EXPECT_EQ(table->rowCount(), 3);
  panel->choose(BeforeAfterPanel::Choice::kThis);
  press(Qt::Key_PageUp);
  ASSERT_EQ(table->rowCount(), 3);
  const auto cell = [table](int row, int column) { return table->index(row, column).data().toString(); };
  // By e = 0.6: (−0.5 − 0.6 · 2.5 · 3) / 3.5 m/s and (−0.5 + 0.6 · 3) / 3.5 m/s.
  EXPECT_EQ(cell(0, 4), "−1.43, 0.00");
  EXPECT_EQ(cell(1, 4), "0.371, 0.000");
  for (int row = 0; row < 2; ++row) EXPECT_EQ(cell(row, 3), cell(row, 4));
  EXPECT_EQ(cell(0, 5), "< 1e−12");
  press(Qt::Key_Comma);
  EXPECT_EQ(table->rowCount(), 0);
}

// Marks at the shown moment, by keys: the timeline shows them, and the table compares the run there.
TEST_F(LabPlayheadTest, BeforeAndAfterFromMarkToMark) {
  auto* panel = window_.findChild<BeforeAfterPanel*>();
  const QAbstractItemModel* table = panel->findChild<BeforeAfterTable*>()->model();
  auto* plots = window_.findChild<PlotPanel*>();
  auto* drawer = window_.findChild<Drawer*>();
  drawer->choose(panel);
  panel->choose(BeforeAfterPanel::Choice::kMarked);
  EXPECT_EQ(table->rowCount(), 0);
  QTest::keyClick(&window_.scene_view(), Qt::Key_M, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_EQ(plots->marks().b, std::optional(end_->time));
  const QImage without = timeline()->grab().toImage();
  press(Qt::Key_Home);
  QTest::keyClick(&window_.scene_view(), Qt::Key_M, Qt::ControlModifier);
  EXPECT_EQ(plots->marks().a, std::optional(0.0));
  EXPECT_TRUE(drawer->shows(panel)) << "the table of the marks stays";
  ASSERT_TRUE(wait_for([table] { return table->rowCount() == 5; }));
  const auto cell = [table](int row, int column) { return table->index(row, column).data().toString(); };
  EXPECT_EQ(cell(0, 2), "2.00, 0.00");
  EXPECT_EQ(cell(0, 4), "−1.43, 0.00");
  EXPECT_EQ(cell(3, 7), "−0.500, 0.000") << "theory";
  press(Qt::Key_End);
  EXPECT_NE(timeline()->grab().toImage(), without) << "mark A";
  panel->choose(BeforeAfterPanel::Choice::kThis);
  QTest::keyClick(&window_.scene_view(), Qt::Key_M, Qt::ControlModifier);
  EXPECT_TRUE(drawer->shows(panel)) << "no panel opens by itself";
}

TEST_F(LabPlayheadTest, SpacePlaysTheRecordOnAndPastIt) {
  press(Qt::Key_Home);
  choose_speed(20.0);
  QTest::keyClick(&window_.scene_view(), Qt::Key_Space);
  ASSERT_TRUE(runs().in_past());
  ASSERT_TRUE(wait_for([this] { return !runs().in_past() && !window_.frame()->playing; }));
  EXPECT_EQ(steps(), end_->steps) << "at the duration it stops";
  EXPECT_TRUE(test::same_bytes(window_.frame()->state, end_->state));
}

TEST_F(LabPlayheadTest, SpaceStopsAMomentOfTheRecord) {
  press(Qt::Key_Home);
  choose_speed(0.25);
  QTest::keyClick(&window_.scene_view(), Qt::Key_Space);
  ASSERT_TRUE(wait_for([this] { return window_.frame()->playing && time() > 0.05; }));
  press(Qt::Key_Space);
  EXPECT_TRUE(runs().in_past());
  expect_step(steps());
  ASSERT_NE(window_.frame()->scene, nullptr);
}

TEST_F(LabPlayheadTest, GoesOnFromHereUntilItIsUndone) {
  drag_timeline(0.9, 0.5);
  const std::int64_t at = steps();
  press(Qt::Key_G);
  ASSERT_TRUE(wait_for([=, this] { return !runs().in_past() && steps() == at; }));
  ASSERT_TRUE(wait_for([this] { return runs().recorders().front()->time() < 0.52; })) << "the rest is gone";
  EXPECT_EQ(runs().newest().front()->steps, at);
  window_.run_until(0.7);
  expect_step(steps());
  QTest::keyClick(&window_, Qt::Key_Z, Qt::ControlModifier);
  ASSERT_TRUE(wait_there());
  EXPECT_EQ(runs().newest().front()->steps, end_->steps);
  EXPECT_EQ(steps(), at) << "at the moment where it was cut";
  press(Qt::Key_End);
  EXPECT_TRUE(test::same_bytes(window_.frame()->state, end_->state));
  QTest::keyClick(&window_, Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  ASSERT_TRUE(wait_for([=, this] { return !runs().in_past() && steps() == at; }));
}

// Within a step too: there the run stands, the impact ahead.
TEST_F(LabPlayheadTest, GoesOnFromAnImpact) {
  press(Qt::Key_PageUp);
  const std::shared_ptr<const Frame> shown = window_.frame();
  press(Qt::Key_G);
  ASSERT_TRUE(wait_for([this] { return !runs().in_past() && window_.frame()->setup->edits.size() == 1; }));
  EXPECT_EQ(time(), shown->time);
  EXPECT_EQ(window_.frame()->impact_count, 0);
  EXPECT_TRUE(test::same_bytes(window_.frame()->state, shown->state));
  window_.run_until(1.0);
  EXPECT_EQ(window_.frame()->impact_count, 1);
  EXPECT_EQ(time(), end_->time) << "its other steps are where they were";
  EXPECT_LT((window_.frame()->state.q - end_->state.q).cwiseAbs().maxCoeff(), 1e-12);
  QTest::keyClick(&window_, Qt::Key_Z, Qt::ControlModifier);
  ASSERT_TRUE(wait_there());
  EXPECT_EQ(time(), shown->time);
  press(Qt::Key_End);
  EXPECT_TRUE(test::same_bytes(window_.frame()->state, end_->state));
}

// A mass holds from the shown moment on; the record after it comes back with one step of undo.
TEST_F(LabPlayheadTest, AnEditAtAMomentCutsTheRecord) {
  drag_timeline(0.9, 0.2);
  const std::int64_t at = steps();
  Body body = window_.frame()->scene->bodies.front();
  body.density = 7.0;
  body.mass.reset();
  window_.session().edit({Replace<Body>{body}}, "Mass");
  ASSERT_TRUE(wait_for([=, this] {
    return !runs().in_past() && !runs().replayed() && window_.frame()->setup->edits.size() == 1;
  }));
  EXPECT_EQ(steps(), at);
  EXPECT_EQ(window_.frame()->bodies->front().density, body.density);
  window_.run_until(1.0);
  EXPECT_FALSE(test::same_bytes(window_.frame()->state, end_->state));
  const State with = window_.frame()->state;
  window_.session().edits().undo();
  ASSERT_TRUE(wait_there());
  EXPECT_EQ(steps(), at);
  press(Qt::Key_End);
  EXPECT_TRUE(test::same_bytes(window_.frame()->state, end_->state));
  EXPECT_TRUE(window_.frame()->setup->edits.empty());
  window_.session().edits().redo();
  ASSERT_TRUE(wait_for(
      [=, this] { return !runs().replayed() && window_.frame()->setup->edits.size() == 1 && steps() == at; }));
  window_.run_until(1.0);
  EXPECT_TRUE(test::same_bytes(window_.frame()->state, with));
}

TEST_F(LabPlayheadTest, AMovedBodyMakesTheMomentTheStart) {
  drag_timeline(0.9, 0.2);
  const std::int64_t at = steps();
  Body body = window_.frame()->scene->bodies.front();
  body.position.y() += 0.1;
  window_.session().edit({Replace<Body>{body}}, "Move");
  ASSERT_TRUE(wait_for([=, this] { return !runs().in_past() && steps() == 0; }));
  EXPECT_EQ(window_.preset().scene.bodies.front().position, body.position);
  window_.session().edits().undo();
  ASSERT_TRUE(wait_there());
  EXPECT_EQ(steps(), at);
  EXPECT_EQ(runs().newest().front()->steps, end_->steps);
}

TEST_F(LabPlayheadTest, ARestartLeavesTheRecord) {
  press(Qt::Key_PageUp);
  QTest::keyClick(&window_.scene_view(), Qt::Key_R);
  ASSERT_TRUE(wait_for([this] { return steps() == 0 && !runs().in_past(); }));
}

// The start has the surface already when an earlier moment gets it.
TEST_F(LabPlayheadTest, ASurfaceIsEditedAtOneMomentAndThenAtAnEarlierOne) {
  const auto edit_at = [this](double from, double to, double restitution) {
    drag_timeline(from, to);
    Material rubber;
    rubber.name = "rubber";
    rubber.restitution = restitution;
    window_.session().edit({Add<Material>{rubber, Add<Material>::kAtEnd}}, "Surface");
    ASSERT_TRUE(wait_for([this] { return !runs().in_past() && !runs().replayed(); }));
  };
  const auto rubber_of = [](const Scene& scene) {
    std::vector<double> all;
    for (const Material& each : scene.materials) {
      if (each.name == "rubber") all.push_back(each.restitution);
    }
    return all;
  };
  edit_at(0.9, 0.6, 0.9);
  edit_at(0.55, 0.2, 0.7);
  EXPECT_EQ(rubber_of(window_.preset().scene), std::vector<double>{0.7});
  EXPECT_TRUE(wait_for([&] {
    const auto scene = window_.frame()->scene;
    return scene != nullptr && rubber_of(*scene) == std::vector<double>{0.7};
  }));
  window_.session().edits().undo();
  EXPECT_EQ(rubber_of(window_.preset().scene), std::vector<double>{0.9});
}

// Two bodies that get surfaces of their own at two moments, the later one first, have two.
TEST_F(LabPlayheadTest, ASurfaceOfOnesOwnLeavesThatOfAnotherBodyAlone) {
  const auto part = [this](const std::string& name, double from, double to, double restitution) {
    drag_timeline(from, to);
    ASSERT_TRUE(wait_for([this] { return window_.session().runs().scene() != nullptr && runs().there(); }));
    Body body = bodies_named(*window_.session().runs().scene(), {name}).front();
    Material own = material_named(*window_.session().runs().scene(), body.material);
    own.name = "wood 2";
    own.id = {};
    own.restitution = restitution;
    body.material = own.name;
    window_.session().edit({Add<Material>{own, Add<Material>::kAtEnd}, Replace<Body>{body}}, "Surface");
    ASSERT_TRUE(wait_for([this] { return !runs().in_past() && !runs().replayed(); }));
  };
  part("light", 0.9, 0.6, 0.9);
  part("heavy", 0.55, 0.2, 0.7);
  const Scene& start = window_.preset().scene;
  EXPECT_EQ(material_named(start, bodies_named(start, {"light"}).front().material).restitution, 0.9);
  const Body heavy = bodies_named(start, {"heavy"}).front();
  EXPECT_EQ(heavy.material, "wood 3");
  EXPECT_EQ(material_named(start, heavy.material).restitution, 0.7);
  EXPECT_TRUE(wait_for([&] {
    const auto scene = window_.frame()->scene;
    return scene != nullptr &&
           material_named(*scene, bodies_named(*scene, {"heavy"}).front().material).restitution == 0.7;
  }));
}

}  // namespace
}  // namespace carom
