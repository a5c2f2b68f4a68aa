#include "widgets/scene/drawing_others.h"

#include <algorithm>
#include <cmath>

#include "widgets/base/number_text.h"
#include "widgets/base/plotted_run.h"
#include "widgets/scene/drawing_shapes.h"

namespace carom {
namespace {

constexpr double kDistanceWidth = 1.2;   // px
constexpr double kLeastDistance = 3.0;   // px, shorter ones are left out
constexpr double kLeastLabelled = 40.0;  // px
constexpr int kMostLabelled = 3;         // moving bodies
constexpr double kAtOnce = 1e-9;         // s

}  // namespace

void add_other_runs(const DrawingInput& in, const WorldRect& seen, Drawing& out) {
  for (std::size_t k = 0; k < in.others.size(); ++k) {
    const Frame& other = *in.others[k];
    const QColor color = pen_of_run(k + 1, in.theme).color();
    const std::vector<Body>& bodies = *other.bodies;
    const State& there = other.state;
    const auto moving =
        std::count_if(bodies.begin(), bodies.end(), [](const Body& b) { return !has_infinite_mass(b); });
    const int count = std::min({there.size(), in.frame.state.size(), static_cast<int>(bodies.size())});
    for (int i = 0; i < count; ++i) {
      const Body& body = bodies[static_cast<std::size_t>(i)];
      if (has_infinite_mass(body) || !there.q.col(i).allFinite()) continue;
      const Vec2 at = there.position(i);
      const Vec2 from = in.frame.state.position(i);
      const double distance = from.allFinite() ? (at - from).norm() : 0.0;
      if (!seen.meets(at, bounding_radius(body.shape) + distance)) continue;
      add_outline(body.shape, at, there.q(2, i), color, out);
      if (!(distance * in.camera.scale >= kLeastDistance)) continue;
      out.segments.push_back({from, at, color, kDistanceWidth * in.options.line_scale});
      // No label between frames of different times: the distance would include motion in time.
      const bool at_once = std::abs(other.time - in.frame.time) < kAtOnce;
      if (!at_once || moving > kMostLabelled || distance * in.camera.scale < kLeastLabelled) continue;
      out.labels.push_back({0.5 * (from + at), 3.0, figure(distance, 3) + " m", color});
    }
  }
}

}  // namespace carom
