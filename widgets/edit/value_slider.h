#pragma once

#include <QSlider>
#include <optional>

#include "widgets/edit/slider_scale.h"

namespace carom {

// A slider beside a field. A press beside its knob brings the knob there, one on it moves nothing; Escape takes
// the pull back. The field has the keys.
class ValueSlider : public QSlider {
  Q_OBJECT

 public:
  explicit ValueSlider(QWidget* parent = nullptr);

  // While it is pulled its scale stays.
  void show_value(const Range& range, double value);

 signals:
  void began();
  void moved(double value);  // SI
  void cancelled();

 protected:
  bool event(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;

 private:
  [[nodiscard]] int room() const;     // px that the middle of the knob goes through
  [[nodiscard]] double knob() const;  // px from the left end of the room
  void pull_to(double pixels);

  SliderScale scale_;
  std::optional<double> grip_;  // px from the knob to the mouse, while it is pulled
};

}  // namespace carom
