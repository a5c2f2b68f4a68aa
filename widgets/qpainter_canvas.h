#pragma once

#include <QWidget>

#include "widgets/drawing.h"

namespace carom {

// What a canvas shows; the scene view owns it and outlives the canvas.
struct Picture {
  Drawing drawing;
  Camera camera;
  Theme theme;
};

// Paints the picture by QPainter, where there is no OpenGL.
class QPainterCanvas : public QWidget {
 public:
  explicit QPainterCanvas(const Picture& picture, QWidget* parent = nullptr);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  const Picture& picture_;
};

}  // namespace carom
