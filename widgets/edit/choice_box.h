#pragma once

#include <QComboBox>

namespace carom {

// A list of choices that the wheel scrolls past unless it has the focus.
class ChoiceBox : public QComboBox {
 public:
  explicit ChoiceBox(QWidget* parent);

  // Lists these words, if they are not listed yet.
  void list(const QStringList& words);

 protected:
  void wheelEvent(QWheelEvent* event) override;
};

}  // namespace carom
