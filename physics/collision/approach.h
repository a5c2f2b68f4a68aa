#pragma once

#include <utility>

#include "physics/collision/contact.h"
#include "physics/model/geometry.h"

namespace carom {

// The relative motion of two touching bodies along the normal.
struct Approach {
  Contact contact;
  double speed = 0.0;  // m/s along the normal at the contact point; negative: they approach
  double scale = 0.0;  // m/s: sum of both bodies' largest point speeds, for the rounding
};

// Where bodies a and b, at q = (x, y, angle), approach each other: in the middle of the stretch at which they
// touch, so that a face that lands flat is hit as a whole; if that does not approach, at the end that
// approaches fastest. Points whose gap is within `tolerance` (m) of the least one touch.
[[nodiscard]] Approach approach_of(const Geometry& g, BodyIndex a, const Eigen::Vector3d& qa,
                                   const Twist& twist_a, BodyIndex b, const Eigen::Vector3d& qb,
                                   const Twist& twist_b, double tolerance);
// Of these two parts alone.
[[nodiscard]] Approach approach_of(const Geometry& g, BodyIndex a, const Eigen::Vector3d& qa,
                                   const Twist& twist_a, BodyIndex b, const Eigen::Vector3d& qb,
                                   const Twist& twist_b, double tolerance, const ShapePair& parts);
// Where of that stretch these two parts approach fastest: its middle may all but rest meanwhile.
[[nodiscard]] Approach fastest_approach_of(const Geometry& g, BodyIndex a, const Eigen::Vector3d& qa,
                                           const Twist& twist_a, BodyIndex b, const Eigen::Vector3d& qb,
                                           const Twist& twist_b, double tolerance, const ShapePair& parts);

}  // namespace carom
