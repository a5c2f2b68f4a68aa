#include "widgets/scene/align.h"

#include <algorithm>
#include <array>
#include <limits>

#include "physics/math/vectors.h"
#include "widgets/scene/edit_names.h"

namespace carom {
namespace {

constexpr double kNone = std::numeric_limits<double>::infinity();

struct Bounds {
  double low = 0.0;  // m
  double high = 0.0;
};

// Along x, 0, or y, 1.
Bounds bounds_of(const Body& body, int axis) {
  Bounds out{kNone, -kNone};
  for (const ConvexPart& part : convex_parts(body.shape)) {
    for (const Vec2& vertex : part.outline.vertices) {
      const double at = body.position[axis] + turned_by(body.angle, part.position + vertex)[axis];
      out.low = std::min(out.low, at - part.outline.rounding);
      out.high = std::max(out.high, at + part.outline.rounding);
    }
  }
  return out;
}

int axis_of(Alignment alignment) {
  switch (alignment) {
    case Alignment::kLeft:
    case Alignment::kCentre:
    case Alignment::kRight:
    case Alignment::kAcross:
      return 0;
    default:
      return 1;
  }
}

bool spreads(Alignment alignment) {
  return alignment == Alignment::kAcross || alignment == Alignment::kUpwards;
}

// How far a body goes that is put to the side, or the middle, of what bounds all.
double way(Alignment alignment, const Bounds& body, const Bounds& all) {
  switch (alignment) {
    case Alignment::kLeft:
    case Alignment::kBottom:
      return all.low - body.low;
    case Alignment::kRight:
    case Alignment::kTop:
      return all.high - body.high;
    default:
      return 0.5 * (all.low + all.high) - 0.5 * (body.low + body.high);
  }
}

void spread(std::vector<Body*>& bodies, int axis, const Bounds& all) {
  const auto middle = [axis](const Body& body) {
    const Bounds b = bounds_of(body, axis);
    return b.low + b.high;
  };
  std::stable_sort(bodies.begin(), bodies.end(),
                   [&](const Body* a, const Body* b) { return middle(*a) < middle(*b); });
  double gap = all.high - all.low;
  for (const Body* body : bodies) {
    const Bounds b = bounds_of(*body, axis);
    gap -= b.high - b.low;
  }
  gap /= static_cast<double>(bodies.size() - 1);
  double next = all.low;
  for (Body* body : bodies) {
    const Bounds b = bounds_of(*body, axis);
    body->position[axis] += next - b.low;
    next += b.high - b.low + gap;
  }
}

}  // namespace

std::vector<Body> aligned(std::span<const Body> bodies, Alignment alignment) {
  std::vector<Body> out(bodies.begin(), bodies.end());
  const int axis = axis_of(alignment);
  std::vector<Body*> bounded;
  Bounds all{kNone, -kNone};
  for (Body& body : out) {
    if (outline_of(body.shape).half_plane) continue;
    bounded.push_back(&body);
    const Bounds b = bounds_of(body, axis);
    all = {std::min(all.low, b.low), std::max(all.high, b.high)};
  }
  if (bounded.size() < 2) return out;
  if (spreads(alignment)) {
    spread(bounded, axis, all);
  } else {
    for (Body* body : bounded) body->position[axis] += way(alignment, bounds_of(*body, axis), all);
  }
  return out;
}

QString name_of(Alignment alignment, std::span<const Body> bodies) {
  constexpr std::array kWhere = {"at the left", "in a column",   "at the right", "at the top",
                                 "in a row",    "at the bottom", "across",       "upwards"};
  return (spreads(alignment) ? "Distribute " : "Align ") + name_of_bodies(bodies) + " " +
         kWhere[static_cast<std::size_t>(alignment)];
}

}  // namespace carom
