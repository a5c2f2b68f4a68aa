#pragma once

#include <cstdint>
#include <vector>

#include "physics/preset/preset.h"
#include "widgets/plot/plot_content.h"

namespace carom {

// A theory on a plot of one's own experiment, and the scene that it is for.
struct OwnTheory {
  PlottedTheory theory;
  std::uint64_t scene;  // its number: fingerprint_of_start()

  bool operator==(const OwnTheory&) const = default;
};

// The known theories and those of the preset's plots that are not known yet, which are for its scene.
[[nodiscard]] std::vector<OwnTheory> with_theories_of(std::vector<OwnTheory> known, const Preset& preset);

// Those that are for another scene than the preset's.
[[nodiscard]] std::vector<PlottedTheory> theories_of_others(const std::vector<OwnTheory>& known,
                                                            const Preset& preset);

}  // namespace carom
