#include "app/lab/right_column.h"

#include <QSignalBlocker>
#include <QSplitter>
#include <QTabBar>
#include <QVBoxLayout>
#include <algorithm>

#include "app/lab/floating_panel.h"

namespace carom {
namespace {

enum Tab { kInspector = 0, kPlots = 1 };

}  // namespace

RightColumn::RightColumn(QWidget* inspector, QWidget* plots, QWidget* parent)
    : QWidget(parent), tabs_(new QTabBar), splitter_(new QSplitter(Qt::Vertical)) {
  tabs_->setAccessibleName(tr("Inspector and plots"));
  tabs_->addTab(tr("Inspector"));
  tabs_->addTab(tr("Plots"));
  splitter_->setHandleWidth(8);
  splitter_->addWidget(inspector);
  splitter_->addWidget(plots);
  splitter_->setStretchFactor(0, 0);
  splitter_->setStretchFactor(1, 1);
  splitter_->setChildrenCollapsible(false);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(8);
  column->addWidget(tabs_);
  column->addWidget(splitter_, 1);
  inspector_window_ = new FloatingPanel(inspector, "inspector", tr("Inspector"));
  plots_window_ = new FloatingPanel(plots, "plots", tr("Plots"));
  connect(inspector_window_, &FloatingPanel::floatingChanged, this, [this](bool floating) {
    inspector_open_ = inspector_open_ || floating;
    place();
  });
  connect(plots_window_, &FloatingPanel::floatingChanged, this, &RightColumn::place);
  connect(splitter_, &QSplitter::splitterMoved, this, &RightColumn::keep_height);
  connect(tabs_, &QTabBar::currentChanged, this, [this](int tab) { show_inspector(tab == kInspector); });
  place();
}

void RightColumn::set_tabbed(bool tabbed) {
  if (tabbed == tabbed_) return;
  keep_height();
  tabbed_ = tabbed;
  place();
}

void RightColumn::show_inspector(bool shown) {
  if (shown == shows_inspector()) return;
  keep_height();
  (has_tabs() ? inspector_tab_ : inspector_open_) = shown;
  place();
}

RightColumn::Places RightColumn::places() const {
  const bool stacked =
      !tabbed_ && inspector_open_ && !inspector_window_->floating() && !plots_window_->floating();
  return {stacked ? splitter_->sizes().front() : inspector_height_, inspector_open_, inspector_tab_};
}

void RightColumn::set_places(const Places& places) {
  inspector_height_ = places.inspector_height;
  inspector_open_ = places.inspector_open;
  inspector_tab_ = places.inspector_tab;
  place();
}

void RightColumn::keep_height() { inspector_height_ = places().inspector_height; }

bool RightColumn::has_tabs() const {
  return tabbed_ && !inspector_window_->floating() && !plots_window_->floating();
}

void RightColumn::place() {
  constexpr int kUsualHeight = 720;  // px, of both; the plots get what there is more
  tabs_->setVisible(has_tabs());
  {
    const QSignalBlocker not_by_the_user(tabs_);
    tabs_->setCurrentIndex(inspector_tab_ ? kInspector : kPlots);
  }
  inspector_window_->set_shown(shows_inspector());
  plots_window_->set_shown(!has_tabs() || !inspector_tab_);
  const bool has_inspector = shows_inspector() && !inspector_window_->floating();
  const bool has_plots = !plots_window_->floating();
  if (parentWidget() != nullptr) setVisible(has_inspector || has_plots);
  if (!tabbed_ && has_inspector && has_plots)
    splitter_->setSizes({inspector_height_, std::max(1, kUsualHeight - inspector_height_)});
  emit inspectorShown(shows_inspector());
}

}  // namespace carom
