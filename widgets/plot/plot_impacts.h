#pragma once

#include <QPointF>
#include <optional>

#include "physics/record/recorder.h"

class QwtPlot;

namespace carom {

// s: the impact at a point of the canvas (px) of a plot over time. Of a plot with a bar for each impact it is
// the bar there; else the impact whose time is there, unless others are so near that they can't be told apart.
[[nodiscard]] std::optional<double> impact_under(const QwtPlot& plot, const Recorder& recorder, bool bars,
                                                 const QPointF& at);

}  // namespace carom
