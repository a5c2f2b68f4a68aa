#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "physics/math/vectors.h"

// Straight lines y = y0 + slope x by least squares, from a list of points or point by point.
namespace carom {

struct Line {
  double slope = std::numeric_limits<double>::quiet_NaN();
  double uncertainty = std::numeric_limits<double>::quiet_NaN();  // one standard error of the slope
  double farthest = 0.0;                                          // largest distance of a point, in y
};

// Needs two points with different x, and a third for the uncertainty. Non-finite input gives NaN.
[[nodiscard]] inline Line fit_line(std::span<const Vec2> points) {
  const auto n = static_cast<double>(points.size());
  Vec2 mean = Vec2::Zero();
  for (const Vec2& p : points) mean += p / n;
  double xx = 0.0;
  double xy = 0.0;
  for (const Vec2& p : points) {
    xx += (p.x() - mean.x()) * (p.x() - mean.x());
    xy += (p.x() - mean.x()) * (p.y() - mean.y());
  }
  Line line;
  line.slope = xy / xx;
  double squares = 0.0;
  for (const Vec2& p : points) {
    const double off = p.y() - mean.y() - line.slope * (p.x() - mean.x());
    line.farthest = std::max(line.farthest, std::abs(off));
    squares += off * off;
  }
  line.uncertainty = std::sqrt(squares / ((n - 2.0) * xx));
  return line;
}

// Mean and slope of points added one by one; none is stored (B. P. Welford, Technometrics 4 (1962) 419).
class RunningLine {
 public:
  void add(double x, double y) {
    n_ += 1.0;
    const double dx = x - mean_x_;
    mean_x_ += dx / n_;
    mean_y_ += (y - mean_y_) / n_;
    xx_ += dx * (x - mean_x_);
    xy_ += dx * (y - mean_y_);
  }
  [[nodiscard]] double mean() const { return mean_y_; }
  // NaN for fewer than two points.
  [[nodiscard]] double slope() const { return n_ < 2.0 ? std::numeric_limits<double>::quiet_NaN() : xy_ / xx_; }

 private:
  double n_ = 0.0;
  double mean_x_ = 0.0;
  double mean_y_ = 0.0;
  double xx_ = 0.0;
  double xy_ = 0.0;
};

}  // namespace carom
