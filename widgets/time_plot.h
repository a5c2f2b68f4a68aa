#pragma once

#include <QFrame>
#include <QPointF>
#include <memory>
#include <optional>
#include <qwt_interval.h>
#include <vector>

#include "physics/measure/recorder.h"
#include "widgets/plot_table.h"
#include "widgets/theme.h"

class QLabel;
class QwtPlot;
class QwtPlotCurve;
class QwtPlotGrid;
class QwtPlotMarker;

namespace carom {

class DecimatedSeries;
class LegendButton;

// One plot of the table over time, with title, unit and legend. The time axis is its owner's to set: several
// plots share it. Changes show at the next replot().
class TimePlot : public QFrame {
  Q_OBJECT

 public:
  TimePlot(const PlotKind& kind, const Theme& theme, QWidget* parent = nullptr);
  ~TimePlot() override;

  void set_theme(const Theme& theme);
  void set_time_range(const QwtInterval& range);
  // Reads what the time range shows; fits the value axis to the visible curves unless `hold_values`.
  void update_from(const Recorder& recorder, bool hold_values);
  // The room in px that the value axis' labels take, and the room that they are to take at least.
  [[nodiscard]] int label_extent() const;
  void set_label_extent(int extent);
  void set_cursor(std::optional<double> time);
  void set_chip_visible(bool visible);
  void replot();

  void forget_value_range() { value_range_ = QwtInterval(); }  // the next fit starts anew
  void zoom_values(double at, double factor);
  void pan_values(double by);

  [[nodiscard]] const PlotKind& kind() const { return kind_; }
  [[nodiscard]] QwtInterval time_range() const { return time_range_; }
  [[nodiscard]] QwtInterval value_range() const;
  [[nodiscard]] QwtPlot* plot() const { return plot_; }

 signals:
  void timeZoomAsked(double at, double factor);
  void valueZoomAsked(double at, double factor);
  void panAsked(const QPointF& by);
  void resetAsked();
  void curvesChanged();  // one was shown or hidden
  void timeHovered(const std::optional<double>& time);

 private:
  struct Curve {
    std::unique_ptr<QwtPlotCurve> item;
    DecimatedSeries* series;  // owned by the item
    LegendButton* button;
  };

  void set_heads(const Curve& curve);
  void build_header();
  void build_plot();
  void set_value_range(const QwtInterval& range);
  void show_readout(const std::optional<QPointF>& at);

  const PlotKind& kind_;
  QwtInterval time_range_{0.0, 1.0};
  QwtInterval value_range_;
  QLabel* unit_ = nullptr;
  QwtPlot* plot_ = nullptr;
  QLabel* chip_ = nullptr;
  QLabel* readout_ = nullptr;
  std::unique_ptr<QwtPlotGrid> grid_;
  std::unique_ptr<QwtPlotMarker> cursor_;
  std::vector<Curve> curves_;
};

}  // namespace carom
