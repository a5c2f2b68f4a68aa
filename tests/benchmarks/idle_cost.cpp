#include <algorithm>
#include <cmath>
#include <ctime>
#include <fmt/format.h>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include "physics/model/needs.h"
#include "physics/preset/preset.h"
#include "physics/preset/preset_file.h"
#include "physics/run/simulation.h"
#include "tests/support/scenes.h"

// Cost of a part of the model with nothing to do, as the ratio of its CPU time to that of the trimmed run;
// and collisions a second. Repeats alternate, so that a change of the machine's speed affects all alike;
// prints medians, tests nothing. part_instructions counts instructions instead, with `carom_idle_cost FILE
// KEY`.
namespace carom {
namespace {

constexpr int kRepeats = 10;

// Frictionless elastic discs in a square room, over a fifth of its area, at random speeds.
RunSetup gas(int columns, IntegratorId integrator) {
  const double spacing = 0.1;
  const double radius = spacing * std::sqrt(0.2 / M_PI);
  const double half = 0.5 * spacing * columns;
  std::vector<Body> bodies = test::room(half, 0.5);
  std::mt19937_64 random(3);
  const auto draw = [&] { return static_cast<double>(random() >> 11) * 0x1p-52 - 1.0; };
  for (int i = 0; i < columns * columns; ++i) {
    const Vec2 home(-half + spacing * (i % columns + 0.5), -half + spacing * (i / columns + 0.5));
    const double x = draw();
    bodies.push_back(test::disc(fmt::format("disc-{}", i), home, {x, draw()}, radius));
  }
  RunSetup s = test::setup_with(std::move(bodies));
  s.method = {integrator, ImpactsId::kLocated, ContactsId::kImpulse, 1.0 / 60.0};
  return s;
}

double cpu_seconds(const std::function<void()>& work) {
  const std::clock_t start = std::clock();
  work();
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

struct Variant {
  std::string name;
  Needs needs;
};

std::vector<Variant> variants(const RunSetup& setup, bool with_all) {
  // The trimmed run is listed twice: the second one shows the accuracy of the figures.
  std::vector<Variant> list = {{"trimmed", needs_of(setup.scene)}, {"trimmed again", needs_of(setup.scene)}};
  for (const PartEntry& entry : part_entries()) {
    Needs needs = needs_of(setup.scene);
    needs.set(entry.part);
    list.push_back({std::string(entry.noun), needs});
  }
  if (with_all) list.push_back({"all", all_needs()});
  return list;
}

void idle_cost(const std::string& title, const RunSetup& setup, double until, bool with_all) {
  const std::vector<Variant> list = variants(setup, with_all);
  std::vector<std::vector<double>> seconds(list.size());
  std::int64_t impacts = 0;
  for (int repeat = 0; repeat < kRepeats; ++repeat) {
    for (std::size_t turn = 0; turn < list.size(); ++turn) {
      const std::size_t k = (turn + static_cast<std::size_t>(repeat)) % list.size();
      Simulation run(setup, list[k].needs);
      seconds[k].push_back(cpu_seconds([&] { run.advance_to(until); }));
      impacts = run.impact_count();
    }
  }
  const double trimmed = median(seconds[0]);
  fmt::print("{}: {:.0f} ms of CPU time, {} impacts\n", title, 1e3 * trimmed, impacts);
  for (std::size_t k = 1; k < list.size(); ++k)
    fmt::print("  {:<18}{:.3f}\n", list[k].name, median(seconds[k]) / trimmed);
}

void collisions_a_second(int columns) {
  const RunSetup setup = gas(columns, IntegratorId::kExactFlight);
  std::vector<double> rates;
  for (int repeat = 0; repeat < 5; ++repeat) {
    Simulation run(setup);
    run.advance_to(0.1);  // warm up
    const std::int64_t before = run.impact_count();
    const double seconds = cpu_seconds([&] {
      while (run.impact_count() - before < 300'000) run.step();
    });
    rates.push_back(static_cast<double>(run.impact_count() - before) / seconds);
  }
  fmt::print("  {:>6} discs: {:.0f} collisions a second\n", columns * columns, median(rates));
}

constexpr int kCountedSteps = 200;

template <class Change>
void change_materials(Scene& scene, const Change& change) {
  for (Material& m : scene.materials) change(m);
  for (MaterialPair& pair : scene.pairs) change(pair.surface);
}

// Removes from a scene what needs the part; false if the rest could not run.
bool remove_part(Scene& scene, Part part) {
  switch (part) {
    case Part::kFriction:
      change_materials(scene, [](Material& m) {
        m.static_friction = m.kinetic_friction = m.rolling_resistance = m.tangential_restitution = 0.0;
      });
      return true;
    case Part::kSticking:
      change_materials(scene, [](Material& m) { m.sticks = false; });
      return true;
    case Part::kDrag:
      scene.forces.linear_drag = scene.forces.quadratic_drag = 0.0;
      return true;
    case Part::kSprings:
      scene.forces.springs.clear();
      return true;
    case Part::kAttraction:
      scene.forces.attraction.reset();
      return true;
    case Part::kAppliedForces:
      scene.forces.applied.clear();
      return true;
    case Part::kDrives:
      for (Body& body : scene.bodies) {
        if (body.drive) body.fixed = true;
        body.drive.reset();
      }
      return true;
    case Part::kJoints:
      scene.joints.clear();
      return true;
    case Part::kRotation:
    case Part::kSwitching:
    case Part::kRestingContacts:
      break;
  }
  return false;
}

// Steps of a preset with one part (by its key) switched: added to the model if the scene does not need it,
// otherwise removed from the scene. Any other key leaves the scene as it is.
int count_steps(const char* file, std::string_view key) {
  RunSetup setup = setup_of(read_preset(file));
  Needs needs = needs_of(setup.scene);
  for (const PartEntry& entry : part_entries()) {
    if (entry.key != key) continue;
    const bool needed = needs.has(entry.part);
    if (needed) {
      if (!remove_part(setup.scene, entry.part)) return 1;
      needs = needs_of(setup.scene);
    }
    needs.set(entry.part, !needed);
  }
  Simulation run(setup, needs);
  for (int i = 0; i < kCountedSteps; ++i) run.step();
  return 0;
}

}  // namespace
}  // namespace carom

int main(int argc, char** argv) {
  using namespace carom;
  if (argc == 3) return count_steps(argv[1], argv[2]);
  fmt::print("Ratios of CPU time to the trimmed run's, medians of {} repeats that take turns:\n", kRepeats);
  idle_cost("1024 discs, exact flight", gas(32, IntegratorId::kExactFlight), 6.0, false);
  // Untrimmed, every impact touches all bodies: therefore few discs and a short time.
  idle_cost("25 discs, exact flight", gas(5, IntegratorId::kExactFlight), 20.0, true);
  RunSetup drag = gas(5, IntegratorId::kRk4);
  drag.scene.forces.linear_drag = 0.01;
  idle_cost("25 discs with drag, RK4", drag, 4.0, true);
  fmt::print("Frictionless discs over a fifth of the area, exact flight, h = 1/60 s:\n");
  for (const int columns : {10, 32, 100}) collisions_a_second(columns);
}
