#include <QAction>
#include <QHBoxLayout>
#include <QLabel>
#include <QTimer>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

#include "app/lab/document_files.h"
#include "app/lab/drawer.h"
#include "app/lab/floating_panel.h"
#include "app/lab/lab_window.h"
#include "app/lab/method_bar.h"
#include "app/lab/notice_bar.h"
#include "app/lab/panel_docks.h"
#include "app/lab/scrolled.h"
#include "app/library/library_items.h"
#include "physics/scene/validate.h"
#include "widgets/compare/compare_panel.h"
#include "widgets/compare/study_panel.h"
#include "widgets/edit/bodies_sheet.h"
#include "widgets/edit/inspector.h"
#include "widgets/plot/plot_panel.h"
#include "widgets/plot/reading_table.h"
#include "widgets/plot/run_plot.h"
#include "widgets/run/before_after_panel.h"
#include "widgets/run/experiment_list.h"
#include "widgets/run/experiment_preview.h"
#include "widgets/run/impacts_panel.h"
#include "widgets/run/ledger_table.h"
#include "widgets/run/transport_bar.h"
#include "widgets/scene/scene_view.h"

// The layout of the lab's window.
namespace carom {
namespace {

constexpr int kListWidth = 256;           // px, as a column
constexpr int kOpenListWidth = 340;       // px, over the scene
constexpr int kGap = 8;                   // px, between panels
constexpr QSize kStackedFrom(1200, 720);  // px: a window that has room for the inspector over the plots
constexpr int kPinnedFrom = 1600;         // px: width of a window that has room for the list beside the scene

QWidget* with_frame(QWidget* inside, int margin) {
  auto* frame = new QFrame;
  frame->setObjectName("panel");
  auto* column = new QVBoxLayout(frame);
  column->setContentsMargins(margin, margin, margin, margin);
  column->addWidget(inside);
  return frame;
}

}  // namespace

void LabWindow::make_body() {
  auto* all = new QWidget;
  all->setObjectName("window");
  auto* row = new QHBoxLayout(all);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(0);
  list_ = new ExperimentList(theme_, all);
  list_->hide();

  make_docks();
  preview_ = new ExperimentPreview(*list_, view_->parentWidget());
  restore_bar_ = new NoticeBar;
  lost_bar_ = new NoticeBar;
  auto* inner = new QVBoxLayout;
  inner->setContentsMargins(kGap, kGap, kGap, kGap);
  inner->setSpacing(kGap);
  inner->addWidget(restore_bar_);
  inner->addWidget(lost_bar_);
  inner->addWidget(docks_, 1);
  row->addLayout(inner, 1);
  setCentralWidget(all);
}

// A wide window has room for the list as a column. Else it opens over the scene, and closes once an experiment
// is chosen.
bool LabWindow::list_pinned() const { return width() >= kPinnedFrom && pin_action_->isChecked(); }

void LabWindow::place_list() {
  QWidget* all = centralWidget();
  auto* row = static_cast<QHBoxLayout*>(all->layout());
  pin_action_->setEnabled(width() >= kPinnedFrom);
  const bool pinned = list_pinned();
  const bool was_pinned = row->indexOf(list_) >= 0;
  list_action_->setCheckable(!pinned);  // there it stays, and its search is gone to
  name_in_bar_->setVisible(!pinned);
  list_->set_over(!pinned);
  list_->setFixedWidth(pinned ? kListWidth : kOpenListWidth);
  if (pinned && !was_pinned) {
    row->insertWidget(0, list_);
    list_->show();
  } else if (!pinned && was_pinned) {
    row->removeWidget(list_);
    list_->hide();
    list_action_->setChecked(false);
  }
  if (!pinned) list_->setGeometry(kGap, 0, kOpenListWidth, all->height() - kGap);
  list_->raise();
}

void LabWindow::open_list(bool open) {
  const bool pinned = list_pinned();
  list_->setVisible(open || pinned);
  if (open) {
    place_list();
    list_->begin_search();
    return;
  }
  leave_preview();
  if (!pinned) view_->setFocus(Qt::ShortcutFocusReason);
}

void LabWindow::close_list() {
  list_action_->setChecked(false);
  leave_preview();
}

void LabWindow::leave_preview() {
  preview_->hide();
  list_->set_current(session_.name());
}

// Over what the list leaves of the scene.
void LabWindow::place_preview() {
  const int list = list_pinned() ? 0 : list_->geometry().right() + 1;
  const int left = view_->parentWidget()->mapFrom(centralWidget(), QPoint(list, 0)).x();
  preview_->setGeometry(view_->geometry().adjusted(std::max(left - view_->x(), 0), 0, 0, 0));
}

void LabWindow::resizeEvent(QResizeEvent* event) {
  QMainWindow::resizeEvent(event);
  preview_->hide();
  // Once the tool bar has its new width.
  QTimer::singleShot(0, this, [this] { methods_->show_document(preset()); });
  place_list();
  // A small window has room for the inspector or the plots, but not for both.
  docks_->set_tabbed(width() < kStackedFrom.width() || height() < kStackedFrom.height());
}

QWidget* LabWindow::make_scene() {
  view_ = new SceneView(theme_);
  transport_ = new TransportBar(theme_);
  auto* scene = new QWidget;
  auto* column = new QVBoxLayout(scene);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(kGap);
  auto* row = new QHBoxLayout;
  row->setSpacing(kGap);
  row->addWidget(make_tool_column());
  row->addWidget(with_frame(view_, 1), 1);
  column->addLayout(row, 1);
  column->addWidget(transport_);
  return scene;
}

// Inspector and plots scroll if they are too tall for their place.
void LabWindow::make_docks() {
  QWidget* scene = make_scene();
  make_drawer();
  inspector_ = new Inspector;
  plots_ = new PlotPanel(theme_);
  auto* inspector = scrolled<TallArea>(inspector_);
  auto* plots = scrolled<TallArea>(plots_);
  for (QScrollArea* area : {inspector, plots}) area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  // Once it is laid out: the scrolled widget grows after the plot has its size.
  connect(plots_, &PlotPanel::plotAdded, plots, [plots](RunPlot* added) {
    const auto show = [plots, added] { plots->ensureWidgetVisible(added); };
    QTimer::singleShot(0, added, [added, show] { QTimer::singleShot(0, added, show); });
  });
  docks_ = new PanelDocks(scene, with_frame(inspector, 1), plots, drawer_);
  for (const auto panel : {PanelDocks::kInspector, PanelDocks::kPlots, PanelDocks::kDrawer})
    icon_actions_.emplace_back(docks_->window_of(panel).action(), "float");
  const auto anywhere = [](const QPoint&) { return true; };
  const auto add_button = [&](PanelDocks::Panel panel) {
    QToolButton* button = docks_->window_of(panel).make_button();
    docks_->add_head(panel, button, anywhere);
    return button;
  };
  inspector_->add_to_head(add_button(PanelDocks::kInspector));
  drawer_->add_corner(add_button(PanelDocks::kDrawer));
  docks_->add_head(PanelDocks::kInspector, inspector_->head(), anywhere);
  docks_->add_head(PanelDocks::kPlots, plots_, [this](const QPoint& at) { return plots_->in_head(at); });
  docks_->add_head(PanelDocks::kDrawer, drawer_, [this](const QPoint& at) { return drawer_->in_head(at); });
}

void LabWindow::make_drawer() {
  about_ = new QLabel;
  about_->setWordWrap(true);
  about_->setTextFormat(Qt::RichText);
  about_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  about_->setContentsMargins(4, 4, 12, 8);
  about_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  drawer_ = new Drawer;
  drawer_->add(sheet_ = new BodiesSheet(theme_), tr("Bodies"));
  drawer_->add(before_after_ = new BeforeAfterPanel, tr("Before and after"));
  drawer_->add(impacts_ = new ImpactsPanel, tr("Impacts"));
  drawer_->add(ledger_ = new LedgerTable, tr("Ledger"));
  drawer_->add(reading_ = new ReadingTable, tr("Reading"));
  drawer_->add(compare_ = new ComparePanel(theme_), tr("Compare"));
  drawer_->add(study_ = new StudyPanel(theme_), tr("Study"));
  drawer_->add(scrolled<QScrollArea>(about_), tr("About"));
}

void LabWindow::connect_views() {
  connect(study_, &StudyPanel::methodChosen, this, [this](const Method& method) {
    const std::vector<Method>& others = preset().compare;
    const bool there =
        preset().method == method || std::find(others.begin(), others.end(), method) != others.end();
    if (!there) session_.methods().add(method);
  });
  connect(compare_, &ComparePanel::methodAdded, &session_.methods(), &MethodEdits::add);
  connect(compare_, &ComparePanel::methodRemoved, &session_.methods(), &MethodEdits::remove);
  connect(compare_, &ComparePanel::methodChanged, &session_.methods(), &MethodEdits::change);
  connect(compare_, &ComparePanel::stepChanged, &session_.methods(), &MethodEdits::change_step);
  connect(compare_, &ComparePanel::referenceChosen, &session_.methods(), &MethodEdits::choose_reference);
  connect(compare_, &ComparePanel::usualAsked, this, &LabWindow::compare_usual);
  connect(drawer_, &Drawer::pageChanged, this, &LabWindow::show_frame);
  connect(plots_, &PlotPanel::layoutChanged, this, [this] {
    session_.change_plots(plots_->chosen());
    session_.runs().record(plots_->curves());
  });
  connect_marks();
  connect(lost_bar_, &NoticeBar::accepted, &session_.starts(), &SessionStarts::restart);
  connect(lost_bar_, &NoticeBar::dismissed, this, [this] {
    lost_bar_->hide();
    show_notices();
  });
  connect(list_, &ExperimentList::openRequested, files_, [this](const QString& name) {
    close_list();
    view_->setFocus(Qt::ShortcutFocusReason);  // a list that stays had it
    files_->open(name.toStdString());
  });
  connect(list_, &ExperimentList::previewRequested, this, &LabWindow::preview);
  connect(list_, &ExperimentList::closeRequested, this, &LabWindow::close_list);
  connect(list_, &ExperimentList::newRequested, this, [this] {
    close_list();
    new_document();
  });
  connect(list_, &ExperimentList::fileRequested, this, [this] {
    close_list();
    files_->choose();
  });
  connect(preview_, &ExperimentPreview::chosen, list_, &ExperimentList::open_marked);
  connect(preview_, &ExperimentPreview::left, this, &LabWindow::leave_preview);
  connect(transport_, &TransportBar::playClicked, this, &LabWindow::set_playing);
  connect(transport_, &TransportBar::restartClicked, &session_.starts(), &SessionStarts::restart);
  connect(transport_, &TransportBar::stepClicked, &session_.starts(), &SessionStarts::step_by);
  connect_timeline();
  connect(transport_, &TransportBar::speedChosen, this, [this](double speed) {
    session_.runs().set_speed(speed);
    show_frame();
  });
}

void LabWindow::connect_timeline() {
  LabRuns& runs = session_.runs();
  Timeline* timeline = &transport_->timeline();
  connect(timeline, &Timeline::scrubBegan, &scrubbing_, &Scrubbing::begin);
  connect(timeline, &Timeline::scrubbed, &scrubbing_, &Scrubbing::to);
  connect(timeline, &Timeline::scrubEnded, &scrubbing_, &Scrubbing::end);
  connect(plots_, &PlotPanel::scrubBegan, &scrubbing_, &Scrubbing::begin);
  connect(plots_, &PlotPanel::scrubbed, &scrubbing_, &Scrubbing::to);
  connect(plots_, &PlotPanel::scrubEnded, &scrubbing_, &Scrubbing::end);
  connect(timeline, &Timeline::timeTyped, &runs, &LabRuns::go_to);
  connect(timeline, &Timeline::impactOpened, this, [this](double time) {
    drawer_->set_folded(false);
    drawer_->choose(impacts_);
    show_frame();
    impacts_->table().show_impact(time);
  });
  connect(timeline, &Timeline::impactChosen, &runs, &LabRuns::go_to_impact);
  connect(timeline, &Timeline::impactAsked, &runs, &LabRuns::go_by_impact);
  connect(&impacts_->table(), &ImpactsTable::impactChosen, &runs, &LabRuns::go_to_impact);
  connect(impacts_, &ImpactsPanel::filterChanged, this, &LabWindow::show_frame);
  connect(view_, &SceneView::impactChosen, &runs, &LabRuns::go_to_impact);
  connect(plots_, &PlotPanel::impactChosen, &runs, &LabRuns::go_to_impact);
  connect(before_after_, &BeforeAfterPanel::impactAsked, &runs, &LabRuns::go_by_impact);
  connect(before_after_, &BeforeAfterPanel::choiceChanged, this, &LabWindow::show_frame);
  connect(&impacts_->table(), &QTableView::doubleClicked, this, [this] {
    before_after_->choose(BeforeAfterPanel::Choice::kThis);
    drawer_->choose(before_after_);
  });
}

void LabWindow::set_theme(const Theme& theme) {
  theme_ = theme;
  for (const auto& [action, icon] : icon_actions_) action->setIcon(themed_icon(icon, theme.text));
  list_button_->setIcon(themed_icon("list", theme.text));
  theme_action_->setIcon(themed_icon(theme.dark ? "sun" : "moon", theme.text));
  theme_action_->setText(theme.dark ? tr("&Light colours") : tr("&Dark colours"));
  list_->set_theme(theme);
  view_->set_theme(theme);
  transport_->set_theme(theme);
  sheet_->set_theme(theme);
  plots_->set_theme(theme);
  study_->set_theme(theme);
  compare_->set_theme(theme);
  list_->set_pictures(library_pictures(theme, devicePixelRatioF()));
}

}  // namespace carom
