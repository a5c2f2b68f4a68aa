#include "app/lab/panel_docks.h"

#include <QSettings>
#include <QSignalBlocker>
#include <QSplitter>
#include <QTabBar>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "app/lab/drawer.h"
#include "app/lab/drop_mark.h"
#include "app/lab/floating_panel.h"
#include "app/lab/panel_drag.h"

namespace carom {
namespace {

using Panel = PanelDocks::Panel;
using Dock = PanelDocks::Dock;

constexpr int kGap = 8;           // px, between panels
constexpr int kTabsWidth = 280;   // px, of a side column where there is little room; until it is pulled
constexpr double kShare = 0.253;  // of the width, of a side column where there is more

constexpr QPoint kCorner(-40, -24);  // px, of a window that is dropped, from the mouse

struct Standard {
  Dock dock;
  int height;        // px
  int large_height;  // px, in a large window
};
constexpr std::array<Standard, PanelDocks::kPanels> kStandard = {{
    {PanelDocks::kRight, 300, 408},
    {PanelDocks::kRight, 300, 300},
    {PanelDocks::kBottom, 176, 176},
}};
constexpr int kLarge = 660;  // px, from which height of all panels on a window is large
constexpr std::array<Panel, PanelDocks::kPanels> kAll = {PanelDocks::kInspector, PanelDocks::kPlots,
                                                         PanelDocks::kDrawer};
// In settings.
constexpr std::array<const char*, PanelDocks::kPanels> kNames = {"inspector", "plots", "drawer"};
constexpr std::array<const char*, PanelDocks::kDocks> kDockNames = {"left", "right", "bottom"};

QSplitter* make_splitter(Qt::Orientation orientation) {
  auto* splitter = new QSplitter(orientation);
  splitter->setHandleWidth(kGap);
  splitter->setChildrenCollapsible(false);
  return splitter;
}

}  // namespace

PanelDocks::PanelDocks(QWidget* scene, QWidget* inspector, QWidget* plots, Drawer* drawer, QWidget* parent)
    : QWidget(parent),
      scene_(scene),
      drawer_(drawer),
      columns_(make_splitter(Qt::Horizontal)),
      middle_(make_splitter(Qt::Vertical)),
      mark_(new DropMark(this)),
      tabs_width_(kTabsWidth) {
  auto* all = new QVBoxLayout(this);
  all->setContentsMargins(0, 0, 0, 0);
  all->addWidget(columns_);
  make_side(kLeft);
  columns_->addWidget(middle_);
  make_side(kRight);
  columns_->setStretchFactor(1, 3);
  middle_->addWidget(scene);
  middle_->setStretchFactor(0, 1);
  add_panel(kInspector, inspector, kNames[kInspector], tr("Inspector"));
  add_panel(kPlots, plots, kNames[kPlots], tr("Plots"));
  add_panel(kDrawer, drawer, kNames[kDrawer], tr("Tables"));
  connect(columns_, &QSplitter::splitterMoved, this, &PanelDocks::keep_widths);
  connect(middle_, &QSplitter::splitterMoved, this, &PanelDocks::keep_heights);
  connect(drawer_, &Drawer::foldedChanged, this, &PanelDocks::size_heights);
  place();
}

void PanelDocks::make_side(Dock dock) {
  Side& side = sides_[dock];
  side.column = new QWidget;
  side.tabs = new QTabBar;
  side.panels = make_splitter(Qt::Vertical);
  side.share = kShare;
  side.tabs->setAccessibleName(tr("Inspector and plots"));
  side.tabs->addTab(tr("Inspector"));
  side.tabs->addTab(tr("Plots"));
  auto* column = new QVBoxLayout(side.column);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(kGap);
  column->addWidget(side.tabs);
  column->addWidget(side.panels, 1);
  columns_->addWidget(side.column);
  connect(side.tabs, &QTabBar::currentChanged, this, [this](int tab) { show_inspector(tab == kInspector); });
  connect(side.panels, &QSplitter::splitterMoved, this, &PanelDocks::keep_heights);
}

void PanelDocks::add_panel(Panel panel, QWidget* widget, const QString& name, const QString& title) {
  Place& place = places_[panel];
  place.panel = widget;
  place.dock = kStandard[panel].dock;
  insert(panel);
  place.window = new FloatingPanel(widget, name, title, [this, panel] { insert(panel); });
  connect(place.window, &FloatingPanel::aboutToFloat, this, &PanelDocks::keep_heights);
  connect(place.window, &FloatingPanel::floatingChanged, this, [this, panel](bool floating) {
    if (panel == kInspector && floating) inspector_open_ = true;
    this->place();
  });
  place.drag = new PanelDrag(this);
  connect(place.drag, &PanelDrag::moved, this, [this, panel](const QPoint& to) { show_target(panel, to); });
  connect(place.drag, &PanelDrag::dropped, this, [this, panel](const QPoint& at) { drop(panel, at); });
  connect(place.drag, &PanelDrag::cancelled, mark_, &QWidget::hide);
  for (const Side& side : sides_) {
    if (panel == kDrawer) break;
    add_head(panel, side.tabs, [&side, panel](const QPoint& at) { return side.tabs->tabAt(at) == panel; });
  }
}

void PanelDocks::add_head(Panel panel, QWidget* head, std::function<bool(const QPoint&)> in_head) {
  places_[panel].drag->watch(head, std::move(in_head));
}

QSplitter* PanelDocks::splitter(Dock dock) const { return dock == kBottom ? middle_ : sides_[dock].panels; }

// In the order of the panels, after the scene.
void PanelDocks::insert(Panel panel) {
  const Place& place = places_[panel];
  QSplitter* to = splitter(place.dock);
  int index = to == middle_ ? 1 : 0;
  for (const Panel other : kAll) {
    if (other < panel && to->indexOf(places_[other].panel) >= 0) ++index;
  }
  to->insertWidget(index, place.panel);
  to->setStretchFactor(index, panel == kPlots && to != middle_ ? 1 : 0);
}

bool PanelDocks::stands(Panel panel, Dock dock) const {
  const Place& place = places_[panel];
  return place.dock == dock && !place.window->floating() && !place.panel->isHidden();
}

bool PanelDocks::has_tabs() const {
  const Dock dock = dock_of(kInspector);
  return tabbed_ && dock != kBottom && dock == dock_of(kPlots) && !window_of(kInspector).floating() &&
         !window_of(kPlots).floating();
}

// --- what stands where
// -----------------------------------------------------------------------------------------------------------

void PanelDocks::put(Panel panel, Dock dock) {
  keep_heights();
  if (dock != dock_of(panel)) {
    // The scene stays the largest thing.
    const int most = std::min(middle_->height() / 4, standard_height(panel));
    places_[panel].height = dock == kBottom && panel != kDrawer ? most : 0;
  }
  places_[panel].dock = dock;
  if (window_of(panel).floating()) {
    window_of(panel).set_floating(false);
  } else {
    insert(panel);
    place();
  }
  emit docksChanged();
}

void PanelDocks::put_at_left(bool left) {
  if (left == at_left()) return;
  // Both columns keep their widths.
  sides_[left ? kLeft : kRight].share = sides_[left ? kRight : kLeft].share;
  put(kInspector, left ? kLeft : kRight);
  put(kPlots, left ? kLeft : kRight);
}

void PanelDocks::reset() {
  for (Side& side : sides_) side.share = kShare;
  tabs_width_ = kTabsWidth;
  inspector_open_ = inspector_tab_ = true;
  for (const Panel panel : kAll) put(panel, kStandard[panel].dock);
  for (Place& of_panel : places_) of_panel.height = 0;
  drawer_->set_folded(false);
  sized_for_ = -1;
  place();
}

void PanelDocks::set_tabbed(bool tabbed) {
  if (tabbed == tabbed_) return;
  keep_heights();
  tabbed_ = tabbed;
  place();
}

void PanelDocks::show_inspector(bool shown) {
  if (shown == shows_inspector()) return;
  keep_heights();
  (has_tabs() ? inspector_tab_ : inspector_open_) = shown;
  place();
}

void PanelDocks::place() {
  for (const Dock dock : {kLeft, kRight}) {
    QTabBar* tabs = sides_[dock].tabs;
    const QSignalBlocker not_by_the_user(tabs);
    tabs->setVisible(has_tabs() && dock_of(kPlots) == dock);
    tabs->setCurrentIndex(inspector_tab_ ? kInspector : kPlots);
  }
  window_of(kInspector).set_shown(shows_inspector());
  window_of(kPlots).set_shown(!has_tabs() || !inspector_tab_);
  for (const Dock dock : {kLeft, kRight}) {
    const bool used = std::any_of(kAll.begin(), kAll.end(), [&](Panel panel) { return stands(panel, dock); });
    sides_[dock].column->setVisible(used);
  }
  if (drawer_->folded()) drawer_->set_folded(true);  // unless it is alone now
  size_widths();
  size_heights();
  emit inspectorShown(shows_inspector());
}

// --- sizes
// -----------------------------------------------------------------------------------------------------------

QWidget* PanelDocks::flexible(Dock dock) const {
  if (dock == kBottom) return scene_;
  for (const Panel panel : {kPlots, kInspector, kDrawer}) {
    if (stands(panel, dock)) return places_[panel].panel;
  }
  return nullptr;
}

int PanelDocks::standard_height(Panel panel) const {
  return height() < kLarge ? kStandard[panel].height : kStandard[panel].large_height;
}

int PanelDocks::height_of(Panel panel) const {
  return places_[panel].height > 0 ? places_[panel].height : standard_height(panel);
}

void PanelDocks::keep_heights() {
  if (!isVisible()) return;
  for (const Panel panel : kAll) {
    Place& place = places_[panel];
    const bool own = stands(panel, place.dock) && flexible(place.dock) != place.panel;
    if (!own || (panel == kDrawer && drawer_->folded())) continue;
    const int now = place.panel->height();
    place.height = now == standard_height(panel) ? 0 : now;
  }
}

void PanelDocks::keep_widths() {
  for (Side& side : sides_) {
    if (side.column->isHidden()) continue;
    if (tabbed_) {
      tabs_width_ = side.column->width();
    } else {
      side.share = 1.0 * side.column->width() / columns_->width();
    }
  }
}

// The user's widths hold as long as the same columns are there.
void PanelDocks::size_widths() {
  const auto shown = [this](Dock dock) { return !sides_[dock].column->isHidden(); };
  const int now = (shown(kLeft) ? 1 : 0) + (shown(kRight) ? 2 : 0) + (tabbed_ ? 4 : 0);
  if (std::exchange(sized_for_, now) == now) return;
  const auto wide = [&](Dock dock) {
    return !shown(dock) ? 0 : tabbed_ ? tabs_width_ : qRound(sides_[dock].share * width());
  };
  const int gaps = kGap * ((shown(kLeft) ? 1 : 0) + (shown(kRight) ? 1 : 0));
  columns_->setSizes({wide(kLeft), width() - gaps - wide(kLeft) - wide(kRight), wide(kRight)});
  // Beside tabs, what the window has more or less is the scene's.
  for (const Side& side : sides_) columns_->setStretchFactor(columns_->indexOf(side.column), tabbed_ ? 0 : 1);
}

void PanelDocks::size_heights() {
  for (const Dock dock : {kLeft, kRight, kBottom}) {
    QSplitter* column = splitter(dock);
    const QWidget* rest = flexible(dock);
    int left = column->height();
    QList<int> sizes;
    for (int i = 0; i < column->count(); ++i) {
      const auto of = std::find_if(places_.begin(), places_.end(),
                                   [&](const Place& place) { return place.panel == column->widget(i); });
      const bool fixed = of != places_.end() && of->panel != rest && !of->panel->isHidden();
      const int own = fixed ? height_of(static_cast<Panel>(of - places_.begin())) : 0;
      sizes << (fixed ? std::min(own, of->panel->maximumHeight()) : 0);
      if (fixed) left -= sizes.last() + kGap;
    }
    for (int i = 0; i < column->count(); ++i) {
      if (column->widget(i) == rest) sizes[i] = std::max(1, left);
    }
    column->setSizes(sizes);
  }
}

// Before, no size is known.
void PanelDocks::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  sized_for_ = -1;
  size_widths();
  size_heights();
}

// --- a drag
// -----------------------------------------------------------------------------------------------------------

std::optional<Dock> PanelDocks::target(const QPoint& at) const {
  constexpr int kEdge = 96;  // px, of a dock that is empty or low
  if (!rect().contains(at)) return std::nullopt;
  const auto side_width = [&](Dock dock) {
    const QWidget* column = sides_[dock].column;
    return column->isHidden() ? kEdge : column->width();
  };
  if (at.x() < side_width(kLeft)) return kLeft;
  if (at.x() >= width() - side_width(kRight)) return kRight;
  const int under = scene_->mapTo(this, QPoint(0, scene_->height())).y();
  if (at.y() >= std::min(under, height() - kEdge)) return kBottom;
  return std::nullopt;
}

QRect PanelDocks::target_rect(Dock dock) const {
  const QRect middle(middle_->mapTo(this, QPoint()), middle_->size());
  if (dock == kBottom) {
    const int low = std::max(middle_->height() - scene_->height(), kStandard[kDrawer].height);
    return middle.adjusted(0, middle.height() - low, 0, 0);
  }
  const QWidget* column = sides_[dock].column;
  if (!column->isHidden()) return {column->mapTo(this, QPoint()), column->size()};
  const int wide = tabbed_ ? tabs_width_ : qRound(sides_[dock].share * width());
  return {dock == kLeft ? 0 : width() - wide, 0, wide, height()};
}

void PanelDocks::show_target(Panel panel, const QPoint& global) {
  const QPoint at = mapFromGlobal(global);
  const std::optional<Dock> dock = target(at);
  if (!dock) {
    constexpr QSize kLargest(360, 300);  // px
    return mark_->show_at(QRect(at + kCorner, places_[panel].panel->size().boundedTo(kLargest)),
                          tr("In a window"));
  }
  const std::array<QString, kDocks> words = {tr("At the left"), tr("At the right"), tr("Under the scene")};
  mark_->show_at(target_rect(*dock), words[*dock]);
}

void PanelDocks::drop(Panel panel, const QPoint& global) {
  mark_->hide();
  const std::optional<Dock> dock = target(mapFromGlobal(global));
  if (!dock) {
    window_of(panel).float_at(global + kCorner);
  } else if (*dock != dock_of(panel) || window_of(panel).floating()) {
    put(panel, *dock);
  }
}

// --- what is remembered
// -----------------------------------------------------------------------------------------------------------

void PanelDocks::restore(const QSettings& settings) {
  for (const Panel panel : kAll) {
    const QString name = kNames[panel];
    const auto dock = std::find(kDockNames.begin(), kDockNames.end(),
                                settings.value(name + "_dock").toString().toStdString());
    put(panel, dock == kDockNames.end() ? kStandard[panel].dock : static_cast<Dock>(dock - kDockNames.begin()));
    places_[panel].height = std::max(0, settings.value(name + "_height", 0).toInt());
  }
  sides_[kLeft].share = settings.value("left_share", kShare).toDouble();
  sides_[kRight].share = settings.value("right_share", kShare).toDouble();
  tabs_width_ = settings.value("tabs_width", kTabsWidth).toInt();
  inspector_open_ = settings.value("inspector", true).toBool();
  inspector_tab_ = settings.value("inspector_tab", true).toBool();
  drawer_->set_folded(settings.value("folded", false).toBool());
  for (const Panel panel : kAll) window_of(panel).restore(settings);
  sized_for_ = -1;
  place();
}

void PanelDocks::keep(QSettings& settings) {
  keep_heights();
  for (const Panel panel : kAll) {
    const QString name = kNames[panel];
    settings.setValue(name + "_dock", kDockNames[dock_of(panel)]);
    settings.setValue(name + "_height", places_[panel].height);
    window_of(panel).keep(settings);
  }
  settings.setValue("left_share", sides_[kLeft].share);
  settings.setValue("right_share", sides_[kRight].share);
  settings.setValue("tabs_width", tabs_width_);
  settings.setValue("inspector", inspector_open_);
  settings.setValue("inspector_tab", inspector_tab_);
  settings.setValue("folded", drawer_->folded());
}

}  // namespace carom
