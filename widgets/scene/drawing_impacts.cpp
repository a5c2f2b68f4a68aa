#include "widgets/scene/drawing_impacts.h"

#include <algorithm>
#include <cstddef>

namespace carom {
namespace {

constexpr double kContactDot = 5.0;  // px

}  // namespace

void add_impacts(const DrawingInput& in, const WorldRect& seen, Drawing& out) {
  if (!in.frame.bodies) return;
  const int count = std::min(in.frame.state.size(), static_cast<int>(in.frame.bodies->size()));
  const auto is_free = [&](int i) {
    return !has_infinite_mass((*in.frame.bodies)[static_cast<std::size_t>(i)]);
  };
  for (const ImpactRecord& impact : in.impacts) {
    const double age = in.frame.time - impact.time;
    if (age < 0.0 || age >= kImpactShown) continue;
    if (impact.a < 0 || impact.b < 0 || impact.a >= count || impact.b >= count) continue;
    if (in.jump != nullptr && in.options.jumps && impact.time == in.jump->time()) {
      out.marks.push_back(impact);  // it is shown in full
      continue;
    }
    QColor color = in.theme.series[1];
    color.setAlphaF(static_cast<float>(1.0 - age / kImpactShown));
    const Vec2 push = impact.normal * (impact.normal_impulse * in.arrows.metres_per_impulse);
    bool shown = false;
    if (is_free(impact.a)) shown = add_arrow(in, seen, {impact.point, -push, color}, out) || shown;
    if (is_free(impact.b)) shown = add_arrow(in, seen, {impact.point, push, color}, out) || shown;
    if (!shown) continue;
    out.segments.push_back({impact.point, impact.point, color, kContactDot * in.options.line_scale});
    out.marks.push_back(impact);
  }
}

}  // namespace carom
