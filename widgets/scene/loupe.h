#pragma once

#include <QPointF>
#include <QWidget>
#include <functional>

#include "widgets/scene/camera.h"
#include "widgets/scene/drawing.h"
#include "widgets/theme/theme.h"

namespace carom {

// A round magnifier over a picture of the scene: what is under its middle, kTimes as large. It lets the mouse
// through.
class Loupe : public QWidget {
  Q_OBJECT

 public:
  static constexpr double kTimes = 5.0;
  static constexpr int kSide = 240;  // px

  // `draw` makes the drawing of what a camera sees.
  Loupe(std::function<Drawing(const Camera&)> draw, QWidget* parent);

  // Magnifies what this camera of the parent shows at the place `at` (px).
  void show_at(const QPointF& at, const Camera& camera, const Theme& theme);
  [[nodiscard]] const Camera& camera() const { return camera_; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  std::function<Drawing(const Camera&)> draw_;
  Camera camera_;
  Theme theme_;
};

}  // namespace carom
