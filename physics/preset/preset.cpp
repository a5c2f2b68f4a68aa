#include "physics/preset/preset.h"

#include "physics/world/run_setup.h"

namespace carom {

RunSetup setup_of(const Preset& preset) {
  RunSetup setup{preset.scene, preset.method, preset.saved};
  const auto count = [&](const QuantityName& quantity) {
    if (quantity.bodies.size() == 2) setup.counted_pairs.emplace_back(quantity.bodies[0], quantity.bodies[1]);
  };
  for (const Plot& plot : preset.plots) {
    for (const QuantityName& y : plot.y) count(y);
    if (plot.x) count(*plot.x);
  }
  return setup;
}

}  // namespace carom
