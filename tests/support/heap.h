#pragma once

#include "physics/run/run_setup.h"
#include "tests/support/scenes.h"

namespace carom::test {

// Discs all at the same place, with speeds up to `speed` (m/s).
inline RunSetup heap(int columns, int rows, double speed = 0.0) {
  GridGenerator discs;
  discs.columns = columns;
  discs.rows = rows;
  discs.spacing = {0, 0};
  discs.speed_max = speed;
  RunSetup s = setup_with({});
  s.scene.generators = {discs};
  s.method = {.step = 0.005};
  return s;
}

}  // namespace carom::test
