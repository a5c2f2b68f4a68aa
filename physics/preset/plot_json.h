#pragma once

#include "physics/preset/preset.h"
#include "physics/preset/value_reader.h"

namespace carom {

// A plot of a preset file: the name of a known one, or an object. Bodies are not looked up here.
[[nodiscard]] Plot read_plot(const ValueReader& value);
[[nodiscard]] Json plot_json(const Plot& plot);

}  // namespace carom
