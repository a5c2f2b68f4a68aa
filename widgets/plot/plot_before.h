#pragma once

#include <QPen>
#include <QString>
#include <memory>
#include <optional>
#include <qwt_interval.h>
#include <span>
#include <utility>
#include <vector>

#include "widgets/base/run_before.h"
#include "widgets/plot/plot_content.h"
#include "widgets/theme/theme.h"

class QwtPlot;
class QwtPlotCurve;

namespace carom {

class DecimatedSeries;
class LegendButton;

// The run before, as plots show it.
struct PaleRun {
  RunBefore run;
  double shift = 0.0;  // s, from its clock to the present run's
  double reach = 0.0;  // s, by the present clock: the plots' time reaches at least up to here

  [[nodiscard]] bool same_as(const PaleRun& other) const {
    return run.recorder == other.run.recorder && run.from == other.run.from && shift == other.shift &&
           reach == other.reach;
  }
};

// The same curve of a run with other bodies, which it knows by their places; none without one of the bodies.
[[nodiscard]] std::optional<Curve> curve_among(const Curve& curve, std::span<const Body> bodies,
                                               std::span<const Body> others);

// The curves of the run before, pale below those of the present runs, and their one entry in the legend.
class PlotBefore {
 public:
  PlotBefore(const PlotContent& content, QwtPlot* plot, QWidget* parent);
  ~PlotBefore();

  [[nodiscard]] LegendButton* button() const { return button_; }
  // `bodies`: of the present run. None: no run is shown.
  void set_run(const std::optional<PaleRun>& run, std::span<const Body> bodies);
  // Whether it has any of the curves.
  [[nodiscard]] bool there() const;
  void set_shown(bool shown);
  void set_line_shown(std::size_t line, bool shown);
  // `pens`: of the present run's curves.
  void set_theme(const Theme& theme, const std::vector<QPen>& pens);
  // Reads the record within this time of the present clock, for so many columns of pixels.
  void update_from(const QwtInterval& time, int columns);
  // Of the visible curves, and along x; invalid without any.
  [[nodiscard]] QwtInterval spread() const;
  [[nodiscard]] QwtInterval x_spread() const;
  // Name and line, if it is shown.
  [[nodiscard]] std::vector<std::pair<QString, QPen>> legend() const;

 private:
  struct Line {
    std::unique_ptr<QwtPlotCurve> item;
    DecimatedSeries* series;  // owned by the item
    std::optional<Curve> wanted;
    std::optional<Curve> curve{};  // the same, of the run before; none: it has no such curve
    bool shown = true;
  };
  [[nodiscard]] bool has(const Line& line) const;
  [[nodiscard]] QRectF bounds(const Line& line) const;
  void take(const Line& line, const QwtInterval& time, int columns) const;
  void show_lines();

  QwtPlot* plot_;
  std::optional<PaleRun> run_;
  bool magnitudes_;
  std::vector<Line> lines_;
  LegendButton* button_;
  QPen pen_;  // in the legend
  bool shown_ = true;
  std::pair<QwtInterval, int> taken_{};  // what was read last
};

}  // namespace carom
