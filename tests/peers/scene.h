#pragma once

#include <variant>
#include <vector>

// The scene that an engine gets: bodies as values, in SI units. The engines' own types stay in their files.
namespace carom::peers {

// Position (m), angle (rad, counter-clockwise) and their rates.
struct Motion {
  double x = 0.0;
  double y = 0.0;
  double angle = 0.0;
  double vx = 0.0;
  double vy = 0.0;
  double spin = 0.0;
};

struct Disc {
  double radius = 0.25;  // m
};

struct Box {
  double width = 1.0;   // m
  double height = 1.0;  // m
};

struct Body {
  Motion start;
  std::variant<Disc, Box> shape = Box{};
  double density = 1.0;  // kg/m²; 0: the body is static
  bool bullet = false;   // the engine's own continuous collision, if it is enabled body by body
};

struct Scene {
  std::vector<Body> bodies = {};
  double friction = 0.0;     // dimensionless, of every pair
  double restitution = 0.0;  // dimensionless, of every pair
  double gx = 0.0;           // m/s²
  double gy = -kGravity;     // m/s²
  bool counts_contacts = false;

  static constexpr double kGravity = 9.81;  // m/s²
};

[[nodiscard]] double mass(const Body& body);     // kg
[[nodiscard]] double inertia(const Body& body);  // kg·m², about the centre

// A static box, `width` wide and 1 m thick, about x = 0, with its top at y = 0.
[[nodiscard]] Body floor(double width);

// A floor, body 0, and on it a column of `count` touching boxes of 1 m.
[[nodiscard]] Scene stack(int count);

// A floor, body 0, and rows of `base`, base − 1, ... 1 touching boxes of 1 m; the last body is the top.
[[nodiscard]] Scene pyramid(int base);

// A floor, body 0, and on it a box of 1 kg under one of `ratio` kg, both of 1 m.
[[nodiscard]] Scene heavy_on_light(double ratio);

// A static body 0 and a box of 1 m touching it, μ = 0.5. The incline comes from gravity, or from the bodies
// if `turned`.
[[nodiscard]] Scene incline(double tan_theta, bool turned);

// An open container of static boxes, bodies 0 to 2, with the inside x in [0, width] and y > 0; then the
// discs.
struct Pile {
  Scene scene;
  double width = 0.0;   // m
  double radius = 0.0;  // m
};
[[nodiscard]] Pile pile(int count);

// Elastic discs without friction in a closed square of five times their area: four static boxes, then the
// discs.
[[nodiscard]] Scene gas(int count);

}  // namespace carom::peers
