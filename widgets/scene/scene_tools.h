#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QPointF>
#include <QString>
#include <QTimer>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

#include "physics/record/frame.h"
#include "physics/scene/edit.h"
#include "physics/scene/part_id.h"
#include "widgets/scene/align.h"
#include "widgets/scene/bubble.h"
#include "widgets/scene/camera.h"
#include "widgets/scene/drag.h"
#include "widgets/scene/joint_tools.h"
#include "widgets/scene/key_edits.h"
#include "widgets/scene/overlay.h"
#include "widgets/scene/part_ends.h"
#include "widgets/scene/polygon_draft.h"
#include "widgets/scene/scene_parts.h"
#include "widgets/scene/selection.h"
#include "widgets/scene/shape_tools.h"

namespace carom {

class TypedDrawing;
class TypedThing;

// px: a press that moves no farther is a click.
inline constexpr double kDragBegins = 4.0;

// What the tools need to know of the view.
struct SceneSight {
  std::shared_ptr<const Frame> frame;
  Camera camera;
  double arrow_seconds = 0.1;             // m of arrow per m/s
  double metres_per_newton = 0.1;         // of arrow
  bool grid = true;                       // is drawn
  bool velocities = true;                 // are drawn
  bool forces_shown = false;              // so that the scale of their arrows is one to keep to
  std::span<const ImpactRecord> marks{};  // of impacts
  std::span<const Overlap> kept{};        // overlaps that have a sign
};

// Draws, selects and edits bodies by mouse and keys. It changes nothing itself: signals say what is wanted, and
// the frames that follow show it. Handles exist only while the frame has a scene, that is, while the run is
// paused.
class SceneTools : public QObject {
  Q_OBJECT

 public:
  explicit SceneTools(std::function<SceneSight()> sight, QObject* parent = nullptr);

  [[nodiscard]] const std::vector<std::string>& selection() const { return selection_.names(); }
  // Now, or once a frame shows them.
  void select(const std::vector<std::string>& names);
  // Once the next frame has shown them, unless others are selected before; keys that edit the selection wait.
  void select_when_shown(const std::vector<std::string>& names) { awaited_ = names; }
  // The chosen joint, spring or force; no body is selected then.
  [[nodiscard]] const std::optional<PartId>& part() const { return part_; }
  void choose(const std::optional<PartId>& part);
  // The next or previous body, beside those that stay selected (Ctrl+Space); false after the last one.
  bool select_next(bool forward);
  [[nodiscard]] SceneTool tool() const { return tool_; }
  // After one use it is kSelect again, unless it is kept.
  void set_tool(SceneTool tool, bool keep);
  [[nodiscard]] bool tool_kept() const { return keep_tool_; }
  // Whether what is dragged or drawn snaps, and arrow keys move by the grid; while Ctrl is down nothing snaps.
  void set_snapping(bool on) { snapping_ = on; }
  // As bodies get another size.
  void set_keeps(Keeps keeps) { keeps_ = keeps; }
  // Locked bodies are changed neither by the mouse nor by keys.
  [[nodiscard]] bool all_locked() const;  // the selected ones
  void unlock_all();
  // Forgets the corners of a polygon that is not closed yet, and the first end of a link.
  void drop_draft();

  // The frame of the sight is another one.
  void frame_changed();
  // A drag of a body, a handle or an end is going on.
  [[nodiscard]] bool dragging() const { return state_ == State::kDrag || state_ == State::kEnd; }

  // The overlaps that the start of the run has, which its first steps will part.
  [[nodiscard]] std::span<const Overlap> kept_overlaps() const { return kept_; }

  // Puts the selected bodies in line. Joints to others give way; overlaps stay, and the deepest
  // one is said.
  void align(Alignment alignment);
  [[nodiscard]] bool can_align() const;
  // A right click: selects the body, or chooses the part, that is there, unless it is already; over empty space
  // selects nothing.
  void pick(const QPointF& at);
  // What a click of the tool draws there.
  void draw_at(SceneTool tool, const QPointF& at);
  // The left button. The second press of a double click is `repeated`.
  void press(const QPointF& at, bool repeated);
  void move(const QPointF& at, Qt::KeyboardModifiers keys);
  void release(const QPointF& at, Qt::KeyboardModifiers keys);
  // The mouse moves without a button; it leaves the scene.
  void hover(const QPointF& at, Qt::KeyboardModifiers keys);
  void leave();
  // Shift or Ctrl went up or down while the mouse stood still.
  void hold_keys(Qt::KeyboardModifiers keys);
  // False if the key means nothing here now; `takes` asks without doing it. What edits the selection of a run
  // that plays asks for a pause, and is done then.
  bool press_key(int key, Qt::KeyboardModifiers keys);
  [[nodiscard]] bool takes(int key, Qt::KeyboardModifiers keys) const;

  // A value that is typed at the mouse.
  struct Typed {
    QString name;     // "Speed"
    QString subject;  // "light"
    QString unit;
    QString text;
    Bubble bubble;  // where it stands, and what it says under the value
  };
  [[nodiscard]] std::optional<Typed> typed() const;
  // Whether a click on the bubble edits its value, and the click.
  [[nodiscard]] bool can_type_noted() const { return note_of_.has_value(); }
  // False if it has no value to type; `first` is typed already.
  bool type_noted(const QString& first = {});
  // Takes the text of the typed value, or returns one sentence on why it can't; `yields` as with Ctrl.
  [[nodiscard]] QString take_typed(const QString& text, bool yields);
  // The handles around the selected bodies, for readers.
  struct ToldHandle {
    QPointF at;     // px
    QString name;   // "Speed and direction of light", "Width of A, at its right"
    QString value;  // "2 m/s, 30°"
  };
  [[nodiscard]] std::vector<ToldHandle> told_handles() const;
  void type_handle(std::size_t index);  // types its value
  [[nodiscard]] std::optional<std::size_t> handle_under(const QPointF& at) const;
  // Shows what the text would make of the scene, as far as it can be taken: with the next edit, or when typing
  // ends without one, that is over.
  void preview_typed(const QString& text);
  void type_next(bool forward);
  void end_typing();
  // Takes back what was typed, with the drag in which it was.
  void cancel_typing();
  // The scene was edited: unless by these tools, what the bubble says is over, and so is a row of keys.
  void scene_edited();
  // The edit that is being told was refused: its bubble says why. False if none is.
  bool refuse(const QString& sentence);

  [[nodiscard]] Qt::CursorShape cursor(const QPointF& at) const;
  // What the mouse can do there, in a few words; nothing while a tool but kSelect waits for its use.
  [[nodiscard]] QString hint(const QPointF& at) const;
  [[nodiscard]] Overlay overlay() const;

 signals:
  void selectionChanged(const std::vector<std::string>& names);
  void partChosen();               // part() is another one
  void impactChosen(double time);  // s, by its mark
  void edited(const carom::SceneEdits& edits, const QString& name, int drag);
  void dragCancelled(int drag);
  void renameRequested();  // of the selected body
  void toolChanged(carom::SceneTool tool, bool kept);
  void pauseRequested();
  void spawnRequested(double x, double y);  // m
  // A body of a run that plays is pulled, from this hand; it is let go, after it was pulled.
  void pulled(const carom::Hand& hand);
  void letGo();
  void changed();  // the overlay
  // typed() is another value, and `first` is typed over it; there is none any more.
  void typingBegan(const QString& first);
  void typingEnded();

 private:
  // kMute: until the button is let go, nothing happens.
  enum class State { kNone, kPressed, kMute, kDrag, kHand, kEnd, kBand, kDraw };
  // What the button was pressed on; as the target of a value without a body: the chosen part.
  struct Grab {
    HandleKind kind = HandleKind::kBody;
    std::string body;
    std::size_t corner = 0;  // of a polygon
  };
  struct Typing {
    Grab target;
    std::shared_ptr<TypedThing> thing;
    std::shared_ptr<TypedDrawing> drawing;  // the same, of a body that is being drawn
    std::size_t index = 0;                  // of its values
    int drag = 0;
    bool changed = false;  // the scene, under this number
    bool taken = false;    // a typed value
    bool in_drag = false;  // of a body, or of an end
    // What the scene goes back to from a value that is shown but not taken: the edits of the drag, or those
    // taken last; none: the scene as it was.
    struct Last {
      SceneEdits edits;
      QString name;
    };
    std::optional<Last> last;
    bool previewed = false;               // such a value is shown
    std::shared_ptr<TypedDrawing> tried;  // the body that is being drawn, with it
    Bubble bubble;
  };
  // Keys of one kind in quick succession, one step of undo.
  struct KeyRow {
    KeyEdit kind = KeyEdit::kMove;
    int drag = 0;
    std::vector<std::string> names;
    std::vector<Body> before;
    DragStart start;      // as they are now: frames may not yet show it
    QElapsedTimer since;  // the last key
  };

  [[nodiscard]] std::vector<int> selected_indices() const;
  [[nodiscard]] std::vector<Body> selected_now() const;
  [[nodiscard]] std::vector<Handle> handles(const SceneSight& sight) const;
  [[nodiscard]] std::optional<Grab> grab_at(const QPointF& at) const;
  [[nodiscard]] std::vector<std::string> names_at(const QPointF& at) const;
  [[nodiscard]] bool was_clicked(const QPointF& at) const;
  [[nodiscard]] std::vector<std::string>::const_iterator selected_among(
      const std::vector<std::string>& names) const;
  [[nodiscard]] std::string clicked_body();
  // The selected bodies of which an edit can change what this handle stands for, none that is locked, `first`
  // in front.
  [[nodiscard]] std::vector<Body> editable(const std::string& first, HandleKind kind) const;
  [[nodiscard]] DragPoint point(Qt::KeyboardModifiers keys) const;
  [[nodiscard]] QString hint_of_mouse(const QPointF& at) const;

  // Tells an edit; what follows from it does not end the bubble. Returns why it was refused, or nothing.
  QString own_edit(const SceneEdits& edits, const QString& name, int drag);
  // Keeps a bubble for a while; a click on it edits the value of its target.
  void note(const Bubble& bubble, const std::optional<Grab>& of = std::nullopt);
  void end_note();
  [[nodiscard]] bool has_draft() const { return !draft_.empty() || first_end_.has_value(); }
  void set_selection(const std::vector<std::string>& names);
  void select_awaited();
  void begin();
  void begin_drag();
  void drag_on();
  void sweep(const QPointF& from, const QPointF& to);
  void click(Qt::KeyboardModifiers keys);
  void select_band(Qt::KeyboardModifiers keys);
  void used_tool();
  // New bodies (scene_tool_draw.cpp).
  [[nodiscard]] Stroke stroke() const;
  [[nodiscard]] Body body_of(const Drawn& drawn) const;
  void add(const Drawn& drawn);
  void add_usual();
  [[nodiscard]] QPointF middle_of_view() const;
  [[nodiscard]] QPointF free_place();
  void draw();
  [[nodiscard]] bool closes_polygon() const;  // a corner at the mouse
  [[nodiscard]] Vec2 next_corner() const;
  void set_corner();
  void close_polygon();
  void show_corners(Overlay& out) const;
  void show_drawing(Overlay& out) const;
  void show_overlaps_of_new(const Body& body, Overlay& out) const;
  // The hand on a body of a run that plays (scene_tool_hand.cpp).
  void begin_hand();
  [[nodiscard]] bool holds() const;  // a body that moves, still
  void pull();
  void end_hand();
  // Joints, springs and forces (scene_tool_join.cpp).
  [[nodiscard]] JointSight joint_sight(const QPointF& at) const;
  [[nodiscard]] std::optional<LinkEnds> drawn_ends() const;
  void begin_link();
  void end_link();
  void set_end();
  void join(const LinkEnds& ends);
  void await_part(const SceneEdits& edits);
  void find_made_part();
  void join_selected();
  void show_joining(Overlay& out) const;
  // The impact to whose moment a click goes: while the run is paused.
  [[nodiscard]] std::optional<ImpactRecord> mark_under(const QPointF& at) const;
  [[nodiscard]] std::optional<PartId> part_under(const QPointF& at) const;
  void show_part(Overlay& out) const;
  [[nodiscard]] std::optional<std::size_t> end_under(const QPointF& at) const;  // of the chosen part
  void begin_end_drag();
  void drag_end_on();
  void let_end_go();
  void show_moved_end(Overlay& out) const;
  // Locked bodies (scene_tool_locks.cpp).
  void toggle_lock();
  void rename_locked(const std::vector<Body>& before, const std::vector<Body>& after);
  [[nodiscard]] std::optional<std::string> locked_among(const std::vector<Body>& bodies) const;
  void say_locked(const std::string& name);
  void show_locks(Overlay& out) const;
  // Typed values (scene_tool_typing.cpp).
  [[nodiscard]] bool types_in_drag(int key, Qt::KeyboardModifiers keys) const;
  [[nodiscard]] bool draws_link_with_value() const;
  [[nodiscard]] bool types_noted(int key, Qt::KeyboardModifiers keys) const;
  void begin_typing(Typing typing, const QString& first);
  void type_in_drag(const QString& first);
  void type_in_drawing(const QString& first);
  void type_in_link(const QString& first);
  void type_value_of(const Grab& target, const Bubble& where, const QString& first = {});
  bool type_at(const QPointF& at);
  void take_preview_back(Typing& typing);
  void drop_typing();
  // Keys (scene_tool_keys.cpp).
  [[nodiscard]] bool plays() const;
  [[nodiscard]] bool changes(int key, Qt::KeyboardModifiers keys) const;
  void press_waiting_keys();
  void edit_by_key(int key, Qt::KeyboardModifiers keys);
  void enter();
  void toggle_stay();
  bool escape();
  void remove_selected();
  void say_no_velocity();
  void edit_by_key(KeyEdit kind, int key, Qt::KeyboardModifiers keys);
  // What surrounds an edit, and what is left of it (scene_tool_limits.cpp).
  [[nodiscard]] DragStart start_of(const Grab& grab, std::vector<Body> bodies) const;
  [[nodiscard]] std::vector<Overlap> overlaps_of_new(const Body& body) const;  // the deepest first
  [[nodiscard]] bool can_touch() const;
  void say_two_touch();
  void put_in_touch();
  void say_overlap(const std::vector<Body>& bodies, const Surroundings& beside);
  void find_kept_overlaps();
  void show_kept_overlaps(Overlay& out) const;
  void change_by_key(Dragged wanted);
  void end_drag();
  QString emit_change(const Dragged& change, bool joints, int drag);

  std::function<SceneSight()> sight_;
  Selection selection_;
  Selection stay_;                                   // selected when Tab goes on
  std::vector<std::string> awaited_;                 // see select_when_shown
  std::shared_ptr<const std::vector<Body>> bodies_;  // of `index_`
  std::unordered_map<std::string, int> index_;
  SceneTool tool_ = SceneTool::kSelect;
  bool keep_tool_ = false;
  bool snapping_ = true;
  Keeps keeps_ = Keeps::kDensity;
  PolygonDraft draft_;
  std::optional<LinkEnd> first_end_;  // that a click has set
  std::optional<PartId> part_;
  std::optional<PartId> awaited_part_;  // a newer one of its kind will be shown, which a tool has made
  std::optional<PartId> made_part_;     // that one: what is typed after it was drawn is its value
  QString typed_ahead_;                 // before it is shown
  Selection locked_;
  std::vector<Overlap> kept_;
  std::shared_ptr<const Frame> kept_in_;

  State state_ = State::kNone;
  bool repeated_ = false;  // the press is the second one of a double click
  QPointF press_;
  QPointF mouse_;
  bool over_ = false;  // the mouse is over the scene
  Qt::KeyboardModifiers keys_{};
  std::optional<Grab> grab_;        // none: empty space
  bool press_grabs_ = false;        // whether the last press did
  std::optional<QPointF> clicked_;  // where a click last selected a body
  // What was selected before that click, if it took the body below: the first one of a double click takes none.
  std::optional<std::vector<std::string>> clicked_through_;
  std::optional<std::size_t> end_;     // of the chosen part, that a drag would take
  std::shared_ptr<EndDrag> end_drag_;  // the last one
  Joined moved_end_;                   // as it is, or why it can't be there
  double swept_ = 0.0;                 // rad, see DragPoint
  std::optional<Body> pressed_;        // as it stood when it was pressed, while the run plays
  Vec2 pressed_place_ = Vec2::Zero();  // m, likewise
  std::optional<Hand> hand_;
  QElapsedTimer since_pull_;
  DragStart start_;
  std::vector<Overlay::Ghost> ghosts_;
  Dragged dragged_;
  bool emitted_ = false;   // by this drag
  bool refitted_ = false;  // it has changed joints
  int drags_ = 0;          // number of the last one
  KeyRow row_;
  std::vector<std::pair<int, Qt::KeyboardModifiers>> waiting_keys_;  // for the pause, or for awaited_
  Bubble note_;
  std::optional<Grab> note_of_;
  std::shared_ptr<Typing> typing_;
  bool telling_ = false;  // an edit of its own
  QString refusal_;       // of that edit
  QTimer note_time_;
};

}  // namespace carom
