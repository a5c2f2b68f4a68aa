#include <QAction>
#include <QHBoxLayout>
#include <QLabel>
#include <QSplitter>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

#include "app/lab/document_files.h"
#include "app/lab/drawer.h"
#include "app/lab/floating_panel.h"
#include "app/lab/lab_window.h"
#include "app/lab/notice_bar.h"
#include "app/lab/right_column.h"
#include "app/lab/scrolled.h"
#include "app/library/library_items.h"
#include "physics/scene/validate.h"
#include "widgets/compare/compare_panel.h"
#include "widgets/compare/study_panel.h"
#include "widgets/edit/bodies_sheet.h"
#include "widgets/edit/inspector.h"
#include "widgets/plot/plot_panel.h"
#include "widgets/plot/reading_table.h"
#include "widgets/run/experiment_list.h"
#include "widgets/run/ledger_table.h"
#include "widgets/run/run_tables.h"
#include "widgets/run/transport_bar.h"
#include "widgets/scene/scene_view.h"

// The layout of the lab's window.
namespace carom {
namespace {

constexpr int kListWidth = 256;           // px
constexpr int kGap = 8;                   // px, between panels
constexpr int kTabsWidth = 280;           // px, of the right column with tabs
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
  list_->setFixedWidth(kListWidth);
  list_->hide();

  columns_ = new QSplitter(Qt::Horizontal);
  columns_->setHandleWidth(kGap);
  columns_->addWidget(make_middle());
  columns_->addWidget(make_right());
  columns_->setStretchFactor(0, 3);
  columns_->setStretchFactor(1, 1);
  columns_->setChildrenCollapsible(false);
  connect(columns_, &QSplitter::splitterMoved, this, [this](int at) {
    if (!right_->tabbed())
      right_share_ =
          right_is_left() ? 1.0 * at / columns_->width() : 1.0 - 1.0 * (at + kGap) / columns_->width();
  });
  floating_ = {&right_->inspector_window(), &right_->plots_window(),
               new FloatingPanel(drawer_, "drawer", tr("Tables"))};
  for (FloatingPanel* each : floating_) icon_actions_.emplace_back(each->action(), "float");
  inspector_->add_to_head(floating_[0]->make_button());
  drawer_->add_corner(floating_[2]->make_button());
  restore_bar_ = new NoticeBar;
  lost_bar_ = new NoticeBar;
  auto* inner = new QVBoxLayout;
  inner->setContentsMargins(kGap, kGap, kGap, kGap);
  inner->setSpacing(kGap);
  inner->addWidget(restore_bar_);
  inner->addWidget(lost_bar_);
  inner->addWidget(columns_, 1);
  row->addLayout(inner, 1);
  setCentralWidget(all);
}

// A wide window has room for the list as a column. Else it opens over the scene, and closes once an experiment
// is chosen.
void LabWindow::place_list() {
  QWidget* all = centralWidget();
  auto* row = static_cast<QHBoxLayout*>(all->layout());
  const bool pinned = width() >= kPinnedFrom;
  const bool was_pinned = row->indexOf(list_) >= 0;
  list_action_->setVisible(!pinned);
  if (pinned && !was_pinned) {
    row->insertWidget(0, list_);
    list_->show();
  } else if (!pinned && was_pinned) {
    row->removeWidget(list_);
    list_->hide();
    list_action_->setChecked(false);
  }
  if (!pinned) list_->setGeometry(0, 0, kListWidth, all->height());
  list_->raise();
}

void LabWindow::open_list(bool open) {
  const bool pinned = width() >= kPinnedFrom;
  list_->setVisible(open || pinned);
  if (open) {
    place_list();
    list_->begin_search();
  } else if (!pinned) {
    view_->setFocus();
  }
}

void LabWindow::resizeEvent(QResizeEvent* event) {
  fold_tool_bar();
  QMainWindow::resizeEvent(event);
  place_list();
  place_right();
}

// A small window has room for the inspector or the plots, but not for both.
void LabWindow::place_right() {
  const bool tabbed = width() < kStackedFrom.width() || height() < kStackedFrom.height();
  if (tabbed == right_->tabbed()) return;
  right_->set_tabbed(tabbed);
  size_right();
}

void LabWindow::size_right() {
  const int both = columns_->isVisible() ? columns_->width() : width() - 2 * kGap;
  const int right = right_->tabbed() ? kTabsWidth : qRound(right_share_ * both);
  const int scene = both - kGap - right;
  columns_->setSizes(right_is_left() ? QList{right, scene} : QList{scene, right});
  // Beside tabs, what the window has more or less is the scene's.
  columns_->setStretchFactor(columns_->indexOf(right_), right_->tabbed() ? 0 : 1);
}

bool LabWindow::right_is_left() const { return columns_->indexOf(right_) == 0; }

// Both columns keep their widths.
void LabWindow::put_right(bool at_left) {
  if (at_left == right_is_left()) return;
  const QList<int> sizes = columns_->sizes();
  columns_->insertWidget(at_left ? 0 : 1, right_);
  columns_->setSizes({sizes[1], sizes[0]});
}

QWidget* LabWindow::make_middle() {
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
  make_drawer();
  middle_ = new QSplitter(Qt::Vertical);
  middle_->setHandleWidth(kGap);
  middle_->addWidget(scene);
  middle_->addWidget(drawer_);
  middle_->setStretchFactor(0, 1);
  middle_->setStretchFactor(1, 0);
  middle_->setChildrenCollapsible(false);
  return middle_;
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
  drawer_->add(bodies_ = new BodiesTable, tr("Before and after"));
  drawer_->add(impacts_ = new ImpactsTable, tr("Impacts"));
  drawer_->add(ledger_ = new LedgerTable, tr("Ledger"));
  drawer_->add(reading_ = new ReadingTable, tr("Reading"));
  drawer_->add(compare_ = new ComparePanel(theme_), tr("Compare"));
  drawer_->add(study_ = new StudyPanel(theme_), tr("Study"));
  drawer_->add(scrolled<QScrollArea>(about_), tr("About"));
}

QWidget* LabWindow::make_right() {
  inspector_ = new Inspector;
  auto* area = scrolled<TallArea>(inspector_);
  area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  right_ = new RightColumn(with_frame(area, 1), make_plots());
  return right_;
}

// Plots scroll if there are too many for the height.
QWidget* LabWindow::make_plots() {
  plots_ = new PlotPanel(theme_);
  auto* area = scrolled<TallArea>(plots_);
  area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  return area;
}

void LabWindow::connect_views() {
  connect(study_, &StudyPanel::methodChosen, this, [this](const Method& method) {
    const std::vector<Method>& others = preset().compare;
    const bool there =
        preset().method == method || std::find(others.begin(), others.end(), method) != others.end();
    if (!there) session_.add_method(method);
  });
  connect(compare_, &ComparePanel::methodAdded, &session_, &Session::add_method);
  connect(compare_, &ComparePanel::methodRemoved, &session_, &Session::remove_method);
  connect(compare_, &ComparePanel::methodChanged, &session_, &Session::change_method);
  connect(compare_, &ComparePanel::stepChanged, &session_, &Session::change_step);
  connect(compare_, &ComparePanel::referenceChosen, &session_, &Session::choose_reference);
  connect(compare_, &ComparePanel::usualAsked, this, &LabWindow::compare_usual);
  connect(drawer_, &Drawer::pageChanged, this, &LabWindow::show_frame);
  connect(plots_, &PlotPanel::layoutChanged, this, [this] {
    session_.change_plots(plots_->chosen());
    session_.runs().record(plots_->curves());
  });
  connect(plots_, &PlotPanel::marksChanged, this, [this] {
    drawer_->choose(reading_);
    show_frame();
  });
  connect(lost_bar_, &NoticeBar::accepted, &session_.runs(), &LabRuns::restart);
  connect(lost_bar_, &NoticeBar::dismissed, this, [this] {
    lost_bar_->hide();
    show_notices();
  });
  connect(list_, &ExperimentList::openRequested, files_, [this](const QString& name) {
    list_action_->setChecked(false);
    files_->open(name.toStdString());
  });
  connect(list_, &ExperimentList::closeRequested, this, [this] { list_action_->setChecked(false); });
  connect(transport_, &TransportBar::playClicked, this, &LabWindow::set_playing);
  connect(transport_, &TransportBar::restartClicked, &session_.runs(), &LabRuns::restart);
  connect(transport_, &TransportBar::stepClicked, &session_.runs(), &LabRuns::step_once);
  connect(transport_, &TransportBar::speedChosen, this, [this](double speed) {
    session_.runs().set_speed(speed);
    show_frame();
  });
}

void LabWindow::set_theme(const Theme& theme) {
  theme_ = theme;
  for (const auto& [action, icon] : icon_actions_) action->setIcon(themed_icon(icon, theme.text));
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
