#include "physics/record/pose_track.h"

#include <algorithm>
#include <utility>

namespace carom {

void PoseTrack::clear() { *this = {}; }

void PoseTrack::drop_last() {
  bytes_ -= moments_.back().bytes();
  moments_.pop_back();
}

void PoseTrack::cut(double time) {
  while (!moments_.empty() && moments_.back().time >= time) drop_last();
}

void PoseTrack::add(double time, const Eigen::Matrix3Xd& q, std::int64_t impacts) {
  if (q.cols() > kMostBodies) return clear();
  cut(time);
  const std::size_t count = moments_.size();
  // The newest one so far stands too near to the one before to be kept.
  if (count > 1 && moments_[count - 1].time - moments_[count - 2].time < distance_) drop_last();
  moments_.push_back({time, impacts, q.cast<float>()});
  bytes_ += moments_.back().bytes();
  if (bytes_ > kMostBytes) thin();
}

void PoseTrack::thin() {
  const double span = moments_.back().time - moments_.front().time;
  distance_ = std::max(2.0 * distance_, 2.0 * span / static_cast<double>(moments_.size()));
  std::vector<Moment> rest;
  bytes_ = 0;
  for (std::size_t i = 0; i < moments_.size(); i += 2) {
    bytes_ += moments_[i].bytes();
    rest.push_back(std::move(moments_[i]));
  }
  moments_ = std::move(rest);
}

std::optional<Eigen::Matrix3Xd> PoseTrack::at(double time) const {
  const auto after = std::lower_bound(moments_.begin(), moments_.end(), time,
                                      [](const Moment& moment, double t) { return moment.time < t; });
  if (after == moments_.end()) return std::nullopt;
  if (after->time == time) return after->q.cast<double>();
  if (after == moments_.begin()) return std::nullopt;
  const Moment& before = *(after - 1);
  const double gap = after->time - before.time;
  if (gap > kLongestGap || after->impacts != before.impacts) return std::nullopt;
  const Eigen::Index count = std::min(before.q.cols(), after->q.cols());
  const Eigen::Matrix3Xd from = before.q.leftCols(count).cast<double>();
  const Eigen::Matrix3Xd to = after->q.leftCols(count).cast<double>();
  return from + (time - before.time) / gap * (to - from);
}

}  // namespace carom
