#include "widgets/plot_panel.h"

#include <QKeyEvent>
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
  set_plots({});
}

void PlotPanel::set_theme(const Theme& theme) {
  theme_ = theme;
  for (TimePlot* plot : plots_) plot->set_theme(theme);
  schedule();
}

void PlotPanel::set_plots(const std::vector<std::string>& ids) {
  for (TimePlot* plot : plots_) delete plot;
  plots_.clear();
  zoomed_.clear();
  time_zoom_.reset();
  for (const PlotKind& kind : plot_table()) {
    if (!ids.empty() && std::find(ids.begin(), ids.end(), kind.id) == ids.end()) continue;
    auto* plot = new TimePlot(kind, theme_, this);
    plots_.push_back(plot);
    layout()->addWidget(plot);
    connect_plot(plot);
  }
  schedule();
}

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
