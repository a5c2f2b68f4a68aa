#include "widgets/scene/drawing_before.h"

#include <algorithm>

#include "widgets/scene/drawing_shapes.h"

namespace carom {

void add_run_before(const DrawingInput& in, const WorldRect& seen, Drawing& out) {
  constexpr double kPale = 0.55;  // of the scene's ground
  if (in.before == nullptr || !in.options.run_before) return;
  const QColor color = blend(in.theme.body_line, in.theme.scene_ground, kPale);
  const std::vector<Body>& bodies = *in.before->bodies;
  const Eigen::Matrix3Xd& q = in.before->q;
  const int count = std::min(static_cast<int>(q.cols()), static_cast<int>(bodies.size()));
  for (int i = 0; i < count; ++i) {
    const Body& body = bodies[static_cast<std::size_t>(i)];
    if (has_infinite_mass(body) || !q.col(i).allFinite()) continue;
    const Vec2 at = q.col(i).head<2>();
    if (seen.meets(at, bounding_radius(body.shape))) add_outline(body.shape, at, q(2, i), color, out);
  }
}

}  // namespace carom
