#include <QAction>
#include <QMenu>
#include <algorithm>
#include <array>
#include <cmath>
#include <variant>

#include "app/lab/lab_window.h"
#include "physics/observe/observables.h"
#include "widgets/base/method_names.h"
#include "widgets/edit/inspected_parts.h"
#include "widgets/plot/plot_panel.h"
#include "widgets/run/stop_editor.h"
#include "widgets/run/transport_bar.h"
#include "widgets/scene/body_text.h"
#include "widgets/scene/hit.h"
#include "widgets/scene/scene_view.h"

// The menu of a right click in the scene. Its entries do what their keys do.
namespace carom {
namespace {

QAction* add(QMenu& menu, const QString& text, const QKeySequence& key) {
  QAction* action = menu.addAction(text);
  action->setShortcut(key);
  action->setShortcutVisibleInContextMenu(true);
  return action;
}

// What the scene view does by key, if it can now.
void add_key(QMenu& menu, SceneView* view, const QString& text, Qt::Key key) {
  QAction* action = add(menu, text, key);
  action->setEnabled(view->takes(key));
  QObject::connect(action, &QAction::triggered, view, [view, key] { view->press_key(key); });
}

// -1: none.
int index_of(const Frame& frame, const std::string& name) {
  const auto found = std::find_if(frame.bodies->begin(), frame.bodies->end(),
                                  [&](const Body& body) { return body.name == name; });
  return found == frame.bodies->end() ? -1 : static_cast<int>(found - frame.bodies->begin());
}

// Without a mark of a key in it.
QString escaped(QString name) { return name.replace("&", "&&"); }

void add_title(QMenu& menu, const QString& title) {
  QAction* action = menu.addAction(escaped(title));
  QFont font = menu.font();
  font.setBold(true);
  action->setFont(font);
  action->setEnabled(false);
  menu.addSeparator();
}

}  // namespace

void LabWindow::inspect() { inspector_action_->setChecked(true); }

void LabWindow::show_scene_menu(const QPoint& at) {
  if (frame() == nullptr) return;
  auto* menu = new QMenu(this);
  menu->setAttribute(Qt::WA_DeleteOnClose);
  menu->setAccessibleName(tr("Scene"));
  if (view_->part() && frame()->scene) {
    if (const auto part = inspected_part(*frame()->scene, *view_->part())) add_title(*menu, part->title);
    connect(add(*menu, tr("&Inspect"), Qt::Key_I), &QAction::triggered, this, &LabWindow::inspect);
    add_key(*menu, view_, tr("D&elete"), Qt::Key_Delete);
  } else if (!view_->selection().empty()) {
    fill_menu_of_bodies(*menu);
  } else {
    fill_menu_of_space(*menu, at);
  }
  menu->popup(view_->mapToGlobal(at));
}

void LabWindow::fill_menu_of_bodies(QMenu& menu) {
  const std::vector<std::string>& names = view_->selection();
  const int only = names.size() == 1 ? index_of(*frame(), names[0]) : -1;
  const Body* body = only < 0 ? nullptr : &(*frame()->bodies)[static_cast<std::size_t>(only)];
  add_title(menu, body != nullptr ? QString("%1 · %2").arg(QString::fromStdString(names[0]), kind_text(*body))
                                  : tr("%n bodies", nullptr, static_cast<int>(names.size())));
  const auto do_it = [&](const QString& text, const QKeySequence& key, void (LabWindow::*slot)()) {
    connect(add(menu, text, key), &QAction::triggered, this, slot);
  };
  connect(add(menu, tr("&Inspect"), Qt::Key_I), &QAction::triggered, this, &LabWindow::inspect);
  add_key(menu, view_, tr("Re&name"), Qt::Key_F2);
  menu.addSeparator();
  do_it(tr("&Duplicate"), Qt::CTRL | Qt::Key_D, &LabWindow::duplicate_selection);
  do_it(tr("&Copy as preset text"), QKeySequence::Copy, &LabWindow::copy_selection);
  do_it(tr("Cu&t"), QKeySequence::Cut, &LabWindow::cut_selection);
  add_key(menu, view_, tr("D&elete"), Qt::Key_Delete);
  menu.addSeparator();
  add_key(menu, view_, view_->all_locked() ? tr("Un&lock") : tr("&Lock: hands off"), Qt::Key_L);
  add_key(menu, view_, tr("Bring to &rest"), Qt::Key_0);
  add_key(menu, view_, tr("Reverse the &velocity"), Qt::Key_X);
  if (names.size() > 1) {
    do_it(tr("&Join into one body"), Qt::CTRL | Qt::Key_G, &LabWindow::join_selection);
  }
  const auto& bodies = *frame()->bodies;
  const bool has_compound = std::any_of(bodies.begin(), bodies.end(), [&](const Body& each) {
    return std::holds_alternative<Compound>(each.shape) &&
           std::find(names.begin(), names.end(), each.name) != names.end();
  });
  if (has_compound) {
    do_it(tr("Take &apart"), Qt::CTRL | Qt::SHIFT | Qt::Key_G, &LabWindow::take_selection_apart);
  }
  if (names.size() > 1) add_align_menu(&menu)->setEnabled(view_->can_align());
  if (names.size() == 2) {
    add_key(menu, view_, tr("Put in touc&h with %1").arg(escaped(QString::fromStdString(names[1]))), Qt::Key_K);
  }
  if (body == nullptr || has_infinite_mass(*body)) return;
  menu.addSeparator();
  add_plots_of(menu, names[0]);
  add_stops_of(menu, body_now(*frame(), only));
}

// A plot of each quantity of this body.
void LabWindow::add_plots_of(QMenu& menu, const std::string& body) {
  QMenu* plots = menu.addMenu(tr("&Plot its"));
  for (const Observable& each : observables()) {
    if (each.topic != Topic::kBody || each.bodies != 1) continue;
    Plot plot;
    plot.y = {{std::string(each.name), {body}}};
    const QString label = text_of(each.label);
    connect(plots->addAction(label), &QAction::triggered, this, [this, plot] { plots_->add(plot); });
  }
}

// The editor of stops, with where it is now.
void LabWindow::add_stops_of(QMenu& menu, const Body& now) {
  QMenu* stops = menu.addMenu(tr("&Stop when it passes"));
  struct Entry {
    StopQuantity quantity;
    const char* text;
    double value;  // SI unit
  };
  const std::array<Entry, 4> entries = {{{StopQuantity::kX, "&x ...", now.position.x()},
                                         {StopQuantity::kY, "&y ...", now.position.y()},
                                         {StopQuantity::kAngle, "&Angle ...", now.angle},
                                         {StopQuantity::kSpeed, "&Speed ...", now.velocity.norm()}}};
  for (const Entry& entry : entries) {
    Stop stop;
    stop.kind = StopKind::kPassing;
    stop.body = now.name;
    stop.quantity = entry.quantity;
    stop.value = std::round(100.0 * entry.value) / 100.0;
    connect(stops->addAction(tr(entry.text)), &QAction::triggered, this,
            [this, stop] { stop_editor_->open_over(transport_->flag(), stop); });
  }
}

void LabWindow::fill_menu_of_space(QMenu& menu, const QPoint& at) {
  connect(add(menu, tr("&Paste here"), QKeySequence::Paste), &QAction::triggered, this,
          [this, at] { paste_at(at); });
  connect(add(menu, tr("&Fit the scene"), Qt::Key_F), &QAction::triggered, view_, &SceneView::find);
  menu.addSeparator();
  const auto draws = [&](const QString& text, SceneTool tool) {
    connect(menu.addAction(text), &QAction::triggered, view_, [this, tool, at] { view_->draw_at(tool, at); });
  };
  draws(tr("New &disc here"), SceneTool::kDisc);
  draws(tr("New &box here"), SceneTool::kBox);
}

}  // namespace carom
