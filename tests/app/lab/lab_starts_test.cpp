#include <QPushButton>
#include <algorithm>

#include "tests/app/lab/hands_fixture.h"

// The starts in the window: R and Ctrl+R, the arrow beside the restart button, and the chip of a new start.
namespace carom {
namespace {

class LabStartsTest : public LabHandsTest {
 protected:
  void SetUp() override {
    ASSERT_NO_FATAL_FAILURE(LabHandsTest::SetUp());
    name_ = window_.preset().scene.bodies[0].name;
    window_.run_until(0.8);
  }
  // Moves the first body up at 0.8 s.
  void make_new_start() {
    window_.scene_view().select({name_});
    window_.scene_view().setFocus();
    key(Qt::Key_Up);
    ASSERT_TRUE(wait_for([this] { return time() == 0.0 && window_.frame()->scene; }));
  }
  QPushButton* start_chip() {
    for (QPushButton* chip : window_.scene_view().findChildren<QPushButton*>("chip")) {
      if (chip->menu() != nullptr) return chip;
    }
    throw std::runtime_error("no chip with a menu");
  }
  // What a menu says when it opens, without what follows a tab.
  static QStringList texts(QMenu* menu) {
    emit menu->aboutToShow();
    QStringList all;
    for (const QAction* each : menu->actions())
      all << QString(each->text()).remove('&') + (each->isChecked() ? " (ticked)" : "");
    return all;
  }
  [[nodiscard]] QString undo_text() { return window_.session().edits().undoText(); }

  std::string name_;
};

TEST_F(LabStartsTest, AStrayRestartIsTakenBack) {
  const State before = window_.frame()->state;
  key(Qt::Key_R);
  ASSERT_TRUE(wait_for([this] { return time() == 0.0; }));
  EXPECT_EQ(undo_text(), "Restart");
  EXPECT_FALSE(window_.isWindowModified());
  key(Qt::Key_Z, Qt::ControlModifier);
  ASSERT_TRUE(wait_for([this] { return std::abs(time() - 0.8) < 1e-9; }));
  EXPECT_EQ(window_.frame()->state.q, before.q);
}

// Restart, run, mass and run: each is taken back by one Ctrl+Z.
TEST_F(LabStartsTest, RunsAndEditsInThemAreTakenBackOneByOne) {
  const double last = time();
  Body light = now(name_);
  light.mass = 2.0;
  window_.session().edit({Replace<Body>{light}}, "Mass");
  ASSERT_TRUE(wait_for([&] { return now(name_).mass == 2.0; }));
  key(Qt::Key_Space);
  ASSERT_TRUE(wait_for([&] { return time() > last && !window_.frame()->playing; })) << "to its end";
  EXPECT_EQ(undo_text(), "Run from 0.800 s");
  key(Qt::Key_R);
  ASSERT_TRUE(wait_for([this] { return time() == 0.0; }));
  key(Qt::Key_Z, Qt::ControlModifier);
  ASSERT_TRUE(wait_for([&] { return time() > last; }));
  key(Qt::Key_Z, Qt::ControlModifier);
  ASSERT_TRUE(wait_for([&] { return std::abs(time() - last) < 1e-9 && now(name_).mass == 2.0; }));
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_TRUE(wait_for([&] { return now(name_).mass == 1.0; }));
  EXPECT_FALSE(window_.isWindowModified());
}

TEST_F(LabStartsTest, UndoBringsTheAimOfAStartBack) {
  const auto aims = [this] { return window_.scene_view().aim().has_value(); };
  make_new_start();
  EXPECT_FALSE(aims()) << "they part after their impact";
  Body light = now(name_);
  light.velocity = {3.0, 0.0};
  window_.session().edit({Replace<Body>{light}}, "Speed");
  ASSERT_TRUE(shows_start());
  bool shown = false;
  for (int i = 0; i < 10 && !shown; ++i) {  // a busy machine may leave one out
    key(Qt::Key_Space);
    ASSERT_TRUE(wait_for([&] { return time() > 0.0 && !aims(); }));
    key(Qt::Key_Z, Qt::ControlModifier);
    ASSERT_TRUE(wait_for([this] { return time() == 0.0 && !window_.frame()->playing; }));
    shown = aims();
  }
  EXPECT_TRUE(shown);
  // Back before the new start there is none.
  key(Qt::Key_Z, Qt::ControlModifier);
  key(Qt::Key_Z, Qt::ControlModifier);
  ASSERT_TRUE(wait_for([this] { return std::abs(time() - 0.8) < 1e-9; }));
  EXPECT_FALSE(aims());
}

TEST_F(LabStartsTest, RGoesToTheNewestStartAndCtrlRToTheFirst) {
  const Vec2 opened = window_.preset().scene.bodies[0].position;
  make_new_start();
  const Vec2 moved = window_.preset().scene.bodies[0].position;
  ASSERT_NE(moved, opened);
  window_.run_until(0.3);
  key(Qt::Key_R);
  ASSERT_TRUE(shows_start());
  EXPECT_EQ(now(name_).position, moved);
  key(Qt::Key_R, Qt::ControlModifier);
  ASSERT_TRUE(shows_start());
  EXPECT_EQ(now(name_).position, opened);
  EXPECT_EQ(undo_text(), "First start");
}

TEST_F(LabStartsTest, TheArrowListsAllStarts) {
  make_new_start();
  QMenu* menu = button("All starts")->menu();
  const QString newest = "from 0.800 s: Move " + QString::fromStdString(name_);
  EXPECT_EQ(texts(menu), (QStringList{"as opened", newest + " (ticked)"}));
  menu->actions()[0]->trigger();
  ASSERT_TRUE(shows_start());
  EXPECT_EQ(texts(menu), (QStringList{"as opened (ticked)", newest}));
  EXPECT_FALSE(start_chip()->isVisible());
  menu->actions()[1]->trigger();
  ASSERT_TRUE(shows_start());
  EXPECT_TRUE(start_chip()->isVisible());
}

TEST_F(LabStartsTest, AChipNamesTheNewStartForAsLongAsItHolds) {
  EXPECT_FALSE(start_chip()->isVisible());
  make_new_start();
  ASSERT_TRUE(start_chip()->isVisible());
  EXPECT_TRUE(start_chip()->text().startsWith("new start, from 0.800 s"));
  window_.run_until(0.2);
  EXPECT_TRUE(start_chip()->isVisible());
  const QStringList entries = texts(start_chip()->menu());
  ASSERT_EQ(entries.size(), 3);
  EXPECT_TRUE(entries[0].startsWith("Undo"));
  EXPECT_EQ(entries[1], "Put the edit into the start before instead");
  EXPECT_EQ(entries[2], "First start");
  start_chip()->menu()->actions()[1]->trigger();
  ASSERT_TRUE(shows_start());
  EXPECT_FALSE(start_chip()->isVisible());
  EXPECT_EQ(undo_text(), "Move " + QString::fromStdString(name_));
  undo();
  EXPECT_TRUE(wait_for([this] { return std::abs(time() - 0.8) < 1e-9; }));
}

// Arrows stay as long as they were per m/s, though the start before is much faster or slower.
TEST_F(LabStartsTest, ArrowsKeepTheirScaleWhereAnEditIsPutIntoTheStartBefore) {
  const auto scale = [this] {
    const Drawing::ArrowKey& key = window_.scene_view().drawing().velocity_key;
    return key.length / key.amount;
  };
  const auto until_start_has = [this](double speed) {
    return wait_for([&] {
      const auto frame = window_.frame();
      return time() == 0.0 && frame->scene && frame->scene->bodies[0].velocity.x() == speed;
    });
  };
  Body body = window_.session().runs().scene()->bodies[0];
  body.velocity.x() = 6.0;
  window_.session().edit({Replace<Body>{body}}, "Speed");
  ASSERT_TRUE(until_start_has(6.0));
  const double before = scale();
  ASSERT_GT(before, 0.0);
  start_chip()->menu()->actions()[1]->trigger();
  ASSERT_TRUE(until_start_has(6.0));
  EXPECT_DOUBLE_EQ(scale(), before);
  undo();
  ASSERT_TRUE(wait_for([this] { return std::abs(time() - 0.8) < 1e-9; }));
  EXPECT_DOUBLE_EQ(scale(), before);
  window_.session().edits().redo();
  ASSERT_TRUE(until_start_has(6.0));
  EXPECT_DOUBLE_EQ(scale(), before);
}

}  // namespace
}  // namespace carom
