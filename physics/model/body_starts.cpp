#include "physics/model/body_starts.h"

#include "physics/scene/drive.h"

namespace carom {

BodyStarts body_starts(const std::vector<Body>& bodies, double time) {
  const auto n = static_cast<Eigen::Index>(bodies.size());
  BodyStarts starts{Eigen::Matrix3Xd(3, n), Eigen::Matrix3Xd(3, n)};
  for (Eigen::Index i = 0; i < n; ++i) {
    const Body now = moved_by_drive(bodies[static_cast<std::size_t>(i)], time);
    starts.q.col(i) << now.position, now.angle;
    starts.v.col(i) << now.velocity, now.spin;
  }
  return starts;
}

DriveTerms drive_terms(const std::vector<Body>& bodies) {
  DriveTerms terms;
  for (const Body& body : bodies) {
    terms.of.push_back(body.drive ? static_cast<int>(terms.all.size()) : -1);
    if (body.drive) terms.all.push_back({*body.drive, body.position});
  }
  return terms;
}

}  // namespace carom
