#pragma once

#include <map>
#include <memory>
#include <vector>

#include "physics/record/frame.h"
#include "physics/record/pose_track.h"
#include "physics/record/series.h"

namespace carom {

// Data of a run for plots and tables: each curve as a series of bounded memory, and the newest impacts.
class Recorder {
 public:
  static constexpr std::size_t kMostImpacts = 100'000;

  void clear();
  // Drops all other curves.
  void keep(const std::vector<Curve>& curves);
  // Adds the changes since the previous frame; a frame of another run clears everything first, one of a run
  // that has gone back drops what came after.
  void add(const Frame& frame);

  // The speeds now are those of this frame, a moment of the record.
  void show(const Frame& frame) { speeds_.set_now(frame.state, *frame.bodies); }

  // Series of a curve over time; nullptr if it is not recorded.
  [[nodiscard]] const Series<1>* series(const Curve& curve) const;
  // Series of a curve over another quantity: y, then x.
  [[nodiscard]] const Series<2>* path(const Curve& curve) const;
  // The normal impulses of all impacts, N s.
  [[nodiscard]] const Series<1>& impulses() const { return impulses_; }
  // The newest kMostImpacts of them.
  [[nodiscard]] const Ring<ImpactRecord>& impacts() const { return impacts_; }
  // Where the run met stops, in the order of time, and the list of these.
  [[nodiscard]] const std::vector<MetStop>& met() const { return met_; }
  [[nodiscard]] const std::shared_ptr<const std::vector<Stop>>& stops() const { return stops_; }
  [[nodiscard]] const SpeedRecord& speeds() const { return speeds_; }
  // Where the bodies stood in the frames.
  [[nodiscard]] const PoseTrack& poses() const { return poses_; }
  [[nodiscard]] const Scales& scales() const { return scales_; }
  [[nodiscard]] double time() const { return time_; }       // s, of the newest frame
  [[nodiscard]] std::uint64_t run() const { return run_; }  // of its frames; 0: none yet

 private:
  void add(const Rows& rows);
  void add_stops(const Frame& frame);
  void cut(double time);
  void cut_impacts(double time);

  std::uint64_t run_ = 0;
  double time_ = 0.0;
  std::map<Curve, Series<1>> series_;
  std::map<Curve, Series<2>> paths_;
  Series<1> impulses_;
  Ring<ImpactRecord> impacts_{kMostImpacts};
  std::shared_ptr<const std::vector<Stop>> stops_;
  std::vector<MetStop> met_;
  SpeedRecord speeds_;
  PoseTrack poses_;
  Scales scales_;
};

}  // namespace carom
