#pragma once

#include <QTableView>

#include "physics/preset/preset_file.h"
#include "tests/app/lab/hands_fixture.h"
#include "widgets/edit/bodies_sheet.h"
#include "widgets/edit/value_slider.h"
#include "widgets/scene/handles.h"

namespace carom {

// A window in which lessons are given: what is seen in it, and actions, which are counted.
class LessonTest : public LabHandsTest {
 protected:
  // --- what is seen
  [[nodiscard]] Overlay overlay() { return window_.scene_view().findChild<SceneTools*>()->overlay(); }
  [[nodiscard]] QString bubble() { return overlay().bubble.value; }
  [[nodiscard]] QTableView& table() { return *window_.findChild<BodiesSheet*>()->findChild<QTableView*>(); }
  [[nodiscard]] QString cell(int row, int column) {
    return table().model()->index(row, column).data().toString();
  }
  [[nodiscard]] QString whole_table() {
    QString text;
    for (int row = 0; row < table().model()->rowCount(); ++row) {
      for (int column = 0; column < table().model()->columnCount(); ++column) text += cell(row, column) + '\t';
      text += '\n';
    }
    return text;
  }
  [[nodiscard]] QLineEdit* field(const QString& name) {
    for (QLineEdit* each : window_.findChild<Inspector*>()->findChildren<QLineEdit*>()) {
      if (each->accessibleName() == name && each->isVisibleTo(&window_)) return each;
    }
    QStringList names;
    for (const QLineEdit* each : window_.findChild<Inspector*>()->findChildren<QLineEdit*>())
      names << each->accessibleName();
    throw std::runtime_error("no field " + name.toStdString() + " among " + names.join("; ").toStdString());
  }
  [[nodiscard]] QStringList names_in_scene() {
    QStringList names;
    for (const auto& label : window_.scene_view().drawing().labels) names << label.text;
    return names;
  }
  [[nodiscard]] QString sentence() {
    for (const QLabel* label : window_.findChild<Inspector*>()->findChildren<QLabel*>("fault")) {
      if (label->isVisibleTo(&window_) && !label->text().isEmpty()) return label->text();
    }
    return {};
  }
  [[nodiscard]] QString undo_text() { return window_.session().edits().undoText(); }
  [[nodiscard]] const Body& body(std::size_t i) { return window_.preset().scene.bodies.at(i); }
  [[nodiscard]] bool has(std::size_t count) {
    return wait_for([=, this] { return window_.frame()->bodies->size() == count; }) && shows_start();
  }
  [[nodiscard]] Vec2 grip(HandleKind kind) {
    for (const Handle& handle : overlay().handles) {
      if (handle.kind == kind) return window_.scene_view().camera().to_world(handle.at);
    }
    throw std::runtime_error("no such handle");
  }

  // Has the keys; after a dialog the window itself.
  [[nodiscard]] QWidget* focused() {
    QWidget* widget = QApplication::focusWidget();
    return widget != nullptr ? widget : &window_;
  }

  // --- what is done, each one action
  void press(int k, Qt::KeyboardModifiers held = {}) {
    ++actions_;
    QTest::keyClick(focused(), static_cast<Qt::Key>(k), held);
  }
  void write(const QString& text) {
    ++actions_;
    for (const QChar c : text) QTest::keyClicks(focused(), c);
    QTest::keyClick(focused(), Qt::Key_Return);
  }
  void pull(const Vec2& from, const Vec2& to, Qt::KeyboardModifiers held = {}) {
    ++actions_;
    drag(from, to, held);
  }
  void click(QWidget* widget, const QPoint& at) {
    ++actions_;
    QTest::mouseClick(widget, Qt::LeftButton, {}, at);
  }
  void click(const Vec2& at) { click(&window_.scene_view(), pixel(at)); }
  void click_cell(int row, int column) {
    const QModelIndex index = table().model()->index(row, column);
    table().scrollTo(index);
    click(table().viewport(), table().visualRect(index).center());
  }
  void click_field(const QString& name) {
    QLineEdit* edit = field(name);
    click(edit, edit->rect().center());
    edit->selectAll();
  }
  // The slider of this value to a part of its way.
  void slide(const QString& name, double part) {
    for (auto* slider : window_.findChildren<ValueSlider*>()) {
      if (slider->accessibleName() != name || !slider->isVisibleTo(&window_)) continue;
      constexpr int kHalfKnob = 7;  // px
      const QPoint from(kHalfKnob + (slider->width() - 2 * kHalfKnob) * slider->value() / slider->maximum(),
                        slider->height() / 2);
      const QPoint to(kHalfKnob + qRound((slider->width() - 2 * kHalfKnob) * part), slider->height() / 2);
      ++actions_;
      QTest::mousePress(slider, Qt::LeftButton, {}, from);
      for (int i = 1; i <= 5; ++i) {
        const QPoint at = from + (to - from) * i / 5;
        QMouseEvent move(QEvent::MouseMove, at, slider->mapToGlobal(at), Qt::NoButton, Qt::LeftButton, {});
        QApplication::sendEvent(slider, &move);
      }
      QTest::mouseRelease(slider, Qt::LeftButton, {}, to);
      return;
    }
    FAIL() << "no slider " << name.toStdString();
  }
  // The mouse goes there with the button down, and is let go later.
  void hold(const Vec2& from, const Vec2& to, Qt::KeyboardModifiers held = {}) {
    ++actions_;
    SceneView* view = &window_.scene_view();
    QTest::mousePress(view, Qt::LeftButton, held, pixel(from));
    for (int i = 1; i <= 10; ++i) {
      const QPoint at = pixel(from) + (pixel(to) - pixel(from)) * i / 10;
      QMouseEvent move(QEvent::MouseMove, at, view->mapToGlobal(at), Qt::NoButton, Qt::LeftButton, held);
      QApplication::sendEvent(view, &move);
      QTest::qWait(2);
    }
  }
  void let_go(const Vec2& at, Qt::KeyboardModifiers held = {}) {
    QTest::mouseRelease(&window_.scene_view(), Qt::LeftButton, held, pixel(at));
  }
  // By Tab, at most once round the window.
  void tab_to(const QWidget* widget) {
    for (int i = 0; i < 300 && QApplication::focusWidget() != widget; ++i)
      QTest::keyClick(focused(), Qt::Key_Tab);
    ASSERT_EQ(QApplication::focusWidget(), widget);
  }
  void begin_new() {
    press(Qt::Key_N, Qt::ControlModifier);
    ASSERT_TRUE(has(0));
    actions_ = 0;
  }
  void play_to_the_end(double end) {
    press(Qt::Key_Space);
    ASSERT_TRUE(wait_for([this] { return window_.frame()->playing; }));
    ASSERT_TRUE(wait_for([=, this] { return !window_.frame()->playing && time() > end - 0.01; }));
  }
  // The last two bodies.
  [[nodiscard]] std::vector<std::string> new_ones() {
    const std::vector<Body>& bodies = window_.preset().scene.bodies;
    return {bodies[bodies.size() - 2].name, bodies.back().name};
  }
  // All is taken back and made again, saved and opened.
  void take_all_back_and_save() {
    const QString seen = whole_table();
    const std::string document = write_preset(window_.preset());
    while (window_.session().edits().canUndo()) press(Qt::Key_Z, Qt::ControlModifier);
    ASSERT_TRUE(has(0));
    while (window_.session().edits().canRedo()) press(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    ASSERT_TRUE(has(2));
    EXPECT_EQ(write_preset(window_.preset()), document);
    EXPECT_TRUE(wait_for([&] { return whole_table() == seen; })) << whole_table().toStdString();
    chosen_file_ = folder_.filePath("lesson.json");
    const QString file = chosen_file_;
    press(Qt::Key_S, Qt::ControlModifier);
    ASSERT_TRUE(wait_for([this] { return !window_.session().modified(); }));
    ASSERT_TRUE(window_.open("head-on"));
    ASSERT_TRUE(shows_start());
    chosen_file_ = file;
    window_.activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(&window_));
    press(Qt::Key_O, Qt::ControlModifier);
    ASSERT_TRUE(wait_for([&] { return write_preset(window_.preset()) == document; }));
    ASSERT_TRUE(has(2));
    EXPECT_EQ(whole_table(), seen);
  }
  [[nodiscard]] double speed(const std::string& name) { return now(name).velocity.x(); }

  int actions_ = 0;
};

}  // namespace carom
