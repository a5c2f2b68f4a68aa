#include "widgets/plot/distribution.h"

#include <QCoreApplication>
#include <algorithm>
#include <array>
#include <cmath>
#include <qwt_plot_curve.h>
#include <qwt_plot_histogram.h>

#include "widgets/base/number_text.h"
#include "widgets/plot/legend_button.h"
#include "widgets/plot/smooth_curve.h"

namespace carom {
namespace {

constexpr double kMost = 0.999;  // least share of the values within the axis
constexpr int kCurvePoints = 240;

QString tr(const char* text) { return QCoreApplication::translate("Distribution", text); }

std::unique_ptr<QwtPlotHistogram> histogram_item(QwtPlot* plot, QwtPlotHistogram::HistogramStyle style) {
  auto item = std::make_unique<QwtPlotHistogram>();
  item->setStyle(style);
  item->setRenderHint(QwtPlotItem::RenderAntialiased);
  item->attach(plot);
  return item;
}

std::vector<double> strengths(const Recorder& recorder, const QwtInterval& time) {
  const Ring<ImpactRecord>& impacts = recorder.impacts();
  std::vector<double> all;
  for (std::size_t i = 0; i < impacts.size(); ++i) {
    if (time.contains(impacts[i].time)) all.push_back(impacts[i].normal_impulse);
  }
  return all;
}

}  // namespace

Distribution::Distribution(PlotContent::Shows what, QwtPlot* plot, QWidget* parent)
    : what_(what), bars_(histogram_item(plot, QwtPlotHistogram::Columns)) {
  if (what_ != PlotContent::Shows::kSpeeds) return;
  outline_ = histogram_item(plot, QwtPlotHistogram::Outline);
  outline_->setBrush(Qt::NoBrush);
  curve_ = std::make_unique<SmoothCurve>();
  curve_->setRenderHint(QwtPlotItem::RenderAntialiased);
  curve_->attach(plot);
  buttons_ = {new LegendButton(tr("now"), tr("speeds of all freely moving bodies at this moment"), parent),
              new LegendButton(tr("mean"),
                               tr("mean over the time that the plots show: zoom in time to choose it"), parent),
              new LegendButton(tr("Maxwell"),
                               tr("f(v) = (m v/kT) exp(−m v²/2kT), kT being the mean kinetic energy "
                                  "of the translation now; with several masses, the mean of their laws"),
                               parent)};
}

Distribution::~Distribution() = default;

void Distribution::set_shown(std::size_t button, bool shown) {
  const std::array<QwtPlotItem*, 3> items = {bars_.get(), outline_.get(), curve_.get()};
  items[button]->setVisible(shown);
}

void Distribution::set_theme(const Theme& theme) {
  const QColor fill = blend(theme.series[0], theme.panel, 0.55);
  bars_->setBrush(fill);
  bars_->setPen(QPen(theme.panel, 1.0));
  looks_ = {QPen(fill, 7.0), QPen(theme.series[1], 1.8), QPen(theme.text, 1.2, Qt::CustomDashLine)};
  looks_[0].setCapStyle(Qt::FlatCap);
  looks_[2].setDashPattern({5.0, 4.0});
  if (outline_ != nullptr) outline_->setPen(looks_[1]);
  if (curve_ != nullptr) curve_->setPen(looks_[2]);
  for (std::size_t i = 0; i < buttons_.size(); ++i) buttons_[i]->set_look(looks_[i], theme.muted);
}

double Distribution::height(const Histogram& h, std::size_t bin) const {
  return what_ == PlotContent::Shows::kSpeeds ? h.density(bin) : static_cast<double>(h.counts[bin]);
}

void Distribution::draw_bins(QwtPlotHistogram& item, const Histogram& h) const {
  QVector<QwtIntervalSample> samples;
  for (std::size_t k = 0; k < h.counts.size(); ++k) {
    if (h.counts[k] > 0 || &item == outline_.get()) {
      samples.append(QwtIntervalSample(height(h, k), h.from(k), h.from(k + 1)));
    }
  }
  item.setSamples(samples);
}

void Distribution::update_from(const Recorder& recorder, const QwtInterval& time) {
  const SpeedRecord& speeds = recorder.speeds();
  const bool of_speeds = what_ == PlotContent::Shows::kSpeeds;
  const std::vector<double> now = of_speeds ? speeds.now() : strengths(recorder, time);
  now_width_ = steady_bin_width(now_width_, bin_width(now));
  now_ = histogram_of(now, now_width_);
  draw_bins(*bars_, now_);
  if (!of_speeds) return;
  if (mean_of_ != &recorder || mean_version_ != speeds.version() || mean_time_ != time) {
    mean_of_ = &recorder;
    mean_version_ = speeds.version();
    mean_time_ = time;
    const std::vector<double> all = speeds.between(time.minValue(), time.maxValue());
    mean_width_ = steady_bin_width(mean_width_, bin_width(all));
    mean_ = histogram_of(all, mean_width_);
    draw_bins(*outline_, mean_);
  }
  law_ = Maxwell(speeds.masses(), speeds.now());
  QVector<QPointF> points;
  const double end = x_spread().maxValue() * 2.0;  // the axis ends at the next round number
  for (int i = 0; i <= kCurvePoints && law_.thermal_energy() > 0.0; ++i) {
    const double v = end * i / kCurvePoints;
    points.append({v, law_.density(v)});
  }
  curve_->setSamples(points);
}

QwtInterval Distribution::x_spread() const {
  double end = now_.from(now_.counts.size());
  if (shows_mean()) end = std::max(end, mean_.quantile(kMost));
  return {0.0, end};
}

QwtInterval Distribution::spread() const {
  double top = 0.0;
  for (std::size_t k = 0; k < now_.counts.size(); ++k) top = std::max(top, height(now_, k));
  for (std::size_t k = 0; shows_mean() && k < mean_.counts.size(); ++k) top = std::max(top, height(mean_, k));
  if (curve_ != nullptr && curve_->isVisible()) top = std::max(top, curve_->maxYValue());
  return {0.0, top};
}

bool Distribution::shows_mean() const {
  return outline_ != nullptr && outline_->isVisible() && mean_.total > 0;
}

QString Distribution::readout(double x) const {
  const double bin = std::floor(x / now_.width);
  if (!(bin >= 0.0) || !(bin < static_cast<double>(now_.counts.size()))) return {};
  const auto k = static_cast<std::size_t>(bin);
  const QString unit = what_ == PlotContent::Shows::kSpeeds ? tr("m/s") : tr("N·s");
  const QString place =
      QString("%1 to %2 %3:  ").arg(figure(now_.from(k), 4), figure(now_.from(k + 1), 4), unit);
  const auto count = static_cast<double>(now_.counts[k]);
  if (what_ != PlotContent::Shows::kSpeeds) return place + tr("%1 impacts").arg(count);
  QString text = place + tr("%1 of %2 bodies").arg(count).arg(now_.total);
  if (law_.thermal_energy() > 0.0) {
    const double expected = law_.share_below(now_.from(k + 1)) - law_.share_below(now_.from(k));
    text += tr(", by Maxwell %1").arg(figure(expected * static_cast<double>(now_.total), 3));
  }
  return text;
}

std::vector<std::pair<QString, QPen>> Distribution::legend() const {
  std::vector<std::pair<QString, QPen>> entries;
  for (std::size_t i = 0; i < buttons_.size(); ++i) {
    if (buttons_[i]->isChecked()) entries.emplace_back(buttons_[i]->text(), looks_[i]);
  }
  return entries;
}

std::vector<ShownBins> Distribution::bins() const {
  if (what_ != PlotContent::Shows::kSpeeds) return {{QStringLiteral("impulses"), now_, {}}};
  return {{QStringLiteral("now"), now_, law_}, {QStringLiteral("mean"), mean_, law_}};
}

}  // namespace carom
