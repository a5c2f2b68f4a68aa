#include "tests/app/lab/hands_fixture.h"

// The hand of the mouse on a body of a run that plays.
namespace carom {
namespace {

class LabHandTest : public LabHandsTest {
 protected:
  void SetUp() override {
    ASSERT_NO_FATAL_FAILURE(LabHandsTest::SetUp());
    choose_speed(0.25);
    window_.session().starts().set_playing(true);
    ASSERT_TRUE(wait_for([this] { return time() > 0.02 && window_.frame()->playing; }));
  }
  void TearDown() override { window_.session().starts().set_playing(false); }
  [[nodiscard]] Vec2 place_of(std::size_t body) {
    return window_.frame()->state.position(static_cast<int>(body));
  }
  void move_to(const Vec2& world) {
    SceneView* view = &window_.scene_view();
    const QPoint at = pixel(world);
    QMouseEvent move(QEvent::MouseMove, at, view->mapToGlobal(at), Qt::NoButton, Qt::LeftButton, {});
    QApplication::sendEvent(view, &move);
  }
  void press_at(const Vec2& world) {
    QTest::mousePress(&window_.scene_view(), Qt::LeftButton, {}, pixel(world));
  }
  void release_at(const Vec2& world) {
    QTest::mouseRelease(&window_.scene_view(), Qt::LeftButton, {}, pixel(world));
  }
  [[nodiscard]] QString undo_text() { return window_.session().edits().undoText(); }
};

TEST_F(LabHandTest, PullsAndThrows) {
  const std::string name = (*window_.frame()->bodies)[0].name;
  const Vec2 from = place_of(0);
  press_at(from);
  move_to(from + Vec2(0.0, 0.3));
  ASSERT_TRUE(wait_for([this] { return window_.frame()->hand.has_value(); }));
  EXPECT_TRUE(undo_text().startsWith("Throw " + QString::fromStdString(name))) << undo_text().toStdString();
  EXPECT_GT(window_.frame()->hand->force.y(), 0.0);
  EXPECT_EQ(window_.scene_view().cursor().shape(), Qt::ClosedHandCursor);
  const bool said =
      std::any_of(window_.scene_view().drawing().labels.begin(), window_.scene_view().drawing().labels.end(),
                  [](const auto& label) { return label.text.endsWith(" N"); });
  EXPECT_TRUE(said) << "its force";
  ASSERT_TRUE(wait_for([&] { return window_.frame()->state.velocity(0).y() > 0.1; }));
  release_at(from + Vec2(0.0, 0.3));
  ASSERT_TRUE(wait_for([this] { return !window_.frame()->hand; }));
  EXPECT_TRUE(window_.frame()->playing);
  EXPECT_GT(window_.frame()->state.velocity(0).y(), 0.1) << "thrown";
  EXPECT_NE(window_.frame()->ledger.put_in_by_user, 0.0);
  const double thrown = time();
  ASSERT_TRUE(wait_for([&] { return time() > thrown + 0.02; }));
  key(Qt::Key_Z, Qt::ControlModifier);
  window_.session().edits().undo();
  EXPECT_TRUE(wait_for([this] { return window_.frame()->ledger.put_in_by_user == 0.0; })) << "never thrown";
}

TEST_F(LabHandTest, AClickSelectsAndPausingLetsGo) {
  const Vec2 from = place_of(0);
  press_at(from);
  release_at(from);
  EXPECT_EQ(window_.scene_view().selection().size(), 1U);
  EXPECT_TRUE(undo_text().startsWith("Run"));
  press_at(place_of(0));
  move_to(from + Vec2(0.0, 0.3));
  ASSERT_TRUE(wait_for([this] { return window_.frame()->hand.has_value(); }));
  window_.session().starts().set_playing(false);
  ASSERT_TRUE(wait_for([this] { return !window_.frame()->playing && !window_.frame()->hand; }));
  release_at(from);
  EXPECT_FALSE(window_.frame()->playing);
}

TEST_F(LabHandTest, AFixedBodyIsNotMoved) {
  ASSERT_TRUE(window_.open("bouncing-ball"));
  window_.session().starts().set_playing(true);
  ASSERT_TRUE(wait_for([this] { return time() > 0.02 && window_.frame()->playing; }));
  const std::vector<Body>& bodies = *window_.frame()->bodies;
  const auto fixed = std::find_if(bodies.begin(), bodies.end(), [](const Body& body) { return body.fixed; });
  ASSERT_NE(fixed, bodies.end());
  Vec2 inside = fixed->position;
  if (std::holds_alternative<Wall>(fixed->shape)) inside.y() -= 0.05;
  press_at(inside);
  move_to(inside + Vec2(0.3, 0.0));
  EXPECT_EQ(window_.scene_view().bubble().value, "fixed; pause to move it");
  EXPECT_FALSE(window_.frame()->hand);
  release_at(inside);
  const double said = time();
  ASSERT_TRUE(wait_for([&] { return time() > said + 0.1; }));
  EXPECT_TRUE(window_.frame()->playing);
  EXPECT_EQ(window_.scene_view().bubble().value, "fixed; pause to move it") << "as the run goes on";
  EXPECT_TRUE(undo_text().startsWith("Run"));
}

}  // namespace
}  // namespace carom
