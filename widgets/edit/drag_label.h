#pragma once

#include <optional>

#include "widgets/base/plain_text.h"

namespace carom {

// A label that is pulled left and right like a slider. A press alone does nothing; with Shift it is ten times
// finer.
class DragLabel : public PlainLabel {
  Q_OBJECT

 public:
  explicit DragLabel(const QString& text, QWidget* parent = nullptr);

 signals:
  void began();
  // px since it began; those with Shift count a tenth.
  void moved(double pixels);

 protected:
  bool event(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;

 private:
  std::optional<int> last_x_;  // px, while the button is down
  bool pulling_ = false;
  double pixels_ = 0.0;
};

}  // namespace carom
