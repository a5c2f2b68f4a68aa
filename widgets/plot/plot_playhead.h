#pragma once

#include <QColor>
#include <QObject>
#include <optional>

class QMouseEvent;
class QwtPlot;

namespace carom {

// The moment that is shown, in a plot over time: a dashed line, and at its top a head that the mouse can drag,
// with Shift ten times finer. A drag goes on where the line is hidden meanwhile.
class PlotPlayhead : public QObject {
  Q_OBJECT

 public:
  explicit PlotPlayhead(QwtPlot* plot);
  ~PlotPlayhead() override;

  void set_color(const QColor& color);
  void set_time(std::optional<double> time);  // s; none: hidden
  // px, of the head's middle on the canvas.
  [[nodiscard]] std::optional<QPointF> head() const;

 signals:
  void scrubBegan();
  void scrubbed(double time);  // s, not before 0
  void scrubEnded();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  class Line;
  // A drag.
  struct Scrub {
    double x = 0.0;     // px, of the last event
    double time = 0.0;  // s, there
  };

  [[nodiscard]] bool on_head(const QMouseEvent& mouse) const;
  bool press(const QMouseEvent& mouse);
  bool move(const QMouseEvent& mouse);

  QwtPlot* plot_;
  Line* line_;  // the plot has it while it is attached
  std::optional<double> time_;
  std::optional<Scrub> scrub_;
};

}  // namespace carom
