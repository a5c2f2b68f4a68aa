#include "tests/peers/scene.h"

#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>

namespace carom::peers {

namespace {

constexpr int kFixedWalls = 4;

// The same draws with every standard library: the top 53 bits, and Box and Muller's transform.
class Draws {
 public:
  explicit Draws(std::uint64_t seed) : random_(seed) {}
  double uniform(double from, double to) {
    return from + (to - from) * static_cast<double>(random_() >> 11) * 0x1p-53;
  }
  double normal() {
    const double length = std::sqrt(-2.0 * std::log(1.0 - uniform(0.0, 1.0)));
    return length * std::cos(uniform(0.0, 2.0 * std::numbers::pi));
  }

 private:
  std::mt19937_64 random_;
};

Body box_at(double x, double y) { return {{.x = x, .y = y}, Box{}, 1.0}; }

Body fixed_box(double x, double y, double width, double height) {
  return {{.x = x, .y = y}, Box{width, height}, 0.0};
}

}  // namespace

double mass(const Body& body) {
  if (const Disc* disc = std::get_if<Disc>(&body.shape))
    return body.density * std::numbers::pi * disc->radius * disc->radius;
  const Box& box = std::get<Box>(body.shape);
  return body.density * box.width * box.height;
}

double inertia(const Body& body) {
  if (const Disc* disc = std::get_if<Disc>(&body.shape)) return 0.5 * mass(body) * disc->radius * disc->radius;
  const Box& box = std::get<Box>(body.shape);
  return mass(body) * (box.width * box.width + box.height * box.height) / 12.0;
}

Body floor(double width) { return fixed_box(0.0, -0.5, width, 1.0); }

Scene stack(int count) {
  Scene s{.bodies = {floor(200.0)}, .friction = 0.6};
  for (int i = 0; i < count; ++i) s.bodies.push_back(box_at(0.0, i + 0.5));
  return s;
}

Scene pyramid(int base) {
  Scene s{.bodies = {floor(200.0)}, .friction = 0.6};
  for (int row = 0; row < base; ++row) {
    for (int i = 0; i < base - row; ++i) s.bodies.push_back(box_at(i + 0.5 * (row - base + 1), row + 0.5));
  }
  return s;
}

Scene heavy_on_light(double ratio) {
  Scene s = stack(2);
  s.bodies.back().density = ratio;
  return s;
}

Scene incline(double tan_theta, bool turned) {
  Scene s = stack(1);
  s.friction = 0.5;
  const double theta = std::atan(tan_theta);
  if (!turned) {
    s.gx = Scene::kGravity * std::sin(theta);
    s.gy = -Scene::kGravity * std::cos(theta);
    return s;
  }
  for (Body& body : s.bodies) {
    const double away = body.start.y;
    body.start.x = away * std::sin(theta);
    body.start.y = away * std::cos(theta);
    body.start.angle = -theta;
  }
  return s;
}

Pile pile(int count) {
  constexpr double kRadius = 0.25;
  constexpr double kAcross = 0.55;
  constexpr double kUp = 0.75;
  const int columns = static_cast<int>(std::lround(std::sqrt(count)));
  const double width = kAcross * columns;
  const double height = kUp * (count / columns) + 10.0;
  Scene s{.friction = 0.5};
  s.bodies = {fixed_box(0.5 * width, -0.5, width + 2.0, 1.0), fixed_box(-0.5, 0.5 * height, 1.0, height),
              fixed_box(width + 0.5, 0.5 * height, 1.0, height)};
  Draws draws(1);
  for (int i = 0; i < count; ++i) {
    const double x = kAcross * (i % columns + 0.5) + draws.uniform(-0.02, 0.02);
    const double y = 0.3 + kUp * (i / columns) + draws.uniform(-0.02, 0.02);
    s.bodies.push_back({{.x = x, .y = y}, Disc{kRadius}, 1.0});
  }
  return {s, width, kRadius};
}

Scene gas(int count) {
  constexpr double kRadius = 0.25;
  constexpr double kFilled = 0.2;  // of the area
  const double side = std::sqrt(count * std::numbers::pi * kRadius * kRadius / kFilled);
  const double middle = 0.5 * side;
  const double beyond = side + 0.5;
  Scene s{.restitution = 1.0, .gy = 0.0, .counts_contacts = true};
  s.bodies = {fixed_box(middle, -0.5, side + 2.0, 1.0), fixed_box(middle, beyond, side + 2.0, 1.0),
              fixed_box(-0.5, middle, 1.0, side), fixed_box(beyond, middle, 1.0, side)};
  const int columns = static_cast<int>(std::ceil(std::sqrt(count)));
  const double spacing = side / columns;
  const double jitter = 0.4 * (0.5 * spacing - kRadius);
  Draws draws(2);
  double px = 0.0;
  double py = 0.0;
  for (int i = 0; i < count; ++i) {
    Motion m{.x = spacing * (i % columns + 0.5) + draws.uniform(-jitter, jitter),
             .y = spacing * (i / columns + 0.5) + draws.uniform(-jitter, jitter)};
    m.vx = draws.normal();
    m.vy = draws.normal();
    px += m.vx;
    py += m.vy;
    s.bodies.push_back({m, Disc{kRadius}, 1.0});
  }
  // No net momentum, and an rms speed of 1 m/s exactly.
  double square = 0.0;
  for (std::size_t i = kFixedWalls; i < s.bodies.size(); ++i) {
    Motion& m = s.bodies[i].start;
    m.vx -= px / count;
    m.vy -= py / count;
    square += m.vx * m.vx + m.vy * m.vy;
  }
  const double scale = std::sqrt(count / square);
  for (std::size_t i = kFixedWalls; i < s.bodies.size(); ++i) {
    s.bodies[i].start.vx *= scale;
    s.bodies[i].start.vy *= scale;
  }
  return s;
}

}  // namespace carom::peers
