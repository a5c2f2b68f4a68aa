#include "widgets/plot_panel.h"

#include <QContextMenuEvent>
#include <QKeyEvent>
#include <QMenu>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "widgets/plot_scale.h"
#include "widgets/plot_table.h"
#include "widgets/time_plot.h"

namespace carom {

PlotPanel::PlotPanel(const Theme& theme, QWidget* parent) : QWidget(parent), theme_(theme) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(8);
  timer_.setSingleShot(true);
  timer_.setInterval(0);
  connect(&timer_, &QTimer::timeout, this, &PlotPanel::refresh);
  menu_ = new QMenu(tr("&Plots"), this);
  menu_->setToolTipsVisible(true);
  for (const PlotKind& kind : plot_table()) {
    QAction* action = menu_->addAction(QString::fromUtf8(kind.title));
    action->setToolTip(QString::fromUtf8(kind.tip));
    action->setCheckable(true);
    action->setData(QString::fromUtf8(kind.id.data(), static_cast<qsizetype>(kind.id.size())));
    connect(action, &QAction::triggered, this, [this, &kind](bool on) { set_shown(kind.id, on); });
  }
  set_plots({});
}

void PlotPanel::set_theme(const Theme& theme) {
  theme_ = theme;
  for (TimePlot* plot : plots_) plot->set_theme(theme);
  schedule();
}

void PlotPanel::set_plots(const std::vector<std::string>& ids) {
  const std::vector<std::string>& wanted = ids.empty() ? default_plots() : ids;
  for (TimePlot* plot : plots_) delete plot;
  plots_.clear();
  zoomed_.clear();
  time_zoom_.reset();
  for (const PlotKind& kind : plot_table()) {
    if (std::find(wanted.begin(), wanted.end(), kind.id) != wanted.end()) add_plot(kind);
  }
  mark_menu();
  schedule();
}

// At its place in the order of the table.
void PlotPanel::add_plot(const PlotKind& kind) {
  const auto place = std::find_if(plots_.begin(), plots_.end(),
                                  [&kind](const TimePlot* plot) { return &plot->kind() > &kind; });
  auto* plot = new TimePlot(kind, theme_, this);
  static_cast<QVBoxLayout*>(layout())->insertWidget(static_cast<int>(place - plots_.begin()), plot);
  plots_.insert(place, plot);
  connect_plot(plot);
}

bool PlotPanel::shows(std::string_view id) const {
  return std::any_of(plots_.begin(), plots_.end(),
                     [id](const TimePlot* plot) { return plot->kind().id == id; });
}

void PlotPanel::set_shown(std::string_view id, bool shown) {
  const auto at =
      std::find_if(plots_.begin(), plots_.end(), [id](const TimePlot* plot) { return plot->kind().id == id; });
  if (shown && at == plots_.end()) {
    for (const PlotKind& kind : plot_table()) {
      if (kind.id == id) add_plot(kind);
    }
  } else if (!shown && at != plots_.end() && plots_.size() > 1) {
    std::erase(zoomed_, *at);
    delete *at;
    plots_.erase(at);
    if (zoomed_.empty()) time_zoom_.reset();
  }
  mark_menu();
  schedule();
}

void PlotPanel::mark_menu() {
  for (QAction* action : menu_->actions()) {
    const bool shown = shows(action->data().toString().toStdString());
    action->setChecked(shown);
    action->setEnabled(!shown || plots_.size() > 1);
  }
}

void PlotPanel::contextMenuEvent(QContextMenuEvent* event) { menu_->popup(event->globalPos()); }

void PlotPanel::connect_plot(TimePlot* plot) {
  connect(plot, &TimePlot::timeZoomAsked, this, [this, plot](double at, double factor) {
    const QwtInterval now = time_range();
    set_time_zoom(plot, {at + (now.minValue() - at) * factor, at + (now.maxValue() - at) * factor});
  });
  connect(plot, &TimePlot::valueZoomAsked, this, [this, plot](double at, double factor) {
    plot->zoom_values(at, factor);
    mark_zoomed(plot);
  });
  connect(plot, &TimePlot::panAsked, this, [this, plot](const QPointF& by) {
    const QwtInterval now = time_range();
    plot->pan_values(by.y());
    set_time_zoom(plot, {now.minValue() + by.x(), now.maxValue() + by.x()});
  });
  connect(plot, &TimePlot::resetAsked, this, &PlotPanel::reset_zoom);
  connect(plot, &TimePlot::curvesChanged, this, &PlotPanel::schedule);
  connect(plot, &TimePlot::timeHovered, this, [this](const std::optional<double>& time) {
    for (TimePlot* each : plots_) each->set_cursor(time);
    schedule();
  });
}

void PlotPanel::update_from(const Recorder& recorder) {
  recorder_ = &recorder;
  schedule();
}

void PlotPanel::reset_zoom() {
  zoomed_.clear();
  time_zoom_.reset();
  for (TimePlot* plot : plots_) {
    plot->set_chip_visible(false);
    plot->forget_value_range();
  }
  schedule();
}

void PlotPanel::set_time_zoom(TimePlot* plot, const QwtInterval& range) {
  // Further in, pixels would share one double; further out there is nothing to see.
  const double magnitude = std::max(std::abs(range.minValue()), std::abs(range.maxValue()));
  constexpr double kLongest = 1e9;  // s
  if (range.width() < 1e-12 * magnitude || magnitude > kLongest) return;
  time_zoom_ = range;
  mark_zoomed(plot);
}

void PlotPanel::mark_zoomed(TimePlot* plot) {
  if (std::find(zoomed_.begin(), zoomed_.end(), plot) == zoomed_.end()) zoomed_.push_back(plot);
  plot->set_chip_visible(true);
  schedule();
}

QwtInterval PlotPanel::time_range() const {
  if (time_zoom_) return *time_zoom_;
  const std::vector<Sample>& samples = recorder_->samples();
  return {0.0, nice_time_end(samples.empty() ? 0.0 : samples.back().time)};
}

void PlotPanel::schedule() {
  if (isVisible() && !timer_.isActive()) timer_.start();
}

void PlotPanel::refresh() {
  const QwtInterval range = time_range();
  int extent = 0;
  for (TimePlot* plot : plots_) {
    plot->set_time_range(range);
    const bool hold = time_zoom_ || std::find(zoomed_.begin(), zoomed_.end(), plot) != zoomed_.end();
    plot->update_from(*recorder_, hold);
    extent = std::max(extent, plot->label_extent());
  }
  // Room in steps, so that the canvases don't shift with each new label.
  constexpr int kExtentStep = 8;  // px
  extent = (extent + kExtentStep - 1) / kExtentStep * kExtentStep;
  for (TimePlot* plot : plots_) {
    plot->set_label_extent(extent);
    plot->replot();
  }
}

void PlotPanel::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  schedule();
}

void PlotPanel::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  schedule();
}

void PlotPanel::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Home) {
    reset_zoom();
  } else {
    QWidget::keyPressEvent(event);
  }
}

}  // namespace carom
