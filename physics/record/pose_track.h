#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace carom {

// Where the bodies of a run stood at moments of the past, in bounded memory: when it is full, every second
// moment goes, and further ones come at twice the distance. The newest one is always known. Nothing is kept of
// scenes with more than kMostBodies bodies. Single precision: it is for the eye.
class PoseTrack {
 public:
  static constexpr Eigen::Index kMostBodies = 300;
  static constexpr std::size_t kMostBytes = 4'000'000;
  // s: between moments that are farther apart nothing is known.
  static constexpr double kLongestGap = 0.15;

  void clear();
  // q: x, y and angle (m, m, rad) of each body; `impacts`: how many there have been. A moment that is not after
  // the newest one replaces it, and all that it is before.
  void add(double time, const Eigen::Matrix3Xd& q, std::int64_t impacts);
  void cut(double time);  // drops the moments from it on

  // Linear between two moments, of the bodies of both; none before the first moment and after the last, and
  // none between two with an impact in between: where paths bend there is not known.
  [[nodiscard]] std::optional<Eigen::Matrix3Xd> at(double time) const;
  [[nodiscard]] std::size_t size() const { return moments_.size(); }
  [[nodiscard]] std::size_t bytes() const { return bytes_; }

 private:
  struct Moment {
    double time;  // s
    std::int64_t impacts;
    Eigen::Matrix3Xf q;
    [[nodiscard]] std::size_t bytes() const {
      return sizeof(Moment) + static_cast<std::size_t>(q.size()) * sizeof(float);
    }
  };

  void drop_last();
  void thin();

  std::vector<Moment> moments_;  // in the order of time
  std::size_t bytes_ = 0;        // of all moments
  double distance_ = 0.0;        // s, least between two moments, but for the newest
};

}  // namespace carom
