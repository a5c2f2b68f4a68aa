#include "widgets/scene/gl_canvas.h"

#include <QGuiApplication>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLPaintDevice>
#include <QPainter>
#include <QSurfaceFormat>
#include <algorithm>
#include <cmath>
#include <cstddef>

#include "widgets/scene/paint_drawing.h"

namespace carom {
namespace {

constexpr float kRoundedBox = 0.0F;  // discs, boxes and lines: a core rectangle grown by a rounding
constexpr float kTriangle = 1.0F;    // isosceles, its tip at +x
constexpr float kPolygon = 2.0F;     // convex, grown by a rounding

constexpr const char* kVertexShader = R"(#version 330 core
layout(location = 0) in vec2 center;
layout(location = 1) in vec2 axis;
layout(location = 2) in vec2 half_size;
layout(location = 3) in vec3 shape;  // rounding, line width, kind
layout(location = 4) in vec4 fill;
layout(location = 5) in vec4 line;
layout(location = 6) in vec2 corners;
uniform vec2 to_clip;
out vec2 local;
flat out vec2 core;
flat out vec3 form;
flat out ivec2 range;
flat out vec4 fill_color;
flat out vec4 line_color;
void main() {
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0;
  local = corner * (half_size + shape.x + 0.5 * shape.y + 1.0);
  core = half_size;
  form = shape;
  range = ivec2(corners);
  fill_color = fill;
  line_color = line;
  vec2 at = center + axis * local.x + vec2(-axis.y, axis.x) * local.y;
  gl_Position = vec4(at.x * to_clip.x - 1.0, 1.0 - at.y * to_clip.y, 0.0, 1.0);
}
)";

// Coverage is half a pixel either side of the edge; a pixel's size comes from the derivative of the position,
// not of the distance, which has a crease along the middle of thin lines.
constexpr const char* kFragmentShader = R"(#version 330 core
in vec2 local;
flat in vec2 core;
flat in vec3 form;
flat in ivec2 range;
uniform samplerBuffer points;
flat in vec4 fill_color;
flat in vec4 line_color;
out vec4 color;
float rounded_box(vec2 p) {
  vec2 q = abs(p) - core;
  return length(max(q, 0.0)) + min(max(q.x, q.y), 0.0) - form.x;
}
float triangle(vec2 p) {
  vec2 side = normalize(vec2(core.y, 2.0 * core.x));
  return max(-p.x - core.x, dot(vec2(p.x - core.x, abs(p.y)), side));
}
// The nearest edge's distance; inside where no edge has the point on its outer side.
float polygon(vec2 p) {
  float nearest = 1e30;
  float outer = -1e30;
  vec2 a = texelFetch(points, range.x + range.y - 1).xy;
  for (int k = 0; k < range.y; ++k) {
    vec2 b = texelFetch(points, range.x + k).xy;
    vec2 e = b - a;
    vec2 w = p - a;
    nearest = min(nearest, length(w - e * clamp(dot(w, e) / max(dot(e, e), 1e-12), 0.0, 1.0)));
    outer = max(outer, dot(w, vec2(-e.y, e.x)));
    a = b;
  }
  return (outer > 0.0 || range.y < 3 ? nearest : -nearest) - form.x;
}
void main() {
  float pixel = length(vec2(dFdx(local.x), dFdy(local.x)));
  float distance = form.z < 0.5 ? rounded_box(local) : form.z < 1.5 ? triangle(local) : polygon(local);
  float inside = clamp(0.5 - distance / pixel, 0.0, 1.0) * fill_color.a;
  float outline = form.y > 0.0
      ? clamp(0.5 - (abs(distance) - 0.5 * form.y) / pixel, 0.0, 1.0) * line_color.a : 0.0;
  color = vec4(line_color.rgb, 1.0) * outline + vec4(fill_color.rgb, 1.0) * inside * (1.0 - outline);
}
)";

QPointF direction(double angle) { return {std::cos(angle), -std::sin(angle)}; }

}  // namespace

GlCanvas::GlCanvas(const Picture& picture, QWidget* parent)
    : QOpenGLWidget(parent),
      picture_(picture),
      buffer_(QOpenGLBuffer::VertexBuffer),
      corner_buffer_(QOpenGLBuffer::VertexBuffer) {
  QSurfaceFormat surface = format();
  surface.setVersion(3, 3);
  surface.setProfile(QSurfaceFormat::CoreProfile);
  surface.setStencilBufferSize(8);  // needed by QPainter's text
  setFormat(surface);
  setAttribute(Qt::WA_TransparentForMouseEvents);
}

GlCanvas::~GlCanvas() { release(); }

bool GlCanvas::available() {
  // Elsewhere (offscreen, minimal, ...) showing a QOpenGLWidget may crash even where a context can be made.
  const QString platform = QGuiApplication::platformName();
  if (platform != "xcb" && platform != "windows" && platform != "cocoa" && !platform.startsWith("wayland")) {
    return false;
  }
  QSurfaceFormat wanted;
  wanted.setVersion(3, 3);
  wanted.setProfile(QSurfaceFormat::CoreProfile);
  QOffscreenSurface surface;
  surface.setFormat(wanted);
  surface.create();
  QOpenGLContext context;
  context.setFormat(wanted);
  if (!context.create() || !context.makeCurrent(&surface)) return false;
  const bool enough = context.format().version() >= qMakePair(3, 3) && !context.isOpenGLES();
  context.doneCurrent();
  return enough;
}

void GlCanvas::initializeGL() {
  initializeOpenGLFunctions();
  // A widget that moves to another window gets a new context.
  connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, [this] { release(); });
  program_ = std::make_unique<QOpenGLShaderProgram>();
  const bool linked = program_->addShaderFromSourceCode(QOpenGLShader::Vertex, kVertexShader) &&
                      program_->addShaderFromSourceCode(QOpenGLShader::Fragment, kFragmentShader) &&
                      program_->link();
  if (!linked) qFatal("the scene's shaders don't build: %s", qPrintable(program_->log()));
  to_clip_ = program_->uniformLocation("to_clip");
  array_.create();
  buffer_.create();
  buffer_.setUsagePattern(QOpenGLBuffer::StreamDraw);
  corner_buffer_.create();
  corner_buffer_.setUsagePattern(QOpenGLBuffer::StreamDraw);
  glGenTextures(1, &corner_texture_);

  const QOpenGLVertexArrayObject::Binder bound(&array_);
  buffer_.bind();
  const auto attribute = [this](GLuint place, GLint size, GLenum type, std::size_t offset) {
    glEnableVertexAttribArray(place);
    glVertexAttribPointer(place, size, type, type == GL_UNSIGNED_BYTE, sizeof(Instance),
                          reinterpret_cast<const void*>(offset));
    glVertexAttribDivisor(place, 1);
  };
  attribute(0, 2, GL_FLOAT, offsetof(Instance, center));
  attribute(1, 2, GL_FLOAT, offsetof(Instance, axis));
  attribute(2, 2, GL_FLOAT, offsetof(Instance, half));
  attribute(3, 3, GL_FLOAT, offsetof(Instance, rounding));
  attribute(4, 4, GL_UNSIGNED_BYTE, offsetof(Instance, fill));
  attribute(5, 4, GL_UNSIGNED_BYTE, offsetof(Instance, line));
  attribute(6, 2, GL_FLOAT, offsetof(Instance, corners));
  buffer_.release();
}

void GlCanvas::release() {
  if (!program_) return;
  makeCurrent();
  glDeleteTextures(1, &corner_texture_);
  corner_buffer_.destroy();
  buffer_.destroy();
  array_.destroy();
  program_.reset();
  doneCurrent();
  disconnect(context(), nullptr, this, nullptr);
}

void GlCanvas::paintGL() {
  collect();
  const QColor& ground = picture_.theme.scene_ground;
  glClearColor(ground.redF(), ground.greenF(), ground.blueF(), 1.0F);
  glClear(GL_COLOR_BUFFER_BIT);
  if (!instances_.empty()) {
    glDisable(GL_DEPTH_TEST);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    program_->bind();
    const QSizeF& viewport = picture_.camera.viewport;
    program_->setUniformValue(to_clip_, QVector2D(static_cast<float>(2.0 / (viewport.width() * ratio_)),
                                                  static_cast<float>(2.0 / (viewport.height() * ratio_))));
    {
      if (!corners_.empty()) {
        corner_buffer_.bind();
        corner_buffer_.allocate(corners_.data(), static_cast<int>(corners_.size() * sizeof(float)));
        corner_buffer_.release();
        glBindTexture(GL_TEXTURE_BUFFER, corner_texture_);
        glTexBuffer(GL_TEXTURE_BUFFER, GL_RG32F, corner_buffer_.bufferId());
      }
      const QOpenGLVertexArrayObject::Binder bound(&array_);
      buffer_.bind();
      buffer_.allocate(instances_.data(), static_cast<int>(instances_.size() * sizeof(Instance)));
      glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(instances_.size()));
      buffer_.release();
    }
    program_->release();
  }
  // Not QPainter(this): a grab of the window would redirect it and lose the text below the picture.
  QOpenGLPaintDevice device(size() * ratio_);
  device.setDevicePixelRatio(ratio_);
  QPainter painter(&device);
  painter.setFont(font());
  paint_overlay(painter, picture_);
}

// Converts the list to quads. Positions become pixels in double; only pixels, small numbers, become float.
void GlCanvas::collect() {
  ratio_ = devicePixelRatioF();
  instances_.clear();
  corners_.clear();
  const Drawing& drawing = picture_.drawing;
  const Camera& camera = picture_.camera;
  const QPointF right(1.0, 0.0);
  if (drawing.has_grid) {
    for (const Grid::Line& line : drawing.grid.lines) {
      const QRectF r = line_rect(line, camera, grid_line_width(drawing), ratio_);
      add(r.center(), right, r.width() / 2, r.height() / 2, 0.0, 0.0, kRoundedBox,
          line.strong ? picture_.theme.strong_grid : picture_.theme.grid, {});
    }
  }
  for (const Drawing::BoxItem& box : drawing.boxes) {
    const Vec2 half = box.half * camera.scale;
    const double corner = std::min(kCornerRadius, half.minCoeff());
    add(camera.to_screen(box.center), direction(box.angle), half.x() - corner, half.y() - corner, corner,
        drawing.outline, kRoundedBox, box.fill, box.line);
  }
  for (const Drawing::PolygonItem& polygon : drawing.polygons) add_polygon(polygon);
  const auto add_segments = [&](const std::vector<Drawing::SegmentItem>& segments) {
    for (const Drawing::SegmentItem& segment : segments) {
      add_line(camera.to_screen(segment.from), camera.to_screen(segment.to), segment.width, segment.color,
               true);
    }
  };
  add_segments(drawing.lines);
  for (const Drawing::DiscItem& disc : drawing.discs) {
    const QPointF center = camera.to_screen(disc.center);
    const double radius = disc.radius * camera.scale;
    add(center, right, 0.0, 0.0, radius, drawing.outline, kRoundedBox, disc.fill, disc.line);
    if (disc.oriented) {
      add_line(center, center + radius * direction(disc.angle), drawing.outline, disc.line, true);
    }
  }
  add_segments(drawing.segments);
  for (const Drawing::ArrowItem& arrow : drawing.arrows) {
    const ArrowOnScreen a = arrow_on_screen(arrow, camera);
    add_line(a.from, a.shaft_end, arrow.width, arrow.color, false);
    const QPointF along = (a.tip - a.from) / QLineF(a.from, a.tip).length();
    add(a.tip - along * (a.head_length / 2), along, a.head_length / 2, a.head_half_width, 0.0, 0.0, kTriangle,
        arrow.color, {});
  }
}

void GlCanvas::add_polygon(const Drawing::PolygonItem& polygon) {
  const Camera& camera = picture_.camera;
  const std::span<const Vec2> corners = picture_.drawing.corners(polygon);
  QRectF around(camera.to_screen(corners[0]), QSizeF(0.0, 0.0));
  for (const Vec2& corner : corners) {
    const QPointF at = camera.to_screen(corner);
    around.setCoords(std::min(around.left(), at.x()), std::min(around.top(), at.y()),
                     std::max(around.right(), at.x()), std::max(around.bottom(), at.y()));
  }
  const std::size_t known = corners_.size() / 2;
  const auto first = static_cast<float>(known);
  for (const Vec2& corner : corners) {
    const QPointF at = (camera.to_screen(corner) - around.center()) * ratio_;
    corners_.push_back(static_cast<float>(at.x()));
    corners_.push_back(static_cast<float>(at.y()));
  }
  add(around.center(), QPointF(1.0, 0.0), around.width() / 2, around.height() / 2,
      polygon.rounding * camera.scale, picture_.drawing.outline, kPolygon, polygon.fill, polygon.line);
  instances_.back().corners[0] = first;
  instances_.back().corners[1] = static_cast<float>(corners.size());
}

void GlCanvas::add(const QPointF& center, const QPointF& axis, double half_x, double half_y, double rounding,
                   double line_width, float kind, const QColor& fill, const QColor& line) {
  const auto pixels = [this](double logical) { return static_cast<float>(logical * ratio_); };
  const auto byte = [](int channel) { return static_cast<std::uint8_t>(channel); };
  instances_.push_back({{pixels(center.x()), pixels(center.y())},
                        {static_cast<float>(axis.x()), static_cast<float>(axis.y())},
                        {pixels(half_x), pixels(half_y)},
                        pixels(rounding),
                        pixels(line_width),
                        kind,
                        {0.0F, 0.0F},
                        {byte(fill.red()), byte(fill.green()), byte(fill.blue()), byte(fill.alpha())},
                        {byte(line.red()), byte(line.green()), byte(line.blue()), byte(line.alpha())}});
}

void GlCanvas::add_line(const QPointF& from, const QPointF& to, double width, const QColor& color, bool round) {
  const double length = QLineF(from, to).length();
  const QPointF along = length > 0.0 ? (to - from) / length : QPointF(1.0, 0.0);
  add((from + to) / 2, along, length / 2, round ? 0.0 : width / 2, round ? width / 2 : 0.0, 0.0, kRoundedBox,
      color, {});
}

}  // namespace carom
