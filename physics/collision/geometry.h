#pragma once

#include <cstdint>
#include <vector>

#include "physics/collision/contact.h"
#include "physics/motion/state.h"
#include "physics/scene/scene.h"

namespace carom {

// The shapes of N bodies as arrays. Every shape here is a core rectangle of half extents (a, b) grown by a
// rounding radius: a disc is a point core with its radius, a box a core without rounding.
struct Geometry {
  Eigen::Matrix2Xd half;     // m, 2×N
  Eigen::VectorXd rounding;  // m
  Eigen::Matrix2Xd extent;  // m, 2×N, half the axis-aligned rectangle around the body at its initial angle; it
                            // stays so, because the bodies that turn are discs
  std::vector<std::uint8_t> fixed;  // immovable: fixed or driven
};

[[nodiscard]] Geometry geometry(const std::vector<Body>& bodies);

// Contact of bodies a and b at poses qa, qb = (x, y, angle). At least one of them must be a disc (moving boxes
// are not modelled), anywhere: also with its centre inside the box, where the nearest face is the way out.
// Coincident centres of two discs get the normal +x.
[[nodiscard]] Contact contact_between(const Geometry& g, int a, const Eigen::Vector3d& qa, int b,
                                      const Eigen::Vector3d& qb);

}  // namespace carom
