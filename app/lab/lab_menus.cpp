#include <QAction>
#include <QApplication>
#include <QMenu>
#include <QMenuBar>
#include <QPushButton>
#include <array>

#include "app/help/help_dialog.h"
#include "app/help/keys_page.h"
#include "app/lab/document_files.h"
#include "app/lab/drawer.h"
#include "app/lab/floating_panel.h"
#include "app/lab/group_tools.h"
#include "app/lab/lab_exports.h"
#include "app/lab/lab_window.h"
#include "app/lab/method_bar.h"
#include "app/lab/panel_docks.h"
#include "app/lab/panel_focus.h"
#include "app/lab/scene_chips.h"
#include "app/lab/tool_column.h"
#include "widgets/base/ask.h"
#include "widgets/edit/inspector.h"
#include "widgets/plot/plot_panel.h"
#include "widgets/run/experiment_list.h"
#include "widgets/run/transport_bar.h"
#include "widgets/scene/scene_view.h"

// The menus of the lab's window.
namespace carom {

QAction* LabWindow::add_action(QMenu* menu, const QString& icon, const QString& text, const QKeySequence& key,
                               const std::function<void()>& slot) {
  auto* action = menu->addAction(text);
  action->setShortcut(key);
  if (!icon.isEmpty()) icon_actions_.emplace_back(action, icon);
  connect(action, &QAction::triggered, this, slot);
  return action;
}

void LabWindow::make_file_menu() {
  QMenu* file = menuBar()->addMenu(tr("&File"));
  const auto add = [&](const QString& icon, const QString& text, const QKeySequence& key, const auto& slot) {
    add_action(file, icon, text, key, slot);
  };
  add("new", tr("&New"), QKeySequence::New, [this] { new_document(); });
  add("open", tr("&Open..."), QKeySequence::Open, [this] { files_->choose(); });
  QMenu* recent = file->addMenu(tr("Open &recent"));
  connect(recent, &QMenu::aboutToShow, this, [this, recent] {
    recent->clear();
    for (const QString& each : files_->recent()) {
      recent->addAction(QString(each).replace("&", "&&"), this, [this, each] { open(each.toStdString()); });
    }
    if (recent->isEmpty()) recent->addAction(tr("No files yet"))->setEnabled(false);
  });
  add("save", tr("&Save"), QKeySequence::Save, [this] { save(); });
  add("", tr("Save &as..."), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_S), [this] { files_->save_as(); });
  add("", tr("Save the r&un as it stands..."), QKeySequence(), [this] { exports_->save_run(); });
  file->addSeparator();
  add("", tr("Save the &picture of the scene..."), QKeySequence(), [this] { exports_->save_scene_picture(); });
  add("", tr("&Copy the picture of the scene"), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_C),
      [this] { exports_->copy_scene_picture(); });
  add("", tr("&Film..."), QKeySequence(), [this] { exports_->make_film(); });
  add("", tr("Save &data..."), QKeySequence(Qt::CTRL | Qt::Key_E), [this] { exports_->save_data(nullptr); });
  add("", tr("&Lab report..."), QKeySequence(Qt::CTRL | Qt::Key_L), [this] { exports_->make_report(); });
  file->addSeparator();
  add("", tr("&Quit"), QKeySequence::Quit, [this] { close(); });
}

void LabWindow::make_edit_menu() {
  QMenu* edit = menuBar()->addMenu(tr("&Edit"));
  QAction* undo = undo_ = session_.edits().createUndoAction(this, tr("&Undo"));
  undo->setShortcut(QKeySequence(Qt::CTRL | Qt::Key_Z));
  QAction* redo = session_.edits().createRedoAction(this, tr("&Redo"));
  redo->setShortcuts({QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Z), QKeySequence(Qt::CTRL | Qt::Key_Y)});
  edit->addActions({undo, redo});
  icon_actions_.emplace_back(undo, "undo");
  icon_actions_.emplace_back(redo, "redo");
  edit->addSeparator();
  // The scene has the keys of its selection; a text field has its own.
  const auto add = [&](const QString& text, const QKeySequence& key, const std::function<void()>& slot) {
    return add_action(edit, "", text, key, slot);
  };
  std::vector<QAction*> of_bodies = {add(tr("Cu&t"), QKeySequence::Cut, [this] { cut_selection(); }),
                                     add(tr("&Copy"), QKeySequence::Copy, [this] { copy_selection(); })};
  add(tr("&Paste"), QKeySequence::Paste, [this] { paste(); });
  of_bodies.push_back(
      add(tr("&Duplicate"), QKeySequence(Qt::CTRL | Qt::Key_D), [this] { duplicate_selection(); }));
  const auto enable = [this, of_bodies] {
    for (QAction* action : of_bodies) action->setEnabled(!view_->selection().empty());
  };
  connect(view_, &SceneView::selectionChanged, this, enable);
  enable();
  // Their keys are named, and stay the scene's.
  QAction* removal = add(tr("D&elete") + "\tDel", {}, [this] { view_->press_key(Qt::Key_Delete); });
  QAction* all =
      add(tr("Select &all") + "\tCtrl+A", {}, [this] { view_->press_key(Qt::Key_A, Qt::ControlModifier); });
  connect(edit, &QMenu::aboutToShow, this, [this, removal, all] {
    removal->setEnabled(view_->takes(Qt::Key_Delete));
    all->setEnabled(view_->takes(Qt::Key_A, Qt::ControlModifier));
  });
  edit->addSeparator();
  QAction* snapping = add(tr("Sna&pping"), QKeySequence(Qt::Key_Q), [] {});
  snapping->setCheckable(true);
  snapping->setChecked(true);
  snapping->setToolTip(tr("To touching, centres, the grid and round values (Q); off while Ctrl is held"));
  connect(snapping, &QAction::toggled, view_, &SceneView::set_snapping);
  edit->addSeparator();
  QAction* join =
      add(tr("&Join into one body"), QKeySequence(Qt::CTRL | Qt::Key_G), [this] { join_selection(); });
  QAction* apart = add(tr("Take &apart"), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_G),
                       [this] { take_selection_apart(); });
  connect(edit, &QMenu::aboutToShow, this, [this, join, apart] {
    join->setEnabled(view_->selection().size() > 1);
    apart->setEnabled(!view_->selection().empty());
  });
  connect(edit, &QMenu::aboutToHide, this, [join, apart] {
    join->setEnabled(true);
    apart->setEnabled(true);
  });
  QMenu* align = add_align_menu(edit);
  connect(edit, &QMenu::aboutToShow, align, [this, align] { align->setEnabled(view_->can_align()); });
  QAction* touch = add(tr("Put in touc&h") + "\tK", {}, [this] { view_->press_key(Qt::Key_K); });
  group_ = new GroupTools(align->actions(), touch);
  inspector_->set_group_tools(group_);
}

QMenu* LabWindow::add_align_menu(QMenu* to) {
  QMenu* menu = to->addMenu(tr("A&lign"));
  struct Entry {
    const char* text;
    Alignment alignment;
  };
  constexpr std::array<Entry, 8> kEntries = {{
      {"&Left sides", Alignment::kLeft},
      {"&Centres in a column", Alignment::kCentre},
      {"&Right sides", Alignment::kRight},
      {"&Tops", Alignment::kTop},
      {"Centres in a ro&w", Alignment::kMiddle},
      {"&Bottoms", Alignment::kBottom},
      {"&Distribute across", Alignment::kAcross},
      {"Distribute &upwards", Alignment::kUpwards},
  }};
  for (const Entry& entry : kEntries) {
    if (entry.alignment == Alignment::kAcross) menu->addSeparator();
    add_action(menu, "", tr(entry.text), QKeySequence(),
               [this, alignment = entry.alignment] { view_->align(alignment); });
  }
  return menu;
}

// What the scene shows.
void LabWindow::add_toggles(QMenu* view) {
  struct Toggle {
    const char* icon;
    const char* text;
    const char* tip;
    Qt::Key key;  // with Shift
    bool DrawingOptions::*flag;
  };
  constexpr std::array<Toggle, 7> kToggles = {{
      {"grid", "&Grid", "Grid in metres", Qt::Key_G, &DrawingOptions::grid},
      {"velocity", "&Velocities", "Arrows of the velocities", Qt::Key_V, &DrawingOptions::velocities},
      {"", "F&orces", "Applied forces and torques", Qt::Key_F, &DrawingOptions::forces},
      {"contact", "&Contacts", "Impulses of the newest impacts; forces in N of contacts that last", Qt::Key_K,
       &DrawingOptions::contacts},
      {"", "&Before and after at an impact", "Velocities and impulse of the impact that was gone to", Qt::Key_J,
       &DrawingOptions::jumps},
      {"names", "&Names", "Names of the bodies", Qt::Key_N, &DrawingOptions::names},
      {"", "R&un before", "The run that was left last, pale in scene and plots by the time since its start",
       Qt::Key_B, &DrawingOptions::run_before},
  }};
  for (const Toggle& toggle : kToggles) {
    const QKeySequence key(Qt::SHIFT | toggle.key);
    QAction* action = add_action(view, toggle.icon, tr(toggle.text), key, [] {});
    action->setToolTip(tr("%1 (%2)").arg(tr(toggle.tip), key.toString(QKeySequence::NativeText)));
    action->setCheckable(true);
    action->setIconVisibleInMenu(false);  // it would hide the tick
    action->setChecked(view_->options().*toggle.flag);
    connect(action, &QAction::toggled, this, [this, flag = toggle.flag](bool on) {
      DrawingOptions options = view_->options();
      options.*flag = on;
      view_->set_options(options);
      show_run_before();
    });
    if (toggle.flag == &DrawingOptions::run_before) run_before_ = action;
  }
}

void LabWindow::make_view_menu() {
  QMenu* view = menuBar()->addMenu(tr("&View"));
  list_action_ = add_action(view, "", tr("&Experiments"), QKeySequence(Qt::Key_E), [this] {
    if (!list_action_->isCheckable()) list_->begin_search();
  });
  list_action_->setCheckable(true);
  connect(list_action_, &QAction::toggled, this, &LabWindow::open_list);
  pin_action_ = add_action(view, "", tr("E&xperiments beside the scene"), QKeySequence(), [] {});
  pin_action_->setCheckable(true);
  pin_action_->setChecked(true);
  connect(pin_action_, &QAction::toggled, this, &LabWindow::place_list);
  add_action(view, "fit", tr("&Fit the scene"), QKeySequence(Qt::Key_F), [this] { view_->find(); });
  add_action(view, "", tr("&Zoom to the selection"), QKeySequence(Qt::Key_Z),
             [this] { view_->show_selected(); });
  add_action(view, "", tr("&Reset the plots' zoom"), QKeySequence(Qt::CTRL | Qt::Key_Home),
             [this] { plots_->reset_zoom(); });
  view->addSeparator();
  add_toggles(view);
  QAction* loupe = add_action(view, "", tr("&Loupe at the mouse") + "\tY", {}, [] {});
  loupe->setCheckable(true);
  loupe->setToolTip(tr("What is at the mouse, five times as large; Y shows it while it is held"));
  connect(loupe, &QAction::toggled, view_, &SceneView::set_loupe);
  slow_action_ = add_action(view, "", tr("&Slow near impacts"), QKeySequence(Qt::SHIFT | Qt::Key_I), [] {});
  slow_action_->setCheckable(true);
  slow_action_->setToolTip(
      tr("A twentieth of the speed from 50 ms before an impact to 50 ms after it (Shift+I)"));
  connect(slow_action_, &QAction::toggled, this, [this](bool on) {
    session_.runs().slow_near_impacts(on);
    chips_->say_slower(on);
    chips_->show_time(session_.runs());
  });
  view->addSeparator();
  inspector_action_ = add_action(view, "", tr("&Inspector"), QKeySequence(Qt::Key_I), [] {});
  inspector_action_->setCheckable(true);
  inspector_action_->setChecked(true);
  connect(inspector_action_, &QAction::toggled, docks_, &PanelDocks::show_inspector);
  connect(docks_, &PanelDocks::inspectorShown, inspector_action_, &QAction::setChecked);
  QAction* folded = add_action(view, "", tr("&Drawer"), QKeySequence(Qt::CTRL | Qt::Key_J), [] {});
  folded->setCheckable(true);
  folded->setChecked(true);
  connect(folded, &QAction::toggled, drawer_, [this](bool open) { drawer_->set_folded(!open); });
  connect(drawer_, &Drawer::foldedChanged, folded, [folded](bool now) { folded->setChecked(!now); });
  QMenu* tabs = view->addMenu(tr("&Tabs of the drawer"));
  const QStringList titles = drawer_->titles();
  for (int tab = 0; tab < titles.size(); ++tab) {
    add_action(tabs, "", titles[tab], QKeySequence(Qt::CTRL | static_cast<Qt::Key>(Qt::Key_1 + tab)),
               [this, tab] { drawer_->press(tab); });
  }
  const auto go = [this](bool forward) {
    focus_next_panel({list_, tool_column_, view_, transport_, drawer_, inspector_, plots_}, forward);
  };
  add_action(view, "", tr("Ne&xt panel"), QKeySequence(Qt::Key_F6), [go] { go(true); });
  add_action(view, "", tr("Pre&vious panel"), QKeySequence(Qt::SHIFT | Qt::Key_F6), [go] { go(false); });
  view->addMenu(plots_->menu());
  add_places_menu(view);
  left_action_ = add_action(view, "", tr("Panels at the &left"), QKeySequence(), [] {});
  left_action_->setCheckable(true);
  left_action_->setToolTip(tr("The inspector and the plots at the left of the scene"));
  connect(left_action_, &QAction::triggered, docks_, &PanelDocks::put_at_left);
  connect(docks_, &PanelDocks::docksChanged, left_action_,
          [this] { left_action_->setChecked(docks_->at_left()); });
  add_action(view, "", tr("&Standard layout"), QKeySequence(Qt::CTRL | Qt::Key_0),
             [this] { standard_layout(); });
  view->addSeparator();
  theme_action_ = add_action(view, "", {}, QKeySequence(), [this] {
    const Theme& next = theme_.dark ? light_theme() : dark_theme();
    theme_chosen_ = true;
    apply_theme(*qApp, next);
    set_theme(next);
  });
}

// What a drag of a panel's head does, for the keyboard.
void LabWindow::add_places_menu(QMenu* to) {
  const std::array<QString, PanelDocks::kDocks> places = {tr("At the &left"), tr("At the &right"),
                                                          tr("&Under the scene")};
  const std::array<QString, PanelDocks::kPanels> titles = {tr("&Inspector"), tr("&Plots"), tr("&Tables")};
  QMenu* menu = to->addMenu(tr("Pla&ces of the panels"));
  for (const auto panel : {PanelDocks::kInspector, PanelDocks::kPlots, PanelDocks::kDrawer}) {
    QMenu* of_panel = menu->addMenu(titles[panel]);
    const FloatingPanel& window = docks_->window_of(panel);
    for (const auto dock : {PanelDocks::kLeft, PanelDocks::kRight, PanelDocks::kBottom}) {
      QAction* action =
          add_action(of_panel, "", places[dock], {}, [this, panel, dock] { docks_->put(panel, dock); });
      action->setCheckable(true);
      connect(of_panel, &QMenu::aboutToShow, action, [this, action, panel, dock, &window] {
        action->setChecked(docks_->dock_of(panel) == dock && !window.floating());
      });
    }
    of_panel->addAction(window.action());
  }
}

void LabWindow::make_run_menus() {
  QMenu* run = menuBar()->addMenu(tr("&Run"));
  add_action(run, "", tr("&Play or pause"), QKeySequence(Qt::Key_Space),
             [this] { set_playing(frame() == nullptr || !frame()->playing); });
  add_action(run, "", tr("Play &on past the end"), QKeySequence(), [this] { session_.starts().play_on(); });
  add_action(run, "", tr("One &step"), QKeySequence(Qt::Key_Period), [this] { session_.starts().step_by(1); });
  add_action(run, "", tr("One step &back"), QKeySequence(Qt::Key_Comma),
             [this] { session_.starts().step_by(-1); });
  add_action(run, "", tr("&Faster"), QKeySequence(Qt::CTRL | Qt::Key_Period),
             [this] { transport_->change_speed(1); });
  add_action(run, "", tr("S&lower"), QKeySequence(Qt::CTRL | Qt::Key_Comma),
             [this] { transport_->change_speed(-1); });
  add_action(run, "", tr("&Next impact"), QKeySequence(Qt::Key_PageDown),
             [this] { session_.runs().go_by_impact(true); });
  add_action(run, "", tr("&Last impact"), QKeySequence(Qt::Key_PageUp),
             [this] { session_.runs().go_by_impact(false); });
  add_action(run, "", tr("S&tart of the record"), QKeySequence(Qt::Key_Home),
             [this] { session_.runs().go_to_start(); });
  add_action(run, "", tr("&End of the record"), QKeySequence(Qt::Key_End),
             [this] { session_.runs().show_end(); });
  QAction* go_on = add_action(run, "", tr("&Go on from here"), QKeySequence(Qt::Key_G),
                              [this] { session_.go_on_from_here(); });
  go_on->setToolTip(tr("What comes after the shown moment is dropped; undo brings it back"));
  connect(run, &QMenu::aboutToShow, this, [this, go_on] { go_on->setEnabled(session_.runs().in_past()); });
  connect(run, &QMenu::aboutToHide, go_on, [go_on] { go_on->setEnabled(true); });
  add_action(run, "", tr("Mark &A here"), QKeySequence(Qt::CTRL | Qt::Key_M), [this] {
    mark_shown_moment(false);
  })->setToolTip(tr("At the shown moment; in a plot a click sets it"));
  add_action(run, "", tr("Mark &B here"), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_M), [this] {
    mark_shown_moment(true);
  })->setToolTip(tr("At the shown moment; in a plot Shift and a click set it"));
  add_action(run, "flag", tr("Sto&ps..."), QKeySequence(Qt::Key_H), [this] { edit_stops(std::nullopt); });
  add_action(run, "", tr("&Restart"), QKeySequence(Qt::Key_R), [this] { session_.starts().restart(); });
  first_start_ = add_action(run, "", tr("&First start"), QKeySequence(Qt::CTRL | Qt::Key_R), [this] {
    session_.starts().go_to_first();
    if (preset().scene.bodies.empty())
      say_for_a_while(tr("The first start is empty; Ctrl+Z brings the bodies back."));
  });
  first_start_->setToolTip(tr("The experiment as it was opened or saved"));
  make_starts_menu(run);
  QMenu* methods = menuBar()->addMenu(tr("&Method"));
  methods_ = new MethodBar(methods, this);
  connect(methods_, &MethodBar::methodChosen, this,
          [this](const Method& method) { session_.methods().change(method); });
  methods->addSeparator();
  add_action(methods, "", tr("Compare &Euler, RK4 and the exact run"), QKeySequence(Qt::Key_C),
             [this] { compare_usual(); });
}

// All starts since the document was opened, also at the arrow beside the restart button; a tick marks the
// present one.
void LabWindow::make_starts_menu(QMenu* to) {
  QMenu* starts = to->addMenu(tr("S&tarts"));
  transport_->set_starts_menu(starts);
  connect(starts, &QMenu::aboutToShow, this, [this, starts] {
    starts->clear();
    for (const SessionStarts::Known& known : session_.starts().known()) {
      QAction* action = starts->addAction(QString(known.name).replace("&", "&&"), this,
                                          [this, known] { session_.starts().go_to(known); });
      action->setCheckable(true);
      action->setChecked(known.start == nullptr);
    }
  });
}

// Of the chip that names a new start.
void LabWindow::make_start_chip_menu() {
  auto* menu = new QMenu(chips_->start_chip());
  chips_->start_chip()->setMenu(menu);
  menu->addAction(undo_);
  menu->setToolTipsVisible(true);
  QAction* before = menu->addAction(tr("&Put the edit into the start before instead"), this, [this] {
    view_->hold_arrows();
    session_.starts().put_into_start_before();
  });
  connect(menu, &QMenu::aboutToShow, this, [this, before] {
    const QString why_not = session_.starts().why_not_into_start_before();
    before->setEnabled(why_not.isEmpty());
    before->setToolTip(why_not);
  });
  menu->addAction(first_start_);
}

void LabWindow::make_help_menu() {
  QMenu* help = menuBar()->addMenu(tr("&Help"));
  add_action(help, "help", tr("&Help pages"), QKeySequence::HelpContents,
             [this] { show_help(this, keys_page(*menuBar())); });
  add_action(help, "", tr("&Keys"), Qt::Key_Question,
             [this] { show_help(this, keys_page(*menuBar()), HelpPage::kKeys); });
  add_action(help, "", tr("&About Carom"), QKeySequence(), [this] {
    show_message(this, tr("About Carom"), tr("Carom %1").arg(CAROM_VERSION),
                 tr("A lab for two-dimensional rigid-body collisions.\n\n"
                    "MIT licence. Plots by Qwt (Qwt licence), window by Qt (LGPL)."));
  });
}

}  // namespace carom
