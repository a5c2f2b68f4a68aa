#pragma once

#include <QString>

#include "physics/record/impact_theory.h"
#include "physics/record/interval_theory.h"

namespace carom {

// Why there is no closed law, in a sentence; empty if there is one.
[[nodiscard]] QString text_of(NoTheory why);
[[nodiscard]] QString text_of(NoIntervalLaw why);

}  // namespace carom
