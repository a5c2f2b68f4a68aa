#pragma once

#include <cmath>

#include "tests/peers/box_cases.h"

// Cases of discs: a pile, one disc on a floor, and collisions.
namespace carom::peers {

template <World W>
std::vector<Figure> pile_case(int count, double h) {
  const Pile p = pile(count);
  W world(p.scene);
  const StepTimes times = run(world, h, kWatched);
  const std::vector<Motion> end = motions(world, p.scene);
  const Penetrations overlaps = disc_penetrations(p.scene, end, p.radius, {0.0, p.width, 0.0});
  return {{"step time mean", times.mean(), "ms"},
          {"step time mean of the last third", times.mean_of_last_third(), "ms"},
          {"largest overlap", kMillimetre * overlaps.largest, "mm"},
          {"mean overlap", kMillimetre * overlaps.mean, "mm"},
          {"rms speed", rms_speed(p.scene, end), "m/s"}};
}

inline constexpr double kDiscRadius = 0.25;  // m

// A disc placed on a floor with v (m/s, to the right) and a clockwise spin ω (rad/s); it ends up rolling at
// (2v + Rω)/3.
template <World W>
std::vector<Figure> rolling_case(double v, double clockwise, double h) {
  Scene scene{.bodies = {floor(100.0)}, .friction = 0.3};
  scene.bodies.push_back({{.y = kDiscRadius, .vx = v, .spin = -clockwise}, Disc{kDiscRadius}});
  W world(scene);
  run(world, h, 3.0);
  const double rolling = (2.0 * v + kDiscRadius * clockwise) / 3.0;
  return {{"final speed error", world.motion(1).vx - rolling, "m/s"}};
}

// A bounce counts at the end of the step that turns the velocity upward.
template <World W>
std::vector<Figure> bounce_case(double h) {
  constexpr double kHeight = 1.0;
  constexpr double kRestitution = 0.8;
  Scene scene{.bodies = {floor(10.0)}, .restitution = kRestitution};
  scene.bodies.push_back({{.y = kDiscRadius + kHeight}, Disc{kDiscRadius}});
  W world(scene);
  int bounces = 0;
  double fifth = std::nan("");
  double before = 0.0;
  run(world, h, 4.0, [&](double t) {
    const double vy = world.motion(1).vy;
    if (before < 0.0 && vy > 0.0 && ++bounces == 5) fifth = t;
    before = vy;
  });
  double falls = 1.0;  // in units of the first fall's time
  for (int n = 1; n <= 4; ++n) falls += 2.0 * std::pow(kRestitution, n);
  return {{"fifth bounce error", fifth - falls * std::sqrt(2.0 * kHeight / Scene::kGravity), "s"}};
}

template <World W>
std::vector<Figure> bullet_case(double h) {
  constexpr double kWall = 20.0;  // m
  Scene scene{.restitution = 1.0, .gy = 0.0};
  scene.bodies = {{{.x = kWall}, Box{0.02, 10.0}, 0.0}, {{.vx = 3000.0}, Disc{0.05}, 1.0, true}};
  W world(scene);
  bool passed = false;
  run(world, h, 1.0, [&](double) { passed = passed || world.motion(1).x > kWall; });
  return {{"passes", passed ? 1.0 : 0.0, "1"}, {"final speed", speed(world.motion(1)), "m/s"}};
}

// `count` discs in all: the first, half a metre away, hits the others, which touch.
template <World W>
std::vector<Figure> cradle_case(int count, double h) {
  Scene scene{.restitution = 1.0, .gy = 0.0};
  scene.bodies.push_back({{.x = -2.0 * kDiscRadius - 0.5, .vx = 1.0}, Disc{kDiscRadius}});
  for (int i = 0; i < count - 1; ++i) scene.bodies.push_back({{.x = 2.0 * kDiscRadius * i}, Disc{kDiscRadius}});
  W world(scene);
  const double before = kinetic_energy(scene, motions(world, scene));
  run(world, h, 3.0);
  const std::vector<Motion> end = motions(world, scene);
  return {{"speed of the last ball", end.back().vx, "m/s"},
          {"energy lost", 100.0 * (1.0 - kinetic_energy(scene, end) / before), "%"}};
}

// A grid of discs that penetrate by a quarter of their diameters. A correction moves a disc whether or not
// its velocity shows it.
template <World W>
std::vector<Figure> overlapping_start_case(double h) {
  constexpr int kSide = 10;
  constexpr double kSpacing = 0.75 * 2.0 * kDiscRadius;
  Scene scene{.gy = 0.0};
  for (int i = 0; i < kSide * kSide; ++i)
    scene.bodies.push_back({{.x = kSpacing * (i % kSide), .y = kSpacing * (i / kSide)}, Disc{kDiscRadius}});
  W world(scene);
  double fastest = 0.0;
  std::vector<Motion> last = motions(world, scene);
  double quickest = 0.0;
  run(world, h, kWatched, [&](double) {
    const std::vector<Motion> now = motions(world, scene);
    for (std::size_t i = 0; i < now.size(); ++i) {
      fastest = std::max(fastest, speed(now[i]));
      quickest = std::max(quickest, std::hypot(now[i].x - last[i].x, now[i].y - last[i].y) / h);
    }
    last = now;
  });
  return {{"largest speed", fastest, "m/s"},
          {"fastest correction", quickest, "m/s"},
          {"largest overlap at the end", kMillimetre * disc_penetrations(scene, last, kDiscRadius, {}).largest,
           "mm"}};
}

// Galperin's billiard: a wall, a light disc at rest, a heavy disc that comes in at 1 m/s.
template <World W>
std::vector<Figure> galperin_case(double ratio, double h) {
  Scene scene{.restitution = 1.0, .gy = 0.0, .counts_contacts = true};
  scene.bodies = {{{.x = -0.5}, Box{}, 0.0},
                  {{.x = 1.0}, Disc{kDiscRadius}, 1.0},
                  {{.x = 2.0, .vx = -1.0}, Disc{kDiscRadius}, ratio}};
  W world(scene);
  run(world, h, kWatched);
  return {{"collisions", static_cast<double>(world.contacts_begun()), "1"}};
}

template <World W>
std::vector<Figure> gas_case(int count, double h) {
  const Scene scene = gas(count);
  W world(scene);
  const double before = kinetic_energy(scene, motions(world, scene));
  const StepTimes times = run(world, h, kWatched);
  const double after = kinetic_energy(scene, motions(world, scene));
  return {{"relative energy change", after / before - 1.0, "1"},
          {"collisions", static_cast<double>(world.contacts_begun()), "1"},
          {"collisions over wall time", static_cast<double>(world.contacts_begun()) / (1e-3 * times.total()),
           "1/s"},
          {"step time mean", times.mean(), "ms"}};
}

}  // namespace carom::peers
