#include "physics/run/simulation.h"

#include "physics/preset/preset.h"
#include "tests/fuzz/running.h"
#include "tests/fuzz/targets.h"

namespace carom::fuzz {

void try_simulation(std::string_view bytes) {
  std::optional<Preset> scene = small_scene(bytes);
  if (!scene) return;
  Draws draws(bytes);
  scene->method = draw_method(*scene, draws);
  Simulation run(setup_of(*scene));
  run.watch_impacts(true);
  for (int k = 0; k < kMostSteps && run.time() < kMostTime && !run.lost(); ++k) checked_step(run);
}

}  // namespace carom::fuzz
