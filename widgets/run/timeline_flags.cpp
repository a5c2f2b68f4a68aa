#include "widgets/run/timeline_flags.h"

#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

namespace carom {
namespace {

constexpr double kHigh = 13.0;  // px, over the line
constexpr double kWide = 8.0;   // px, of the cloth
constexpr double kCloth = 7.0;  // px, its height
constexpr double kNear = 3.0;   // px, beside the pole

}  // namespace

void TimelineFlags::set_stops(const std::vector<Stop>& stops) {
  stops_ = stops;
  flags_.clear();
  for (std::size_t i = 0; i < stops.size(); ++i) {
    if (stops[i].kind == StopKind::kTime) flags_.push_back({.time = stops[i].time, .stop = i, .moves = true});
  }
}

void TimelineFlags::update_from(const Recorder& recorder, double least) {
  std::erase_if(flags_, [](const TimelineFlag& flag) { return !flag.moves; });
  for (TimelineFlag& flag : flags_) flag.met = flag.time <= recorder.time();
  if (recorder.stops() == nullptr || *recorder.stops() != stops_) return;
  std::vector<double> last(stops_.size(), -2.0 * least);
  for (const MetStop& met : recorder.met()) {
    if (stops_[met.stop].kind == StopKind::kTime || met.time - last[met.stop] < least) continue;
    last[met.stop] = met.time;
    flags_.push_back({.time = met.time, .stop = met.stop, .met = true});
  }
}

QString TimelineFlags::sentence(std::size_t stop) const {
  return stop < stops_.size() ? QString::fromStdString(sentence_of(stops_[stop])) : QString();
}

std::optional<TimelineFlag> TimelineFlags::at(double x, double y, double middle, const XOf& x_of) const {
  if (y > middle - kHigh + kCloth + 1.0) return std::nullopt;
  const auto under = [&](const TimelineFlag& flag) {
    return x >= x_of(flag.time) - kNear && x <= x_of(flag.time) + kWide + 1.0;
  };
  const auto found = std::find_if(flags_.rbegin(), flags_.rend(), under);
  return found == flags_.rend() ? std::nullopt : std::optional(*found);
}

void TimelineFlags::paint(QPainter& painter, const Theme& theme, double middle, const XOf& x_of,
                          std::optional<std::size_t> chosen) const {
  for (const TimelineFlag& flag : flags_) {
    const double x = x_of(flag.time);
    const QColor color = chosen == flag.stop ? theme.accent : theme.text;
    painter.setPen(QPen(color, 1.2));
    painter.drawLine(QPointF(x, middle + 3.0), QPointF(x, middle - kHigh));
    QPainterPath cloth(QPointF(x, middle - kHigh));
    cloth.lineTo(x + kWide, middle - kHigh + 0.5 * kCloth);
    cloth.lineTo(x, middle - kHigh + kCloth);
    cloth.closeSubpath();
    painter.setBrush(flag.met ? color : theme.panel);
    painter.drawPath(cloth);
  }
}

void TimelineFlags::drag_to(std::size_t stop, double time) {
  for (TimelineFlag& flag : flags_) {
    if (flag.stop == stop) flag.time = time;
  }
}

double round_to_pixel(double time, double pixel) {
  const double digits = std::pow(10.0, -std::floor(std::log10(pixel)));
  return std::round(time * digits) / digits;
}

}  // namespace carom
