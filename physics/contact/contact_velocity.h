#pragma once

#include <Eigen/Core>

#include "physics/contact/contact_rows.h"
#include "physics/contact/contacts.h"
#include "physics/math/vectors.h"

namespace carom {

// Relative velocity of two bodies with the velocities a and b (m/s, m/s, rad/s) at a contact with this normal
// and these arms.
[[nodiscard]] inline RowVelocity contact_velocity(const Vec2& normal, const Vec2& arm_a, const Vec2& arm_b,
                                                  const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  const Vec2 d = (b - a).head<2>();
  return {d.dot(normal) + b[2] * cross(arm_b, normal) - a[2] * cross(arm_a, normal),
          cross(normal, d) + b[2] * arm_b.dot(normal) - a[2] * arm_a.dot(normal), b[2] - a[2]};
}
// Likewise of the bodies at contact i, for the velocities v of all bodies (3×N).
[[nodiscard]] inline RowVelocity contact_velocity(const Contacts& c, int i, const Eigen::Matrix3Xd& v) {
  return contact_velocity(c.normal[i], c.arm_a[i], c.arm_b[i], v.col(c.a[i]), v.col(c.b[i]));
}

}  // namespace carom
