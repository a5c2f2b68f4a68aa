#pragma once

#include <cmath>
#include <vector>

#include "physics/math/least_squares.h"

namespace carom::test {

// Slope of log error against log step.
inline double fitted_order(const std::vector<double>& steps, const std::vector<double>& errors) {
  std::vector<Vec2> points;
  for (std::size_t i = 0; i < steps.size(); ++i) points.emplace_back(std::log(steps[i]), std::log(errors[i]));
  return fit_line(points).slope;
}

}  // namespace carom::test
