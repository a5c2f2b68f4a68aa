#include <QPushButton>

#include "physics/scene/hand.h"
#include "tests/app/lab/lesson_fixture.h"
#include "tests/support/scenes.h"
#include "widgets/edit/bodies_model.h"
#include "widgets/run/stop_editor.h"
#include "widgets/run/timeline.h"

// The second lesson in the real window, about time: every step with real events, and what is seen after each.
namespace carom {
namespace {

class LessonTimeTest : public LessonTest {
 protected:
  LabRuns& runs() { return window_.session().runs(); }
  [[nodiscard]] QString chip_text(const QString& name) {
    return chip(name)->isVisible() ? chip(name)->text() : QString();
  }
  [[nodiscard]] QPushButton* start_chip() {
    for (QPushButton* each : window_.scene_view().findChildren<QPushButton*>("chip")) {
      if (each->menu() != nullptr) return each;
    }
    throw std::runtime_error("no chip with a menu");
  }
  [[nodiscard]] bool shows(double moment) {
    return wait_for([&] { return runs().there() && std::abs(time() - moment) < 1e-9; });
  }
  void scene_key(int k, Qt::KeyboardModifiers held = {}) {
    window_.scene_view().setFocus();
    press(k, held);
  }
  void drag_timeline(double from, double to) {
    ++actions_;
    auto* timeline = window_.findChild<Timeline*>();
    const auto at = [timeline](double t) { return QPoint(qRound(timeline->x_of(t)), timeline->height() / 2); };
    QTest::mousePress(timeline, Qt::LeftButton, {}, at(from));
    for (int i = 1; i <= 5; ++i) {
      const QPoint place = at(from + (to - from) * i / 5);
      QMouseEvent move(QEvent::MouseMove, place, timeline->mapToGlobal(place), Qt::NoButton, Qt::LeftButton,
                       {});
      QApplication::sendEvent(timeline, &move);
      QTest::qWait(5);
    }
    QTest::mouseRelease(timeline, Qt::LeftButton, {}, at(to));
  }
  [[nodiscard]] double mass_in_run() { return mass_of((*window_.frame()->bodies)[0]); }
  [[nodiscard]] std::size_t impacts_known() { return runs().recorders().front()->impacts().size(); }
};

TEST_F(LessonTimeTest, StepBackEditGoOnAndThrow) {
  const std::string light = (*window_.frame()->bodies)[0].name;
  ASSERT_EQ(light, "light");
  // 1. The experiment runs to its end.
  window_.scene_view().setFocus();
  play_to_the_end(1.0);
  const State first_run = window_.frame()->state;

  // 2. Back to its impact: the discs touch.
  scene_key(Qt::Key_PageUp);
  ASSERT_TRUE(wait_for([this] { return runs().there() && time() < 0.5; }));
  EXPECT_EQ(chip_text("Impact at this moment"), "impact 1 of 1");
  EXPECT_NEAR(time(), 1.0 / 3.0, 1e-9);
  const State at_impact = window_.frame()->state;
  const double radii = std::get<Disc>(body(0).shape).radius + std::get<Disc>(body(1).shape).radius;
  EXPECT_NEAR((at_impact.position(0) - at_impact.position(1)).norm(), radii, 1e-9);

  // 3. Three steps back and forth: the same digits.
  const double moment = time();
  for (int i = 0; i < 3; ++i) scene_key(Qt::Key_Comma);
  ASSERT_TRUE(shows(moment - 3 * window_.frame()->method.step));
  for (int i = 0; i < 3; ++i) scene_key(Qt::Key_Period);
  ASSERT_TRUE(shows(moment));
  EXPECT_TRUE(test::same_bytes(window_.frame()->state, at_impact));

  // 4. Along the timeline: scene, plots and table go along.
  drag_timeline(moment, 0.5);
  ASSERT_TRUE(wait_for([this] { return runs().there() && std::abs(time() - 0.5) < 0.02; }));
  const double cut = time();
  const double x = window_.frame()->state.position(0).x();
  EXPECT_TRUE(wait_for([&] {
    return std::abs(cell(0, BodiesModel::kX).replace(QChar(0x2212), '-').toDouble() - x) < 1e-3;
  })) << cell(0, BodiesModel::kX).toStdString();

  // 5. Another mass from here on, and in the start.
  click_cell(0, BodiesModel::kMass);
  write("2");
  ASSERT_TRUE(wait_for([this] { return mass_in_run() == 2.0 && !runs().in_past(); }));
  EXPECT_TRUE(runs().before().has_value()) << "the rest is pale";
  EXPECT_EQ(time(), cut);
  scene_key(Qt::Key_Space);
  ASSERT_TRUE(wait_for([&] { return !window_.frame()->playing && time() > 0.99; }));
  EXPECT_EQ(mass_in_run(), 2.0);
  scene_key(Qt::Key_R);
  ASSERT_TRUE(wait_for([this] { return time() == 0.0 && window_.frame()->scene; }));
  EXPECT_EQ(mass_in_run(), 2.0);

  // 6. All of it is taken back, one by one.
  scene_key(Qt::Key_Z, Qt::ControlModifier);
  ASSERT_TRUE(wait_for([this] { return time() > 0.99; })) << "the restart";
  scene_key(Qt::Key_Z, Qt::ControlModifier);
  ASSERT_TRUE(wait_for([&] { return time() == cut && mass_in_run() == 2.0; })) << "the run from there";
  scene_key(Qt::Key_Z, Qt::ControlModifier);
  ASSERT_TRUE(wait_for([&] { return mass_in_run() == 1.0; })) << "the mass";
  scene_key(Qt::Key_End);
  ASSERT_TRUE(wait_for([this] { return runs().there() && time() > 0.99; })) << "the whole first run is back";
  EXPECT_TRUE(test::same_bytes(window_.frame()->state, first_run));
  scene_key(Qt::Key_Z, Qt::ControlModifier);
  ASSERT_TRUE(wait_for([this] { return time() == 0.0; })) << "the first run";

  // 7. A body moved on the way makes a new start; R goes there, Ctrl+R to the first one.
  choose_speed(0.5);
  scene_key(Qt::Key_Space);
  ASSERT_TRUE(wait_for([this] { return time() >= 0.75; }));
  scene_key(Qt::Key_Space);
  ASSERT_TRUE(wait_for([this] { return !window_.frame()->playing && window_.frame()->scene; }));
  const double paused = time();
  const Vec2 heavy = now("heavy").position;
  const Vec2 opened = body(1).position;
  pull(heavy, heavy + Vec2(0.0, 0.2));
  ASSERT_TRUE(shows_start());
  EXPECT_EQ(start_chip()->text().section(" ▾", 0, 0), QString("new start, from %1 s").arg(paused, 0, 'f', 3));
  EXPECT_GT(body(1).position.y(), heavy.y() + 0.1);
  EXPECT_TRUE(runs().before().has_value());
  scene_key(Qt::Key_Space);
  ASSERT_TRUE(wait_for([this] { return time() > 0.1; }));
  EXPECT_TRUE(runs().before().has_value()) << "the old run stays pale";
  const Vec2 moved = body(1).position;
  scene_key(Qt::Key_R);
  ASSERT_TRUE(wait_for([this] { return time() == 0.0 && !window_.frame()->playing; }));
  EXPECT_EQ(body(1).position, moved);
  scene_key(Qt::Key_R, Qt::ControlModifier);
  ASSERT_TRUE(wait_for([&] { return body(1).position == opened; }));
  ASSERT_TRUE(shows_start());

  // 8. A stop at the first impact.
  choose_speed(1.0);
  action("Stops...")->trigger();
  auto* editor = window_.findChild<StopEditor*>();
  auto* words = editor->findChild<QLineEdit*>();
  for (QLineEdit* each : editor->findChildren<QLineEdit*>()) {
    if (each->accessibleName() == "Sentence of the stop") words = each;
  }
  words->clear();
  QTest::keyClicks(words, "at the 1st impact");
  QTest::keyClick(words, Qt::Key_Return);
  editor->hide();
  window_.activateWindow();
  scene_key(Qt::Key_R);
  scene_key(Qt::Key_Space);
  ASSERT_TRUE(wait_for([this] { return chip_text("Why it stopped") == "stopped: 1st impact"; }));
  EXPECT_NEAR(time(), 1.0 / 3.0, 1e-9);

  // 9. A body is thrown; the record repeats it; it was never thrown.
  scene_key(Qt::Key_R);
  ASSERT_TRUE(wait_for([this] { return time() == 0.0 && window_.frame()->scene; }));
  choose_speed(0.125);
  scene_key(Qt::Key_Space);
  ASSERT_TRUE(wait_for([this] { return window_.frame()->playing && time() > 0.02; }));
  const Vec2 grabbed = window_.frame()->state.position(0);
  hold(grabbed, grabbed + Vec2(0.0, 0.4));
  ASSERT_TRUE(
      wait_for([this] { return window_.frame()->hand && window_.frame()->state.velocity(0).y() > 0.2; }));
  let_go(grabbed + Vec2(0.0, 0.4));
  ASSERT_TRUE(wait_for([this] { return !window_.frame()->hand; }));
  scene_key(Qt::Key_Space);
  ASSERT_TRUE(wait_for([this] { return !window_.frame()->playing && window_.frame()->scene; }));
  EXPECT_TRUE(undo_text().startsWith("Throw light at ")) << undo_text().toStdString();
  EXPECT_NE(window_.frame()->ledger.put_in_by_user, 0.0);
  const State thrown = window_.frame()->state;
  const double end = time();
  scene_key(Qt::Key_Home);
  ASSERT_TRUE(shows(0.0));
  EXPECT_EQ(window_.frame()->ledger.put_in_by_user, 0.0);
  scene_key(Qt::Key_End);
  ASSERT_TRUE(shows(end));
  EXPECT_TRUE(test::same_bytes(window_.frame()->state, thrown));
  scene_key(Qt::Key_Z, Qt::ControlModifier);
  ASSERT_TRUE(wait_for([this] { return window_.frame()->ledger.put_in_by_user == 0.0; }));
  EXPECT_NEAR(window_.frame()->state.velocity(0).y(), 0.0, 1e-12) << "never thrown";
}

}  // namespace
}  // namespace carom
