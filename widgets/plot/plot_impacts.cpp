#include "widgets/plot/plot_impacts.h"

#include <cmath>
#include <qwt_axis.h>
#include <qwt_plot.h>
#include <vector>

namespace carom {
namespace {

constexpr double kReach = 4.0;  // px, to both sides
constexpr double kApart = 8.0;  // px, between two that can be told apart
constexpr double kOne = 1.0;    // px: within it they are one to the eye
constexpr double kHead = 5.0;   // px, above the end of a bar

}  // namespace

std::optional<double> impact_under(const QwtPlot& plot, const Recorder& recorder, bool bars,
                                   const QPointF& at) {
  const auto time = [&](double x) { return plot.invTransform(QwtAxis::XBottom, x); };
  std::vector<SeriesPoint<1>> near;
  recorder.impulses().read(time(at.x() - kReach - kApart), time(at.x() + kReach + kApart), near);
  const auto x_of = [&](const SeriesPoint<1>& impact) { return plot.transform(QwtAxis::XBottom, impact.at); };
  const SeriesPoint<1>* found = nullptr;
  for (const SeriesPoint<1>& impact : near) {
    const double distance = std::abs(x_of(impact) - at.x());
    const bool beside = bars && plot.transform(QwtAxis::YLeft, impact.value[0]) > at.y() + kHead;
    if (distance > kReach || beside) continue;
    if (found == nullptr || distance <= std::abs(x_of(*found) - at.x())) found = &impact;
  }
  if (found == nullptr) return std::nullopt;
  for (const SeriesPoint<1>& impact : near) {
    const double apart = std::abs(x_of(impact) - x_of(*found));
    if (!bars && apart > kOne && apart < kApart) return std::nullopt;
  }
  return found->at;
}

}  // namespace carom
