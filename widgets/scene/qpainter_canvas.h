#pragma once

#include <QWidget>

#include "widgets/scene/drawing.h"
#include "widgets/scene/overlay.h"

class QPainter;

namespace carom {

// Content of a canvas, owned by the scene view, which outlives the canvas.
struct Picture {
  Drawing drawing;
  Overlay overlay;
  Camera camera;
  Theme theme;
  bool focus_frame = false;  // the focus came by Tab
};

// Paints the screen's overlay: text, what the tools show, and the frame of keyboard focus.
void paint_overlay(QPainter& painter, const Picture& picture);

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
