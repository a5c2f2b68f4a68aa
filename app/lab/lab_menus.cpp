#include <QAction>
#include <QActionGroup>
#include <QApplication>
#include <QMenu>
#include <QMenuBar>
#include <QToolBar>
#include <QToolButton>
#include <array>

#include "app/help/help_dialog.h"
#include "app/lab/lab_window.h"
#include "physics/dynamics/integrators/integrators.h"
#include "widgets/plot/plot_panel.h"
#include "widgets/scene/scene_view.h"
#include "widgets/theme/number_text.h"
#include "widgets/theme/plain_text.h"

// The menus and the tool bar of the lab's window.
namespace carom {
namespace {

QString text_of(std::string_view s) { return QString::fromUtf8(s.data(), static_cast<int>(s.size())); }

// Steps to choose from, in s.
constexpr std::array kSteps = {0.0001, 0.0002, 0.0005, 0.001, 0.002, 0.005, 0.01, 0.02, 0.05};
// Tolerances of the adaptive integrator to choose from, in m and m/s.
constexpr std::array kTolerances = {1e-2, 1e-3,  1e-4,  1e-5,  1e-6,  1e-7, 1e-8,
                                    1e-9, 1e-10, 1e-11, 1e-12, 1e-13, 1e-14};

}  // namespace

void LabWindow::make_actions() {
  theme_action_ = new QAction(this);
  connect(theme_action_, &QAction::triggered, this, [this] {
    const Theme& next = theme_.dark ? light_theme() : dark_theme();
    apply_theme(*qApp, next);
    set_theme(next);
  });
}

void LabWindow::make_menus() {
  const auto add = [this](QMenu* menu, const QString& icon, const QString& text, const QKeySequence& key,
                          auto&& slot) {
    auto* action = menu->addAction(text);
    action->setShortcut(key);
    if (!icon.isEmpty()) icon_actions_.emplace_back(action, icon);
    connect(action, &QAction::triggered, this, slot);
    return action;
  };
  QMenu* file = menuBar()->addMenu(tr("&File"));
  add(file, "open", tr("&Open..."), QKeySequence::Open, [this] { choose_file(); });
  add(file, "save", tr("&Save"), QKeySequence::Save, [this] { save(); });
  add(file, "", tr("Save &as..."), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_S), [this] { saveAs(); });
  add(file, "", tr("Save the &run as it stands..."), QKeySequence(), [this] { save_run(); });
  file->addSeparator();
  add(file, "", tr("Save the &picture of the scene..."), QKeySequence(), [this] { save_scene_picture(); });
  add(file, "", tr("&Copy the picture of the scene"), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_C),
      [this] { copy_scene_picture(); });
  add(file, "", tr("&Film..."), QKeySequence(), [this] { make_film(); });
  add(file, "", tr("Save &data..."), QKeySequence(Qt::CTRL | Qt::Key_E), [this] { save_data(nullptr); });
  add(file, "", tr("&Lab report..."), QKeySequence(Qt::CTRL | Qt::Key_L), [this] { make_report(); });
  file->addSeparator();
  add(file, "", tr("&Quit"), QKeySequence::Quit, [this] { close(); });

  QMenu* edit = menuBar()->addMenu(tr("&Edit"));
  QAction* undo = session_.edits().createUndoAction(this, tr("&Undo"));
  undo->setShortcut(QKeySequence(Qt::CTRL | Qt::Key_Z));
  QAction* redo = session_.edits().createRedoAction(this, tr("&Redo"));
  redo->setShortcut(QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Z));
  edit->addActions({undo, redo});

  QMenu* view = menuBar()->addMenu(tr("&View"));
  add(view, "fit", tr("&Fit the scene"), QKeySequence(Qt::Key_F), [this] { view_->fit(); });
  add(view, "", tr("&Reset the plots' zoom"), QKeySequence(Qt::Key_Home), [this] { plots_->reset_zoom(); });
  view->addSeparator();
  struct Toggle {
    const char* icon;
    const char* text;
    const char* tip;
    bool DrawingOptions::*flag;
  };
  constexpr std::array<Toggle, 5> kToggles = {{
      {"grid", "&Grid", "Grid in metres", &DrawingOptions::grid},
      {"velocity", "&Velocities", "Arrows of the velocities", &DrawingOptions::velocities},
      {"", "F&orces", "Applied forces and torques", &DrawingOptions::forces},
      {"contact", "&Contacts", "Impulses of the newest impacts; forces in N of contacts that last",
       &DrawingOptions::contacts},
      {"names", "&Names", "Names of the bodies", &DrawingOptions::names},
  }};
  for (const Toggle& toggle : kToggles) {
    const auto flag = toggle.flag;
    QAction* action = add(view, toggle.icon, tr(toggle.text), QKeySequence(), [] {});
    action->setToolTip(tr(toggle.tip));
    action->setCheckable(true);
    action->setChecked(view_->options().*flag);
    connect(action, &QAction::toggled, this, [this, flag](bool on) {
      DrawingOptions options = view_->options();
      options.*flag = on;
      view_->set_options(options);
    });
  }
  view->addSeparator();
  view->addMenu(plots_->menu());
  view->addSeparator();
  view->addAction(theme_action_);

  QMenu* run = menuBar()->addMenu(tr("&Run"));
  add(run, "", tr("&Play or pause"), QKeySequence(Qt::Key_Space),
      [this] { set_playing(frame() == nullptr || !frame()->playing); });
  add(run, "", tr("One &step"), QKeySequence(Qt::Key_Period), [this] { session_.step_once(); });
  add(run, "", tr("&Restart"), QKeySequence(Qt::Key_R), [this] { session_.restart(); });

  QMenu* methods = menuBar()->addMenu(tr("&Method"));
  const auto add_choices = [this, methods](const QString& title, const auto& table, auto member) {
    QMenu* menu = methods->addMenu(title);
    menu->setToolTipsVisible(true);
    auto* group = new QActionGroup(menu);
    for (const auto& choice : table) {
      QAction* action = menu->addAction(text_of(choice.label));
      action->setToolTip(text_of(choice.tip));
      action->setData(static_cast<int>(choice.id));
      action->setCheckable(true);
      group->addAction(action);
      connect(action, &QAction::triggered, this, [this, member, id = choice.id] {
        Method method = preset().method;
        method.*member = id;
        session_.change_method(method);
      });
      connect(menu, &QMenu::aboutToShow, action,
              [this, action, member, id = choice.id] { action->setChecked(preset().method.*member == id); });
    }
    return menu;
  };
  const auto button = [this](QMenu* menu, const QString& tip) {
    auto* b = new QToolButton(this);
    b->setObjectName("choice");
    b->setPopupMode(QToolButton::InstantPopup);
    b->setMenu(menu);
    b->setToolTip(tip);
    return b;
  };
  integrators_ = add_choices(tr("&Integrator"), kIntegrators, &Method::integrator);
  integrator_button_ = button(integrators_, tr("How free motion is advanced; holds from now on"));
  impacts_button_ = button(add_choices(tr("&Impacts"), kImpacts, &Method::impacts),
                           tr("When impacts are resolved; holds from now on"));
  contacts_button_ = button(add_choices(tr("&Contacts"), kContacts, &Method::contacts),
                            tr("What holds bodies that touch; holds from now on"));
  steps_ = methods->addMenu(tr("&Step"));
  for (const double step : kSteps) {
    steps_->addAction(QString("h = %1 ms").arg(1e3 * step, 0, 'g', 4), this, [this, step] {
      Method method = preset().method;
      method.step = step;
      session_.change_method(method);
    });
  }
  steps_->addSeparator();
  steps_->addAction(tr("Another..."), this, [this] { choose_step(); });
  tolerances_ = methods->addMenu(tr("&Tolerance"));
  for (const double tolerance : kTolerances) {
    tolerances_->addAction(tr("tolerance %1").arg(short_figure(tolerance)), this, [this, tolerance] {
      Method method = preset().method;
      method.tolerance = tolerance;
      session_.change_method(method);
    });
  }
  methods->addSeparator();
  add(methods, "", tr("Compare &Euler, RK4 and the exact run"), QKeySequence(Qt::Key_C),
      [this] { compare_usual(); });
  step_button_ = button(steps_, {});
  plots_button_ = button(plots_->menu(), tr("Which plots are shown"));
  plots_button_->setText(tr("Plots") + QStringLiteral(" ▾"));

  QMenu* help = menuBar()->addMenu(tr("&Help"));
  add(help, "help", tr("&Help pages"), QKeySequence::HelpContents, [this] { show_help(this); });
  add(help, "", tr("&About Carom"), QKeySequence(), [this] {
    tell(this, tr("About Carom"), tr("Carom %1").arg(CAROM_VERSION),
         tr("A lab for two-dimensional rigid-body collisions.\n\n"
            "MIT licence. Plots by Qwt (Qwt licence), window by Qt (LGPL)."));
  });
}

void LabWindow::make_tool_bar() {
  QToolBar* bar = tool_bar_ = addToolBar(tr("Tools"));
  bar->installEventFilter(this);
  bar->setMovable(false);
  bar->setContextMenuPolicy(Qt::PreventContextMenu);
  bar->setIconSize({18, 18});
  const auto add = [&](const QString& icon) {
    for (const auto& [action, name] : icon_actions_) {
      if (name == icon) bar->addAction(action);
    }
  };
  for (const char* icon : {"open", "save"}) add(icon);
  bar->addSeparator();
  for (const char* icon : {"fit", "grid", "velocity", "contact", "names"}) add(icon);
  bar->addSeparator();
  for (QToolButton* choice : {integrator_button_, impacts_button_, contacts_button_, step_button_}) {
    bar->addWidget(choice);
    auto* gap = new QWidget;
    gap->setFixedWidth(4);
    bar->addWidget(gap);
  }
  auto* stretch = new QWidget;
  stretch->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
  bar->addWidget(stretch);
  bar->addWidget(plots_button_);
  auto* gap = new QWidget;
  gap->setFixedWidth(4);
  bar->addWidget(gap);
  add("help");
  bar->addAction(theme_action_);
  setContextMenuPolicy(Qt::NoContextMenu);
  set_theme(theme_);
}

}  // namespace carom
