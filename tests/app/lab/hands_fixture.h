#pragma once

#include <QLineEdit>
#include <QMouseEvent>
#include <algorithm>

#include "app/lab/session.h"
#include "tests/app/lab/lab_fixture.h"
#include "widgets/edit/inspector.h"
#include "widgets/scene/scene_view.h"

namespace carom {

// A window whose scene is edited by hand.
class LabHandsTest : public LabWindowTest {
 protected:
  // In a new scene, their radii drawn: A of 0.1 m at (-1, 0), B of 0.2 m at (1, 0).
  void draw_two_discs() {
    action("New")->trigger();
    ASSERT_TRUE(wait_for([this] { return window_.frame() && window_.frame()->bodies->empty(); }));
    key(Qt::Key_D);
    drag({-1.0, 0.0}, {-0.9, 0.0});
    ASSERT_TRUE(wait_for([this] { return window_.frame()->bodies->size() == 1; }));
    key(Qt::Key_D);
    drag({1.0, 0.0}, {1.2, 0.0});
    ASSERT_TRUE(wait_for([this] { return window_.frame()->bodies->size() == 2; }));
    ASSERT_TRUE(shows_start());
  }
  [[nodiscard]] QPoint pixel(const Vec2& world) {
    return window_.scene_view().camera().to_screen(world).toPoint();
  }
  void drag(const Vec2& from, const Vec2& to, Qt::KeyboardModifiers keys = {}) {
    const QPoint end = pixel(to);
    hold(from, to, keys);
    QTest::mouseRelease(&window_.scene_view(), Qt::LeftButton, keys, end);
  }
  // A drag that goes on.
  void hold(const Vec2& from, const Vec2& to, Qt::KeyboardModifiers keys = {}) {
    SceneView* view = &window_.scene_view();
    const QPoint a = pixel(from);
    const QPoint b = pixel(to);
    QTest::mousePress(view, Qt::LeftButton, keys, a);
    constexpr int kMoves = 10;
    for (int i = 1; i <= kMoves; ++i) {
      const QPoint at = a + (b - a) * i / kMoves;
      QMouseEvent move(QEvent::MouseMove, at, view->mapToGlobal(at), Qt::NoButton, Qt::LeftButton, keys);
      QApplication::sendEvent(view, &move);
      QTest::qWait(2);
    }
  }
  void select(const Vec2& at) { QTest::mouseClick(&window_.scene_view(), Qt::LeftButton, {}, pixel(at)); }
  void key(int k, Qt::KeyboardModifiers keys = {}) {
    QTest::keyClick(&window_.scene_view(), static_cast<Qt::Key>(k), keys);
  }
  // Types into the inspector's field of this name.
  void type(const QString& field, const QString& text) {
    for (QLineEdit* edit : window_.findChild<Inspector*>()->findChildren<QLineEdit*>()) {
      if (edit->accessibleName() != field || !edit->isVisibleTo(&window_)) continue;
      edit->setFocus();
      edit->selectAll();
      QTest::keyClicks(edit, text);
      QTest::keyClick(edit, Qt::Key_Return);
      window_.scene_view().setFocus();
      return;
    }
    QString names;
    for (QLineEdit* edit : window_.findChild<Inspector*>()->findChildren<QLineEdit*>())
      names += edit->accessibleName() + "; ";
    ADD_FAILURE() << "no field " << field.toStdString() << " among " << names.toStdString();
  }
  [[nodiscard]] Body now(const std::string& name) {
    Body found;
    const bool there = wait_for([&] {
      if (!window_.frame() || !window_.frame()->scene) return false;
      for (const Body& body : window_.frame()->scene->bodies) {
        if (body.name != name) continue;
        found = body;
        return true;
      }
      return false;
    });
    EXPECT_TRUE(there) << "no body " << name;
    return found;
  }
  // Until the newest frame is still and shows, but for the last digits of what joints hold, the document's
  // start.
  [[nodiscard]] bool shows_start() {
    constexpr double kSame = 1e-12;  // m, and m/s
    return wait_for([this] {
      const auto frame = window_.frame();
      if (!frame || !frame->scene || frame->time != 0.0) return false;
      const std::vector<Body>& bodies = window_.preset().scene.bodies;
      return std::equal(bodies.begin(), bodies.end(), frame->scene->bodies.begin(), frame->scene->bodies.end(),
                        [](const Body& a, const Body& b) {
                          return a.name == b.name && (a.position - b.position).norm() < kSame &&
                                 (a.velocity - b.velocity).norm() < kSame;
                        });
    });
  }
  void undo() { window_.session().edits().undo(); }
};

}  // namespace carom
