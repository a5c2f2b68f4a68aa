#pragma once

#include <QFrame>
#include <QPen>
#include <QPointF>
#include <array>
#include <memory>
#include <optional>
#include <qwt_interval.h>
#include <span>
#include <vector>

#include "physics/preset/preset.h"
#include "physics/record/recorder.h"
#include "widgets/base/plotted_run.h"
#include "widgets/plot/plot_axes.h"
#include "widgets/plot/plot_content.h"
#include "widgets/theme/theme.h"

class QLabel;
class QwtPlot;
class QwtPlotCurve;
class QwtPlotGrid;
class QwtPlotMarker;

namespace carom {

class DecimatedSeries;
class Distribution;
class LegendButton;
class LegendRow;
class PlotBefore;
class PlotLabels;
class PlotNotes;
class PlotPlayhead;
class PlotTheories;
struct PaleRun;
class ZoomBox;

// One plot with title, unit and legend. Over time, the owner sets the time axis, which several plots share.
// Over another quantity it shows the path within that time, with an x axis of its own. Changes appear at the
// next replot().
class RunPlot : public QFrame {
  Q_OBJECT

 public:
  RunPlot(PlotContent content, const Theme& theme, QWidget* parent = nullptr);
  ~RunPlot() override;

  void set_theme(const Theme& theme);
  void set_time_range(const QwtInterval& range);
  // Reads the records within the time range; fits the other axes to the visible curves unless `hold`. Each of
  // several runs has its own colour and dash.
  void update_from(const std::vector<PlottedRun>& runs, bool hold);
  // The run before, shown pale below the others; `bodies` are those of the present run. None: none is shown.
  void set_run_before(const std::optional<PaleRun>& run, std::span<const Body> bodies);
  // The time under the mouse: a line there, and the values of the visible curves.
  void set_cursor(std::optional<double> time);
  // The user's two marks, A and B.
  void set_marks(std::optional<double> a, std::optional<double> b);
  // A line at the moment that is shown, if it is not the newest one (s).
  void set_playhead(std::optional<double> time);
  void set_chip_visible(bool visible);
  void replot();

  [[nodiscard]] PlotAxes& axes() { return *axes_; }
  [[nodiscard]] const PlotAxes& axes() const { return *axes_; }
  // The user's notes, which are part of the plot; the note at a point of the canvas, in px.
  void set_notes(const std::vector<PlotNote>& notes);
  [[nodiscard]] std::optional<std::size_t> note_at(const QPointF& pixel) const;
  [[nodiscard]] const PlotContent& content() const { return content_; }
  // Whether the x axis is time.
  [[nodiscard]] bool over_time() const { return !content_.plot.x && distribution_ == nullptr; }
  // The histogram; nullptr for lines.
  [[nodiscard]] const Distribution* distribution() const { return distribution_.get(); }
  [[nodiscard]] QwtInterval time_range() const { return time_range_; }
  [[nodiscard]] QwtInterval value_range() const { return axes_->values(); }
  [[nodiscard]] QwtPlot* plot() const { return plot_; }
  [[nodiscard]] const Theme& theme() const { return theme_; }
  // Name and line of each run, if there are several, and of each visible curve with a name.
  [[nodiscard]] std::vector<std::pair<QString, QPen>> legend() const;
  // Time of the newest record not after `time`; `time` itself if nothing is recorded.
  [[nodiscard]] double snapped(double time) const;

 signals:
  void timeZoomAsked(double at, double factor);
  void valueZoomAsked(double at, double factor);
  void panAsked(const QPointF& from, const QPointF& to);
  void boxAsked(const QRectF& box);  // in the axes' units
  void resetAsked();
  void curvesChanged();  // a curve was shown or hidden
  void timeHovered(const std::optional<double>& time);
  void timeClicked(double time, bool second);  // second: with Shift
  void impactClicked(double time);             // s, of a recorded impact
  // A drag of the head of the line at the shown moment.
  void scrubBegan();
  void scrubbed(double time);  // s
  void scrubEnded();

 private:
  struct Item {
    std::unique_ptr<QwtPlotCurve> item;
    DecimatedSeries* series;  // owned by the item
  };
  struct Line {
    LegendButton* button;
    std::vector<Item> items;  // of each run
  };

  [[nodiscard]] bool is_main(std::size_t line) const;
  [[nodiscard]] QPen pen(std::size_t line, std::size_t run) const;
  void set_runs(const std::vector<PlottedRun>& runs);
  void set_looks();
  [[nodiscard]] bool shows(std::size_t line) const;
  void set_heads(const Item& curve);
  void update_distribution(const Recorder& recorder, bool hold);
  void build_header();
  void build_plot();
  void show_readout();
  void hover(const std::optional<QPointF>& at);
  void click(const QPointF& at, bool second);
  [[nodiscard]] std::optional<double> impact_at(const QPointF& at) const;  // s; in the axes' units
  [[nodiscard]] const Series<1>* series_of(std::size_t line, std::size_t run) const;

  PlotContent content_;
  Theme theme_;
  std::vector<PlottedRun> runs_;  // of the last update
  std::optional<double> cursor_time_;
  QwtInterval time_range_{0.0, 1.0};
  QLabel* unit_ = nullptr;
  QwtPlot* plot_ = nullptr;
  std::unique_ptr<PlotAxes> axes_;
  ZoomBox* zoom_box_ = nullptr;
  PlotLabels* labels_ = nullptr;
  LegendRow* legend_ = nullptr;
  std::unique_ptr<QwtPlotGrid> grid_;
  std::unique_ptr<QwtPlotMarker> cursor_;
  PlotPlayhead* playhead_ = nullptr;
  std::array<std::unique_ptr<QwtPlotMarker>, 2> marks_;
  std::vector<Line> lines_;
  std::unique_ptr<PlotTheories> theories_;
  std::unique_ptr<PlotBefore> before_;
  std::unique_ptr<Distribution> distribution_;
  std::unique_ptr<PlotNotes> notes_;
};

}  // namespace carom
