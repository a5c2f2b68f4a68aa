#pragma once

#include <map>
#include <memory>
#include <vector>

#include "physics/record/frame.h"
#include "physics/record/series.h"

namespace carom {

// What plots and tables show of a run: each curve as a series whose memory is bounded, and the newest impacts.
class Recorder {
 public:
  static constexpr std::size_t kMostImpacts = 100'000;

  void clear();
  // Forgets the other curves.
  void keep(const std::vector<Curve>& curves);
  // Takes what happened since the frame before; a frame of another run starts anew.
  void add(const Frame& frame);

  // Of a curve over time; nullptr if it is not recorded.
  [[nodiscard]] const Series<1>* series(const Curve& curve) const;
  // Of a curve over another quantity: y, then x.
  [[nodiscard]] const Series<2>* path(const Curve& curve) const;
  // The normal impulses of all impacts, N s.
  [[nodiscard]] const Series<1>& impulses() const { return impulses_; }
  // The newest kMostImpacts of them.
  [[nodiscard]] const Ring<ImpactRecord>& impacts() const { return impacts_; }
  [[nodiscard]] const SpeedRecord& speeds() const { return speeds_; }
  [[nodiscard]] const Scales& scales() const { return scales_; }
  [[nodiscard]] double time() const { return time_; }       // s, of the newest frame
  [[nodiscard]] std::uint64_t run() const { return run_; }  // whose frames it has; 0: none yet

 private:
  void add(const Rows& rows);

  std::uint64_t run_ = 0;
  double time_ = 0.0;
  std::map<Curve, Series<1>> series_;
  std::map<Curve, Series<2>> paths_;
  Series<1> impulses_;
  Ring<ImpactRecord> impacts_{kMostImpacts};
  SpeedRecord speeds_;
  Scales scales_;
};

}  // namespace carom
