#include "app/lab/own_theories.h"

#include <algorithm>

#include "physics/preset/start_fingerprint.h"

namespace carom {

std::vector<OwnTheory> with_theories_of(std::vector<OwnTheory> known, const Preset& preset) {
  std::vector<PlottedTheory> unknown;
  for (const Plot& plot : preset.plots) {
    for (const QuantityName& line : plot.y) {
      const PlottedTheory theory{line, plot.x};
      const bool is_known = std::any_of(known.begin(), known.end(),
                                        [&theory](const OwnTheory& each) { return each.theory == theory; });
      if (!line.theory.empty() && !is_known) unknown.push_back(theory);
    }
  }
  if (unknown.empty()) return known;
  const std::uint64_t scene = fingerprint_of_start(preset);
  for (PlottedTheory& theory : unknown) known.push_back({std::move(theory), scene});
  return known;
}

std::vector<PlottedTheory> theories_of_others(const std::vector<OwnTheory>& known, const Preset& preset) {
  std::vector<PlottedTheory> others;
  if (known.empty()) return others;
  const std::uint64_t scene = fingerprint_of_start(preset);
  for (const OwnTheory& each : known) {
    if (each.scene != scene) others.push_back(each.theory);
  }
  return others;
}

}  // namespace carom
