#pragma once

#include <QEvent>
#include <QObject>
#include <QPoint>
#include <QString>
#include <QStringList>
#include <QTimer>
#include <functional>
#include <map>
#include <memory>
#include <random>
#include <vector>

class QWindow;

namespace carom {

class LabWindow;

// Random mouse, keys, drags, drops, resizes and closings on the real lab window, in an order given by a seed.
// Events enter at the same place as those of the screen, so that popups, modal dialogs and focus act as for
// people. Each action is one turn of the innermost event loop: where a dialog waits, the next action goes to
// it. A closed window is replaced by a new one.
class Monkey : public QObject {
 public:
  struct Options {
    unsigned seed = 1;
    int actions = 300;
    QString folder;                             // the only folder that is written to, with files to open
    std::function<void(const QString&)> about;  // receives each action before it is done
  };

  explicit Monkey(Options options);
  ~Monkey() override;

  // Returns after the last action, with every window closed.
  void run();
  // How often each kind of action was done.
  [[nodiscard]] const std::map<std::string, int>& counts() const { return counts_; }
  [[nodiscard]] int windows() const { return windows_; }  // opened one after the other

 private:
  struct Kind {
    const char* name;
    int weight;
    void (Monkey::*act)();
  };
  static const std::vector<Kind>& kinds();

  void act();
  void report(const QString& what);
  void open_window();
  void stay_inside();  // resets file dialogs and folder fields that have left the monkey's folder

  // Whole numbers from 0 to below n, and true once in n.
  [[nodiscard]] int below(int n);
  [[nodiscard]] bool once_in(int n) { return below(n) == 0; }
  [[nodiscard]] Qt::KeyboardModifiers modifiers();
  [[nodiscard]] QString file();

  // The target of events: an open menu, or else a waiting dialog, or else any window.
  [[nodiscard]] QWindow* target();
  [[nodiscard]] QPoint place(const QWindow& window);
  void mouse(QWindow* window, const QPoint& at, Qt::MouseButton button, QEvent::Type type,
             Qt::KeyboardModifiers held);
  void click_at(Qt::MouseButton button, int times);

  void move();
  void click();
  void double_click();
  void right_click();
  void middle_click();
  void press_only();
  void drag();
  void wheel();
  void key();
  void type();
  void shortcut();
  void menu();
  void button();
  void answer();
  void experiment();
  void open_file();
  void drop();
  void resize();
  void close_top();
  void clipboard();
  void play();
  void rest();
  // On the parts of the lab (monkey_lab.cpp).
  [[nodiscard]] QPoint near_body();
  void drag_in(QWidget& widget, const QPoint& from, const QPoint& to);
  void draw();
  void cell();
  void slider();
  void link();
  void edit_key();
  void take_back();
  void fold();
  void scrub();
  void new_scene();
  void wait();
  void pull();
  void stop();
  void start();

  Options options_;
  std::mt19937 random_;
  std::unique_ptr<LabWindow> window_;
  std::vector<QString> names_;  // of the experiments
  std::map<std::string, int> counts_;
  int done_ = 0;
  int windows_ = 0;
  int acting_at_ = -1;  // the level of the event loop of the current action
  int timestamp_ = 1000;
  Qt::MouseButtons held_;
};

}  // namespace carom
