#pragma once

#include "physics/collision/contact.h"
#include "physics/model/geometry.h"

namespace carom {

// How two touching bodies move against each other.
struct Approach {
  Contact contact;
  double speed = 0.0;  // m/s along the normal at the contact point; negative: they approach
  double scale = 0.0;  // m/s: how fast their points move at the most, the sum of both; for its rounding
};

// Where bodies a and b, at q = (x, y, angle), approach each other if they do: the middle of what they touch at,
// so that a face that lands flat is met as a whole; else that end of it which approaches fastest. Gaps up to
// `tolerance` (m) beyond the least one count as touch.
[[nodiscard]] Approach approach_of(const Geometry& g, int a, const Eigen::Vector3d& qa, const Twist& twist_a,
                                   int b, const Eigen::Vector3d& qb, const Twist& twist_b, double tolerance);

}  // namespace carom
