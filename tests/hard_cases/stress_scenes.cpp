#include "tests/hard_cases/stress_scenes.h"

#include <algorithm>
#include <cmath>

#include "physics/collision/broad_phase.h"
#include "physics/collision/pair_contact.h"
#include "physics/run/run_setup.h"
#include "physics/scene/shape.h"

namespace carom::stress {
namespace {

double without_puts(const Simulation& s) {
  const Ledger ledger = s.ledger();
  return s.totals().energy() - ledger.penetration_correction - ledger.put_in_by_drives;
}

Body body(const std::string& name, Shape shape, const Vec2& position, double mass) {
  Body b;
  b.name = name;
  b.shape = std::move(shape);
  b.position = position;
  b.mass = mass;
  return b;
}

}  // namespace

Body half_plane(const std::string& name, Vec2 point, double angle) {
  Body b = body(name, Wall{}, point, 0.0);
  b.mass.reset();
  b.angle = angle;
  b.fixed = true;
  return b;
}

Body box(const std::string& name, Vec2 position, double width, double height, double mass) {
  return body(name, Box{width, height}, position, mass);
}

Body disc(const std::string& name, Vec2 position, double radius, double mass) {
  return body(name, Disc{radius}, position, mass);
}

Body plate(const std::string& name, const std::vector<Vec2>& corners, double mass) {
  return body(name, Polygon{corners}, moments_of(tidied(corners), 0.0).centroid, mass);
}

RunSetup scene(const StressSetting& setting, std::vector<Body> bodies, double restitution, double friction,
               double gravity) {
  RunSetup s;
  s.method = setting.method;
  s.scene.forces.gravity = {0.0, -gravity};
  s.scene.materials = {{.name = "default",
                        .restitution = restitution,
                        .static_friction = friction,
                        .kinetic_friction = friction}};
  s.scene.bodies = std::move(bodies);
  return s;
}

Simulation run(const RunSetup& setup, double time) {
  Simulation simulation(setup);
  simulation.advance_to(time);
  return simulation;
}

Penetrations penetrations_of(const Simulation& s) {
  const Geometry& g = s.shapes();
  std::vector<Bounds> bounds;
  for (int i = 0; i < s.state().size(); ++i) {
    const Eigen::Array2d x = s.state().position(i).array();
    bounds.push_back({x - g.extent.col(i).array(), x + g.extent.col(i).array()});
  }
  Penetrations found;
  int count = 0;
  BroadPhase broad_phase;
  for (const auto& [a, b] : broad_phase.pairs(bounds, g.fixed)) {
    if (!g.can_collide(a, b)) continue;
    const double overlap = -contact_between(g, a, s.state().q.col(a), b, s.state().q.col(b)).gap;
    if (!(overlap > 0.0)) continue;
    found.largest = std::max(found.largest, overlap);
    found.mean += overlap;
    ++count;
  }
  if (count > 0) found.mean /= count;
  return found;
}

double moving_mass(const Simulation& s) {
  double mass = 0.0;
  for (const double m : s.mass().mass) {
    if (std::isfinite(m)) mass += m;
  }
  return mass;
}

EnergyRise::EnergyRise(const Simulation& s)
    : unit_(0.5 * moving_mass(s) * kGravity * kGravity * s.method().step * s.method().step),
      before_(without_puts(s)) {}

void EnergyRise::look(const Simulation& s) {
  const double now = without_puts(s);
  // A run with NaN must not pass for one that gained nothing.
  if (!(now - before_ <= largest_)) largest_ = now - before_;
  before_ = now;
}

RiseAndOverlap look_to(Simulation& simulation, double time) {
  EnergyRise rise(simulation);
  double overlap = 0.0;
  simulation.advance_to(time, [&] {
    rise.look(simulation);
    overlap = std::max(overlap, penetrations_of(simulation).largest);
  });
  return {rise.largest(), overlap};
}

}  // namespace carom::stress
