#pragma once

#include <QImage>
#include <QPoint>
#include <QWidget>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "physics/preset/preset.h"
#include "physics/record/frame.h"
#include "widgets/scene/drawing.h"
#include "widgets/scene/follow.h"
#include "widgets/scene/qpainter_canvas.h"
#include "widgets/scene/scale_row.h"
#include "widgets/scene/scene_accessible.h"
#include "widgets/scene/scene_export.h"
#include "widgets/scene/scene_tip.h"
#include "widgets/scene/scene_tools.h"

namespace carom {

class Loupe;
class ValueBubble;

// Shows the frames of a run, zooms and pans, and lets tools select and edit bodies (scene_tools.h). It changes
// nothing itself; signals tell what is wanted. Painted by OpenGL, or by QPainter where OpenGL is not available
// or the environment sets CAROM_PAINTER=qpainter.
class SceneView : public QWidget {
  Q_OBJECT

 public:
  explicit SceneView(const Theme& theme, QWidget* parent = nullptr);

  void set_theme(const Theme& theme);
  // Shows a frame, with other runs beside it.
  void set_frame(std::shared_ptr<const Frame> frame, OtherRuns others = {});
  // Where the bodies of the run before stood then; shown with the next frame.
  void set_before(std::optional<PlacedBodies> before) { before_ = std::move(before); }
  // The impact (s) whose velocities before and after, and impulse, are shown while its moment is.
  void set_picked(std::optional<double> impact);
  // Shows nothing until the next frame.
  void clear();
  // What is shown is of a scene that is gone: until the next frame the tools have none.
  void await_scene();
  void set_options(const DrawingOptions& options);
  [[nodiscard]] const DrawingOptions& options() const { return options_; }
  // Starts a new scene: with its own view, or fitted to all its bodies. Resets the scales of the arrows.
  void set_view(const std::optional<View>& view);
  // The current view, if the user has moved the camera.
  [[nodiscard]] std::optional<View> moved_view() const;
  // Fits all bodies with a margin, and repeats this at each new size and run until the user zooms or pans.
  void fit();
  // The key F: follows what has left the view, where that is offered, and ends it; else shows the scene's own
  // view, and all bodies where that is shown already.
  void find();
  // Shows the selected bodies and as much again around them.
  void show_selected();
  // Keeps the bodies that move in view, until the user moves the camera.
  void follow();
  [[nodiscard]] bool follows() const { return follow_.on(); }
  // The shown picture on white: to a file (see save_picture()), and for the clipboard.
  [[nodiscard]] bool save(const QString& path, QString* error) const;
  [[nodiscard]] QImage picture() const;
  // The look as shown, in the window's own colours.
  [[nodiscard]] SceneLook look() const;
  void zoom_in();
  void zoom_out();

  [[nodiscard]] bool uses_opengl() const { return uses_opengl_; }
  // What is shown; nullptr: nothing.
  [[nodiscard]] const Frame* frame() const { return frame_.get(); }
  // On which it is painted.
  [[nodiscard]] const QWidget* canvas() const { return canvas_; }
  [[nodiscard]] const Camera& camera() const { return picture_.camera; }
  [[nodiscard]] const Drawing& drawing() const { return picture_.drawing; }

  // The selected bodies, by name; those that vanish drop out.
  [[nodiscard]] const std::vector<std::string>& selection() const { return tools_->selection(); }
  void select(const std::vector<std::string>& names) { tools_->select(names); }
  void select_when_shown(const std::vector<std::string>& names) { tools_->select_when_shown(names); }
  // The chosen joint, spring or force; no body is selected then.
  [[nodiscard]] const std::optional<PartId>& part() const { return tools_->part(); }
  void choose_part(const std::optional<PartId>& part) { tools_->choose(part); }
  // Shows where the bodies will first meet.
  void set_aim(std::optional<Aim> aim);
  [[nodiscard]] const std::optional<Aim>& aim() const { return aim_; }
  [[nodiscard]] SceneTool tool() const { return tools_->tool(); }
  // After one use it is kSelect again, unless it is kept.
  void set_tool(SceneTool tool, bool keep = false) { tools_->set_tool(tool, keep); }
  [[nodiscard]] bool tool_kept() const { return tools_->tool_kept(); }
  void set_snapping(bool on);
  [[nodiscard]] bool is_dragging() const { return tools_->dragging(); }
  void set_keeps(Keeps keeps) { tools_->set_keeps(keeps); }
  // A magnifier at the mouse (loupe.h); the key Y shows it while it is held.
  void set_loupe(bool on);

  [[nodiscard]] QSize sizeHint() const override { return {640, 460}; }
  [[nodiscard]] QSize minimumSizeHint() const override { return {160, 120}; }

  // A key of the tools, pressed by other means; whether it means anything now.
  void press_key(int key, Qt::KeyboardModifiers keys = {}) { tools_->press_key(key, keys); }
  [[nodiscard]] bool takes(int key, Qt::KeyboardModifiers keys = {}) const { return tools_->takes(key, keys); }
  // The handles, for readers; to type the value of one; the one that a press there takes.
  [[nodiscard]] std::vector<SceneTools::ToldHandle> told_handles() const { return tools_->told_handles(); }
  void type_handle(std::size_t index) { tools_->type_handle(index); }
  [[nodiscard]] std::optional<std::size_t> handle_under(const QPointF& at) const {
    return tools_->handle_under(at);
  }
  // What a click of the tool draws, at a place of the widget.
  void draw_at(SceneTool tool, const QPointF& at) { tools_->draw_at(tool, at); }
  // Puts the selected bodies in line; there must be several that can be moved.
  void align(Alignment alignment) { tools_->align(alignment); }
  [[nodiscard]] bool can_align() const { return tools_->can_align(); }
  // The scene was edited by other means: what the bubble says is over.
  void scene_edited() { tools_->scene_edited(); }
  // From now on arrows keep the scale that they have, also in another start; that of a force which is added
  // too.
  void hold_arrows(const SceneEdits& edits = {});
  // Says beside the mouse why an edit could not be, if it is one of the view that is being told.
  bool refuse(const QString& sentence) { return tools_->refuse(sentence); }
  // What stands beside the mouse; empty: nothing.
  [[nodiscard]] const Bubble& bubble() const { return picture_.overlay.bubble; }
  // Whether all selected bodies are locked.
  [[nodiscard]] bool all_locked() const { return tools_->all_locked(); }
  // To screen readers (scene_accessible.h), as the view's description: the moment, or a value that was changed.
  void say(const QString& text);

 signals:
  void selectionChanged(const std::vector<std::string>& names);
  void partChosen();               // part() is another one
  void impactChosen(double time);  // s, by its mark
  // For what is selected or chosen, else for the empty space at this place of the widget.
  void menuRequested(const QPoint& at);
  void renameRequested();  // of the selected body
  // What the user wants changed, as it stands now: a drag, or a row of keys, tells each change under the same
  // number, and all of them are one step of undo.
  void edited(const carom::SceneEdits& edits, const QString& name, int drag);
  // A drag of a body or handle begins, before its first edit, or is over.
  void dragChanged(bool drags);
  // Takes back all that was told under this number.
  void dragCancelled(int drag);
  void toolChanged(carom::SceneTool tool, bool kept);
  void pauseRequested();                    // to edit by key
  void spawnRequested(double x, double y);  // m
  // A body of a run that plays is pulled, from this hand; it is let go, after it was pulled.
  void pulled(const carom::Hand& hand);
  void letGo();
  void cursorMoved(double x, double y);  // m
  void cursorLeft();
  void hintChanged(const QString& hint);  // what the mouse can do where it is; empty: nothing is told
  // All bodies that move left the view a while ago, so that follow() would find them; or no more.
  void followOffered(bool offered);

 protected:
  bool event(QEvent* event) override;
  bool focusNextPrevChild(bool next) override;
  void resizeEvent(QResizeEvent* event) override;
  void showEvent(QShowEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void keyReleaseEvent(QKeyEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;

 private:
  enum class Press { kNone, kTool, kMayPan, kPan };

  void end_follow();
  void tell_follow();
  [[nodiscard]] QPoint place_of_menu() const;
  void go_home();  // moves the camera to the scene's view, unless the user has moved it
  void zoom(const QPointF& at, double factor);
  void pan(const QPointF& delta);
  [[nodiscard]] DrawingInput shown(const Theme& theme, const Camera& camera) const;
  [[nodiscard]] const JumpMoment* picked_jump() const;
  void paint_on_paper(QPainter& painter) const;
  void refresh();
  void refresh_tools();
  void release_arrows();
  [[nodiscard]] ArrowScale arrows() const;
  [[nodiscard]] ArrowScale usual_arrows() const;  // before the user's own lengths
  void hold_speeds(const Peaks& before);
  [[nodiscard]] std::optional<ScaleKind> scale_under(const QPointF& at) const;
  bool change_scale(const QPointF& at, bool halve);  // false: there is none
  [[nodiscard]] bool shows_forces() const;
  [[nodiscard]] SceneSight sight() const;
  void show_typing(const QString& first);
  void show_focus(bool shown);
  void place_typing();
  [[nodiscard]] Obstacles around_bubble() const;          // what it stands clear of
  [[nodiscard]] bool on_bubble(const QPointF& at) const;  // whose value a click edits
  void show_cursor(const QPointF& at);
  void hold_loupe(bool on);
  void place_loupe();
  void say_bubble();

  Picture picture_;
  DrawingOptions options_;
  std::shared_ptr<const Frame> frame_;
  OtherRuns others_;
  std::optional<PlacedBodies> before_;
  std::optional<double> picked_;       // s
  std::vector<ImpactRecord> impacts_;  // recent ones, in the order of time
  Peaks peaks_;
  std::optional<View> view_;
  bool fits_all_ = false;  // although there is a view
  Follow follow_;
  bool follow_offered_ = false;
  bool home_ = true;           // the user has not moved the camera
  double home_scale_ = 100.0;  // px/m when nothing is zoomed
  double home_side_ = 4.0;     // m, the shorter side of the view then
  bool uses_opengl_ = false;
  QWidget* canvas_ = nullptr;
  SceneTools* tools_ = nullptr;
  ValueBubble* typing_ = nullptr;
  Loupe* loupe_ = nullptr;
  bool loupe_on_ = false;
  bool loupe_held_ = false;  // by its key
  std::optional<Aim> aim_;
  std::optional<ArrowScale> held_arrows_;  // since an edit, so that what was drawn keeps its length
  std::optional<double> run_seconds_;      // m of arrow per m/s, while a run lasts
  ArrowTimes times_;
  bool drags_ = false;        // told
  bool held_camera_ = false;  // the scene was edited, so a new run starts where the user looks

  Press press_ = Press::kNone;
  Qt::MouseButton button_ = Qt::NoButton;
  bool awaits_ = false;       // see await_scene()
  bool was_pressed_ = false;  // in this scene: a double click is none if the first press was elsewhere
  QPointF press_at_;
  QPointF last_at_;
  QString hint_;
  SpokenBody spoken_body_;
  QString said_bubble_;
  SceneTip tip_{this};
};

}  // namespace carom
