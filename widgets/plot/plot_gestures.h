#pragma once

#include <QObject>
#include <QPointF>
#include <optional>

class QwtPlot;

namespace carom {

// Turns mouse and wheel on a plot's canvas into wishes about its axes, in the axes' units.
class PlotGestures : public QObject {
  Q_OBJECT

 public:
  explicit PlotGestures(QwtPlot* plot);

 signals:
  // The axis' range is to become `factor` as wide, with `at` where it is.
  void timeZoomAsked(double at, double factor);
  void valueZoomAsked(double at, double factor);
  void panAsked(const QPointF& from, const QPointF& to);  // what was at `from` is to come to `to`
  void resetAsked();
  void clicked(const QPointF& at, Qt::KeyboardModifiers modifiers);  // not the end of a drag
  void hovered(const std::optional<QPointF>& at);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  [[nodiscard]] QPointF value_at(const QPointF& pixel) const;

  QwtPlot* plot_;
  std::optional<QPointF> grip_;  // where the button went down or the drag was last, in pixels
  bool dragging_ = false;
};

}  // namespace carom
