#pragma once

#include <QObject>

#include "physics/preset/preset.h"

class QMenu;
class QToolBar;
class QToolButton;

namespace carom {

// The choice of the method: a menu, and a tool bar button for each of the four choices. It changes nothing
// itself: a signal reports the user's choice.
class MethodBar : public QObject {
  Q_OBJECT

 public:
  // Adds its choices to the menu.
  MethodBar(QMenu* methods, QWidget* window);
  void add_to(QToolBar* bar);
  // Sets the current method and the methods that the scene allows.
  void show_document(const Preset& document);

 signals:
  void methodChosen(const carom::Method& method);
  // The names are shown anew: what else stands in the tool bar may have all the room that it wants, until so
  // many px are missing for them.
  void roomFreed();
  void roomMissing(int pixels);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  template <class Table, class Member>
  [[nodiscard]] QMenu* add_choices(QMenu* methods, const QString& title, const Table& table, Member member);
  void add_steps(QMenu* methods);
  void ask_for_step();
  void choose(double Method::*member, double value);
  void add_number(QMenu* menu, const QString& text, double Method::*member, double value);
  void show_names();  // as wide as the tool bar allows
  void show_allowed(const Scene& scene);

  QWidget* window_;
  Method method_;
  QToolBar* bar_ = nullptr;
  QMenu* integrator_menu_ = nullptr;
  QMenu* steps_ = nullptr;
  QMenu* tolerances_ = nullptr;
  QToolButton* integrator_ = nullptr;
  QToolButton* impacts_ = nullptr;
  QToolButton* contacts_ = nullptr;
  QToolButton* step_ = nullptr;
};

}  // namespace carom
