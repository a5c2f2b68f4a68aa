#pragma once

#include <QGuiApplication>
#include <QMouseEvent>
#include <QTest>
#include <cstdint>
#include <cstdlib>
#include <gtest/gtest.h>
#include <memory>

#include "physics/run/scene_now.h"
#include "physics/scene/edit.h"
#include "tests/support/scene_fixture.h"
#include "widgets/scene/scene_view.h"

namespace carom {

// 600×400 px, 100 px/m: the world's (2, 1) stands at (300, 200), disc A at (200, 200), disc B at (400, 200).
// The arrow of A's 2 m/s is 0.8 m long or less.
class SceneToolsTest : public testing::Test {
 protected:
  struct Told {
    SceneEdits edits;
    QString name;
    int drag = 0;
  };

  void SetUp() override {
    scene_ = two_discs().scene;
    give_ids(scene_);
    view_.resize(600, 400);
    view_.set_view(View{Vec2(2.0, 1.0), 6.0});
    show(true);
    view_.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&view_));
    QObject::connect(&view_, &SceneView::selectionChanged,
                     [this](const std::vector<std::string>& names) { selected_ = names; });
    QObject::connect(&view_, &SceneView::edited,
                     [this](const SceneEdits& edits, const QString& name, int drag) {
                       told_.push_back({edits, name, drag});
                       if (answers_) {
                         apply_edits(scene_, edits);
                         show(true);
                       }
                     });
    QObject::connect(&view_, &SceneView::dragCancelled, [this](int drag) { cancelled_.push_back(drag); });
    QObject::connect(&view_, &SceneView::spawnRequested,
                     [this](double x, double y) { spawned_.emplace_back(x, y); });
  }

  // Publishes the scene, as the run's next frame does.
  void show(bool paused) {
    Preset preset;
    preset.scene = scene_;
    const auto setup = std::make_shared<const RunSetup>(setup_of(preset));
    const Simulation run(*setup);
    auto frame = frame_of(run);
    frame->setup = setup;
    frame->run = run_;
    frame->forces = std::make_shared<const Forces>(scene_.forces);
    if (paused) frame->scene = std::make_shared<const Scene>(scene_now(run));
    view_.set_frame(frame);
  }

  void press(const QPoint& at, Qt::KeyboardModifiers keys = {}) {
    QTest::mousePress(&view_, Qt::LeftButton, keys, at);
  }
  void move(const QPoint& at, Qt::KeyboardModifiers keys = {}) {
    QMouseEvent event(QEvent::MouseMove, at, view_.mapToGlobal(QPointF(at)), Qt::NoButton, Qt::LeftButton,
                      keys);
    QGuiApplication::sendEvent(&view_, &event);
  }
  void release(const QPoint& at, Qt::KeyboardModifiers keys = {}) {
    QTest::mouseRelease(&view_, Qt::LeftButton, keys, at);
  }
  void click(const QPoint& at, Qt::KeyboardModifiers keys = {}) {
    QTest::mouseClick(&view_, Qt::LeftButton, keys, at);
  }
  void drag(const QPoint& from, const QPoint& to, Qt::KeyboardModifiers keys = {}) {
    press(from, keys);
    move((from + to) / 2, keys);
    move(to, keys);
    release(to, keys);
  }
  [[nodiscard]] static const Body& replaced(const SceneEdit& edit) {
    return std::get<Replace<Body>>(edit).part;
  }

  // But for the smoothing of edges.
  [[nodiscard]] static bool alike(const QColor& a, const QColor& b) {
    return std::abs(a.red() - b.red()) + std::abs(a.green() - b.green()) + std::abs(a.blue() - b.blue()) < 120;
  }

  using Names = std::vector<std::string>;
  const QPoint a_{200, 220};  // in A, off its arrow
  const QPoint b_{400, 200};
  const QPoint empty_{300, 60};

  SceneView view_{light_theme()};
  Scene scene_;
  std::uint64_t run_ = 0;
  bool answers_ = false;
  Names selected_;
  std::vector<Told> told_;
  std::vector<int> cancelled_;
  std::vector<Vec2> spawned_;
};

}  // namespace carom
