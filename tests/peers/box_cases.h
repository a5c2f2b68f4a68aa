#pragma once

#include <cmath>

#include "tests/peers/measure.h"

// Cases of boxes of 1 m that stand on each other or on an incline.
namespace carom::peers {

inline constexpr double kWatched = 10.0;    // s, duration of a case
inline constexpr double kFallen = 0.5;      // m sideways
inline constexpr double kMillimetre = 1e3;  // mm/m

// Result of boxes at rest; the last body is the top. Lean is its drift to the right, sag its drift down.
struct Settled {
  std::vector<Figure> figures;
  StepTimes times;
};

template <World W>
Settled settle(const Scene& scene, double h) {
  W world(scene);
  double ever = kNone;
  const StepTimes times = run(world, h, kWatched, [&](double) { ever = std::max(ever, deepest(world)); });
  const std::vector<Motion> end = motions(world, scene);
  double farthest = 0.0;
  for (std::size_t i = 0; i < end.size(); ++i)
    farthest = std::max(farthest, std::abs(end[i].x - scene.bodies[i].start.x));
  const Motion& top = scene.bodies.back().start;
  return {{{"largest overlap at the end", kMillimetre * deepest(world), "mm"},
           {"largest overlap ever", kMillimetre * ever, "mm"},
           {"lean", kMillimetre * (end.back().x - top.x), "mm"},
           {"sag", kMillimetre * (top.y - end.back().y), "mm"},
           {"stands", farthest <= kFallen ? 1.0 : 0.0, "1"}},
          times};
}

template <World W>
std::vector<Figure> stack_case(int count, double h) {
  return settle<W>(stack(count), h).figures;
}

template <World W>
std::vector<Figure> pyramid_case(int base, double h) {
  Settled s = settle<W>(pyramid(base), h);
  s.figures.push_back({"step time median", s.times.median(), "ms"});
  s.figures.push_back({"step time mean", s.times.mean(), "ms"});
  return s.figures;
}

template <World W>
std::vector<Figure> mass_ratio_case(double ratio, double h) {
  return settle<W>(heavy_on_light(ratio), h).figures;
}

// Below and at the friction cone the box must stay; above it slides with a = g(sin θ − μ cos θ).
template <World W>
std::vector<Figure> incline_case(bool turned, double h) {
  const auto distance = [&](double tan_theta) {
    const Scene scene = incline(tan_theta, turned);
    W world(scene);
    run(world, h, kWatched);
    const Motion& from = scene.bodies.back().start;
    const Motion to = world.motion(1);
    const double theta = std::atan(tan_theta);
    if (!turned) return to.x - from.x;
    return (to.x - from.x) * std::cos(theta) - (to.y - from.y) * std::sin(theta);
  };
  constexpr double kMu = 0.5;
  const double theta = std::atan(1.005 * kMu);
  const double slid = 0.5 * Scene::kGravity * (std::sin(theta) - kMu * std::cos(theta)) * kWatched * kWatched;
  return {{"creep at 0.995 mu", kMillimetre * distance(0.995 * kMu), "mm"},
          {"creep at 1.000 mu", kMillimetre * distance(kMu), "mm"},
          {"distance error at 1.005 mu", kMillimetre * (distance(1.005 * kMu) - slid), "mm"}};
}

}  // namespace carom::peers
