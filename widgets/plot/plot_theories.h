#pragma once

#include <QPen>
#include <QString>
#include <memory>
#include <qwt_interval.h>
#include <utility>
#include <vector>

#include "physics/record/recorder.h"
#include "widgets/plot/plot_content.h"
#include "widgets/theme/theme.h"

class QwtPlot;

namespace carom {

class LegendButton;
class TheoryCurve;

// The closed forms of a plot's lines, drawn below the measured curves, and their one entry in the legend, which
// says so where they are those of the first scene.
class PlotTheories {
 public:
  PlotTheories(const PlotContent& content, QwtPlot* plot, QWidget* parent);
  ~PlotTheories();

  [[nodiscard]] LegendButton* button() const { return button_; }  // nullptr: there are none
  void set_shown(bool shown);
  void set_theme(const Theme& theme);
  void update_from(const Recorder& recorder, const QwtInterval& time);
  // The range of the value axis that includes them over `x` beside the measured range: at most its height more
  // on either side, since a closed form may diverge. Before the run has begun: most of what they will show.
  [[nodiscard]] QwtInterval spread(const QwtInterval& x, const QwtInterval& measured, bool begun) const;
  // Name and line of the visible ones.
  [[nodiscard]] std::vector<std::pair<QString, QPen>> legend() const;

 private:
  std::vector<std::pair<Curve, std::unique_ptr<TheoryCurve>>> curves_;
  LegendButton* button_ = nullptr;
  QPen pen_;
  bool shown_ = true;
};

}  // namespace carom
