#include "widgets/scene/scene_view.h"

#include <Eigen/Geometry>
#include <QGuiApplication>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QStyleHints>
#include <QToolTip>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <utility>

#include "physics/preset/preset.h"
#include "physics/record/frame.h"
#include "widgets/print/picture_file.h"
#include "widgets/scene/drawing_forces.h"
#include "widgets/scene/gl_canvas.h"
#include "widgets/scene/paint_drawing.h"

namespace carom {
namespace {

constexpr double kMostZoomOut = 1.0 / 50.0;  // of the scale that shows the whole scene
constexpr double kMostZoomIn = 100.0;
constexpr double kWheelFactor = 1.2;  // a notch of the wheel
constexpr double kKeyFactor = 1.25;
constexpr double kKeyPan = 40.0;     // px
constexpr double kClickSlack = 3.0;  // px around a body that count as a click on it
constexpr int kDots = 2;             // image pixels of a picture, for a px of the window

const QMarginsF& fit_margins() {
  // Room for the window's chips above and the scale bar below.
  static const QMarginsF margins(32.0, 48.0, 32.0, 44.0);
  return margins;
}

bool covers(const Shape& shape, const Vec2& offset, double angle, double slack) {
  return signed_distance(outline_of(shape), Eigen::Rotation2Dd(-angle) * offset) <= slack;
}

}  // namespace

SceneView::SceneView(const Theme& theme, QWidget* parent) : QWidget(parent) {
  picture_.theme = theme;
  uses_opengl_ = qgetenv("CAROM_PAINTER") != "qpainter" && GlCanvas::available();
  if (uses_opengl_) {
    canvas_ = new GlCanvas(picture_, this);
  } else {
    canvas_ = new QPainterCanvas(picture_, this);
  }
  canvas_->lower();
  setMouseTracking(true);
  setFocusPolicy(Qt::StrongFocus);
  setAccessibleName("Scene");
}

void SceneView::set_theme(const Theme& theme) {
  picture_.theme = theme;
  refresh();
}

void SceneView::set_frame(std::shared_ptr<const Frame> frame, OtherRuns others) {
  if (!frame || frame == frame_) return;
  others_ = std::move(others);
  const bool new_run = !frame_ || frame->run != frame_->run;
  frame_ = std::move(frame);
  if (new_run) {
    impacts_.clear();
    peaks_ = {};
  }
  peaks_.observe(*frame_);
  keep_recent(impacts_, frame_->impacts, frame_->time, kImpactShown);
  if (new_run) go_home();
  refresh();
  follow_tip();
}

void SceneView::clear() {
  frame_.reset();
  others_ = {};
  impacts_.clear();
  peaks_ = {};
  refresh();
  follow_tip();
}

void SceneView::set_options(const DrawingOptions& options) {
  options_ = options;
  refresh();
}

void SceneView::set_view(const std::optional<View>& view) {
  view_ = view;
  home_ = true;
  peaks_ = {};
  if (frame_) peaks_.observe(*frame_);
  go_home();
  refresh();
}

void SceneView::fit() {
  view_.reset();
  home_ = true;
  go_home();
  refresh();
}

void SceneView::zoom_in() { zoom(QRectF(rect()).center(), kKeyFactor); }

void SceneView::zoom_out() { zoom(QRectF(rect()).center(), 1.0 / kKeyFactor); }

std::optional<View> SceneView::moved_view() const {
  if (home_) return std::nullopt;
  const Camera& camera = picture_.camera;
  return View{camera.center, camera.viewport.width() / camera.scale};
}

void SceneView::go_home() {
  Camera home = picture_.camera;
  if (view_) {
    home.show(*view_);
  } else if (frame_) {
    home.fit(bounds(*frame_), fit_margins());
  }
  home_scale_ = home.scale;
  home_side_ = std::min(home.viewport.width(), home.viewport.height()) / home.scale;
  if (home_) picture_.camera = home;
}

void SceneView::zoom(const QPointF& at, double factor) {
  home_ = false;
  const double wanted =
      std::clamp(picture_.camera.scale * factor, home_scale_ * kMostZoomOut, home_scale_ * kMostZoomIn);
  picture_.camera.zoom_at(at, wanted / picture_.camera.scale);
  refresh();
}

void SceneView::pan(const QPointF& delta) {
  home_ = false;
  picture_.camera.pan(delta);
  refresh();
}

void SceneView::refresh() {
  if (!isVisible()) return;  // showEvent() does it later
  static const Frame empty;
  picture_.drawing = make_drawing({frame_ ? *frame_ : empty, impacts_, picture_.camera, options_,
                                   picture_.theme, arrow_scale(peaks_, home_side_), others_},
                                  std::move(picture_.drawing));
  canvas_->update();
}

SceneLook SceneView::look() const { return {picture_.camera, home_side_, options_, picture_.theme, peaks_}; }

void SceneView::paint_on_paper(QPainter& painter) const {
  static const Frame empty;
  const Theme& theme = light_theme();
  const Drawing drawing = make_drawing({frame_ ? *frame_ : empty, impacts_, picture_.camera, options_, theme,
                                        arrow_scale(peaks_, home_side_), others_});
  paint_drawing(painter, drawing, picture_.camera, theme);
}

bool SceneView::save(const QString& path, QString* error) const {
  return save_picture(
      path, picture_.camera.viewport.toSize(), [&](QPainter& painter) { paint_on_paper(painter); }, error,
      kDots);
}

QImage SceneView::picture() const {
  QImage image(picture_.camera.viewport.toSize() * kDots, QImage::Format_RGB32);
  image.setDevicePixelRatio(kDots);
  QPainter painter(&image);
  paint_on_paper(painter);
  return image;
}

int SceneView::body_at(const QPointF& position) const {
  if (!frame_ || !frame_->bodies) return -1;
  const Vec2 at = picture_.camera.to_world(position);
  const int count = std::min(frame_->state.size(), static_cast<int>(frame_->bodies->size()));
  // Moving bodies come before fixed ones, as they may be small; of two, the later one is painted on top.
  for (const bool fixed : {false, true}) {
    const double slack = fixed ? 0.0 : kClickSlack / picture_.camera.scale;
    for (int i = count - 1; i >= 0; --i) {
      const Body& body = (*frame_->bodies)[static_cast<std::size_t>(i)];
      if (body.fixed != fixed) continue;
      if (covers(body.shape, at - frame_->state.position(i), frame_->state.q(2, i), slack)) return i;
    }
  }
  return -1;
}

QString SceneView::body_text(int index) const {
  const Body& body = (*frame_->bodies)[static_cast<std::size_t>(index)];
  const Vec2 at = frame_->state.position(index);
  const Vec2 v = frame_->state.velocity(index);
  const auto number = [](double value) { return number_text(value, 4); };
  QString text = QString::fromStdString(body.name).toHtmlEscaped();
  text = "<b>" + text + "</b>" +
         (body.fixed   ? ", fixed"
          : body.drive ? ", driven"
                       : ", " + number(mass_of(body)) + " kg");
  text += QString("<br>position (%1, %2) m").arg(number(at.x()), number(at.y()));
  if (!body.fixed) {
    text += QString("<br>velocity (%1, %2) m/s").arg(number(v.x()), number(v.y()));
    text += QString("<br>spin %1 rad/s").arg(number(frame_->state.v(2, index)));
  }
  int touching = 0;
  Vec2 force = Vec2::Zero();
  for (const ContactForce& contact : frame_->contacts) {
    if (contact.a != index && contact.b != index) continue;
    ++touching;
    force += (contact.b == index ? 1.0 : -1.0) * force_on_b(contact);
  }
  if (touching > 0) {
    text += QString("<br>force of %1 contact%2 (%3, %4) N")
                .arg(touching)
                .arg(touching == 1 ? "" : "s")
                .arg(number(force.x()), number(force.y()));
  }
  return "<div style='white-space: nowrap'>" + text + "</div>";
}

bool SceneView::event(QEvent* event) {
  if (event->type() != QEvent::ToolTip) return QWidget::event(event);
  const auto* help = static_cast<QHelpEvent*>(event);
  tip_body_ = body_at(help->pos());
  tip_at_ = help->pos();
  if (tip_body_ >= 0) {
    QToolTip::showText(help->globalPos(), body_text(tip_body_), this);
  } else {
    QToolTip::hideText();
  }
  return true;
}

void SceneView::follow_tip() {
  if (tip_body_ < 0) return;
  const bool shown = QToolTip::isVisible() && underMouse();
  if (shown && body_at(tip_at_) == tip_body_) {
    QToolTip::showText(mapToGlobal(tip_at_), body_text(tip_body_), this);
  } else {
    if (shown) QToolTip::hideText();
    tip_body_ = -1;
  }
}

void SceneView::resizeEvent(QResizeEvent*) {
  canvas_->setGeometry(rect());
  picture_.camera.viewport = size();
  go_home();
  refresh();
}

void SceneView::showEvent(QShowEvent*) { refresh(); }

void SceneView::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton && event->button() != Qt::MiddleButton) {
    event->ignore();
    return;
  }
  press_ = event->button() == Qt::LeftButton ? Press::kClick : Press::kMute;
  press_at_ = last_at_ = event->position();
}

void SceneView::mouseMoveEvent(QMouseEvent* event) {
  const QPointF at = event->position();
  if (press_ != Press::kNone && press_ != Press::kPan &&
      (at - press_at_).manhattanLength() >= QGuiApplication::styleHints()->startDragDistance()) {
    press_ = Press::kPan;
    setCursor(Qt::ClosedHandCursor);
  }
  if (press_ == Press::kPan) {
    pan(at - last_at_);
    last_at_ = at;
  }
  const Vec2 world = picture_.camera.to_world(at);
  emit cursorMoved(world.x(), world.y());
}

void SceneView::mouseReleaseEvent(QMouseEvent* event) {
  const Press press = std::exchange(press_, Press::kNone);
  unsetCursor();
  if (press != Press::kClick) return;
  const int body = body_at(event->position());
  const Vec2 world = picture_.camera.to_world(event->position());
  if (body >= 0) {
    emit bodyClicked(body);
  } else {
    emit spawnRequested(world.x(), world.y());
  }
}

// The second click of a double click would hit the body added by the first.
void SceneView::mouseDoubleClickEvent(QMouseEvent* event) {
  mousePressEvent(event);
  if (press_ == Press::kClick) press_ = Press::kMute;
}

void SceneView::wheelEvent(QWheelEvent* event) {
  const double notches = event->angleDelta().y() / 120.0;
  if (notches != 0.0) zoom(event->position(), std::pow(kWheelFactor, notches));
  event->accept();
}

void SceneView::keyPressEvent(QKeyEvent* event) {
  switch (event->key()) {
    case Qt::Key_F:
    case Qt::Key_Home:
      return fit();
    case Qt::Key_Plus:
    case Qt::Key_Equal:
      return zoom_in();
    case Qt::Key_Minus:
      return zoom_out();
    case Qt::Key_Left:
      return pan({kKeyPan, 0.0});
    case Qt::Key_Right:
      return pan({-kKeyPan, 0.0});
    case Qt::Key_Up:
      return pan({0.0, kKeyPan});
    case Qt::Key_Down:
      return pan({0.0, -kKeyPan});
    default:
      QWidget::keyPressEvent(event);
  }
}

void SceneView::leaveEvent(QEvent*) { emit cursorLeft(); }

void SceneView::focusInEvent(QFocusEvent* event) {
  picture_.focus_frame = event->reason() == Qt::TabFocusReason || event->reason() == Qt::BacktabFocusReason;
  canvas_->update();
}

void SceneView::focusOutEvent(QFocusEvent*) {
  picture_.focus_frame = false;
  canvas_->update();
}

}  // namespace carom
