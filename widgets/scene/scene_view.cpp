#include "widgets/scene/scene_view.h"

#include <QApplication>
#include <QCursor>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <utility>

#include "widgets/print/picture_file.h"
#include "widgets/scene/gl_canvas.h"
#include "widgets/scene/loupe.h"
#include "widgets/scene/paint_drawing.h"
#include "widgets/scene/scene_parts.h"
#include "widgets/scene/value_bubble.h"

namespace carom {
namespace {

constexpr double kMostZoomOut = 1.0 / 50.0;  // of the scale that shows the whole scene
constexpr double kMostZoomIn = 100.0;
constexpr double kWheelFactor = 1.2;  // a notch of the wheel
constexpr double kKeyFactor = 1.25;
constexpr double kKeyPan = 40.0;  // px
constexpr int kDots = 2;          // image pixels of a picture, for a px of the window

const QMarginsF& fit_margins() {
  // Room for the window's chips above and the scale bar below.
  static const QMarginsF margins(32.0, 48.0, 32.0, 44.0);
  return margins;
}

}  // namespace

SceneView::SceneView(const Theme& theme, QWidget* parent) : QWidget(parent) {
  QAccessible::installFactory(&SceneAccessible::make);  // first: what is asked for earlier is kept
  picture_.theme = theme;
  uses_opengl_ = qgetenv("CAROM_PAINTER") != "qpainter" && GlCanvas::available();
  if (uses_opengl_) {
    canvas_ = new GlCanvas(picture_, this);
  } else {
    canvas_ = new QPainterCanvas(picture_, this);
  }
  canvas_->lower();
  tools_ = new SceneTools([this] { return sight(); }, this);
  connect(tools_, &SceneTools::selectionChanged, this, [this](const std::vector<std::string>& names) {
    refresh();  // names make room for handles, and selected bodies keep their arrows beside an impact
    const auto news = spoken_body_.selected(frame_.get(), names);
    QAccessibleEvent handles(this, QAccessible::ObjectReorder);
    QAccessible::updateAccessibility(&handles);
    if (hasFocus()) tell(*this, news);
    emit selectionChanged(names);
  });
  connect(tools_, &SceneTools::partChosen, this, &SceneView::partChosen);
  connect(tools_, &SceneTools::impactChosen, this, &SceneView::impactChosen);
  connect(tools_, &SceneTools::edited, this, [this](const SceneEdits& edits, const QString& name, int drag) {
    held_camera_ = true;
    hold_arrows(edits);
    emit edited(edits, name, drag);
  });
  connect(tools_, &SceneTools::dragCancelled, this, &SceneView::dragCancelled);
  connect(tools_, &SceneTools::renameRequested, this, &SceneView::renameRequested);
  connect(tools_, &SceneTools::toolChanged, this, &SceneView::toolChanged);
  connect(tools_, &SceneTools::pauseRequested, this, &SceneView::pauseRequested);
  connect(tools_, &SceneTools::spawnRequested, this, &SceneView::spawnRequested);
  connect(tools_, &SceneTools::pulled, this, &SceneView::pulled);
  connect(tools_, &SceneTools::letGo, this, &SceneView::letGo);
  connect(tools_, &SceneTools::changed, this, &SceneView::refresh_tools);
  typing_ = new ValueBubble(
      [this](const QString& text, bool yields) { return tools_->take_typed(text, yields); }, this);
  connect(tools_, &SceneTools::typingBegan, this, &SceneView::show_typing);
  connect(tools_, &SceneTools::typingEnded, this, [this] {
    // First: a hidden field would hand the focus to the next widget.
    if (typing_->isAncestorOf(QApplication::focusWidget())) setFocus(Qt::OtherFocusReason);
    typing_->end();
  });
  connect(typing_, &ValueBubble::resized, this, &SceneView::place_typing);
  connect(&typing_->field(), &QLineEdit::textEdited, tools_, [this](const QString& text) {
    tools_->preview_typed(text);
    if (const auto typed = tools_->typed()) typing_->show_detail(typed->bubble.detail);
  });
  connect(&typing_->field(), &ValueField::nextAsked, tools_, &SceneTools::type_next);
  connect(&typing_->field(), &ValueField::finished, tools_, &SceneTools::end_typing);
  connect(&typing_->field(), &ValueField::cancelled, tools_, &SceneTools::cancel_typing);
  loupe_ =
      new Loupe([this](const Camera& camera) { return make_drawing(shown(picture_.theme, camera)); }, this);
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
  awaits_ = false;
  if (new_run || frame_->impacts_of_late) impacts_.clear();
  if (frame_->back_to)
    std::erase_if(impacts_, [&](const ImpactRecord& impact) { return impact.time > *frame_->back_to; });
  if (new_run) {
    peaks_ = {};
    run_seconds_.reset();
  }
  const Peaks before = peaks_;
  peaks_.observe(*frame_);
  hold_speeds(before);
  keep_recent(impacts_, frame_->impacts, frame_->time, kImpactShown);
  tools_->frame_changed();
  if (new_run && !held_camera_) go_home();
  if (follow_.on()) Follow::show_moving(*frame_, picture_.camera, fit_margins());
  follow_.observe(*frame_, picture_.camera);
  tell_follow();
  refresh();
  tip_.follow(sight());
  tell(*this, spoken_body_.shown(frame_.get(), selection()));
}

void SceneView::set_picked(std::optional<double> impact) {
  if (std::exchange(picked_, impact) != impact) refresh();
}

void SceneView::clear() {
  frame_.reset();
  others_ = {};
  before_.reset();
  impacts_.clear();
  peaks_ = {};
  tools_->frame_changed();
  refresh();
  tip_.follow(sight());
}

void SceneView::await_scene() {
  awaits_ = true;
  tools_->frame_changed();
}

void SceneView::set_options(const DrawingOptions& options) {
  options_ = options;
  refresh();
}

void SceneView::set_view(const std::optional<View>& view) {
  view_ = view;
  fits_all_ = false;
  end_follow();
  home_ = true;
  was_pressed_ = false;
  held_camera_ = false;
  held_arrows_.reset();
  run_seconds_.reset();
  times_ = {};
  peaks_ = {};
  tools_->drop_draft();
  tools_->unlock_all();
  if (frame_) peaks_.observe(*frame_);
  go_home();
  refresh();
}

void SceneView::find() {
  if (follow_.offered()) return follow();
  const bool at_view = home_ && !fits_all_;
  if (!view_ || (at_view && !follow_.on())) return fit();
  end_follow();
  fits_all_ = false;
  home_ = true;
  held_camera_ = false;
  go_home();
  refresh();
}

void SceneView::follow() {
  if (!frame_) return;
  home_ = false;
  follow_.begin();
  tell_follow();
  Follow::show_moving(*frame_, picture_.camera, fit_margins());
  refresh();
}

void SceneView::end_follow() {
  follow_.end();
  tell_follow();
}

void SceneView::tell_follow() {
  if (std::exchange(follow_offered_, follow_.offered()) != follow_.offered())
    emit followOffered(follow_offered_);
}

void SceneView::fit() {
  fits_all_ = true;
  end_follow();
  home_ = true;
  held_camera_ = false;
  go_home();
  refresh();
}

void SceneView::show_selected() {
  WorldRect rect = frame_ ? bounds(*frame_, selection()) : WorldRect{};
  if (rect.empty()) return;
  constexpr double kLeastShare = 0.05;  // of the view, for what is very small
  const Vec2 centre = 0.5 * (rect.lower + rect.upper);
  rect.include(centre, (rect.upper - rect.lower).cwiseMax(kLeastShare * home_side_));
  Camera camera = picture_.camera;
  camera.fit(rect, fit_margins());
  picture_.camera.center = camera.center;
  zoom(QRectF(this->rect()).center(), camera.scale / picture_.camera.scale);
}

void SceneView::zoom_in() { zoom(QRectF(rect()).center(), kKeyFactor); }

void SceneView::zoom_out() { zoom(QRectF(rect()).center(), 1.0 / kKeyFactor); }

std::optional<View> SceneView::moved_view() const {
  if (home_) return std::nullopt;
  const Camera& camera = picture_.camera;
  return View{camera.center, camera.viewport.width() / camera.scale, camera.viewport.height() / camera.scale};
}

void SceneView::go_home() {
  Camera home = picture_.camera;
  if (view_ && !fits_all_) {
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
  end_follow();
  const double wanted =
      std::clamp(picture_.camera.scale * factor, home_scale_ * kMostZoomOut, home_scale_ * kMostZoomIn);
  picture_.camera.zoom_at(at, wanted / picture_.camera.scale);
  refresh();
}

void SceneView::pan(const QPointF& delta) {
  home_ = false;
  end_follow();
  picture_.camera.pan(delta);
  refresh();
}

void SceneView::refresh() {
  release_arrows();
  if (!isVisible()) return;  // showEvent() does it later
  picture_.drawing = make_drawing(shown(picture_.theme, picture_.camera), std::move(picture_.drawing));
  refresh_tools();
}

void SceneView::refresh_tools() {
  if (std::exchange(drags_, tools_->dragging()) != tools_->dragging()) emit dragChanged(drags_);
  picture_.overlay = tools_->overlay();
  picture_.overlay.aim = aim_;
  if (!picture_.overlay.bubble.value.isEmpty()) picture_.overlay.bubble.clear_of = around_bubble();
  if (press_ != Press::kPan) show_cursor(last_at_);
  canvas_->update();
  place_loupe();
  say_bubble();
}

void SceneView::set_loupe(bool on) {
  loupe_on_ = on;
  place_loupe();
}

void SceneView::hold_loupe(bool on) {
  loupe_held_ = on;
  place_loupe();
}

// At the mouse, and where there is none at what is selected.
void SceneView::place_loupe() {
  if (!loupe_on_ && !loupe_held_) return loupe_->hide();
  const QPoint mouse = mapFromGlobal(QCursor::pos());
  loupe_->show_at(rect().contains(mouse) ? mouse : place_of_menu(), picture_.camera, picture_.theme);
}

void SceneView::show_cursor(const QPointF& at) {
  if (QString hint = tools_->hint(at); hint != hint_) emit hintChanged(hint_ = std::move(hint));
  if (press_ == Press::kNone && on_bubble(at)) return setCursor(Qt::IBeamCursor);
  setCursor(press_ == Press::kNone && scale_under(at) ? Qt::PointingHandCursor : tools_->cursor(at));
}

void SceneView::set_snapping(bool on) {
  tools_->set_snapping(on);
  refresh_tools();
}

void SceneView::set_aim(std::optional<Aim> aim) {
  if (!aim && !aim_) return;
  aim_ = std::move(aim);
  refresh_tools();
}

SceneSight SceneView::sight() const {
  const ArrowScale scale = arrows();
  return {.frame = awaits_ ? nullptr : frame_,
          .camera = picture_.camera,
          .arrow_seconds = scale.seconds,
          .metres_per_newton = scale.metres_per_newton,
          .grid = options_.grid,
          .velocities = options_.velocities,
          .forces_shown = shows_forces(),
          .marks = picture_.drawing.marks,
          .kept = tools_->kept_overlaps()};
}

SceneLook SceneView::look() const {
  return {picture_.camera, home_side_, options_, picture_.theme, peaks_, times_};
}

DrawingInput SceneView::shown(const Theme& theme, const Camera& camera) const {
  static const Frame empty;
  return {frame_ ? *frame_ : empty,
          impacts_,
          camera,
          options_,
          theme,
          arrows(),
          others_,
          picked_jump(),
          selection(),
          before_ ? &*before_ : nullptr};
}

const JumpMoment* SceneView::picked_jump() const {
  if (!frame_ || !picked_ || frame_->playing) return nullptr;
  const auto found = std::find_if(frame_->jumps.begin(), frame_->jumps.end(),
                                  [this](const auto& jump) { return jump->time() == *picked_; });
  return found == frame_->jumps.end() ? nullptr : found->get();
}

void SceneView::paint_on_paper(QPainter& painter) const {
  const Theme& theme = light_theme();
  DrawingInput input = shown(theme, picture_.camera);
  input.selected = {};
  paint_drawing(painter, make_drawing(input), picture_.camera, theme);
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

bool SceneView::event(QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride) {
    // The tools' keys come before the window's.
    const auto* key = static_cast<QKeyEvent*>(event);
    if (tools_->takes(key->key(), key->modifiers() & ~Qt::KeypadModifier)) event->accept();
  }
  if (event->type() != QEvent::ToolTip) return QWidget::event(event);
  const auto& help = *static_cast<QHelpEvent*>(event);
  if (const auto scale = press_ == Press::kNone ? scale_under(help.pos()) : std::nullopt) {
    QToolTip::showText(help.globalPos(), scale_tip(*scale), this);
  } else {
    tip_.show(help, sight(), press_ != Press::kNone);
  }
  return true;
}

void SceneView::resizeEvent(QResizeEvent*) {
  canvas_->setGeometry(rect());
  picture_.camera.viewport = size();
  go_home();
  refresh();
}

void SceneView::showEvent(QShowEvent*) { refresh(); }

void SceneView::mousePressEvent(QMouseEvent* event) {
  if (press_ != Press::kNone) return;  // another button holds the mouse
  if (event->button() == Qt::LeftButton && on_bubble(event->position()) && tools_->type_noted()) return;
  const bool shift = event->modifiers().testFlag(Qt::ShiftModifier);
  if (event->button() == Qt::LeftButton && change_scale(event->position(), shift)) return;
  show_focus(false);
  button_ = event->button();
  press_at_ = last_at_ = event->position();
  if (button_ == Qt::LeftButton) {
    press_ = Press::kTool;
    tools_->press(press_at_, event->type() == QEvent::MouseButtonDblClick && was_pressed_);
    was_pressed_ = true;
  } else if (button_ == Qt::MiddleButton || button_ == Qt::RightButton) {
    press_ = Press::kMayPan;
  } else {
    event->ignore();
  }
}

void SceneView::mouseMoveEvent(QMouseEvent* event) {
  const QPointF at = event->position();
  if (press_ == Press::kMayPan && (at - press_at_).manhattanLength() >= kDragBegins) {
    press_ = Press::kPan;
    setCursor(Qt::ClosedHandCursor);
  }
  last_at_ = at;
  if (press_ == Press::kPan) {
    pan(at - std::exchange(press_at_, at));
  } else if (press_ == Press::kTool) {
    tools_->move(at, event->modifiers());
  } else {
    tools_->hover(at, event->modifiers());
    show_cursor(at);
  }
  place_loupe();
  const Vec2 world = picture_.camera.to_world(at);
  emit cursorMoved(world.x(), world.y());
}

void SceneView::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() != button_) return;
  button_ = Qt::NoButton;
  const Press press = std::exchange(press_, Press::kNone);
  if (press == Press::kTool) {
    tools_->release(event->position(), event->modifiers());
    refresh();
  } else if (press == Press::kMayPan && event->button() == Qt::RightButton) {
    tools_->pick(event->position());
    emit menuRequested(event->position().toPoint());
  } else {
    show_cursor(event->position());
  }
}

void SceneView::mouseDoubleClickEvent(QMouseEvent* event) { mousePressEvent(event); }

void SceneView::wheelEvent(QWheelEvent* event) {
  const double notches = event->angleDelta().y() / 120.0;
  if (notches != 0.0) zoom(event->position(), std::pow(kWheelFactor, notches));
  event->accept();
}

void SceneView::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Shift || event->key() == Qt::Key_Control) tools_->hold_keys(event->modifiers());
  if (tools_->press_key(event->key(), event->modifiers() & ~Qt::KeypadModifier)) return;
  if (event->key() == Qt::Key_F10 && event->modifiers() == Qt::ShiftModifier) {
    emit menuRequested(place_of_menu());
    return;
  }
  if (event->key() == Qt::Key_Y && event->modifiers() == Qt::NoModifier) return hold_loupe(true);
  switch (event->key()) {
    case Qt::Key_F:
      return find();
    case Qt::Key_Menu:
      emit menuRequested(place_of_menu());
      return;
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

void SceneView::keyReleaseEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Shift || event->key() == Qt::Key_Control) tools_->hold_keys(event->modifiers());
  if (event->key() == Qt::Key_Y && !event->isAutoRepeat()) hold_loupe(false);
  QWidget::keyReleaseEvent(event);
}

// By a key: at what is selected or chosen, else at the mouse, else in the middle.
QPoint SceneView::place_of_menu() const {
  constexpr int kEdge = 8;  // px
  WorldRect rect;
  if (frame_ && frame_->bodies) {
    const std::vector<Body>& bodies = *frame_->bodies;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      const auto& names = selection();
      if (std::find(names.begin(), names.end(), bodies[i].name) != names.end())
        rect.include(frame_->state.position(static_cast<int>(i)), Vec2::Zero());
    }
    if (const auto line = part() ? line_of(*frame_, *part(), arrows().metres_per_newton) : std::nullopt) {
      rect.include(line->from, Vec2::Zero());
      rect.include(line->to, Vec2::Zero());
    }
  }
  const QRect inner = this->rect().adjusted(kEdge, kEdge, -kEdge, -kEdge);
  if (rect.empty()) {
    const QPoint mouse = mapFromGlobal(QCursor::pos());
    return inner.contains(mouse) ? mouse : inner.center();
  }
  const QPoint at = picture_.camera.to_screen((rect.lower + rect.upper) / 2).toPoint();
  return {std::clamp(at.x(), inner.left(), inner.right()), std::clamp(at.y(), inner.top(), inner.bottom())};
}

bool SceneView::focusNextPrevChild(bool next) {
  return tools_->select_next(next) || QWidget::focusNextPrevChild(next);
}

void SceneView::leaveEvent(QEvent*) {
  tools_->leave();
  show_cursor(last_at_);
  emit cursorLeft();
}

void SceneView::focusInEvent(QFocusEvent* event) {
  constexpr auto kByKeys = std::to_array({Qt::TabFocusReason, Qt::BacktabFocusReason, Qt::ShortcutFocusReason});
  show_focus(std::find(kByKeys.begin(), kByKeys.end(), event->reason()) != kByKeys.end());
}

void SceneView::focusOutEvent(QFocusEvent*) {
  hold_loupe(false);
  show_focus(false);
}

// With a frame, unless the mouse is what is used.
void SceneView::show_focus(bool shown) {
  if (std::exchange(picture_.focus_frame, shown) != shown) canvas_->update();
}

}  // namespace carom
