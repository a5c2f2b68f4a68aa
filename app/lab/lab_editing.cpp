#include <QApplication>
#include <QClipboard>
#include <QCursor>
#include <algorithm>
#include <utility>

#include "app/lab/copied_bodies.h"
#include "app/lab/document_files.h"
#include "app/lab/drawer.h"
#include "app/lab/group_tools.h"
#include "app/lab/lab_window.h"
#include "physics/dynamics/integrators/method_fields.h"
#include "physics/preset/preset_file.h"
#include "physics/scene/validate.h"
#include "widgets/base/ask.h"
#include "widgets/edit/bodies_sheet.h"
#include "widgets/edit/driven.h"
#include "widgets/edit/inspector.h"
#include "widgets/scene/allowed_motion.h"
#include "widgets/scene/allowed_place.h"
#include "widgets/scene/drag.h"
#include "widgets/scene/join_shapes.h"
#include "widgets/scene/joined_velocities.h"
#include "widgets/scene/scene_parts.h"
#include "widgets/scene/scene_view.h"
#include "widgets/scene/typed_overlap.h"

// What the window edits by hand: the scene view, the inspector and the table say what, the session does it.
namespace carom {
namespace {

// Each widget counts its drags; no two of them share a number.
enum DragSource { kOfScene = 1, kOfInspector = 2, kSources = 3 };

int drag_of(DragSource source, int drag) { return drag > 0 ? kSources * drag + source : 0; }

// The disc that a tool has drawn; nullptr: something else was done.
const Body* drawn_disc(const SceneEdits& edits) {
  const auto* added = edits.size() == 1 ? std::get_if<Add<Body>>(&edits[0]) : nullptr;
  return added != nullptr && std::holds_alternative<Disc>(added->part.shape) ? &added->part : nullptr;
}

// Edits of bodies as they are seen at the shown moment, as the session takes them.
SceneEdits stated(const SceneEdits& edits, LabRuns& runs) {
  const auto scene = runs.shown_scene();
  if (scene == nullptr || runs.frame() == nullptr) return edits;
  return as_stated(edits, *scene, runs.frame()->time, runs.at_start());
}

}  // namespace

void LabWindow::connect_edits() {
  connect(view_, &SceneView::edited, this, [this](const SceneEdits& edits, const QString& name, int drag) {
    const Body* disc = session_.runs().at_start() ? nullptr : drawn_disc(edits);
    if (disc != nullptr) return drop(disc->position, std::get<Disc>(disc->shape).radius);
    select_drawn(edits);
    session_.edit(stated(edits, session_.runs()), name, drag_of(kOfScene, drag));
  });
  connect(view_, &SceneView::spawnRequested, this, [this](double x, double y) { drop({x, y}, std::nullopt); });
  connect(view_, &SceneView::pulled, &session_.hand(), &HandEdits::pull);
  connect(view_, &SceneView::letGo, &session_.hand(), &HandEdits::let_go);
  connect(view_, &SceneView::pauseRequested, this, [this] { session_.runs().set_playing(false); });
  connect(view_, &SceneView::dragCancelled, this,
          [this](int drag) { session_.cancel(drag_of(kOfScene, drag)); });
  connect(view_, &SceneView::selectionChanged, this, &LabWindow::show_selection);
  connect(view_, &SceneView::partChosen, this, &LabWindow::show_selection);
  connect(view_, &SceneView::selectionChanged, &session_,
          [this] { session_.history().set_selection(view_->selection()); });
  connect(&session_.history(), &EditHistory::selectionReturned, this, &LabWindow::select_again);
  connect(view_, &SceneView::dragChanged, inspector_, &Inspector::watch_changes);
  connect(view_, &SceneView::dragChanged, sheet_, &BodiesSheet::watch_changes);
  connect(view_, &SceneView::menuRequested, this, &LabWindow::show_scene_menu);
  connect(view_, &SceneView::renameRequested, this, [this] {
    inspect();
    inspector_->edit_name();
  });
  const auto pause = [this] {
    if (session_.runs().plays()) session_.runs().set_playing(false);
  };
  connect(inspector_, &Inspector::pauseRequested, this, pause);
  connect(sheet_, &BodiesSheet::pauseRequested, this, pause);
  connect(inspector_, &Inspector::keepsChosen, view_, &SceneView::set_keeps);
  connect(inspector_, &Inspector::left, this, [this] {
    view_->activateWindow();  // the inspector may float
    view_->setFocus(Qt::ShortcutFocusReason);
  });
  connect(inspector_, &Inspector::partOpened, this, [this] { view_->choose_part(inspector_->part()); });
  connect(inspector_, &Inspector::edited, this, [this](const SceneEdits& edits, const QString& name, int drag) {
    edit_bodies(stated(edits, session_.runs()), name, drag_of(kOfInspector, drag));
  });
  connect(inspector_, &Inspector::durationEdited, &session_,
          [this](double duration, const QString& name, int drag) {
            session_.change_duration(duration, name, drag_of(kOfInspector, drag));
          });
  connect(sheet_, &BodiesSheet::edited, this, [this](const SceneEdits& edits, const QString& name) {
    edit_bodies(stated(edits, session_.runs()), name, 0);
  });
  connect(sheet_, &BodiesSheet::chosen, this,
          [this](const std::vector<std::string>& names) { view_->select(names); });
  connect(&session_.history(), &EditHistory::bodiesChanged, this, &LabWindow::show_aim);
  connect(&session_.history(), &EditHistory::runsReturned, this, &LabWindow::show_aim);
  connect(&session_.history(), &EditHistory::documentChanged, view_, &SceneView::scene_edited);
  aim_time_.setSingleShot(true);
  connect(&aim_time_, &QTimer::timeout, view_,
          [this] { view_->is_dragging() ? aim_time_.start() : view_->set_aim(std::nullopt); });
  // A refusal is about the last edit and what is shown; red cells are about the edit alone, which may select.
  connect(&session_.history(), &EditHistory::documentChanged, this, [this] {
    inspector_->say({});
    sheet_->forget_faults();
    if (std::exchange(said_of_edit_, {}) == said_) said_.clear();
  });
  connect(view_, &SceneView::selectionChanged, this, &LabWindow::forget_refusal);
  connect(view_, &SceneView::partChosen, this, &LabWindow::forget_refusal);
  connect(&session_.history(), &EditHistory::editSaid, this, [this](const QString& sentence) {
    said_of_edit_ = sentence;
    say_for_a_while(sentence);
  });
  connect(&session_.history(), &EditHistory::editRefused, this, [this](const QString& why) {
    if (view_->refuse(why)) return;
    const bool typed_in_table = sheet_->isAncestorOf(QApplication::focusWidget());
    typed_in_table ? sheet_->refuse(why) : say_refusal(why);
  });
}

// In the inspector, where it is seen.
void LabWindow::say_refusal(const QString& why) {
  inspector_->say(why);
  if (!inspector_->isVisible()) say_for_a_while(why);
}

void LabWindow::forget_refusal() {
  inspector_->say({});
  sheet_->end_sentence();
}

// For a while after each edit of a start, and when undo brings one back: where the bodies will first meet.
// Within a frame, or not at all.
void LabWindow::show_aim() {
  constexpr double kAhead = 2.0;  // s
  constexpr std::chrono::milliseconds kBudget(4);
  constexpr std::chrono::milliseconds kShown(4000);
  if (!session_.runs().at_start()) return view_->set_aim(std::nullopt);
  try {
    view_->set_aim(aim_of(setup_of(preset()), kAhead, kBudget));
  } catch (const std::exception&) {
    view_->set_aim(std::nullopt);  // the session says what is wrong with the scene
  }
  aim_time_.start(kShown);
}

// A disc, into the run where it has begun; without a radius a random one.
void LabWindow::drop(const Vec2& at, std::optional<double> radius) {
  try {
    const std::string name = session_.add_body(at.x(), at.y(), radius);
    if (!view_->tool_kept() && !name.empty()) view_->select_when_shown({name});
  } catch (const SceneError& error) {
    show_message(this, tr("No body can be put here"), QString::fromStdString(error.what()));
  }
}

// A new body is selected, unless the tool is kept for more of them.
void LabWindow::select_drawn(const SceneEdits& edits) {
  const auto* added = edits.size() == 1 ? std::get_if<Add<Body>>(&edits[0]) : nullptr;
  if (added != nullptr && !view_->tool_kept()) view_->select_when_shown({added->part.name});
}

void LabWindow::edit_bodies(const SceneEdits& edits, const QString& name, int drag) {
  if (session_.needs_pause(edits)) {
    return session_.pause_for(edits, name,
                              [=, this](const SceneEdits& there) { edit_bodies(there, name, drag); });
  }
  const auto scene = session_.runs().scene();
  if (scene == nullptr) {
    session_.edit(edits, name, drag);
    return keep_selected(edits);
  }
  const AllowedPlace placed = allowed_place(*scene, edits);
  if (!placed.refusal.isEmpty()) {
    session_.history().refuse(placed.refusal);
    return;
  }
  const AllowedMotion allowed = allowed_motion(*scene, placed.edits);
  QString sentence = placed.sentence.isEmpty() ? allowed.sentence : placed.sentence;
  if (sentence.isEmpty()) sentence = typed_overlap(*scene, allowed.edits);
  const std::uint64_t before = session_.history().revision();
  session_.edit(with_joined(*scene, allowed.edits), allowed.sentence.isEmpty() ? name : allowed.name, drag);
  if (session_.history().revision() == before) return;
  keep_selected(edits);
  say_of_edit(sentence);
}

// Beside what the session says of it.
void LabWindow::say_of_edit(QString sentence) {
  if (sentence.isEmpty()) return;
  if (!said_of_edit_.isEmpty()) sentence += " " + said_of_edit_;
  said_of_edit_ = sentence;
  say_for_a_while(sentence);
}

// Bodies that get another name stay selected.
void LabWindow::keep_selected(const SceneEdits& edits) {
  std::vector<std::string> names;
  for (const SceneEdit& edit : edits) {
    if (const auto* body = std::get_if<Replace<Body>>(&edit)) names.push_back(body->part.name);
  }
  if (!names.empty() && names != view_->selection()) view_->select_when_shown(names);
}

void LabWindow::show_selection() {
  LabRuns& runs = session_.runs();
  const auto parts = runs.shown_parts();
  inspector_->set_playing(runs.plays());
  const std::optional<PartId>& part = view_->part();
  if (part && parts != nullptr && has_part(*parts, *part)) {
    inspector_->show_part(parts, *part);
  } else {
    const double time = runs.frame() == nullptr ? 0.0 : runs.frame()->time;
    inspector_->show_selection(view_->selection().empty() ? parts : runs.shown_scene(), view_->selection(),
                               time);
  }
  const bool align = view_->can_align();
  group_->enable(align, align && view_->selection().size() > 2,
                 view_->selection().size() == 2 && view_->takes(Qt::Key_K));
  if (!drawer_->shows(sheet_)) return;
  sheet_->show_moment(runs.shown_scene(), runs.frame());
  sheet_->show_selection(view_->selection());
}

void LabWindow::new_document() {
  files_->when_saved([this] {
    Preset empty;
    empty.title = tr("New scene").toStdString();
    empty.duration = 10.0;
    empty.method = unstated_method();
    empty.view = View{Vec2::Zero(), 4.0};
    empty.scene.materials.emplace_back();  // the surface of all that is drawn, to be seen and changed
    show_scene(empty, {}, {});
  });
}

// With the scene as it stands; a run that plays pauses first.
void LabWindow::with_scene(const QString& what, const std::function<void(const Scene&)>& then) {
  if (frame() == nullptr) return;
  session_.runs().when_still(what, [this, then] {
    if (const auto scene = session_.runs().scene()) then(*scene);
  });
}

// Of the shown moment, also while it plays.
void LabWindow::copy_selection() {
  const auto scene = session_.runs().shown_scene();
  if (scene == nullptr || view_->selection().empty()) return;
  const Preset copy = copied_bodies(*scene, view_->selection());
  QApplication::clipboard()->setText(QString::fromStdString(write_preset(copy)));
}

void LabWindow::cut_selection() {
  copy_selection();
  if (!view_->selection().empty()) view_->press_key(Qt::Key_Delete);
}

// At the mouse if it is over the scene, else in the middle of the view.
void LabWindow::paste() {
  paste_at(view_->underMouse() ? QPointF(view_->mapFromGlobal(QCursor::pos()))
                               : QRectF(view_->rect()).center());
}

void LabWindow::paste_at(const QPointF& at) {
  const QString text = QApplication::clipboard()->text();
  if (!text.trimmed().startsWith('{'))
    return say_refusal(tr("The clipboard holds no bodies. Copy some in the scene, or the text of a preset."));
  try {
    const Preset from = parse_preset(text.toStdString(), "clipboard");
    const Extent extent = extent_of(all_bodies(from.scene));
    const bool bounded = (extent.upper.array() >= extent.lower.array()).all();
    const Vec2 middle = bounded ? Vec2(0.5 * (extent.lower + extent.upper)) : Vec2(Vec2::Zero());
    // Round, so that places stay short numbers.
    const Camera& camera = view_->camera();
    const Vec2 shift = drawn_place(camera.to_world(at) - middle, {.scale = camera.scale}, 0.0);
    with_scene(tr("Paste"), [this, from, shift](const Scene& scene) {
      put(scene, paste_into(scene, from, shift), tr("Paste"));
    });
  } catch (const SceneError& error) {
    say_refusal(tr("The clipboard holds no preset: %1").arg(error.what()));
  }
}

void LabWindow::duplicate_selection() {
  if (view_->selection().empty()) return;
  with_scene(tr("Duplicate"), [this, names = view_->selection()](const Scene& scene) {
    const Preset copy = copied_bodies(scene, names);
    const WorldRect seen = view_->camera().visible();
    const Vec2 shift = shift_beside(copy.scene.bodies, all_bodies(scene), {seen.lower, seen.upper});
    put(scene, paste_into(scene, copy, shift), tr("Duplicate"));
  });
}

void LabWindow::put(const Scene& scene, const Paste& paste, const QString& what) {
  if (paste.names.empty()) return;
  const int count = static_cast<int>(paste.names.size());
  const QString overlap = typed_overlap(scene, paste.edits);
  const std::uint64_t before = session_.history().revision();
  session_.edit(paste.edits, count == 1 ? tr("%1 %2").arg(what, QString::fromStdString(paste.names.front()))
                                        : tr("%1 %n bodies", nullptr, count).arg(what));
  if (session_.history().revision() == before) return;
  say_of_edit(overlap);
  view_->select_when_shown(paste.names);
}

void LabWindow::join_selection() {
  if (view_->selection().empty()) return;
  with_scene(tr("Join"),
             [this, names = view_->selection()](const Scene& scene) { regroup(joining(scene, names)); });
}

void LabWindow::take_selection_apart() {
  if (view_->selection().empty()) return;
  with_scene(tr("Take apart"),
             [this, names = view_->selection()](const Scene& scene) { regroup(taking_apart(scene, names)); });
}

void LabWindow::regroup(const Regrouping& made) {
  if (!made.refusal.isEmpty()) return say_refusal(made.refusal);
  session_.edit(made.edits, made.name);
  view_->select_when_shown(made.bodies);
}

// After undo, as before the edit, once the bodies are shown.
void LabWindow::select_again(const std::vector<std::string>& names) {
  const auto gone = [this](const std::string& name) {
    return std::none_of(session_.history().bodies().begin(), session_.history().bodies().end(),
                        [&](const Body& body) { return body.name == name; });
  };
  std::vector<std::string> left = names;
  std::erase_if(left, gone);
  view_->select_when_shown(left);
}

}  // namespace carom
