#pragma once

#include <QOpenGLBuffer>
#include <QOpenGLFunctions_3_3_Core>
#include <QOpenGLShaderProgram>
#include <QOpenGLVertexArrayObject>
#include <QOpenGLWidget>
#include <cstdint>
#include <memory>
#include <vector>

#include "widgets/scene/qpainter_canvas.h"

namespace carom {

// Paints the picture by OpenGL 3.3 core: every shape is one instance of a quad, drawn in the list's order by a
// single call; the fragment shader covers it by its signed distance, with edges one device pixel soft.
// QPainter draws text on top.
class GlCanvas : public QOpenGLWidget, private QOpenGLFunctions_3_3_Core {
 public:
  explicit GlCanvas(const Picture& picture, QWidget* parent = nullptr);
  ~GlCanvas() override;

  // Whether this platform can show a QOpenGLWidget and create an OpenGL 3.3 context. Queries the driver.
  [[nodiscard]] static bool available();

 protected:
  void initializeGL() override;
  void paintGL() override;

 private:
  // One quad, in device pixels from the viewport's upper left, y down.
  struct Instance {
    float center[2];
    float axis[2];  // unit vector of its own x
    float half[2];  // of the core, without `rounding`
    float rounding;
    float line_width;
    float kind;
    float corners[2];  // of a polygon: the first one in `corners_` and their number
    std::uint8_t fill[4];
    std::uint8_t line[4];
  };

  void collect();
  void add_polygon(const Drawing::PolygonItem& polygon);
  void add(const QPointF& center, const QPointF& axis, double half_x, double half_y, double rounding,
           double line_width, float kind, const QColor& fill, const QColor& line);
  void add_line(const QPointF& from, const QPointF& to, double width, const QColor& color, bool round);
  void release();

  const Picture& picture_;
  double ratio_ = 1.0;  // device pixels per logical pixel
  std::vector<Instance> instances_;
  std::vector<float>
      corners_;  // x, y of the polygons' corners, in device pixels from their quad's centre, y down
  std::unique_ptr<QOpenGLShaderProgram> program_;
  QOpenGLVertexArrayObject array_;
  QOpenGLBuffer buffer_;
  QOpenGLBuffer corner_buffer_;
  unsigned int corner_texture_ = 0;  // uploads the corners to the shader
  int to_clip_ = -1;
};

}  // namespace carom
