#include "widgets/time_plot.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <qwt_axis.h>
#include <qwt_plot.h>
#include <qwt_plot_canvas.h>
#include <qwt_plot_curve.h>
#include <qwt_plot_grid.h>
#include <qwt_plot_layout.h>
#include <qwt_plot_marker.h>
#include <qwt_scale_widget.h>
#include <qwt_symbol.h>

#include "widgets/legend_button.h"
#include "widgets/number_text.h"
#include "widgets/plot_gestures.h"
#include "widgets/plot_scale.h"
#include "widgets/series_data.h"
#include "widgets/smooth_curve.h"

namespace carom {
namespace {

constexpr double kLineWidth = 1.8;  // px
constexpr double kSumWidth = 4.5;   // px
constexpr int kPixelsPerTimeTick = 60;
constexpr int kPixelsPerValueTick = 20;

void make_quiet(QwtPlot* plot, int axis, const QString& unit) {
  QFont font = plot->font();
  font.setPixelSize(11);
  plot->setAxisFont(axis, font);
  plot->setAxisScaleDraw(axis, new QuietScaleDraw(unit));
  plot->axisWidget(axis)->setMargin(0);
  plot->axisWidget(axis)->setSpacing(0);
}

}  // namespace

TimePlot::TimePlot(const PlotKind& kind, const Theme& theme, QWidget* parent) : QFrame(parent), kind_(kind) {
  setObjectName("panel");
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(12, 6, 8, 6);
  layout->setSpacing(2);
  build_plot();
  build_header();
  layout->addWidget(plot_, 1);
  set_theme(theme);
  set_value_range(nice_range(0.0, 0.0));
  set_time_range(time_range_);
}

TimePlot::~TimePlot() = default;

void TimePlot::build_header() {
  auto* header = new QHBoxLayout;
  header->setSpacing(4);
  auto* title = new QLabel(QString::fromUtf8(kind_.title), this);
  title->setObjectName("title");
  unit_ = new QLabel(QString::fromUtf8(kind_.unit), this);
  unit_->setObjectName("muted");
  title->setToolTip(QString::fromUtf8(kind_.tip));
  header->addWidget(title);
  header->addWidget(unit_);
  header->addStretch(1);
  for (Curve& curve : curves_) {
    header->addWidget(curve.button);
    connect(curve.button, &LegendButton::toggled, this, [this, item = curve.item.get()](bool shown) {
      item->setVisible(shown);
      emit curvesChanged();
    });
  }
  static_cast<QVBoxLayout*>(layout())->addLayout(header);
}

void TimePlot::build_plot() {
  plot_ = new QwtPlot(this);
  plot_->setAutoReplot(false);
  plot_->setMinimumSize(120, 60);
  plot_->plotLayout()->setAlignCanvasToScales(true);
  auto* canvas = static_cast<QwtPlotCanvas*>(plot_->canvas());
  canvas->setFrameStyle(QFrame::NoFrame);
  canvas->setCursor(Qt::CrossCursor);
  canvas->setToolTip(
      tr("Wheel: zoom in time. Ctrl+wheel: zoom the values.\n"
         "Drag: move. Double click or Home: show all again."));
  make_quiet(plot_, QwtAxis::XBottom, "s");
  make_quiet(plot_, QwtAxis::YLeft, {});

  grid_ = std::make_unique<QwtPlotGrid>();
  grid_->enableX(false);
  grid_->attach(plot_);
  for (const PlotCurve& kind : kind_.curves) {
    auto item = std::make_unique<SmoothCurve>(QString::fromUtf8(kind.label));
    auto* series = new DecimatedSeries;
    item->setData(series);
    item->setRenderHint(QwtPlotItem::RenderAntialiased);
    item->setStyle(kind.of_impact ? QwtPlotCurve::Sticks : QwtPlotCurve::Lines);
    if (kind.sum) item->setZ(item->z() - 1.0);
    item->attach(plot_);
    auto* button = new LegendButton(QString::fromUtf8(kind.label), QString::fromUtf8(kind.tip), this);
    curves_.push_back({std::move(item), series, button});
  }
  cursor_ = std::make_unique<QwtPlotMarker>();
  cursor_->setLineStyle(QwtPlotMarker::VLine);
  cursor_->setVisible(false);
  cursor_->attach(plot_);

  // Over the canvas, so that they take no room from it.
  auto* over = new QHBoxLayout(canvas);
  over->setContentsMargins(4, 2, 4, 2);
  readout_ = new QLabel(canvas);
  chip_ = new QLabel(tr("zoomed · double-click to reset"), canvas);
  for (QLabel* label : {readout_, chip_}) {
    label->setObjectName("chip");
    label->setAttribute(Qt::WA_TransparentForMouseEvents);
    label->hide();
  }
  over->addWidget(readout_, 0, Qt::AlignTop);
  over->addStretch(1);
  over->addWidget(chip_, 0, Qt::AlignTop);

  auto* gestures = new PlotGestures(plot_);
  connect(gestures, &PlotGestures::timeZoomAsked, this, &TimePlot::timeZoomAsked);
  connect(gestures, &PlotGestures::valueZoomAsked, this, &TimePlot::valueZoomAsked);
  connect(gestures, &PlotGestures::panAsked, this, &TimePlot::panAsked);
  connect(gestures, &PlotGestures::resetAsked, this, &TimePlot::resetAsked);
  connect(gestures, &PlotGestures::hovered, this, &TimePlot::show_readout);
}

void TimePlot::set_theme(const Theme& theme) {
  plot_->setCanvasBackground(theme.panel);
  grid_->setPen(theme.grid, 1.0);
  cursor_->setLinePen(theme.muted, 1.0, Qt::DashLine);
  for (QLabel* label : {chip_, readout_}) label->setStyleSheet("color: " + theme.muted.name());
  for (const int axis : {static_cast<int>(QwtAxis::XBottom), static_cast<int>(QwtAxis::YLeft)}) {
    static_cast<QuietScaleDraw*>(plot_->axisScaleDraw(axis))->set_color(theme.muted);
    plot_->axisWidget(axis)->update();
  }
  for (std::size_t i = 0; i < curves_.size(); ++i) {
    Curve& curve = curves_[i];
    QPen pen(theme.series[i % theme.series.size()], kLineWidth, series_dash(static_cast<int>(i)));
    if (kind_.curves[i].sum) pen = QPen(blend(pen.color(), theme.panel, 0.45), kSumWidth, Qt::SolidLine);
    curve.button->set_look(pen, theme.muted);
    if (kind_.curves[i].of_impact) pen.setStyle(Qt::SolidLine);
    curve.item->setPen(pen);
    curve.item->setSymbol(nullptr);  // in the new colour with the next data
  }
}

// Heads on sticks, unless they would run into each other.
void TimePlot::set_heads(const Curve& curve) {
  constexpr int kPixelsPerHead = 4;
  const bool wanted = static_cast<int>(curve.series->size()) * kPixelsPerHead < plot_->canvas()->width();
  if (wanted == (curve.item->symbol() != nullptr)) return;
  constexpr QSize kHead(6, 6);  // px
  curve.item->setSymbol(
      wanted ? new QwtSymbol(QwtSymbol::Ellipse, curve.item->pen().color(), QPen(Qt::NoPen), kHead) : nullptr);
}

void TimePlot::set_time_range(const QwtInterval& range) {
  time_range_ = range;
  const auto put = [&](int pixels_per_tick) {
    plot_->setAxisScaleDiv(QwtAxis::XBottom, ticks(range, plot_->canvas()->width() / pixels_per_tick));
    plot_->updateAxes();
  };
  put(kPixelsPerTimeTick);
  // Deep in a zoom the labels have many digits.
  constexpr int kGap = 12;  // px, between labels
  const int needed = plot_->axisScaleDraw(QwtAxis::XBottom)->maxLabelWidth(plot_->axisFont(QwtAxis::XBottom));
  if (needed + kGap > kPixelsPerTimeTick) put(needed + kGap);
}

void TimePlot::set_value_range(const QwtInterval& range) {
  value_range_ = range;
  plot_->setAxisScaleDiv(QwtAxis::YLeft,
                         ticks(range, std::clamp(plot_->canvas()->height() / kPixelsPerValueTick, 2, 6)));
  plot_->updateAxes();
}

void TimePlot::update_from(const Recorder& recorder, bool hold_values) {
  const int columns = std::max(plot_->canvas()->width(), 1);
  QwtInterval spread;
  for (std::size_t i = 0; i < curves_.size(); ++i) {
    const PlotCurve& kind = kind_.curves[i];
    DecimatedSeries& series = *curves_[i].series;
    if (kind.of_impact) {
      series.take(recorder.impacts(), kind.of_impact, time_range_, columns);
      set_heads(curves_[i]);
    } else {
      series.take(recorder.samples(), kind.of_sample, time_range_, columns);
    }
    if (!curves_[i].item->isVisible() || series.size() == 0) continue;
    const QRectF bounds = series.boundingRect();
    spread |= QwtInterval(bounds.top(), bounds.bottom());
    if (kind.of_impact) spread |= 0.0;  // sticks stand on zero
  }
  const double scale = recorder.scales().*kind_.scale;
  const Zero zero{kind_.rounding.zero * scale, kind_.rounding.range * scale};
  if (hold_values) {
    set_value_range(value_range());
  } else {
    set_value_range(spread.isValid() ? steady_range(value_range_, spread.minValue(), spread.maxValue(), zero)
                                     : nice_range(0.0, 0.0, zero));
  }
}

QwtInterval TimePlot::value_range() const { return plot_->axisScaleDiv(QwtAxis::YLeft).interval(); }

int TimePlot::label_extent() const {
  auto* draw = plot_->axisScaleDraw(QwtAxis::YLeft);
  const double set = draw->minimumExtent();
  draw->setMinimumExtent(0.0);
  const double needed = draw->extent(plot_->axisFont(QwtAxis::YLeft));
  draw->setMinimumExtent(set);
  return static_cast<int>(std::ceil(needed));
}

void TimePlot::set_label_extent(int extent) {
  auto* draw = plot_->axisScaleDraw(QwtAxis::YLeft);
  if (draw->minimumExtent() == extent) return;
  draw->setMinimumExtent(extent);
  plot_->updateLayout();
}

void TimePlot::set_cursor(std::optional<double> time) {
  cursor_->setVisible(time.has_value());
  if (time) cursor_->setXValue(*time);
}

void TimePlot::set_chip_visible(bool visible) { chip_->setVisible(visible); }

void TimePlot::replot() { plot_->replot(); }

void TimePlot::zoom_values(double at, double factor) {
  const QwtInterval now = value_range();
  const QwtInterval wanted(at + (now.minValue() - at) * factor, at + (now.maxValue() - at) * factor);
  // Further in, neighbouring labels would be the same double; further out, squares overflow.
  const double magnitude = std::max(std::abs(wanted.minValue()), std::abs(wanted.maxValue()));
  if (wanted.width() > 1e-12 * magnitude && magnitude < 1e100) set_value_range(wanted);
}

void TimePlot::pan_values(double by) {
  const QwtInterval now = value_range();
  set_value_range({now.minValue() + by, now.maxValue() + by});
}

void TimePlot::show_readout(const std::optional<QPointF>& at) {
  readout_->setVisible(at.has_value());
  if (at) {
    readout_->setText(
        QString("%1 s, %2 %3").arg(figure(at->x()), figure(at->y()), QString::fromUtf8(kind_.unit)));
  }
  emit timeHovered(at ? std::optional(at->x()) : std::nullopt);
}

}  // namespace carom
