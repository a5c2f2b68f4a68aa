#pragma once

#include <QString>
#include <memory>
#include <qwt_interval.h>
#include <utility>
#include <vector>

#include "physics/observe/histogram.h"
#include "physics/record/recorder.h"
#include "widgets/plot/plot_content.h"
#include "widgets/theme/theme.h"

class QwtPlot;
class QwtPlotCurve;
class QwtPlotHistogram;

namespace carom {

class LegendButton;

// The bins of one distribution, with the law beside it if there is one.
struct ShownBins {
  QString name;
  Histogram bins;
  Maxwell law;  // empty if there is none
};

// Draws a histogram: the present speeds of all moving bodies as bars, Maxwell's law at their energy as a
// curve, and the mean over the visible time as an outline; or the strengths of that time's impacts as bars.
class Distribution {
 public:
  // Attaches itself to the plot; `parent` owns the entries of the legend.
  Distribution(PlotContent::Shows what, QwtPlot* plot, QWidget* parent);
  ~Distribution();

  [[nodiscard]] const std::vector<LegendButton*>& buttons() const { return buttons_; }
  void set_shown(std::size_t button, bool shown);
  void set_theme(const Theme& theme);
  void update_from(const Recorder& recorder, const QwtInterval& time);
  // Ranges for the axes, from zero on.
  [[nodiscard]] QwtInterval x_spread() const;
  [[nodiscard]] QwtInterval spread() const;
  // Content of the bin at x.
  [[nodiscard]] QString readout(double x) const;
  [[nodiscard]] std::vector<std::pair<QString, QPen>> legend() const;
  [[nodiscard]] std::vector<ShownBins> bins() const;

 private:
  [[nodiscard]] double height(const Histogram& h, std::size_t bin) const;
  [[nodiscard]] bool shows_mean() const;
  void draw_bins(QwtPlotHistogram& item, const Histogram& h) const;

  PlotContent::Shows what_;
  std::unique_ptr<QwtPlotHistogram> bars_;
  std::unique_ptr<QwtPlotHistogram> outline_;
  std::unique_ptr<QwtPlotCurve> curve_;
  std::vector<LegendButton*> buttons_;  // for the bars, the outline, the curve; none for impacts
  std::vector<QPen> looks_;
  Histogram now_;   // bars
  Histogram mean_;  // outline
  Maxwell law_;
  double now_width_ = 0.0;  // previous widths, so that bins do not flicker
  double mean_width_ = 0.0;
  // Key of the cached mean: with many bodies it takes some ms to compute.
  const Recorder* mean_of_ = nullptr;
  std::uint64_t mean_version_ = 0;
  QwtInterval mean_time_;
};

}  // namespace carom
