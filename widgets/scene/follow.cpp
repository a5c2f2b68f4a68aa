#include "widgets/scene/follow.h"

#include <algorithm>

#include "physics/scene/shape.h"

namespace carom {
namespace {

constexpr qint64 kOfferedAfter = 1000;  // ms

template <class Visit>
void visit_moving(const Frame& frame, const Visit& visit) {
  if (!frame.bodies) return;
  const int count = std::min(frame.state.size(), static_cast<int>(frame.bodies->size()));
  for (int i = 0; i < count; ++i) {
    const Body& body = (*frame.bodies)[static_cast<std::size_t>(i)];
    if (has_infinite_mass(body) || !frame.state.q.col(i).allFinite()) continue;
    visit(Vec2(frame.state.position(i)), half_extent(body.shape, frame.state.q(2, i)));
  }
}

bool are_outside(const Frame& frame, const WorldRect& view) {
  bool any = false;
  bool seen = false;
  visit_moving(frame, [&](const Vec2& at, const Vec2& half) {
    any = true;
    seen = seen || view.meets(at, half.norm());
  });
  return any && !seen;
}

}  // namespace

void Follow::observe(const Frame& frame, const Camera& camera) {
  if (!are_outside(frame, camera.visible())) {
    lost_.invalidate();
    offered_ = false;
  } else if (!frame.playing) {
    lost_.invalidate();  // what is offered stays
  } else if (!lost_.isValid()) {
    lost_.start();
  } else if (lost_.elapsed() >= kOfferedAfter) {
    offered_ = true;
  }
}

void Follow::end() {
  on_ = false;
  offered_ = false;
  lost_.invalidate();
}

void Follow::show_moving(const Frame& frame, Camera& camera, const QMarginsF& margins) {
  WorldRect rect;
  visit_moving(frame, [&rect](const Vec2& at, const Vec2& half) { rect.include(at, half); });
  if (rect.empty()) return;
  const double scale = camera.scale;
  camera.fit(rect, margins);
  camera.scale = std::min(camera.scale, scale);
  camera.center = (rect.lower + rect.upper) / 2;
}

}  // namespace carom
