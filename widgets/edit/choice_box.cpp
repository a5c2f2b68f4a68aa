#include "widgets/edit/choice_box.h"

#include <QWheelEvent>

namespace carom {

ChoiceBox::ChoiceBox(QWidget* parent) : QComboBox(parent) {
  setFocusPolicy(Qt::StrongFocus);
  setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  setMinimumContentsLength(4);
}

void ChoiceBox::list(const QStringList& words) {
  QStringList listed;
  for (int i = 0; i < count(); ++i) listed << itemText(i);
  if (listed == words) return;
  clear();
  addItems(words);
}

void ChoiceBox::wheelEvent(QWheelEvent* event) {
  if (hasFocus()) {
    QComboBox::wheelEvent(event);
  } else {
    event->ignore();
  }
}

}  // namespace carom
