#pragma once

#include <QObject>
#include <QPointF>
#include <optional>

class QwtPlot;

namespace carom {

// Turns mouse and wheel events on a plot's canvas into requests about its axes, in the axes' units.
class PlotGestures : public QObject {
  Q_OBJECT

 public:
  explicit PlotGestures(QwtPlot* plot);

 signals:
  // Asks to scale the axis' range by `factor`, with `at` fixed.
  void timeZoomAsked(double at, double factor);
  void valueZoomAsked(double at, double factor);
  void panAsked(const QPointF& from, const QPointF& to);  // asks to move the point `from` to `to`
  void resetAsked(const QPointF& at);
  void clicked(const QPointF& at, Qt::KeyboardModifiers modifiers);  // not the end of a drag
  void hovered(const std::optional<QPointF>& at);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  [[nodiscard]] QPointF value_at(const QPointF& pixel) const;

  QwtPlot* plot_;
  std::optional<QPointF> grip_;  // position of the press or of the last drag event, in pixels
  bool dragging_ = false;
};

}  // namespace carom
