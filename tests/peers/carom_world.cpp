#include <fmt/format.h>

#include "physics/run/run_setup.h"
#include "tests/hard_cases/stress_scenes.h"
#include "tests/peers/cases.h"

// Carom in the same scenes: RK4 and resting contacts, with impacts at the step's end, as in the peers, or at
// their own time.
namespace carom::peers {
namespace {

carom::Body body_of(const Body& body, int index) {
  carom::Body b;
  b.name = fmt::format("{}", index);
  if (const Disc* disc = std::get_if<Disc>(&body.shape)) b.shape = carom::Disc{disc->radius};
  if (const Box* box = std::get_if<Box>(&body.shape)) b.shape = carom::Box{box->width, box->height};
  b.position = {body.start.x, body.start.y};
  b.angle = body.start.angle;
  b.velocity = {body.start.vx, body.start.vy};
  b.spin = body.start.spin;
  b.fixed = body.density == 0.0;
  if (!b.fixed) b.density = body.density;
  return b;
}

carom::RunSetup scene_of(const Scene& scene, ImpactsId impacts) {
  carom::RunSetup s;
  s.method = {.integrator = IntegratorId::kRk4, .impacts = impacts, .contacts = ContactsId::kLasting};
  s.scene.forces.gravity = {scene.gx, scene.gy};
  s.scene.materials = {{.name = "default",
                        .restitution = scene.restitution,
                        .static_friction = scene.friction,
                        .kinetic_friction = scene.friction}};
  for (const Body& body : scene.bodies)
    s.scene.bodies.push_back(body_of(body, static_cast<int>(s.scene.bodies.size())));
  return s;
}

template <ImpactsId kImpacts>
class CaromWorld {
 public:
  explicit CaromWorld(const Scene& scene) : simulation_(scene_of(scene, kImpacts)) {}

  void step(double h) {
    if (simulation_.method().step != h) {
      Method method = simulation_.method();
      method.step = h;
      simulation_.set_method(method);
    }
    simulation_.step();
  }

  [[nodiscard]] Motion motion(int i) const {
    const auto q = simulation_.state().q.col(i);
    const auto v = simulation_.state().v.col(i);
    return {q.x(), q.y(), q.z(), v.x(), v.y(), v.z()};
  }

  [[nodiscard]] std::vector<double> overlaps() const { return {stress::penetrations_of(simulation_).largest}; }

  [[nodiscard]] long contacts_begun() const { return simulation_.impact_count(); }

 private:
  Simulation simulation_;
};

}  // namespace

Engine carom_at_step_end() { return {"carom", cases<CaromWorld<ImpactsId::kStepEnd>>()}; }
Engine carom_located() { return {"carom-loc", cases<CaromWorld<ImpactsId::kLocated>>()}; }

}  // namespace carom::peers
