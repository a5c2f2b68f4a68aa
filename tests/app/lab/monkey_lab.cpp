#include <QApplication>
#include <QElapsedTimer>
#include <QLineEdit>
#include <QMenu>
#include <QTableView>
#include <QTest>
#include <algorithm>
#include <array>

#include "app/lab/drawer.h"
#include "app/lab/lab_window.h"
#include "monkey.h"
#include "widgets/edit/bodies_sheet.h"
#include "widgets/edit/value_slider.h"
#include "widgets/run/stop_editor.h"
#include "widgets/run/timeline.h"
#include "widgets/scene/scene_view.h"

// The monkey on the parts of the lab: chance alone would seldom hit a body, a handle or a cell.
namespace carom {
namespace {

struct KeyHeld {
  Qt::Key key;
  Qt::KeyboardModifiers held;
};

bool answers() {
  return QApplication::activeModalWidget() == nullptr && QApplication::activePopupWidget() == nullptr;
}

}  // namespace

// In the scene: on a body, beside one, or anywhere.
QPoint Monkey::near_body() {
  SceneView& view = window_->scene_view();
  const QPoint anywhere(below(std::max(view.width(), 1)), below(std::max(view.height(), 1)));
  const int chosen = below(1 << 20);
  const QPoint off(below(61) - 30, below(61) - 30);
  const auto frame = window_->frame();
  if (frame == nullptr || frame->bodies->empty() || once_in(4)) return anywhere;
  const auto body = static_cast<std::size_t>(chosen) % frame->bodies->size();
  const QPointF at = view.camera().to_screen(frame->state.position(static_cast<int>(body)));
  const QPoint place = once_in(2) ? at.toPoint() : at.toPoint() + off;
  return view.rect().contains(place) ? place : anywhere;
}

void Monkey::drag_in(QWidget& widget, const QPoint& from, const QPoint& to) {
  const QPointer<QWindow> window = widget.window()->windowHandle();
  const QPoint a = widget.mapTo(widget.window(), from);
  const QPoint b = widget.mapTo(widget.window(), to);
  const Qt::KeyboardModifiers held = modifiers();
  constexpr int kParts = 4;
  timestamp_ += 2000;
  if (window != nullptr) mouse(window, a, Qt::NoButton, QEvent::MouseMove, held);
  if (window != nullptr) mouse(window, a, Qt::LeftButton, QEvent::MouseButtonPress, held);
  for (int i = 1; i <= kParts && window != nullptr; ++i)
    mouse(window, a + (b - a) * i / kParts, Qt::NoButton, QEvent::MouseMove, held);
  if (window != nullptr) mouse(window, b, Qt::LeftButton, QEvent::MouseButtonRelease, held);
}

// With any tool, or by the handles of what is selected.
void Monkey::draw() {
  if (window_ == nullptr || !answers()) return;
  constexpr int kTools = static_cast<int>(SceneTool::kForce) + 1;
  const auto tool = static_cast<SceneTool>(below(kTools));
  const bool keep = once_in(4);
  const QPoint from = near_body();
  const QPoint to = once_in(3) ? from : near_body();
  report(QString("tool %1").arg(static_cast<int>(tool)));
  if (!once_in(3)) window_->scene_view().set_tool(tool, keep);
  drag_in(window_->scene_view(), from, to);
}

void Monkey::cell() {
  const int chosen = below(1 << 20);
  const int column = below(9);
  if (window_ == nullptr || !answers()) return;
  auto* table = window_->findChild<BodiesSheet*>()->findChild<QTableView*>();
  const int rows = table->model()->rowCount();
  if (!table->isVisible() || rows == 0) return;
  const QModelIndex index = table->model()->index(chosen % rows, column);
  table->scrollTo(index);
  const QPoint at = table->visualRect(index).center();
  drag_in(*table->viewport(), at, at);
  type();
  edit_key();
}

void Monkey::slider() {
  const int chosen = below(1 << 20);
  const int to = below(200);
  if (window_ == nullptr || !answers()) return;
  QList<ValueSlider*> all;
  for (auto* each : window_->findChildren<ValueSlider*>()) {
    if (each->isVisible() && each->isEnabled() && !each->visibleRegion().isEmpty()) all << each;
  }
  if (all.isEmpty()) return;
  ValueSlider& slider = *all[chosen % all.size()];
  report("slider " + slider.accessibleName());
  const int middle = slider.height() / 2;
  drag_in(slider, {slider.width() / 2, middle}, {to, middle});
}

// Chooses a joint, a spring or a force, and sometimes deletes it.
void Monkey::link() {
  const int chosen = below(1 << 20);
  const bool removes = once_in(4);
  if (window_ == nullptr || !answers() || window_->session().runs().scene() == nullptr) return;
  const Scene& scene = *window_->session().runs().scene();
  std::vector<PartId> all;
  for (const Joint& joint : scene.joints) all.emplace_back(joint.id);
  for (const Spring& spring : scene.forces.springs) all.emplace_back(spring.id);
  for (const AppliedForce& force : scene.forces.applied) all.emplace_back(force.id);
  if (all.empty()) return;
  window_->scene_view().choose_part(all[static_cast<std::size_t>(chosen) % all.size()]);
  if (removes) QTest::keyClick(&window_->scene_view(), Qt::Key_Delete);
}

void Monkey::edit_key() {
  constexpr std::array kKeys = {
      KeyHeld{Qt::Key_Left, Qt::NoModifier},   KeyHeld{Qt::Key_Right, Qt::ControlModifier},
      KeyHeld{Qt::Key_Up, Qt::ShiftModifier},  KeyHeld{Qt::Key_BracketLeft, Qt::NoModifier},
      KeyHeld{Qt::Key_Plus, Qt::NoModifier},   KeyHeld{Qt::Key_Minus, Qt::NoModifier},
      KeyHeld{Qt::Key_0, Qt::NoModifier},      KeyHeld{Qt::Key_X, Qt::NoModifier},
      KeyHeld{Qt::Key_K, Qt::NoModifier},      KeyHeld{Qt::Key_Tab, Qt::NoModifier},
      KeyHeld{Qt::Key_A, Qt::ControlModifier}, KeyHeld{Qt::Key_D, Qt::ControlModifier},
      KeyHeld{Qt::Key_Return, Qt::NoModifier}, KeyHeld{Qt::Key_Escape, Qt::NoModifier},
      KeyHeld{Qt::Key_Delete, Qt::NoModifier}, KeyHeld{Qt::Key_2, Qt::NoModifier},
      KeyHeld{Qt::Key_G, Qt::ControlModifier}, KeyHeld{Qt::Key_G, Qt::ControlModifier | Qt::ShiftModifier}};
  const KeyHeld& chosen = kKeys[static_cast<std::size_t>(below(static_cast<int>(kKeys.size())))];
  if (window_ == nullptr || !answers()) return;
  QWidget* widget = QApplication::focusWidget();
  QTest::keyClick(widget == nullptr || once_in(2) ? &window_->scene_view() : widget, chosen.key, chosen.held);
}

void Monkey::take_back() {
  const bool again = once_in(3);
  int count = 1 + below(6);
  if (window_ == nullptr || !answers()) return;
  QUndoStack& edits = window_->session().edits();
  for (; count > 0; --count) again ? edits.redo() : edits.undo();
}

void Monkey::fold() {
  if (window_ == nullptr || !answers()) return;
  auto* drawer = window_->findChild<Drawer*>();
  drawer->set_folded(!drawer->folded());
}

// Through the record, by the timeline or by keys, at another speed, or from another start.
void Monkey::scrub() {
  constexpr std::array kKeys = {
      KeyHeld{Qt::Key_Comma, Qt::NoModifier},      KeyHeld{Qt::Key_Period, Qt::NoModifier},
      KeyHeld{Qt::Key_PageUp, Qt::NoModifier},     KeyHeld{Qt::Key_PageDown, Qt::NoModifier},
      KeyHeld{Qt::Key_Home, Qt::NoModifier},       KeyHeld{Qt::Key_End, Qt::NoModifier},
      KeyHeld{Qt::Key_G, Qt::NoModifier},          KeyHeld{Qt::Key_Space, Qt::NoModifier},
      KeyHeld{Qt::Key_Comma, Qt::ControlModifier}, KeyHeld{Qt::Key_Period, Qt::ControlModifier},
      KeyHeld{Qt::Key_I, Qt::ShiftModifier},       KeyHeld{Qt::Key_B, Qt::ShiftModifier},
      KeyHeld{Qt::Key_R, Qt::ControlModifier},     KeyHeld{Qt::Key_H, Qt::NoModifier}};
  const KeyHeld& key = kKeys[static_cast<std::size_t>(below(static_cast<int>(kKeys.size())))];
  const int from = below(1 << 10);
  const int to = below(1 << 10);
  const bool drags = once_in(2);
  if (window_ == nullptr || !answers()) return;
  if (!drags) return QTest::keyClick(&window_->scene_view(), key.key, key.held);
  Timeline& timeline = *window_->findChild<Timeline*>();
  const int y = timeline.height() / 2;
  drag_in(timeline, {from % std::max(timeline.width(), 1), y}, {to % std::max(timeline.width(), 1), y});
}

// Some frames.
void Monkey::wait() {
  QElapsedTimer clock;
  clock.start();
  const int ms = 20 + below(100);
  while (clock.elapsed() < ms) QApplication::processEvents(QEventLoop::AllEvents, 5);
}

// By the hand, on a run that mostly plays, for so long that it acts.
void Monkey::pull() {
  const bool plays = !once_in(4);
  const int chosen = below(1 << 20);
  if (window_ == nullptr || !answers() || window_->frame() == nullptr) return;
  SceneView& view = window_->scene_view();
  view.set_tool(SceneTool::kSelect, false);
  if (plays) window_->session().starts().set_playing(true);
  const QPointer<QWindow> window = window_->windowHandle();
  QPoint to = view.mapTo(window_.get(), near_body());
  timestamp_ += 2000;
  wait();
  const std::shared_ptr<const Frame> frame = window_->frame();
  std::vector<int> moved;
  for (int i = 0; i < frame->state.size(); ++i) {
    if (!has_infinite_mass((*frame->bodies)[static_cast<std::size_t>(i)])) moved.push_back(i);
  }
  if (moved.empty()) return;
  const int body = moved[static_cast<std::size_t>(chosen) % moved.size()];
  const QPoint from = view.mapTo(window_.get(), view.camera().to_screen(frame->state.position(body)).toPoint());
  mouse(window, from, Qt::NoButton, QEvent::MouseMove, Qt::NoModifier);
  mouse(window, from, Qt::LeftButton, QEvent::MouseButtonPress, Qt::NoModifier);
  wait();
  for (int moves = 1 + below(3); moves > 0 && window != nullptr; --moves, to = from + (to - from) / 2) {
    mouse(window, to, Qt::NoButton, QEvent::MouseMove, Qt::NoModifier);
    wait();
  }
  if (window != nullptr) mouse(window, to, Qt::LeftButton, QEvent::MouseButtonRelease, Qt::NoModifier);
}

// Types a sentence that is true of the scene into the editor of stops, and adds it.
void Monkey::stop() {
  const int chosen = below(1 << 20);
  const double value = 0.01 * (1 + below(200));
  const int which = below(8);
  if (window_ == nullptr || !answers()) return;
  const auto& bodies = window_->session().document().scene.bodies;
  if (bodies.empty()) return;
  const auto name =
      QString::fromStdString(bodies[static_cast<std::size_t>(chosen) % bodies.size()].name).prepend('"') + '"';
  const QStringList sentences = {QString("at %1 s").arg(value),
                                 "at the 2nd impact",
                                 "at every impact with a wall",
                                 "at every impact of " + name,
                                 QString("when %1 passes x = %2 m").arg(name).arg(value - 1.0),
                                 QString("when %1 passes speed = %2 m/s downwards").arg(name).arg(value),
                                 "when all is at rest",
                                 QString("when K falls below %1 J").arg(value)};
  report(sentences[which]);
  for (QAction* action : window_->findChildren<QAction*>()) {
    if (action->shortcut() == QKeySequence(Qt::Key_H)) action->trigger();
  }
  auto* editor = window_->findChild<StopEditor*>();
  if (!editor->isVisible()) return;
  for (auto* field : editor->findChildren<QLineEdit*>()) {
    if (field->accessibleName() != "Sentence of the stop") continue;
    field->setFocus();
    field->selectAll();
    field->insert(sentences[which]);  // QTest types ASCII alone, and names hold anything
    QTest::keyClick(field, Qt::Key_Return);
  }
  editor->close();
}

// Chooses one of the list of starts.
void Monkey::start() {
  const int chosen = below(1 << 20);
  if (window_ == nullptr || !answers()) return;
  for (auto* menu : window_->findChildren<QMenu*>()) {
    if (menu->title() != "S&tarts") continue;
    menu->popup(window_->mapToGlobal(window_->rect().center()));
    const QList<QAction*> all = menu->actions();
    if (all.isEmpty()) return;
    QAction* start = all[chosen % all.size()];
    report("“" + start->text() + "”");
    const QPoint at = menu->actionGeometry(start).center();
    const QPointer<QWindow> window = menu->windowHandle();
    timestamp_ += 2000;
    for (const QEvent::Type type : {QEvent::MouseMove, QEvent::MouseButtonPress, QEvent::MouseButtonRelease}) {
      if (window == nullptr) return;
      mouse(window, at, type == QEvent::MouseMove ? Qt::NoButton : Qt::LeftButton, type, Qt::NoModifier);
    }
    return;
  }
}

void Monkey::new_scene() {
  if (window_ == nullptr || !answers()) return;
  for (QAction* action : window_->findChildren<QAction*>()) {
    if (action->shortcut() == QKeySequence(QKeySequence::New)) return action->trigger();
  }
}

}  // namespace carom
