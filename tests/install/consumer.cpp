#include <cmath>
#include <cstdio>
#include <physics/run/simulation.h>

int main() {
  carom::Scene scene;
  scene.materials = {{.name = "default", .restitution = 0.8}};
  scene.bodies = {{.name = "A", .shape = carom::Disc{0.1}, .position = {0, 0}, .velocity = {2, 0}, .mass = 1.0},
                  {.name = "B", .shape = carom::Disc{0.1}, .position = {1, 0}, .mass = 3.0}};
  const carom::Method method{
      .integrator = carom::IntegratorId::kRk4, .impacts = carom::ImpactsId::kLocated, .step = 0.005};
  carom::Simulation simulation({.scene = scene, .method = method});
  simulation.advance_to(1.0);
  std::printf("A leaves with %+.3f m/s, B with %+.3f m/s\n", simulation.state().v(0, 0),
              simulation.state().v(0, 1));
  // Momentum and Newton's restitution: 2 m/s shared as (1 - 3 * 0.8) / 4 and (1 + 0.8) / 4.
  return std::abs(simulation.state().v(0, 0) + 0.7) < 1e-12 &&
                 std::abs(simulation.state().v(0, 1) - 0.9) < 1e-12
             ? 0
             : 1;
}
