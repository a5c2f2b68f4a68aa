#include "monkey.h"

#include <QAbstractButton>
#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QContextMenuEvent>
#include <QCursor>
#include <QDialog>
#include <QDir>
#include <QDropEvent>
#include <QElapsedTimer>
#include <QEventLoop>
#include <QFileDialog>
#include <QGuiApplication>
#include <QImage>
#include <QLineEdit>
#include <QMenu>
#include <QMimeData>
#include <QPointer>
#include <QScreen>
#include <QTest>
#include <QThread>
#include <QUrl>
#include <QWheelEvent>
#include <QWindow>
#include <algorithm>
#include <array>

#include "app/lab/lab_window.h"
#include "app/library/preset_library.h"
#include "widgets/run/experiment_list.h"
#include "widgets/theme/theme.h"

namespace carom {

Monkey::Monkey(Options options) : options_(std::move(options)), random_(options_.seed) {
  for (const LibraryEntry& entry : preset_library()) names_.push_back(QString::fromStdString(entry.name));
}

Monkey::~Monkey() = default;

int Monkey::below(int n) { return static_cast<int>(random_() % static_cast<unsigned>(n)); }

Qt::KeyboardModifiers Monkey::modifiers() {
  constexpr std::array kHeld = {Qt::NoModifier, Qt::NoModifier, Qt::NoModifier, Qt::ControlModifier,
                                Qt::ShiftModifier};
  return kHeld[static_cast<std::size_t>(below(static_cast<int>(kHeld.size())))];
}

void Monkey::report(const QString& what) {
  if (options_.about) options_.about(QString("%1: %2").arg(done_).arg(what));
}

void Monkey::open_window() {
  window_.reset();
  window_ = std::make_unique<LabWindow>(once_in(2) ? light_theme() : dark_theme());
  ++windows_;
  window_->open(names_[static_cast<std::size_t>(below(static_cast<int>(names_.size())))].toStdString());
  window_->show();
}

void Monkey::run() {
  open_window();
  QEventLoop loop;
  QTimer end;
  connect(&end, &QTimer::timeout, &loop, [&] {
    if (done_ >= options_.actions && QThread::currentThread()->loopLevel() == 1) loop.quit();
  });
  end.start(10);
  QTimer::singleShot(0, this, &Monkey::act);
  loop.exec();
  report("closing the window");
  window_.reset();
}

void Monkey::act() {
  const int level = QThread::currentThread()->loopLevel();
  QTimer::singleShot(0, this, &Monkey::act);
  if (acting_at_ == level) return;  // within an action that processes events
  stay_inside();
  if (done_ >= options_.actions) {
    // Open questions get no answer.
    if (QWidget* popup = QApplication::activePopupWidget()) popup->close();
    if (auto* dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget())) dialog->reject();
    return;
  }
  const int outer = std::exchange(acting_at_, level);
  ++done_;
  if (level == 1 && (window_ == nullptr || !window_->isVisible())) {
    report("a new window");
    open_window();
  }
  int total = 0;
  for (const Kind& kind : kinds()) total += kind.weight;
  int chosen = below(total);
  for (const Kind& kind : kinds()) {
    chosen -= kind.weight;
    if (chosen >= 0) continue;
    ++counts_[kind.name];
    report(kind.name);
    (this->*kind.act)();
    break;
  }
  acting_at_ = outer;
}

// A native rename or delete is never offered, and what is typed has no slash: one step outside can be undone
// before the next action.
void Monkey::stay_inside() {
  for (QWidget* widget : QApplication::topLevelWidgets()) {
    if (auto* dialog = qobject_cast<QFileDialog*>(widget); dialog != nullptr && dialog->isVisible()) {
      dialog->setOption(QFileDialog::ReadOnly);
      if (!dialog->directory().absolutePath().startsWith(options_.folder))
        dialog->setDirectory(options_.folder);
    }
    for (auto* field : widget->findChildren<QLineEdit*>("folder")) {
      if (!field->text().startsWith(options_.folder + "/")) field->setText(options_.folder + "/film");
    }
  }
}

QString Monkey::file() {
  QStringList all;
  for (const QFileInfo& entry :
       QDir(options_.folder)
           .entryInfoList(QDir::Files | QDir::Dirs | QDir::System | QDir::NoDotAndDotDot, QDir::Name))
    all << entry.absoluteFilePath();
  return all.isEmpty() ? options_.folder : all[below(static_cast<int>(all.size()))];
}

// --- events
// --------------------------------------------------------------------------------------------------------

QWindow* Monkey::target() {
  if (QWidget* popup = QApplication::activePopupWidget(); popup != nullptr && !once_in(8)) {
    return popup->windowHandle();
  }
  if (QWidget* modal = QApplication::activeModalWidget(); modal != nullptr && !once_in(16)) {
    return modal->windowHandle();
  }
  std::vector<QWindow*> shown;
  for (QWindow* window : QGuiApplication::topLevelWindows()) {
    if (window->isVisible()) shown.push_back(window);
  }
  return shown.empty() ? nullptr : shown[static_cast<std::size_t>(below(static_cast<int>(shown.size())))];
}

QPoint Monkey::place(const QWindow& window) {
  return {below(std::max(window.width(), 1)), below(std::max(window.height(), 1))};
}

void Monkey::mouse(QWindow* window, const QPoint& at, Qt::MouseButton button, QEvent::Type type,
                   Qt::KeyboardModifiers held) {
  if (type == QEvent::MouseButtonPress) held_ |= button;
  if (type == QEvent::MouseButtonRelease) held_ &= ~button;
  const QPoint global = window->mapToGlobal(at);
  if (type == QEvent::MouseMove) QCursor::setPos(global);
  qt_handleMouseEvent(window, at, global, held_, button, type, held, timestamp_ += 5);
}

void Monkey::click_at(Qt::MouseButton button, int times) {
  QPointer<QWindow> window = target();
  if (window == nullptr) return;
  const QPoint at = place(*window);
  const Qt::KeyboardModifiers held = modifiers();
  timestamp_ += 2000;  // keeps two clicks from being a double click
  for (int i = 0; i < times; ++i) {
    for (const QEvent::Type type : {QEvent::MouseMove, QEvent::MouseButtonPress, QEvent::MouseButtonRelease}) {
      if (window == nullptr) return;  // closed by the previous step
      mouse(window, at, type == QEvent::MouseMove ? Qt::NoButton : button, type, held);
    }
  }
}

void Monkey::move() {
  if (QWindow* window = target())
    mouse(window, place(*window), Qt::NoButton, QEvent::MouseMove, Qt::NoModifier);
}
void Monkey::click() { click_at(Qt::LeftButton, 1); }
void Monkey::double_click() { click_at(Qt::LeftButton, 2); }
void Monkey::right_click() {
  click_at(Qt::RightButton, 1);
  // The screen's own events cause this one.
  QWidget* under = QApplication::widgetAt(QCursor::pos());
  if (under == nullptr ||
      (QApplication::activeModalWidget() != nullptr && under->window() != QApplication::activeModalWidget()))
    return;
  QContextMenuEvent event(QContextMenuEvent::Mouse, under->mapFromGlobal(QCursor::pos()), QCursor::pos());
  QApplication::sendEvent(under, &event);
}
void Monkey::middle_click() { click_at(Qt::MiddleButton, 1); }

void Monkey::press_only() {
  if (QWindow* window = target())
    mouse(window, place(*window), Qt::LeftButton, QEvent::MouseButtonPress, modifiers());
}

void Monkey::drag() {
  QPointer<QWindow> window = target();
  if (window == nullptr) return;
  const Qt::MouseButton button = once_in(5) ? Qt::MiddleButton : Qt::LeftButton;
  const Qt::KeyboardModifiers held = modifiers();
  const QPoint from = place(*window);
  const QPoint to = place(*window);
  timestamp_ += 2000;
  mouse(window, from, Qt::NoButton, QEvent::MouseMove, held);
  if (window != nullptr) mouse(window, from, button, QEvent::MouseButtonPress, held);
  constexpr int kParts = 5;
  for (int i = 1; i <= kParts && window != nullptr; ++i)
    mouse(window, from + (to - from) * i / kParts, Qt::NoButton, QEvent::MouseMove, held);
  if (window != nullptr) mouse(window, to, button, QEvent::MouseButtonRelease, held);
}

void Monkey::wheel() {
  QWindow* window = target();
  if (window == nullptr) return;
  const QPoint at = place(*window);
  const Qt::KeyboardModifiers held = modifiers();
  const QPoint turn(0, (below(9) - 4) * 120);
  QWidget* modal = QApplication::activeModalWidget();
  if (modal != nullptr && modal->windowHandle() != window) return;
  QWheelEvent event(at, window->mapToGlobal(at), {}, turn, Qt::NoButton, held, Qt::NoScrollPhase, false);
  QApplication::sendEvent(window, &event);
}

namespace {

QWindow* with_focus() {
  if (QWidget* popup = QApplication::activePopupWidget()) return popup->windowHandle();
  if (QWindow* focused = QGuiApplication::focusWindow()) return focused;
  if (QWidget* modal = QApplication::activeModalWidget()) return modal->windowHandle();
  return nullptr;
}

void press_key(QWindow* window, int key, Qt::KeyboardModifiers held, const QString& text = {}) {
  const QPointer<QWindow> where = window;
  qt_handleKeyEvent(where, QEvent::KeyPress, key, held, text);
  if (where != nullptr) qt_handleKeyEvent(where, QEvent::KeyRelease, key, held, text);
}

}  // namespace

void Monkey::key() {
  constexpr std::array kKeys = {
      Qt::Key_Up,        Qt::Key_Down,    Qt::Key_Left,     Qt::Key_Right, Qt::Key_Return, Qt::Key_Escape,
      Qt::Key_Tab,       Qt::Key_Backtab, Qt::Key_Space,    Qt::Key_Home,  Qt::Key_End,    Qt::Key_Delete,
      Qt::Key_Backspace, Qt::Key_PageUp,  Qt::Key_PageDown, Qt::Key_R,     Qt::Key_C,      Qt::Key_F,
      Qt::Key_Period,    Qt::Key_Menu,    Qt::Key_B,        Qt::Key_P,     Qt::Key_W,      Qt::Key_D,
      Qt::Key_O,         Qt::Key_T,       Qt::Key_S,        Qt::Key_N,     Qt::Key_J,      Qt::Key_A,
      Qt::Key_Comma,     Qt::Key_G};
  const auto chosen = kKeys[static_cast<std::size_t>(below(static_cast<int>(kKeys.size())))];
  const Qt::KeyboardModifiers held = once_in(4) ? modifiers() : Qt::NoModifier;
  QString text;
  if (chosen == Qt::Key_Space) text = " ";
  if (chosen == Qt::Key_Period) text = ".";
  if (chosen == Qt::Key_Comma) text = ",";
  if (chosen >= Qt::Key_A && chosen <= Qt::Key_Z) text = QChar(chosen).toLower();
  if (QWindow* window = with_focus()) press_key(window, chosen, held, text);
}

void Monkey::type() {
  static const QStringList words = {"ball",     "<b>x<img src=a>", "0,5; 1", "-1e400",     "2*exp(-t)",
                                    "a b.json", "%1 &x",           "3.7",    "Ünï ∑ code", "nan"};
  for (const QChar letter : words[below(static_cast<int>(words.size()))]) {
    QWindow* window = with_focus();
    if (window == nullptr) return;
    press_key(window, letter.toUpper().unicode(), Qt::NoModifier, letter);
  }
}

void Monkey::shortcut() {
  constexpr std::array kKeys = {Qt::Key_O, Qt::Key_S, Qt::Key_E, Qt::Key_L, Qt::Key_C, Qt::Key_V,
                                Qt::Key_A, Qt::Key_X, Qt::Key_Z, Qt::Key_Q, Qt::Key_W, Qt::Key_Home};
  const auto chosen = kKeys[static_cast<std::size_t>(below(static_cast<int>(kKeys.size())))];
  const Qt::KeyboardModifiers held =
      once_in(5) ? Qt::ControlModifier | Qt::ShiftModifier : Qt::KeyboardModifiers(Qt::ControlModifier);
  report(QString("Ctrl+%1").arg(QChar(chosen)));
  if (QWindow* window = with_focus()) press_key(window, chosen, held);
}

// --- what people find by looking
// ------------------------------------------------------------------------------------

void Monkey::menu() {
  const int chosen = below(1 << 20);
  if (window_ == nullptr || QApplication::activeModalWidget() != nullptr) return;
  QList<QAction*> all;
  for (QAction* action : window_->findChildren<QAction*>()) {
    if (action->isEnabled() && action->menu() == nullptr && !action->isSeparator()) all << action;
  }
  if (all.isEmpty()) return;
  QAction* action = all[chosen % all.size()];
  report("“" + action->text() + "”");
  action->trigger();
}

void Monkey::button() {
  const int chosen = below(1 << 20);
  QWidget* top = QApplication::activeModalWidget();
  if (top == nullptr) top = window_.get();
  if (top == nullptr) return;
  QList<QAbstractButton*> all;
  for (auto* each : top->findChildren<QAbstractButton*>()) {
    if (each->isVisible() && each->isEnabled() && each->rect().isValid()) all << each;
  }
  if (all.isEmpty()) return;
  QAbstractButton* each = all[chosen % all.size()];
  report("“" + each->text() + "” " + each->toolTip().left(30));
  const QPoint at = each->mapTo(each->window(), each->rect().center());
  QPointer<QWindow> window = each->window()->windowHandle();
  timestamp_ += 2000;
  for (const QEvent::Type type : {QEvent::MouseMove, QEvent::MouseButtonPress, QEvent::MouseButtonRelease}) {
    if (window == nullptr) return;
    mouse(window, at, type == QEvent::MouseMove ? Qt::NoButton : Qt::LeftButton, type, Qt::NoModifier);
  }
}

// Dialogs are closed more often than by chance, otherwise they would take most actions.
void Monkey::answer() {
  const bool away = once_in(2);
  QWindow* window = with_focus();
  const bool waits =
      QApplication::activeModalWidget() != nullptr || QApplication::activePopupWidget() != nullptr;
  if (window != nullptr && waits) press_key(window, away ? Qt::Key_Escape : Qt::Key_Return, Qt::NoModifier);
}

void Monkey::experiment() {
  const QString& name = names_[static_cast<std::size_t>(below(static_cast<int>(names_.size())))];
  if (window_ == nullptr || QApplication::activeModalWidget() != nullptr) return;
  report(name);
  emit window_->findChild<ExperimentList*>()->openRequested(name);
}

void Monkey::open_file() {
  const QString chosen = file();
  if (window_ == nullptr || QApplication::activeModalWidget() != nullptr) return;
  report(chosen);
  window_->open(chosen.toStdString());
}

void Monkey::drop() {
  QWindow* window = target();
  QMimeData data;
  if (once_in(3)) {
    data.setText("head-on <img src=x>");
  } else {
    QList<QUrl> urls;
    for (int i = 1 + below(2); i > 0; --i) urls << QUrl::fromLocalFile(file());
    data.setUrls(urls);
  }
  if (window == nullptr) return;
  const QPoint at = place(*window);
  QWidget* under = QApplication::widgetAt(window->mapToGlobal(at));
  const QWidget* modal = QApplication::activeModalWidget();
  if (under == nullptr || (modal != nullptr && under->window() != modal)) return;
  while (under != nullptr && !under->acceptDrops() && !under->isWindow()) under = under->parentWidget();
  if (!under->acceptDrops()) return;
  const QPoint there = under->mapFromGlobal(window->mapToGlobal(at));
  const QPointer<QWidget> where = under;
  QDragEnterEvent enter(there, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(where, &enter);
  if (where == nullptr || !enter.isAccepted()) return;
  QDropEvent event(there, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(where, &event);
}

void Monkey::resize() {
  const QSize size(300 + below(1600), 200 + below(1000));
  const int how = below(8);
  if (window_ == nullptr) return;
  if (how == 0) return window_->showMaximized();
  if (how == 1) return window_->showNormal();
  if (how == 2) return window_->showMinimized();
  if (window_->isMinimized()) window_->showNormal();
  window_->resize(size);
}

void Monkey::close_top() {
  QWindow* window = target();
  QWidget* modal = QApplication::activeModalWidget();
  if (window == nullptr || (modal != nullptr && modal->windowHandle() != window)) return;
  // On a screen an open menu has the mouse, and goes first. Qt's file dialog would free its own twice.
  if (QWidget* popup = QApplication::activePopupWidget()) {
    popup->close();
    return;
  }
  window->close();
}

void Monkey::clipboard() {
  QClipboard* clipboard = QGuiApplication::clipboard();
  const auto mode =
      clipboard->supportsSelection() && once_in(2) ? QClipboard::Selection : QClipboard::Clipboard;
  switch (below(4)) {
    case 0:
      return clipboard->clear(mode);
    case 1:
      return clipboard->setImage(QImage(8, 8, QImage::Format_RGB32), mode);
    case 2: {
      auto* data = new QMimeData;
      data->setHtml("<img src='file:///'><b>x</b>");
      return clipboard->setMimeData(data, mode);
    }
    default:
      return clipboard->setText("a\nb\tc <b>", mode);
  }
}

void Monkey::play() {
  QWidget* modal = QApplication::activeModalWidget();
  if (window_ == nullptr || modal != nullptr) return;
  for (QAction* action : window_->findChildren<QAction*>()) {
    if (action->shortcut() == QKeySequence(Qt::Key_Space)) return action->trigger();
  }
}

void Monkey::rest() {
  QElapsedTimer clock;
  clock.start();
  const int ms = 10 + below(40);
  while (clock.elapsed() < ms) QApplication::processEvents(QEventLoop::AllEvents, 5);
}

}  // namespace carom
