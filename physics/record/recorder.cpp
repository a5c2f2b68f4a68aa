#include "physics/record/recorder.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace carom {

void Recorder::clear() {
  series_.clear();
  paths_.clear();
  impulses_ = {};
  speeds_.clear();
  poses_.clear();
  impacts_ = Ring<ImpactRecord>(kMostImpacts);
  stops_.reset();
  met_.clear();
  scales_ = {};
  time_ = 0.0;
}

void Recorder::keep(const std::vector<Curve>& curves) {
  const auto unwanted = [&](const auto& entry) {
    return std::find(curves.begin(), curves.end(), entry.first) == curves.end();
  };
  std::erase_if(series_, unwanted);
  std::erase_if(paths_, unwanted);
}

void Recorder::add(const Frame& frame) {
  if (frame.run != run_) {
    clear();
    run_ = frame.run;
  }
  time_ = frame.time;
  scales_ = frame.scales;
  for (const Rows& rows : frame.rows) add(rows);
  if (frame.bodies != nullptr) speeds_.set_now(frame.state, *frame.bodies);
  if (frame.back_to) {
    cut_impacts(*frame.back_to);
    poses_.cut(*frame.back_to);
  }
  poses_.add(frame.time, frame.state.q, frame.impact_count);
  for (const ImpactRecord& impact : frame.impacts) {
    impacts_.push(impact);
    impulses_.append({impact.time, {impact.normal_impulse}});
  }
  add_stops(frame);
}

void Recorder::add_stops(const Frame& frame) {
  if (std::exchange(stops_, frame.stops) != frame.stops) met_.clear();
  if (frame.back_to)
    std::erase_if(met_, [time = *frame.back_to](const MetStop& met) { return met.time > time; });
  met_.insert(met_.end(), frame.met.begin(), frame.met.end());
}

void Recorder::cut(double time) {
  for (auto& [curve, series] : series_) series.cut(time);
  for (auto& [curve, path] : paths_) path.cut(time);
  speeds_.cut(time);
  poses_.cut(time);
}

void Recorder::cut_impacts(double time) {
  impacts_.drop_back_while([time](const ImpactRecord& impact) { return impact.time > time; });
  impulses_.cut(std::nextafter(time, std::numeric_limits<double>::infinity()));
}

void Recorder::add(const Rows& rows) {
  if (rows.back_to) cut(*rows.back_to);
  std::size_t width = 0;
  for (const Curve& curve : *rows.curves) width += curve.x ? 2 : 1;
  std::size_t column = 0;
  for (const Curve& curve : *rows.curves) {
    if (rows.from_the_start) {
      series_.erase(curve);
      paths_.erase(curve);
    }
    const double* value = rows.values.empty() ? nullptr : rows.values.data() + column;
    if (curve.x) {
      Series<2>& path = paths_[curve];
      for (std::size_t i = 0; i < rows.size(); ++i, value += width) {
        path.append({rows.times[i], {value[0], value[1]}});
      }
    } else {
      Series<1>& series = series_[curve];
      for (std::size_t i = 0; i < rows.size(); ++i, value += width) series.append({rows.times[i], {*value}});
    }
    column += curve.x ? 2 : 1;
  }
  for (const SpeedMoment& moment : rows.moments) speeds_.add(moment);
}

const Series<1>* Recorder::series(const Curve& curve) const {
  const auto found = series_.find(curve);
  return found == series_.end() ? nullptr : &found->second;
}

const Series<2>* Recorder::path(const Curve& curve) const {
  const auto found = paths_.find(curve);
  return found == paths_.end() ? nullptr : &found->second;
}

}  // namespace carom
