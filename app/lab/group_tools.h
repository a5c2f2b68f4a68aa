#pragma once

#include <QList>
#include <QWidget>

class QAction;
class QPushButton;

namespace carom {

// What is done with several bodies together, as buttons: their actions are those of the menus.
class GroupTools : public QWidget {
  Q_OBJECT

 public:
  // `align`: its actions up to the separator put bodies in line, those after it distribute them.
  GroupTools(const QList<QAction*>& align, QAction* touch, QWidget* parent = nullptr);

  // Whether the bodies can be put in line, distributed and put in touch now.
  void enable(bool align, bool distribute, bool touch);

 private:
  QAction* touch_action_;
  QPushButton* align_;
  QPushButton* distribute_;
  QPushButton* touch_;
};

}  // namespace carom
