#pragma once

#include <functional>

#include "physics/step/hits_at_once.h"

namespace carom {

// Where impacts are not located in time: resolves those of buffers.hits in the order in which they touch. Those
// that share bodies and touch at one moment, or within one step if the scene says so, are resolved at once, as
// resolve_at_once() does; each that is left alone, or has no solution with the others, by `resolve_alone`. A
// step has h s; `within` is now, in s after the epoch. The hits are used up.
void resolve_in_order(World& world, HitsAtOnce& buffers, double h, double within,
                      const std::function<void(const Hit&)>& resolve_alone);

}  // namespace carom
