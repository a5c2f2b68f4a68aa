#include <QAction>
#include <QActionGroup>
#include <QApplication>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>
#include <QPainter>
#include <QScrollArea>
#include <QScrollBar>
#include <QSplitter>
#include <QStatusBar>
#include <QTabWidget>
#include <QToolBar>
#include <QToolButton>
#include <QVBoxLayout>

#include "app/help_dialog.h"
#include "app/lab_window.h"
#include "app/preset_library.h"
#include "physics/motion/integrators.h"
#include "physics/preset/preset.h"
#include "widgets/experiment_list.h"
#include "widgets/ledger_table.h"
#include "widgets/number_text.h"
#include "widgets/plot_panel.h"
#include "widgets/run_tables.h"
#include "widgets/scene_thumbnail.h"
#include "widgets/scene_view.h"
#include "widgets/transport_bar.h"

// What stands where in the lab's window.
namespace carom {
namespace {

QString text_of(std::string_view s) { return QString::fromUtf8(s.data(), static_cast<int>(s.size())); }

// Steps to choose from, in s.
constexpr std::array kSteps = {0.0001, 0.0002, 0.0005, 0.001, 0.002, 0.005, 0.01, 0.02, 0.05};
// Tolerances of the adaptive integrator to choose from, in m and m/s.
constexpr std::array kTolerances = {1e-2, 1e-3,  1e-4,  1e-5,  1e-6,  1e-7, 1e-8,
                                    1e-9, 1e-10, 1e-11, 1e-12, 1e-13, 1e-14};

QWidget* with_frame(QWidget* inside, int margin) {
  auto* frame = new QFrame;
  frame->setObjectName("panel");
  auto* column = new QVBoxLayout(frame);
  column->setContentsMargins(margin, margin, margin, margin);
  column->addWidget(inside);
  return frame;
}

// Scrolls upright only: as wide as what it holds.
class PlotArea : public QScrollArea {
 public:
  [[nodiscard]] QSize minimumSizeHint() const override {
    const int bar = verticalScrollBar()->sizeHint().width();
    return {widget() == nullptr ? 0 : widget()->minimumSizeHint().width() + bar, 0};
  }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override {
    if (watched == widget() && event->type() == QEvent::LayoutRequest) updateGeometry();
    return QScrollArea::eventFilter(watched, event);
  }
};

}  // namespace

void LabWindow::make_actions() {
  theme_action_ = new QAction(this);
  connect(theme_action_, &QAction::triggered, this, [this] {
    const Theme& next = theme_.dark ? light_theme() : dark_theme();
    apply_theme(*qApp, next);
    set_theme(next);
  });
}

void LabWindow::make_body() {
  auto* middle = new QWidget;
  middle->setObjectName("window");
  auto* row = new QHBoxLayout(middle);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(0);

  list_ = new ExperimentList(theme_);
  list_->setFixedWidth(240);
  row->addWidget(list_);

  view_ = new SceneView(theme_);
  transport_ = new TransportBar(theme_);
  bodies_ = new BodiesTable;
  impacts_ = new ImpactsTable;
  ledger_ = new LedgerTable;
  about_ = new QLabel;
  about_->setWordWrap(true);
  about_->setTextFormat(Qt::RichText);
  about_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  about_->setContentsMargins(4, 4, 12, 8);
  about_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  auto* about_area = new QScrollArea;
  about_area->setWidget(about_);
  about_area->setWidgetResizable(true);
  about_area->setFrameShape(QFrame::NoFrame);
  about_area->setStyleSheet("QScrollArea, QScrollArea > QWidget > QWidget { background: transparent; }");
  tabs_ = new QTabWidget;
  tabs_->addTab(bodies_, tr("Before and after"));
  tabs_->addTab(impacts_, tr("Impacts"));
  tabs_->addTab(ledger_, tr("Ledger"));
  tabs_->addTab(about_area, tr("About"));
  connect(tabs_, &QTabWidget::currentChanged, this, [this] {
    if (frame_ != nullptr) show_frame();
  });

  auto* drawer = with_frame(tabs_, 0);
  drawer->layout()->setContentsMargins(12, 4, 12, 8);
  auto* centre = new QSplitter(Qt::Vertical);
  centre->setHandleWidth(8);
  auto* scene = new QWidget;
  auto* scene_column = new QVBoxLayout(scene);
  scene_column->setContentsMargins(0, 0, 0, 0);
  scene_column->setSpacing(8);
  scene_column->addWidget(with_frame(view_, 1), 1);
  scene_column->addWidget(transport_);
  centre->addWidget(scene);
  centre->addWidget(drawer);
  centre->setStretchFactor(0, 3);
  centre->setStretchFactor(1, 1);
  centre->setSizes({540, 190});
  centre->setChildrenCollapsible(false);

  plots_ = new PlotPanel(theme_);
  auto* columns = new QSplitter(Qt::Horizontal);
  columns->setHandleWidth(8);
  columns->addWidget(centre);
  // More plots than the height shows well are scrolled.
  auto* plot_area = new PlotArea;
  plot_area->setWidget(plots_);
  plot_area->setWidgetResizable(true);
  plot_area->setFrameShape(QFrame::NoFrame);
  plot_area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  plot_area->setStyleSheet("QScrollArea, QScrollArea > QWidget > QWidget { background: transparent; }");
  columns->addWidget(plot_area);
  // Both keep their share of the window's width.
  columns->setStretchFactor(0, 616);
  columns->setStretchFactor(1, 392);
  columns->setSizes({616, 392});
  columns->setChildrenCollapsible(false);
  auto* inner = new QHBoxLayout;
  inner->setContentsMargins(8, 8, 8, 8);
  inner->addWidget(columns);
  row->addLayout(inner, 1);
  setCentralWidget(middle);

  // Chips over the scene: time, speed and what is modelled; below, what the run has to say.
  chips_ = new QWidget(view_);
  auto* chips = new QHBoxLayout(chips_);
  chips->setContentsMargins(0, 0, 0, 0);
  chips->setSpacing(6);
  for (QLabel** chip : {&time_chip_, &speed_chip_, &needs_chip_}) {
    *chip = new QLabel(chips_);
    (*chip)->setObjectName("chip");
    chips->addWidget(*chip);
  }
  needs_chip_->setAccessibleName(tr("What is modelled"));
  status_chip_ = new QLabel(view_);
  status_chip_->setObjectName("chip");
  time_chip_->setStyleSheet("font-weight: bold;");
  speed_chip_->setToolTip(tr("Simulated seconds per second"));
  status_chip_->hide();
  view_->installEventFilter(this);

  position_ = new QLabel(view_);
  position_->setObjectName("caption");
  connect(view_, &SceneView::cursorMoved, this, [this](double x, double y) {
    position_->setText(
        QString("x = %1 m, y = %2 m").arg(x, 0, 'f', 3).arg(y, 0, 'f', 3).replace('-', QChar(0x2212)));
    position_->show();
    place_chips();
  });
  connect(view_, &SceneView::cursorLeft, position_, &QLabel::hide);
  connect(view_, &SceneView::spawnRequested, this, &LabWindow::spawn);
  connect(list_, &ExperimentList::openRequested, this,
          [this](const QString& name) { open(name.toStdString()); });
  connect(transport_, &TransportBar::playClicked, this, &LabWindow::set_playing);
  connect(transport_, &TransportBar::restartClicked, this, [this] { worker_->restart(); });
  connect(transport_, &TransportBar::stepClicked, this, [this] { worker_->step_once(); });
  connect(transport_, &TransportBar::speedChosen, this, [this](double speed) {
    speed_ = speed;
    worker_->set_speed(speed);
    if (frame_ != nullptr) show_frame();
  });
}

bool LabWindow::eventFilter(QObject* watched, QEvent* event) {
  if (watched == view_ && event->type() == QEvent::Resize) place_chips();
  if (watched == tool_bar_ && event->type() == QEvent::Resize) show_method();
  return QMainWindow::eventFilter(watched, event);
}

void LabWindow::place_chips() {
  constexpr int kEdge = 10;       // px
  constexpr int kGap = 6;         // px between chips
  constexpr int kPadding = 22;    // px, of a chip's text left and right, with its border
  constexpr int kLeastRoom = 60;  // px
  const auto elide = [&](QLabel* chip, const QString& text, int room) {
    chip->setText(chip->fontMetrics().elidedText(text, Qt::ElideRight, std::max(room, kLeastRoom) - kPadding));
  };
  const int before = time_chip_->sizeHint().width() + speed_chip_->sizeHint().width() + 2 * kGap;
  elide(needs_chip_, needs_, view_->width() - 2 * kEdge - before);
  chips_->adjustSize();
  chips_->move(kEdge, kEdge);
  chips_->raise();
  const int second_row = kEdge + chips_->height() + kGap;
  position_->adjustSize();
  position_->move(view_->width() - position_->width() - kEdge - 2, second_row + 4);
  position_->raise();
  elide(status_chip_, status_, view_->width() - 3 * kEdge - (position_->isVisible() ? position_->width() : 0));
  status_chip_->adjustSize();
  status_chip_->move(kEdge, second_row);
  status_chip_->raise();
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
  file->addSeparator();
  add(file, "", tr("&Quit"), QKeySequence::Quit, [this] { close(); });

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
      [this] { set_playing(frame_ == nullptr || !frame_->playing); });
  add(run, "", tr("One &step"), QKeySequence(Qt::Key_Period), [this] { worker_->step_once(); });
  add(run, "", tr("&Restart"), QKeySequence(Qt::Key_R), [this] { worker_->restart(); });

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
        Method method = worker_->scene().method;
        method.*member = id;
        change_method(method);
      });
      connect(menu, &QMenu::aboutToShow, action, [this, action, member, id = choice.id] {
        action->setChecked(worker_->scene().method.*member == id);
      });
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
      Method method = worker_->scene().method;
      method.step = step;
      change_method(method);
    });
  }
  steps_->addSeparator();
  steps_->addAction(tr("Another..."), this, [this] { choose_step(); });
  tolerances_ = methods->addMenu(tr("&Tolerance"));
  for (const double tolerance : kTolerances) {
    tolerances_->addAction(tr("tolerance %1").arg(short_figure(tolerance)), this, [this, tolerance] {
      Method method = worker_->scene().method;
      method.tolerance = tolerance;
      change_method(method);
    });
  }
  step_button_ = button(steps_, {});
  plots_button_ = button(plots_->menu(), tr("Which plots are shown"));
  plots_button_->setText(tr("Plots") + QStringLiteral(" ▾"));

  QMenu* help = menuBar()->addMenu(tr("&Help"));
  add(help, "help", tr("&Help pages"), QKeySequence::HelpContents, [this] { show_help(this); });
  add(help, "", tr("&About Carom"), QKeySequence(), [this] {
    QMessageBox::about(this, tr("About Carom"),
                       tr("<b>Carom %1</b><p>A lab for two-dimensional rigid-body collisions.</p>"
                          "<p>MIT licence. Plots by Qwt (Qwt licence), window by Qt (LGPL).</p>")
                           .arg(CAROM_VERSION));
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

void LabWindow::set_theme(const Theme& theme) {
  theme_ = theme;
  for (const auto& [action, icon] : icon_actions_) action->setIcon(themed_icon(icon, theme.text));
  theme_action_->setIcon(themed_icon(theme.dark ? "sun" : "moon", theme.text));
  theme_action_->setText(theme.dark ? tr("&Light colours") : tr("&Dark colours"));
  list_->set_theme(theme);
  view_->set_theme(theme);
  transport_->set_theme(theme);
  plots_->set_theme(theme);
  draw_thumbnails();
}

void LabWindow::fill_library() {
  std::vector<ExperimentItem> items;
  for (const LibraryEntry& entry : preset_library()) {
    try {
      const Scene scene = read_preset(entry.file);
      items.push_back({QString::fromStdString(entry.name), QString::fromStdString(entry.topic),
                       QString::fromStdString(scene.title), QString::fromStdString(scene.observe)});
    } catch (const SceneError& error) {
      items.push_back({QString::fromStdString(entry.name), QString::fromStdString(entry.topic),
                       QString::fromStdString(entry.name), QString::fromStdString(error.what())});
    }
  }
  list_->set_items(std::move(items));
  draw_thumbnails();
}

void LabWindow::draw_thumbnails() {
  std::vector<QPixmap> pictures;
  for (const LibraryEntry& entry : preset_library()) {
    QPixmap picture;
    try {
      const Scene scene = read_preset(entry.file);
      const Simulation simulation(scene);
      Frame frame;
      take_moment(simulation, frame);
      frame.bodies = std::make_shared<const std::vector<Body>>(simulation.bodies());
      frame.forces = std::make_shared<const Forces>(scene.forces);
      picture = scene_thumbnail(frame, theme_, {52, 36}, devicePixelRatioF());
    } catch (const SceneError&) {
      picture = QPixmap();
    }
    pictures.push_back(picture);
  }
  list_->set_pictures(pictures);
}

}  // namespace carom
