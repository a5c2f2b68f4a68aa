#pragma once

#include <QColor>
#include <QObject>
#include <QString>
#include <QStringList>

class QHBoxLayout;
class QLabel;
class QwtPlot;

namespace carom {

// What stands over a plot's canvas, so that it takes no room from it: the values where the mouse is, and a chip
// while the plot is zoomed.
class PlotLabels : public QObject {
 public:
  explicit PlotLabels(QwtPlot* plot);

  void set_color(const QColor& color);
  void set_zoomed(bool zoomed);
  void hide_values();
  void show_values(const QString& text);
  // All in one line if it fits: head, then the values, with `unit` behind each line. Else one below the other,
  // on the side where the place `x` (px, in the canvas) is not.
  void show_values(const QString& head, const QStringList& values, const QString& unit, double x);

 private:
  QwtPlot* plot_;
  QHBoxLayout* row_;
  QLabel* values_;
  QLabel* zoomed_;
};

}  // namespace carom
