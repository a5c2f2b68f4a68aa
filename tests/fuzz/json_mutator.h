#pragma once

#include <cstdint>
#include <random>

#include "physics/preset/json_text.h"

namespace carom::fuzz {

using Random = std::mt19937_64;

// Changes one thing in a preset: inserts a number at the edge of a range or a value of another kind; removes,
// repeats, renames or swaps members; or copies a part over another. The same random numbers make the same
// change.
void mutate(Json& preset, Random& random);

}  // namespace carom::fuzz
